//! Makes cells. Each function folds what is constant or does nothing, so that a caller can write
//! the general case.

use std::sync::Arc;

use super::{
    Cell, Circuit, Input, Instance, InstanceId, ModuleId, Net, Op, Operands, Output, Reading,
    Register, RegisterId, Section, as_signed, mask,
};

/// The longest list of operands that is searched for operands that say nothing new.
const ABSORBED: usize = 4;

/// True if the net is among the first few: to look through all of a long list for each of its
/// operands would take too long, and repeating one is harmless.
fn is_among_first(nets: &[Net], net: Net) -> bool {
    nets.iter().take(32).any(|&other| other == net)
}

impl Circuit {
    /// A circuit without ports and cells.
    pub fn new(name: impl Into<String>) -> Self {
        Circuit { name: name.into(), ..Circuit::default() }
    }

    pub(super) fn add_cell(&mut self, op: Op, width: u32) -> Net {
        self.cells.alloc(Cell { op, width })
    }

    /// Starts a section: cells made from now on belong to it.
    pub fn section(&mut self, comment: impl Into<Arc<str>>, rung: u32) {
        let start = self.cells.len() as u32;
        self.sections.push(Section { comment: comment.into(), rung, start });
    }

    /// A new input port and its net.
    pub fn input(&mut self, name: impl Into<Arc<str>>, width: u32) -> Net {
        self.input_of(name, width, Reading::Unsigned)
    }

    /// A new input port whose word is read as that.
    pub fn input_of(&mut self, name: impl Into<Arc<str>>, width: u32, reading: Reading) -> Net {
        self.inputs.push(Input { name: name.into(), width, reading });
        self.add_cell(Op::Input(self.inputs.len() as u32 - 1), width)
    }

    /// A new output port.
    pub fn output(&mut self, name: impl Into<Arc<str>>, net: Net) {
        self.outputs.push(Output { name: name.into(), net });
    }

    /// A new register and the net of its value. It keeps its value until it is given a `next`
    /// with [`Circuit::drive`].
    pub fn register(
        &mut self,
        name: impl Into<Arc<str>>,
        width: u32,
        reset: u64,
    ) -> (RegisterId, Net) {
        let name = name.into();
        let reset = reset & mask(width);
        let net = Net::from_raw((self.cells.len() as u32).into());
        let id = self.registers.alloc(Register { name, width, reset, next: net, enable: None });
        self.add_cell(Op::Register(id), width);
        (id, net)
    }

    /// Gives a register its next value.
    pub fn drive(&mut self, register: RegisterId, next: Net) {
        self.registers[register].next = next;
    }

    /// Gives a register the value that it takes where a bit is 1.
    pub fn drive_where(&mut self, enable: Net, register: RegisterId, next: Net) {
        self.registers[register].enable = Some(enable);
        self.registers[register].next = next;
    }

    /// A new instance of a circuit; its inputs are given later.
    pub fn instance(&mut self, name: impl Into<String>, module: ModuleId) -> InstanceId {
        self.instances.alloc(Instance {
            name: name.into(),
            module,
            inputs: Vec::new(),
            enable: None,
        })
    }

    /// The net of an instance's output port.
    pub fn port(&mut self, instance: InstanceId, output: usize, width: u32) -> Net {
        self.add_cell(Op::Port(instance, output as u32), width)
    }

    /// The lowest `width` bits of `value`.
    pub fn constant(&mut self, value: u64, width: u32) -> Net {
        self.add_cell(Op::Const(value & mask(width)), width)
    }

    /// One bit.
    pub fn bit(&mut self, value: bool) -> Net {
        self.constant(u64::from(value), 1)
    }

    /// The bits of a net that is a constant.
    pub fn constant_value(&self, net: Net) -> Option<u64> {
        match self.cells[net].op {
            Op::Const(value) => Some(value),
            _ => None,
        }
    }

    /// Every bit inverted.
    pub fn not(&mut self, from: Net) -> Net {
        let width = self.width(from);
        match self.cells[from].op {
            Op::Const(value) => self.constant(!value, width),
            Op::Not(inner) => inner,
            _ => self.add_cell(Op::Not(from), width),
        }
    }

    /// Bit by bit and of one operand or more.
    ///
    /// # Panics
    /// If there is no operand.
    pub fn and(&mut self, operands: impl IntoIterator<Item = Net>) -> Net {
        self.and_or(operands, true)
    }

    /// Bit by bit or of one operand or more.
    ///
    /// # Panics
    /// If there is no operand.
    pub fn or(&mut self, operands: impl IntoIterator<Item = Net>) -> Net {
        self.and_or(operands, false)
    }

