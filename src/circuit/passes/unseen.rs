//! Lets a word be anything while nobody looks at it.
//!
//! Before: any circuit. After: the same outputs in every scan; a word that everybody, but the
//! register itself, looks at only while a flag is on may take whatever is simplest where the flag
//! will be off, and stands for what it can be while the flag is on. So the count of a pulse is
//! `run ? n + 1 : 0`, whatever the timer shows when the pulse is over, and does not ask whether it
//! has arrived where the pulse would be over.
//!
//! Why that is right: where the flag is on, the word is what it was. It is on in the next scan
//! either where it is on now, and then the word's next value is what it was; or where it is off
//! now, and then the next value follows from other nets, which are what they were.

use std::collections::{BTreeSet, HashMap, HashSet};

use super::rebuild::{Rebuild, rebuild};
use crate::circuit::ranges::{Assumptions, Ranges};
use crate::circuit::{Cell, Circuit, Net, Op, Register, RegisterId};
use crate::index::index;

/// How many cells may follow from a word within the scan.
const CELLS: usize = 64;
/// How many flags are tried for a word.
const FLAGS: usize = 4;
/// How deep a next value is searched for choices.
const DEPTH: u32 = 8;

/// The circuit with simpler words, if some word is not always looked at.
pub fn forget_unseen(circuit: &Circuit) -> Option<Circuit> {
    let is_word = |(_, cell): (Net, Cell)| matches!(cell.op, Op::Register(_)) && cell.width > 1;
    if !circuit.cells().any(is_word) {
        return None;
    }
    let readers = Readers::of(circuit);
    let mut ranges = None;
    let mut next: HashMap<Net, Choices> = HashMap::new();
    let mut known: HashMap<Net, bool> = HashMap::new();
    for (net, _) in circuit.cells().filter(|&cell| is_word(cell)) {
        for flag in readers.flags(circuit, net) {
            let Some(cells) = readers.unseen(circuit, net, flag) else { continue };
            let ranges = ranges.get_or_insert_with(|| Ranges::of(circuit));
            let word = Word { circuit, ranges, net, flag, cells };
            let Some(simple) = word.next() else { continue };
            let bits = word.known();
            let (_, register) = register(circuit, net);
            known.extend(bits);
            // Where no choice is left, none is simpler either.
            let as_it_is =
                [Choices::Net(register.next), Choices::of(circuit, register.next, DEPTH)];
            if !as_it_is.contains(&simple) {
                next.insert(register.next, simple);
            }
            break;
        }
    }
    if next.is_empty() && known.is_empty() {
        return None;
    }
    Some(rebuild(circuit, |rebuild, net, cell| match (known.get(&net), next.get(&net)) {
        (Some(&bit), _) => rebuild.to.bit(bit),
        (None, Some(choices)) => choices.make(rebuild),
        (None, None) => rebuild.copy(cell),
    }))
}

fn register(circuit: &Circuit, net: Net) -> (RegisterId, &Register) {
    let Op::Register(id) = circuit.cell(net).op else { unreachable!("it is a register's net") };
    (id, &circuit.registers[id])
}

/// Who reads each net.
struct Readers {
    cells: Vec<Vec<Net>>,
    /// The registers that take a net.
    taken: HashMap<Net, Vec<RegisterId>>,
    /// What is read by anything but cells and the values of registers.
    shown: HashSet<Net>,
}

impl Readers {
    fn of(circuit: &Circuit) -> Self {
        let shown: HashSet<Net> = circuit.shown().collect();
        let mut taken: HashMap<Net, Vec<RegisterId>> = HashMap::new();
        for (id, register) in circuit.registers.iter() {
            taken.entry(register.next).or_default().push(id);
        }
        // Passes leave cells that nobody reads any more.
        let mut cells = vec![Vec::new(); circuit.len()];
        for (net, cell) in circuit.cells().rev() {
            if !cells[index(net)].is_empty() || shown.contains(&net) || taken.contains_key(&net) {
                circuit.for_each_operand(cell, |operand| cells[index(operand)].push(net));
            }
        }
        Readers { cells, taken, shown }
    }

    /// Flip-flops that what follows from a word meets, and that take something when the word does.
    fn flags(&self, circuit: &Circuit, word: Net) -> Vec<Net> {
        let enable = register(circuit, word).1.enable;
        let mut flags = Vec::new();
        let (mut open, mut seen) = (vec![word], HashSet::from([word]));
        while let Some(net) = open.pop() {
            for &reader in &self.cells[index(net)] {
                if seen.len() == CELLS || !seen.insert(reader) {
                    continue;
                }
                open.push(reader);
                circuit.for_each_operand(circuit.cell(reader), |operand| {
                    let is_flag = circuit.width(operand) == 1
                        && matches!(circuit.cell(operand).op, Op::Register(_))
                        && register(circuit, operand).1.enable == enable;
                    if is_flag && flags.len() < FLAGS && !flags.contains(&operand) {
                        flags.push(operand);
                    }
                });
            }
        }
        flags
    }

