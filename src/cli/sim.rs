//! `hotrail sim`

use std::io::IsTerminal;
use std::path::PathBuf;

use anyhow::{Context, bail};
use clap::ValueEnum;
use indicatif::{ProgressBar, ProgressStyle};

use hotrail::backend::{CircuitRunner, Vcd};
use hotrail::eval::{Evaluator, Machine, Stimulus};
use hotrail::files::NewFile;
use hotrail::lint;
use hotrail::model::{Program, Role, VariableId};

use super::report::Report;
use super::table::Table;
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
    /// Show these variables and members instead of inputs and outputs
    #[arg(long, value_name = "NAMES")]
    watch: Vec<String>,
    /// How the scans are printed
    #[arg(long, value_enum, default_value_t = Format::Csv)]
    format: Format,
    /// Write a value change dump too, for GTKWave or Surfer, with every variable or those watched;
    /// - writes it to standard output instead of the table
    #[arg(long, value_name = "FILE")]
    vcd: Option<PathBuf>,
}

const EXAMPLES: &str = "\
A stimulus has a column for each input that it drives and, if not every scan has the tick, a column
tick. An empty cell keeps the value of the row before.

Examples:
  hotrail sim conveyor.ladder stimulus.csv
  hotrail sim conveyor.ladder - --watch motor,delay.ET --format jsonl < stimulus.csv
  hotrail sim conveyor.ladder stimulus.csv --scans 10000 --vcd conveyor.vcd
  hotrail sim conveyor.ladder day.csv --on circuit > day.out";

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

/// A run of fewer scans is over before anybody could read how far it is.
const LONG_RUN: usize = 200_000;

/// How much of a result is kept back before it is written, in bytes.
const PIECE: usize = 1 << 16;

pub fn run(options: &Options, report: &mut Report) -> anyhow::Result<Verdict> {
    let lints = lint::Options { off: true, ..lint::Options::default() };
    if options.stimulus.as_ref() == Some(&options.file) && options.file.as_os_str() == "-" {
        bail!("standard input cannot be both the program and its stimulus");
    }
    let Some((_, program)) = report.analyze(&options.file, &lints) else {
        return Ok(Verdict::Bad);
    };
    let Some(stimulus) = read_stimulus(&program, options.stimulus.as_ref(), report)? else {
        return Ok(Verdict::Bad);
    };
    let watched = watched(&program, &options.watch)?;
    let shown = Shown::new(&program, watched, options.vcd.is_some());
    let sink = Sink::new(&program, &shown, options)?;
    let scans = options.scans.unwrap_or(stimulus.len());
    let run = Run { stimulus: &stimulus, scans, report };
    match options.on {
        Executor::Evaluator => run.on(Evaluator::new(&program), sink)?,
        Executor::Circuit => run.on(CircuitRunner::new(&program, &shown.all()), sink)?,
    }
    Ok(Verdict::Good)
}

/// What is to be run.
struct Run<'a> {
    stimulus: &'a Stimulus,
    scans: usize,
    report: &'a Report,
}

impl Run<'_> {
    fn on(&self, mut machine: impl Machine, mut sink: Sink) -> anyhow::Result<()> {
        let progress = progress(self.scans);
        for scan in 0..self.scans {
            let row = self.stimulus.row(scan);
            row.drives.iter().for_each(|&(input, value)| machine.drive(input, value));
            machine.scan(row.tick);
            sink.scan(row.tick, &machine);
            if sink.is_full() {
                sink.flush(self.report)?;
                progress.set_position(scan as u64);
            }
        }
        progress.finish_and_clear();
        sink.finish(self.report)
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
    let mut watched = Vec::new();
    for name in lists.iter().flat_map(|list| split_names(list)) {
        let variable = variable(program, &name)?;
        if !watched.contains(&variable) {
            watched.push(variable);
        }
    }
    Ok(Some(watched))
}

/// The variable or member of that name.
pub fn variable(program: &Program, name: &str) -> anyhow::Result<VariableId> {
    program.variable_named(name).with_context(|| {
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

/// The variables that are to be seen.
struct Shown {
    /// Those of the table.
    columns: Vec<VariableId>,
    /// Those of the dump, if there is to be one.
    dumped: Vec<VariableId>,
}

impl Shown {
    fn new(program: &Program, watched: Option<Vec<VariableId>>, with_dump: bool) -> Shown {
        let ports = || {
            let inputs = program.with_role(Role::Input);
            inputs.chain(program.with_role(Role::Output)).map(|(id, _)| id).collect()
        };
        let named = || program.named_variables().map(|(id, _)| id).collect();
        let dumped = match (with_dump, &watched) {
            (false, _) => Vec::new(),
            (true, Some(watched)) => watched.clone(),
            (true, None) => named(),
        };
        Shown { columns: watched.unwrap_or_else(ports), dumped }
    }

    fn all(&self) -> Vec<VariableId> {
        [&self.columns[..], &self.dumped[..]].concat()
    }
}

/// Where the scans go.
struct Sink {
    table: Option<Table>,
    dump: Option<(Vcd, Option<NewFile>)>,
    /// What of the dump is not written yet.
    piece: Vec<u8>,
}

impl Sink {
    fn new(program: &Program, shown: &Shown, options: &Options) -> anyhow::Result<Sink> {
        let to_stdout = options.vcd.as_ref().is_some_and(|path| path.as_os_str() == "-");
        let dump = match &options.vcd {
            None => None,
            Some(path) => {
                let sources = [Some(options.file.clone()), options.stimulus.clone()];
                let sources: Vec<PathBuf> = sources.into_iter().flatten().collect();
                let file = (!to_stdout).then(|| NewFile::create(path, &sources)).transpose()?;
                Some((Vcd::new(program, &shown.dumped), file))
            }
        };
        let table =
            (!to_stdout).then(|| Table::new(program, shown.columns.clone(), options.format));
        Ok(Sink { table, dump, piece: Vec::new() })
    }

    fn scan(&mut self, tick: bool, machine: &impl Machine) {
        if let Some(table) = &mut self.table {
            table.row(tick, |variable| machine.value(variable));
        }
        if let Some((dump, _)) = &mut self.dump {
            dump.scan(tick, |variable| machine.value(variable));
            self.piece.append(&mut dump.take());
        }
    }

    fn is_full(&self) -> bool {
        self.piece.len() > PIECE || self.table.as_ref().is_some_and(|t| t.text.len() > PIECE)
    }

    fn flush(&mut self, report: &Report) -> anyhow::Result<()> {
        if let Some(table) = &mut self.table {
            report.result(&std::mem::take(&mut table.text));
        }
        if let Some((_, file)) = &mut self.dump {
            let piece = std::mem::take(&mut self.piece);
            match file {
                Some(file) => file.write(&piece)?,
                None => report.result(&String::from_utf8_lossy(&piece)),
            }
        }
        Ok(())
    }

    fn finish(mut self, report: &Report) -> anyhow::Result<()> {
        self.flush(report)?;
        if let Some((dump, file)) = self.dump {
            let rest = dump.finish();
            match file {
                Some(mut file) => {
                    file.write(&rest)?;
                    file.finish()?;
                }
                None => report.result(&String::from_utf8_lossy(&rest)),
            }
        }
        Ok(())
    }
}
