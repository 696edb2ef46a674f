//! The tree of what was written: nothing is resolved, every part knows its place.
//!
//! Nesting is at most [`super::MAX_NESTING`] lists plus as many operators in an expression, so a
//! recursive walk is safe.

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
    pub length: Option<Literal<'s>>,
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

/// `test "title" statements`
#[derive(Debug)]
pub struct Test<'s> {
    /// The title.
    pub title: Text<'s>,
    /// The statements in text order.
    pub statements: Vec<Statement<'s>>,
    /// From the word `test` to the end of the last statement.
    pub span: Span,
}

/// One statement of a test.
#[derive(Debug)]
pub struct Statement<'s> {
    /// What it does.
    pub kind: StatementKind<'s>,
    /// Its place.
    pub span: Span,
}

/// The kinds of statement.
#[derive(Debug)]
pub enum StatementKind<'s> {
    /// `start := 1`
    Drive(Reference<'s>, Expr<'s>),
    /// `scan`, `scan 10`
    Scan(Option<Literal<'s>>),
    /// `wait 500ms`
    Wait(Literal<'s>),
    /// `pulse start`
    Pulse(Reference<'s>),
    /// `repeat 4 { ... }`
    Repeat(Literal<'s>, Vec<Statement<'s>>),
    /// `reset`
    Reset,
    /// `expect a !b`
    Expect(Series<'s>),
}
