//! Compares a count before it is counted on instead of behind the adder, and remembers that it has
//! arrived instead of comparing it again.
//!
//! Before: any circuit. After: the same outputs in every scan; where the sum of a word and one bit
//! is compared with a constant, `n + bit = 50` is `bit ? n = 49 : n = 50`, so that no signal runs
//! through both the adder and a comparison within one clock. Where the next value of a register is
//! compared with a constant and its present value with the same one, the latter is a flip-flop that
//! takes the former: what was said of the next value a scan ago. A timer's output is such a
//! flip-flop already, and the coil behind it often is: then one of them goes.

use std::collections::{HashMap, HashSet};

use super::family::families;
use super::rebuild::{Rebuild, rebuild};
use crate::circuit::ranges::{Assumptions, Interval, Ranges};
use crate::circuit::{Cell, Circuit, Net, Op, RegisterId, mask};

/// The most comparisons that may stand in for one behind an adder.
const COMPARISONS: usize = 2;
/// The most cells between a comparison and what is compared instead.
const CELLS: u32 = 32;
/// The width from which a comparison costs more than a flip-flop.
const WIDTH: u32 = 5;

/// A word and the constant that it is compared with.
type Place = (Net, u64);

/// The circuit with comparisons in front of adders, if some stand behind one.
pub fn compare_ahead(circuit: &Circuit) -> Option<Circuit> {
    let stands_behind = |(_, cell): (Net, Cell)| {
        compared(circuit, cell).is_some_and(|place| places(circuit, place) != [place])
    };
    if !circuit.cells().any(stands_behind) {
        return None;
    }
    let ranges = Ranges::of(circuit);
    let arrivals = arrivals(circuit);
    // One comparison serves all that ask the same.
    let mut made: HashMap<Place, Net> = HashMap::new();
    // Whose next value nobody reads but to compare it: the adder is not needed in the same scan.
    let hidden: HashSet<RegisterId> =
        families(circuit, &ranges).into_iter().map(|family| family.register).collect();
    let remembered: HashSet<RegisterId> = arrivals
        .values()
        .map(|arrival| arrival.register)
        .filter(|register| hidden.contains(register))
        .collect();
    Some(rebuild(circuit, |rebuild, net, cell| {
        let Some(place) = compared(circuit, cell) else {
            return match counted(circuit, net, 0) {
                Some((from, bit, _)) if is_one_of(circuit, from, &remembered) => {
                    enabled(rebuild, cell, from, bit)
                }
                _ => rebuild.copy(cell),
            };
        };
        let mut compare = |(net, value): Place| {
            *made.entry((net, value)).or_insert_with(|| match arrivals.get(&(net, value)) {
                Some(arrival) => arrival.register(rebuild),
                None if !is_possible(circuit, &ranges, (net, value)) => rebuild.to.bit(false),
                None => {
                    let (copy, width) = (rebuild.net(net), circuit.width(net));
                    let value = rebuild.to.constant(value, width);
                    Circuit::eq(&mut rebuild.to, copy, value)
                }
            })
        };
        let places = places(circuit, place);
        let is_remembered = places
            .iter()
            .any(|place| arrivals.contains_key(place) && is_one_of(circuit, place.0, &remembered));
        let comparisons = places.into_iter().map(|place| (place, compare(place))).collect();
        let assumptions = ranges.assumptions(circuit);
        let mut ahead = Ahead { comparisons, is_remembered, assumptions };
        ahead.equal(rebuild, place)
    }))
}

/// A comparison of a register's value that a flip-flop can remember.
struct Arrival {
    register: RegisterId,
    value: u64,
    /// The same comparison of the value that the register takes.
    next: Net,
}

impl Arrival {
    fn register(&self, rebuild: &mut Rebuild<'_>) -> Net {
        let register = &rebuild.from.registers[self.register];
        let name = format!("{}_is_{}", register.name, self.value);
        let reset = register.reset == self.value;
        rebuild.new_register(&name, reset, self.next, self.register)
    }
}

