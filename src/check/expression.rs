//! Expressions: the type of every part, and constants worked out.

use super::names::{Constant, Entity};
use super::reference::Resolved;
use super::{Checked, Checker, Reported, literal};
use crate::diagnostic::{Diagnostic, code};
use crate::model::{BinaryOp, Expr, ExprKind, Relation};
use crate::source::Span;
use crate::syntax::ast::{self, BinaryOperator, LiteralKind, Reference, UnaryOperator};
use crate::types::Type;

pub(super) fn arithmetic(operator: BinaryOperator) -> Option<BinaryOp> {
    match operator {
        BinaryOperator::Add => Some(BinaryOp::Add),
        BinaryOperator::Subtract => Some(BinaryOp::Subtract),
        BinaryOperator::Multiply => Some(BinaryOp::Multiply),
        BinaryOperator::Divide => Some(BinaryOp::Divide),
        BinaryOperator::Modulo => Some(BinaryOp::Modulo),
        _ => None,
    }
}

pub(super) fn bitwise(operator: BinaryOperator) -> Option<BinaryOp> {
    match operator {
        BinaryOperator::And => Some(BinaryOp::And),
        BinaryOperator::Or => Some(BinaryOp::Or),
        BinaryOperator::Xor => Some(BinaryOp::Xor),
        _ => None,
    }
}

/// What an operator compares for.
pub(super) fn relation(operator: BinaryOperator) -> Option<Relation> {
    match operator {
        BinaryOperator::Equal => Some(Relation::Equal),
        BinaryOperator::NotEqual => Some(Relation::NotEqual),
        BinaryOperator::Less => Some(Relation::Less),
        BinaryOperator::LessOrEqual => Some(Relation::LessOrEqual),
        BinaryOperator::Greater => Some(Relation::Greater),
        BinaryOperator::GreaterOrEqual => Some(Relation::GreaterOrEqual),
        _ => None,
    }
}

impl<'s> Checker<'s> {
    /// An expression; an untyped literal in it takes the wanted type, anything else must have it.
    pub(super) fn expression(&mut self, expr: &ast::Expr<'s>, want: Option<Type>) -> Checked<Expr> {
        if is_operation(expr) && self.takes_any_type(expr) {
            return self.number_of_type(expr, want);
        }
        let found = match &expr.kind {
            _ if is_operation(expr) && self.is_exact(expr) => self.time_of_literals(expr)?,
            ast::ExprKind::Literal(literal) => self.literal(*literal, false, want)?,
            ast::ExprKind::Reference(reference) => self.read(reference, want)?,
            ast::ExprKind::Unary(operator, operand) => {
                self.unary(*operator, operand, expr.span, want)?
            }
            ast::ExprKind::Binary(operator, a, b) => {
                self.binary(*operator, a, b, expr.span, want)?
            }
            ast::ExprKind::Function(name, arguments) => {
                self.function(*name, arguments, expr.span, want)?
            }
        };
        match want {
            Some(want) if want != found.ty => Err(self.mismatch(expr.span, found.ty, want)),
            _ => Ok(found),
        }
    }

    fn literal(
        &mut self,
        literal: ast::Literal<'s>,
        negative: bool,
        want: Option<Type>,
    ) -> Checked<Expr> {
        if literal.kind == LiteralKind::Time {
            let ticks = self.signed_ticks(literal, negative)?;
            return Ok(Expr { ty: Type::Time, kind: ExprKind::Constant(ticks) });
        }
        let ty = match (literal.kind, want) {
            (LiteralKind::Bool, _) => Type::Bool,
            (_, Some(Type::Time)) => {
                return Err(self.number_for_a_time(literal));
            }
            (_, want) => want.unwrap_or(Type::Dint),
        };
        let value = literal::integer(literal).map(|value| if negative { -value } else { value });
        match value.filter(|&value| ty.holds(value)) {
            Some(value) => Ok(Expr { ty, kind: ExprKind::Constant(value as i64) }),
            None => {
                let (low, high) = ty.range();
                let message = format!("{ty} holds {low} to {high}");
                let diagnostic = Diagnostic::new(code::OUT_OF_RANGE, literal.span, message)
                    .label(format!("does not fit {ty}"))
                    .help(match ty {
                        Type::Bool => "use 0 or 1; for a number declare a type such as INT",
                        _ if ty.width() == 32 => "use a value in that range",
                        _ => "use a value in that range or a wider type",
                    });
                Err(self.report(diagnostic))
            }
        }
    }

