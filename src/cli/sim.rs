//! `hotrail sim`

use std::io::IsTerminal;
use std::path::PathBuf;

use anyhow::{Context, bail};
use clap::ValueEnum;
use indicatif::{ProgressBar, ProgressStyle};

use hotrail::backend::CircuitRunner;
use hotrail::eval::{Evaluator, Flow, Machine, Stimulus};
use hotrail::lint;
use hotrail::model::{Names, Program, VariableId};
use hotrail::source::Source;

use super::order::Order;
use super::pictures;
use super::report::Report;
use super::sink::{Shown, Sink};
use super::{Verdict, split_names};

/// Run a program on values for its inputs and print every scan
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Options {
    /// Ladder file; - is standard input
    file: PathBuf,
    /// Values for the inputs, one row a scan: CSV with a header of names, or JSON lines; - is
    /// standard input. Without it all inputs stay 0
    #[arg(required_unless_present = "scans")]
    stimulus: Option<PathBuf>,
    /// What runs the program. Both print the same
    #[arg(long, value_enum, default_value_t = Executor::Evaluator)]
    on: Executor,
    /// Run that many scans; behind the stimulus's last row its values are held
    #[arg(long, value_name = "N")]
    scans: Option<usize>,
    /// In which order the rungs act
    #[arg(long, value_enum, default_value_t = Order::Text)]
    order: Order,
    /// Show these variables and members instead of inputs and outputs
    #[arg(long, value_name = "NAMES")]
    watch: Vec<String>,
    /// How the scans are printed
    #[arg(long, value_enum, default_value_t = Format::Csv)]
    pub format: Format,
    /// Write a value change dump too, for GTKWave or Surfer, with every variable or those watched;
    /// - writes it to standard output instead of the table
    #[arg(long, value_name = "FILE")]
    pub vcd: Option<PathBuf>,
    /// Draw the ladder with the power of a scan as an SVG picture too
    #[arg(long, value_name = "FILE")]
    pub svg: Option<PathBuf>,
    /// The scan of that picture, from 0; the last one if it is not said
    #[arg(long, value_name = "SCAN", requires = "svg")]
    at: Option<usize>,
    /// Draw a timing diagram of inputs and outputs, or of what is watched, as an SVG picture too
    #[arg(long, value_name = "FILE")]
    pub waves: Option<PathBuf>,
}

const EXAMPLES: &str = "\
A stimulus has a column for each input that it drives and, if not every scan has the tick, a column
tick. An empty cell keeps the value of the row before.

Examples:
  hotrail sim conveyor.ladder stimulus.csv
  hotrail sim conveyor.ladder - --watch motor,delay.ET --format jsonl < stimulus.csv
  hotrail sim conveyor.ladder stimulus.csv --scans 10000 --vcd conveyor.vcd
  hotrail sim conveyor.ladder day.csv --on circuit > day.out
  hotrail sim conveyor.ladder stimulus.csv --svg power.svg --at 120
  hotrail sim conveyor.ladder stimulus.csv --waves waves.svg --watch start,motor,delay.ET";

#[derive(ValueEnum, Clone, Copy, PartialEq, Eq)]
enum Executor {
    /// The reference evaluator, which walks the rungs: the meaning of the program
    Evaluator,
    /// The circuit that the hardware is printed from, simulated: faster in long runs
    Circuit,
}

#[derive(ValueEnum, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// Comma-separated values with a header
    Csv,
    /// One JSON object in a line for each scan
    Jsonl,
}

impl Options {
    /// The files that are read and must not be written.
    pub fn sources(&self) -> Vec<PathBuf> {
        [Some(&self.file), self.stimulus.as_ref()].into_iter().flatten().cloned().collect()
    }
}

/// A run of fewer scans is over before anybody could read how far it is.
const LONG_RUN: usize = 200_000;

