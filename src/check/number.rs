//! Numbers and times: literals, and what is worked out of literals alone before a type is known.

use super::expression::is_operation;
use super::reference::Resolved;
use super::{Checked, Checker, literal};
use crate::diagnostic::{Diagnostic, code, shortened};
use crate::model::{Expr, ExprKind};
use crate::quantity;
use crate::source::Span;
use crate::syntax::ast::{self, BinaryOperator};
use crate::types::Type;

impl<'s> Checker<'s> {
    pub(super) fn number_for_a_time(&mut self, literal: ast::Literal<'s>) -> super::Reported {
        let number = shortened(literal.text);
        let help = match literal::integer(literal) {
            Some(0) => "write `0s`".to_owned(),
            _ if literal.text.contains('#') => "write a time with its unit, such as 500ms".into(),
            _ => format!("write a time with its unit, such as `{number}ms` or `{number}s`"),
        };
        let message = "TIME is needed here, this is a number";
        let diagnostic = Diagnostic::new(code::TYPE_MISMATCH, literal.span, message)
            .label("a number without a unit")
            .help(help);
        self.report(diagnostic)
    }

    /// The exact value of an expression of literals and untyped constants, which has to fit the
    /// type that it takes.
    pub(super) fn number_of_type(
        &mut self,
        expr: &ast::Expr<'s>,
        want: Option<Type>,
    ) -> Checked<Expr> {
        let ty = want.unwrap_or(Type::Dint);
        if ty == Type::Time {
            return Err(self.mismatch(expr.span, Type::Dint, Type::Time));
        }
        self.numbers_only(ty, expr.span)?;
        let value = self.number(expr)?;
        if ty.holds(value) {
            return Ok(Expr { ty, kind: ExprKind::Constant(value as i64) });
        }
        let (low, high) = ty.range();
        Err(self.does_not_fit(expr, value, &format!("{ty} holds {low} to {high}")))
    }

    /// The number that an untyped constant is a name for: one that some type can hold.
    pub(super) fn untyped_constant(&mut self, expr: &ast::Expr<'s>) -> Checked<i64> {
        let value = self.number(expr)?;
        let (low, high) = (i64::from(i32::MIN), i64::from(u32::MAX));
        if (i128::from(low)..=i128::from(high)).contains(&value) {
            return Ok(value as i64);
        }
        Err(self.does_not_fit(expr, value, &format!("numbers are {low} to {high}")))
    }

    pub(super) fn does_not_fit(
        &mut self,
        expr: &ast::Expr<'s>,
        value: i128,
        range: &str,
    ) -> super::Reported {
        let words: Vec<_> = self.source.slice(expr.span).split_whitespace().collect();
        let text = words.join(" ");
        let message = match is_operation(expr) {
            true => format!("`{}` is {value}, and {range}", shortened(&text)),
            false => range.to_owned(),
        };
        let diagnostic = Diagnostic::new(code::OUT_OF_RANGE, expr.span, message)
            .label("outside that range")
            .help("use a value in that range; only values known while the program runs wrap");
        self.report(diagnostic)
    }

