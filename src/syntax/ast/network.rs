//! What stands between the rails: series, lists, contacts, coils, calls and general networks.

use super::{Expr, Name, Reference};
use crate::source::Span;

/// Elements from left to right.
#[derive(Debug)]
pub struct Series<'s> {
    /// The elements; the checker reports an empty list.
    pub elements: Vec<Element<'s>>,
    /// Their place; where the list is empty, the place where it should stand.
    pub span: Span,
}

/// One element of a series.
#[derive(Debug)]
pub struct Element<'s> {
    /// What it is.
    pub kind: ElementKind<'s>,
    /// Its place.
    pub span: Span,
}

/// The kinds of element.
#[derive(Debug)]
pub enum ElementKind<'s> {
    /// `TRUE` or `1`: a wire. `FALSE` or `0`: an open contact.
    Constant(bool),
    /// `first_scan`, `!first_scan`
    FirstScan {
        /// Normally closed.
        negated: bool,
    },
    /// `x`, `!x`, `/x`
    Contact {
        /// What it looks at.
        operand: Reference<'s>,
        /// Normally closed.
        negated: bool,
    },
    /// `rise(x)`, `fall(x)`
    Edge {
        /// Which change conducts.
        edge: Edge,
        /// What it looks at.
        operand: Reference<'s>,
    },
    /// `[ a | b ]`
    Parallel(Vec<Series<'s>>),
    /// `rising`, `falling`: a one-shot on the power
    OneShot(Edge),
    /// `not`: inverts the power
    Invert,
    /// `{ a > b }`
    Compare(Box<Expr<'s>>),
    /// `(y)` and its kin
    Coil {
        /// What the coil does.
        action: CoilAction,
        /// What it acts on.
        target: Reference<'s>,
    },
    /// `{ y := expression }`
    Assign {
        /// What is written.
        target: Box<Reference<'s>>,
        /// The value.
        value: Box<Expr<'s>>,
    },
    /// `name:KIND(...)`
    Call(Box<Call<'s>>),
    /// `net { ... }`
    Net(Box<Net<'s>>),
}

/// A change of a bit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Edge {
    /// From 0 to 1.
    Rise,
    /// From 1 to 0.
    Fall,
}

/// What a coil does with the power.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CoilAction {
    /// `(y)`
    Plain,
    /// `(!y)`
    Negated,
    /// `(S y)`
    Set,
    /// `(R y)`
    Reset,
    /// `(rise y)`
    Rise,
    /// `(fall y)`
    Fall,
}

/// `name:KIND(A := x, B := y)`
#[derive(Debug)]
pub struct Call<'s> {
    /// The instance.
    pub name: Name<'s>,
    /// The kind of block.
    pub kind: Name<'s>,
    /// The arguments in text order.
    pub arguments: Vec<Argument<'s>>,
}

impl<'s> Call<'s> {
    /// What is written as a network among the arguments, in text order.
    pub fn networks(&self) -> impl Iterator<Item = &Series<'s>> {
        self.arguments.iter().filter_map(|argument| match &argument.value {
            ArgumentValue::Network(network) => Some(network),
            ArgumentValue::Expr(_) | ArgumentValue::List(..) => None,
        })
    }
}

/// One argument of a call.
#[derive(Debug)]
pub struct Argument<'s> {
    /// The parameter.
    pub name: Name<'s>,
    /// What it is given.
    pub value: ArgumentValue<'s>,
}

/// What a parameter is given. The text alone does not always tell (`R := x` may be a network or
/// an expression), so the parser takes the narrowest reading and the checker widens it.
#[derive(Debug)]
pub enum ArgumentValue<'s> {
    /// An expression: a name, a literal or more.
    Expr(Expr<'s>),
    /// A list of constants in square brackets, separated by commas.
    List(Vec<Expr<'s>>, Span),
    /// A network, fed with power 1.
    Network(Series<'s>),
}

impl ArgumentValue<'_> {
    /// Its place.
    pub fn span(&self) -> Span {
        match self {
            ArgumentValue::Expr(expr) => expr.span,
            ArgumentValue::List(_, span) => *span,
            ArgumentValue::Network(network) => network.span,
        }
    }
}

/// `net { left -> n : a b }`
#[derive(Debug)]
pub struct Net<'s> {
    /// The connections in text order.
    pub connections: Vec<Connection<'s>>,
}

/// One connection of a general network.
#[derive(Debug)]
pub struct Connection<'s> {
    /// The node at its left.
    pub from: Name<'s>,
    /// The node at its right.
    pub to: Name<'s>,
    /// `<->`: conducts both ways.
    pub both_ways: bool,
    /// What stands in it.
    pub network: Series<'s>,
}
