//! The circuit as a machine that runs stimuli: what the evaluator shows, it shows.

use std::fs;

use fastrand::Rng;
use hotrail::backend::CircuitRunner;
use hotrail::eval::{Evaluator, Machine};
use hotrail::model::{Program, Role, VariableId};
use hotrail::source::Source;

use crate::PROGRAM;
use crate::common::folder::Folder;
use crate::common::{self, generate};

/// The examples, and some random programs.
fn programs() -> Vec<(String, String)> {
    let text = |example: &common::Example| fs::read_to_string(&example.ladder).unwrap();
    let examples = common::examples();
    let examples = examples.iter().map(|example| (example.name(), text(example)));
    examples
        .chain((0..30).map(|seed| (format!("random {seed}"), generate::program(seed))))
        .collect()
}

/// A stimulus for every input of a program.
fn random_stimulus(program: &Program, random: &mut Rng) -> String {
    let inputs: Vec<_> = program.with_role(Role::Input).map(|(_, input)| input).collect();
    let names = inputs.iter().map(|input| format!(",\"`{}`\"", input.name));
    let mut text = format!("tick{}\n", names.collect::<String>());
    for _ in 0..60 {
        text += if random.u8(..4) == 0 { "0" } else { "1" };
        for input in &inputs {
            text.push(',');
            if random.bool() {
                let value = if random.bool() { random.i64(0..3) } else { random.i64(..) };
                text += &input.ty.wrap(value).to_string();
            }
        }
        text.push('\n');
    }
    text
}

#[test]
fn the_circuit_prints_what_the_evaluator_prints() {
    let folder = Folder::new();
    let mut random = Rng::with_seed(11);
    for (name, text) in programs() {
        let (program, _) = hotrail::analyze(&Source::new("p.ladder", text.as_str()));
        folder.write("p.ladder", &text);
        folder.write("s.csv", &random_stimulus(&program.expect("it is right"), &mut random));
        for format in [&["--format", "jsonl"][..], &["--vcd", "-"]] {
            let on = |executor| {
                let run = ["sim", "p.ladder", "s.csv", "--scans", "70", "--on", executor];
                let run = folder.run(&[&run, format].concat());
                assert_eq!((run.code, run.err.as_str()), (0, ""), "{name}");
                run.out
            };
            assert_eq!(on("circuit"), on("evaluator"), "{name}");
        }
    }
    folder.write("lift.ladder", PROGRAM);
    let power = ["sim", "lift.ladder", "--scans", "1", "--on", "circuit", "--svg", "p.svg"];
    let run = folder.run(&power);
    assert!(run.code == 1 && run.err.contains("leave out --on circuit"), "{}", run.err);
    let watch = ["sim", "lift.ladder", "--scans", "3", "--on", "circuit", "--watch"];
    let run = folder.run(&[&watch[..], &["delay.ET,up,delay.ET,delay.Q"]].concat());
    assert_eq!(run.out, "scan,tick,delay.ET,up,delay.Q\n0,1,0,0,0\n1,1,0,0,0\n2,1,0,0,0\n");
}

#[test]
fn the_circuit_holds_what_the_evaluator_holds_at_every_reset() {
    let mut random = Rng::with_seed(12);
    for (name, text) in programs() {
        let program = hotrail::analyze(&Source::new("p.ladder", text)).0.expect("it is right");
        let named: Vec<VariableId> = program.named_variables().map(|(id, _)| id).collect();
        let mut evaluator = Evaluator::new(&program);
        let mut circuit = CircuitRunner::new(&program, &named);
        for scan in 0..40 {
            if scan % 8 == 0 {
                Machine::reset(&mut evaluator);
                circuit.reset();
            } else {
                for (input, variable) in program.with_role(Role::Input) {
                    let value = variable.ty.wrap(random.i64(..));
                    evaluator.drive(input, value);
                    circuit.drive(input, value);
                }
                evaluator.scan(true);
                circuit.scan(true);
            }
            for &variable in &named {
                let (meant, shown) = (evaluator.value(variable), circuit.value(variable));
                let variable = &program.variables[variable].name;
                assert_eq!(shown, meant, "{name}: {variable} after {scan} steps");
            }
        }
    }
}
