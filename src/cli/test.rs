//! `hotrail test`

use std::collections::HashSet;
use std::path::{Path, PathBuf};

use anyhow::bail;
use clap::ValueEnum;

use hotrail::backend::CircuitRunner;
use hotrail::backend::hdl::Harmless;
use hotrail::backend::processor::{self, Runner};
use hotrail::diagnostic::{Diagnostic, code};
use hotrail::eval::{self, Evaluator, Failure, Moment, Outcome};
use hotrail::lint;
use hotrail::model::{Program, Role, Test, VariableId};
use hotrail::source::Source;

use super::dump;
use super::order::Order;
use super::pictures;
use super::report::Report;
use super::schedule::Schedule;
use super::simulators::{self, Simulator};
use super::{Sources, Verdict};

/// Run the tests of ladder files
#[derive(clap::Args)]
#[command(after_help = "A test that fails names the command that tells its cause.

Examples:
  hotrail test conveyor.ladder
  hotrail test conveyor.ladder --on evaluator,circuit,processor,icarus,ghdl --filter emergency
  hotrail test conveyor.ladder --on icarus,ghdl --schedule levels
  hotrail test conveyor.ladder --vcd waves
  hotrail test conveyor.ladder --filter emergency --svg pictures")]
pub struct Options {
    #[command(flatten)]
    sources: Sources,
    /// What runs the tests; simulators run the emitted HDL and must be installed
    #[arg(long, value_enum, value_delimiter = ',', default_value = "evaluator")]
    on: Vec<Executor>,
    /// In which clocks of a scan the rungs act in the emitted HDL
    #[arg(long, value_enum, default_value_t = Schedule::Flat)]
    schedule: Schedule,
    /// In which order the rungs act
    #[arg(long, value_enum, default_value_t = Order::Text)]
    order: Order,
    /// Run only tests whose title contains this text
    #[arg(long, value_name = "TEXT", default_value = "")]
    filter: String,
    /// Write a value change dump of each test on the evaluator into this folder, for GTKWave or
    /// Surfer
    #[arg(long, value_name = "DIR")]
    vcd: Option<PathBuf>,
    /// Draw each test into this folder, as two SVG pictures: the ladder with the power of its last
    /// scan, which is the one in which it fails, and a timing diagram of all that the test names
    #[arg(long, value_name = "DIR")]
    svg: Option<PathBuf>,
}

#[derive(ValueEnum, Clone, Copy, PartialEq, Eq)]
enum Executor {
    /// The built-in reference evaluator
    Evaluator,
    /// The built-in simulation of the circuit that the hardware is printed from
    Circuit,
    /// The emulator of the ladder processor, on its image
    Processor,
    /// Icarus Verilog, on the emitted Verilog
    Icarus,
    /// GHDL, on the emitted VHDL
    Ghdl,
}

impl Executor {
    fn name(self) -> &'static str {
        match self {
            Executor::Evaluator => "evaluator",
            Executor::Circuit => "circuit",
            Executor::Processor => "processor",
            Executor::Icarus => "icarus",
            Executor::Ghdl => "ghdl",
        }
    }
}

pub fn run(options: &Options, report: &mut Report) -> anyhow::Result<Verdict> {
    // Who runs tests asks whether they pass; `check` and `build` tell the rest.
    let lints = lint::Options { off: true, ..lint::Options::default() };
    let mut verdict = Verdict::Good;
    let mut chosen = 0;
    let mut dumped = HashSet::new();
    let mut drawn = HashSet::new();
    for path in &options.sources.files {
        let Some((source, mut program)) = report.analyze(path, &lints) else {
            verdict = Verdict::Bad;
            continue;
        };
        report.reorder(path, &mut program, options.order);
        let before = program.tests.len();
        program.retain_tests(|test| test.title.contains(&options.filter));
        let filtered_out = before - program.tests.len();
        chosen += program.tests.len();
        if let Some(folder) = &options.svg {
            pictures::of_tests(&program, &source, path, folder, &mut drawn)?;
        }
        for &executor in &options.on {
            let outcomes = match (executor, &options.vcd) {
                (Executor::Evaluator, Some(folder)) => dump(&program, path, folder, &mut dumped)?,
                (Executor::Processor, _) => match emulate(&program) {
                    Ok(outcomes) => outcomes,
                    Err(findings) => {
                        report.findings(&findings, &source);
                        verdict = Verdict::Bad;
                        continue;
                    }
                },
                _ => execute(executor, options.schedule, &program, &source)?,
            };
            let shown = Shown { executor, program: &program, source: &source, path };
            let failed = shown.show(&outcomes, filtered_out, report);
            if failed > 0 {
                verdict = Verdict::Bad;
            }
        }
    }
    if chosen == 0 && verdict == Verdict::Good && !options.filter.is_empty() {
        bail!("no test has a title with `{}` in it", options.filter);
    }
    Ok(verdict)
}

/// Runs the tests on the evaluator, each into a dump of its own.
fn dump(
    program: &Program,
    source: &Path,
    folder: &Path,
    dumped: &mut HashSet<String>,
) -> anyhow::Result<Vec<Outcome>> {
    let mut outcomes = Vec::new();
    for (number, test) in program.tests.iter().enumerate() {
        let name = dump::file_stem(program, number, test) + ".vcd";
        if !dumped.insert(name.to_lowercase()) {
            bail!("two programs would write {name}: give one of them another name");
        }
        let mut evaluator = Evaluator::new(program);
        let path = folder.join(name);
        outcomes.push(dump::run_test_dumped(&mut evaluator, program, test, &path, source)?);
    }
    Ok(outcomes)
}

