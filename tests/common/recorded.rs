//! Programs with a test that expects what the reference evaluator does, for whoever else runs
//! tests.

use std::fmt::Write;

use fastrand::Rng;
use hotrail::eval::Evaluator;
use hotrail::model::{Program, Role, Variable, VariableId};
use hotrail::types::Type;

use super::dice::Dice;

/// A literal of a value, as an expectation can compare with it; a tick is so many milliseconds.
fn literal(ty: Type, value: i64, tick: i64) -> String {
    match ty {
        // The magnitude of the lowest TIME is no TIME.
        Type::Time if value == Type::Time.range().0 => {
            format!("{}ms - {tick}ms", (value + 1) * tick)
        }
        Type::Time => format!("{}ms", value * tick),
        _ => value.to_string(),
    }
}

/// A variable's name as a program writes it.
fn quoted(program: &Program, id: VariableId, variable: &Variable) -> String {
    if let Some(array) = program.array_of(id) {
        let (array, index) = (&program.arrays[array].name, variable.name.rfind('['));
        return format!("`{array}`{}", &variable.name[index.expect("elements have an index")..]);
    }
    match variable.role {
        Role::Member(instance, port) => {
            let instance = &program.instances[instance];
            format!("`{}`.{}", instance.name, instance.shape.ports[port].name)
        }
        _ => format!("`{}`", variable.name),
    }
}

/// The program with a test that drives it at random and expects, after every scan, what the
/// evaluator says.
pub fn with_recorded_test(text: &str, program: &Program, random: &mut Rng) -> String {
    let is_shown = |variable: &Variable| program.is_named(variable) && variable.role != Role::Input;
    let inputs: Vec<VariableId> = program.with_role(Role::Input).map(|(id, _)| id).collect();
    let tick_ms = (program.tick_ns / 1_000_000) as i64;
    let mut evaluator = Evaluator::new(program);
    let mut text = format!("{text}test \"as recorded\"\n");
    for _ in 0..60 {
        for &input in &inputs {
            let ty = &program.variables[input].ty;
            let name = quoted(program, input, &program.variables[input]);
            if random.u8(..3) == 0 {
                let value = random.value(*ty);
                evaluator.drive(input, value);
                writeln!(text, "    {name} := {}", literal(*ty, value, tick_ms)).unwrap();
            }
        }
        let tick = random.bool();
        evaluator.scan(tick);
        let run = if tick { format!("wait {tick_ms}ms") } else { "scan".to_owned() };
        write!(text, "    {run} expect TRUE").unwrap();
        for (id, variable) in program.variables.iter().filter(|(_, v)| is_shown(v)) {
            let (name, value) = (quoted(program, id, variable), evaluator.value(id));
            match variable.ty {
                Type::Bool if value == 1 => write!(text, " {name}").unwrap(),
                Type::Bool => write!(text, " !{name}").unwrap(),
                ty => write!(text, " {{ {name} = {} }}", literal(ty, value, tick_ms)).unwrap(),
            }
        }
        text.push('\n');
    }
    text
}
