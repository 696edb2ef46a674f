//! A run as a timing diagram: one lane for each signal over the scans, as an SVG picture.
//!
//! Where nothing happens for long the time axis is cut short. A word that grows or shrinks by the
//! same step in every scan, as the elapsed time of a timer does, counts as nothing that happens.

mod picture;
mod ruler;

use super::words::{harmless, shortened};
use crate::eval::value_text;
use crate::model::{Program, VariableId};
use crate::types::Type;

/// Columns of a name.
const LONGEST_NAME: i32 = 28;
/// So many moments at which something happens are drawn at most.
const MOST_STRETCHES: usize = 2_000;

/// A timing diagram under construction.
#[derive(Debug)]
pub struct Timing {
    name: String,
    title: Option<String>,
    /// What is said of the run.
    note: Option<String>,
    tick_ns: u64,
    lanes: Vec<Lane>,
    /// Which scans have the tick; drawn if not all do.
    tick: Lane,
    /// The scans in which something happens.
    events: Vec<usize>,
    /// How many of the scans 1 to each event have the tick.
    ticks_at_events: Vec<u64>,
    ticks: u64,
    /// How many scans are drawn.
    drawn: usize,
    scans: usize,
}

/// What one signal did.
#[derive(Debug)]
struct Lane {
    /// The variable; none for the tick.
    variable: Option<VariableId>,
    name: String,
    ty: Type,
    segments: Vec<Segment>,
}

/// Scans in which a value stays as it is, or changes by the same step in each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Segment {
    /// Its first scan.
    start: usize,
    /// The value in that.
    first: i64,
    /// The value in its last scan.
    last: i64,
    /// What is added from scan to scan.
    step: i64,
    /// How many scans it has.
    scans: usize,
}

impl Timing {
    /// The diagram of these variables.
    pub fn new(program: &Program, variables: &[VariableId]) -> Timing {
        let lane = |&id: &VariableId| {
            let variable = &program.variables[id];
            Lane::new(Some(id), &variable.name, variable.ty)
        };
        Timing {
            name: program.name.clone(),
            title: program.title.as_deref().map(harmless),
            note: None,
            tick_ns: program.tick_ns,
            lanes: variables.iter().map(lane).collect(),
            tick: Lane::new(None, "tick", Type::Bool),
            events: Vec::new(),
            ticks_at_events: Vec::new(),
            ticks: 0,
            drawn: 0,
            scans: 0,
        }
    }

    /// Says something of the run, above the diagram.
    pub fn note(&mut self, note: &str) {
        self.note = Some(harmless(note));
    }

    /// Takes down the values after one more scan.
    pub fn scan(&mut self, tick: bool, value: impl Fn(VariableId) -> i64) {
        let scan = self.scans;
        self.scans += 1;
        if self.drawn < scan {
            return;
        }
        let mut happens = self.tick.add(scan, tick.into());
        for lane in &mut self.lanes {
            let variable = lane.variable.expect("it shows a variable");
            happens |= lane.add(scan, value(variable));
        }
        self.ticks += u64::from(tick && scan > 0);
        if happens {
            self.events.push(scan);
            self.ticks_at_events.push(self.ticks);
        }
        if self.events.len() <= MOST_STRETCHES {
            self.drawn = self.scans;
        }
    }
}

impl Lane {
    fn new(variable: Option<VariableId>, name: &str, ty: Type) -> Lane {
        let name = shortened(&harmless(name), LONGEST_NAME);
        Lane { variable, name, ty, segments: Vec::new() }
    }

    /// Adds the value after a scan; true if that is something that happens.
    fn add(&mut self, scan: usize, value: i64) -> bool {
        let is_word = self.ty != Type::Bool;
        if let Some(last) = self.segments.last_mut() {
            let step = value - last.last;
            if step == last.step {
                last.last = value;
                last.scans += 1;
                return false;
            }
            if let [.., before, last] = &mut self.segments[..]
                && is_word
                && (before.scans, last.scans) == (1, 1)
                && last.first - before.first == step
            {
                *before = Segment { last: value, step, scans: 3, ..*before };
                self.segments.pop();
                return false;
            }
        }
        self.segments.push(Segment { start: scan, first: value, last: value, step: 0, scans: 1 });
        true
    }

    /// What a segment's value is, as text.
    fn text(&self, segment: &Segment, tick_ns: u64) -> String {
        let text = |value| value_text(self.ty, value, tick_ns);
        match segment.step {
            0 => text(segment.first),
            _ => format!("{}..{}", text(segment.first), text(segment.last)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn segments(values: &[i64]) -> (Vec<(usize, i64, i64)>, Vec<usize>) {
        let mut lane = Lane::new(None, "n", Type::Int);
        let mut events = Vec::new();
        for (scan, &value) in values.iter().enumerate() {
            if lane.add(scan, value) {
                events.push(scan);
            }
        }
        let segment = |segment: &Segment| (segment.start, segment.first, segment.last);
        (lane.segments.iter().map(segment).collect(), events)
    }

    #[test]
    fn equal_steps_are_one_segment() {
        let (found, events) = segments(&[0, 0, 1, 2, 3, 4, 4, 4]);
        assert_eq!(found, [(0, 0, 0), (2, 1, 4), (6, 4, 4)]);
        assert_eq!(events, [0, 2, 3, 6]);
    }

    #[test]
    fn a_few_changes_are_no_steps() {
        let (found, _) = segments(&[5, 9, 2, 2, 7]);
        assert_eq!(found, [(0, 5, 5), (1, 9, 9), (2, 2, 2), (4, 7, 7)]);
    }
}
