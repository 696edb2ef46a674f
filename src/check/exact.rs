//! Times that are worked out of literals and of constants without a type: nothing wraps.

use super::expression::arithmetic;
use super::names::{Constant, Entity};
use super::reference::Resolved;
use super::{Checked, Checker};
use crate::diagnostic::{Diagnostic, code};
use crate::model::{Expr, ExprKind};
use crate::quantity;
use crate::source::Span;
use crate::syntax::ast::{self, BinaryOperator, LiteralKind, UnaryOperator};
use crate::types::Type;

/// A value of which no type says how large it may be.
#[derive(Clone, Copy)]
struct Exact {
    /// A number of ticks, and not a plain number.
    is_time: bool,
    value: i128,
}

impl Exact {
    fn ty(self) -> Type {
        if self.is_time { Type::Time } else { Type::Dint }
    }
}

impl<'s> Checker<'s> {
    /// True for literals of numbers and times, constants of which no declaration says the type, and
    /// operations on such alone.
    pub(super) fn is_exact(&self, expr: &ast::Expr<'s>) -> bool {
        match &expr.kind {
            ast::ExprKind::Literal(literal) => literal.kind != LiteralKind::Bool,
            ast::ExprKind::Reference(reference) => {
                let entity = self.names.get(reference.name.text);
                reference.path.is_empty()
                    && matches!(
                        entity,
                        Some(Entity::Constant(Constant {
                            ty: None | Some(Type::Time),
                            is_typed: false,
                            ..
                        }))
                    )
            }
            ast::ExprKind::Unary(UnaryOperator::Negate, operand) => self.is_exact(operand),
            ast::ExprKind::Binary(operator, a, b) => {
                arithmetic(*operator).is_some() && self.is_exact(a) && self.is_exact(b)
            }
            _ => false,
        }
    }

    /// The time that an exact expression with a time in it stands for.
    pub(super) fn time_of_literals(&mut self, expr: &ast::Expr<'s>) -> Checked<Expr> {
        let Exact { value, .. } = self.exact(expr)?;
        if Type::Time.holds(value) {
            return Ok(Expr { ty: Type::Time, kind: ExprKind::Constant(value as i64) });
        }
        let time = value.checked_mul(self.program.tick_ns.into()).map(quantity::time_text);
        Err(self.time_too_long(expr.span, time))
    }

    fn exact(&mut self, expr: &ast::Expr<'s>) -> Checked<Exact> {
        if self.takes_any_type(expr) {
            return Ok(Exact { is_time: false, value: self.number(expr)? });
        }
        match &expr.kind {
            ast::ExprKind::Reference(reference) => match self.resolve(reference)? {
                Resolved::Constant(Constant { value, .. }) => {
                    Ok(Exact { is_time: true, value: value.into() })
                }
                _ => unreachable!("only constants are exact"),
            },
            ast::ExprKind::Literal(literal) => {
                Ok(Exact { is_time: true, value: self.exact_ticks(*literal)? })
            }
            ast::ExprKind::Unary(_, operand) => {
                let operand = self.exact(operand)?;
                // No time is as long as the number that has no opposite.
                Ok(Exact { value: operand.value.saturating_neg(), ..operand })
            }
            ast::ExprKind::Binary(operator, a, b) => {
                let values = (self.exact(a), self.exact(b));
                self.exact_operation(*operator, (a, values.0?), (b, values.1?), expr.span)
            }
            ast::ExprKind::Function(..) => unreachable!("no function is exact"),
        }
    }

    /// An operation with a time at one side or both.
    fn exact_operation(
        &mut self,
        operator: BinaryOperator,
        (a, left): (&ast::Expr<'s>, Exact),
        (b, right): (&ast::Expr<'s>, Exact),
        span: Span,
    ) -> Checked<Exact> {
        let value = match (operator, left.is_time, right.is_time) {
            (BinaryOperator::Add, true, true) => left.value.checked_add(right.value),
            (BinaryOperator::Subtract, true, true) => left.value.checked_sub(right.value),
            (BinaryOperator::Multiply, true, false) | (BinaryOperator::Multiply, false, true) => {
                left.value.checked_mul(right.value)
            }
            (BinaryOperator::Divide, true, false) => {
                if right.value == 0 {
                    self.program.zero_divisors.push(b.span);
                }
                Some(left.value.checked_div(right.value).unwrap_or(0))
            }
            (BinaryOperator::Add | BinaryOperator::Subtract, ..) => {
                let number = if left.is_time { b } else { a };
                return Err(match number.kind {
                    ast::ExprKind::Literal(literal) => self.number_for_a_time(literal),
                    _ => self.mismatch(number.span, Type::Dint, Type::Time),
                });
            }
            _ => {
                return Err(self.no_such_operation_on_times(operator, left.ty(), right.ty(), span));
            }
        };
        value.map(|value| Exact { is_time: true, value }).ok_or_else(|| {
            let diagnostic = Diagnostic::new(code::OUT_OF_RANGE, span, "no type holds such a time")
                .label("too long for every tick")
                .help("use a smaller number");
            self.report(diagnostic)
        })
    }
}
