//! Compares a count before it is counted on instead of behind the adder, and remembers that it has
//! arrived instead of comparing it again.
//!
//! Before: any circuit. After: the same outputs in every scan; where the sum of a word and one bit
//! is compared with a constant, `n + bit = 50` is `bit ? n = 49 : n = 50`, so that no signal runs
//! through both the adder and a comparison within one clock. Where the next value of a register is
//! compared with a constant and its present value with the same one, the latter is a flip-flop that
//! takes the former: what was said of the next value a scan ago. A timer's output is such a
//! flip-flop already, and the coil behind it often is: then one of them goes. `n + bit >= 20` asks
//! for that by itself: it is `n >= 20`, a flip-flop, or `bit` and `n = 19`.

use std::collections::{HashMap, HashSet};

use super::family::families;
use super::place::{Place, Search, Source, Test, Then, asked};
use super::rebuild::{Rebuild, rebuild};
use crate::circuit::ranges::{Assumptions, Interval, Ranges};
use crate::circuit::{Cell, Circuit, Net, Op, RegisterId};

/// The width from which a comparison costs more than a flip-flop.
const WIDTH: u32 = 5;

/// A comparison with a constant.
struct Comparison {
    place: Place,
    /// It is 1 where the answer is yes, else where it is no.
    is_yes: bool,
    /// What is asked instead, if that is better.
    instead: Option<Vec<Place>>,
}

/// The circuit with comparisons in front of adders, if some stand behind one.
pub fn compare_ahead(circuit: &Circuit) -> Option<Circuit> {
    let is_computed = |(_, cell): (Net, Cell)| {
        asked(circuit, cell).is_some_and(|(place, _)| {
            matches!(Source::of(circuit, place), Source::Moved { .. } | Source::Choice { .. })
        })
    };
    if !circuit.cells().any(is_computed) {
        return None;
    }
    let ranges = Ranges::of(circuit);
    let mut comparisons = comparisons(circuit, &ranges);
    if comparisons.values().all(|comparison| comparison.instead.is_none()) {
        return None;
    }
    let arrivals = arrivals(circuit, &comparisons);
    // To know that a number was passed is cheap as a flip-flop only.
    let is_cheap = |place: &Place| matches!(place.1, Test::Is(_)) || arrivals.contains_key(place);
    for comparison in comparisons.values_mut() {
        comparison.instead.take_if(|instead| !instead.iter().all(is_cheap));
    }
    // Whose next value nobody reads but to compare it: the adder is not needed in the same scan.
    let hidden: HashSet<RegisterId> =
        families(circuit, &ranges).into_iter().map(|family| family.register).collect();
    let remembered: HashSet<RegisterId> = arrivals
        .values()
        .map(|arrival| arrival.register)
        .filter(|register| hidden.contains(register))
        .collect();
    // One comparison serves all that ask the same.
    let mut made: HashMap<Place, Net> = HashMap::new();
    Some(rebuild(circuit, |rebuild, net, cell| {
        let Some(comparison) = comparisons.get(&net) else {
            return match counted(circuit, net) {
                Some((from, bit)) if is_one_of(circuit, from, &remembered) => {
                    enabled(rebuild, cell, from, bit)
                }
                _ => rebuild.copy(cell),
            };
        };
        let mut ask = |place: Place| {
            *made.entry(place).or_insert_with(|| match arrivals.get(&place) {
                Some(arrival) => arrival.register(rebuild, place.1),
                None => ask_here(rebuild, &ranges, place),
            })
        };
        let here = [comparison.place];
        let places = comparison.instead.as_deref().unwrap_or(&here);
        let is_remembered = places
            .iter()
            .any(|place| arrivals.contains_key(place) && is_one_of(circuit, place.0, &remembered));
        let answers = places.iter().map(|&place| (place, ask(place))).collect();
        let assumptions = ranges.assumptions(circuit);
        let mut ahead = Ahead { answers, is_remembered, assumptions };
        let answer = ahead.answer(rebuild, comparison.place);
        if comparison.is_yes { answer } else { rebuild.to.not(answer) }
    }))
}

fn comparisons(circuit: &Circuit, ranges: &Ranges) -> HashMap<Net, Comparison> {
    let comparison = |(net, cell): (Net, Cell)| {
        let (place, is_yes) = asked(circuit, cell)?;
        let instead = Search::places(circuit, &mut ranges.assumptions(circuit), place);
        Some((net, Comparison { place, is_yes, instead }))
    };
    circuit.cells().filter_map(comparison).collect()
}

/// An answer that a flip-flop can remember.
struct Arrival {
    register: RegisterId,
    /// The same comparison of the value that the register takes.
    next: Net,
    is_yes: bool,
}

impl Arrival {
    fn register(&self, rebuild: &mut Rebuild<'_>, test: Test) -> Net {
        let register = &rebuild.from.registers[self.register];
        let name = match test {
            Test::Is(number) => format!("{}_is_{number}", register.name),
            Test::AtLeast(number) => format!("{}_at_least_{number}", register.name),
        };
        rebuild.new_register(&name, test.of(register.reset), self.next, !self.is_yes, self.register)
    }
}

