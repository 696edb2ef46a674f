//! Decides which cells get a wire of their own and which are printed inside their only user.

use std::collections::HashMap;

use crate::circuit::{Cell, Circuit, InstanceId, Net, Op, Operands, RegisterId};
use crate::index::index;

/// The most operators that stand inside each other in one expression.
const DEEPEST: u8 = 32;

/// Something reads the cell or names it.
const LIVE: u8 = 1;
/// Its user, or a signal's name, demands a wire.
const DEMANDED: u8 = 1 << 1;
/// Its reader inverts it.
const INVERTED: u8 = 1 << 2;
/// An output port of one bit shows it.
const SHOWN: u8 = 1 << 3;
/// Something reads all its bits.
const READ: u8 = 1 << 4;
/// Its user needs its name, even if it is a constant.
const CUT: u8 = 1 << 5;
/// A signal names it.
const NAMED: u8 = 1 << 6;
/// It has a wire.
const WIRE: u8 = 1 << 7;

#[derive(Clone, Copy, Default)]
struct Facts {
    flags: u8,
    uses: u8,
    depth: u8,
}

/// How each cell of a circuit is printed.
pub struct Plan {
    facts: Vec<Facts>,
    /// The bits that slices read of cells.
    sliced: HashMap<Net, u64>,
}

/// What a cell computes, as it is printed.
#[derive(Clone, Copy, Debug)]
pub enum Form {
    /// A port, a register or a constant.
    Leaf,
    /// Both languages invert bit by bit.
    Not(Net),
    /// Bit by bit.
    And(Operands),
    /// Bit by bit.
    Or(Operands),
    /// Bit by bit; also the sum and the difference of single bits.
    Xor(Net, Net),
    /// The second operand and not the first: the comparison of single bits.
    Above(Net, Net),
    /// A choice between `on` and `off`.
    Choice(Net, Net, Net),
    /// A sum.
    Sum(Net, Net),
    /// A difference.
    Difference(Net, Net),
    /// A product, as wide as an operand.
    Product(Net, Net),
    /// An unsigned quotient; 0 for the divisor 0.
    Quotient(Net, Net),
    /// What an unsigned division leaves; 0 for the divisor 0.
    Rest(Net, Net),
    /// A comparison.
    Compare(Relation, Net, Net),
    /// An extension with zeros or, if true, with the top bit.
    Extend(Net, bool),
    /// Bits from that one up.
    Slice(Net, u32),
    /// Parts side by side, the highest bits first.
    Concat(Operands),
}

/// A comparison.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    /// `a = b`
    Equal,
    /// `a /= b`
    Unequal,
    /// `a < b`, in two's complement if true.
    Less(bool),
    /// `a >= b`, in two's complement if true.
    AtLeast(bool),
    /// `a > b`, in two's complement if true.
    Greater(bool),
    /// `a <= b`, in two's complement if true.
    AtMost(bool),
}

impl Plan {
    /// Looks at every cell twice: users before operands, then operands before users.
    pub fn new(circuit: &Circuit) -> Plan {
        let mut plan =
            Plan { facts: vec![Facts::default(); circuit.len()], sliced: HashMap::new() };
        plan.note_roots(circuit);
        for (net, cell) in circuit.cells().rev() {
            if plan.is_live(net) {
                plan.note_uses(circuit, cell);
            }
        }
        for (net, cell) in circuit.cells() {
            if plan.is_live(net) {
                plan.decide(circuit, net, cell);
            }
        }
        plan
    }

    /// True if the net is printed at all.
    pub fn is_live(&self, net: Net) -> bool {
        self.has(net, LIVE)
    }

    /// True if the net has a wire of its own.
    pub fn has_wire(&self, net: Net) -> bool {
        self.has(net, WIRE)
    }

    /// The bits of a net that something reads.
    pub fn read_bits(&self, net: Net) -> u64 {
        if self.has(net, READ) { u64::MAX } else { self.sliced.get(&net).copied().unwrap_or(0) }
    }

