//! Every registered block: its timing diagrams, and its plain step against its circuit.

use std::path::Path;

use fastrand::Rng;
use hotrail::blocks::wave::Wave;
use hotrail::blocks::{self, Block, PortRole, Step};
use hotrail::circuit::{Design, Simulator, Valid};
use hotrail::eval::{Outcome, run_test};
use hotrail::source::Source;
use hotrail::types::Type;

/// The block alone as a design.
fn design(block: &'static Block, starts: &[i64]) -> Valid<Design> {
    let mut design = Design::default();
    design.modules.alloc(blocks::module(block, starts));
    design.validate().expect("a block's module is valid")
}

/// A block's plain step and its circuit, side by side.
struct Pair {
    block: &'static Block,
    starts: Vec<i64>,
    values: Vec<i64>,
    circuit: Simulator,
}

impl Pair {
    fn new(block: &'static Block, starts: Vec<i64>) -> Self {
        let circuit = Simulator::new(&design(block, &starts));
        Pair { block, values: starts.clone(), starts, circuit }
    }

    fn give(&mut self, port: &str, value: i64) {
        self.values[self.block.port_named(port).unwrap()] = value;
    }

    /// One scan on both; returns what the circuit shows where it differs from the step.
    fn scan(&mut self, power: bool, tick: bool, clear: [bool; 2]) -> Vec<String> {
        let inputs: Vec<u64> = self
            .circuit
            .circuit()
            .inputs
            .iter()
            .map(|input| match &*input.name {
                blocks::TICK => u64::from(tick),
                blocks::POWER => u64::from(power),
                blocks::CLEAR_BEFORE => u64::from(clear[0]),
                blocks::CLEAR_AFTER => u64::from(clear[1]),
                name => {
                    let port = self.block.port_named(name).unwrap();
                    self.block.ports[port].ty.bits(self.values[port])
                }
            })
            .collect();
        self.circuit.settle(&inputs);
        if clear[0] {
            self.clear();
        }
        let block = self.block;
        (block.step)(&mut Step { block, power, tick, values: &mut self.values });
        let mut wrong = self.differences("");
        self.circuit.clock();
        if clear[1] {
            self.clear();
        }
        wrong.extend(self.differences("_last"));
        wrong
    }

    fn clear(&mut self) {
        for ((value, &start), port) in
            self.values.iter_mut().zip(&self.starts).zip(self.block.ports)
        {
            if matches!(port.role, PortRole::Output | PortRole::State) {
                *value = start;
            }
        }
    }

    fn differences(&self, suffix: &str) -> Vec<String> {
        let outputs = self.block.ports.iter().zip(&self.values);
        outputs
            .filter(|(port, _)| port.role == PortRole::Output)
            .filter_map(|(port, &value)| {
                let name = format!("{}{suffix}", port.name);
                let shown =
                    self.circuit.output(self.circuit.circuit().output_named(&name).unwrap());
                (shown != port.ty.bits(value)).then(|| format!("{name}: {value} but {shown}"))
            })
            .collect()
    }
}

/// Start values as a diagram says them; what it does not say follows from the presets.
fn starts_of(wave: &Wave, block: &'static Block) -> Vec<i64> {
    let said = |port: usize| wave.constants.iter().find(|(name, _)| name == block.ports[port].name);
    let mut starts = block.starts(|port| said(port).map_or(0, |&(_, value)| value));
    for (port, start) in starts.iter_mut().enumerate() {
        *start = said(port).map_or(*start, |&(_, value)| value);
    }
    starts
}

#[test]
fn timing_diagrams_hold_on_the_step_and_on_the_circuit() {
    for &block in blocks::ALL {
        assert!(!block.waves.is_empty(), "{} has no timing diagram", block.name);
        for text in block.waves {
            let wave = Wave::parse(block, text).unwrap_or_else(|e| panic!("{}: {e}", block.name));
            let mut pair = Pair::new(block, starts_of(&wave, block));
            for scan in 0..wave.power.len() {
                let is_parameter =
                    |name: &str| block.ports[block.port_named(name).unwrap()].role.is_parameter();
                for (name, row) in wave.rows.iter().filter(|row| is_parameter(&row.0)) {
                    pair.give(name, row[scan]);
                }
                let clear = [false, wave.clears[scan]];
                let wrong = pair.scan(wave.power[scan], wave.ticks[scan], clear);
                assert!(wrong.is_empty(), "{} scan {scan}: {wrong:?}", block.name);
                for (name, row) in wave.rows.iter().filter(|row| !is_parameter(&row.0)) {
                    let value = pair.values[block.port_named(name).unwrap()];
                    assert_eq!(value, row[scan], "{} scan {scan}: {name}\n{text}", block.name);
                }
            }
        }
    }
}

