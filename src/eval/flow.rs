//! The power in every element of the rungs in one scan, and the values that stand beside it.

use super::Evaluator;
use super::recorder::{Recorder, Recording};
use super::scene::Scene;
use crate::model::{Call, Element, Expr, ExprKind, Net, Place, Program, Rung, Series};
use crate::quantity;
use crate::types::Type;

/// Columns that a time takes at most.
const TIME: usize = 12;

/// One scan as it went through the rungs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Flow {
    /// For each rung, in text order, its elements in text order: a list before what is in it, a
    /// block before the circuits that it is given.
    pub rungs: Vec<Vec<Seen>>,
}

/// What one element did.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Seen {
    /// Power arrived. In a general network: from the node at the left of the connection.
    pub power: bool,
    /// Power went on.
    pub out: bool,
    /// A contact or comparison that lets power pass, whether any came or not; a coil whose
    /// variable was on behind it; whatever else acted or had power behind it.
    pub is_on: bool,
    /// It decided what is being explained.
    pub decides: bool,
    /// Values that belong beside it. Which ones, and their room, is the same in every scan.
    pub readings: Vec<Reading>,
    /// Of a general network, for each connection, whether the nodes at its ends had power.
    pub ends: Vec<[bool; 2]>,
}

/// A value beside an element. What an element reads is shown as it read it, what it writes as it
/// left it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Reading {
    /// The variable as it is written, or the port of a block.
    pub name: String,
    /// The value, a time with its unit.
    pub text: String,
    /// How many characters the value takes at most.
    pub room: usize,
}

impl Flow {
    /// What there is to see before the first scan: no power, and every variable as it starts.
    pub fn at_reset(program: &Program) -> Flow {
        let start: Vec<i64> = program.variables.values().map(|variable| variable.initial).collect();
        let recording = Recording::default();
        Flow::of(program, Scene { recording: &recording, start: &start })
    }

    pub(super) fn of(program: &Program, scene: Scene) -> Flow {
        let seen = |network: &Series| {
            let mut walk = Walk { program, scene, seen: Vec::new() };
            walk.series(network, true);
            walk.seen
        };
        // They may be executed in another order than they are drawn in.
        let mut rungs: Vec<&Rung> = program.rungs.iter().collect();
        rungs.sort_by_key(|rung| rung.number);
        Flow { rungs: rungs.into_iter().map(|rung| seen(&rung.network)).collect() }
    }
}

impl Evaluator<'_> {
    /// One scan as [`Evaluator::scan`] does it, and what went on in it.
    pub fn scan_seen(&mut self, tick: bool) -> Flow {
        let start = self.values().to_vec();
        match self.scan_recorded(tick, Recorder::Full(Recording::default())) {
            Recorder::Full(recording) => {
                Flow::of(self.program(), Scene { recording: &recording, start: &start })
            }
            Recorder::Calls(_) => unreachable!("a recorder stays of its kind"),
        }
    }
}

/// A walk over a rung in text order.
struct Walk<'a> {
    program: &'a Program,
    scene: Scene<'a>,
    seen: Vec<Seen>,
}

