//! The scalar types of the language, with the widths of IEC 61131-3.

use std::fmt;

/// A scalar type. A value of any type is kept as an `i64` in the type's own range: 0 or 1 for
/// `BOOL`, sign-extended for signed types, zero-extended for the others.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Type {
    /// One bit.
    Bool,
    /// 16 bits, signed.
    Int,
    /// 16 bits, unsigned.
    Uint,
    /// 32 bits, signed.
    Dint,
    /// 32 bits, unsigned.
    Udint,
    /// 16 bits, a bit pattern.
    Word,
    /// 32 bits, a bit pattern.
    Dword,
    /// 32 bits, signed: a number of ticks.
    Time,
}

impl Type {
    /// Every type, in the order of the language reference.
    pub const ALL: [Type; 8] = [
        Type::Bool,
        Type::Int,
        Type::Uint,
        Type::Dint,
        Type::Udint,
        Type::Word,
        Type::Dword,
        Type::Time,
    ];

    /// The name as written in a program.
    pub fn name(self) -> &'static str {
        match self {
            Type::Bool => "BOOL",
            Type::Int => "INT",
            Type::Uint => "UINT",
            Type::Dint => "DINT",
            Type::Udint => "UDINT",
            Type::Word => "WORD",
            Type::Dword => "DWORD",
            Type::Time => "TIME",
        }
    }

    /// The type of that name, if there is one.
    pub fn named(name: &str) -> Option<Type> {
        Type::ALL.into_iter().find(|ty| ty.name() == name)
    }

    /// Width in bits.
    pub fn width(self) -> u32 {
        match self {
            Type::Bool => 1,
            Type::Int | Type::Uint | Type::Word => 16,
            Type::Dint | Type::Udint | Type::Dword | Type::Time => 32,
        }
    }

    /// True where the top bit is a sign.
    pub fn is_signed(self) -> bool {
        matches!(self, Type::Int | Type::Dint | Type::Time)
    }

    /// True for whole numbers without a unit: indexes, amounts of shifts.
    pub fn is_integer(self) -> bool {
        matches!(self, Type::Int | Type::Uint | Type::Dint | Type::Udint)
    }

    /// True for bit patterns, single bits aside.
    pub fn is_pattern(self) -> bool {
        matches!(self, Type::Word | Type::Dword)
    }

    /// True for the types whose bits have numbers: `x.5`.
    pub fn has_bits(self) -> bool {
        self.is_integer() || self.is_pattern()
    }

    /// True for the types that `+` and `-` take.
    pub fn is_number(self) -> bool {
        self.is_integer() || self == Type::Time
    }

    /// The smallest and the largest value.
    pub fn range(self) -> (i64, i64) {
        if self.is_signed() {
            let half = 1_i64 << (self.width() - 1);
            (-half, half - 1)
        } else {
            (0, (1_i64 << self.width()) - 1)
        }
    }

    /// True if the value can be held without wrapping.
    pub fn holds(self, value: i128) -> bool {
        let (low, high) = self.range();
        (i128::from(low)..=i128::from(high)).contains(&value)
    }

    /// The value reduced to the type's width in two's complement.
    pub fn wrap(self, value: i64) -> i64 {
        let spare = 64 - self.width();
        if self.is_signed() {
            (value << spare) >> spare
        } else {
            ((value as u64) << spare >> spare) as i64
        }
    }

    /// The bits of a value, as a register of the type's width holds them.
    pub fn bits(self, value: i64) -> u64 {
        value as u64 & (u64::MAX >> (64 - self.width()))
    }
}

impl fmt::Display for Type {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_wrap_at_the_width_of_their_type() {
        assert_eq!(Type::Int.wrap(32768), -32768);
        assert_eq!(Type::Uint.wrap(-1), 65535);
        assert_eq!(Type::Dint.wrap(i64::from(i32::MAX) + 1), i64::from(i32::MIN));
        assert_eq!(Type::Bool.wrap(3), 1);
        assert_eq!(Type::Int.bits(-1), 0xFFFF);
        assert!(Type::Int.holds(-32768) && !Type::Int.holds(32768));
    }
}
