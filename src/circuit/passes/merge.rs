//! Makes one register of those that always hold the same.
//!
//! Before: any circuit. After: the same outputs in every scan; no two registers take the same net
//! at the same clocks and have the same reset value, but for those that an output shows under their
//! own name: readers look for them, and synthesis merges them without our help.

use std::collections::{HashMap, HashSet};

use super::rebuild::rebuild;
use crate::circuit::{Circuit, Net, Op, Register, RegisterId};
use crate::index::index;

/// The circuit with one register in place of several equal ones.
pub fn merge(circuit: &Circuit) -> Option<Circuit> {
    let kept = kept(circuit);
    if circuit.registers.iter().all(|(id, _)| kept[index(id)] == id) {
        return None;
    }
    let mut copies: HashMap<RegisterId, Net> = HashMap::new();
    Some(rebuild(circuit, |rebuild, _, cell| match cell.op {
        // The first reader of any of them stands behind the register.
        Op::Register(id) => *copies
            .entry(kept[index(id)])
            .or_insert_with_key(|&kept| rebuild.register(kept, cell.width)),
        _ => rebuild.copy(cell),
    }))
}

/// For each register the one that stays in its place.
fn kept(circuit: &Circuit) -> Vec<RegisterId> {
    let shown: HashSet<&str> = circuit.outputs.iter().map(|output| &*output.name).collect();
    let named: HashSet<&str> = circuit.signals.iter().map(|signal| &*signal.name).collect();
    let rank = |register: &Register| match &*register.name {
        name if shown.contains(name) => 0,
        name if named.contains(name) => 1,
        _ => 2,
    };
    let key = |register: &Register| (register.next, register.reset, register.enable);
    let mut best: HashMap<(Net, u64, Option<Net>), RegisterId> = HashMap::new();
    for (id, register) in circuit.registers.iter() {
        let best = best.entry(key(register)).or_insert(id);
        if rank(register) < rank(&circuit.registers[*best]) {
            *best = id;
        }
    }
    let keep = |(id, register): (RegisterId, &Register)| match rank(register) {
        0 => id,
        _ => best[&key(register)],
    };
    circuit.registers.iter().map(keep).collect()
}
