//! What has a value: references, expressions and literals.

use super::Name;
use crate::source::Span;

/// A name with what follows it: `t1.Q`, `x.5`, `w[2].5`.
#[derive(Debug)]
pub struct Reference<'s> {
    /// The declared name.
    pub name: Name<'s>,
    /// Members, bits and indexes.
    pub path: Vec<Accessor<'s>>,
}

impl Reference<'_> {
    /// The place of the whole reference.
    pub fn span(&self) -> Span {
        self.path.last().map_or(self.name.span, |last| self.name.span.to(last.span()))
    }
}

/// One step into a name.
#[derive(Debug)]
pub enum Accessor<'s> {
    /// `.Q`
    Member(Name<'s>),
    /// `.5`
    Bit(Literal<'s>),
    /// `[i]`
    Index(Box<Expr<'s>>, Span),
}

impl Accessor<'_> {
    /// The place of the step.
    pub fn span(&self) -> Span {
        match self {
            Accessor::Member(name) => name.span,
            Accessor::Bit(literal) => literal.span,
            Accessor::Index(_, span) => *span,
        }
    }
}

/// An expression.
#[derive(Debug)]
pub struct Expr<'s> {
    /// What it is.
    pub kind: ExprKind<'s>,
    /// Its place.
    pub span: Span,
}

/// The kinds of expression.
#[derive(Debug)]
pub enum ExprKind<'s> {
    /// A number, a time, `TRUE` or `FALSE`.
    Literal(Literal<'s>),
    /// A variable, constant or member.
    Reference(Reference<'s>),
    /// `-x`, `NOT x`
    Unary(UnaryOperator, Box<Expr<'s>>),
    /// `a + b` and its kin
    Binary(BinaryOperator, Box<Expr<'s>>, Box<Expr<'s>>),
    /// `MAX(a, b)`
    Function(Name<'s>, Vec<Expr<'s>>),
}

/// An operator with one operand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UnaryOperator {
    /// `-`
    Negate,
    /// `NOT`
    Not,
}

/// An operator with two operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BinaryOperator {
    /// `+`
    Add,
    /// `-`
    Subtract,
    /// `*`
    Multiply,
    /// `/`
    Divide,
    /// `MOD`
    Modulo,
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
    /// `AND`
    And,
    /// `XOR`
    Xor,
    /// `OR`
    Or,
}

impl BinaryOperator {
    /// How tightly it binds, as in IEC 61131-3 structured text: 7 is tightest.
    pub fn binding(self) -> u8 {
        match self {
            BinaryOperator::Multiply | BinaryOperator::Divide | BinaryOperator::Modulo => 7,
            BinaryOperator::Add | BinaryOperator::Subtract => 6,
            BinaryOperator::Less
            | BinaryOperator::LessOrEqual
            | BinaryOperator::Greater
            | BinaryOperator::GreaterOrEqual => 5,
            BinaryOperator::Equal | BinaryOperator::NotEqual => 4,
            BinaryOperator::And => 3,
            BinaryOperator::Xor => 2,
            BinaryOperator::Or => 1,
        }
    }
}

/// A literal as written; the checker gives it its value.
#[derive(Clone, Copy, Debug)]
pub struct Literal<'s> {
    /// What it is by its looks.
    pub kind: LiteralKind,
    /// As written.
    pub text: &'s str,
    /// Its place.
    pub span: Span,
}

/// How many or how long: a literal, or a constant that stands for one.
#[derive(Clone, Copy, Debug)]
pub enum Amount<'s> {
    /// `10`, `500ms`
    Literal(Literal<'s>),
    /// `PATIENCE`
    Constant(Name<'s>),
}

impl<'s> Amount<'s> {
    /// As written, a name without its back-ticks.
    pub fn text(&self) -> &'s str {
        match self {
            Amount::Literal(literal) => literal.text,
            Amount::Constant(name) => name.text,
        }
    }

    /// Its place.
    pub fn span(&self) -> Span {
        match self {
            Amount::Literal(literal) => literal.span,
            Amount::Constant(name) => name.span,
        }
    }
}

/// The kinds of literal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LiteralKind {
    /// `TRUE`, `FALSE`
    Bool,
    /// `10`, `1_000`, `16#FF`
    Integer,
    /// `500ms`, `2m30s`, `T#1.5s`
    Time,
}