/// The comparisons for which there is one of the next value.
fn arrivals(circuit: &Circuit) -> HashMap<Place, Arrival> {
    let comparisons =
        || circuit.cells().filter_map(|(net, cell)| Some((net, compared(circuit, cell)?)));
    let by_place: HashMap<Place, Net> = comparisons().map(|(net, place)| (place, net)).collect();
    let arrival = |(_, (net, value)): (Net, Place)| {
        let Op::Register(register) = circuit.cell(net).op else { return None };
        let next = *by_place.get(&(circuit.registers[register].next, value))?;
        let is_wide = circuit.width(net) >= WIDTH;
        is_wide.then_some(((net, value), Arrival { register, value, next }))
    };
    comparisons().filter_map(arrival).collect()
}

fn is_possible(circuit: &Circuit, ranges: &Ranges, (net, value): Place) -> bool {
    ranges.interval(circuit, net).contains(Interval::bits(value, circuit.width(net)))
}

fn is_one_of(circuit: &Circuit, net: Net, registers: &HashSet<RegisterId>) -> bool {
    matches!(circuit.cell(net).op, Op::Register(id) if registers.contains(&id))
}

/// A count as people write it: `bit ? n + 1 : n`. A flip-flop that keeps its value has an input
/// for that in every FPGA, and the flip-flop that remembers shares it.
fn enabled(rebuild: &mut Rebuild<'_>, cell: Cell, from: Net, bit: Net) -> Net {
    let (from, bit) = (rebuild.net(from), rebuild.net(bit));
    let one = rebuild.to.constant(1, cell.width);
    let counted = match cell.op {
        Op::Sub(..) => rebuild.to.sub(from, one),
        _ => rebuild.to.add(from, one),
    };
    rebuild.to.mux(bit, counted, from)
}

/// What a comparison with a constant compares.
fn compared(circuit: &Circuit, cell: Cell) -> Option<Place> {
    let Op::Eq(net, constant) = cell.op else { return None };
    circuit.constant_value(constant).map(|value| (net, value))
}

/// What has to be compared instead; the place itself if that is best.
fn places(circuit: &Circuit, place: Place) -> Vec<Place> {
    let mut search = Search { circuit, places: Vec::new(), cells: CELLS };
    match search.find(place) && (1..=COMPARISONS).contains(&search.places.len()) {
        true if search.cells > 0 => search.places,
        _ => vec![place],
    }
}

/// A search for what has to be compared to know whether a net is a value.
struct Search<'c> {
    circuit: &'c Circuit,
    places: Vec<Place>,
    /// How many cells may still be looked at.
    cells: u32,
}

impl Search<'_> {
    /// Collects the places. True if some of them stand before an adder.
    fn find(&mut self, (net, value): Place) -> bool {
        self.cells = self.cells.saturating_sub(1);
        if self.cells == 0 || self.places.len() > COMPARISONS {
            return false;
        }
        if let Some((from, _, before)) = counted(self.circuit, net, value) {
            self.find((from, value));
            self.find((from, before));
            return true;
        }
        if let Some(place) = shifted(self.circuit, net, value) {
            self.find(place);
            return true;
        }
        match self.circuit.cell(net).op {
            Op::Const(_) => false,
            Op::Mux { on, off, .. } => {
                let on = self.find((on, value));
                self.find((off, value)) || on
            }
            _ => {
                if !self.places.contains(&(net, value)) {
                    self.places.push((net, value));
                }
                false
            }
        }
    }
}

/// For the sum or the difference of a word and one bit: the word, the bit, and what the word is
/// where the bit makes that value of it.
fn counted(circuit: &Circuit, net: Net, value: u64) -> Option<(Net, Net, u64)> {
    let bit = |net: Net| match circuit.cell(net).op {
        Op::Extend { from, signed: false } if circuit.width(from) == 1 => Some(from),
        _ => None,
    };
    let mask = mask(circuit.width(net));
    match circuit.cell(net).op {
        Op::Add(a, b) => {
            let right = bit(b).map(|bit| (a, bit));
            let (from, bit) = right.or_else(|| bit(a).map(|bit| (b, bit)))?;
            Some((from, bit, value.wrapping_sub(1) & mask))
        }
        Op::Sub(a, b) => bit(b).map(|bit| (a, bit, value.wrapping_add(1) & mask)),
        _ => None,
    }
}

