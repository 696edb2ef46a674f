//! Tests.

use super::grammar::{Pair, Rule};
use super::items::next;
use super::{Lower, Parsed};
use crate::source::Span;
use crate::syntax::ast::{Item, LiteralKind, Statement, StatementKind, Test};

impl<'s> Lower<'s> {
    pub(super) fn test(&self, pair: Pair<'_>) -> Parsed<Item<'s>> {
        let mut parts = pair.into_inner();
        let title = self.title(&next(&mut parts));
        let statements = parts.map(|part| self.statement(part)).collect::<Parsed<Vec<_>>>()?;
        let last = statements.last().map_or(title.span, |statement| statement.span);
        Ok(Item::Test(Test { title, statements, span: self.word.to(last) }))
    }

    fn statement(&self, pair: Pair<'_>) -> Parsed<Statement<'s>> {
        let mut span = self.span(&pair);
        let rule = pair.as_rule();
        let mut parts = pair.into_inner();
        let kind = match rule {
            Rule::scan => {
                let count = parts.next().map(|count| self.count(&count, "a number of scans"));
                StatementKind::Scan(count.transpose()?)
            }
            Rule::wait => {
                let time = next(&mut parts);
                StatementKind::Wait(self.amount(&time, LiteralKind::Time, "a time")?)
            }
            Rule::pulse => StatementKind::Pulse(self.reference(next(&mut parts))?.0),
            Rule::repeat => {
                let count = self.count(&next(&mut parts), "a number of times")?;
                let body = parts.map(|part| self.statement(part)).collect::<Parsed<Vec<_>>>()?;
                StatementKind::Repeat(count, body)
            }
            Rule::reset => StatementKind::Reset,
            Rule::drive => {
                let (input, _) = self.reference(next(&mut parts))?;
                StatementKind::Drive(input, self.expression(next(&mut parts))?)
            }
            _ => {
                let word = Span { start: span.start, end: span.start + "expect".len() as u32 };
                let network = self.series(next(&mut parts))?;
                span = word.to(network.span);
                StatementKind::Expect(network)
            }
        };
        Ok(Statement { kind, span })
    }
}
