//! The ports of a block, and what it keeps besides.

use crate::types::Type;

/// A port of a block, or a part of its hidden state.
#[derive(Debug)]
pub struct Port {
    /// As written after the instance's name and a dot, or before `:=` in a call.
    pub name: &'static str,
    /// Its type.
    pub ty: Type,
    /// What it is there for.
    pub role: PortRole,
    /// What it is at reset and after `(R name)`.
    pub start: Start,
    /// Meaning and unit.
    pub doc: &'static str,
}

/// What a port is there for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PortRole {
    /// A `BOOL` parameter that takes a network; off where the call leaves it out.
    Circuit,
    /// A number or a time that is read in every scan. Where the call leaves it out it is a member
    /// that starts at 0 and can be assigned. Constants must lie between `low` and `high`; other
    /// values act as the nearer of the two.
    Preset {
        /// Smallest constant.
        low: i64,
        /// Largest constant.
        high: i64,
    },
    /// Shown as a member; `(R name)` puts it back to its start.
    Output,
    /// Not shown; `(R name)` puts it back to its start.
    State,
    /// Not shown, and kept by `(R name)`: what the block saw of its inputs.
    Memory,
}

/// What a port is at reset.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Start {
    /// This number.
    Value(i64),
    /// The value that the preset of that name has at reset: a constant, an expression taken over
    /// the initial values of its variables, or 0 where the call leaves the preset out.
    Preset(&'static str),
}

impl PortRole {
    /// True for what the caller gives, false for what the block keeps.
    pub fn is_parameter(self) -> bool {
        matches!(self, PortRole::Circuit | PortRole::Preset { .. })
    }

    /// True if a program can read it as `instance.NAME`.
    pub fn is_member(self) -> bool {
        matches!(self, PortRole::Preset { .. } | PortRole::Output)
    }

    /// True for what `(R name)` puts back to its start.
    pub fn is_cleared(self) -> bool {
        matches!(self, PortRole::Output | PortRole::State)
    }

    /// What a preset of that value acts as.
    pub fn within(self, value: i64) -> i64 {
        match self {
            PortRole::Preset { low, high } => value.clamp(low, high),
            _ => value,
        }
    }
}

impl Port {
    const fn new(name: &'static str, ty: Type, role: PortRole, doc: &'static str) -> Port {
        Port { name, ty, role, start: Start::Value(0), doc }
    }

    /// A parameter that takes a network.
    pub const fn circuit(name: &'static str, doc: &'static str) -> Port {
        Port::new(name, Type::Bool, PortRole::Circuit, doc)
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

    /// The same with another start.
    pub const fn starting_at(self, start: Start) -> Port {
        Port { start, ..self }
    }
}
