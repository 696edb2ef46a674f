//! Divisions that need a divider: hardware that is large and slow next to everything else.

use super::index::Index;
use super::walk::Division;
use crate::diagnostic::{Diagnostic, code};

pub(super) fn check(index: &Index, found: &mut Vec<Diagnostic>) {
    let mut last = None;
    for Division { divisor, ty, span } in &index.divisions {
        // One for each pair of braces is enough.
        if last.replace(span) == Some(span) {
            continue;
        }
        let by = match divisor {
            Some(divisor) => format!("by {divisor}"),
            None => "by a variable".to_owned(),
        };
        let message = format!("a division {by} needs a divider of {} bits", ty.width());
        found.push(
            Diagnostic::new(code::DIVIDER, *span, message)
                .label("worked out in one clock: it takes many cells and makes the clock slow")
                .help("divide by a power of two, which costs little, or compare instead"),
        );
    }
}
