//! `hotrail check`

use super::lints::Lints;
use super::report::Report;
use super::{Sources, Verdict};

/// Find what is wrong with ladder files
#[derive(clap::Args)]
#[command(after_help = "Examples:
  hotrail check conveyor.ladder
  hotrail check *.ladder --deny warnings --allow read-above
  hotrail check *.ladder --message-format sarif > ladder.sarif")]
pub struct Options {
    #[command(flatten)]
    sources: Sources,
    #[command(flatten)]
    lints: Lints,
}

pub fn run(options: &Options, report: &mut Report) -> anyhow::Result<Verdict> {
    let lints = options.lints.options();
    let mut verdict = Verdict::Good;
    for path in &options.sources.files {
        if report.analyze(path, &lints).is_none() {
            verdict = Verdict::Bad;
        }
    }
    Ok(verdict)
}
