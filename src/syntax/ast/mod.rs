//! The tree of what was written: nothing is resolved, every part knows its place.
//!
//! Nesting is at most [`super::MAX_NESTING`] lists plus as many operators in an expression, so a
//! recursive walk is safe.

mod expression;
mod network;
mod test;

pub use expression::{
    Accessor, Amount, BinaryOperator, Expr, ExprKind, Literal, LiteralKind, Reference,
    UnaryOperator,
};
pub use network::{
    Argument, ArgumentValue, Call, CoilAction, Connection, Edge, Element, ElementKind, Net, Series,
};
pub use test::{Statement, StatementKind, Test};

use crate::source::Span;

/// One file.
#[derive(Debug, Default)]
pub struct File<'s> {
    /// Declarations, rungs and tests in text order.
    pub items: Vec<Item<'s>>,
    /// Every comment, in text order, with its marks.
    pub comments: Vec<Span>,
    /// The places of items with a mistake, which are not among the items.
    pub broken: Vec<Span>,
}

/// A part of a program at the outermost level.
#[derive(Debug)]
pub enum Item<'s> {
    /// `ladder NAME "title"`
    Header(Header<'s>),
    /// `clock 50MHz`
    Clock(Quantity<'s>),
    /// `tick 1ms`
    Tick(Quantity<'s>),
    /// `input`, `output` or `var` with its names
    Variables(Variables<'s>),
    /// `const NAME : TYPE := value`
    Constant(Constant<'s>),
    /// `rung "title" network`
    Rung(Rung<'s>),
    /// `test "title" statements`
    Test(Test<'s>),
    /// `assert`, `assume`, `block`, `use`: reserved for later
    Reserved(Reserved<'s>),
}

/// An item that is kept for later: read as far as where it ends.
#[derive(Debug)]
pub struct Reserved<'s> {
    /// The word that starts it.
    pub word: Name<'s>,
    /// From the word to the end of the last token before the next item.
    pub span: Span,
}

/// A name without its back-ticks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Name<'s> {
    /// The name itself.
    pub text: &'s str,
    /// Its place, back-ticks included.
    pub span: Span,
}

/// A string without its quotes.
#[derive(Clone, Copy, Debug)]
pub struct Text<'s> {
    /// The characters between the quotes; there are no escapes.
    pub text: &'s str,
    /// Its place, quotes included.
    pub span: Span,
}

/// `ladder NAME "title"`
#[derive(Debug)]
pub struct Header<'s> {
    /// The program's name.
    pub name: Name<'s>,
    /// Its title.
    pub title: Option<Text<'s>>,
}

/// A frequency or a time as written: `50MHz`, `1ms`.
#[derive(Clone, Copy, Debug)]
pub struct Quantity<'s> {
    /// As written.
    pub text: &'s str,
    /// Its place.
    pub span: Span,
}

/// What a declaration declares.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum VariableKind {
    /// `input`
    Input,
    /// `output`
    Output,
    /// `var`
    Var,
}

/// `input a, b : INT`: the type holds for every name.
#[derive(Debug)]
pub struct Variables<'s> {
    /// Input, output or var.
    pub kind: VariableKind,
    /// The names with their addresses and initial values.
    pub names: Vec<Declarator<'s>>,
    /// The type; `BOOL` if left out.
    pub ty: Option<TypeName<'s>>,
}

/// One name of a declaration.
#[derive(Debug)]
pub struct Declarator<'s> {
    /// The name.
    pub name: Name<'s>,
    /// `at 316`
    pub address: Option<Literal<'s>>,
    /// `:= value`
    pub initial: Option<Initial<'s>>,
}

/// An initial value.
#[derive(Debug)]
pub enum Initial<'s> {
    /// One constant expression.
    Value(Expr<'s>),
    /// `[a, b, c]`, for an array.
    List(Vec<Expr<'s>>, Span),
}

/// `WORD` or `WORD[3]`
#[derive(Debug)]
pub struct TypeName<'s> {
    /// The scalar type's name.
    pub name: Name<'s>,
    /// The number of elements of an array.
    pub length: Option<Amount<'s>>,
}

/// `const NAME : TYPE := value`
#[derive(Debug)]
pub struct Constant<'s> {
    /// The name.
    pub name: Name<'s>,
    /// The type; that of the value if left out.
    pub ty: Option<TypeName<'s>>,
    /// The value.
    pub value: Expr<'s>,
}

/// `rung "title" network`
#[derive(Debug)]
pub struct Rung<'s> {
    /// The title.
    pub title: Option<Text<'s>>,
    /// What stands between the rails.
    pub network: Series<'s>,
    /// From the word `rung` to the end of the network.
    pub span: Span,
}
