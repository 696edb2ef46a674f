//! Sixty-four runs at once: a slot holds one bit of each run.

use super::arithmetic;
use super::assembler::{Assembler, Bit, OFF};
use super::code::{Copies, Machine, Slot};
use crate::circuit::{Cell, Circuit, Design, Net, Op, Valid};
use crate::index::index;

/// How many runs there are.
pub const LANES: usize = 64;

/// A circuit that runs with 64 stimuli at once, all scan by scan.
#[derive(Clone, Debug)]
pub struct LaneSimulator {
    machine: Machine,
    /// For each input port the slots of its bits, lowest first.
    inputs: Vec<std::ops::Range<Slot>>,
    /// The same for each output port.
    outputs: Vec<Vec<Slot>>,
    /// The slot of each bit of a register and what it holds at reset.
    resets: Vec<(Slot, u64)>,
    clock: Copies,
}

struct Lowering<'c> {
    circuit: &'c Circuit,
    assembler: Assembler,
    /// The bits of each net, lowest first.
    nets: Vec<Vec<Bit>>,
    inputs: Vec<std::ops::Range<Slot>>,
    registers: Vec<std::ops::Range<Slot>>,
}

impl LaneSimulator {
    /// A design, at reset in every lane.
    pub fn new(design: &Valid<Design>) -> Self {
        let circuit = design.flatten();
        let widths = circuit.inputs.iter().map(|port| port.width);
        let widths: Vec<u32> = widths.chain(circuit.registers.values().map(|r| r.width)).collect();
        let assembler = Assembler::new([], widths.iter().sum::<u32>() as usize);
        let mut next = assembler.first_free();
        let mut given = widths.into_iter().map(|width| {
            next += width;
            next - width..next
        });
        let inputs: Vec<_> = given.by_ref().take(circuit.inputs.len()).collect();
        let registers: Vec<_> = given.collect();
        let mut lowering =
            Lowering { circuit: &circuit, assembler, nets: Vec::new(), inputs, registers };
        for (_, cell) in circuit.cells() {
            let bits = lowering.cell(cell);
            debug_assert_eq!(bits.len(), cell.width as usize);
            lowering.nets.push(bits);
        }
        let (mut nexts, mut resets) = (Vec::new(), Vec::new());
        for (slots, register) in lowering.registers.clone().iter().zip(circuit.registers.values()) {
            nexts.extend(lowering.slots(register.next).into_iter().zip(slots.clone()));
            let bits = (0..).map(|bit| (register.reset >> bit & 1).wrapping_neg());
            resets.extend(slots.clone().zip(bits));
        }
        let outputs = circuit.outputs.iter().map(|output| lowering.slots(output.net)).collect();
        let Lowering {
            assembler: Assembler { given, instructions, .. }, inputs, registers, ..
        } = lowering;
        let mut machine = Machine::new(given.len() as Slot, &instructions);
        given.iter().zip(0..).for_each(|(&value, slot)| machine.set(slot, value));
        let first_register = registers.first().map_or(Slot::MAX, |slots| slots.start);
        let is_register = |slot| (first_register..given.len() as Slot).contains(&slot);
        let clock = Copies::new(nexts.into_iter(), is_register);
        let mut simulator = LaneSimulator { machine, inputs, outputs, resets, clock };
        simulator.reset();
        simulator
    }

    /// Back to reset in every lane.
    pub fn reset(&mut self) {
        self.resets.iter().for_each(|&(slot, value)| self.machine.set(slot, value));
    }

    /// Drives a bit, from the lowest, of an input port: in each lane with the bit of that number
    /// of `lanes`.
    pub fn drive(&mut self, port: usize, bit: u32, lanes: u64) {
        let slots = &self.inputs[port];
        assert!(bit < slots.end - slots.start, "input {port} has no bit {bit}");
        self.machine.set(slots.start + bit, lanes);
    }

    /// The width of an input port in bits.
    pub fn input_width(&self, port: usize) -> u32 {
        self.inputs[port].end - self.inputs[port].start
    }

    /// Computes every net from the registers and the inputs.
    pub fn settle(&mut self) {
        self.machine.run();
    }

    /// The clock edge: every register takes its next value.
    pub fn clock(&mut self) {
        self.machine.copy(&self.clock);
    }

    /// The bits of an output port in one lane.
    pub fn output(&self, port: usize, lane: usize) -> u64 {
        let bits = self.outputs[port].iter().enumerate();
        bits.fold(0, |all, (bit, &slot)| all | (self.machine.get(slot) >> lane & 1) << bit)
    }