    fn read(&mut self, reference: &Reference<'s>, want: Option<Type>) -> Checked<Expr> {
        match self.resolve(reference)? {
            Resolved::Place(place) => {
                Ok(Expr { ty: place.ty(&self.program), kind: ExprKind::Read(place) })
            }
            Resolved::Array(array) => Err(self.array_is_no_value(array, reference)),
            Resolved::Constant(Constant { ty: None, .. }) if want == Some(Type::Time) => {
                Err(self.mismatch(reference.span(), Type::Dint, Type::Time))
            }
            Resolved::Constant(Constant { ty, value, .. }) => {
                let ty = ty.or(want).unwrap_or(Type::Dint);
                if ty.holds(i128::from(value)) {
                    return Ok(Expr { ty, kind: ExprKind::Constant(value) });
                }
                let message = format!("{value} does not fit {ty}");
                let diagnostic = Diagnostic::new(code::OUT_OF_RANGE, reference.span(), message)
                    .label("this constant")
                    .help(match ty {
                        Type::Bool => "a BOOL is 0 or 1; for a number declare a type such as INT",
                        _ if ty.width() == 32 => "use a smaller number",
                        _ => "use a wider type",
                    });
                Err(self.report(diagnostic))
            }
            Resolved::Instance(instance) => Err(self.instance_is_no_value(instance, reference)),
        }
    }

    fn unary(
        &mut self,
        operator: UnaryOperator,
        operand: &ast::Expr<'s>,
        span: Span,
        want: Option<Type>,
    ) -> Checked<Expr> {
        if operator == UnaryOperator::Negate {
            // The literal -32768 fits INT though 32768 does not.
            if let ast::ExprKind::Literal(literal) = operand.kind
                && literal.kind != LiteralKind::Bool
            {
                return self.literal(literal, true, want);
            }
            let operand = self.expression(operand, want)?;
            let zero = Expr { ty: operand.ty, kind: ExprKind::Constant(0) };
            self.numbers_only(operand.ty, span)?;
            return Ok(combine(BinaryOp::Subtract, zero, operand));
        }
        let operand = self.expression(operand, want)?;
        self.bits_only(operand.ty, span)?;
        let ty = operand.ty;
        Ok(match operand.kind {
            ExprKind::Constant(value) => Expr { ty, kind: ExprKind::Constant(ty.wrap(!value)) },
            _ => Expr { ty, kind: ExprKind::Not(Box::new(operand)) },
        })
    }

    fn binary(
        &mut self,
        operator: BinaryOperator,
        a: &ast::Expr<'s>,
        b: &ast::Expr<'s>,
        span: Span,
        want: Option<Type>,
    ) -> Checked<Expr> {
        if let Some(relation) = relation(operator) {
            let (a, b) = self.operands(a, b, None)?;
            return Ok(match (&a.kind, &b.kind) {
                (&ExprKind::Constant(x), &ExprKind::Constant(y)) => {
                    let kind = ExprKind::Constant(relation.holds(x, y).into());
                    Expr { ty: Type::Bool, kind }
                }
                _ => {
                    let kind = ExprKind::Compare(relation, Box::new(a), Box::new(b));
                    Expr { ty: Type::Bool, kind }
                }
            });
        }
        if let Some(op) = bitwise(operator) {
            let (a, b) = self.operands(a, b, want)?;
            self.bits_only(a.ty, span)?;
            return Ok(combine(op, a, b));
        }
        let op = arithmetic(operator).expect("every other operator is arithmetic");
        let divisor = b.span;
        let (a, b) = match op {
            BinaryOp::Multiply | BinaryOp::Divide | BinaryOp::Modulo => {
                self.factors(operator, a, b, want)?
            }
            _ => self.operands(a, b, want)?,
        };
        match (op, a.ty, b.ty) {
            (BinaryOp::Multiply | BinaryOp::Divide, Type::Time, Type::Time)
            | (BinaryOp::Modulo, Type::Time, _) => {
                return Err(self.no_such_operation_on_times(operator, a.ty, b.ty, span));
            }
            _ => self.numbers_only(a.ty, span)?,
        }
        if matches!(op, BinaryOp::Divide | BinaryOp::Modulo) && b.constant() == Some(0) {
            self.program.zero_divisors.push(divisor);
        }
        Ok(combine(op, a, b))
    }

    /// The operands of `*`, `/` or `MOD`: of one type, or a `TIME` and an integer, in this order.
    fn factors(
        &mut self,
        operator: BinaryOperator,
        a: &ast::Expr<'s>,
        b: &ast::Expr<'s>,
        want: Option<Type>,
    ) -> Checked<(Expr, Expr)> {
        // If a TIME is wanted, either side may be an integer.
        let want = want.filter(|&want| want != Type::Time);
        let of_other = |other: &Checked<Expr>| match other {
            Ok(Expr { ty: Type::Time, .. }) | Err(Reported) => None,
            Ok(other) => Some(other.ty),
        };
        let (left, right) = if self.adapts(a) && !self.adapts(b) {
            let right = self.expression(b, want);
            (self.expression(a, of_other(&right)), right)
        } else {
            let left = self.expression(a, want);
            let adapts = self.adapts(b);
            let right = self.expression(b, of_other(&left).filter(|_| adapts));
            (left, right)
        };
        match (left?, right?) {
            (time, factor) if time.ty == Type::Time && factor.ty.is_integer() => Ok((time, factor)),
            (factor, time)
                if operator == BinaryOperator::Multiply
                    && time.ty == Type::Time
                    && factor.ty.is_integer() =>
            {
                Ok((time, factor))
            }
            (left, right) if left.ty == right.ty => Ok((left, right)),
            (number, time) if number.ty.is_integer() && time.ty == Type::Time => {
                let span = a.span.to(b.span);
                Err(self.no_such_operation_on_times(operator, number.ty, time.ty, span))
            }
            (left, right) => Err(self.two_types((a.span, left.ty), (b.span, right.ty))),
        }
    }