/// Runs the tests on the ladder processor, with the members that they read in its image.
fn emulate(program: &Program) -> Result<Vec<Outcome>, Vec<Diagnostic>> {
    let image = processor::compile_observing(program, &eval::variables_of_tests(program))?;
    let mut runner = Runner::new(program, &image);
    let run = |test| eval::run_test_on(&mut runner, program, test);
    Ok(program.tests.iter().map(run).collect())
}

/// How each test of the program ended.
fn execute(
    executor: Executor,
    schedule: Schedule,
    program: &Program,
    source: &Source,
) -> anyhow::Result<Vec<Outcome>> {
    let simulator = match executor {
        Executor::Evaluator => {
            let run = |test| eval::run_test(program, test);
            return Ok(program.tests.iter().map(run).collect());
        }
        Executor::Circuit => {
            let mut machine = CircuitRunner::new(program, &eval::variables_of_tests(program));
            let run = |test| eval::run_test_on(&mut machine, program, test);
            return Ok(program.tests.iter().map(run).collect());
        }
        Executor::Processor => unreachable!("it needs no simulator"),
        Executor::Icarus => Simulator::Icarus,
        Executor::Ghdl => Simulator::Ghdl,
    };
    simulators::run_tests(simulator, schedule.schedule(), program, source)
}

/// How the tests of a program ended on something.
struct Shown<'s> {
    executor: Executor,
    program: &'s Program,
    source: &'s Source,
    path: &'s Path,
}

impl Shown<'_> {
    /// Prints a line for each test, then the failures, then the sum; returns the number of
    /// failures.
    fn show(&self, outcomes: &[Outcome], filtered_out: usize, report: &mut Report) -> usize {
        let count = outcomes.len();
        let plural = if count == 1 { "" } else { "s" };
        let (name, executor) = (self.source.name(), self.executor.name());
        report.result(&format!("running {count} test{plural} of {name} on {executor}\n"));
        for (test, outcome) in self.program.tests.iter().zip(outcomes) {
            let word = if *outcome == Outcome::Passed { "ok" } else { "FAILED" };
            report.result(&format!("test {} ... {word}\n", Harmless::unicode(&test.title)));
        }
        let mut failed = 0;
        for (test, outcome) in self.program.tests.iter().zip(outcomes) {
            if let Outcome::Failed(failure) = outcome {
                failed += 1;
                report.findings(&[self.finding(test, failure)], self.source);
            }
        }
        let verdict = if failed == 0 { "ok" } else { "FAILED" };
        let passed = count - failed;
        report.result(&format!(
            "test result: {verdict}. {passed} passed; {failed} failed; {filtered_out} filtered \
             out\n\n"
        ));
        failed
    }

    fn finding(&self, test: &Test, failure: &Failure) -> Diagnostic {
        let (title, executor) = (Harmless::unicode(&test.title), self.executor.name());
        let moment = failure.moment.as_ref().and_then(in_words).unwrap_or_default();
        let message = format!("the test \"{title}\" failed on {executor}{moment}");
        let found = Diagnostic::new(code::EXPECTATION, failure.span, message)
            .label(format!("does not conduct: {}", failure.text));
        match self.why(test, failure) {
            Some(command) => found.help(format!("the cause: {command}")),
            None => found,
        }
    }

    /// The command that tells why what the expectation looks at is what it is: its first variable
    /// that is no input. Where a title means several tests there is none, nor where another
    /// executor than the evaluator is at fault.
    fn why(&self, test: &Test, failure: &Failure) -> Option<String> {
        let is_input = |id: &&VariableId| self.program.variables[**id].role == Role::Input;
        let variable = failure.variables.iter().find(|id| !is_input(id))?;
        let is_sole = self.program.tests.iter().filter(|t| t.title == test.title).count() == 1;
        if !is_sole || self.executor != Executor::Evaluator || self.path.as_os_str() == "-" {
            return None;
        }
        let file = quoted(&self.path.display().to_string());
        let name = quoted(&self.program.variables[*variable].name);
        Some(format!("hotrail why {file} --test {} {name}", quoted(&test.title)))
    }
}

/// Which turn it was of the `repeat` in which an expectation stands.
fn in_words(moment: &Moment) -> Option<String> {
    let turns = moment.turns.iter().map(|(turn, turns)| format!(" in turn {turn} of {turns},"));
    let turns: String = turns.collect();
    let plural = if moment.scans == 1 { "" } else { "s" };
    (!turns.is_empty()).then(|| format!(",{turns} after {} scan{plural}", moment.scans))
}

/// A word of a command as a shell takes it.
fn quoted(word: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "_-./:+@%,=".contains(c);
    let shown = Harmless::unicode(word).to_string();
    match !shown.is_empty() && !shown.starts_with('-') && shown.chars().all(is_plain) {
        true => shown,
        false => format!("'{}'", shown.replace('\'', "'\\''")),
    }
}
