//! The command line: arguments in, files and findings out.

mod blocks;
mod build;
mod check;
mod completions;
mod draw;
mod dump;
mod equations;
mod explain;
mod fmt;
mod lints;
mod new;
mod order;
mod pictures;
mod report;
mod rom;
mod run;
mod schedule;
mod sim;
mod simulators;
mod sink;
mod table;
mod test;
mod why;

use std::io::IsTerminal;
use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Args, Parser, Subcommand, ValueEnum};

use hotrail::files::{self, FileError};

use report::Report;

/// Turns ladder logic into hardware.
///
/// A ladder is a text file: contacts in series and parallel, coils, timers, counters. hotrail
/// checks it, tests it, and writes Verilog or VHDL that runs the whole program in one clock.
#[derive(Parser)]
#[command(name = "hotrail", version, after_help = EXAMPLES)]
struct Cli {
    #[command(subcommand)]
    command: Command,
    #[command(flatten)]
    style: Style,
}

const EXAMPLES: &str = "Examples:
  hotrail new conveyor
  hotrail check conveyor.ladder
  hotrail test conveyor.ladder
  hotrail sim conveyor.ladder stimulus.csv --vcd conveyor.vcd
  hotrail run conveyor.ladder
  hotrail fmt conveyor.ladder
  hotrail draw conveyor.ladder
  hotrail build conveyor.ladder -o out --emit verilog,vhdl";

#[derive(Subcommand)]
enum Command {
    New(new::Options),
    Check(check::Options),
    Build(build::Options),
    Test(test::Options),
    Sim(sim::Options),
    Run(run::Options),
    Why(why::Options),
    Fmt(fmt::Options),
    Equations(equations::Options),
    Draw(draw::Options),
    Rom(rom::Options),
    Explain(explain::Options),
    Blocks(blocks::Options),
    Completions(completions::Options),
}

/// How findings look.
#[derive(Args, Clone, Copy)]
struct Style {
    /// When to use colour
    #[arg(long, value_enum, default_value_t = Color::Auto, global = true)]
    color: Color,
    /// How findings are written
    #[arg(long, value_enum, default_value_t = MessageFormat::Human, global = true)]
    message_format: MessageFormat,
    /// Largest file that is read, in MiB
    #[arg(long, value_name = "MIB", default_value_t = files::LARGEST_SOURCE >> 20, global = true,
        value_parser = clap::value_parser!(u64).range(1..=1024))]
    max_size: u64,
}

#[derive(ValueEnum, Clone, Copy, PartialEq, Eq)]
enum Color {
    /// On a terminal, unless NO_COLOR is set
    Auto,
    /// In any case
    Always,
    /// Not at all
    Never,
}

#[derive(ValueEnum, Clone, Copy, PartialEq, Eq)]
enum MessageFormat {
    /// With the lines of the source
    Human,
    /// One line each
    Short,
    /// One JSON object each
    Json,
    /// One SARIF document on standard output
    Sarif,
    /// One GitHub workflow command each, on standard output
    Github,
}

impl Style {
    fn use_color(self) -> bool {
        self.use_color_on(&std::io::stderr())
    }

    fn use_color_on(self, stream: &impl IsTerminal) -> bool {
        match self.color {
            Color::Always => true,
            Color::Never => false,
            Color::Auto => {
                let asked_not_to = std::env::var_os("NO_COLOR").is_some_and(|v| !v.is_empty());
                !asked_not_to && stream.is_terminal()
            }
        }
    }
}

/// The ladder files of a command.
#[derive(Args)]
struct Sources {
    /// Ladder files; - is standard input
    #[arg(required = true, value_name = "FILES")]
    files: Vec<PathBuf>,
}

/// The names of a list separated by commas, which may stand in back-ticks and hold commas then.
fn split_names(list: &str) -> Vec<String> {
    let mut quoted = false;
    let names = list.split(|c: char| {
        quoted ^= c == '`';
        c == ',' && !quoted
    });
    names.map(str::to_owned).collect()
}

/// What a command found out.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Verdict {
    /// All is well.
    Good,
    /// The input is at fault, or a check failed; it has been reported.
    Bad,
}

/// Runs the command that the arguments ask for. The exit code is 0 for success, 1 if the input is
/// at fault or a check failed, 2 for wrong use.
pub fn run() -> ExitCode {
    let cli = Cli::parse();
    let mut report = Report::new(cli.style);
    let result = match cli.command {
        Command::New(options) => new::run(&options),
        Command::Check(options) => check::run(&options, &mut report),
        Command::Build(options) => build::run(&options, &mut report),
        Command::Test(options) => test::run(&options, &mut report),
        Command::Sim(options) => sim::run(&options, &mut report),
        Command::Run(options) => run::run(&options, &mut report),
        Command::Why(options) => why::run(&options, &mut report),
        Command::Fmt(options) => fmt::run(&options, &mut report),
        Command::Equations(options) => equations::run(&options, &mut report),
        Command::Draw(options) => draw::run(&options, &mut report),
        Command::Rom(options) => rom::run(&options, &mut report),
        Command::Explain(options) => return exit_code(explain::run(&options)),
        Command::Blocks(options) => return exit_code(blocks::run(&options)),
        Command::Completions(options) => return exit_code(completions::run(&options)),
    };
    let result = result.or_else(|error| {
        let error = error.downcast::<FileError>()?;
        report.file_error(&error);
        Ok(Verdict::Bad)
    });
    report.finish();
    exit_code(result)
}

fn exit_code(result: anyhow::Result<Verdict>) -> ExitCode {
    match result {
        Ok(Verdict::Good) => ExitCode::SUCCESS,
        Ok(Verdict::Bad) => ExitCode::FAILURE,
        Err(error) => {
            let text = format!("{error:#}");
            let sign = if text.starts_with("error") { "" } else { "error: " };
            report::err(&format!("{sign}{text}\n"));
            ExitCode::FAILURE
        }
    }
}
