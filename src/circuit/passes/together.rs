//! Lets flip-flops that a word moves move together.
//!
//! Before: any circuit. After: the same outputs in every scan; where a condition and a few numbers
//! of a word set and reset several flip-flops, all of them take a new value at each of these
//! numbers, which is the old one where nothing happens to them. So the lamps of a traffic light,
//! one of which is on, have one enable, and each takes whether its own time has come.

use std::collections::{BTreeMap, BTreeSet, HashMap};

use super::rebuild::{Rebuild, rebuild};
use crate::circuit::ranges::{Interval, Ranges};
use crate::circuit::{Cell, Circuit, Net, Op, RegisterId};

/// How many flip-flops are worth an enable.
const FLAGS: usize = 3;
/// How many numbers may move a group.
const NUMBERS: usize = 8;
/// How deep the next value of a flip-flop may be.
const DEPTH: u32 = 8;

/// The circuit with flip-flops that move together, if there are any.
pub fn move_together(circuit: &Circuit) -> Option<Circuit> {
    let mut groups: BTreeMap<(Net, Net), Vec<Flag>> = BTreeMap::new();
    for (own, cell) in circuit.cells() {
        let Op::Register(id) = cell.op else { continue };
        if let Some((condition, word, flag)) = Flag::of(circuit, id, own) {
            groups.entry((condition, word)).or_default().push(flag);
        }
    }
    groups.retain(|_, flags| flags.len() >= FLAGS);
    if groups.is_empty() {
        return None;
    }
    let ranges = Ranges::of(circuit);
    let mut moves: HashMap<Net, Move> = HashMap::new();
    for ((condition, word), flags) in groups {
        let group = Group { circuit, ranges: &ranges, word };
        for (flag, sets, numbers) in group.settle(flags) {
            let next = circuit.registers[flag.id].next;
            moves.insert(next, Move { condition, word, own: flag.own, sets, numbers });
        }
    }
    if moves.is_empty() {
        return None;
    }
    let mut made = Made::default();
    Some(rebuild(circuit, |rebuild, net, cell| {
        if let Some(moved) = moves.get(&net) {
            return moved.make(rebuild, &mut made);
        }
        let known = test(circuit, cell).and_then(|place| made.tests.get(&place));
        known.copied().unwrap_or_else(|| rebuild.copy(cell))
    }))
}

/// The word and the number that a cell holds to be equal.
fn test(circuit: &Circuit, cell: Cell) -> Option<(Net, u64)> {
    match cell.op {
        Op::Eq(word, number) => Some((word, circuit.constant_value(number)?)),
        _ => None,
    }
}

/// A flip-flop that numbers of a word set and reset.
struct Flag {
    id: RegisterId,
    own: Net,
    /// What it takes where the condition holds.
    value: Net,
    /// The numbers that it is made of.
    numbers: BTreeSet<u64>,
}

impl Flag {
    /// With the condition without which it keeps its value, and the word.
    fn of(circuit: &Circuit, id: RegisterId, own: Net) -> Option<(Net, Net, Flag)> {
        let next = circuit.registers[id].next;
        let Cell { op: Op::Mux { select, on: value, off }, width: 1 } = circuit.cell(next) else {
            return None;
        };
        let mut flag = Flag { id, own, value, numbers: BTreeSet::new() };
        let mut word = None;
        let is_one = off == own && flag.search(circuit, value, &mut word, DEPTH);
        Some((select, word.filter(|_| is_one)?, flag))
    }

    /// Collects the numbers. False if a net is made of something else too.
    fn search(&mut self, circuit: &Circuit, net: Net, word: &mut Option<Net>, depth: u32) -> bool {
        let cell = circuit.cell(net);
        if net == self.own || circuit.constant_value(net).is_some() {
            return true;
        }
        if let Some((of, number)) = test(circuit, cell) {
            self.numbers.insert(number);
            return *word.get_or_insert(of) == of && self.numbers.len() <= NUMBERS;
        }
        let mut is_made = depth > 0 && is_gate(cell);
        if is_made {
            circuit.for_each_operand(cell, |operand| {
                is_made = is_made && self.search(circuit, operand, word, depth - 1);
            });
        }
        is_made
    }
}

