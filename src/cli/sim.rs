//! `hotrail sim`

use std::io::IsTerminal;
use std::path::PathBuf;

use anyhow::{Context, bail};
use clap::ValueEnum;
use indicatif::{ProgressBar, ProgressStyle};

use hotrail::backend::Vcd;
use hotrail::draw::{Drawing, Timing};
use hotrail::eval::{Evaluator, Machine, Stimulus};
use hotrail::files::NewFile;
use hotrail::lint;
use hotrail::model::{Program, Role, VariableId};

use super::order::Order;
use super::pictures;
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
    format: Format,
    /// Write a value change dump too, for GTKWave or Surfer, with every variable or those watched;
    /// - writes it to standard output instead of the table
    #[arg(long, value_name = "FILE")]
    vcd: Option<PathBuf>,
    /// Draw the ladder with the power of a scan as an SVG picture too
    #[arg(long, value_name = "FILE")]
    svg: Option<PathBuf>,
    /// The scan of that picture, from 0; the last one if it is not said
    #[arg(long, value_name = "SCAN", requires = "svg")]
    at: Option<usize>,
    /// Draw a timing diagram of inputs and outputs, or of what is watched, as an SVG picture too
    #[arg(long, value_name = "FILE")]
    waves: Option<PathBuf>,
}

const EXAMPLES: &str = "\
A stimulus has a column for each input that it drives and, if not every scan has the tick, a column
tick. An empty cell keeps the value of the row before.

Examples:
  hotrail sim conveyor.ladder stimulus.csv
  hotrail sim conveyor.ladder - --watch motor,delay.ET --format jsonl < stimulus.csv
  hotrail sim conveyor.ladder stimulus.csv --scans 10000 --vcd conveyor.vcd
  hotrail sim conveyor.ladder stimulus.csv --svg power.svg --at 120
  hotrail sim conveyor.ladder stimulus.csv --waves waves.svg --watch start,motor,delay.ET";

#[derive(ValueEnum, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// Comma-separated values with a header
    Csv,
    /// One JSON object in a line for each scan
    Jsonl,
}

impl Options {
    /// The files that are read and must not be written.
    fn sources(&self) -> Vec<PathBuf> {
        [Some(&self.file), self.stimulus.as_ref()].into_iter().flatten().cloned().collect()
    }
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
    let Some((source, mut program)) = report.analyze(&options.file, &lints) else {
        return Ok(Verdict::Bad);
    };
    report.reorder(&options.file, &mut program, options.order);
    let Some(stimulus) = read_stimulus(&program, options.stimulus.as_ref(), report)? else {
        return Ok(Verdict::Bad);
    };
    let watched = watched(&program, &options.watch)?;
    let scans = options.scans.unwrap_or(stimulus.len());
    let mut sink = Sink::new(&program, watched.as_deref(), options)?;
    let last = scans.saturating_sub(1);
    let shown = options.svg.is_some().then_some(options.at.unwrap_or(last));
    if shown.is_some_and(|scan| scan >= scans) {
        bail!("the run has {scans} scans, from 0; --scans N runs more");
    }
    let progress = progress(scans);
    let mut machine = Evaluator::new(&program);
    for scan in 0..scans {
        let row = stimulus.row(scan);
        row.drives.iter().for_each(|&(input, value)| machine.drive(input, value));
        if shown == Some(scan) {
            let flow = machine.scan_seen(row.tick);
            sink.power = Some(pictures::power(&source, &flow, scan));
        } else {
            Machine::scan(&mut machine, row.tick);
        }
        sink.scan(row.tick, &machine);
        if sink.is_full() {
            sink.flush(report)?;
            progress.set_position(scan as u64);
        }
    }
    progress.finish_and_clear();
    sink.finish(report, options)?;
    Ok(Verdict::Good)
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

/// Where the scans go.
struct Sink {
    table: Option<Table>,
    dump: Option<(Vcd, Option<NewFile>)>,
    /// What of the dump is not written yet.
    piece: Vec<u8>,
    timing: Option<Timing>,
    /// The ladder in the scan that is shown.
    power: Option<Drawing>,
}

impl Sink {
    fn new(
        program: &Program,
        watched: Option<&[VariableId]>,
        options: &Options,
    ) -> anyhow::Result<Sink> {
        let ports = || {
            let inputs = program.with_role(Role::Input);
            inputs.chain(program.with_role(Role::Output)).map(|(id, _)| id).collect()
        };
        let all = || program.named_variables().map(|(id, _)| id).collect();
        let to_stdout = options.vcd.as_ref().is_some_and(|path| path.as_os_str() == "-");
        let columns = watched.map_or_else(ports, <[VariableId]>::to_vec);
        let dump = match &options.vcd {
            None => None,
            Some(path) => {
                let sources = options.sources();
                let file = (!to_stdout).then(|| NewFile::create(path, &sources)).transpose()?;
                let shown: Vec<VariableId> = watched.map_or_else(all, <[VariableId]>::to_vec);
                Some((Vcd::new(program, &shown), file))
            }
        };
        let timing = options.waves.is_some().then(|| Timing::new(program, &columns));
        let table = (!to_stdout).then(|| Table::new(program, columns, options.format));
        Ok(Sink { table, dump, piece: Vec::new(), timing, power: None })
    }

    fn scan(&mut self, tick: bool, machine: &impl Machine) {
        if let Some(table) = &mut self.table {
            table.row(tick, |variable| machine.value(variable));
        }
        if let Some((dump, _)) = &mut self.dump {
            dump.scan(tick, |variable| machine.value(variable));
            self.piece.append(&mut dump.take());
        }
        if let Some(timing) = &mut self.timing {
            timing.scan(tick, |variable| machine.value(variable));
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

    fn finish(mut self, report: &Report, options: &Options) -> anyhow::Result<()> {
        self.flush(report)?;
        let power = options.svg.as_ref().zip(self.power.map(|power| power.svg()));
        let timing = options.waves.as_ref().zip(self.timing.map(|timing| timing.svg()));
        for (path, picture) in power.into_iter().chain(timing) {
            pictures::write(path, &picture, &options.sources())?;
        }
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