    /// Two operands of one type. Both are checked even if one is wrong.
    pub(super) fn operands(
        &mut self,
        a: &ast::Expr<'s>,
        b: &ast::Expr<'s>,
        want: Option<Type>,
    ) -> Checked<(Expr, Expr)> {
        if self.adapts(a) && !self.adapts(b) {
            let right = self.expression(b, want);
            let left = self.expression(a, right.as_ref().ok().map(|right| right.ty));
            return Ok((left?, right?));
        }
        let left = self.expression(a, want);
        let of_left = left.as_ref().ok().map(|left| left.ty);
        let adapts = self.adapts(b);
        let right = self.expression(b, of_left.filter(|_| adapts));
        let (left, right) = (left?, right?);
        match left.ty == right.ty {
            true => Ok((left, right)),
            false => Err(self.two_types((a.span, left.ty), (b.span, right.ty))),
        }
    }

    /// True for an integer literal, a constant without a type, and an operation on such alone.
    pub(super) fn takes_any_type(&self, expr: &ast::Expr<'s>) -> bool {
        match &expr.kind {
            ast::ExprKind::Literal(literal) => literal.kind == LiteralKind::Integer,
            ast::ExprKind::Reference(reference) => {
                let entity = self.names.get(reference.name.text);
                reference.path.is_empty()
                    && matches!(entity, Some(Entity::Constant(Constant { ty: None, .. })))
            }
            ast::ExprKind::Unary(UnaryOperator::Negate, operand) => self.takes_any_type(operand),
            ast::ExprKind::Binary(operator, a, b) => {
                arithmetic(*operator).is_some() && self.takes_any_type(a) && self.takes_any_type(b)
            }
            _ => false,
        }
    }

    pub(super) fn numbers_only(&mut self, ty: Type, span: Span) -> Checked<()> {
        if ty.is_number() {
            return Ok(());
        }
        let message = format!("{ty} values take no arithmetic");
        let diagnostic = Diagnostic::new(code::TYPE_MISMATCH, span, message)
            .label(format!("of type {ty}"))
            .help(match ty {
                Type::Bool => "BOOL values take AND, OR, XOR and NOT",
                _ => "arithmetic takes INT, UINT, DINT, UDINT and TIME",
            });
        Err(self.report(diagnostic))
    }

    /// `*`, `/` or `MOD` with a time where it takes none.
    pub(super) fn no_such_operation_on_times(
        &mut self,
        operator: BinaryOperator,
        left: Type,
        right: Type,
        span: Span,
    ) -> Reported {
        let in_ticks = "TO_DINT gives the number of ticks, for instance:";
        let (message, help) = match (operator, left) {
            (BinaryOperator::Modulo, _) => {
                ("a TIME has no MOD", format!("{in_ticks} TO_TIME(TO_DINT(t) MOD TO_DINT(u))"))
            }
            (BinaryOperator::Divide, left) if left != Type::Time => (
                "a TIME is divided by an integer, and an integer by no TIME",
                format!("{in_ticks} n / TO_DINT(t)"),
            ),
            _ => (
                "a TIME is multiplied or divided by an integer only",
                format!("{in_ticks} TO_DINT(t) / TO_DINT(u)"),
            ),
        };
        let label = match left == right {
            true => format!("of two values of type {left}"),
            false => format!("of {left} and {right}"),
        };
        let diagnostic =
            Diagnostic::new(code::TYPE_MISMATCH, span, message).label(label).help(help);
        self.report(diagnostic)
    }

    pub(super) fn bits_only(&mut self, ty: Type, span: Span) -> Checked<()> {
        if ty == Type::Bool || ty.is_pattern() {
            return Ok(());
        }
        let message = format!("{ty} values have no AND, OR, XOR and NOT");
        let diagnostic = Diagnostic::new(code::TYPE_MISMATCH, span, message)
            .label(format!("of type {ty}"))
            .help("these take BOOL, WORD and DWORD");
        Err(self.report(diagnostic))
    }
}

/// An operation, worked out if both operands are constants.
fn combine(op: BinaryOp, a: Expr, b: Expr) -> Expr {
    let ty = a.ty;
    let kind = match (&a.kind, &b.kind) {
        (&ExprKind::Constant(x), &ExprKind::Constant(y)) => ExprKind::Constant(op.apply(ty, x, y)),
        _ => ExprKind::Binary(op, Box::new(a), Box::new(b)),
    };
    Expr { ty, kind }
}

/// True for what is worked out from parts; a literal with its sign is one part.
pub(super) fn is_operation(expr: &ast::Expr<'_>) -> bool {
    match &expr.kind {
        ast::ExprKind::Unary(_, operand) => !matches!(operand.kind, ast::ExprKind::Literal(_)),
        ast::ExprKind::Binary(..) => true,
        _ => false,
    }
}