impl Walk<'_> {
    /// `is_fed`: what was taken for the power at its left end was there.
    fn series(&mut self, series: &[Element], is_fed: bool) {
        series.iter().for_each(|element| self.element(element, is_fed));
    }

    fn element(&mut self, element: &Element, is_fed: bool) {
        let visit = self.scene.recording.visit(element);
        let number = self.seen.len();
        self.seen.push(Seen {
            power: visit.power && is_fed,
            out: visit.out && is_fed,
            is_on: self.is_on(element),
            decides: false,
            readings: self.readings(element),
            ends: Vec::new(),
        });
        match element {
            Element::Parallel(branches) => {
                branches.iter().for_each(|branch| self.series(branch, is_fed));
            }
            Element::Net(net) => {
                let fed = self.fed_nodes(net, visit.power && is_fed);
                for connection in &net.connections {
                    self.seen[number].ends.push([fed[connection.from], fed[connection.to]]);
                    self.series(&connection.network, fed[connection.from]);
                }
            }
            Element::Call(call) => {
                call.networks().for_each(|network| self.series(network, true));
            }
            Element::Constant(_)
            | Element::Contact { .. }
            | Element::Edge { .. }
            | Element::OneShot { .. }
            | Element::Invert
            | Element::Compare(..)
            | Element::Coil { .. }
            | Element::ResetInstance(_)
            | Element::Assign { .. } => {}
        }
    }

    fn fed_nodes(&self, net: &Net, power: bool) -> Vec<bool> {
        match power {
            true => self.scene.powered(net),
            false => vec![false; net.nodes.len()],
        }
    }

    fn is_on(&self, element: &Element) -> bool {
        let visit = self.scene.recording.visit(element);
        match element {
            Element::Coil { target, .. } => {
                target.value(&|variable| self.scene.value(variable, visit.end)) != 0
            }
            Element::ResetInstance(_) | Element::Assign { .. } | Element::Call(_) => visit.power,
            Element::Constant(_)
            | Element::Contact { .. }
            | Element::Edge { .. }
            | Element::Parallel(_)
            | Element::OneShot { .. }
            | Element::Invert
            | Element::Compare(..)
            | Element::Net(_) => self.scene.conducts(element),
        }
    }

    fn readings(&self, element: &Element) -> Vec<Reading> {
        let visit = self.scene.recording.visit(element);
        let mut readings = Vec::new();
        match element {
            Element::Compare(expr, _) => self.read(expr, visit.start, &mut readings),
            Element::Assign { target, value, .. } => {
                self.look(target, visit.end, &mut readings);
                let index = target.index();
                index.into_iter().for_each(|index| self.read(index, visit.start, &mut readings));
                self.read(value, visit.start, &mut readings);
            }
            Element::Call(call) => readings = self.ports(call, visit.end),
            Element::Constant(_)
            | Element::Contact { .. }
            | Element::Edge { .. }
            | Element::Parallel(_)
            | Element::OneShot { .. }
            | Element::Invert
            | Element::Coil { .. }
            | Element::ResetInstance(_)
            | Element::Net(_) => {}
        }
        readings
    }

    /// What an expression reads, in text order.
    fn read(&self, expr: &Expr, until: usize, readings: &mut Vec<Reading>) {
        if let ExprKind::Read(place) = &expr.kind {
            self.look(place, until, readings);
        }
        expr.parts().into_iter().for_each(|part| self.read(part, until, readings));
    }

    /// A place when so much had been written, if it is not among the readings.
    fn look(&self, place: &Place, until: usize, readings: &mut Vec<Reading>) {
        let name = place.name(self.program);
        if readings.iter().any(|reading| reading.name == name) {
            return;
        }
        let value = place.value(&|variable| self.scene.value(variable, until));
        readings.push(self.reading(name, place.ty(self.program), value));
    }

    /// The ports of a block that a program can name.
    fn ports(&self, call: &Call, until: usize) -> Vec<Reading> {
        let members = &self.program.instances[call.instance].members;
        let ports = call.shape.ports.iter().zip(members);
        let named = ports.filter(|(port, _)| port.role.is_member());
        let readings = named.map(|(port, &member)| {
            self.reading(port.name.to_owned(), port.ty, self.scene.value(member, until))
        });
        readings.collect()
    }

    fn reading(&self, name: String, ty: Type, value: i64) -> Reading {
        let text = value_text(ty, value, self.program.tick_ns);
        Reading { name, text, room: room(ty) }
    }
}

/// A value as it is shown: decimal, a time with its unit.
pub fn value_text(ty: Type, value: i64, tick_ns: u64) -> String {
    match ty {
        Type::Time => time(value, tick_ns),
        _ => value.to_string(),
    }
}

/// How many characters a value of a type takes at most.
fn room(ty: Type) -> usize {
    match ty {
        Type::Time => TIME,
        _ => {
            let (low, high) = ty.range();
            low.to_string().len().max(high.to_string().len())
        }
    }
}

/// A number of ticks as a time with its unit. Where that is too long it is cut to larger units,
/// with a `~` in front.
fn time(ticks: i64, tick_ns: u64) -> String {
    let ns = i128::from(ticks) * i128::from(tick_ns);
    let exact = quantity::time_text(ns);
    let cut = |unit: &i128| format!("~{}", quantity::time_text(ns - ns % unit));
    let second = 1_000_000_000;
    let units = [1_000_000, second, 60 * second, 3600 * second, 24 * 3600 * second];
    let mut texts = std::iter::once(exact).chain(units.iter().map(cut));
    texts.find(|text| text.len() <= TIME).unwrap_or_else(|| "~".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_keep_within_their_room() {
        assert_eq!(time(0, 1_000_000), "0s");
        assert_eq!(time(3200, 1_000_000), "3200ms");
        assert_eq!(time(-1500, 1_000), "-1500us");
        assert_eq!(time(i64::from(i32::MAX), 1_000_000), "2147483647ms");
        assert_eq!(time(i64::from(i32::MIN), 1_000_000), "~-24d20h31m");
        assert_eq!(time(i64::from(i32::MAX), 10), "~21474ms");
        let longest = quantity::LONGEST_TICK_NS;
        for ticks in [i32::MIN, -1, 1, 86_399, i32::MAX] {
            for tick_ns in [1, 7, 999, 1_000_001, 59_999_999_999, longest - 1, longest] {
                let text = time(ticks.into(), tick_ns);
                assert!(text.len() <= TIME && text.len() > 1, "{ticks} of {tick_ns} ns: {text}");
            }
        }
    }
}
