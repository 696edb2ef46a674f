//! Finds the registers that only count one way and are only compared with constants.

use std::collections::{HashMap, HashSet};

use crate::circuit::ranges::{Interval, Ranges};
use crate::circuit::{Cell, Circuit, Net, Op, RegisterId};
use crate::index::index;

/// How many cells the condition of a step may have.
const CONDITION: usize = 500;

/// A register, the words that are computed from it, and what is read of them.
///
/// Every member is the register, a choice between members and constants, or a member moved by one.
/// No step wraps. Nothing but members and observers reads a member, and the register takes a
/// member or a constant.
pub struct Family {
    /// The register.
    pub register: RegisterId,
    /// Its words, in order.
    pub members: Vec<Net>,
    /// The comparisons of its words with constants.
    pub observers: Vec<Observer>,
    /// Which way it counts.
    pub step: Step,
    /// Its words are numbers in two's complement.
    pub signed: bool,
}

/// A comparison with a constant.
pub struct Observer {
    /// The comparison.
    pub net: Net,
    /// The member that is compared.
    pub of: Net,
    /// It follows from knowing whether the member is at least each of these.
    pub thresholds: [i128; 2],
    /// It decides on nothing but whether the very word that it compares is moved.
    pub is_inside: bool,
}

/// A way to count.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Step {
    /// By adding 1.
    Up,
    /// By subtracting 1.
    Down,
}

impl Step {
    /// The word that is moved and the bit that says whether it is, if it is not always.
    pub fn parts(self, circuit: &Circuit, cell: Cell) -> Option<(Net, Option<Net>)> {
        let one = |net: Net| match circuit.cell(net).op {
            Op::Extend { from, signed: false } if circuit.width(from) == 1 => Some(Some(from)),
            Op::Const(1) => Some(None),
            _ => None,
        };
        match (cell.op, self) {
            (Op::Add(a, b), Step::Up) => {
                let right = one(b).map(|bit| (a, bit));
                right.or_else(|| one(a).map(|bit| (b, bit)))
            }
            (Op::Sub(a, b), Step::Down) => one(b).map(|bit| (a, bit)),
            _ => None,
        }
    }
}

/// The families of a circuit.
pub fn families(circuit: &Circuit, ranges: &Ranges) -> Vec<Family> {
    let is_word = |(_, cell): (Net, Cell)| matches!(cell.op, Op::Register(_)) && cell.width > 1;
    if !circuit.cells().any(is_word) {
        return Vec::new();
    }
    let live = reach(circuit, circuit.roots().collect(), usize::MAX, |_| None);
    let live = live.expect("there is no limit");
    let mut search = Search::default();
    for (net, cell) in circuit.cells().filter(|(net, _)| live.contains(net)) {
        search.place(circuit, net, cell);
    }
    search.refuse_readers(circuit);
    let Search { found, refused, .. } = search;
    let mut families: Vec<Family> = found
        .into_values()
        .filter(|found| !refused.contains(&found.register))
        .filter_map(|found| found.family(circuit, ranges))
        .collect();
    families.sort_by_key(|family| index(family.register));
    if !families.is_empty() {
        look_inside(circuit, &mut families);
    }
    families
}

/// A register that may have a family.
struct Found {
    register: RegisterId,
    members: Vec<Net>,
    comparisons: Vec<(Net, Net)>,
}

#[derive(Default)]
struct Search {
    found: HashMap<RegisterId, Found>,
    of: HashMap<Net, RegisterId>,
    refused: HashSet<RegisterId>,
}

impl Search {
    /// Puts a cell into the family of its operands, or ends the family.
    fn place(&mut self, circuit: &Circuit, net: Net, cell: Cell) {
        if let Op::Register(register) = cell.op {
            if cell.width > 1 {
                self.of.insert(net, register);
                let found = Found { register, members: vec![net], comparisons: Vec::new() };
                self.found.insert(register, found);
            }
            return;
        }
        if self.of.is_empty() {
            return;
        }
        let mut parents = Vec::new();
        circuit.for_each_operand(cell, |operand| {
            parents.extend(self.of.get(&operand).map(|&register| (operand, register)));
        });
        let Some(&(parent, register)) = parents.first() else { return };
        let is_one = parents.iter().all(|&(_, other)| other == register);
        let is_constant = |net: Net| circuit.constant_value(net).is_some();
        let is_word = |net: Net| self.of.contains_key(&net) || is_constant(net);
        let found = self.found.get_mut(&register).expect("a family has its register");
        match cell.op {
            Op::Mux { on, off, .. } if is_one && is_word(on) && is_word(off) => {}
            Op::Add(..) | Op::Sub(..)
                if [Step::Up, Step::Down]
                    .iter()
                    .any(|step| step.parts(circuit, cell).is_some())
                    && parents.len() == 1 => {}
            Op::Eq(a, b) | Op::Less { a, b, .. } if is_constant(a) || is_constant(b) => {
                found.comparisons.push((net, parent));
                return;
            }
            _ => {
                self.refused.extend(parents.into_iter().map(|(_, register)| register));
                return;
            }
        }
        found.members.push(net);
        self.of.insert(net, register);
    }