fn is_gate(cell: Cell) -> bool {
    matches!(cell, Cell { op: Op::Not(_) | Op::And(_) | Op::Or(_) | Op::Mux { .. }, width: 1 })
}

/// Flip-flops of one condition and one word.
struct Group<'c> {
    circuit: &'c Circuit,
    ranges: &'c Ranges,
    word: Net,
}

impl Group<'_> {
    /// Those that can move together, the numbers that set each, and those that move all of them.
    fn settle(&self, mut flags: Vec<Flag>) -> Vec<(Flag, BTreeSet<u64>, BTreeSet<u64>)> {
        loop {
            let numbers: BTreeSet<u64> =
                flags.iter().flat_map(|flag| flag.numbers.iter().copied()).collect();
            if flags.len() < FLAGS || numbers.len() > NUMBERS {
                return Vec::new();
            }
            let before = flags.len();
            let moved = flags.into_iter().filter_map(|flag| {
                let sets = self.sets(&flag, &numbers)?;
                Some((flag, sets, numbers.clone()))
            });
            let moved: Vec<_> = moved.collect();
            if moved.len() == before {
                return moved;
            }
            flags = moved.into_iter().map(|(flag, ..)| flag).collect();
        }
    }

    /// The numbers at which a flip-flop takes 1, if it takes 0 at all others, whatever it was.
    fn sets(&self, flag: &Flag, numbers: &BTreeSet<u64>) -> Option<BTreeSet<u64>> {
        let keeps = |bit: bool| self.value(flag, flag.value, bit, None) == bit;
        if !keeps(false) || !keeps(true) {
            return None;
        }
        let width = self.circuit.width(self.word);
        let while_on = self.ranges.interval_while(self.circuit, self.word, flag.own);
        let can_be_on = |number: u64| {
            while_on.is_none_or(|interval| interval.contains(Interval::bits(number, width)))
        };
        let mut sets = BTreeSet::new();
        for &number in numbers {
            let taken = self.value(flag, flag.value, false, Some(number));
            if can_be_on(number) && self.value(flag, flag.value, true, Some(number)) != taken {
                return None;
            }
            if taken {
                sets.insert(number);
            }
        }
        Some(sets)
    }

    /// A net of a flip-flop's next value where it holds a bit, and the word is a number or none of
    /// those that count.
    fn value(&self, flag: &Flag, net: Net, own: bool, number: Option<u64>) -> bool {
        let value = |net: Net| self.value(flag, net, own, number);
        let circuit = self.circuit;
        let cell = circuit.cell(net);
        match cell.op {
            _ if net == flag.own => own,
            Op::Const(bits) => bits == 1,
            Op::Not(from) => !value(from),
            Op::And(list) => circuit.list(list).iter().all(|&net| value(net)),
            Op::Or(list) => circuit.list(list).iter().any(|&net| value(net)),
            Op::Mux { select, on, off } => value(if value(select) { on } else { off }),
            _ => test(circuit, cell).is_some_and(|(_, other)| number == Some(other)),
        }
    }
}

/// How a flip-flop moves with others.
struct Move {
    condition: Net,
    word: Net,
    own: Net,
    /// The numbers at which it takes 1.
    sets: BTreeSet<u64>,
    /// The numbers at which it takes something.
    numbers: BTreeSet<u64>,
}

/// What was made for several flip-flops.
#[derive(Default)]
struct Made {
    /// For each word and number, whether they are equal.
    tests: HashMap<(Net, u64), Net>,
    /// For each word and numbers, whether it is one of them.
    any: HashMap<(Net, BTreeSet<u64>), Net>,
    /// For each condition, word and numbers, whether something moves.
    moves: HashMap<(Net, Net, BTreeSet<u64>), Net>,
}