/// A number of a type, mostly a small one or one at the end of its range.
fn number(random: &mut Rng, ty: Type) -> i64 {
    let (low, high) = ty.range();
    let numbers = [-1, 0, 1, 2, 3, 5, high - 1, high, low, low + 1];
    ty.wrap(numbers[random.usize(..numbers.len())])
}

/// What the ports of a block start with: 0, what follows from presets, or any number.
fn random_starts(random: &mut Rng, block: &'static Block) -> Vec<i64> {
    let presets: Vec<i64> = block.ports.iter().map(|port| number(random, port.ty)).collect();
    let mut starts = block.starts(|port| presets[port]);
    for (port, start) in block.ports.iter().zip(&mut starts) {
        let is_count = port.role == PortRole::Output && port.ty.is_number();
        if is_count && random.u8(..3) == 0 {
            *start = number(random, port.ty);
        }
    }
    starts
}

#[test]
fn step_and_circuit_agree_on_random_inputs() {
    for &block in blocks::ALL {
        let mut random = Rng::with_seed(1);
        for round in 0..400 {
            let mut pair = Pair::new(block, random_starts(&mut random, block));
            for scan in 0..100 {
                for port in block.ports {
                    match port.role {
                        PortRole::Circuit => pair.give(port.name, (random.u8(..6) == 0).into()),
                        PortRole::Preset { .. } if random.u8(..8) == 0 => {
                            pair.give(port.name, number(&mut random, port.ty));
                        }
                        _ => {}
                    }
                }
                let clear = [random.u8(..16) == 0, random.u8(..16) == 0];
                let wrong = pair.scan(random.u8(..5) > 1, random.u8(..4) > 0, clear);
                assert!(wrong.is_empty(), "{} {round} {scan}: {wrong:?}", block.name);
            }
        }
    }
}

/// Each start value of a block that depends on a preset, as the presets of a call make it.
#[test]
fn starts_follow_from_presets() {
    let starts = |block: &Block, preset| {
        let starts = block.starts(|_| preset);
        starts[block.port_named("CV").unwrap()]
    };
    let down = blocks::named("CTD").unwrap();
    assert_eq!([starts(down, 7), starts(down, 0), starts(down, -7)], [7, 0, 0]);
    assert_eq!(starts(blocks::named("CTUD").unwrap(), 7), 0);
}

/// `INSTA_UPDATE=always` writes it anew, as it does with the snapshots.
#[test]
fn the_block_reference_is_up_to_date() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/blocks.md");
    let meant = blocks::reference::page();
    if std::env::var_os("INSTA_UPDATE").is_some_and(|value| value == "always") {
        std::fs::write(&path, &meant).unwrap();
    }
    let written = std::fs::read_to_string(&path).unwrap();
    assert!(written == meant, "write it anew: INSTA_UPDATE=always cargo test --test blocks");
}

#[test]
fn every_block_is_documented() {
    for &block in blocks::ALL {
        assert!(block.doc.contains("Source: "), "{} names no source", block.name);
        for port in block.ports {
            assert!(!port.doc.is_empty(), "{}.{} has no doc", block.name, port.name);
        }
        assert!(block.main.is_none() || block.main_port().is_some(), "{}", block.name);
        assert_eq!(blocks::named(block.name).map(|found| found.name), Some(block.name));
    }
}

/// The start of a count in calls of every kind; what is expected before the first scan is what the
/// contract says.
#[test]
fn a_down_counter_starts_at_its_preset() {
    let text = "ladder starts
        input a, back  input outside : INT
        output y1, y2, y3, y4, y5, y6, y7
        const THREE := 3
        var size : INT := 4  var below : INT := -4
        rung a constant:CTD(PV := THREE) (y1)
        rung a variable:CTD(PV := size) (y2)  rung a { size := 9 }
        rung a sum:CTD(PV := size + 10 + outside) (y3)
        rung a negative:CTD(PV := below) (y4)
        rung a left_out:CTD() (y5)  rung a { left_out.PV := 7 }
        rung a above:CTD(PV := constant.CV + 1) (y6)
        rung a itself:CTD(PV := itself.CV + 5) (y7)
        rung back (R variable)
        test \"starts\"
            expect { constant.CV = 3 } { variable.CV = 4 } { sum.CV = 14 } { negative.CV = 0 }
                { left_out.CV = 0 } { above.CV = 4 } { itself.CV = 5 }
                !constant.Q !negative.Q !left_out.Q
        test \"a reset coil goes back to the start, not to what the preset is now\"
            pulse a
            expect { variable.CV = 3 } { size = 9 }
            back := 1  scan
            expect { variable.CV = 4 } !variable.Q
            reset
            expect { variable.CV = 4 }";
    let source = Source::new("starts.ladder", text);
    let (program, _) = hotrail::analyze(&source);
    let program = program.expect("nothing is wrong with it");
    for test in &program.tests {
        assert_eq!(run_test(&program, test), Outcome::Passed, "{}", test.title);
    }
}