    /// Ends the families whose words are seen from outside, or that take words from outside.
    fn refuse_readers(&mut self, circuit: &Circuit) {
        for net in circuit.shown() {
            self.refused.extend(self.of.get(&net));
        }
        for (id, register) in circuit.registers.iter() {
            let taken = self.of.get(&register.next).copied();
            if taken != Some(id) {
                self.refused.extend(taken);
                if circuit.constant_value(register.next).is_none() {
                    self.refused.insert(id);
                }
            }
        }
    }
}

impl Found {
    fn family(self, circuit: &Circuit, ranges: &Ranges) -> Option<Family> {
        let Found { register, members, comparisons } = self;
        let cells = || members.iter().map(|&net| (net, circuit.cell(net)));
        let counts = |step: Step| cells().any(|(_, cell)| step.parts(circuit, cell).is_some());
        let step = match (counts(Step::Up), counts(Step::Down)) {
            (true, false) => Step::Up,
            (false, true) => Step::Down,
            _ => return None,
        };
        let orders: Vec<bool> = comparisons
            .iter()
            .filter_map(|&(net, _)| match circuit.cell(net).op {
                Op::Less { signed, .. } => Some(signed),
                _ => None,
            })
            .collect();
        let has_sign = members.iter().any(|&net| {
            let interval = ranges.interval(circuit, net);
            interval.signed_width() < interval.unsigned_width()
        });
        let signed = orders.first().copied().unwrap_or(has_sign);
        if orders.iter().any(|&order| order != signed) {
            return None;
        }
        let (lowest, highest) = Interval::full(circuit.width(members[0])).bounds(signed);
        let wraps = cells().any(|(_, cell)| {
            let Some((from, bit)) = step.parts(circuit, cell) else { return false };
            let mut assumptions = ranges.assumptions(circuit);
            let (low, high) = match bit {
                None => assumptions.interval(from).bounds(signed),
                Some(bit) => {
                    match assumptions.under(bit, true, |under| under.interval(from).bounds(signed))
                    {
                        Some(bounds) => bounds,
                        None => return false,
                    }
                }
            };
            if step == Step::Up { high == highest } else { low == lowest }
        });
        if wraps {
            return None;
        }
        let observers = comparisons
            .into_iter()
            .map(|(net, of)| {
                let thresholds = thresholds(circuit, net, of, signed);
                Observer { net, of, thresholds, is_inside: true }
            })
            .collect();
        Some(Family { register, members, observers, step, signed })
    }
}

fn thresholds(circuit: &Circuit, net: Net, of: Net, signed: bool) -> [i128; 2] {
    let number = |net: Net| {
        let bits = circuit.constant_value(net).expect("it is compared with a constant");
        Interval::bits(bits, circuit.width(net)).bounds(signed).0
    };
    match circuit.cell(net).op {
        Op::Less { a, b, .. } if a == of => [number(b); 2],
        Op::Less { a, .. } => [number(a) + 1; 2],
        Op::Eq(a, b) => {
            let number = number(if a == of { b } else { a });
            [number, number + 1]
        }
        _ => unreachable!("these are the comparisons"),
    }
}

/// Finds out which observers decide only on steps of their own family's words, and marks the
/// others.
fn look_inside(circuit: &Circuit, families: &mut [Family]) {
    // For each member that is moved, the bit that decides.
    let mut steps: HashMap<Net, (Net, Option<Net>)> = HashMap::new();
    // For each cell of a condition the only family that it decides for, if there is only one.
    let mut decides: HashMap<Net, Option<usize>> = HashMap::new();
    for (at, family) in families.iter().enumerate() {
        let moved = family.members.iter().filter_map(|&net| {
            family.step.parts(circuit, circuit.cell(net)).map(|parts| (net, parts))
        });
        let moved: Vec<_> = moved.collect();
        let bits = moved.iter().filter_map(|(_, (_, bit))| *bit).collect();
        let Some(condition) = reach(circuit, bits, CONDITION, |_| None) else { continue };
        steps.extend(moved);
        for net in condition {
            let only = decides.entry(net).or_insert(Some(at));
            *only = only.filter(|&only| only == at);
        }
    }
    let instead = |net| steps.get(&net).map(|(from, _)| *from);
    let outside = reach(circuit, circuit.roots().collect(), usize::MAX, instead);
    let outside = outside.expect("there is no limit");
    for (at, family) in families.iter_mut().enumerate() {
        let steps = family.members.iter().filter_map(|net| steps.get(net));
        let moved: Vec<Net> = steps.map(|&(from, _)| from).collect();
        for observer in &mut family.observers {
            observer.is_inside = !outside.contains(&observer.net)
                && decides.get(&observer.net) == Some(&Some(at))
                && moved.iter().all(|&from| from == observer.of);
        }
    }
}

/// What the nets are computed from within the scan, up to a limit. `instead` names the one operand
/// of a net that is followed, if not all are.
fn reach(
    circuit: &Circuit,
    mut open: Vec<Net>,
    limit: usize,
    instead: impl Fn(Net) -> Option<Net>,
) -> Option<HashSet<Net>> {
    let mut seen = HashSet::new();
    while let Some(net) = open.pop() {
        if !seen.insert(net) {
            continue;
        }
        if seen.len() > limit {
            return None;
        }
        match instead(net) {
            Some(operand) => open.push(operand),
            None => circuit.for_each_operand(circuit.cell(net), |operand| open.push(operand)),
        }
    }
    Some(seen)
}
