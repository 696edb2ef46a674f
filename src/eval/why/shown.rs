//! The rungs of an explanation, to be drawn.

use std::collections::HashMap;

use super::{Cause, Reason, Why};
use crate::eval::flow::{Flow, Seen};
use crate::eval::scene::Scene;

/// A rung in a scan that an explanation has led to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ShownRung {
    /// The scan.
    pub scan: usize,
    /// The rung's number, from 1.
    pub rung: usize,
    /// Its elements in text order. Those that decided, or that did what was decided, say so.
    pub seen: Vec<Seen>,
}

impl Why<'_> {
    /// What went on in a scan.
    ///
    /// # Panics
    /// If there was no such scan.
    pub fn flow(&self, scan: usize) -> Flow {
        let (start, recording) = (self.trace.start(scan), self.trace.replay(scan));
        Flow::of(self.program, Scene { recording: &recording, start: &start })
    }

    /// The rungs of an explanation, in the order in which it comes to them.
    pub fn shown(&self, cause: &Cause) -> Vec<ShownRung> {
        let mut marks = Vec::new();
        collect(cause, &mut marks);
        let mut flows: HashMap<usize, Flow> = HashMap::new();
        let mut shown: Vec<ShownRung> = Vec::new();
        for (scan, rung, element) in marks {
            let place = shown.iter().position(|shown| (shown.scan, shown.rung) == (scan, rung));
            let place = place.unwrap_or_else(|| {
                let flow = flows.entry(scan).or_insert_with(|| self.flow(scan));
                let seen = flow.rungs[rung - 1].clone();
                shown.push(ShownRung { scan, rung, seen });
                shown.len() - 1
            });
            shown[place].seen[element].decides = true;
        }
        shown
    }
}

/// Scan, rung and element of all that is named.
fn collect(cause: &Cause, marks: &mut Vec<(usize, usize, usize)>) {
    if let Some(looked) = cause.looked {
        marks.push((looked.scan, looked.rung, looked.element));
    }
    match &cause.reason {
        Reason::Element(place) | Reason::Call(place, _) => {
            marks.push((cause.told_of, place.rung, place.element));
        }
        Reason::Input
        | Reason::Reset
        | Reason::FirstScan
        | Reason::Kept
        | Reason::Above
        | Reason::Deeper => {}
    }
    cause.causes.iter().for_each(|cause| collect(cause, marks));
}