    /// What follows from a word, as far as it is not hidden where the flag is off. Nothing if
    /// somebody but the register itself sees it there.
    fn unseen(&self, circuit: &Circuit, word: Net, flag: Net) -> Option<BTreeSet<Net>> {
        let (own, register) = register(circuit, word);
        let (mut cells, mut open) = (BTreeSet::new(), BTreeSet::from([word]));
        // In their order: a cell is looked at when all that it may depend on is known.
        while let Some(net) = open.pop_first() {
            let hides = match circuit.cell(net).op {
                Op::Mux { select, off, .. } => select == flag && !cells.contains(&off),
                Op::And(list) => circuit.list(list).contains(&flag),
                _ => false,
            };
            if hides {
                continue;
            }
            let takers = self.taken.get(&net).map_or(&[][..], Vec::as_slice);
            if self.shown.contains(&net)
                || takers.iter().any(|&id| id != own)
                || cells.len() == CELLS
            {
                return None;
            }
            cells.insert(net);
            open.extend(&self.cells[index(net)]);
        }
        let is_read = !self.cells[index(register.next)].is_empty();
        (!is_read && cells.contains(&register.next)).then_some(cells)
    }
}

/// A word that is seen only while a flag is on.
struct Word<'c> {
    circuit: &'c Circuit,
    ranges: &'c Ranges,
    net: Net,
    flag: Net,
    /// What follows from it and is seen only then.
    cells: BTreeSet<Net>,
}

impl Word<'_> {
    /// What the register may take, if where the flag comes on that does not follow from the word.
    fn next(&self) -> Option<Choices> {
        let (_, word) = register(self.circuit, self.net);
        let (_, flag) = register(self.circuit, self.flag);
        let mut assumptions = self.ranges.assumptions(self.circuit);
        assumptions.under(flag.next, true, |under| {
            let comes_on =
                under.under(self.flag, false, |under| self.is_independent(under, word.next, DEPTH));
            comes_on.unwrap_or(true).then(|| Choices::under(self.circuit, under, word.next, DEPTH))
        })?
    }

    fn is_independent(&self, under: &mut Assumptions<'_>, net: Net, depth: u32) -> bool {
        let Op::Mux { select, on, off } = self.circuit.cell(net).op else {
            return !self.cells.contains(&net);
        };
        if depth == 0 || self.cells.contains(&select) {
            return !self.cells.contains(&net);
        }
        let mut is_independent = |value: bool, net: Net| {
            let chosen =
                under.under(select, value, |under| self.is_independent(under, net, depth - 1));
            chosen.unwrap_or(true)
        };
        is_independent(true, on) && is_independent(false, off)
    }

    /// The comparisons that are decided while somebody looks.
    fn known(&self) -> Vec<(Net, bool)> {
        let Some(interval) = self.ranges.interval_while(self.circuit, self.net, self.flag) else {
            return Vec::new();
        };
        let compares =
            |net: &&Net| matches!(self.circuit.cell(**net).op, Op::Eq(..) | Op::Less { .. });
        let known = |&net: &Net| {
            let mut assumptions = self.ranges.assumptions(self.circuit);
            let bit = assumptions.where_in(self.net, interval, |under| {
                under.under(self.flag, true, |under| under.bit(net))
            });
            Some((net, bit.flatten().flatten()?))
        };
        self.cells.iter().filter(compares).filter_map(known).collect()
    }
}

/// A net as choices between others.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Choices {
    Net(Net),
    Of(Net, Box<Choices>, Box<Choices>),
}

impl Choices {
    /// As they are.
    fn of(circuit: &Circuit, net: Net, depth: u32) -> Choices {
        match circuit.cell(net).op {
            Op::Mux { select, on, off } if depth > 0 => {
                let [on, off] = [on, off].map(|net| Choices::of(circuit, net, depth - 1));
                Choices::Of(select, on.into(), off.into())
            }
            _ => Choices::Net(net),
        }
    }

    /// As far as they are left.
    fn under(circuit: &Circuit, under: &mut Assumptions<'_>, net: Net, depth: u32) -> Choices {
        let Op::Mux { select, on, off } = circuit.cell(net).op else { return Choices::Net(net) };
        if depth == 0 {
            return Choices::Net(net);
        }
        let mut chosen = |value: bool, net: Net| {
            under.under(select, value, |under| Choices::under(circuit, under, net, depth - 1))
        };
        match (chosen(true, on), chosen(false, off)) {
            (Some(on), Some(off)) if on == off => on,
            (Some(on), Some(off)) => Choices::Of(select, on.into(), off.into()),
            (Some(only), None) | (None, Some(only)) => only,
            (None, None) => Choices::Net(net),
        }
    }

