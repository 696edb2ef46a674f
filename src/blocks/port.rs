//! The ports of a block, and what it keeps besides.

use crate::types::Type;

/// A port of a block, or a part of its hidden state.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Port {
    /// As written after the instance's name and a dot, or before `:=` in a call.
    pub name: &'static str,
    /// Its type, unless it [follows](Port::follows) a setting.
    pub ty: Type,
    /// What it is there for.
    pub role: PortRole,
    /// What it is at reset; for a parameter, where the call leaves it out.
    pub start: Start,
    /// What `(R name)` makes of it where that is not its start.
    pub cleared: Option<i64>,
    /// What a setting of the call decides about it.
    pub follows: Follows,
    /// The hidden state that counts the parts of one unit of this one: it is 0 from where the
    /// program assigns 0 here.
    pub fraction: Option<&'static str>,
    /// Meaning and unit.
    pub doc: &'static str,
}

/// What a port is there for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum PortRole {
    /// A `BOOL` parameter that takes a network, looked at in every scan. Where the call leaves it
    /// out it is a member that can be assigned.
    Circuit,
    /// A number or a time that is read in every scan. Where the call leaves it out it is a member
    /// that starts at 0 and can be assigned. Constants must lie between `low` and `high`; another
    /// value acts as the nearest that is not negative and not above `high`.
    Preset {
        /// Smallest constant.
        low: i64,
        /// Largest constant.
        high: i64,
    },
    /// One bit that the compiler gives: the pulse of a unit of time of so many nanoseconds, which
    /// all blocks share.
    Pulse(u64),
    /// A number to which the call gives its start and which any rung may assign; the block reads
    /// it. Values act as those of a preset.
    Loaded {
        /// Smallest constant.
        low: i64,
        /// Largest constant.
        high: i64,
    },
    /// The same, and the block counts in it. The range of constants is there if the call may
    /// give a start.
    Accumulator(Option<(i64, i64)>),
    /// Shown as a member; `(R name)` puts it back to its start.
    Output,
    /// Not shown; `(R name)` puts it back to its start.
    State,
    /// Not shown, and kept by `(R name)`: what the block saw of its inputs.
    Memory,
    /// An output, or where it is not shown a state, that something outside of the call may write
    /// too: another call of the instance, or what an assignment entails.
    Shared {
        /// It is a member.
        shown: bool,
    },
    /// A word of a register of the program, which the call reads and writes in place. The member
    /// is that variable itself.
    Register,
    /// Written by another call of the instance alone.
    Idle {
        /// It is a member.
        shown: bool,
    },
}

/// What a port is at reset.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Start {
    /// This number.
    Value(i64),
    /// The value that the preset of that name has at reset: a constant, an expression taken over
    /// the initial values of its variables, or 0 where the call leaves the preset out.
    Preset(&'static str),
}

