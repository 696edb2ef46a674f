//! What is allowed and yet hardly meant: warnings and notes on a program without errors.
//!
//! A rule is one function in a file of its own, one line in `RULES`, one line in the table of
//! codes and one page in `docs/errors`, whose two examples are its tests. It looks at the
//! program through the `Index` of reads and writes, or at the tree for how it is written.

mod allow;
mod at_rail;
mod coil_and_latch;
mod dead_end;
mod declared;
mod divider;
mod double_coil;
mod idle;
mod index;
mod latch;
mod long_chain;
mod no_rungs;
mod preset_zero;
mod read_above;
mod running_equality;
mod unreset;
mod unwieldy;
mod walk;
mod zero_divisor;

use crate::diagnostic::{Code, Diagnostic, Severity};
use crate::model::Program;
use crate::source::Source;
use crate::syntax::ast::File;
use index::Index;

/// Which warnings and notes are wanted.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Looks for none at all.
    pub off: bool,
    /// These are not reported.
    pub allow: Vec<Code>,
    /// These are errors.
    pub deny: Vec<Code>,
    /// All warnings are errors; notes stay what they are.
    pub deny_warnings: bool,
    /// Frequency of the board's clock in Hz, instead of the program's own.
    pub clock_hz: Option<u64>,
}

/// Tells what it finds.
type Rule = fn(&Index, &mut Vec<Diagnostic>);

const RULES: &[Rule] = &[
    declared::check,
    double_coil::check,
    coil_and_latch::check,
    latch::check,
    read_above::check,
    unwieldy::check,
    dead_end::check,
    long_chain::check,
    preset_zero::check,
    unreset::check,
    running_equality::check,
    divider::check,
    zero_divisor::check,
];

/// The warnings and notes on a program, in the order of their places. What the options deny is
/// an error.
pub fn check(
    source: &Source,
    file: &File<'_>,
    program: &Program,
    options: &Options,
) -> Vec<Diagnostic> {
    if options.off {
        return Vec::new();
    }
    let mut found = Vec::new();
    let index = Index::new(program, options.clock_hz.unwrap_or(program.clock_hz));
    // Without rungs nothing is used, which is one cause of much.
    if !no_rungs::check(file, &mut found) {
        RULES.iter().for_each(|rule| rule(&index, &mut found));
    }
    at_rail::check(source, file, &mut found);
    idle::check(file, &mut found);
    let allowed = allow::Allowed::new(source, file, &mut found);
    found.retain(|finding| !options.allow.contains(&finding.code) && !allowed.covers(finding));
    for finding in &mut found {
        let is_warning = finding.code.severity == Severity::Warning;
        if options.deny.contains(&finding.code) || (options.deny_warnings && is_warning) {
            finding.code.severity = Severity::Error;
        }
    }
    let key = |finding: &Diagnostic| (finding.primary.span, finding.code.id);
    found.sort_by(|a, b| key(a).cmp(&key(b)).then_with(|| a.message.cmp(&b.message)));
    found
}

/// `1 more place`, `3 more places`; nothing for none.
fn more_places(count: usize) -> Option<String> {
    match count {
        0 => None,
        1 => Some("1 more place".to_owned()),
        _ => Some(format!("{count} more places")),
    }
}
