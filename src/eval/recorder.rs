//! What happened inside of a scan, element by element.

use std::collections::HashMap;

use crate::model::{Element, VariableId};

/// Which element of a program: it stands where it stands as long as the program lives.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Place(usize);

impl Place {
    pub(super) fn of(element: &Element) -> Place {
        Place(std::ptr::from_ref(element).addr())
    }
}

/// Takes down a scan as it is executed.
#[derive(Clone, Debug)]
pub(super) enum Recorder {
    /// The power that arrives at each call, in the order of execution, which is the same in every
    /// scan.
    Calls(Vec<bool>),
    /// Everything.
    Full(Recording),
}

/// A scan as it was executed.
#[derive(Clone, Debug, Default)]
pub(super) struct Recording {
    /// What happened at each element; each is executed once in a scan.
    visits: HashMap<Place, Visit>,
    /// Every value that was written, in order.
    pub(super) writes: Vec<Write>,
    /// For each variable that was written the places of its writes in that order.
    of_variable: HashMap<VariableId, Vec<usize>>,
    /// The element that is being executed.
    current: Option<Place>,
}

/// The execution of an element.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Visit {
    /// The power that arrived.
    pub(super) power: bool,
    /// The power that went on.
    pub(super) out: bool,
    /// How much had been written before.
    pub(super) start: usize,
    /// How much had been written behind it.
    pub(super) end: usize,
}

/// A value that was written.
#[derive(Clone, Copy, Debug)]
pub(super) struct Write {
    pub(super) value: i64,
    /// Who wrote it; nobody where the scan itself did.
    pub(super) by: Option<Place>,
}

/// An element whose execution has begun.
pub(super) struct Entry {
    element: Place,
    power: bool,
    start: usize,
    outer: Option<Place>,
}

impl Recorder {
    pub(super) fn enter(&mut self, element: &Element, power: bool) -> Entry {
        let element = Place::of(element);
        match self {
            Recorder::Calls(_) => Entry { element, power, start: 0, outer: None },
            Recorder::Full(recording) => {
                let outer = recording.current.replace(element);
                Entry { element, power, start: recording.writes.len(), outer }
            }
        }
    }

    pub(super) fn leave(&mut self, entry: Entry, out: bool) {
        if let Recorder::Full(recording) = self {
            recording.current = entry.outer;
            let end = recording.writes.len();
            let visit = Visit { power: entry.power, out, start: entry.start, end };
            recording.visits.insert(entry.element, visit);
        }
    }

    pub(super) fn call(&mut self, power: bool) {
        if let Recorder::Calls(calls) = self {
            calls.push(power);
        }
    }

    pub(super) fn write(&mut self, variable: VariableId, value: i64) {
        if let Recorder::Full(recording) = self {
            recording.of_variable.entry(variable).or_default().push(recording.writes.len());
            recording.writes.push(Write { value, by: recording.current });
        }
    }
}

impl Recording {
    /// What happened at an element of the program that ran; nothing where no scan did.
    pub(super) fn visit(&self, element: &Element) -> Visit {
        self.visits.get(&Place::of(element)).copied().unwrap_or_default()
    }

    /// The last write of a variable among the first `until`.
    pub(super) fn last_write(&self, variable: VariableId, until: usize) -> Option<usize> {
        let writes = self.of_variable.get(&variable)?;
        let before = writes.partition_point(|&write| write < until);
        before.checked_sub(1).map(|last| writes[last])
    }
}
