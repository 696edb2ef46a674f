//! The rungs in the order of what flows between them, instead of that of the text.
//!
//! Who only reads a variable or a block comes behind all that write it. Who writes it stays in the
//! order of the text with the others that do. Rungs that read each other in a loop keep the order
//! of the text among themselves: there a value comes from the last scan. What is free to come at
//! several places comes in the order of the text.

use std::cmp::Reverse;
use std::collections::{BinaryHeap, HashMap, HashSet};

use petgraph::algo::kosaraju_scc;
use petgraph::graph::DiGraph;

use super::graph::{Resource, Use, uses};
use super::lower;
use crate::model::Program;

/// A new order of a program's rungs and what it changes. Rungs are counted from 0, as the text has
/// them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Order {
    /// All rungs.
    pub rungs: Vec<u32>,
    /// Where another value is read than in the order of the text, by rung.
    pub changes: Vec<Change>,
    /// Where a rung reads what the last scan left though another one writes it, by rung.
    pub feedback: Vec<Change>,
    /// What may have other values than in the order of the text.
    pub may_differ: Vec<Resource>,
}

/// A rung reads a resource.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Change {
    /// The rung that reads.
    pub rung: u32,
    /// What it reads.
    pub through: Resource,
    /// The rung whose write it sees in the order of the text; without one the last scan's value.
    pub before: Option<u32>,
    /// The same in the new order.
    pub after: Option<u32>,
}

/// Puts the rungs of a program into the order of what flows between them.
pub fn by_dataflow(program: &mut Program) -> Order {
    let uses = Uses::new(program);
    let rungs = uses.sorted();
    let (before, after) = (uses.seen(&uses.in_text_order()), uses.seen(&rungs));
    let mut changes = Vec::new();
    let mut feedback = Vec::new();
    for (rung, (before, after)) in (0..).zip(before.iter().zip(&after)) {
        for (&(through, before), &(_, after)) in before.iter().zip(after) {
            let change = Change { rung, through, before, after };
            if before != after {
                changes.push(change);
            }
            let writers = &uses.writers[&through];
            if writers.binary_search(&rung).is_err() && after != writers.last().copied() {
                feedback.push(change);
            }
        }
    }
    let may_differ = uses.reached(changes.iter().map(|change| change.rung).collect());
    program.reorder(&rungs);
    Order { rungs, changes, feedback, may_differ }
}

/// What the rungs of a program use.
struct Uses {
    /// For each rung, in order.
    of: Vec<Vec<Use>>,
    /// For each resource that is written, the rungs that do, in order.
    writers: HashMap<Resource, Vec<u32>>,
    /// The rungs that read it.
    readers: HashMap<Resource, Vec<u32>>,
}

impl Uses {
    fn new(program: &Program) -> Self {
        let mut of = vec![Vec::new(); program.rungs.len()];
        let mut writers: HashMap<Resource, Vec<u32>> = HashMap::new();
        let mut readers: HashMap<Resource, Vec<u32>> = HashMap::new();
        for one in uses(program, &lower(program)) {
            // Units of time act in front of all rungs.
            let Some(list) = of.get_mut(one.rung as usize) else { continue };
            list.push(one);
            let users = if one.is_write { &mut writers } else { &mut readers };
            let users = users.entry(one.resource).or_default();
            if users.last() != Some(&one.rung) {
                users.push(one.rung);
            }
        }
        Uses { of, writers, readers }
    }

    fn in_text_order(&self) -> Vec<u32> {
        (0..self.of.len() as u32).collect()
    }

    /// For each rung those that come behind it.
    fn behind(&self) -> Vec<Vec<u32>> {
        let mut behind = vec![Vec::new(); self.of.len()];
        for (resource, writers) in &self.writers {
            for pair in writers.windows(2) {
                behind[pair[0] as usize].push(pair[1]);
            }
            // The last writer stands behind the others; in a loop, the one above is what counts.
            let last = *writers.last().expect("somebody writes it");
            for &reader in self.readers.get(resource).into_iter().flatten() {
                let Err(above) = writers.binary_search(&reader) else { continue };
                behind[last as usize].push(reader);
                if let Some(above) = above.checked_sub(1) {
                    behind[writers[above] as usize].push(reader);
                }
            }
        }
        for list in &mut behind {
            list.sort_unstable();
            list.dedup();
        }
        behind
    }

    fn sorted(&self) -> Vec<u32> {
        let mut behind = self.behind();
        let loops = loops(&behind);
        for (rung, others) in (0..).zip(&mut behind) {
            let is_kept =
                |&other: &u32| other > rung || loops[other as usize] != loops[rung as usize];
            others.retain(is_kept);
        }
        let mut waits_for = vec![0_u32; behind.len()];
        behind.iter().flatten().for_each(|&rung| waits_for[rung as usize] += 1);
        let is_free = |rung: &u32| waits_for[*rung as usize] == 0;
        let mut free: BinaryHeap<Reverse<u32>> =
            (0..behind.len() as u32).filter(is_free).map(Reverse).collect();
        let mut order = Vec::with_capacity(behind.len());
        while let Some(Reverse(rung)) = free.pop() {
            order.push(rung);
            for &other in &behind[rung as usize] {
                waits_for[other as usize] -= 1;
                if waits_for[other as usize] == 0 {
                    free.push(Reverse(other));
                }
            }
        }
        order
    }

    /// For each rung, which write it sees in each resource that it reads and some rung writes: the
    /// newest at its first look, unless it has written it itself by then.
    fn seen(&self, order: &[u32]) -> Vec<Vec<(Resource, Option<u32>)>> {
        let mut newest: HashMap<Resource, u32> = HashMap::new();
        let mut seen = vec![Vec::new(); self.of.len()];
        for &rung in order {
            let mut met = HashSet::new();
            for one in &self.of[rung as usize] {
                let is_first = met.insert(one.resource);
                if !one.is_write && is_first && self.writers.contains_key(&one.resource) {
                    let writer = newest.get(&one.resource).copied();
                    seen[rung as usize].push((one.resource, writer));
                }
            }
            let writes = self.of[rung as usize].iter().filter(|one| one.is_write);
            newest.extend(writes.map(|one| (one.resource, rung)));
        }
        seen
    }

    /// What these rungs write, and what others write that read it, and so on.
    fn reached(&self, mut open: Vec<u32>) -> Vec<Resource> {
        let mut rungs = HashSet::new();
        let mut resources = HashSet::new();
        while let Some(rung) = open.pop() {
            if !rungs.insert(rung) {
                continue;
            }
            for one in self.of[rung as usize].iter().filter(|one| one.is_write) {
                if resources.insert(one.resource) {
                    open.extend(self.readers.get(&one.resource).into_iter().flatten());
                }
            }
        }
        let mut resources: Vec<Resource> = resources.into_iter().collect();
        resources.sort_unstable();
        resources
    }
}

/// For each rung the number of its loop: two rungs are in one if each comes behind the other. Rungs that are
/// in no edge may have any.
fn loops(behind: &[Vec<u32>]) -> Vec<usize> {
    let edges =
        (0..).zip(behind).flat_map(|(rung, others)| others.iter().map(move |&to| (rung, to)));
    let graph = DiGraph::<(), ()>::from_edges(edges);
    let mut loops = vec![0; behind.len()];
    for (number, members) in kosaraju_scc(&graph).into_iter().enumerate() {
        members.into_iter().for_each(|rung| loops[rung.index()] = number);
    }
    loops
}
