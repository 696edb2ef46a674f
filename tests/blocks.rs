//! Every registered block: its timing diagrams, and its plain step against its circuit.

use std::path::Path;

use fastrand::Rng;
use hotrail::blocks::wave::Wave;
use hotrail::blocks::{self, Block, Choice, PortRole, Shape, Start, Step};
use hotrail::circuit::{Design, Simulator, Valid};
use hotrail::eval::{Outcome, run_test};
use hotrail::source::Source;
use hotrail::types::Type;

/// The block alone as a design.
fn design(shape: &Shape, starts: &[i64]) -> Valid<Design> {
    let mut design = Design::default();
    design.modules.alloc(blocks::module(shape, starts));
    design.validate().expect("a block's module is valid")
}

/// A block's plain step and its circuit, side by side.
struct Pair {
    shape: Shape,
    starts: Vec<i64>,
    values: Vec<i64>,
    circuit: Simulator,
}

impl Pair {
    fn new(shape: Shape, starts: Vec<i64>) -> Self {
        let circuit = Simulator::new(&design(&shape, &starts));
        Pair { shape, values: starts.clone(), starts, circuit }
    }

    fn give(&mut self, port: &str, value: i64) {
        self.values[self.shape.port_named(port).unwrap()] = value;
    }

    /// One scan on both; returns what the circuit shows where it differs from the step.
    fn scan(&mut self, power: bool, tick: bool, clear: [bool; 2]) -> Vec<String> {
        // What the program holds it puts back itself, and what the block holds the block.
        if clear[0] {
            self.clear();
        }
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
                    let name = name.strip_suffix("_before").unwrap_or(name);
                    let port = self.shape.port_named(name).unwrap();
                    self.shape.ports[port].ty.bits(self.values[port])
                }
            })
            .collect();
        self.circuit.settle(&inputs);
        let shape = &self.shape;
        (shape.block.step)(&mut Step { shape, power, tick, values: &mut self.values });
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
            self.values.iter_mut().zip(&self.starts).zip(&self.shape.ports)
        {
            if port.role.is_cleared() {
                *value = port.cleared.unwrap_or(start);
            }
        }
    }

    fn differences(&self, suffix: &str) -> Vec<String> {
        let outputs = self.shape.ports.iter().zip(&self.values);
        let is_shown = |role: PortRole| match suffix {
            "" => role.is_result(),
            _ => role == PortRole::Output,
        };
        outputs
            .filter(|(port, _)| is_shown(port.role))
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
fn starts_of(wave: &Wave, shape: &Shape) -> Vec<i64> {
    let said = |port: usize| {
        let said = wave.constants.iter().find(|(name, _)| name == shape.ports[port].name);
        said.map(|&(_, value)| value)
    };
    let mut starts = shape.starts(said);
    for (port, start) in starts.iter_mut().enumerate() {
        *start = said(port).unwrap_or(*start);
    }
    starts
}

#[test]
fn timing_diagrams_hold_on_the_step_and_on_the_circuit() {
    for block in every_block() {
        assert!(!block.waves.is_empty(), "{} has no timing diagram", block.name);
        for text in block.waves {
            let wave = Wave::parse(block, text).unwrap_or_else(|e| panic!("{}: {e}", block.name));
            let shape = Shape::new(block, wave.chosen.clone());
            let starts = starts_of(&wave, &shape);
            let mut pair = Pair::new(shape.clone(), starts);
            for scan in 0..wave.power.len() {
                let is_parameter = |name: &str| {
                    let role = shape.ports[shape.port_named(name).unwrap()].role;
                    role.is_input() || matches!(role, PortRole::Loaded { .. })
                };
                for (name, row) in wave.rows.iter().filter(|row| is_parameter(&row.0)) {
                    pair.give(name, row[scan]);
                }
                let clear = [false, wave.clears[scan]];
                let wrong = pair.scan(wave.power[scan], wave.ticks[scan], clear);
                assert!(wrong.is_empty(), "{} scan {scan}: {wrong:?}", block.name);
                for (name, row) in wave.rows.iter().filter(|row| !is_parameter(&row.0)) {
                    let value = pair.values[shape.port_named(name).unwrap()];
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
fn random_starts(random: &mut Rng, shape: &Shape) -> Vec<i64> {
    let presets: Vec<i64> = shape.ports.iter().map(|port| number(random, port.ty)).collect();
    let mut starts = shape.starts(|port| Some(presets[port]));
    for (port, start) in shape.ports.iter().zip(&mut starts) {
        let is_count = port.role == PortRole::Output && port.ty.is_number();
        if is_count && random.u8(..3) == 0 {
            *start = number(random, port.ty);
        }
    }
    starts
}

/// A block with any settings.
fn random_shape(random: &mut Rng, block: &'static Block) -> Shape {
    let chosen = block.settings.iter().map(|setting| match &setting.choice {
        Choice::Word(words) => vec![random.i64(0..words.len() as i64)],
        Choice::Time(..) => vec![[1, 2, 3, 10][random.usize(..4)]],
        Choice::Register { .. } => vec![0; 1 + random.usize(..4)],
        Choice::List { low, most, .. } => {
            (0..random.usize(..=*most)).map(|_| random.i64(*low..low + 6)).collect()
        }
    });
    Shape::new(block, chosen.collect())
}

/// Those that programs call and the compiler's own.
fn every_block() -> impl Iterator<Item = &'static Block> {
    blocks::ALL.iter().copied().chain([&blocks::DIVIDER])
}

#[test]
fn step_and_circuit_agree_on_random_inputs() {
    for block in every_block() {
        let mut random = Rng::with_seed(1);
        for round in 0..400 {
            let shape = random_shape(&mut random, block);
            let starts = random_starts(&mut random, &shape);
            let mut pair = Pair::new(shape.clone(), starts);
            for scan in 0..100 {
                for port in &shape.ports {
                    match port.role {
                        PortRole::Circuit if port.start == Start::Value(1) => {
                            pair.give(port.name, (random.u8(..6) > 0).into());
                        }
                        PortRole::Pulse(_) => pair.give(port.name, (random.u8(..3) > 0).into()),
                        PortRole::Circuit => pair.give(port.name, (random.u8(..6) == 0).into()),
                        role if role.range().is_some() && random.u8(..8) == 0 => {
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
    let starts = |block: &'static Block, preset| {
        let shape = Shape::plain(block);
        let starts = shape.starts(|_| Some(preset));
        starts[shape.port_named("CV").unwrap()]
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
        let shape = Shape::plain(block);
        assert!(block.main.is_none() || shape.main_port().is_some(), "{}", block.name);
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

/// What no diagram of a single call shows: calls that share an instance, and members that a program
/// assigns. Each expectation is worked out from the manuals by hand.
const OTHERS: &str = "ladder others
        tick 5ms
        input a, b, c, d
        output y
        var size : INT := 3
        rung a both:AB_CTU(PRE := 2, ACC := 32767)
        rung b both:AB_CTD()
        rung c (R both)
        rung a low:AB_CTD(PRE := 0, ACC := -32768)
        rung b low:AB_CTU()
        rung a slow:AB_RTO(PRE := size, BASE := 10ms)
        rung c { slow.ACC := 0 }
        rung d { slow.ACC := 1 }
        rung b { size := 9 }
        rung a off:AB_TOF(PRE := size + 1)
        rung a units:T_01(PV := 2)
        rung d ( !units.EN )
        rung d (S y)
        test \"the two calls of a counter share its count and its bits\"
            expect { both.ACC = 32767 } !both.DN !both.CU !both.CD
            scan
            expect both.DN !both.OV !both.UN
            a := 1  scan
            expect { both.ACC = -32768 } both.OV !both.UN !both.DN both.CU
            b := 1  scan
            expect { both.ACC = 32767 } !both.OV !both.UN both.DN both.CD
            c := 1  scan
            expect { both.ACC = 0 } !both.OV !both.DN !both.CU !both.CD
            c := 0  scan                // both are held and count once more: up, then down
            expect { both.ACC = 0 } both.CU both.CD !both.UN
        test \"and the other way round\"
            scan
            a := 1  scan
            expect { low.ACC = 32767 } low.UN !low.OV
            b := 1  scan
            expect { low.ACC = -32768 } !low.UN !low.OV
        test \"an assignment of 0 clears the fraction too\"
            a := 1  scan  wait 15ms
            expect { slow.ACC = 1 }
            c := 1  scan
            expect { slow.ACC = 0 }
            c := 0  wait 5ms
            expect { slow.ACC = 0 }
            wait 5ms
            expect { slow.ACC = 1 }
            c := 1  scan  c := 0
            wait 5ms
            c := 1  scan  c := 0        // 0 already, and half a unit
            wait 5ms
            expect { slow.ACC = 0 }
            wait 5ms
            expect { slow.ACC = 1 }
        test \"an assignment of another number does not\"
            a := 1  scan  wait 5ms
            d := 1  scan  d := 0
            expect { slow.ACC = 1 }
            wait 5ms
            expect { slow.ACC = 2 }
        test \"starts are taken at reset and stay when their variables change\"
            expect { slow.PRE = 3 } { off.PRE = 4 } { off.ACC = 4 } !off.DN
            b := 1  scan
            expect { size = 9 } { slow.PRE = 3 } { off.PRE = 4 } { off.ACC = 4 }
        test \"a pulse comes with every second tick, whatever the power does\"
            wait 5ms
            a := 1  scan
            wait 5ms
            expect { units.ACC = 1 }
            wait 5ms
            expect { units.ACC = 1 }
            wait 5ms
            expect { units.ACC = 2 } units.Q !units.QN
        test \"an enable circuit that the call leaves out can be a coil\"
            expect units.EN
            a := 1  scan  wait 10ms
            expect { units.ACC = 1 } units.EN
            d := 1  scan  scan
            expect !units.EN { units.ACC = 0 }";

#[test]
fn programs_of_other_makers_blocks() {
    let source = Source::new("others.ladder", OTHERS);
    let (program, findings) = hotrail::analyze(&source);
    let program = program.unwrap_or_else(|| panic!("{findings:?}"));
    for test in &program.tests {
        assert_eq!(run_test(&program, test), Outcome::Passed, "{}", test.title);
    }
}
