//! Typed expressions and what their operations mean.

use super::{Place, VariableId};
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
            ExprKind::Read(place) => place.value(read),
            ExprKind::Not(operand) => self.ty.wrap(!operand.value(read)),
            ExprKind::Convert(operand) => convert(self.ty, operand.value(read)),
            ExprKind::Binary(op, a, b) => op.apply(self.ty, a.value(read), b.value(read)),
            ExprKind::Compare(relation, a, b) => {
                relation.holds(a.value(read), b.value(read)).into()
            }
            ExprKind::Call(function, arguments) => {
                let arguments: Vec<i64> =
                    arguments.iter().map(|argument| argument.value(read)).collect();
                function.apply(self.ty, &arguments)
            }
        }
    }

    /// The value of a constant.
    pub fn constant(&self) -> Option<i64> {
        match self.kind {
            ExprKind::Constant(value) => Some(value),
            _ => None,
        }
    }

    /// The expressions that it is made of.
    pub fn parts(&self) -> Vec<&Expr> {
        match &self.kind {
            ExprKind::Constant(_) => Vec::new(),
            ExprKind::Read(place) => place.index().into_iter().collect(),
            ExprKind::Not(operand) | ExprKind::Convert(operand) => vec![operand],
            ExprKind::Binary(_, a, b) | ExprKind::Compare(_, a, b) => vec![a, b],
            ExprKind::Call(_, arguments) => arguments.iter().collect(),
        }
    }

    /// Calls `see` with every variable that its value may depend on.
    pub fn for_each_variable(&self, see: &mut dyn FnMut(VariableId)) {
        match &self.kind {
            ExprKind::Read(place) => place.for_each_variable(see),
            _ => self.parts().into_iter().for_each(|part| part.for_each_variable(see)),
        }
    }
}

/// The kinds of expression.
#[derive(Debug)]
pub enum ExprKind {
    /// A value in the range of the type.
    Constant(i64),
    /// The newest value of a place.
    Read(Place),
    /// `NOT`: every bit inverted.
    Not(Box<Expr>),
    /// `TO_INT(x)` and its kin: the value of another type; for `BOOL`, whether it is not 0.
    Convert(Box<Expr>),
    /// An operation on two operands of the result's type; for `TIME`, the second operand of `*`
    /// and `/` is an integer of any type.
    Binary(BinaryOp, Box<Expr>, Box<Expr>),
    /// A comparison of two operands of one type; the result is a `BOOL`.
    Compare(Relation, Box<Expr>, Box<Expr>),
    /// A function of operands of the result's type; the first of [`Function::Select`] is a
    /// `BOOL`, the second of shifts and rotations an integer of any type.
    Call(Function, Vec<Expr>),
}

/// The value of another type: the low bits, read as the new type does; for `BOOL`, whether it is
/// not 0.
pub fn convert(to: Type, value: i64) -> i64 {
    if to == Type::Bool { (value != 0).into() } else { to.wrap(value) }
}

/// An operation on two values, with a result of the first one's type.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum BinaryOp {
    /// Wraps at the width of the type.
    Add,
    /// Wraps at the width of the type.
    Subtract,
    /// Wraps at the width of the type.
    Multiply,
    /// Truncates toward zero and wraps at the width of the type; 0 if the divisor is 0.
    Divide,
    /// What the division leaves, with the sign of the dividend; 0 if the divisor is 0.
    Modulo,
    /// Bit by bit.
    And,
    /// Bit by bit.
    Or,
    /// Bit by bit.
    Xor,
}

impl BinaryOp {
    /// The result for two values, wrapped at the width of a type.
    pub fn apply(self, ty: Type, a: i64, b: i64) -> i64 {
        ty.wrap(match self {
            BinaryOp::Add => a + b,
            BinaryOp::Subtract => a - b,
            // Two values of 32 bits make 64 bits at most; the lowest are right in any case.
            BinaryOp::Multiply => a.wrapping_mul(b),
            BinaryOp::Divide => a.checked_div(b).unwrap_or(0),
            BinaryOp::Modulo => a.checked_rem(b).unwrap_or(0),
            BinaryOp::And => a & b,
            BinaryOp::Or => a | b,
            BinaryOp::Xor => a ^ b,
        })
    }
}

/// A function.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Function {
    /// `ABS(x)`: without its sign; the lowest number, which has no opposite, stays.
    Abs,
    /// `MIN(a, b, ...)`: the smallest of two or more.
    Min,
    /// `MAX(a, b, ...)`: the largest of two or more.
    Max,
    /// `LIMIT(low, x, high)`: `MIN(MAX(x, low), high)`.
    Limit,
    /// `SEL(g, a, b)`: `b` if `g`, else `a`.
    Select,
    /// `SHL(x, n)`: to the left, 0 comes in; a negative amount shifts nothing.
    ShiftLeft,
    /// `SHR(x, n)`: to the right, 0 comes in; a negative amount shifts nothing.
    ShiftRight,
    /// `ROL(x, n)`: to the left in a circle, by `n` modulo the width; a negative amount to the
    /// right.
    RotateLeft,
    /// `ROR(x, n)`: to the right in a circle, by `n` modulo the width; a negative amount to the
    /// left.
    RotateRight,
}