impl Move {
    fn make(&self, rebuild: &mut Rebuild<'_>, made: &mut Made) -> Net {
        let Some(&first) = self.numbers.first() else { return rebuild.net(self.own) };
        let others = self.numbers.iter().copied().filter(|&number| number != first).collect();
        let key = (self.condition, self.word, self.numbers.clone());
        let moves = made.moves.get(&key).copied().unwrap_or_else(|| {
            let is_other = self.any(rebuild, made, &others);
            let is_first = self.any(rebuild, made, &BTreeSet::from([first]));
            let is_any = rebuild.to.or([is_first, is_other]);
            let condition = rebuild.net(self.condition);
            rebuild.to.and([condition, is_any])
        });
        made.moves.insert(key, moves);
        // Where something moves it is the first number unless it is another one, which is known.
        let taken = if self.sets.contains(&first) {
            let resets = self.numbers.difference(&self.sets).copied().collect();
            let is_reset = self.any(rebuild, made, &resets);
            rebuild.to.not(is_reset)
        } else {
            self.any(rebuild, made, &self.sets)
        };
        let own = rebuild.net(self.own);
        rebuild.to.choice(moves, taken, own)
    }

    /// Whether the word is one of these numbers.
    fn any(&self, rebuild: &mut Rebuild<'_>, made: &mut Made, numbers: &BTreeSet<u64>) -> Net {
        let key = (self.word, numbers.clone());
        if let Some(&net) = made.any.get(&key) {
            return net;
        }
        let word = rebuild.net(self.word);
        let width = rebuild.to.width(word);
        let mut nets = vec![rebuild.to.bit(false)];
        for &number in numbers {
            let test = made.tests.entry((self.word, number)).or_insert_with(|| {
                let number = rebuild.to.constant(number, width);
                Circuit::eq(&mut rebuild.to, word, number)
            });
            nets.push(*test);
        }
        let net = rebuild.to.or(nets);
        made.any.insert(key, net);
        net
    }
}

#[cfg(test)]
mod tests {
    use fastrand::Rng;

    use super::*;
    use crate::circuit::Design;
    use crate::circuit::passes::same::assert_same;

    /// A word that counts up to a number while an input is 1, and flip-flops that numbers set and
    /// reset.
    fn random(rng: &mut Rng) -> Circuit {
        let mut circuit = Circuit::new("random");
        let counts = circuit.input("counts", 1);
        let (word_id, word) = circuit.register("word", 4, 0);
        let equals = |circuit: &mut Circuit, number: u64| {
            let number = circuit.constant(number, 4);
            Circuit::eq(circuit, word, number)
        };
        let last = rng.u64(4..15);
        let (is_last, zero) = (equals(&mut circuit, last), circuit.constant(0, 4));
        let one = circuit.constant(1, 4);
        let sum = circuit.add(word, one);
        let counted = circuit.mux(is_last, zero, sum);
        let next = circuit.mux(counts, counted, word);
        circuit.drive(word_id, next);
        let numbers = [rng.u64(..=last), rng.u64(..=last), last];
        for at in 0..rng.usize(3..5) {
            let (id, own) = circuit.register(format!("flag_{at}"), 1, rng.u64(..2));
            // Mostly one after the other.
            let mut pick = |at: usize| match rng.u32(..8) {
                0 => rng.u64(..16),
                _ => numbers[at % 3],
            };
            let (sets, resets) = (pick(at), pick(at + 1));
            let (sets, resets) = (equals(&mut circuit, sets), equals(&mut circuit, resets));
            let stays = circuit.not(resets);
            let taken = if rng.bool() {
                let kept = circuit.and([own, stays]);
                circuit.or([sets, kept])
            } else {
                let set = circuit.or([own, sets]);
                circuit.and([set, stays])
            };
            let next = circuit.mux(counts, taken, own);
            circuit.drive(id, next);
            circuit.output(format!("flag_{at}"), own);
        }
        circuit
    }

    #[test]
    fn every_flag_is_what_it_was() {
        let (mut rng, mut changed) = (Rng::with_seed(1), 0);
        for case in 0..3000 {
            let circuit = random(&mut rng);
            let Some(better) = move_together(&circuit) else { continue };
            changed += 1;
            assert_same(case, &circuit, Design { modules: [better].into_iter().collect() }, 60);
        }
        assert!((100..2900).contains(&changed), "{changed} of the circuits were changed");
    }
}
