//! The schedules of several clocks a scan give the evaluator's values, scan by scan, whatever
//! comes between the scans and in them.

mod common;

use std::path::Path;

use common::shrink::shrink;
use common::{amount, generate};
use fastrand::Rng;
use hotrail::backend::hdl;
use hotrail::circuit::Simulator;
use hotrail::diagnostic;
use hotrail::equations;
use hotrail::eval::Evaluator;
use hotrail::expand::{self, Schedule};
use hotrail::model::{Program, Role, Variable, VariableId};
use hotrail::source::Source;

const SCHEDULES: [Schedule; 2] = [Schedule::Levels, Schedule::Serial];

fn analyze(name: &str, text: &str) -> Result<Program, String> {
    let source = Source::new(name, text);
    let (program, diagnostics) = hotrail::analyze(&source);
    program.ok_or_else(|| {
        diagnostics.iter().map(|found| diagnostic::render(found, &source, false)).collect()
    })
}

/// A circuit that takes several clocks for a scan, and what it is told and has told.
struct Run<'p> {
    program: &'p Program,
    circuit: Simulator,
    clocks: u32,
    /// The names of the outputs but the last one, which tells the end of a scan.
    shown: Vec<VariableId>,
    /// What they showed after the last scan.
    held: Vec<u64>,
}

impl<'p> Run<'p> {
    fn new(program: &'p Program, schedule: Schedule, observe: Vec<VariableId>) -> Self {
        let options = expand::Options { observe, schedule, ..expand::Options::default() };
        let circuit = Simulator::new(&hotrail::compile(program, &options));
        let clocks = schedule.clocks(program, &equations::lower(program));
        let (done, shown) = circuit.circuit().outputs.split_last().expect("there is the last one");
        assert_eq!(&*done.name, expand::SCAN_DONE);
        assert_eq!(&*circuit.circuit().inputs[1].name, expand::SCAN_START);
        let variable = |name: &str| program.variable_named(name).expect("ports bear user's names");
        let shown: Vec<VariableId> = shown.iter().map(|output| variable(&output.name)).collect();
        let held = (0..shown.len()).map(|port| circuit.output(port)).collect();
        Run { program, circuit, clocks, shown, held }
    }

    /// One clock. Outputs must stay what they were, up to the clock edge too.
    fn clock(&mut self, inputs: &[u64], is_last: bool) -> Option<String> {
        self.circuit.settle(inputs);
        if self.circuit.output(self.shown.len()) != u64::from(is_last) {
            return Some(format!("{} is {}", expand::SCAN_DONE, !is_last));
        }
        let early = self.changed();
        self.circuit.clock();
        early.or_else(|| if is_last { None } else { self.changed() })
    }

    fn changed(&self) -> Option<String> {
        let port = (0..self.held.len()).find(|&port| self.circuit.output(port) != self.held[port]);
        let name = |port: usize| &self.program.variables[self.shown[port]].name;
        port.map(|port| format!("{} changes before the scan is over", name(port)))
    }

    /// Runs a scan with these inputs, and the idle clocks before it that there are; other clocks
    /// have other inputs.
    fn scan(&mut self, inputs: &[u64], clocks: &[Vec<u64>]) -> Option<String> {
        let (idle, busy) = clocks.split_at(clocks.len() + 1 - self.clocks as usize);
        let mut wrong = None;
        for clock in idle {
            let mut clock = clock.clone();
            clock[1] = 0;
            wrong = wrong.or_else(|| self.clock(&clock, false));
        }
        wrong = wrong.or_else(|| self.clock(inputs, busy.is_empty()));
        for (place, clock) in busy.iter().enumerate() {
            wrong = wrong.or_else(|| self.clock(clock, place + 1 == busy.len()));
        }
        self.held = (0..self.shown.len()).map(|port| self.circuit.output(port)).collect();
        wrong
    }

    fn differs(&self, evaluator: &Evaluator<'_>) -> Option<String> {
        self.shown.iter().zip(&self.held).find_map(|(&id, &shown)| {
            let Variable { name, ty, .. } = &self.program.variables[id];
            let meant = ty.bits(evaluator.value(id));
            (shown != meant).then(|| format!("{name} is {meant}, shown is {shown}"))
        })
    }
}

fn inner_variables(program: &Program) -> Vec<VariableId> {
    let is_inner = |variable: &Variable| {
        program.is_named(variable) && !matches!(variable.role, Role::Input | Role::Output)
    };
    program.variables.iter().filter(|(_, variable)| is_inner(variable)).map(|(id, _)| id).collect()
}

