//! References and expressions.

use super::script::Style;
use super::{INDENT, Printer, Separator};
use crate::source::Span;
use crate::syntax::ast::{Accessor, BinaryOperator, Expr, ExprKind, Reference, UnaryOperator};

impl<'s> Printer<'s> {
    /// One token that is kept as it is written.
    pub(super) fn written(&mut self, span: Span) {
        self.comments_here();
        let text = self.reader.take_until(span.end as usize);
        self.script.text(text);
    }

    /// A name with its members, bits and indexes. Lines do not end inside.
    pub(super) fn reference(&mut self, reference: &Reference<'s>) {
        self.name(&reference.name);
        for accessor in &reference.path {
            match accessor {
                Accessor::Member(name) => {
                    self.token(".");
                    self.name(name);
                }
                Accessor::Bit(bit) => {
                    self.token(".");
                    self.literal(bit);
                }
                Accessor::Index(index, _) => {
                    self.token("[");
                    self.wrapped(index, Wrap::Never);
                    self.token("]");
                }
            }
        }
    }

    /// An expression. A line may end before an operator and after a comma.
    pub(super) fn expression(&mut self, value: &Expr<'s>) {
        self.wrapped(value, Wrap::Anywhere);
    }

    /// `[10, 200]`
    pub(super) fn constants(&mut self, values: &[Expr<'s>]) {
        self.token("[");
        self.list(values, Wrap::Anywhere);
        self.token("]");
    }

    fn list(&mut self, values: &[Expr<'s>], wrap: Wrap) {
        for (index, value) in values.iter().enumerate() {
            if index > 0 {
                self.comma();
                self.blank_or_line(wrap);
            }
            self.operand(value, wrap, None);
        }
    }

    fn wrapped(&mut self, value: &Expr<'s>, wrap: Wrap) {
        let groups = self.open_groups(value);
        match &value.kind {
            ExprKind::Literal(literal) => self.literal(literal),
            ExprKind::Reference(reference) => self.reference(reference),
            ExprKind::Unary(operator, operand) => {
                match operator {
                    UnaryOperator::Negate => self.token("-"),
                    UnaryOperator::Not => {
                        self.token("NOT");
                        self.script.blank();
                    }
                }
                self.operand(operand, wrap, None);
            }
            ExprKind::Binary(operator, left, right) => {
                self.operand(left, wrap, Some(operator.binding()));
                self.blank_or_line(wrap);
                self.token(symbol(*operator));
                self.script.blank();
                // Without brackets the right one is of the same row: a long chain is balanced.
                self.operand(right, wrap, Some(operator.binding()));
            }
            ExprKind::Function(name, values) => {
                self.name(name);
                self.token("(");
                self.list(values, wrap);
                self.token(")");
            }
        }
        self.close_groups(groups);
    }

    /// An operand stays on one line as long as it fits, but `a + b + c` is one row.
    fn operand(&mut self, operand: &Expr<'s>, wrap: Wrap, row: Option<u8>) {
        let in_row = match &operand.kind {
            ExprKind::Literal(_) | ExprKind::Reference(_) => true,
            ExprKind::Binary(operator, left, _) => {
                row == Some(operator.binding()) && left.span.start == operand.span.start
            }
            ExprKind::Unary(..) | ExprKind::Function(..) => false,
        };
        if in_row {
            return self.wrapped(operand, wrap);
        }
        self.script.open(Style::Fill, INDENT, INDENT);
        self.wrapped(operand, wrap);
        self.script.close();
    }

    fn blank_or_line(&mut self, wrap: Wrap) {
        match wrap {
            Wrap::Anywhere => self.separate(Separator::BLANK),
            Wrap::Never => self.script.blank(),
        }
    }

    /// Passes the brackets around an expression: the tree does not have them, but they tell how
    /// the author reads it. Of several pairs one is printed.
    fn open_groups(&mut self, value: &Expr<'s>) -> usize {
        let inside = match &value.kind {
            ExprKind::Binary(_, left, _) => left.span.start as usize,
            _ => usize::MAX,
        };
        let mut groups = 0;
        while self.reader.rest().starts_with('(') && self.reader.position() < inside {
            if groups == 0 {
                self.token("(");
            } else {
                self.drop_token("(");
            }
            groups += 1;
        }
        groups
    }

    fn close_groups(&mut self, groups: usize) {
        for group in 0..groups {
            if group == 0 {
                self.token(")");
            } else {
                self.drop_token(")");
            }
        }
    }

    /// Passes a token that is not printed. The comments before it go to the token after it.
    pub(super) fn drop_token(&mut self, token: &str) {
        let gap = self.reader.take_gap();
        self.reader.take(token);
        self.reader.join_gap(gap.clusters);
    }
}

/// Where a line may end in an expression.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Wrap {
    Anywhere,
    Never,
}

fn symbol(operator: BinaryOperator) -> &'static str {
    match operator {
        BinaryOperator::Add => "+",
        BinaryOperator::Subtract => "-",
        BinaryOperator::Multiply => "*",
        BinaryOperator::Divide => "/",
        BinaryOperator::Modulo => "MOD",
        BinaryOperator::Equal => "=",
        BinaryOperator::NotEqual => "<>",
        BinaryOperator::Less => "<",
        BinaryOperator::LessOrEqual => "<=",
        BinaryOperator::Greater => ">",
        BinaryOperator::GreaterOrEqual => ">=",
        BinaryOperator::And => "AND",
        BinaryOperator::Xor => "XOR",
        BinaryOperator::Or => "OR",
    }
}
