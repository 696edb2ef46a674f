//! Divisions by the constant 0: what they give is settled, and hardly meant.

use super::index::Index;
use crate::diagnostic::{Diagnostic, code};
use crate::source::Span;

pub(super) fn check(index: &Index, found: &mut Vec<Diagnostic>) {
    // The checker looks at some expressions twice: as a number, and with the type that is wanted.
    let mut divisors: Vec<Span> = index.program.zero_divisors.clone();
    divisors.sort_unstable();
    divisors.dedup();
    found.extend(divisors.into_iter().map(|divisor| {
        let message = "a division or remainder by the constant 0 is always 0";
        Diagnostic::new(code::ZERO_DIVISOR, divisor, message)
            .label("is 0")
            .help("divide by another number, or write 0 where that is meant")
    }));
}
