//! Writes either-or as a choice.
//!
//! Before: any circuit. After: the same value of every net; what a variable or an output takes is
//! `automatic ? a : b` instead of `automatic & a | ~automatic & b`, and `a ^ b` instead of
//! `a & ~b | ~a & b`. That is how people say it, and synthesis finds the smaller circuit more often.

use std::collections::{HashMap, HashSet};
use std::slice;

use super::rebuild::{Rebuild, rebuild};
use crate::circuit::{Cell, Circuit, Net, Op};
use crate::index::index;

/// How many bits each side may have.
const BITS: usize = 16;

/// The circuit with choices, if something is one.
pub fn decide(circuit: &Circuit) -> Option<Circuit> {
    let shown: HashSet<Net> =
        circuit.roots().chain(circuit.signals.iter().map(|signal| signal.net)).collect();
    let mut choices: HashMap<Net, Choice> = HashMap::new();
    for (net, cell) in circuit.cells().filter(|(net, _)| shown.contains(net)) {
        choices.extend(Choice::of(circuit, cell).map(|choice| (net, choice)));
    }
    if choices.is_empty() {
        return None;
    }
    let readers = readers(circuit);
    choices.retain(|_, choice| {
        // What others read too has to be there anyway.
        let is_own = |side: &Side| side.rest.len() == 1 || readers[index(side.net)] == 1;
        is_own(&choice.on) && is_own(&choice.off)
    });
    if choices.is_empty() {
        return None;
    }
    Some(rebuild(circuit, |rebuild, net, cell| match choices.get(&net) {
        Some(choice) => choice.make(rebuild),
        None => rebuild.copy(cell),
    }))
}

fn readers(circuit: &Circuit) -> Vec<u32> {
    let mut readers = vec![0; circuit.len()];
    circuit.roots().for_each(|net| readers[index(net)] += 1);
    for (_, cell) in circuit.cells() {
        circuit.for_each_operand(cell, |net| readers[index(net)] += 1);
    }
    readers
}

/// What is one thing where a bit is 1, and another where it is 0.
struct Choice {
    select: Net,
    on: Side,
    off: Side,
}

/// One side of an either-or.
struct Side {
    net: Net,
    /// All that has to be 1 but the bit that decides; at least one net.
    rest: Vec<Net>,
}

impl Choice {
    fn of(circuit: &Circuit, cell: Cell) -> Option<Choice> {
        let Cell { op: Op::Or(list), width: 1 } = cell else { return None };
        let [first, second] = circuit.list(list) else { return None };
        let sides = [(first, second), (second, first)];
        sides.into_iter().find_map(|(on, off)| {
            let has = |side: &Net, net: Net| operands(circuit, side).contains(&net);
            let mut inverted = operands(circuit, off).iter().filter_map(|&net| {
                let Op::Not(from) = circuit.cell(net).op else { return None };
                has(on, from).then_some((from, net))
            });
            let (select, unselected) = inverted.next()?;
            let on = Side::without(circuit, on, select)?;
            let off = Side::without(circuit, off, unselected)?;
            Some(Choice { select, on, off })
        })
    }

    fn make(&self, rebuild: &mut Rebuild<'_>) -> Net {
        let select = rebuild.net(self.select);
        let mut side = |side: &Side| {
            let rest: Vec<Net> = side.rest.iter().map(|&net| rebuild.net(net)).collect();
            rebuild.to.and(rest)
        };
        let (on, off) = (side(&self.on), side(&self.off));
        let inverts = |a: Net, b: Net| rebuild.to.cell(a).op == Op::Not(b);
        if inverts(on, off) {
            return rebuild.to.xor(select, off);
        }
        if inverts(off, on) {
            let differs = rebuild.to.xor(select, on);
            return rebuild.to.not(differs);
        }
        rebuild.to.mux(select, on, off)
    }
}

impl Side {
    fn without(circuit: &Circuit, net: &Net, decides: Net) -> Option<Side> {
        let rest = operands(circuit, net).iter().copied();
        let rest: Vec<Net> = rest.filter(|&net| net != decides).collect();
        (!rest.is_empty()).then_some(Side { net: *net, rest })
    }
}

/// What has to be 1 for a net to be 1, if that is not too much.
fn operands<'c>(circuit: &'c Circuit, net: &'c Net) -> &'c [Net] {
    match circuit.cell(*net).op {
        Op::And(list) if circuit.list(list).len() <= BITS => circuit.list(list),
        _ => slice::from_ref(net),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::circuit::passes::gates::assert_held;

    #[test]
    fn every_output_is_what_it_was() {
        assert_held(decide);
    }
}