/// What a setting decides about a port.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Follows {
    /// Nothing.
    Nothing,
    /// Its type is what the setting of that name says; the ends of its range are those of the
    /// type where they are those of `INT`.
    TypeOf(&'static str),
    /// It is there if the list of that name has an item of that number, from 0.
    ItemOf(&'static str, usize),
}

impl PortRole {
    /// True for what a call can give.
    pub fn is_parameter(self) -> bool {
        match self {
            PortRole::Circuit | PortRole::Preset { .. } | PortRole::Loaded { .. } => true,
            PortRole::Accumulator(range) => range.is_some(),
            _ => false,
        }
    }

    /// True for what the call hands over anew in every scan.
    pub fn is_input(self) -> bool {
        matches!(self, PortRole::Circuit | PortRole::Preset { .. } | PortRole::Pulse(_))
    }

    /// True for what a call gives its value at reset.
    pub fn is_loaded(self) -> bool {
        matches!(self, PortRole::Loaded { .. } | PortRole::Accumulator(_))
    }

    /// True if a program can read it as `instance.NAME`.
    pub fn is_member(self) -> bool {
        match self {
            PortRole::Circuit
            | PortRole::Preset { .. }
            | PortRole::Loaded { .. }
            | PortRole::Accumulator(_)
            | PortRole::Output => true,
            PortRole::Shared { shown } | PortRole::Idle { shown } => shown,
            PortRole::Pulse(_) | PortRole::State | PortRole::Memory | PortRole::Register => false,
        }
    }

    /// True for what the block itself holds from scan to scan.
    pub fn is_inside(self) -> bool {
        matches!(self, PortRole::Output | PortRole::State | PortRole::Memory)
    }

    /// True for what a call reads and writes and the program holds from scan to scan.
    pub fn is_outside(self) -> bool {
        matches!(self, PortRole::Accumulator(_) | PortRole::Shared { .. } | PortRole::Register)
    }

    /// True for what is written by a call or a reset coil and seen by others.
    pub fn is_result(self) -> bool {
        self == PortRole::Output || self.is_outside()
    }

    /// True for what `(R name)` puts back.
    pub fn is_cleared(self) -> bool {
        self == PortRole::State || self.is_result() && self != PortRole::Register
    }

    /// The constants that a number may be given.
    pub fn range(self) -> Option<(i64, i64)> {
        match self {
            PortRole::Preset { low, high } | PortRole::Loaded { low, high } => Some((low, high)),
            PortRole::Accumulator(range) => range,
            _ => None,
        }
    }

    /// What a preset of that value acts as.
    pub fn within(self, value: i64) -> i64 {
        self.range().map_or(value, |(_, high)| value.clamp(0, high))
    }

    /// The same role for a type: ends of a range that are those of `INT` become the type's.
    fn of_type(self, ty: Type) -> PortRole {
        let (lowest, highest) = ty.range();
        let fit = |end: i64| match end {
            super::LOWEST => lowest,
            super::HIGHEST => highest,
            end => end,
        };
        match self {
            PortRole::Preset { low, high } => PortRole::Preset { low: fit(low), high: fit(high) },
            PortRole::Loaded { low, high } => PortRole::Loaded { low: fit(low), high: fit(high) },
            PortRole::Accumulator(Some((low, high))) => {
                PortRole::Accumulator(Some((fit(low), fit(high))))
            }
            other => other,
        }
    }
}

impl Port {
    const fn new(name: &'static str, ty: Type, role: PortRole, doc: &'static str) -> Port {
        Port {
            name,
            ty,
            role,
            start: Start::Value(0),
            cleared: None,
            follows: Follows::Nothing,
            fraction: None,
            doc,
        }
    }

    /// A parameter that takes a network; off where it is left out.
    pub const fn circuit(name: &'static str, doc: &'static str) -> Port {
        Port::new(name, Type::Bool, PortRole::Circuit, doc)
    }

    /// The enable circuit; on where it is left out.
    pub const fn enable(doc: &'static str) -> Port {
        Port::circuit("EN", doc).starting_at(Start::Value(1))
    }

    /// A parameter that takes a number or a time.
    pub const fn preset(
        name: &'static str,
        ty: Type,
        (low, high): (i64, i64),
        doc: &'static str,
    ) -> Port {
        Port::new(name, ty, PortRole::Preset { low, high }, doc)
    }

    /// The pulse of a unit of time of so many nanoseconds.
    pub const fn pulse(unit_ns: u64) -> Port {
        Port::new("unit", Type::Bool, PortRole::Pulse(unit_ns), "one unit of time has gone by")
            .starting_at(Start::Value(1))
    }

    /// A number that any rung may assign and the block reads.
    pub const fn loaded(name: &'static str, (low, high): (i64, i64), doc: &'static str) -> Port {
        Port::new(name, Type::Int, PortRole::Loaded { low, high }, doc)
    }

    /// A number that any rung may assign and the block counts in.
    pub const fn accumulator(
        name: &'static str,
        range: Option<(i64, i64)>,
        doc: &'static str,
    ) -> Port {
        Port::new(name, Type::Int, PortRole::Accumulator(range), doc).cleared_to(0)
    }

    /// An output, which starts at 0.
    pub const fn output(name: &'static str, ty: Type, doc: &'static str) -> Port {
        Port::new(name, ty, PortRole::Output, doc)
    }

    /// One bit that nobody sees and `(R name)` clears.
    pub const fn state(name: &'static str, doc: &'static str) -> Port {
        Port::new(name, Type::Bool, PortRole::State, doc)
    }

    /// One bit that nobody sees and `(R name)` keeps.
    pub const fn memory(name: &'static str, doc: &'static str) -> Port {
        Port::new(name, Type::Bool, PortRole::Memory, doc)
    }

    /// An output or a state that not this call alone writes.
    pub const fn shared(name: &'static str, ty: Type, shown: bool, doc: &'static str) -> Port {
        Port::new(name, ty, PortRole::Shared { shown }, doc)
    }

    /// A word of a register.
    pub const fn register(name: &'static str, doc: &'static str) -> Port {
        Port::new(name, Type::Word, PortRole::Register, doc)
    }

    /// The same with another start.
    pub const fn starting_at(self, start: Start) -> Port {
        Port { start, ..self }
    }

    /// The same with another value after `(R name)`.
    pub const fn cleared_to(self, value: i64) -> Port {
        Port { cleared: Some(value), ..self }
    }

    /// The same of the type that a setting says.
    pub const fn of_type(self, setting: &'static str) -> Port {
        Port { follows: Follows::TypeOf(setting), ..self }
    }

    /// The same, there if a list has that item.
    pub const fn for_item(self, setting: &'static str, item: usize) -> Port {
        Port { follows: Follows::ItemOf(setting, item), ..self }
    }

    /// The same with a port that counts the parts of one.
    pub const fn with_fraction(self, fraction: &'static str) -> Port {
        Port { fraction: Some(fraction), ..self }
    }

    /// The same for another type.
    pub(super) fn fitted(self, ty: Type) -> Port {
        Port { ty, role: self.role.of_type(ty), ..self }
    }
}
