//! The statements of a test.

use super::{Amount, Expr, Reference, Series, Text};
use crate::source::Span;

/// `test "title" statements`
#[derive(Debug)]
pub struct Test<'s> {
    /// The title.
    pub title: Text<'s>,
    /// The statements in text order.
    pub statements: Vec<Statement<'s>>,
    /// From the word `test` to the end of the last statement.
    pub span: Span,
}

/// One statement of a test.
#[derive(Debug)]
pub struct Statement<'s> {
    /// What it does.
    pub kind: StatementKind<'s>,
    /// Its place.
    pub span: Span,
}

/// The kinds of statement.
#[derive(Debug)]
pub enum StatementKind<'s> {
    /// `start := 1`
    Drive(Reference<'s>, Expr<'s>),
    /// `scan`, `scan 10`
    Scan(Option<Amount<'s>>),
    /// `wait 500ms`
    Wait(Amount<'s>),
    /// `pulse start`
    Pulse(Reference<'s>),
    /// `repeat 4 { ... }`
    Repeat(Amount<'s>, Vec<Statement<'s>>),
    /// `reset`
    Reset,
    /// `expect a !b`
    Expect(Series<'s>),
}
