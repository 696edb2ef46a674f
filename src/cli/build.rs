//! `hotrail build`

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, bail};
use clap::ValueEnum;
use similar::TextDiff;

use hotrail::backend::hdl::ResetStyle;
use hotrail::backend::processor::{Form, Sizes};
use hotrail::backend::{self, Artifact, Emit, Unit};
use hotrail::diagnostic::code;
use hotrail::files;
use hotrail::quantity;

use super::lints::Lints;
use super::order::Order;
use super::report::Report;
use super::schedule::Schedule;
use super::{Sources, Verdict, split_names};

/// Compile ladder files to Verilog, VHDL and what goes with them
#[derive(clap::Args)]
#[command(after_help = "Examples:
  hotrail build conveyor.ladder -o out
  hotrail build conveyor.ladder -o out --emit verilog,wrapper --clock 50MHz --debounce 10ms
  hotrail build conveyor.ladder -o out --emit vhdl --schedule levels
  hotrail build conveyor.ladder -o golden --check")]
pub struct Options {
    #[command(flatten)]
    sources: Sources,
    /// Folder for the files
    #[arg(short, long, value_name = "DIR")]
    out: PathBuf,
    /// What to write; testbench and wrapper are written in each language that is named
    #[arg(long, value_enum, value_delimiter = ',', default_value = "verilog")]
    emit: Vec<EmitKind>,
    /// The reset of the hardware
    #[arg(long, value_enum, default_value_t = Reset::SyncHigh)]
    reset: Reset,
    /// Variables and members to show at ports of their own, such as total or delay.ET
    /// Back-ticks as in a ladder, for names that need them
    #[arg(long, value_name = "NAMES")]
    observe: Vec<String>,
    /// In which clocks of a scan the rungs act
    #[arg(long, value_enum, default_value_t = Schedule::Flat)]
    schedule: Schedule,
    /// In which order the rungs act
    #[arg(long, value_enum, default_value_t = Order::Text)]
    order: Order,
    /// Frequency of the board's clock, such as 50MHz, instead of the program's own
    #[arg(long, value_name = "FREQUENCY", value_parser = frequency)]
    clock: Option<u64>,
    /// How long an input must keep its value before the wrapper lets it pass, such as 10ms
    #[arg(long, value_name = "TIME", value_parser = time)]
    debounce: Option<u64>,
    /// Sizes of the ladder processor, where they are not those of the papers, such as
    /// CODE_WORDS=256,IMAGE_BITS=64,REGISTERS=64,STACK_DEPTH=3
    #[arg(long, value_name = "SIZES")]
    processor: Option<Sizes>,
    /// Write nothing; compare with the files in the folder and show what differs
    #[arg(long)]
    check: bool,
    /// Replace files that were not made by hotrail
    #[arg(long)]
    force: bool,
    #[command(flatten)]
    lints: Lints,
}

#[derive(ValueEnum, Clone, Copy, PartialEq, Eq)]
enum EmitKind {
    /// The program as a Verilog-2005 module
    Verilog,
    /// The program as a VHDL-93 entity
    Vhdl,
    /// The program's tests as a self-checking testbench
    Testbench,
    /// A top with synchronisers, reset and tick around the program
    Wrapper,
    /// The ladder as a picture
    Svg,
    /// The image of the ladder processor for $readmemh
    Rom,
    /// The same as Intel HEX
    Ihex,
    /// The same as Xilinx COE
    Coe,
    /// The same as Altera MIF
    Mif,
    /// The same as bare bytes
    Bin,
    /// The words of that image with their rungs and names
    Listing,
}

impl EmitKind {
    fn emit(self) -> Emit {
        match self {
            EmitKind::Verilog => Emit::Verilog,
            EmitKind::Vhdl => Emit::Vhdl,
            EmitKind::Testbench => Emit::Testbench,
            EmitKind::Wrapper => Emit::Wrapper,
            EmitKind::Svg => Emit::Svg,
            EmitKind::Rom => Emit::Rom(Form::Hex),
            EmitKind::Ihex => Emit::Rom(Form::IntelHex),
            EmitKind::Coe => Emit::Rom(Form::Coe),
            EmitKind::Mif => Emit::Rom(Form::Mif),
            EmitKind::Bin => Emit::Rom(Form::Binary),
            EmitKind::Listing => Emit::Listing,
        }
    }
}