/// Runs a schedule and the evaluator on random inputs and ticks, with random gaps between scans.
fn difference(
    program: &Program,
    schedule: Schedule,
    scans: usize,
    mut random: Rng,
) -> Option<String> {
    let mut runs =
        [Vec::new(), inner_variables(program)].map(|observe| Run::new(program, schedule, observe));
    let mut evaluator = Evaluator::new(program);
    let inputs: Vec<VariableId> = program.with_role(Role::Input).map(|(id, _)| id).collect();
    let tick_one_in = random.u8(1..20);
    let most_idle = random.usize(0..4);
    let mut tick_waits = false;
    for scan in 0..scans {
        let row = |random: &mut Rng| -> Vec<u64> {
            let mut row = vec![u64::from(random.u8(..tick_one_in) == 0), random.u64(..2)];
            let widths = inputs.iter().map(|&input| program.variables[input].ty.width());
            row.extend(widths.map(|width| random.u64(..) >> (64 - width)));
            row
        };
        let others = runs[0].clocks as usize - 1;
        let idle = random.usize(..=most_idle);
        let clocks: Vec<Vec<u64>> = (0..idle + others).map(|_| row(&mut random)).collect();
        let mut start = row(&mut random);
        start[1] = 1;
        for (&input, bits) in inputs.iter().zip(&mut start[2..]) {
            let ty = program.variables[input].ty;
            if random.u8(..3) == 0 {
                let value = if random.bool() { random.i64(-3..4) } else { random.i64(..) };
                evaluator.drive(input, ty.wrap(value));
            }
            *bits = ty.bits(evaluator.value(input));
        }
        let ticks = |clocks: &[Vec<u64>]| clocks.iter().any(|clock| clock[0] == 1);
        let (before, within) = clocks.split_at(idle);
        evaluator.scan(tick_waits || ticks(before) || start[0] == 1);
        tick_waits = ticks(within);
        for run in &mut runs {
            let wrong = run.scan(&start, &clocks).or_else(|| run.differs(&evaluator));
            if let Some(wrong) = wrong {
                return Some(format!("{schedule:?}, scan {scan}: {wrong}"));
            }
        }
    }
    None
}

fn differences(program: &Program, scans: usize, seed: u64) -> Option<String> {
    let mut all = SCHEDULES.iter();
    all.find_map(|&schedule| difference(program, schedule, scans, Rng::with_seed(seed)))
}

#[test]
fn random_programs() {
    for seed in 0..amount("HOTRAIL_RANDOM_PROGRAMS", 1000) / 4 {
        let name = format!("random_{seed}");
        let text = generate::program(seed);
        let program = analyze(&name, &text).unwrap_or_else(|findings| panic!("{findings}"));
        let Some(wrong) = differences(&program, 100, seed) else { continue };
        let fails = |text: &str| {
            analyze(&name, text).is_ok_and(|program| differences(&program, 100, seed).is_some())
        };
        panic!("seed {seed}, {wrong}; the smallest such program:\n{}", shrink(&text, fails));
    }
}

#[test]
fn kept_programs() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/lockstep");
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.display().to_string();
        let text = std::fs::read_to_string(&path).unwrap();
        let program = analyze(&name, &text).unwrap_or_else(|findings| panic!("{findings}"));
        for seed in 0..5 {
            assert_eq!(differences(&program, 100, seed), None, "{name}, inputs {seed}");
        }
    }
}

#[test]
fn examples() {
    for example in common::examples() {
        let name = example.ladder.display().to_string();
        let text = std::fs::read_to_string(&example.ladder).unwrap();
        let program = analyze(&name, &text).unwrap_or_else(|findings| panic!("{findings}"));
        for seed in 0..5 {
            assert_eq!(differences(&program, 400, seed), None, "{name}, inputs {seed}");
        }
    }
}

/// What stands in a fenced block of the page behind a line.
fn block<'t>(page: &'t str, line: &str) -> &'t str {
    let (_, behind) = page.split_once(line).unwrap_or_else(|| panic!("no {line}"));
    let (_, block) = behind.split_once('\n').expect("a line has an end");
    block.split_once("\n```").expect("a block has an end").0
}

/// The timing diagram of the page is that of the program above it.
#[test]
fn the_page_is_true() {
    let page = std::fs::read_to_string("docs/schedules.md").unwrap();
    let program = analyze("belt.ladder", block(&page, "```ladder")).unwrap();
    let diagram = block(&page, "<!-- timing of belt, levels -->\n```text");
    let options = expand::Options { schedule: Schedule::Levels, ..expand::Options::default() };
    let mut circuit = Simulator::new(&hotrail::compile(&program, &options));
    let rows: Vec<(&str, Vec<u64>)> = diagram
        .lines()
        .map(|line| {
            let (name, levels) = line.split_once(' ').expect("a row has a name");
            (name, levels.trim().chars().map(|c| u64::from(c == '#')).collect())
        })
        .collect();
    let inputs: Vec<&[u64]> = circuit
        .circuit()
        .inputs
        .iter()
        .map(|input| &*rows.iter().find(|(name, _)| *name == &*input.name).unwrap().1)
        .collect();
    let outputs: Vec<String> =
        circuit.circuit().outputs.iter().map(|output| output.name.to_string()).collect();
    let mut shown = vec![String::new(); outputs.len()];
    for clock in 0..inputs[0].len() {
        let row: Vec<u64> = inputs.iter().map(|levels| levels[clock]).collect();
        circuit.settle(&row);
        for (port, shown) in shown.iter_mut().enumerate() {
            shown.push(if circuit.output(port) == 1 { '#' } else { '_' });
        }
        circuit.clock();
    }
    for (name, shown) in outputs.iter().zip(shown) {
        let line = format!("{name:<12}{shown}");
        assert!(diagram.contains(&line), "the page does not show\n{line}");
    }
    let design = hotrail::compile(&program, &options);
    let text = hdl::print(&design, hdl::Language::Verilog, &hdl::Options::default());
    let process = block(&page, "```verilog");
    assert!(text.contains(process), "no\n{process}\nin\n{text}");
}
