//! `hotrail fmt`

use std::path::Path;

use similar::TextDiff;

use hotrail::files;
use hotrail::source::Source;
use hotrail::syntax;

use super::report::Report;
use super::{Sources, Verdict};

/// Bring ladder files into the one canonical layout
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Options {
    #[command(flatten)]
    sources: Sources,
    /// Write nothing; show what would change, and fail if anything would
    #[arg(long)]
    check: bool,
}

const EXAMPLES: &str = "Files are rewritten in place; what comes from standard input goes to \
standard output.

Examples:
  hotrail fmt conveyor.ladder
  hotrail fmt --check *.ladder
  hotrail fmt - < conveyor.ladder";

pub fn run(options: &Options, report: &mut Report) -> anyhow::Result<Verdict> {
    let mut replaced = Vec::new();
    let mut shown = String::new();
    let mut verdict = Verdict::Good;
    for path in &options.sources.files {
        let Some(Layout { before, after }) = lay_out(path, report) else {
            verdict = Verdict::Bad;
            continue;
        };
        if options.check && before.text() != after {
            verdict = Verdict::Bad;
            let diff = TextDiff::from_lines(before.text(), &after);
            shown += &diff.unified_diff().header(before.name(), "formatted").to_string();
        } else if !options.check && is_stdin(path) {
            shown += &after;
        } else if before.text() != after {
            replaced.push((path.as_path(), after));
        }
    }
    if options.check || verdict == Verdict::Good {
        files::replace_all(&replaced)?;
        report.result(&shown);
    }
    Ok(verdict)
}

struct Layout {
    before: Source,
    after: String,
}

/// Reads and formats a file, or reports why that cannot be.
fn lay_out(path: &Path, report: &mut Report) -> Option<Layout> {
    let before = match report.read(path) {
        Ok(source) => source,
        Err(error) => {
            report.file_error(&error);
            return None;
        }
    };
    match syntax::format(&before) {
        Ok(after) => Some(Layout { before, after }),
        Err(diagnostics) => {
            report.findings(&diagnostics, &before);
            None
        }
    }
}

fn is_stdin(path: &Path) -> bool {
    path.as_os_str() == "-"
}
