//! Tests. Where the lines end between statements is the author's choice: what is done in one step
//! stands on one line.

use super::script::Style;
use super::{INDENT, Printer, Separator};
use crate::source::Span;
use crate::syntax::ast::{Amount, Statement, StatementKind, Test};

/// Between statements on one line.
const BLANKS: usize = 2;

impl<'s> Printer<'s> {
    pub(super) fn test(&mut self, test: &Test<'s>) {
        self.script.open(Style::All, 0, INDENT);
        self.token("test");
        self.script.blank();
        self.written(test.title.span);
        if let Some((first, rest)) = test.statements.split_first() {
            self.separate(Separator::Break { offset: INDENT });
            self.script.open(Style::Fill, INDENT, INDENT);
            self.statement(first);
            self.statements(rest);
            self.script.close();
        }
        self.script.close();
    }

    /// Statements after another one.
    fn statements(&mut self, statements: &[Statement<'s>]) {
        for statement in statements {
            let breaks = self.reader.gap().has_newline();
            self.separate(if breaks {
                Separator::Paragraph
            } else {
                Separator::Line { blanks: BLANKS, offset: 0 }
            });
            self.statement(statement);
        }
    }

    fn statement(&mut self, statement: &Statement<'s>) {
        if let StatementKind::Repeat(count, body) = &statement.kind {
            return self.repeat(count, body, statement.span);
        }
        self.script.open(Style::Fill, INDENT, INDENT);
        match &statement.kind {
            StatementKind::Drive(input, value) => {
                self.reference(input);
                self.script.blank();
                self.token(":=");
                self.script.blank();
                self.expression(value);
            }
            StatementKind::Scan(None) => self.token("scan"),
            StatementKind::Scan(Some(count)) => self.with_amount("scan", count),
            StatementKind::Wait(time) => self.with_amount("wait", time),
            StatementKind::Pulse(input) => {
                self.token("pulse");
                self.script.blank();
                self.reference(input);
            }
            StatementKind::Reset => self.token("reset"),
            StatementKind::Expect(network) => {
                self.token("expect");
                self.series(network, Separator::BLANK);
            }
            StatementKind::Repeat(..) => {}
        }
        self.script.close();
    }

    fn with_amount(&mut self, word: &str, amount: &Amount<'s>) {
        self.token(word);
        self.script.blank();
        self.amount(amount);
    }

    /// On one line if the author has it so and it fits.
    fn repeat(&mut self, count: &Amount<'s>, body: &[Statement<'s>], whole: Span) {
        self.script.open(Style::All, 0, INDENT);
        self.token("repeat");
        self.script.blank();
        self.amount(count);
        self.script.blank();
        let start = self.reader.position();
        self.token("{");
        let on_lines = self.reader.has_newline(start, whole.end as usize);
        let (first_line, last_line) = if on_lines {
            (Separator::Break { offset: INDENT }, Separator::Break { offset: 0 })
        } else {
            let line = |offset| Separator::Line { blanks: 1, offset };
            (line(INDENT), line(0))
        };
        if let Some((first, rest)) = body.split_first() {
            self.separate(first_line);
            self.script.open(Style::Fill, INDENT, INDENT);
            self.statement(first);
            self.statements(rest);
            self.comments_before_end(0);
            self.script.close();
            self.separate(last_line);
        } else {
            self.script.blank();
        }
        self.token("}");
        self.script.close();
    }
}
