//! From a block's circuit to a module with registers, ports and the reset coil's inputs.

use super::{Block, Logic, PortRole};
use crate::circuit::{Circuit, Net, RegisterId};

/// Input: this scan has the tick.
pub const TICK: &str = "tick";
/// Input: the power that arrives at the call.
pub const POWER: &str = "power";
/// Input: a powered `(R name)` in front of the call.
pub const CLEAR_BEFORE: &str = "clear";
/// Input: a powered `(R name)` behind the call.
pub const CLEAR_AFTER: &str = "clear_after";

/// The name of the output that shows what a port was at the end of the last scan.
pub fn last(port: &str) -> String {
    format!("{port}_last")
}

/// The module of a block in its most general form: inputs are [`TICK`], [`POWER`], the parameters,
/// [`CLEAR_BEFORE`] and [`CLEAR_AFTER`]; every output port `X` is there twice, as `X` after the
/// call and as `X_last`. What an instance does not need falls away when the design is simplified.
///
/// `starts` holds the start value of each port in the order of [`Block::ports`].
pub fn module(block: &'static Block, starts: &[i64]) -> Circuit {
    let mut circuit = Circuit::new(block.name);
    circuit.comment.push(format!("{}: {}", block.name, block.title));
    // The first diagram shows what the block is for; the others are corner cases.
    circuit.comment.extend(block.waves.iter().take(1).flat_map(|w| w.lines()).map(str::to_owned));
    let tick = circuit.input(TICK, 1);
    let power = circuit.input(POWER, 1);
    let mut registers: Vec<Option<(RegisterId, Net)>> = Vec::new();
    let mut nets = Vec::new();
    for (port, &start) in block.ports.iter().zip(starts) {
        let width = port.ty.width();
        let register = (!port.role.is_parameter())
            .then(|| circuit.register(port.name, width, port.ty.bits(start)));
        nets.push(match register {
            Some((_, net)) => net,
            None => circuit.input(port.name, width),
        });
        registers.push(register);
    }
    let clear_before = circuit.input(CLEAR_BEFORE, 1);
    let clear_after = circuit.input(CLEAR_AFTER, 1);

    let clear = |circuit: &mut Circuit, nets: &mut [Net], when: Net| {
        for ((net, port), &start) in nets.iter_mut().zip(block.ports).zip(starts) {
            if port.role.is_cleared() {
                let start = circuit.constant(port.ty.bits(start), port.ty.width());
                *net = circuit.mux(when, start, *net);
            }
        }
    };
    clear(&mut circuit, &mut nets, clear_before);
    let mut logic = Logic { block, circuit: &mut circuit, power, tick, nets };
    (block.build)(&mut logic);
    let mut nets = logic.nets;
    let after_call = nets.clone();
    clear(&mut circuit, &mut nets, clear_after);

    for ((port, register), (&shown, &kept)) in
        block.ports.iter().zip(registers).zip(after_call.iter().zip(&nets))
    {
        let Some((register, last_value)) = register else { continue };
        circuit.drive(register, kept);
        if port.role == PortRole::Output {
            circuit.output(port.name, shown);
            circuit.output(last(port.name), last_value);
        }
    }
    circuit
}
