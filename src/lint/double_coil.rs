//! Two coils on one bit: the last one wins, in every scan.

use super::index::{Index, Written};
use super::walk::{Write, Writing};
use crate::diagnostic::{Diagnostic, code};

/// More places than these are not worth showing.
const MOST_SHOWN: usize = 3;

pub(super) fn check(index: &Index, found: &mut Vec<Diagnostic>) {
    for Written { variable, part, writes } in index.written() {
        let is_coil = |write: &&Write| write.how == Writing::Coil && write.part == part;
        let coils: Vec<&Write> = writes.iter().filter(is_coil).collect();
        let [overwritten @ .., last] = coils.as_slice() else { continue };
        if overwritten.is_empty() {
            continue;
        }
        let count = if coils.len() == 2 { "two".to_owned() } else { coils.len().to_string() };
        let message = format!("`{}` has {count} coils", index.part_name(variable, part));
        let mut finding = Diagnostic::new(code::DOUBLE_COIL, last.span, message)
            .label("the last one alone decides")
            .help("join their conditions in one rung, for instance: [ a | b ] ( y )");
        for write in overwritten.iter().take(MOST_SHOWN) {
            finding = finding.also(write.span, "overwritten further down");
        }
        found.push(finding);
    }
}
