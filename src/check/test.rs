//! Tests: what they drive, how long they run, what they expect.

use super::names::not_a_constant;
use super::network::Site;
use super::reference::Resolved;
use super::{Checked, Checker};
use crate::diagnostic::{Diagnostic, code};
use crate::model::{Base, Expect, Place, Role, Statement, Test};
use crate::syntax::ast::{self, Amount, Reference, StatementKind};
use crate::types::Type;

/// Scans of the longest test: at a tick of 1 ms more than a day.
const MOST_SCANS: u64 = 100_000_000;

impl<'s> Checker<'s> {
    pub(super) fn test(&mut self, test: &ast::Test<'s>) {
        let statements = self.statements(&test.statements);
        let scans = total_scans(&statements);
        if scans > MOST_SCANS {
            let message = format!("a test may run {MOST_SCANS} scans at most");
            let diagnostic = Diagnostic::new(code::TEST_TOO_LONG, test.title.span, message)
                .label(format!("this one runs {scans}"))
                .help("shorten its times, or give the program a longer tick");
            self.report(diagnostic);
        }
        let title = test.title.text.to_owned();
        self.program.tests.push(Test { title, statements, span: test.span });
    }

    fn statements(&mut self, statements: &[ast::Statement<'s>]) -> Vec<Statement> {
        let mut checked = Vec::with_capacity(statements.len());
        for statement in statements {
            if let Ok(statements) = self.statement(statement) {
                checked.extend(statements);
            }
        }
        checked
    }

    fn statement(&mut self, statement: &ast::Statement<'s>) -> Checked<Vec<Statement>> {
        Ok(vec![match &statement.kind {
            StatementKind::Drive(reference, value) => {
                let input = self.input(reference);
                let ty = input.as_ref().ok().map(|input| input.ty(&self.program));
                let value = self.constant(value, ty);
                Statement::Drive(input?, value?.1)
            }
            StatementKind::Scan(None) => Statement::Scan(1),
            StatementKind::Scan(Some(count)) => Statement::Scan(self.count(*count)?),
            StatementKind::Wait(time) => Statement::Wait(self.ticks_of(*time)?),
            StatementKind::Pulse(reference) => return self.pulse(reference),
            StatementKind::Repeat(count, statements) => {
                let statements = self.statements(statements);
                Statement::Repeat(self.count(*count)?, statements)
            }
            StatementKind::Reset => Statement::Reset,
            StatementKind::Expect(network) => {
                let spans = network.elements.iter().map(|element| element.span).collect();
                if network.elements.is_empty() {
                    let message = "the expectation is empty";
                    let diagnostic = Diagnostic::new(code::EMPTY_BRANCH, network.span, message)
                        .label("nothing stands here")
                        .help(
                            "name the contacts that must conduct, for instance: expect motor !lamp",
                        );
                    return Err(self.report(diagnostic));
                }
                let bases = self.bases_in(network);
                let network = self.series(network, Site::Expectation);
                let index = self.expectations;
                self.expectations += 1;
                Statement::Expect(Expect { network, index, span: statement.span, spans, bases })
            }
        }])
    }

    fn pulse(&mut self, reference: &Reference<'s>) -> Checked<Vec<Statement>> {
        let Place { base: Base::Variable(input), bit } = self.input(reference)? else {
            unreachable!("an input that is driven has no index to work out")
        };
        let drive = |value| Statement::Drive(Place { base: Base::Variable(input), bit }, value);
        if Place::from(input).ty(&self.program) != Type::Bool && bit.is_none() {
            let name = self.source.slice(reference.span());
            let message = format!("a pulse drives a BOOL, `{name}` is none");
            let diagnostic = Diagnostic::new(code::TYPE_MISMATCH, reference.span(), message)
                .label("not a BOOL")
                .help("drive it with := and scan");
            return Err(self.report(diagnostic));
        }
        let scan = || Statement::Scan(1);
        Ok(vec![drive(1), scan(), drive(0), scan()])
    }

    /// What a test drives: an input, an element of one, a bit of either.
    fn input(&mut self, reference: &Reference<'s>) -> Checked<Place> {
        let place = match self.resolve(reference)? {
            Resolved::Place(place) => Some(place),
            Resolved::Array(array) => return Err(self.array_is_no_value(array, reference)),
            Resolved::Constant(_) | Resolved::Instance(_) => None,
        };
        if place.as_ref().is_some_and(|place| place.index().is_some()) {
            let span = reference.path.first().map_or(reference.name.span, |index| index.span());
            return Err(self.report(not_a_constant(span)));
        }
        if let Some(place) = place
            && self.program.variables[place.declared()].role == Role::Input
        {
            return Ok(place);
        }
        let message = format!("a test drives inputs, `{}` is none", reference.name.text);
        let diagnostic = Diagnostic::new(code::NOT_WRITABLE, reference.span(), message)
            .label("not an input")
            .help("drive the inputs that lead to it, and expect its value");
        Err(self.report(diagnostic))
    }

    fn count(&mut self, amount: Amount<'s>) -> Checked<u64> {
        let count = self.number_of(amount)?;
        u64::try_from(count).map_err(|_| {
            let (message, help) = match count < 0 {
                true => ("a test runs 0 scans or more".to_owned(), "use a positive number"),
                false => {
                    (format!("a test may run {MOST_SCANS} scans at most"), "use a smaller number")
                }
            };
            let diagnostic = Diagnostic::new(code::OUT_OF_RANGE, amount.span(), message)
                .label(if count < 0 { "less than that" } else { "more than that" })
                .help(help);
            self.report(diagnostic)
        })
    }
}

/// How many scans the statements run; the largest number where there are more.
fn total_scans(statements: &[Statement]) -> u64 {
    statements.iter().fold(0, |total: u64, statement| {
        total.saturating_add(match statement {
            Statement::Scan(scans) | Statement::Wait(scans) => *scans,
            Statement::Repeat(times, statements) => {
                // Each statement of a round costs something even if it holds no scan.
                let round = statements.iter().fold(1, |total: u64, statement| {
                    total.saturating_add(total_scans(std::slice::from_ref(statement)).max(1))
                });
                times.saturating_mul((round - 1).max(1))
            }
            Statement::Drive(..) | Statement::Reset | Statement::Expect(_) => 0,
        })
    })
}