    /// What the cell of a net computes.
    pub fn form(&self, circuit: &Circuit, net: Net) -> Form {
        let cell = circuit.cell(net);
        match cell.op {
            Op::Input(_) | Op::Register(_) | Op::Port(..) | Op::Const(_) => Form::Leaf,
            Op::Not(from) => match self.inverted_comparison(circuit, from) {
                Some((relation, a, b)) => Form::Compare(relation, a, b),
                None => Form::Not(from),
            },
            Op::And(operands) => Form::And(operands),
            Op::Or(operands) => Form::Or(operands),
            Op::Xor(a, b) => Form::Xor(a, b),
            Op::Add(a, b) | Op::Sub(a, b) if cell.width == 1 => Form::Xor(a, b),
            Op::Add(a, b) => Form::Sum(a, b),
            Op::Sub(a, b) => Form::Difference(a, b),
            Op::Mul(a, b) => Form::Product(a, b),
            Op::Div(a, b) => Form::Quotient(a, b),
            Op::Rem(a, b) => Form::Rest(a, b),
            Op::Mux { select, on, off } => Form::Choice(select, on, off),
            Op::Eq(a, b) => Form::Compare(Relation::Equal, a, b),
            // A single bit is a sign of its own: 1 is -1 then.
            Op::Less { a, b, signed: true } if circuit.width(a) == 1 => Form::Above(b, a),
            Op::Less { a, b, signed: false } if circuit.width(a) == 1 => Form::Above(a, b),
            // The constant of a comparison stands at its right, as people write it.
            Op::Less { a, b, signed } if is_constant(circuit, a) => {
                Form::Compare(Relation::Greater(signed), b, a)
            }
            Op::Less { a, b, signed } => Form::Compare(Relation::Less(signed), a, b),
            Op::Extend { from, signed } => Form::Extend(from, signed),
            Op::Slice { from, low } => Form::Slice(from, low),
            Op::Concat(operands) => Form::Concat(operands),
        }
    }

    fn inverted_comparison(&self, circuit: &Circuit, from: Net) -> Option<(Relation, Net, Net)> {
        if self.has_wire(from) || !is_comparison(circuit, from) {
            return None;
        }
        match self.form(circuit, from) {
            Form::Compare(Relation::Equal, a, b) => Some((Relation::Unequal, a, b)),
            Form::Compare(Relation::Less(signed), a, b) => Some((Relation::AtLeast(signed), a, b)),
            Form::Compare(Relation::Greater(signed), a, b) => {
                Some((Relation::AtMost(signed), a, b))
            }
            _ => None,
        }
    }

    fn has(&self, net: Net, flag: u8) -> bool {
        self.facts[index(net)].flags & flag != 0
    }

    fn set(&mut self, net: Net, flags: u8) {
        self.facts[index(net)].flags |= flags;
    }

    fn count_use(&mut self, net: Net, flags: u8) {
        let facts = &mut self.facts[index(net)];
        facts.uses = facts.uses.saturating_add(1);
        facts.flags |= LIVE | flags;
    }

    fn note_roots(&mut self, circuit: &Circuit) {
        for (_, register) in circuit.registers.iter() {
            self.count_use(register.next, READ | DEMANDED);
            register.enable.into_iter().for_each(|net| self.count_use(net, READ | DEMANDED | CUT));
        }
        // VHDL-93 connects a port to a name or a constant only.
        for (_, instance) in circuit.instances.iter() {
            let nets = instance.inputs.iter().chain(&instance.enable);
            nets.for_each(|&net| self.count_use(net, READ | DEMANDED));
        }
        for output in &circuit.outputs {
            let kind = if circuit.width(output.net) == 1 { SHOWN } else { CUT };
            self.count_use(output.net, READ | kind);
        }
        for signal in &circuit.signals {
            // A second name reads the first, and so does a name for what is no cell's result.
            let alias =
                self.has(signal.net, NAMED) || matches!(self.form(circuit, signal.net), Form::Leaf);
            self.set(signal.net, LIVE | DEMANDED | NAMED | if alias { READ } else { 0 });
        }
    }