impl Function {
    /// Its name in a program.
    pub fn name(self) -> &'static str {
        match self {
            Function::Abs => "ABS",
            Function::Min => "MIN",
            Function::Max => "MAX",
            Function::Limit => "LIMIT",
            Function::Select => "SEL",
            Function::ShiftLeft => "SHL",
            Function::ShiftRight => "SHR",
            Function::RotateLeft => "ROL",
            Function::RotateRight => "ROR",
        }
    }

    /// The result of a type for as many arguments as the function takes.
    pub fn apply(self, ty: Type, arguments: &[i64]) -> i64 {
        match (self, arguments) {
            (Function::Abs, &[x]) => ty.wrap(x.abs()),
            (Function::Min, list) => list.iter().copied().min().unwrap_or(0),
            (Function::Max, list) => list.iter().copied().max().unwrap_or(0),
            (Function::Limit, &[low, x, high]) => x.max(low).min(high),
            (Function::Select, &[select, off, on]) => [off, on][usize::from(select != 0)],
            (Function::ShiftLeft, &[x, amount]) => shift(ty, x, amount, |x, amount| x << amount),
            (Function::ShiftRight, &[x, amount]) => shift(ty, x, amount, |x, amount| x >> amount),
            (Function::RotateLeft, &[x, amount]) => rotate(ty, x, amount),
            (Function::RotateRight, &[x, amount]) => rotate(ty, x, -amount),
            _ => unreachable!("the checker counts arguments"),
        }
    }
}

fn shift(ty: Type, x: i64, amount: i64, by: impl Fn(u64, i64) -> u64) -> i64 {
    match amount {
        ..0 => x,
        _ if amount >= i64::from(ty.width()) => 0,
        _ => ty.wrap(by(ty.bits(x), amount) as i64),
    }
}

fn rotate(ty: Type, x: i64, left: i64) -> i64 {
    let left = left.rem_euclid(ty.width().into());
    let bits = ty.bits(x);
    // No bit is lost above: the widest type has 32.
    ty.wrap((bits << left | bits >> (i64::from(ty.width()) - left)) as i64)
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn division_truncates_and_wraps() {
        let int = |op: BinaryOp, a, b| op.apply(Type::Int, a, b);
        for (a, b, quotient, rest) in [
            (7, 2, 3, 1),
            (-7, 2, -3, -1),
            (7, -2, -3, 1),
            (-7, -2, 3, -1),
            (-32768, -1, -32768, 0),
            (-32768, 1, -32768, 0),
            (32767, -32768, 0, 32767),
            (5, 0, 0, 0),
            (-5, 0, 0, 0),
        ] {
            assert_eq!(int(BinaryOp::Divide, a, b), quotient, "{a} / {b}");
            assert_eq!(int(BinaryOp::Modulo, a, b), rest, "{a} MOD {b}");
        }
        assert_eq!(int(BinaryOp::Multiply, 256, 256), 0);
        assert_eq!(int(BinaryOp::Multiply, -32768, -1), -32768);
        assert_eq!(BinaryOp::Multiply.apply(Type::Udint, 0xFFFF_FFFF, 0xFFFF_FFFF), 1);
        assert_eq!(BinaryOp::Divide.apply(Type::Time, -100, 4_294_967_295), 0);
    }

    #[test]
    fn shifts_and_rotations_follow_their_amounts() {
        let word = |function: Function, x, amount| function.apply(Type::Word, &[x, amount]);
        for (amount, left, right) in
            [(-1, 0x8001, 0x8001), (0, 0x8001, 0x8001), (1, 2, 0x4000), (15, 0x8000, 1), (16, 0, 0)]
        {
            assert_eq!(word(Function::ShiftLeft, 0x8001, amount), left, "SHL {amount}");
            assert_eq!(word(Function::ShiftRight, 0x8001, amount), right, "SHR {amount}");
        }
        for (amount, left, right) in
            [(0, 0x8001, 0x8001), (1, 3, 0xC000), (16, 0x8001, 0x8001), (-17, 0xC000, 3)]
        {
            assert_eq!(word(Function::RotateLeft, 0x8001, amount), left, "ROL {amount}");
            assert_eq!(word(Function::RotateRight, 0x8001, amount), right, "ROR {amount}");
        }
        assert_eq!(Function::Abs.apply(Type::Int, &[-32768]), -32768);
        assert_eq!(Function::Limit.apply(Type::Int, &[10, 0, 5]), 5);
        assert_eq!(Function::Select.apply(Type::Int, &[1, 3, 4]), 4);
    }
}