    /// The number that an expression of literals and untyped constants stands for. Nothing wraps:
    /// no type is known yet.
    pub(super) fn number(&mut self, expr: &ast::Expr<'s>) -> Checked<i128> {
        let value = match &expr.kind {
            ast::ExprKind::Literal(literal) => literal::integer(*literal),
            ast::ExprKind::Reference(reference) => match self.resolve(reference)? {
                Resolved::Constant(constant) => Some(constant.value.into()),
                _ => None,
            },
            ast::ExprKind::Unary(_, operand) => self.number(operand)?.checked_neg(),
            ast::ExprKind::Binary(operator, a, b) => {
                let divisor = b.span;
                let (a, b) = (self.number(a), self.number(b));
                let (a, b) = (a?, b?);
                if matches!(operator, BinaryOperator::Divide | BinaryOperator::Modulo) && b == 0 {
                    self.program.zero_divisors.push(divisor);
                }
                match operator {
                    BinaryOperator::Add => a.checked_add(b),
                    BinaryOperator::Subtract => a.checked_sub(b),
                    BinaryOperator::Multiply => a.checked_mul(b),
                    BinaryOperator::Divide if b == 0 => Some(0),
                    BinaryOperator::Divide => a.checked_div(b),
                    BinaryOperator::Modulo if b == 0 => Some(0),
                    BinaryOperator::Modulo => a.checked_rem(b),
                    _ => unreachable!("the other operators do not make a number of two"),
                }
            }
            ast::ExprKind::Function(..) => None,
        };
        value.ok_or_else(|| {
            let diagnostic =
                Diagnostic::new(code::OUT_OF_RANGE, expr.span, "no type holds such a number")
                    .label("too large for every type")
                    .help("the largest number is 4294967295, that of UDINT and DWORD");
            self.report(diagnostic)
        })
    }

    /// The number of ticks that a time literal says.
    pub(super) fn ticks(&mut self, literal: ast::Literal<'s>) -> Checked<i64> {
        self.signed_ticks(literal, false)
    }

    /// The same with the sign before it: there is one negative number more than positive ones.
    pub(super) fn signed_ticks(
        &mut self,
        literal: ast::Literal<'s>,
        negative: bool,
    ) -> Checked<i64> {
        let ticks = self.exact_ticks(literal)?;
        let ticks = if negative { -ticks } else { ticks };
        if Type::Time.holds(ticks) {
            return Ok(ticks as i64);
        }
        Err(self.time_too_long(literal.span, None))
    }

    /// The number of ticks that a time literal says, also where no `TIME` holds so many.
    pub(super) fn exact_ticks(&mut self, literal: ast::Literal<'s>) -> Checked<i128> {
        let tick = i128::from(self.program.tick_ns);
        let Some(ns) = quantity::time_ns(literal.text) else {
            return Err(self.time_too_long(literal.span, None));
        };
        if ns % tick == 0 {
            return Ok(ns / tick);
        }
        let below = ns / tick * tick;
        let nearest = match below {
            0 => quantity::time_text(tick),
            _ => format!("{} or {}", quantity::time_text(below), quantity::time_text(below + tick)),
        };
        let message = format!("{} is no whole number of ticks", shortened(literal.text));
        let diagnostic = Diagnostic::new(code::BAD_TIME, literal.span, message)
            .label(format!("a tick is {}", quantity::time_text(tick)))
            .help(format!("use {nearest}, or declare a shorter tick"));
        Err(self.report(diagnostic))
    }

    /// A time of more ticks than a `TIME` holds, and what it is worked out to.
    pub(super) fn time_too_long(&mut self, span: Span, time: Option<String>) -> super::Reported {
        let tick = i128::from(self.program.tick_ns);
        let (low, high) = Type::Time.range();
        let (message, label) = match time {
            Some(time) => {
                let words: Vec<_> = self.source.slice(span).split_whitespace().collect();
                let text = words.join(" ");
                let holds = format!("a TIME holds {low} to {high} ticks");
                (format!("`{}` is {time}, and {holds}", shortened(&text)), "outside that range")
            }
            None => (format!("a TIME holds {high} ticks at most"), "longer than that"),
        };
        let diagnostic =
            Diagnostic::new(code::OUT_OF_RANGE, span, message).label(label).help(format!(
                "a tick is {}, so a time is less than {}; declare a longer tick",
                quantity::time_text(tick),
                quantity::time_text(roughly(i128::from(high) * tick))
            ));
        self.report(diagnostic)
    }
}

/// A length of time, up to the next whole hour, minute or second.
fn roughly(ns: i128) -> i128 {
    const SECOND: i128 = 1_000_000_000;
    let unit = match ns / SECOND {
        0..3600 => SECOND,
        3600..86_400 => 60 * SECOND,
        _ => 3600 * SECOND,
    };
    (ns / unit + 1) * unit
}
