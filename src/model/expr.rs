//! Typed expressions and what their operations mean.

use super::VariableId;
use crate::types::Type;

/// A typed expression.
#[derive(Debug)]
pub struct Expr {
    /// The type of its value.
    pub ty: Type,
    /// What it is.
    pub kind: ExprKind,
}

impl Expr {
    /// Its value, given those of the variables.
    pub fn value(&self, read: &impl Fn(VariableId) -> i64) -> i64 {
        match &self.kind {
            ExprKind::Constant(value) => *value,
            ExprKind::Read(variable) => read(*variable),
            ExprKind::Not(operand) => self.ty.wrap(!operand.value(read)),
            ExprKind::Binary(op, a, b) => op.apply(self.ty, a.value(read), b.value(read)),
            ExprKind::Compare(relation, a, b) => {
                relation.holds(a.value(read), b.value(read)).into()
            }
        }
    }
}

/// The kinds of expression.
#[derive(Debug)]
pub enum ExprKind {
    /// A value in the range of the type.
    Constant(i64),
    /// The newest value of a variable.
    Read(VariableId),
    /// `NOT`: every bit inverted.
    Not(Box<Expr>),
    /// An operation on two operands of the result's type.
    Binary(BinaryOp, Box<Expr>, Box<Expr>),
    /// A comparison of two operands of one type; the result is a `BOOL`.
    Compare(Relation, Box<Expr>, Box<Expr>),
}

/// An operation on two values of one type, with a result of that type.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum BinaryOp {
    /// Wraps at the width of the type.
    Add,
    /// Wraps at the width of the type.
    Subtract,
    /// Bit by bit.
    And,
    /// Bit by bit.
    Or,
    /// Bit by bit.
    Xor,
}

impl BinaryOp {
    /// The result for two values of a type, wrapped at its width.
    pub fn apply(self, ty: Type, a: i64, b: i64) -> i64 {
        ty.wrap(match self {
            BinaryOp::Add => a + b,
            BinaryOp::Subtract => a - b,
            BinaryOp::And => a & b,
            BinaryOp::Or => a | b,
            BinaryOp::Xor => a ^ b,
        })
    }
}

/// A relation between two values of one type.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Relation {
    /// `=`
    Equal,
    /// `<>`
    NotEqual,
    /// `<`
    Less,
    /// `<=`
    LessOrEqual,
    /// `>`
    Greater,
    /// `>=`
    GreaterOrEqual,
}

impl Relation {
    /// True if `a` stands in this relation to `b`.
    pub fn holds(self, a: i64, b: i64) -> bool {
        match self {
            Relation::Equal => a == b,
            Relation::NotEqual => a != b,
            Relation::Less => a < b,
            Relation::LessOrEqual => a <= b,
            Relation::Greater => a > b,
            Relation::GreaterOrEqual => a >= b,
        }
    }

    /// As written in a program.
    pub fn symbol(self) -> &'static str {
        match self {
            Relation::Equal => "=",
            Relation::NotEqual => "<>",
            Relation::Less => "<",
            Relation::LessOrEqual => "<=",
            Relation::Greater => ">",
            Relation::GreaterOrEqual => ">=",
        }
    }
}
