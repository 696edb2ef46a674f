//! `hotrail explain`

use hotrail::diagnostic::{Code, code};

use super::report::out;
use super::{Verdict, lints};

/// Tell what an error or warning means, with an example that has it and one that does not
#[derive(clap::Args)]
#[command(after_help = "Examples:\n  hotrail explain E0101\n  hotrail explain double-coil")]
pub struct Options {
    /// A code or its name, such as W0301 or double-coil; without it all codes are listed
    #[arg(value_name = "CODE", value_parser = lints::any_code)]
    code: Option<Code>,
}

pub fn run(options: &Options) -> anyhow::Result<Verdict> {
    let text = match options.code {
        Some(code) => code.page().to_owned(),
        None => list(),
    };
    out(&text);
    Ok(Verdict::Good)
}

/// Every code with its name and title.
fn list() -> String {
    let width = code::ALL.iter().map(|code| code.name().len()).max().unwrap_or(0);
    let line = |code: &Code| format!("{}  {:width$}  {}\n", code.id, code.name(), code.title);
    code::ALL.iter().map(line).collect()
}
