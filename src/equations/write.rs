//! Writes: a new value of a variable, of one of its bits, of an element that an index chooses.

use super::lower::Lowering;
use super::{ExprId, ExprOp};
use crate::model::{Base, Place, Relation, VariableId};
use crate::types::Type;

/// What becomes of a place. Every power is a `BOOL`.
#[derive(Clone, Copy)]
pub(super) enum Change {
    /// It gets this value.
    To(ExprId),
    /// It gets the value where there is power.
    When { power: ExprId, value: ExprId },
    /// It gets 1 where there is power.
    Set(ExprId),
    /// It gets 0 where there is power.
    Reset(ExprId),
}

impl Lowering<'_> {
    /// Writes a place. An element that is not known yet is a change of every element, where the
    /// index is its own.
    pub(super) fn write(&mut self, target: &Place, change: Change) {
        let (elements, index) = match &target.base {
            Base::Variable(variable) => {
                self.write_variable(*variable, target.bit, change);
                return;
            }
            Base::Element { elements, index } => (elements, index),
        };
        let ty = index.ty;
        let index = self.expr(index);
        for (number, element) in elements.iter().enumerate() {
            let number = self.add(ExprOp::Constant(number as i64), ty);
            let is_meant = self.add(ExprOp::Compare(Relation::Equal, index, number), Type::Bool);
            let change = self.only_where(is_meant, change);
            self.write_variable(element, target.bit, change);
        }
    }

    fn only_where(&mut self, condition: ExprId, change: Change) -> Change {
        match change {
            Change::To(value) => Change::When { power: condition, value },
            Change::When { power, value } => {
                Change::When { power: self.all(vec![power, condition]), value }
            }
            Change::Set(power) => Change::Set(self.all(vec![power, condition])),
            Change::Reset(power) => Change::Reset(self.all(vec![power, condition])),
        }
    }

    fn write_variable(&mut self, variable: VariableId, bit: Option<u32>, change: Change) {
        let whole_ty = self.program.variables[variable].ty;
        let ty = if bit.is_some() { Type::Bool } else { whole_ty };
        let value = match change {
            Change::To(value) => value,
            Change::When { power, value } => {
                let off = self.read_part(variable, bit);
                self.add(ExprOp::Select { power, on: value, off }, ty)
            }
            Change::Set(power) => {
                let before = self.read_part(variable, bit);
                self.any(&[power, before])
            }
            Change::Reset(power) => {
                let before = self.read_part(variable, bit);
                let unpowered = self.not(power);
                self.all(vec![before, unpowered])
            }
        };
        let value = match bit {
            None => value,
            Some(bit) => {
                let whole = self.read(variable);
                self.add(ExprOp::WithBit { whole, bit, value }, whole_ty)
            }
        };
        self.assign(variable, value);
        self.clear_fraction(variable, change);
    }

    /// Clears what counts the parts of a unit where its accumulator is made 0.
    fn clear_fraction(&mut self, written: VariableId, change: Change) {
        let Some(fraction) = self.program.fraction_of(written) else { return };
        let now = self.read(written);
        let no_units = self.add(ExprOp::Constant(0), self.program.variables[written].ty);
        let is_zero = self.add(ExprOp::Compare(Relation::Equal, now, no_units), Type::Bool);
        let clears = match change {
            Change::To(_) => is_zero,
            Change::When { power, .. } | Change::Set(power) | Change::Reset(power) => {
                self.all(vec![power, is_zero])
            }
        };
        let ty = self.program.variables[fraction].ty;
        let (on, off) = (self.add(ExprOp::Constant(0), ty), self.read(fraction));
        let value = self.add(ExprOp::Select { power: clears, on, off }, ty);
        self.assign(fraction, value);
    }
}
