//! A run, kept as the changes of everything that can change.

use crate::eval::recorder::{Recorder, Recording};
use crate::eval::{Evaluator, Machine, Row};
use crate::index::index;
use crate::model::{Program, Role, VariableId};

/// When something took which value.
type Changes<T> = Vec<(usize, T)>;

/// A run from reset.
pub(super) struct Trace<'p> {
    program: &'p Program,
    /// For each variable the scans that changed it, and what it was then.
    variables: Vec<Changes<i64>>,
    /// The same for the power of each call, in the order of execution.
    calls: Vec<Changes<bool>>,
    ticks: Vec<bool>,
}

impl<'p> Trace<'p> {
    /// Runs a program on these rows.
    pub(super) fn new<'r>(program: &'p Program, rows: impl Iterator<Item = Row<'r>>) -> Self {
        let variables = vec![Vec::new(); program.variables.len()];
        let mut trace = Trace { program, variables, calls: Vec::new(), ticks: Vec::new() };
        let mut evaluator = Evaluator::new(program);
        for row in rows {
            let before = evaluator.values().to_vec();
            evaluator.drive_row(row);
            let recorder = Recorder::Calls(Vec::new());
            let Recorder::Calls(calls) = evaluator.scan_recorded(row.tick, recorder) else {
                unreachable!("a recorder stays of its kind")
            };
            trace.take(row.tick, &before, evaluator.values(), &calls);
        }
        trace
    }

    fn take(&mut self, tick: bool, before: &[i64], after: &[i64], calls: &[bool]) {
        let scan = self.ticks.len();
        self.ticks.push(tick);
        for ((changes, before), &after) in self.variables.iter_mut().zip(before).zip(after) {
            if *before != after {
                changes.push((scan, after));
            }
        }
        self.calls.resize(calls.len(), Vec::new());
        for (changes, &power) in self.calls.iter_mut().zip(calls) {
            if changes.last().is_some_and(|&(_, last)| last) != power {
                changes.push((scan, power));
            }
        }
    }

    /// The number of scans.
    pub(super) fn len(&self) -> usize {
        self.ticks.len()
    }

    /// The value of a variable after a scan.
    pub(super) fn value(&self, variable: VariableId, scan: usize) -> i64 {
        match until(&self.variables[index(variable)], scan) {
            Some((_, value)) => value,
            None => self.program.variables[variable].initial,
        }
    }

    /// The scan at whose end a variable took the value that it has after a scan; nothing if it
    /// has had it since reset.
    pub(super) fn since(&self, variable: VariableId, scan: usize) -> Option<usize> {
        until(&self.variables[index(variable)], scan).map(|(since, _)| since)
    }

    /// The scan since which the power of a call is what it is in a scan.
    pub(super) fn power_since(&self, call: usize, scan: usize) -> Option<usize> {
        until(&self.calls[call], scan).map(|(since, _)| since)
    }

    /// What every variable holds when a scan begins, with the inputs of that scan.
    pub(super) fn start(&self, scan: usize) -> Vec<i64> {
        let value = |(id, variable): (VariableId, &crate::model::Variable)| match (
            variable.role,
            scan.checked_sub(1),
        ) {
            (Role::Input, _) => self.value(id, scan),
            (_, Some(before)) => self.value(id, before),
            (_, None) => variable.initial,
        };
        self.program.variables.iter().map(value).collect()
    }

    /// A scan, element by element.
    pub(super) fn replay(&self, scan: usize) -> Recording {
        let mut evaluator = Evaluator::new(self.program);
        evaluator.resume(self.start(scan));
        let recorder = Recorder::Full(Recording::default());
        match evaluator.scan_recorded(self.ticks[scan], recorder) {
            Recorder::Full(recording) => recording,
            Recorder::Calls(_) => unreachable!("a recorder stays of its kind"),
        }
    }

    /// The scan has the tick.
    pub(super) fn tick(&self, scan: usize) -> bool {
        self.ticks[scan]
    }
}

/// The last change up to a scan.
fn until<T: Copy>(changes: &Changes<T>, scan: usize) -> Option<(usize, T)> {
    let behind = changes.partition_point(|&(at, _)| at <= scan);
    behind.checked_sub(1).map(|last| changes[last])
}