    fn note_uses(&mut self, circuit: &Circuit, cell: Cell) {
        match cell.op {
            // Both languages cut bits out of a name only.
            Op::Slice { from, low } => {
                self.count_use(from, CUT);
                *self.sliced.entry(from).or_default() |= crate::circuit::mask(cell.width) << low;
            }
            // Verilog repeats the top bit of a name; a number has no width in VHDL.
            Op::Extend { from, signed } => {
                let cut = signed && circuit.width(from) > 1 || is_constant(circuit, from);
                self.count_use(from, READ | if cut { CUT } else { 0 });
            }
            Op::Not(from) => self.count_use(from, READ | INVERTED),
            // A number takes its width from the other side in VHDL.
            Op::Add(a, b) | Op::Sub(a, b) | Op::Eq(a, b) | Op::Less { a, b, .. } => {
                let cut = is_constant(circuit, a) && is_constant(circuit, b);
                self.count_use(a, READ | if cut { CUT } else { 0 });
                self.count_use(b, READ);
            }
            // A divisor is looked at twice; and what has a name in both languages need not be
            // multiplied or divided to prove that the products or quotients are equal.
            Op::Mul(a, b) | Op::Div(a, b) | Op::Rem(a, b) => {
                for operand in [a, b] {
                    let cut = if is_constant(circuit, operand) { 0 } else { CUT };
                    self.count_use(operand, READ | cut);
                }
            }
            Op::Input(_)
            | Op::Register(_)
            | Op::Port(..)
            | Op::Const(_)
            | Op::Concat(_)
            | Op::And(_)
            | Op::Or(_)
            | Op::Xor(..)
            | Op::Mux { .. } => {
                circuit.for_each_operand(cell, |operand| self.count_use(operand, READ));
            }
        }
        // Only where the type is known can VHDL tell which type parts make.
        if !matches!(cell.op, Op::Mux { .. }) {
            circuit.for_each_operand(cell, |operand| {
                if matches!(circuit.cell(operand).op, Op::Concat(_)) {
                    self.set(operand, CUT);
                }
            });
        }
    }

    fn decide(&mut self, circuit: &Circuit, net: Net, cell: Cell) {
        let (demanded, uses) = (self.has(net, DEMANDED | CUT), self.facts[index(net)].uses);
        let wire = match self.form(circuit, net) {
            Form::Leaf => is_constant(circuit, net) && self.has(net, CUT),
            // A slice of a name is as short as a name.
            Form::Slice(..) => demanded,
            Form::Compare(..) if uses == 1 && self.has(net, INVERTED) => demanded,
            // Each word operation stands alone, so that it wraps at its own width everywhere.
            Form::Compare(..)
            | Form::Choice(..)
            | Form::Sum(..)
            | Form::Difference(..)
            | Form::Product(..)
            | Form::Quotient(..)
            | Form::Rest(..) => demanded || uses > 1 || !self.has(net, SHOWN),
            Form::Not(_)
            | Form::And(_)
            | Form::Or(_)
            | Form::Xor(..)
            | Form::Above(..)
            | Form::Extend(..)
            | Form::Concat(_) => demanded || uses > 1,
        };
        let mut depth = 0;
        circuit.for_each_operand(cell, |operand| {
            depth = depth.max(self.facts[index(operand)].depth + 1);
        });
        if wire || depth > DEEPEST {
            self.set(net, WIRE);
        } else {
            self.facts[index(net)].depth = depth;
        }
    }
}

fn is_comparison(circuit: &Circuit, net: Net) -> bool {
    matches!(circuit.cell(net).op, Op::Eq(..) | Op::Less { .. })
}

fn is_constant(circuit: &Circuit, net: Net) -> bool {
    circuit.constant_value(net).is_some()
}

/// True for what is there without being computed.
pub fn is_leaf(op: Op) -> bool {
    matches!(op, Op::Const(_)) || origin(op) != Origin::Cell
}

/// Where the value of a cell comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Origin {
    /// The input port of that index.
    Input(usize),
    /// A register.
    Register(RegisterId),
    /// An output of an instance.
    Port(InstanceId, u32),
    /// The cell itself.
    Cell,
}

/// Where the value of a cell comes from.
pub fn origin(op: Op) -> Origin {
    match op {
        Op::Input(input) => Origin::Input(input as usize),
        Op::Register(id) => Origin::Register(id),
        Op::Port(instance, output) => Origin::Port(instance, output),
        Op::Const(_)
        | Op::Not(_)
        | Op::And(_)
        | Op::Or(_)
        | Op::Xor(..)
        | Op::Mux { .. }
        | Op::Add(..)
        | Op::Sub(..)
        | Op::Mul(..)
        | Op::Div(..)
        | Op::Rem(..)
        | Op::Eq(..)
        | Op::Less { .. }
        | Op::Extend { .. }
        | Op::Slice { .. }
        | Op::Concat(_) => Origin::Cell,
    }
}