/// The questions of registers' present values that are asked of their next values too.
fn arrivals(circuit: &Circuit, comparisons: &HashMap<Net, Comparison>) -> HashMap<Place, Arrival> {
    let mut in_order: Vec<(&Net, &Comparison)> = comparisons.iter().collect();
    in_order.sort_by_key(|(net, _)| **net);
    let by_place: HashMap<Place, Net> =
        in_order.iter().map(|(net, comparison)| (comparison.place, **net)).collect();
    let arrival = |(net, test): Place| {
        let Op::Register(register) = circuit.cell(net).op else { return None };
        let next = *by_place.get(&(circuit.registers[register].next, test))?;
        let comparison = &comparisons[&next];
        let is_wide = circuit.width(net) >= WIDTH;
        let follows = match (test, &comparison.instead) {
            (Test::Is(_), _) => true,
            // It has to follow from the register alone.
            (Test::AtLeast(_), Some(places)) => places.iter().all(|(from, _)| *from == net),
            (Test::AtLeast(_), None) => false,
        };
        let is_yes = comparison.is_yes;
        (is_wide && follows).then_some(((net, test), Arrival { register, next, is_yes }))
    };
    let present = in_order.iter().map(|(_, comparison)| comparison.place);
    let passed = in_order.iter().flat_map(|(_, comparison)| comparison.instead.iter().flatten());
    let passed = passed.copied().filter(|(_, test)| matches!(test, Test::AtLeast(_)));
    present.chain(passed).filter_map(arrival).collect()
}

/// The answer of a comparison.
fn ask_here(rebuild: &mut Rebuild<'_>, ranges: &Ranges, (net, test): Place) -> Net {
    let (copy, width) = (rebuild.net(net), rebuild.from.width(net));
    match test {
        Test::Is(number) => {
            let is = Interval::bits(number, width);
            if !ranges.interval(rebuild.from, net).contains(is) {
                return rebuild.to.bit(false);
            }
            let number = rebuild.to.constant(number, width);
            Circuit::eq(&mut rebuild.to, copy, number)
        }
        Test::AtLeast(least) => {
            let least = rebuild.to.constant(least, width);
            let below = rebuild.to.less(copy, least, false);
            rebuild.to.not(below)
        }
    }
}

fn is_one_of(circuit: &Circuit, net: Net, registers: &HashSet<RegisterId>) -> bool {
    matches!(circuit.cell(net).op, Op::Register(id) if registers.contains(&id))
}

/// The word that a cell moves by one bit, and the bit.
fn counted(circuit: &Circuit, net: Net) -> Option<(Net, Net)> {
    match Source::of(circuit, (net, Test::Is(0))) {
        Source::Moved { bit: Some(bit), from, .. } => Some((from, bit)),
        _ => None,
    }
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

/// One comparison on its way to the front.
struct Ahead<'a> {
    answers: HashMap<Place, Net>,
    /// One of them is a flip-flop of a count that nobody reads.
    is_remembered: bool,
    assumptions: Assumptions<'a>,
}

impl Ahead<'_> {
    fn answer(&mut self, rebuild: &mut Rebuild<'_>, place: Place) -> Net {
        if let Some(&answer) = self.answers.get(&place) {
            return answer;
        }
        match Source::of(rebuild.from, place) {
            Source::Here => unreachable!("the search has found it"),
            Source::Known(answer) => rebuild.to.bit(answer),
            Source::Choice { select, on, off } => {
                let (on, off) = (self.answer(rebuild, on), self.answer(rebuild, off));
                let select = rebuild.net(select);
                self.choice(rebuild, select, on, off)
            }
            Source::Moved { bit: None, from, then } => self.then(rebuild, from, then),
            Source::Moved { bit: Some(bit), from, then } => {
                let stays = self.answer(rebuild, (from, place.1));
                let comes = self.then(rebuild, from, then);
                match (self.is_remembered, place.1, then) {
                    (false, Test::Is(value), Then::Same(Test::Is(before))) => {
                        let moves = self.under(rebuild, (from, before), bit);
                        let rests = self.under(rebuild, (from, value), bit);
                        let rests = rebuild.to.not(rests);
                        let comes = rebuild.to.and([moves, comes]);
                        let stays = rebuild.to.and([rests, stays]);
                        rebuild.to.or([comes, stays])
                    }
                    _ => {
                        let bit = rebuild.net(bit);
                        self.choice(rebuild, bit, comes, stays)
                    }
                }
            }
        }
    }

    /// In the form of the word beside a flip-flop that remembers, so that both share enable and
    /// reset.
    fn choice(&self, rebuild: &mut Rebuild<'_>, select: Net, on: Net, off: Net) -> Net {
        match self.is_remembered {
            true => rebuild.to.choice(select, on, off),
            false => rebuild.to.mux(select, on, off),
        }
    }

    fn then(&mut self, rebuild: &mut Rebuild<'_>, from: Net, then: Then) -> Net {
        match then {
            Then::Same(test) => self.answer(rebuild, (from, test)),
            Then::Either(a, b) => {
                let answers = [a, b].map(|test| self.answer(rebuild, (from, test)));
                rebuild.to.or(answers)
            }
            Then::Without(a, b) => {
                let [yes, no] = [a, b].map(|test| self.answer(rebuild, (from, test)));
                let no = rebuild.to.not(no);
                rebuild.to.and([yes, no])
            }
        }
    }

    /// The copy of a bit, as simple as it is where a word has a value.
    fn under(&mut self, rebuild: &mut Rebuild<'_>, (net, value): (Net, u64), bit: Net) -> Net {
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