    /// A bit, from the lowest, of an output port in every lane.
    pub fn output_bit(&self, port: usize, bit: u32) -> u64 {
        self.machine.get(self.outputs[port][bit as usize])
    }

    /// The number of output ports.
    pub fn outputs(&self) -> usize {
        self.outputs.len()
    }

    /// The width of an output port in bits.
    pub fn output_width(&self, port: usize) -> u32 {
        self.outputs[port].len() as u32
    }
}

impl Lowering<'_> {
    fn bits(&self, net: Net) -> &[Bit] {
        &self.nets[index(net)]
    }

    /// The slots that hold the bits of a net as they are.
    fn slots(&mut self, net: Net) -> Vec<Slot> {
        let bits = self.bits(net).to_vec();
        bits.into_iter().map(|bit| self.assembler.plain(bit)).collect()
    }

    fn cell(&mut self, cell: Cell) -> Vec<Bit> {
        let width = cell.width as usize;
        match cell.op {
            Op::Input(port) => self.inputs[port as usize].clone().map(Assembler::bit).collect(),
            Op::Register(id) => self.registers[index(id)].clone().map(Assembler::bit).collect(),
            Op::Port(..) => unreachable!("a flat circuit has no ports"),
            Op::Const(bits) => {
                (0..width).map(|bit| Bit { inverted: bits >> bit & 1 == 1, ..OFF }).collect()
            }
            Op::Not(from) => self.bits(from).iter().map(|bit| bit.not()).collect(),
            Op::And(list) => {
                self.bitwise(width, self.circuit.list(list), |a, bits| a.all(bits.into_iter()))
            }
            Op::Or(list) => {
                self.bitwise(width, self.circuit.list(list), |a, bits| a.any(bits.into_iter()))
            }
            Op::Xor(a, b) => {
                self.bitwise(width, &[a, b], |assembler, bits| assembler.xor(bits[0], bits[1]))
            }
            Op::Mux { select, on, off } => {
                let select = self.bits(select)[0];
                self.bitwise(width, &[on, off], |assembler, bits| {
                    assembler.mux(select, bits[0], bits[1])
                })
            }
            Op::Add(a, b) => self.arithmetic(a, b, arithmetic::add),
            Op::Sub(a, b) => self.arithmetic(a, b, |to, a, b| arithmetic::subtract(to, a, b).0),
            Op::Mul(a, b) => self.arithmetic(a, b, arithmetic::multiply),
            Op::Div(a, b) => self.arithmetic(a, b, |to, a, b| arithmetic::divide(to, a, b).0),
            Op::Rem(a, b) => self.arithmetic(a, b, |to, a, b| arithmetic::divide(to, a, b).1),
            Op::Eq(a, b) => {
                let wide = self.bits(a).len();
                let differ =
                    self.bitwise(wide, &[a, b], |assembler, bits| assembler.xor(bits[0], bits[1]));
                vec![self.assembler.any(differ.into_iter()).not()]
            }
            Op::Less { a, b, signed } => {
                self.arithmetic(a, b, |to, a, b| vec![arithmetic::less(to, a, b, signed)])
            }
            Op::Concat(list) => {
                let parts = self.circuit.list(list).iter().rev();
                parts.flat_map(|&net| self.bits(net).to_vec()).collect()
            }
            Op::Extend { from, signed } => {
                let mut bits = self.bits(from).to_vec();
                let top = bits[bits.len() - 1];
                bits.resize(width, if signed { top } else { OFF });
                bits
            }
            Op::Slice { from, low } => self.bits(from)[low as usize..][..width].to_vec(),
        }
    }

    fn arithmetic(
        &mut self,
        a: Net,
        b: Net,
        op: impl Fn(&mut Assembler, &[Bit], &[Bit]) -> Vec<Bit>,
    ) -> Vec<Bit> {
        op(&mut self.assembler, &self.nets[index(a)], &self.nets[index(b)])
    }

    fn bitwise(
        &mut self,
        width: usize,
        operands: &[Net],
        op: impl Fn(&mut Assembler, Vec<Bit>) -> Bit,
    ) -> Vec<Bit> {
        let of_bit = |bit| {
            let bits = operands.iter().map(|&net| self.nets[index(net)][bit]).collect();
            op(&mut self.assembler, bits)
        };
        (0..width).map(of_bit).collect()
    }
}
