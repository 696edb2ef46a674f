//! Runs a circuit, one scan at a time.

use super::{Circuit, Design, Net, Op, Valid, as_signed, mask};
use crate::index::index;

/// A flat circuit with the values of its nets and registers.
#[derive(Clone, Debug)]
pub struct Simulator {
    circuit: Circuit,
    values: Vec<u64>,
    registers: Vec<u64>,
    /// Nets that follow from registers alone, in their order.
    kept: Vec<Net>,
}

impl Simulator {
    /// A design, at reset.
    pub fn new(design: &Valid<Design>) -> Self {
        let circuit = design.flatten();
        let (values, registers) = (vec![0; circuit.len()], vec![0; circuit.registers.len()]);
        let kept = follow_from_registers(&circuit);
        let mut simulator = Simulator { circuit, values, registers, kept };
        simulator.reset();
        simulator
    }

    /// The circuit that runs, without instances.
    pub fn circuit(&self) -> &Circuit {
        &self.circuit
    }

    /// Back to reset.
    pub fn reset(&mut self) {
        for (id, register) in self.circuit.registers.iter() {
            self.registers[index(id)] = register.reset;
        }
        self.show_registers();
    }

    /// Computes every net from the registers and these bits for each input port, in order.
    pub fn settle(&mut self, inputs: &[u64]) {
        for (net, cell) in self.circuit.cells() {
            self.values[index(net)] = match cell.op {
                Op::Input(port) => inputs[port as usize] & mask(cell.width),
                _ => self.value_of(cell.op, cell.width),
            };
        }
    }

    /// The clock edge: every register takes its next value.
    pub fn clock(&mut self) {
        for (id, register) in self.circuit.registers.iter() {
            self.registers[index(id)] = self.values[index(register.next)];
        }
        self.show_registers();
    }

    /// The bits of the output port of that index. A port that follows from registers alone changes
    /// at [`Simulator::clock`], any other at [`Simulator::settle`].
    pub fn output(&self, port: usize) -> u64 {
        self.values[index(self.circuit.outputs[port].net)]
    }

    fn show_registers(&mut self) {
        for &net in &self.kept {
            let cell = self.circuit.cell(net);
            self.values[index(net)] = self.value_of(cell.op, cell.width);
        }
    }

    fn value_of(&self, op: Op, width: u32) -> u64 {
        let get = |net: Net| self.values[index(net)];
        let bits = match op {
            Op::Input(_) | Op::Port(..) => {
                unreachable!("inputs are given, a flat circuit has no ports")
            }
            Op::Register(id) => self.registers[index(id)],
            Op::Const(value) => value,
            Op::Not(from) => !get(from),
            Op::And(list) => {
                self.circuit.list(list).iter().fold(u64::MAX, |all, &net| all & get(net))
            }
            Op::Or(list) => self.circuit.list(list).iter().fold(0, |any, &net| any | get(net)),
            Op::Xor(a, b) => get(a) ^ get(b),
            Op::Mux { select, on, off } => get(if get(select) != 0 { on } else { off }),
            Op::Add(a, b) => get(a).wrapping_add(get(b)),
            Op::Sub(a, b) => get(a).wrapping_sub(get(b)),
            Op::Mul(a, b) => get(a).wrapping_mul(get(b)),
            Op::Div(a, b) => get(a).checked_div(get(b)).unwrap_or(0),
            Op::Rem(a, b) => get(a).checked_rem(get(b)).unwrap_or(0),
            Op::Eq(a, b) => u64::from(get(a) == get(b)),
            Op::Less { a, b, signed: false } => u64::from(get(a) < get(b)),
            Op::Less { a, b, signed: true } => {
                let signed = |net| as_signed(get(net), self.circuit.width(net));
                u64::from(signed(a) < signed(b))
            }
            Op::Extend { from, signed: false } => get(from),
            Op::Extend { from, signed: true } => {
                as_signed(get(from), self.circuit.width(from)) as u64
            }
            Op::Slice { from, low } => get(from) >> low,
            Op::Concat(list) => self.circuit.list(list).iter().fold(0, |high, &net| {
                // A part of all 64 bits would have no neighbour.
                high << self.circuit.width(net) | get(net)
            }),
        };
        bits & mask(width)
    }
}

/// The nets that no input reaches within a clock.
fn follow_from_registers(circuit: &Circuit) -> Vec<Net> {
    let mut is_reached = vec![false; circuit.len()];
    let mut kept = Vec::new();
    for (net, cell) in circuit.cells() {
        let mut reached = matches!(cell.op, Op::Input(_));
        circuit.for_each_operand(cell, |operand| reached |= is_reached[index(operand)]);
        is_reached[index(net)] = reached;
        if !reached {
            kept.push(net);
        }
    }
    kept
}
