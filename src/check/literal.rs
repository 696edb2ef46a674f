//! The numbers that literals say.

use crate::syntax::ast::{Literal, LiteralKind};

/// The number that an integer or `BOOL` literal says; `None` if it is beyond 64 bits.
pub(super) fn integer(literal: Literal<'_>) -> Option<i128> {
    match literal.kind {
        LiteralKind::Bool => return Some(i128::from(literal.text == "TRUE")),
        LiteralKind::Integer => {}
        LiteralKind::Time => return None,
    }
    let digits = literal.text.replace('_', "");
    let value = match digits.split_once('#') {
        Some((base, digits)) => u64::from_str_radix(digits, base.parse().ok()?),
        None => digits.parse(),
    };
    value.ok().map(i128::from)
}
