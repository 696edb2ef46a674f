//! One run: words stay words.

use super::assembler::{Assembler, Bit, OFF};
use super::code::{Copies, Kind, Machine, Slot};
use crate::circuit::{Cell, Circuit, Design, Net, Op, Register, Valid, as_signed, mask};
use crate::index::index;

/// A circuit that runs one scan at a time, as [`Simulator`](crate::circuit::Simulator) does, and
/// many times faster.
#[derive(Clone, Debug)]
pub struct FastSimulator {
    machine: Machine,
    /// The slot and the width of each input port.
    inputs: Vec<(Slot, u32)>,
    outputs: Vec<Shown>,
    /// The slot of each register and what it holds at reset.
    resets: Vec<(Slot, u64)>,
    clock: Copies,
}

/// What an output port shows: a slot of a width in bits, extended when it is asked for, because a
/// register that is extended changes at the clock.
#[derive(Clone, Debug)]
struct Shown {
    slot: Slot,
    width: u32,
    /// To which widths in turn, and whether with the top bit.
    extended: Vec<(u32, bool)>,
}

/// Where the value of a net is.
#[derive(Clone, Copy)]
enum Value {
    /// One bit.
    Bit(Bit),
    /// More than one, in a slot of their own.
    Word(Slot),
}

struct Lowering<'c> {
    circuit: &'c Circuit,
    assembler: Assembler,
    values: Vec<Value>,
    /// The first slot of the input ports; registers stand behind them.
    first_input: Slot,
}

/// What a register or port of that width holds in a slot: one bit fills it.
fn spread(bits: u64, width: u32) -> u64 {
    if width == 1 { (bits & 1).wrapping_neg() } else { bits & mask(width) }
}

impl FastSimulator {
    /// A design, at reset.
    pub fn new(design: &Valid<Design>) -> Self {
        let circuit = design.flatten();
        let free = circuit.inputs.len() + circuit.registers.len();
        let assembler = Assembler::new(constants(&circuit), free);
        let first_input = assembler.first_free();
        let mut lowering =
            Lowering { circuit: &circuit, assembler, values: Vec::new(), first_input };
        for (_, cell) in circuit.cells() {
            let value = lowering.cell(cell);
            lowering.values.push(value);
        }
        let first_register = first_input + circuit.inputs.len() as Slot;
        let registers: Vec<_> = (first_register..).zip(circuit.registers.values()).collect();
        let next = |&(slot, register): &(Slot, &Register)| (lowering.slot(register.next), slot);
        let nexts: Vec<(Slot, Slot)> = registers.iter().map(next).collect();
        let outputs = circuit.outputs.iter().map(|output| lowering.shown(output.net)).collect();
        let resets = registers
            .iter()
            .map(|&(slot, register)| (slot, spread(register.reset, register.width)));
        let Assembler { given, instructions, .. } = lowering.assembler;
        let mut machine = Machine::new(given.len() as Slot, &instructions);
        given.iter().zip(0..).for_each(|(&value, slot)| machine.set(slot, value));
        let is_register = |slot| (first_register..given.len() as Slot).contains(&slot);
        let mut simulator = FastSimulator {
            machine,
            inputs: (first_input..).zip(circuit.inputs.iter().map(|port| port.width)).collect(),
            outputs,
            resets: resets.collect(),
            clock: Copies::new(nexts.into_iter(), is_register),
        };
        simulator.reset();
        simulator
    }

    /// Back to reset.
    pub fn reset(&mut self) {
        self.resets.iter().for_each(|&(slot, value)| self.machine.set(slot, value));
    }

    /// Computes every net from the registers and these bits for each input port, in order.
    pub fn settle(&mut self, inputs: &[u64]) {
        for (&(slot, width), &bits) in self.inputs.iter().zip(inputs) {
            self.machine.set(slot, spread(bits, width));
        }
        self.machine.run();
    }

    /// The clock edge: every register takes its next value.
    pub fn clock(&mut self) {
        self.machine.copy(&self.clock);
    }

    /// The bits of the output port of that index. A port that shows a register, extended or
    /// not, changes at [`FastSimulator::clock`], any other at [`FastSimulator::settle`].
    pub fn output(&self, port: usize) -> u64 {
        let Shown { slot, width, extended } = &self.outputs[port];
        let bits = self.machine.get(*slot) & mask(*width);
        let extend = |(bits, from): (u64, u32), &(to, signed): &(u32, bool)| {
            let bits = if signed { as_signed(bits, from) as u64 & mask(to) } else { bits };
            (bits, to)
        };
        extended.iter().fold((bits, *width), extend).0
    }
}

