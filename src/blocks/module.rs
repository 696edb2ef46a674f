//! From a block's circuit to a module with registers, ports and the reset coil's inputs.

use super::wave::Wave;
use super::{Choice, Logic, PortRole, Shape};
use crate::circuit::{Circuit, Net, Reading};
use crate::types::Type;

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

/// The name of the input that brings what a port outside of the module is in front of the call.
pub fn before(port: &str) -> String {
    format!("{port}_before")
}

/// The module of a block in its most general form. What an instance does not need falls away when
/// the design is simplified. Its inputs are
/// - [`TICK`], [`POWER`], [`CLEAR_BEFORE`] and [`CLEAR_AFTER`],
/// - each parameter `X` that a call reads, as `X`,
/// - each port `X` that the program holds, as `X_before`;
///
/// and its outputs
/// - each of those after the call, as `X`,
/// - each output `X` that the module holds, as `X` after the call and as `X_last`.
///
/// `starts` holds the start value of each port in the order of [`Shape::ports`].
pub fn module(shape: &Shape, starts: &[i64]) -> Circuit {
    let mut circuit = Circuit::new(shape.block.name);
    describe(shape, &mut circuit);
    let tick = circuit.input(TICK, 1);
    let power = circuit.input(POWER, 1);
    let mut registers = Vec::new();
    let mut nets = Vec::new();
    for (port, &start) in shape.ports.iter().zip(starts) {
        let (width, bits) = (port.ty.width(), port.ty.bits(start));
        let register = port.role.is_inside().then(|| circuit.register(port.name, width, bits));
        nets.push(match (register, port.role) {
            (Some((_, net)), _) => Some(net),
            (None, PortRole::Idle { .. }) => None,
            (None, role) if role.is_outside() => Some(circuit.input(before(port.name), width)),
            (None, _) => Some(circuit.input_of(port.name, width, reading(port.ty))),
        });
        registers.push(register);
    }
    let clear_before = circuit.input(CLEAR_BEFORE, 1);
    let clear_after = circuit.input(CLEAR_AFTER, 1);

    let clear = |circuit: &mut Circuit, nets: &mut [Option<Net>], when: Net| {
        for ((net, port), &start) in nets.iter_mut().zip(&shape.ports).zip(starts) {
            if let Some(net) = net
                && port.role.is_inside()
                && port.role.is_cleared()
            {
                let start = port.cleared.unwrap_or(start);
                let start = circuit.constant(port.ty.bits(start), port.ty.width());
                *net = circuit.mux(when, start, *net);
            }
        }
    };
    clear(&mut circuit, &mut nets, clear_before);
    let mut logic = Logic { shape, circuit: &mut circuit, power, tick, nets };
    (shape.block.build)(&mut logic);
    let mut nets = logic.nets;
    let after_call = nets.clone();
    clear(&mut circuit, &mut nets, clear_after);

    for ((port, register), (shown, kept)) in
        shape.ports.iter().zip(registers).zip(after_call.into_iter().zip(nets))
    {
        let (Some(shown), Some(kept)) = (shown, kept) else { continue };
        if port.role.is_result() {
            circuit.output(port.name, shown);
        }
        let Some((register, last_value)) = register else { continue };
        circuit.drive(register, kept);
        if port.role == PortRole::Output {
            circuit.output(last(port.name), last_value);
        }
    }
    circuit
}

fn reading(ty: Type) -> Reading {
    match ty {
        Type::Time => Reading::Ticks,
        _ if ty.is_signed() => Reading::Signed,
        _ => Reading::Unsigned,
    }
}

/// The name and the head of the module: its settings, and the first diagram of such a block, which
/// shows what it is for; the others are corner cases.
fn describe(shape: &Shape, circuit: &mut Circuit) {
    let block = shape.block;
    for (setting, chosen) in block.settings.iter().zip(&shape.chosen) {
        match (&setting.choice, chosen.as_slice()) {
            (Choice::Word(words), &[word]) if word != 0 => {
                circuit.name += &format!("_{}", words[word as usize]);
            }
            (Choice::Register { .. }, words) => {
                circuit.name += &format!("_{}", 16 * words.len());
            }
            (Choice::Time(..), [ticks]) => circuit.name += &format!("_{}{ticks}", setting.name),
            _ => {}
        }
    }
    let settings: String = shape.described().iter().map(|one| format!(", {one}")).collect();
    circuit.comment.push(format!("{}: {}{settings}", block.name, block.title));
    if let Some(text) = block.waves.iter().find(|text| shows(text, shape)) {
        let is_word = |line: &&str| {
            let name = line.split_once(" = ").map(|(name, _)| name);
            block.settings.iter().any(|setting| {
                Some(setting.name) == name && matches!(setting.choice, Choice::Word(_))
            })
        };
        let lines = text.lines().filter(|line| !is_word(line));
        let (presets, drawn): (Vec<&str>, Vec<&str>) = lines.partition(|line| line.contains(" = "));
        if !presets.is_empty() {
            circuit.comment.push(format!("Example, with {}:", presets.join(", ")));
        }
        circuit.comment.extend(drawn.into_iter().map(str::to_owned));
    }
}

/// True if a diagram is one of a block with the same words.
fn shows(text: &str, shape: &Shape) -> bool {
    let wave = Wave::parse(shape.block, text).expect("a block's diagrams can be read");
    let settings = shape.block.settings.iter().zip(&shape.chosen).zip(wave.chosen);
    settings
        .filter(|((setting, _), _)| matches!(setting.choice, Choice::Word(_)))
        .all(|((_, chosen), drawn)| *chosen == drawn)
}

/// What two calls have in common that can use one module.
pub type Key = (&'static str, Vec<Vec<i64>>, Vec<Option<i64>>);

/// The key of a call: what `module` makes of it depends on nothing else.
pub fn key(shape: &Shape, starts: &[i64]) -> Key {
    let ports = shape.ports.iter().zip(starts);
    let held = ports.map(|(port, &start)| port.role.is_inside().then_some(start));
    (shape.block.name, shape.chosen.clone(), held.collect())
}
