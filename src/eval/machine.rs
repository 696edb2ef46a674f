//! What a test, a stimulus or a person needs of anything that runs a program.

use super::Evaluator;
use crate::model::VariableId;

/// Runs one program, scan by scan. It starts at reset with all inputs 0.
pub trait Machine {
    /// Back to reset, inputs to 0.
    fn reset(&mut self);

    /// Drives an input with a value of its type, until it is driven again.
    fn drive(&mut self, input: VariableId, value: i64);

    /// Drives the inputs that a row gives a value; the scan itself is still to come.
    fn drive_row(&mut self, row: Row<'_>) {
        row.drives.iter().for_each(|&(input, value)| self.drive(input, value));
    }

    /// One scan, with the tick or without.
    fn scan(&mut self, tick: bool);

    /// The value of a variable after the last scan, or of an input as it is driven.
    fn value(&self, variable: VariableId) -> i64;
}

impl Machine for Evaluator<'_> {
    fn reset(&mut self) {
        Evaluator::reset(self);
    }

    fn drive(&mut self, input: VariableId, value: i64) {
        Evaluator::drive(self, input, value);
    }

    fn scan(&mut self, tick: bool) {
        Evaluator::scan(self, tick);
    }

    fn value(&self, variable: VariableId) -> i64 {
        Evaluator::value(self, variable)
    }
}

/// What comes from outside in one scan.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Row<'a> {
    /// The scan has the tick.
    pub tick: bool,
    /// Inputs that get a value, in range of their types.
    pub drives: &'a [(VariableId, i64)],
}