    fn and_or(&mut self, operands: impl IntoIterator<Item = Net>, and: bool) -> Net {
        let mut operands = operands.into_iter().peekable();
        let width = self.width(*operands.peek().expect("there is an operand"));
        let (neutral, absorbing) = if and { (mask(width), 0) } else { (0, mask(width)) };
        let start = self.operands.len();
        for operand in operands {
            match self.constant_value(operand) {
                Some(value) if value == absorbing => {
                    self.operands.truncate(start);
                    return self.constant(absorbing, width);
                }
                Some(value) if value == neutral => {}
                _ if is_among_first(&self.operands[start..], operand) => {}
                _ => self.operands.push(operand),
            }
        }
        self.absorb(start, and);
        match self.operands.len() - start {
            0 => self.constant(neutral, width),
            1 => self.operands.pop().expect("there is one operand"),
            len => {
                let list = Operands { start: start as u32, len: len as u32 };
                self.add_cell(if and { Op::And(list) } else { Op::Or(list) }, width)
            }
        }
    }

    /// Drops what the operands from `start` on say twice: `a` next to `a and b`, and what
    /// `a ? b : c` is where `a` is decided.
    fn absorb(&mut self, start: usize, and: bool) {
        if self.operands.len() - start > ABSORBED {
            return;
        }
        for at in start..self.operands.len() {
            let Op::Mux { select, on, off } = self.cells[self.operands[at]].op else { continue };
            let chosen = if and { on } else { off };
            let is_decided = self.operands[start..].contains(&select);
            if is_decided && self.constant_value(chosen).is_none() {
                self.operands[at] = chosen;
            }
        }
        let list = &self.operands[start..];
        let held =
            |net: Net| list.iter().any(|&other| other != net && self.holds(other, net, and, 2));
        let kept: Vec<Net> = list.iter().copied().filter(|&net| !held(net)).collect();
        self.operands.truncate(start);
        self.operands.extend(kept);
    }

    /// True if a net is 0 (or, if not `and`, 1) wherever `part` is.
    fn holds(&self, net: Net, part: Net, and: bool, depth: u32) -> bool {
        let holds =
            |inner: Net| inner == part || depth > 0 && self.holds(inner, part, and, depth - 1);
        match self.cells[net].op {
            Op::And(operands) if and => {
                self.list(operands).iter().take(ABSORBED).any(|&net| holds(net))
            }
            Op::Or(operands) if !and => {
                self.list(operands).iter().take(ABSORBED).any(|&net| holds(net))
            }
            Op::Mux { select, on, off } if and && self.constant_value(off) == Some(0) => {
                holds(on) || self.width(net) == 1 && holds(select)
            }
            _ => false,
        }
    }

    /// Bit by bit exclusive or.
    pub fn xor(&mut self, a: Net, b: Net) -> Net {
        let width = self.width(a);
        if a == b {
            return self.constant(0, width);
        }
        match (self.constant_value(a), self.constant_value(b)) {
            (Some(x), Some(y)) => self.constant(x ^ y, width),
            (Some(0), None) => b,
            (None, Some(0)) => a,
            (Some(x), None) if x == mask(width) => self.not(b),
            (None, Some(y)) if y == mask(width) => self.not(a),
            _ => self.add_cell(Op::Xor(a, b), width),
        }
    }

    /// `on` where the one-bit `select` is 1, else `off`.
    pub fn mux(&mut self, select: Net, on: Net, off: Net) -> Net {
        let width = self.width(on);
        if on == off {
            return on;
        }
        match self.constant_value(select) {
            Some(0) => return off,
            Some(_) => return on,
            None => {}
        }
        match (self.constant_value(on), self.constant_value(off)) {
            (Some(x), Some(y)) if x == y => on,
            (Some(1), _) if width == 1 => self.or([select, off]),
            (_, Some(0)) if width == 1 => self.and([select, on]),
            (Some(0), _) if width == 1 => {
                let unselected = self.not(select);
                self.and([unselected, off])
            }
            (_, Some(1)) if width == 1 => {
                let unselected = self.not(select);
                self.or([unselected, on])
            }
            _ => self.add_cell(Op::Mux { select, on, off }, width),
        }
    }

    /// As [`Circuit::mux`], but a choice between a constant and a bit stays a choice: synthesis
    /// finds the enable and the reset of a flip-flop in choices.
    pub fn choice(&mut self, select: Net, on: Net, off: Net) -> Net {
        let [is_on, is_off] = [on, off].map(|net| self.constant_value(net).is_some());
        match self.constant_value(select) {
            None if on != off && is_on != is_off => {
                let width = self.width(on);
                self.add_cell(Op::Mux { select, on, off }, width)
            }
            _ => self.mux(select, on, off),
        }
    }

    /// The sum, wrapped.
    pub fn add(&mut self, a: Net, b: Net) -> Net {
        let width = self.width(a);
        match (self.constant_value(a), self.constant_value(b)) {
            (Some(x), Some(y)) => self.constant(x.wrapping_add(y), width),
            (Some(0), None) => b,
            (None, Some(0)) => a,
            _ => self.add_cell(Op::Add(a, b), width),
        }
    }

