//! What a contact looks at and a coil or an assignment writes: a variable, an element of an
//! array, or one bit of either.

use super::{Expr, Program, VariableId};
use crate::index::index as at;
use crate::types::Type;

/// The elements of an array: variables of one type in a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Elements {
    /// The element of index 0.
    pub first: VariableId,
    /// How many there are, 1 or more.
    pub length: u32,
}

impl Elements {
    /// The element of an index, if it is in range.
    pub fn get(self, index: i64) -> Option<VariableId> {
        let inside = u32::try_from(index).ok().filter(|&index| index < self.length)?;
        Some(VariableId::from_raw((at(self.first) as u32 + inside).into()))
    }

    /// All elements, that of index 0 first.
    pub fn iter(self) -> impl Iterator<Item = VariableId> {
        (0..self.length).filter_map(move |index| self.get(index.into()))
    }
}

/// What is read or written.
#[derive(Debug)]
pub struct Place {
    /// The variable, or the element that an index chooses in every scan anew.
    pub base: Base,
    /// A bit of it, below the width of its type and 0 for the lowest; else all of it.
    pub bit: Option<u32>,
}

/// The variable of a place.
#[derive(Debug)]
pub enum Base {
    /// A variable; an element of an array with a constant index is one.
    Variable(VariableId),
    /// An element that is known only while the program runs. Out of range there is none: a read
    /// gives 0, a write does nothing.
    Element {
        /// Those that it may be.
        elements: Elements,
        /// Of an integer type.
        index: Box<Expr>,
    },
}

impl From<VariableId> for Place {
    fn from(variable: VariableId) -> Place {
        Place { base: Base::Variable(variable), bit: None }
    }
}

impl Place {
    /// The variable, if the place is one, whole and always the same.
    pub fn as_variable(&self) -> Option<VariableId> {
        match self {
            Place { base: Base::Variable(variable), bit: None } => Some(*variable),
            _ => None,
        }
    }

    /// A variable of the place: itself, or the first of the array.
    pub fn declared(&self) -> VariableId {
        match self.base {
            Base::Variable(variable) => variable,
            Base::Element { elements, .. } => elements.first,
        }
    }

    /// The index, if it is no constant.
    pub fn index(&self) -> Option<&Expr> {
        match &self.base {
            Base::Variable(_) => None,
            Base::Element { index, .. } => Some(index),
        }
    }

    /// The type of its value.
    pub fn ty(&self, program: &Program) -> Type {
        match self.bit {
            Some(_) => Type::Bool,
            None => program.variables[self.declared()].ty,
        }
    }

    /// The variable that is meant, given the values of all; `None` for an index out of range.
    pub fn variable(&self, read: &impl Fn(VariableId) -> i64) -> Option<VariableId> {
        match &self.base {
            Base::Variable(variable) => Some(*variable),
            Base::Element { elements, index } => elements.get(index.value(read)),
        }
    }

    /// Its value, given those of the variables.
    pub fn value(&self, read: &impl Fn(VariableId) -> i64) -> i64 {
        let whole = self.variable(read).map_or(0, read);
        match self.bit {
            Some(bit) => whole >> bit & 1,
            None => whole,
        }
    }

    /// Calls `see` with every variable that its value may depend on.
    pub fn for_each_variable(&self, see: &mut dyn FnMut(VariableId)) {
        match &self.base {
            Base::Variable(variable) => see(*variable),
            Base::Element { elements, index } => {
                elements.iter().for_each(&mut *see);
                index.for_each_variable(see);
            }
        }
    }

    /// As a user writes it, but for an index that is no constant.
    pub fn name(&self, program: &Program) -> String {
        let name = match self.base {
            Base::Variable(variable) => program.variables[variable].name.to_string(),
            Base::Element { elements, .. } => {
                let array = program.array_of(elements.first).expect("elements are an array's");
                format!("{}[...]", program.arrays[array].name)
            }
        };
        match self.bit {
            Some(bit) => format!("{name}.{bit}"),
            None => name,
        }
    }
}
