//! The reference evaluator and the ladder processor's emulator, scan by scan on random inputs and
//! ticks.

use fastrand::Rng;
use hotrail::backend::processor::{self, Image, Machine};
use hotrail::diagnostic;
use hotrail::eval::Evaluator;
use hotrail::model::{Program, Role, VariableId};
use hotrail::source::Source;
use hotrail::types::Type;

use super::analyze;

/// The program of a text and its image, or what a user reads.
pub fn compile(text: &str) -> Result<(Program, Image), String> {
    let program = analyze("test.ladder", text)?;
    match processor::compile(&program) {
        Ok(image) => Ok((program, image)),
        Err(findings) => {
            let source = Source::new("test.ladder", text);
            Err(findings.iter().map(|found| diagnostic::render(found, &source, false)).collect())
        }
    }
}

/// Drives both with the same inputs and ticks and says what differs.
pub fn difference(
    program: &Program,
    image: &Image,
    scans: usize,
    mut random: Rng,
) -> Option<String> {
    let mut evaluator = Evaluator::new(program);
    let mut machine = Machine::new(&image.rom).expect("the compiler's image can be run");
    let inputs: Vec<VariableId> = program.with_role(Role::Input).map(|(id, _)| id).collect();
    let tick_one_in = random.u8(1..4);
    for scan in 0..scans {
        for &input in &inputs {
            if random.u8(..3) > 0 {
                continue;
            }
            if let Some(address) = image.layout.bit(input) {
                let value = random.bool();
                evaluator.drive(input, value.into());
                machine.drive(address, value);
            } else if let Some(register) = image.layout.register(input) {
                let value = [-1, 0, 1, 2, 3, 5, 20_000, 32_767][random.usize(..8)];
                evaluator.drive(input, value);
                machine.write_register(register, value as u16);
            }
        }
        let tick = random.u8(..tick_one_in) == 0;
        evaluator.scan(tick);
        machine.scan(tick);
        for (id, variable) in program.variables.iter() {
            let shown = match variable.ty {
                Type::Bool => image.layout.bit(id).map(|address| i64::from(machine.bit(address))),
                _ => {
                    let register = image.layout.register(id);
                    register.map(|register| variable.ty.wrap(machine.register(register).into()))
                }
            };
            let Some(shown) = shown else { continue };
            let meant = evaluator.value(id);
            if shown != meant {
                return Some(format!("scan {scan}: {} is {meant}, here {shown}", variable.name));
            }
        }
    }
    None
}