#[derive(ValueEnum, Clone, Copy, PartialEq, Eq)]
enum Reset {
    /// Synchronous, active high: rst
    SyncHigh,
    /// Synchronous, active low: rst_n
    SyncLow,
    /// Asynchronous, active low: rst_n
    AsyncLow,
}

fn frequency(text: &str) -> Result<u64, String> {
    let hz = quantity::frequency_hz(text).and_then(|hz| u64::try_from(hz).ok());
    hz.filter(|hz| (1..=quantity::FASTEST_CLOCK_HZ).contains(hz))
        .ok_or_else(|| "a clock is a whole number of hertz up to 1 THz, such as 50MHz".to_owned())
}

fn time(text: &str) -> Result<u64, String> {
    let ns = quantity::time_ns(text).and_then(|ns| u64::try_from(ns).ok());
    ns.filter(|&ns| ns > 0).ok_or_else(|| "a time above 0 with its unit, such as 10ms".to_owned())
}

pub fn run(options: &Options, report: &mut Report) -> anyhow::Result<Verdict> {
    if options.out.as_os_str() == "-" {
        bail!("a build writes several files: name a folder for them");
    }
    let mut artifacts = Vec::new();
    let mut failed = false;
    for path in &options.sources.files {
        match compile(path, options, report)? {
            Some(made) => artifacts.push((path.clone(), made)),
            None => failed = true,
        }
    }
    for error in files::shared_names(&artifacts) {
        report.file_error(&error);
        failed = true;
    }
    if failed {
        return Ok(Verdict::Bad);
    }
    let artifacts: Vec<Artifact> = artifacts.into_iter().flat_map(|(_, made)| made).collect();
    if options.check {
        return compare(&options.out, &artifacts, report);
    }
    files::write_all(&options.out, &artifacts, &options.sources.files, options.force)?;
    Ok(Verdict::Good)
}

fn compile(
    path: &Path,
    options: &Options,
    report: &mut Report,
) -> anyhow::Result<Option<Vec<Artifact>>> {
    let mut lints = options.lints.options();
    lints.clock_hz = options.clock;
    if options.schedule != Schedule::Flat {
        // The chain is that of a scan in one clock.
        lints.allow.push(code::LONG_CHAIN);
    }
    if options.order == Order::Dataflow {
        // No order of the text is asked for.
        lints.allow.push(code::READ_ABOVE);
    }
    let Some((source, mut program)) = report.analyze(path, &lints) else {
        return Ok(None);
    };
    report.reorder(path, &mut program, options.order);
    let backend_options = backend::Options {
        reset: match options.reset {
            Reset::SyncHigh => ResetStyle::SyncHigh,
            Reset::SyncLow => ResetStyle::SyncLow,
            Reset::AsyncLow => ResetStyle::AsyncLow,
        },
        observe: options.observe.iter().flat_map(|names| split_names(names)).collect(),
        clock_hz: options.clock,
        debounce_ns: options.debounce,
        schedule: options.schedule.schedule(),
        processor: options.processor.unwrap_or_default(),
    };
    let unit = Unit::new(&program, &source, &backend_options)
        .with_context(|| path.display().to_string())?;
    let kinds: Vec<Emit> = options.emit.iter().map(|kind| kind.emit()).collect();
    if let Some(made) = unit.inexact_tick().filter(|_| kinds.contains(&Emit::Wrapper)) {
        report.remark(&format!("{}: the wrapper makes the tick {made}", path.display()));
    }
    match unit.emit(&kinds) {
        Ok(artifacts) => Ok(Some(artifacts)),
        Err(findings) => {
            report.findings(&findings, &source);
            Ok(None)
        }
    }
}

/// Shows what differs between the artifacts and the files in the folder.
fn compare(folder: &Path, artifacts: &[Artifact], report: &Report) -> anyhow::Result<Verdict> {
    let mut verdict = Verdict::Good;
    for artifact in artifacts {
        let path = folder.join(&artifact.file_name);
        let found = match fs::read(&path) {
            Ok(bytes) => bytes,
            Err(error) if error.kind() == std::io::ErrorKind::NotFound => Vec::new(),
            Err(error) => return Err(error).with_context(|| path.display().to_string()),
        };
        if found != artifact.contents {
            verdict = Verdict::Bad;
            let name = path.display().to_string();
            let (found, built) = (String::from_utf8_lossy(&found), artifact.text());
            let diff = TextDiff::from_lines(&*found, &*built);
            let diff = diff.unified_diff().header(&name, "as built now").to_string();
            report.result(&diff);
        }
    }
    Ok(verdict)
}