    fn make(&self, rebuild: &mut Rebuild<'_>) -> Net {
        match self {
            Choices::Net(net) => rebuild.net(*net),
            Choices::Of(select, on, off) => {
                let (on, off) = (on.make(rebuild), off.make(rebuild));
                let select = rebuild.net(*select);
                rebuild.to.choice(select, on, off)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use fastrand::Rng;

    use super::*;
    use crate::circuit::passes::same::assert_same;
    use crate::circuit::{Design, simplify};

    /// Nets to choose from.
    struct Pool {
        circuit: Circuit,
        rng: Rng,
        bits: Vec<Net>,
        words: Vec<Net>,
    }

    impl Pool {
        fn bit(&mut self) -> Net {
            let [a, b, c] = [(); 3].map(|()| self.bits[self.rng.usize(..self.bits.len())]);
            let word = self.words[self.rng.usize(..self.words.len())];
            let number = self.circuit.constant(self.rng.u64(..8), 3);
            let net = match self.rng.u32(..6) {
                0 => self.circuit.not(a),
                1 => self.circuit.and([a, b, c]),
                2 => self.circuit.or([a, b]),
                3 => self.circuit.mux(a, b, c),
                4 => Circuit::eq(&mut self.circuit, word, number),
                _ => self.circuit.less(word, number, false),
            };
            self.bits.push(net);
            net
        }

        fn word(&mut self) -> Net {
            let [a, b] = [(); 2].map(|()| self.words[self.rng.usize(..self.words.len())]);
            let bit = self.bits[self.rng.usize(..self.bits.len())];
            let number = self.circuit.constant(self.rng.u64(..8), 3);
            let net = match self.rng.u32(..5) {
                0 => self.circuit.mux(bit, a, number),
                1 => self.circuit.mux(bit, number, a),
                2 => self.circuit.mux(bit, a, b),
                3 => {
                    let one = self.circuit.resize(bit, 3, false);
                    self.circuit.add(a, one)
                }
                _ => self.circuit.sub(a, number),
            };
            self.words.push(net);
            net
        }
    }

    /// A flag, a word, and outputs that look at the word while the flag is on.
    fn random(seed: u64) -> Circuit {
        let mut circuit = Circuit::new("random");
        let mut rng = Rng::with_seed(seed);
        let mut bits: Vec<Net> = ["a", "b", "c"].map(|name| circuit.input(name, 1)).into();
        let (flag_id, flag) = circuit.register("flag", 1, rng.u64(..2));
        let (word_id, word) = circuit.register("word", 3, rng.u64(..8));
        bits.push(flag);
        let mut pool = Pool { circuit, rng, bits, words: vec![word] };
        let start = pool.bits[pool.rng.usize(..3)];
        (0..6).for_each(|_| {
            pool.bit();
        });
        (0..4).for_each(|_| {
            pool.word();
        });
        let goes_on = pool.bit();
        let comes_on = pool.circuit.mux(flag, goes_on, start);
        pool.bits.push(comes_on);
        let (counted, other) = (pool.word(), pool.word());
        let zero = pool.circuit.constant(0, 3);
        let chosen = pool.bits[pool.rng.usize(..pool.bits.len())];
        let kept = pool.circuit.mux(chosen, counted, zero);
        let next = match pool.rng.u32(..3) {
            0 => pool.circuit.mux(flag, other, kept),
            1 => pool.circuit.mux(comes_on, other, kept),
            _ => kept,
        };
        for name in ["x", "y"] {
            let bit = pool.bit();
            let shown = pool.circuit.and([flag, bit]);
            pool.circuit.output(name, shown);
        }
        pool.circuit.drive(flag_id, comes_on);
        pool.circuit.drive(word_id, next);
        pool.circuit
    }

    #[test]
    fn nobody_sees_the_difference() {
        let mut changed = 0;
        for seed in 0..3000 {
            let circuit = random(seed);
            if let Some(simple) = forget_unseen(&circuit) {
                changed += 1;
                let simple = Design { modules: [simple].into_iter().collect() };
                assert_same(seed, &circuit, simple, 200);
            }
            let design = Design { modules: [circuit.clone()].into_iter().collect() };
            assert_same(seed, &circuit, simplify(design), 200);
        }
        assert!(changed > 100, "only {changed} circuits have a word that is not always seen");
    }
}
