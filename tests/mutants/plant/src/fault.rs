//! The faults that cargo-mutants lists.

use serde::Deserialize;

/// A fault.
#[derive(Deserialize)]
pub struct Fault {
    /// File, place and what is done, by which cargo-mutants selects it.
    pub name: String,
    /// The file in the project.
    pub file: String,
    /// What kind of place it changes.
    pub genre: Genre,
    /// What stands there then.
    pub replacement: String,
    /// The function that it is in.
    pub function: Option<Function>,
    /// What it replaces.
    pub span: Span,
}

/// A function.
#[derive(Deserialize)]
pub struct Function {
    /// As it is written, with its arrow.
    pub return_type: String,
}

/// Kinds of places.
#[derive(Clone, Copy, Deserialize, Eq, Hash, PartialEq)]
pub enum Genre {
    /// The body of a function.
    FnValue,
    /// An operator between two operands.
    BinaryOperator,
    /// An operator before its operand, which is left out.
    UnaryOperator,
    /// An arm of a `match`, which is left out.
    MatchArm,
    /// The guard of an arm.
    MatchArmGuard,
    /// A field in a structure that has the others from a base, which is left out.
    StructField,
}

/// From where to where.
#[derive(Deserialize)]
pub struct Span {
    /// Where it starts.
    pub start: Place,
}

/// A place in a file.
#[derive(Clone, Copy, Deserialize, Eq, Hash, PartialEq)]
pub struct Place {
    /// From 1.
    pub line: usize,
    /// Characters, from 1.
    pub column: usize,
}
