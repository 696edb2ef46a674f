//! Runs a single circuit, plainly, to compare printed text with.

use hotrail::circuit::{Circuit, Op};

/// A circuit and what its registers hold.
pub struct Interpreter<'a> {
    circuit: &'a Circuit,
    registers: Vec<u64>,
}

impl<'a> Interpreter<'a> {
    /// The circuit after reset.
    pub fn new(circuit: &'a Circuit) -> Self {
        let registers = circuit.registers.values().map(|register| register.reset).collect();
        Interpreter { circuit, registers }
    }

    /// The outputs for these inputs, before the clock; then the clock.
    pub fn step(&mut self, inputs: &[u64]) -> Vec<u64> {
        let mut values: Vec<u64> = Vec::new();
        for (_, cell) in self.circuit.cells() {
            let value = self.value(cell.op, inputs, &values);
            values.push(value & u64::MAX >> (64 - cell.width));
        }
        let value = |net: hotrail::circuit::Net| values[u32::from(net.into_raw()) as usize];
        let outputs = self.circuit.outputs.iter().map(|output| value(output.net)).collect();
        let registers = self.circuit.registers.values().zip(&self.registers);
        let stays = |enable: Option<_>| enable.is_some_and(|enable| value(enable) == 0);
        self.registers = registers
            .map(|(r, &held)| if stays(r.enable) { held } else { value(r.next) })
            .collect();
        outputs
    }

    fn value(&self, op: Op, inputs: &[u64], values: &[u64]) -> u64 {
        let value = |net: hotrail::circuit::Net| values[u32::from(net.into_raw()) as usize];
        let signed = |net| {
            let spare = 64 - self.circuit.width(net);
            ((value(net) << spare) as i64) >> spare
        };
        match op {
            Op::Input(index) => inputs[index as usize],
            Op::Register(id) => self.registers[u32::from(id.into_raw()) as usize],
            Op::Port(..) => panic!("it takes circuits without instances"),
            Op::Const(bits) => bits,
            Op::Not(a) => !value(a),
            Op::And(list) => {
                self.circuit.list(list).iter().fold(u64::MAX, |all, &n| all & value(n))
            }
            Op::Or(list) => self.circuit.list(list).iter().fold(0, |any, &n| any | value(n)),
            Op::Xor(a, b) => value(a) ^ value(b),
            Op::Mux { select, on, off } => value(if value(select) == 1 { on } else { off }),
            Op::Add(a, b) => value(a).wrapping_add(value(b)),
            Op::Sub(a, b) => value(a).wrapping_sub(value(b)),
            Op::Mul(a, b) => value(a).wrapping_mul(value(b)),
            Op::Div(_, b) | Op::Rem(_, b) if value(b) == 0 => 0,
            Op::Div(a, b) => value(a) / value(b),
            Op::Rem(a, b) => value(a) % value(b),
            Op::Eq(a, b) => (value(a) == value(b)).into(),
            Op::Less { a, b, signed: true } => (signed(a) < signed(b)).into(),
            Op::Less { a, b, signed: false } => (value(a) < value(b)).into(),
            Op::Extend { from, signed: true } => signed(from) as u64,
            Op::Extend { from, signed: false } => value(from),
            Op::Slice { from, low } => value(from) >> low,
            Op::Concat(list) => self
                .circuit
                .list(list)
                .iter()
                .fold(0, |high, &net| high << self.circuit.width(net) | value(net)),
        }
    }
}