/// For the sum or the difference of a word and a constant: the word, and what it is where that
/// makes the value.
fn shifted(circuit: &Circuit, net: Net, value: u64) -> Option<Place> {
    let constant = |net: Net| circuit.constant_value(net);
    let mask = mask(circuit.width(net));
    match circuit.cell(net).op {
        Op::Add(a, b) => {
            let right = constant(b).map(|by| (a, value.wrapping_sub(by) & mask));
            right.or_else(|| constant(a).map(|by| (b, value.wrapping_sub(by) & mask)))
        }
        Op::Sub(a, b) => constant(b).map(|by| (a, value.wrapping_add(by) & mask)),
        _ => None,
    }
}

/// One comparison on its way to the front.
struct Ahead<'a> {
    comparisons: HashMap<Place, Net>,
    /// One of them is a flip-flop.
    is_remembered: bool,
    assumptions: Assumptions<'a>,
}

impl Ahead<'_> {
    fn equal(&mut self, rebuild: &mut Rebuild<'_>, place: Place) -> Net {
        if let Some(&comparison) = self.comparisons.get(&place) {
            return comparison;
        }
        let (net, value) = place;
        if let Some(place) = shifted(rebuild.from, net, value) {
            return self.equal(rebuild, place);
        }
        match rebuild.from.cell(net).op {
            Op::Const(bits) => rebuild.to.bit(bits == value),
            Op::Mux { select, on, off } => {
                let on = self.equal(rebuild, (on, value));
                let off = self.equal(rebuild, (off, value));
                let select = rebuild.net(select);
                match self.is_remembered {
                    // In the form of the word beside it, so that both share enable and reset.
                    true => rebuild.to.choice(select, on, off),
                    false => rebuild.to.mux(select, on, off),
                }
            }
            _ if self.is_remembered => {
                let (from, bit, before) =
                    counted(rebuild.from, net, value).expect("only these are passed");
                let stays = self.equal(rebuild, (from, value));
                let comes = self.equal(rebuild, (from, before));
                let bit = rebuild.net(bit);
                rebuild.to.choice(bit, comes, stays)
            }
            _ => {
                let (from, bit, before) =
                    counted(rebuild.from, net, value).expect("only these are passed");
                let stays = self.equal(rebuild, (from, value));
                let comes = self.equal(rebuild, (from, before));
                let moves = self.under(rebuild, (from, before), bit);
                let rests = self.under(rebuild, (from, value), bit);
                let rests = rebuild.to.not(rests);
                let comes = rebuild.to.and([moves, comes]);
                let stays = rebuild.to.and([rests, stays]);
                rebuild.to.or([comes, stays])
            }
        }
    }

    /// The copy of a bit, as simple as it is where a word has a value.
    fn under(&mut self, rebuild: &mut Rebuild<'_>, (net, value): Place, bit: Net) -> Net {
        let circuit = rebuild.from;
        let parts: Vec<Net> = match circuit.cell(bit).op {
            Op::And(list) => circuit.list(list).to_vec(),
            _ => vec![bit],
        };
        let known = self.assumptions.where_is(net, value, |under| {
            parts.iter().map(|&part| under.bit(part)).collect::<Vec<_>>()
        });
        let parts: Vec<Net> = match known {
            // The word is never that value.
            None => return rebuild.to.bit(false),
            Some(known) => parts
                .into_iter()
                .zip(known)
                .map(|(part, known)| match known {
                    Some(known) => rebuild.to.bit(known),
                    None => rebuild.net(part),
                })
                .collect(),
        };
        rebuild.to.and(parts)
    }
}
