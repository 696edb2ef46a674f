//! Stops a count where nobody can tell any more how far it has gone.
//!
//! Before: any circuit. After: the same outputs in every scan; a register that only counts up, and
//! that is only compared with constants, stops at the largest of them; one that only counts down
//! stops below the smallest. A register v becomes min(v, M): to know whether v is at least t it is
//! enough to know that of min(v, M), as long as t is not above M, and min(v + 1, M) follows from
//! min(v, M). A counter that goes both ways is left alone: on its way back it would come too soon.

use std::collections::HashMap;

use super::family::{Family, Observer, Step, families};
use super::rebuild::{Rebuild, rebuild};
use crate::circuit::ranges::{Interval, Ranges};
use crate::circuit::{Cell, Circuit, Net, Op, RegisterId, mask};

/// The circuit with counts that stop, if some count goes on for nothing.
pub fn saturate(circuit: &Circuit) -> Option<Circuit> {
    let ranges = Ranges::of(circuit);
    let families = families(circuit, &ranges);
    let stops: HashMap<RegisterId, Stop> = families
        .iter()
        .filter_map(|family| Stop::of(circuit, &ranges, family).map(|stop| (family.register, stop)))
        .collect();
    if stops.is_empty() {
        return None;
    }
    let mut changed: HashMap<Net, Change<'_>> = HashMap::new();
    for family in &families {
        let Some(stop) = stops.get(&family.register) else { continue };
        for &net in &family.members {
            changed.insert(net, Change::Member(stop));
        }
        for observer in family.observers.iter().filter(|observer| stop.is_beyond(observer)) {
            changed.insert(observer.net, Change::Bit(stop.answer(circuit, observer)));
        }
    }
    Some(rebuild(circuit, |rebuild, net, cell| match changed.get(&net) {
        None => rebuild.copy(cell),
        Some(Change::Bit(bit)) => rebuild.to.bit(*bit),
        Some(Change::Member(stop)) => stop.member(rebuild, cell),
    }))
}

/// What becomes of a cell.
enum Change<'a> {
    /// It is one of the words that stop.
    Member(&'a Stop),
    /// It only decided on steps beyond the stop.
    Bit(bool),
}

/// Where a count stops.
struct Stop {
    at: i128,
    signed: bool,
    width: u32,
    step: Step,
}

impl Stop {
    /// Where the count of a family can stop, if it goes on beyond that.
    fn of(circuit: &Circuit, ranges: &Ranges, family: &Family) -> Option<Stop> {
        let mut marks = family
            .observers
            .iter()
            .filter(|observer| !observer.is_inside)
            .flat_map(|observer| observer.thresholds);
        let first = marks.next()?;
        let at = match family.step {
            Step::Up => marks.fold(first, i128::max),
            Step::Down => marks.fold(first, i128::min) - 1,
        };
        let interval = family.members.iter().map(|&net| ranges.interval(circuit, net));
        let interval = interval.reduce(Interval::join)?;
        let (low, high) = interval.bounds(family.signed);
        // A stop at an end is there already; outside of the range no comparison is needed.
        let width = circuit.width(family.members[0]);
        let stop = Stop { at, signed: family.signed, width, step: family.step };
        (low < at && at < high).then_some(stop)
    }

    /// True for what decides on steps only, and there on nothing that is left.
    fn is_beyond(&self, observer: &Observer) -> bool {
        observer.is_inside
            && observer.thresholds.iter().any(|&threshold| match self.step {
                Step::Up => threshold > self.at,
                Step::Down => threshold <= self.at,
            })
    }

    /// What a comparison beyond the stop says of every number that is not.
    fn answer(&self, circuit: &Circuit, observer: &Observer) -> bool {
        match (circuit.cell(observer.net).op, self.step) {
            (Op::Less { a, .. }, Step::Up) => a == observer.of,
            (Op::Less { b, .. }, Step::Down) => b == observer.of,
            _ => false,
        }
    }

    fn clamp(&self, bits: u64) -> u64 {
        let number = Interval::bits(bits, self.width).bounds(self.signed).0;
        let clamped = match self.step {
            Step::Up => number.min(self.at),
            Step::Down => number.max(self.at),
        };
        clamped as u64 & mask(self.width)
    }

    /// A word of the family, stopped.
    fn member(&self, rebuild: &mut Rebuild<'_>, cell: Cell) -> Net {
        let circuit = rebuild.from;
        match cell.op {
            Op::Register(id) => {
                let reset = self.clamp(circuit.registers[id].reset);
                rebuild.register_from(id, cell.width, reset)
            }
            Op::Mux { select, on, off } => {
                let select = rebuild.net(select);
                let [on, off] = [on, off].map(|net| match circuit.constant_value(net) {
                    Some(bits) => rebuild.to.constant(self.clamp(bits), cell.width),
                    None => rebuild.net(net),
                });
                rebuild.to.mux(select, on, off)
            }
            _ => {
                let (from, bit) = self.step.parts(circuit, cell).expect("a member is one of these");
                let from = rebuild.net(from);
                let last = rebuild.to.constant(self.at as u64, cell.width);
                let stopped = Circuit::eq(&mut rebuild.to, from, last);
                let goes_on = rebuild.to.not(stopped);
                let bit = match bit {
                    Some(bit) => {
                        let bit = rebuild.net(bit);
                        rebuild.to.and([bit, goes_on])
                    }
                    None => goes_on,
                };
                let bit = rebuild.to.resize(bit, cell.width, false);
                match self.step {
                    Step::Up => rebuild.to.add(from, bit),
                    Step::Down => rebuild.to.sub(from, bit),
                }
            }
        }
    }
}