pub fn run(options: &Options, report: &mut Report) -> anyhow::Result<Verdict> {
    let lints = lint::Options { off: true, ..lint::Options::default() };
    if options.stimulus.as_ref() == Some(&options.file) && options.file.as_os_str() == "-" {
        bail!("standard input cannot be both the program and its stimulus");
    }
    let Some((source, mut program)) = report.analyze(&options.file, &lints) else {
        return Ok(Verdict::Bad);
    };
    report.reorder(&options.file, &mut program, options.order);
    let Some(stimulus) = read_stimulus(&program, options.stimulus.as_ref(), report)? else {
        return Ok(Verdict::Bad);
    };
    let watched = watched(&program, &options.watch)?;
    let scans = options.scans.unwrap_or(stimulus.len());
    let last = scans.saturating_sub(1);
    let drawn = options.svg.is_some().then_some(options.at.unwrap_or(last));
    if drawn.is_some_and(|scan| scan >= scans) {
        bail!("the run has {scans} scans, from 0; --scans N runs more");
    }
    let shown = Shown::new(&program, watched, options);
    let sink = Sink::new(&program, &shown, options)?;
    let run = Run { source: &source, stimulus: &stimulus, scans, drawn, options, report };
    match options.on {
        Executor::Evaluator => run.on(Evaluator::new(&program), sink, Evaluator::scan_seen)?,
        Executor::Circuit => {
            if drawn.is_some() {
                bail!("the evaluator alone knows the power in a rung: leave out --on circuit");
            }
            let not_seen = |_: &mut _, _| unreachable!("nothing is drawn");
            run.on(CircuitRunner::new(&program, &shown.all()), sink, not_seen)?;
        }
    }
    Ok(Verdict::Good)
}

/// What is to be run.
struct Run<'a> {
    source: &'a Source,
    stimulus: &'a Stimulus,
    scans: usize,
    /// The scan whose power is drawn.
    drawn: Option<usize>,
    options: &'a Options,
    report: &'a Report,
}

impl Run<'_> {
    /// Runs it on a machine; `seen` runs the scan that is drawn.
    fn on<M: Machine>(
        &self,
        mut machine: M,
        mut sink: Sink,
        seen: impl Fn(&mut M, bool) -> Flow,
    ) -> anyhow::Result<()> {
        let progress = progress(self.scans);
        for scan in 0..self.scans {
            let row = self.stimulus.row(scan);
            machine.drive_row(row);
            if self.drawn == Some(scan) {
                let flow = seen(&mut machine, row.tick);
                sink.draw(pictures::power(self.source, &flow, scan));
            } else {
                machine.scan(row.tick);
            }
            sink.scan(row.tick, &machine);
            if sink.is_full() {
                sink.flush(self.report)?;
                progress.set_position(scan as u64);
            }
        }
        progress.finish_and_clear();
        sink.finish(self.report, self.options)
    }
}

/// Reads a stimulus, or reports what is wrong with it. Without a file it has no rows.
pub fn read_stimulus(
    program: &Program,
    file: Option<&PathBuf>,
    report: &mut Report,
) -> anyhow::Result<Option<Stimulus>> {
    let Some(file) = file else { return Ok(Some(Stimulus::default())) };
    let source = report.read(file)?;
    match Stimulus::parse(program, &source) {
        Ok(stimulus) => Ok(Some(stimulus)),
        Err(findings) => {
            report.findings(&findings, &source);
            Ok(None)
        }
    }
}

/// The variables that the lists name, each once, if there is a list.
fn watched(program: &Program, lists: &[String]) -> anyhow::Result<Option<Vec<VariableId>>> {
    if lists.is_empty() {
        return Ok(None);
    }
    let (names, mut watched) = (Names::of(program), Vec::new());
    for name in lists.iter().flat_map(|list| split_names(list)) {
        let variable = variable(program, &names, &name)?;
        if !watched.contains(&variable) {
            watched.push(variable);
        }
    }
    Ok(Some(watched))
}

/// The variable or member of that name.
pub fn variable(program: &Program, names: &Names<'_>, name: &str) -> anyhow::Result<VariableId> {
    names.variable(name).with_context(|| {
        let known = program.named_variables().map(|(_, variable)| &*variable.name);
        let similar = hotrail::diagnostic::similar_name(name, known);
        let hint = similar.map(|name| format!("; did you mean `{name}`?")).unwrap_or_default();
        format!("the program has no variable or member `{name}`{hint}")
    })
}

/// A bar on long runs, on standard error if that is a terminal; the rows show it where they are
/// seen themselves.
fn progress(scans: usize) -> ProgressBar {
    if scans < LONG_RUN || std::io::stdout().is_terminal() {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template("{wide_bar} {human_pos} of {human_len} scans, {eta}");
    let style = style.expect("the template is well formed");
    ProgressBar::new(scans as u64).with_style(style)
}
