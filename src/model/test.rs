//! The tests of a program.

use super::{Place, Program, Series, VariableId};
use crate::source::Span;

impl Program {
    /// Keeps the tests that are wanted and numbers their expectations anew.
    pub fn retain_tests(&mut self, is_wanted: impl Fn(&Test) -> bool) {
        fn number(statements: &mut [Statement], next: &mut usize) {
            for statement in statements {
                match statement {
                    Statement::Expect(expect) => {
                        expect.index = *next;
                        *next += 1;
                    }
                    Statement::Repeat(_, statements) => number(statements, next),
                    Statement::Drive(..)
                    | Statement::Scan(_)
                    | Statement::Wait(_)
                    | Statement::Reset => {}
                }
            }
        }
        self.tests.retain(is_wanted);
        let mut next = 0;
        self.tests.iter_mut().for_each(|test| number(&mut test.statements, &mut next));
    }
}

/// One test.
#[derive(Debug)]
pub struct Test {
    /// Its title.
    pub title: String,
    /// Its statements.
    pub statements: Vec<Statement>,
    /// Its place.
    pub span: Span,
}

/// One statement of a test.
#[derive(Debug)]
pub enum Statement {
    /// Drives an input, an element or a bit of one until it is driven again. No index is to be
    /// worked out.
    Drive(Place, i64),
    /// Runs that many scans without a tick.
    Scan(u64),
    /// Runs that many scans with a tick each.
    Wait(u64),
    /// The statements, that many times.
    Repeat(u64, Vec<Statement>),
    /// Back to reset, inputs to 0.
    Reset,
    /// This network must conduct now; only contacts, constants, comparisons and lists.
    Expect(Expect),
}

/// An expectation.
#[derive(Debug)]
pub struct Expect {
    /// Must conduct. Elements stand one for one with `spans`.
    pub network: Series,
    /// Its number among all expectations of the program, from 0.
    pub index: usize,
    /// The place of the statement.
    pub span: Span,
    /// The places of the elements of the outermost series.
    pub spans: Vec<Span>,
    /// Variables that stand beside a number on another base than 10, and that base. Of an array it
    /// is the first element.
    pub bases: Vec<(VariableId, u32)>,
}