    /// The difference, wrapped.
    pub fn sub(&mut self, a: Net, b: Net) -> Net {
        let width = self.width(a);
        if a == b {
            return self.constant(0, width);
        }
        match (self.constant_value(a), self.constant_value(b)) {
            (Some(x), Some(y)) => self.constant(x.wrapping_sub(y), width),
            (None, Some(0)) => a,
            _ => self.add_cell(Op::Sub(a, b), width),
        }
    }

    /// One bit: 1 if both are equal. A constant stands at the right, as people write it.
    pub fn eq(&mut self, a: Net, b: Net) -> Net {
        if a == b {
            return self.bit(true);
        }
        match (self.constant_value(a), self.constant_value(b)) {
            (Some(x), Some(y)) => self.bit(x == y),
            (Some(_), None) => self.eq(b, a),
            (None, Some(y)) if self.width(a) == 1 => self.not_if(a, y == 0),
            _ => self.add_cell(Op::Eq(a, b), 1),
        }
    }

    fn not_if(&mut self, net: Net, inverted: bool) -> Net {
        if inverted { self.not(net) } else { net }
    }

    /// One bit: 1 if `a` is less than `b`.
    pub fn less(&mut self, a: Net, b: Net, signed: bool) -> Net {
        let width = self.width(a);
        let top = if signed { 1 << (width - 1) } else { 0 };
        // Flipping the sign bit puts the numbers in order of their bits.
        let in_order = |value: u64| value ^ top;
        match (self.constant_value(a).map(in_order), self.constant_value(b).map(in_order)) {
            (Some(x), Some(y)) => self.bit(x < y),
            (_, Some(0)) => self.bit(false),
            (Some(x), _) if x == mask(width) => self.bit(false),
            _ if a == b => self.bit(false),
            _ => self.add_cell(Op::Less { a, b, signed }, 1),
        }
    }

    /// `from` made `width` bits wide: its lowest bits, or extended by zeros or its sign.
    pub fn resize(&mut self, from: Net, width: u32, signed: bool) -> Net {
        let old = self.width(from);
        match self.constant_value(from) {
            _ if width == old => from,
            Some(value) if signed => self.constant(as_signed(value, old) as u64, width),
            Some(value) => self.constant(value, width),
            None if width < old => self.slice(from, 0, width),
            None => match self.cells[from].op {
                // Zeros stand before it already, so its top bit is one of them.
                Op::Extend { from: inner, signed: false } => self.resize(inner, width, false),
                Op::Extend { from: inner, signed: true } if signed => {
                    self.resize(inner, width, true)
                }
                _ => self.add_cell(Op::Extend { from, signed }, width),
            },
        }
    }

    /// `width` bits from bit `low` up.
    pub fn slice(&mut self, from: Net, low: u32, width: u32) -> Net {
        if low == 0 && width == self.width(from) {
            return from;
        }
        match self.cells[from].op {
            Op::Const(value) => self.constant(value >> low, width),
            Op::Slice { from: outer, low: above } => self.slice(outer, above + low, width),
            Op::Extend { from: inner, .. } if low + width <= self.width(inner) => {
                self.slice(inner, low, width)
            }
            Op::Extend { from: inner, signed } if low == 0 => self.resize(inner, width, signed),
            Op::Extend { from: inner, signed: false } if low >= self.width(inner) => {
                self.constant(0, width)
            }
            Op::Concat(parts) => {
                let mut top = self.width(from);
                let mut kept = Vec::new();
                for part in self.list(parts).to_vec() {
                    top -= self.width(part);
                    let (first, end) = (low.max(top), (low + width).min(top + self.width(part)));
                    if first < end {
                        kept.push(self.slice(part, first - top, end - first));
                    }
                }
                self.concat(kept)
            }
            _ => self.add_cell(Op::Slice { from, low }, width),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Linters see through what is constant, and would speak of it.
    #[test]
    fn what_is_constant_for_every_input_is_folded() {
        let mut circuit = Circuit::new("folded");
        let (a, lowest) = (circuit.input("a", 16), circuit.constant(0x8000, 16));
        let (highest, zero) = (circuit.constant(0xFFFF, 16), circuit.constant(0, 16));
        let difference = circuit.sub(a, a);
        let exclusive = circuit.xor(a, a);
        for net in [difference, exclusive] {
            assert_eq!(circuit.constant_value(net), Some(0));
        }
        let never = [
            circuit.less(a, difference, false),
            circuit.less(a, zero, false),
            circuit.less(highest, a, false),
            circuit.less(a, lowest, true),
            circuit.less(a, a, true),
        ];
        for net in never {
            assert_eq!(circuit.constant_value(net), Some(0));
        }
        let always = Circuit::eq(&mut circuit, a, a);
        assert_eq!(circuit.constant_value(always), Some(1));
        let sometimes = circuit.less(a, zero, true);
        assert_eq!(circuit.constant_value(sometimes), None);
    }
}
