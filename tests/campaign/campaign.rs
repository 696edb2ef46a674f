//! Random programs in any number, on all cores, on as many machines as there are.
//!
//! `tests/campaign/run` starts it; docs/trust.md tells how.

#[path = "../common/mod.rs"]
mod common;
mod log;
mod report;
mod work;

use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Parser, Subcommand};
use common::checks::{ALL, Check};

#[derive(Parser)]
#[command(name = "tests/campaign/run", about, after_help = HELP)]
struct Options {
    #[command(subcommand)]
    command: Command,
}

const HELP: &str = "Examples:
  tests/campaign/run check --programs 1000000 --log out/core.jsonl
  tests/campaign/run check --checks icarus,ghdl --programs 5000 --log out/simulators.jsonl
  tests/campaign/run check --programs 1000000 --shard 3/8 --log out/part_3.jsonl
  tests/campaign/run report out/part_*.jsonl

A run that was stopped goes on where it was, if it is started again with the same log.";

#[derive(Subcommand)]
enum Command {
    /// Check random programs; a line of the log tells what came of each batch
    Check(CheckOptions),
    /// Add up logs, also those of other machines, as a Markdown table
    Report {
        /// The logs
        #[arg(required = true)]
        logs: Vec<PathBuf>,
    },
}

#[derive(clap::Args)]
struct CheckOptions {
    /// How many programs each check takes, all shards together
    #[arg(long, value_name = "N")]
    programs: u64,
    /// What to check
    #[arg(long, value_delimiter = ',', default_value = "circuit,schedules,processor,metamorphic",
          value_parser = named)]
    checks: Vec<&'static Check>,
    /// The K-th of N parts of the work
    #[arg(long, value_name = "K/N", default_value = "1/1")]
    shard: Shard,
    /// Programs checked at the same time [default: one for each core]
    #[arg(long, value_name = "N")]
    jobs: Option<usize>,
    /// Where the results go, as JSON lines
    #[arg(long, value_name = "FILE")]
    log: PathBuf,
}

/// A part of the work that a machine does.
#[derive(Clone, Copy)]
struct Shard {
    /// Which, from 0.
    index: u64,
    /// Of how many.
    of: u64,
}

impl std::str::FromStr for Shard {
    type Err = String;

    fn from_str(text: &str) -> Result<Shard, String> {
        let parts = text.split_once('/');
        let parts = parts.and_then(|(k, n)| Some((k.parse::<u64>().ok()?, n.parse().ok()?)));
        match parts {
            Some((k, n)) if 1 <= k && k <= n => Ok(Shard { index: k - 1, of: n }),
            _ => Err("write K/N, such as 3/8, with K from 1 to N".to_owned()),
        }
    }
}

fn named(name: &str) -> Result<&'static Check, String> {
    Check::named(name).ok_or_else(|| {
        let all: Vec<&str> = ALL.iter().map(|check| check.name).collect();
        format!("there are {}", all.join(", "))
    })
}

fn main() -> ExitCode {
    let result = match Options::parse().command {
        Command::Check(options) => work::check(&options),
        Command::Report { logs } => report::print(&logs),
    };
    match result {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::from(2)
        }
    }
}
