//! Statements of tests that drive nothing and run no scan.

use crate::diagnostic::{Diagnostic, code};
use crate::syntax::ast::{Amount, File, Item, LiteralKind, Statement, StatementKind};

pub(super) fn check(file: &File<'_>, found: &mut Vec<Diagnostic>) {
    for item in &file.items {
        if let Item::Test(test) = item {
            statements(&test.statements, found);
        }
    }
}

/// The parser bounds how deep repetitions nest.
fn statements(all: &[Statement<'_>], found: &mut Vec<Diagnostic>) {
    for statement in all {
        let label = match &statement.kind {
            StatementKind::Scan(Some(count)) if is_zero(*count) => "no scan",
            StatementKind::Wait(time) if is_zero(*time) => "no time",
            StatementKind::Repeat(count, _) if is_zero(*count) => "not even once",
            StatementKind::Repeat(_, inner) if inner.is_empty() => "nothing is repeated",
            StatementKind::Repeat(_, inner) => {
                statements(inner, found);
                continue;
            }
            _ => continue,
        };
        let diagnostic =
            Diagnostic::new(code::IDLE_STATEMENT, statement.span, "this statement does nothing")
                .label(label)
                .help("remove it, or say how much it has to do");
        found.push(diagnostic);
    }
}

/// True for a number or time without a digit other than 0: what stands before a `#` is its base.
fn is_zero(amount: Amount<'_>) -> bool {
    // What a constant stands for is nothing that the text shows.
    let Amount::Literal(literal) = amount else { return false };
    let digits = literal.text.rsplit('#').next().unwrap_or(literal.text);
    let is_digit = |digit: u8| match literal.kind {
        LiteralKind::Time => digit.is_ascii_digit(),
        _ => digit.is_ascii_hexdigit(),
    };
    digits.bytes().all(|digit| digit == b'0' || !is_digit(digit))
}
