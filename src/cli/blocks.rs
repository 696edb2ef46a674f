//! `hotrail blocks`

use std::io::{self, ErrorKind, Write};

use clap::builder::PossibleValuesParser;

use hotrail::blocks::{self, reference};

use super::Verdict;

/// Tell what a function block does: its parameters, its outputs, its timing diagrams
#[derive(clap::Args)]
#[command(after_help = "Examples:\n  hotrail blocks\n  hotrail blocks TON")]
pub struct Options {
    /// A kind of block, such as TON; without it all kinds are listed
    #[arg(value_name = "NAME", value_parser = kinds(), ignore_case = true)]
    kind: Option<String>,
}

fn kinds() -> PossibleValuesParser {
    PossibleValuesParser::new(blocks::ALL.iter().map(|block| block.name))
}

pub fn run(options: &Options) -> anyhow::Result<Verdict> {
    let text = match &options.kind {
        Some(kind) => blocks::named(&kind.to_ascii_uppercase()).map(reference::section),
        None => Some(reference::list()),
    };
    let text = text.expect("only kinds of block are accepted");
    // A reader that has seen enough is no mistake.
    match io::stdout().write_all(text.as_bytes()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(error.into()),
        _ => Ok(Verdict::Good),
    }
}
