//! Rungs that nobody can take in at a glance.

use super::index::Index;
use crate::diagnostic::{Diagnostic, code};
use crate::model::Rung;
use crate::source::Span;

/// Elements that still fit a screen when they are drawn.
const MOST_ELEMENTS: usize = 64;
/// Lists inside lists.
const MOST_NESTING: usize = 8;

pub(super) fn check(index: &Index, found: &mut Vec<Diagnostic>) {
    for (rung, size) in index.program.rungs.iter().zip(&index.sizes) {
        if size.elements > MOST_ELEMENTS {
            let message = format!("this rung has {} elements", size.elements);
            found.push(
                Diagnostic::new(code::LONG_RUNG, word(rung), message)
                    .label(format!("more than {MOST_ELEMENTS}"))
                    .help("split it: write a part to a variable and read that here"),
            );
        }
        if size.nesting > MOST_NESTING {
            let message = format!("lists are nested {} deep in this rung", size.nesting);
            found.push(
                Diagnostic::new(code::DEEP_RUNG, word(rung), message)
                    .label(format!("more than {MOST_NESTING}"))
                    .help("write the innermost lists to variables and read those here"),
            );
        }
    }
}

/// The word `rung`.
pub(super) fn word(rung: &Rung) -> Span {
    Span { end: rung.span.start + 4, ..rung.span }
}
