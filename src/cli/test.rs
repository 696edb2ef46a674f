//! `hotrail test`

use std::collections::HashSet;
use std::path::{Path, PathBuf};

use anyhow::bail;
use clap::ValueEnum;

use hotrail::backend::CircuitRunner;
use hotrail::backend::hdl::Harmless;
use hotrail::backend::processor::{self, Runner};
use hotrail::diagnostic::{Diagnostic, code};
use hotrail::eval::{self, Evaluator, Failure, Outcome};
use hotrail::lint;
use hotrail::model::Program;
use hotrail::source::Source;

use super::dump;
use super::report::Report;
use super::schedule::Schedule;
use super::simulators::{self, Simulator};
use super::{Sources, Verdict};

/// Run the tests of ladder files
#[derive(clap::Args)]
#[command(after_help = "Examples:
  hotrail test conveyor.ladder
  hotrail test conveyor.ladder --on evaluator,circuit,processor,icarus,ghdl --filter emergency
  hotrail test conveyor.ladder --vcd waves")]
pub struct Options {
    #[command(flatten)]
    sources: Sources,
    /// What runs the tests; simulators run the emitted HDL and must be installed
    #[arg(long, value_enum, value_delimiter = ',', default_value = "evaluator")]
    on: Vec<Executor>,
    /// In which clocks of a scan the rungs act in the emitted HDL
    #[arg(long, value_enum, default_value_t = Schedule::Flat)]
    schedule: Schedule,
    /// Run only tests whose title contains this text
    #[arg(long, value_name = "TEXT", default_value = "")]
    filter: String,
    /// Write a value change dump of each test on the evaluator into this folder, for GTKWave or
    /// Surfer
    #[arg(long, value_name = "DIR")]
    vcd: Option<PathBuf>,
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
    for path in &options.sources.files {
        let Some((source, mut program)) = report.analyze(path, &lints) else {
            verdict = Verdict::Bad;
            continue;
        };
        let before = program.tests.len();
        program.retain_tests(|test| test.title.contains(&options.filter));
        let filtered_out = before - program.tests.len();
        chosen += program.tests.len();
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
            let failed = show(executor, &program, &source, &outcomes, filtered_out, report);
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
        let name = dump::file_name(program, number, test);
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

/// Prints a line for each test, then the failures, then the sum; returns the number of failures.
fn show(
    executor: Executor,
    program: &Program,
    source: &Source,
    outcomes: &[Outcome],
    filtered_out: usize,
    report: &mut Report,
) -> usize {
    let count = outcomes.len();
    let plural = if count == 1 { "" } else { "s" };
    let (name, executor) = (source.name(), executor.name());
    report.result(&format!("running {count} test{plural} of {name} on {executor}\n"));
    for (test, outcome) in program.tests.iter().zip(outcomes) {
        let word = if *outcome == Outcome::Passed { "ok" } else { "FAILED" };
        report.result(&format!("test {} ... {word}\n", Harmless::unicode(&test.title)));
    }
    let mut failed = 0;
    for (test, outcome) in program.tests.iter().zip(outcomes) {
        if let Outcome::Failed(Failure { span, text }) = outcome {
            failed += 1;
            let message =
                format!("the test \"{}\" failed on {executor}", Harmless::unicode(&test.title));
            let found = Diagnostic::new(code::EXPECTATION, *span, message)
                .label(format!("does not conduct: {text}"));
            report.findings(&[found], source);
        }
    }
    let verdict = if failed == 0 { "ok" } else { "FAILED" };
    let passed = count - failed;
    report.result(&format!(
        "test result: {verdict}. {passed} passed; {failed} failed; {filtered_out} filtered out\n\n"
    ));
    failed
}