/// Every number that the instructions of a circuit may need.
fn constants(circuit: &Circuit) -> Vec<u64> {
    let mut all: Vec<u64> = (0..64).collect();
    for (_, cell) in circuit.cells() {
        all.push(mask(cell.width));
        all.push(1 << (cell.width - 1));
        if let Op::Const(bits) = cell.op {
            all.push(bits);
        }
    }
    all.sort_unstable();
    all.dedup();
    all
}

impl Lowering<'_> {
    fn slot(&mut self, net: Net) -> Slot {
        match self.values[index(net)] {
            Value::Bit(bit) => self.assembler.plain(bit),
            Value::Word(slot) => slot,
        }
    }

    fn shown(&mut self, net: Net) -> Shown {
        let Cell { op, width } = self.circuit.cell(net);
        match op {
            Op::Extend { from, signed } => {
                let mut shown = self.shown(from);
                shown.extended.push((width, signed));
                shown
            }
            _ => Shown { slot: self.slot(net), width, extended: Vec::new() },
        }
    }

    fn bit(&self, net: Net) -> Bit {
        match self.values[index(net)] {
            Value::Bit(bit) => bit,
            Value::Word(_) => unreachable!("a net of one bit is a condition"),
        }
    }

    fn cell(&mut self, cell: Cell) -> Value {
        let given = |slot: Slot| match cell.width {
            1 => Value::Bit(Assembler::bit(slot)),
            _ => Value::Word(slot),
        };
        match cell.op {
            Op::Input(port) => given(self.first_input + port),
            Op::Register(id) => {
                let first = self.first_input + self.circuit.inputs.len() as Slot;
                given(first + index(id) as Slot)
            }
            Op::Eq(a, b) | Op::Less { a, b, .. } if self.circuit.width(a) > 1 => {
                Value::Bit(self.compare(cell.op, a, b))
            }
            _ if cell.width == 1 => Value::Bit(self.condition(cell)),
            _ => Value::Word(self.word(cell)),
        }
    }

    fn compare(&mut self, op: Op, a: Net, b: Net) -> Bit {
        let width = self.circuit.width(a);
        let (mut a, mut b) = (self.slot(a), self.slot(b));
        let kind = match op {
            Op::Eq(..) => Kind::Eq,
            _ => Kind::Less,
        };
        if matches!(op, Op::Less { signed: true, .. }) {
            // With their top bits inverted, numbers with a sign are in the order of those without.
            let top = self.assembler.constant(1 << (width - 1));
            a = self.assembler.emit2(Kind::Xor, a, top);
            b = self.assembler.emit2(Kind::Xor, b, top);
        }
        Assembler::bit(self.assembler.emit2(kind, a, b))
    }

    /// A cell of one bit whose operands, but that of a slice, have one bit.
    fn condition(&mut self, cell: Cell) -> Bit {
        let circuit = self.circuit;
        match cell.op {
            Op::Input(_) | Op::Register(_) | Op::Port(..) | Op::Extend { .. } | Op::Concat(_) => {
                unreachable!("given, not in a flat circuit, or wider than one bit")
            }
            Op::Const(bits) => Bit { inverted: bits == 1, ..OFF },
            Op::Not(from) => self.bit(from).not(),
            Op::And(list) => {
                let bits: Vec<Bit> = circuit.list(list).iter().map(|&net| self.bit(net)).collect();
                self.assembler.all(bits.into_iter())
            }
            Op::Or(list) => {
                let bits: Vec<Bit> = circuit.list(list).iter().map(|&net| self.bit(net)).collect();
                self.assembler.any(bits.into_iter())
            }
            Op::Xor(a, b) | Op::Add(a, b) | Op::Sub(a, b) => {
                self.assembler.xor(self.bit(a), self.bit(b))
            }
            // One bit divided by 0 is 0, by 1 itself, and leaves nothing.
            Op::Mul(a, b) | Op::Div(a, b) => {
                self.assembler.all([self.bit(a), self.bit(b)].into_iter())
            }
            Op::Rem(..) => OFF,
            Op::Eq(a, b) => self.assembler.xor(self.bit(a), self.bit(b)).not(),
            Op::Mux { select, on, off } => {
                self.assembler.mux(self.bit(select), self.bit(on), self.bit(off))
            }
            // One bit with a sign is 0 or -1.
            Op::Less { a, b, signed: true } => {
                self.assembler.all([self.bit(a), self.bit(b).not()].into_iter())
            }
            Op::Less { a, b, signed: false } => {
                self.assembler.all([self.bit(a).not(), self.bit(b)].into_iter())
            }
            Op::Slice { from, .. } if circuit.width(from) == 1 => self.bit(from),
            Op::Slice { from, low } => {
                let (from, low) = (self.slot(from), self.assembler.constant(low.into()));
                Assembler::bit(self.assembler.emit2(Kind::Bit, from, low))
            }
        }
    }

    fn word(&mut self, cell: Cell) -> Slot {
        let circuit = self.circuit;
        let ones = self.assembler.constant(mask(cell.width));
        match cell.op {
            Op::Input(_) | Op::Register(_) | Op::Port(..) | Op::Eq(..) | Op::Less { .. } => {
                unreachable!("given, not in a flat circuit, or of one bit")
            }
            Op::Const(bits) => self.assembler.constant(bits),
            Op::Not(from) => {
                let from = self.slot(from);
                self.assembler.emit2(Kind::Xor, from, ones)
            }
            Op::And(list) => self.fold(circuit.list(list), Kind::And),
            Op::Or(list) => self.fold(circuit.list(list), Kind::Or),
            Op::Xor(a, b) => self.fold(&[a, b], Kind::Xor),
            Op::Mux { select, on, off } => {
                let Bit { slot, inverted } = self.bit(select);
                let (on, off) = if inverted { (off, on) } else { (on, off) };
                let (on, off) = (self.slot(on), self.slot(off));
                self.assembler.emit(Kind::Mux, [slot, on, off])
            }
            Op::Add(a, b) => {
                let (a, b) = (self.slot(a), self.slot(b));
                self.assembler.emit(Kind::Add, [a, b, ones])
            }
            Op::Sub(a, b) => {
                let (a, b) = (self.slot(a), self.slot(b));
                self.assembler.emit(Kind::Sub, [a, b, ones])
            }
            Op::Mul(a, b) => {
                let (a, b) = (self.slot(a), self.slot(b));
                self.assembler.emit(Kind::Mul, [a, b, ones])
            }
            Op::Div(a, b) => {
                let (a, b) = (self.slot(a), self.slot(b));
                self.assembler.emit2(Kind::Div, a, b)
            }
            Op::Rem(a, b) => {
                let (a, b) = (self.slot(a), self.slot(b));
                self.assembler.emit2(Kind::Rem, a, b)
            }
            Op::Concat(list) => self.concat(circuit.list(list)),
            Op::Extend { from, signed } => self.extend(from, signed, ones),
            Op::Slice { from, low } => {
                let (from, low) = (self.slot(from), self.assembler.constant(low.into()));
                self.assembler.emit(Kind::Shift, [from, low, ones])
            }
        }
    }

    fn fold(&mut self, list: &[Net], kind: Kind) -> Slot {
        let slots: Vec<Slot> = list.iter().map(|&net| self.slot(net)).collect();
        let joined = slots.into_iter().reduce(|a, b| self.assembler.emit2(kind, a, b));
        joined.expect("a list has two operands or more")
    }

    fn concat(&mut self, list: &[Net]) -> Slot {
        let one = self.assembler.constant(1);
        let mut joined = None;
        for &net in list {
            let mut part = self.slot(net);
            let width = self.circuit.width(net);
            if width == 1 {
                part = self.assembler.emit2(Kind::And, part, one);
            }
            let by = self.assembler.constant(width.into());
            joined = Some(match joined {
                None => part,
                Some(high) => self.assembler.emit(Kind::Join, [high, part, by]),
            });
        }
        joined.expect("a list has two operands or more")
    }

    fn extend(&mut self, from: Net, signed: bool, ones: Slot) -> Slot {
        let width = self.circuit.width(from);
        let slot = self.slot(from);
        match (width, signed) {
            // All bits of its slot are copies of the one bit already.
            (1, true) => self.assembler.emit2(Kind::And, slot, ones),
            (1, false) => {
                let one = self.assembler.constant(1);
                self.assembler.emit2(Kind::And, slot, one)
            }
            (_, false) => slot,
            (_, true) => {
                let top = self.assembler.constant(1 << (width - 1));
                let moved = self.assembler.emit2(Kind::Xor, slot, top);
                self.assembler.emit(Kind::Sub, [moved, top, ones])
            }
        }
    }
}
