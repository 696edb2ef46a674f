//! From words back to the contacts that were drawn.

use super::tree::{Contact, Tree};
use super::word::{Attribute, Word};

/// The contacts of a circuit; nothing if no nesting of series and parallel has these links.
pub fn decode(words: &[Word]) -> Option<Tree> {
    let mut circuit =
        Circuit { nodes: vec![Node { before: 0, part: Tree::WIRE }], ..Circuit::default() };
    for word in words {
        let Word::Contact { negated, attribute, address } = *word else { return None };
        circuit.contact(attribute, Contact { address, negated })?;
    }
    if !circuit.results.is_empty() {
        return None;
    }
    circuit.between(0, circuit.power)
}

/// A point of the circuit: what stands between it and an earlier one.
struct Node {
    before: usize,
    part: Tree,
}

/// The branches of a list so far.
struct List {
    /// The node at its left.
    left: usize,
    branches: Vec<Tree>,
    /// The list in whose branch this one stands as the last part, where that branch's end is
    /// owed by this list.
    outer: Option<Box<List>>,
}

/// The power circuit with points of the drawing instead of bits. Node 0 is the rail.
#[derive(Default)]
struct Circuit {
    nodes: Vec<Node>,
    power: usize,
    lefts: Vec<usize>,
    results: Vec<List>,
}

impl Circuit {
    fn node(&mut self, before: usize, part: Tree) -> usize {
        self.nodes.push(Node { before, part });
        self.nodes.len() - 1
    }

    fn contact(&mut self, attribute: Attribute, contact: Contact) -> Option<()> {
        let left = self.power;
        let right = self.node(left, Tree::Contact(contact));
        let list = if attribute.up { Some(self.results.pop()?) } else { None };
        if attribute.pushes_left() {
            // A contact that ends a list and starts an outer one stands right at the list's left;
            // anywhere else it is that of a bridge.
            if list.as_ref().is_some_and(|list| list.left != left) {
                return None;
            }
            self.lefts.push(left);
        }
        if attribute.ret {
            let start = if attribute.pops_left() { self.lefts.pop()? } else { left };
            let list = self.end_of_branch(start, right, list)?;
            self.results.push(list);
            self.power = start;
        } else {
            self.power = match list {
                Some(list) => self.end_of_list(list, right)?,
                None => right,
            };
        }
        Some(())
    }

    /// A branch from `start` to `right` ends, and joins what was on the stack.
    fn end_of_branch(&mut self, start: usize, right: usize, joined: Option<List>) -> Option<List> {
        let (mut right, mut joined) = (right, joined);
        loop {
            match joined {
                Some(mut list) if list.left == start => {
                    list.branches.push(self.between(start, right)?);
                    return Some(list);
                }
                // A list ends that stands at the end of this branch.
                Some(list) if self.is_behind(list.left, start) => {
                    let (end, outer) = self.close(list, right)?;
                    (right, joined) = (end, outer);
                }
                // The first branch of a list that stands at the end of a branch of `outer`.
                outer => {
                    let branches = vec![self.between(start, right)?];
                    let outer = outer.map(Box::new);
                    return Some(List { left: start, branches, outer });
                }
            }
        }
    }

    /// The last branch of a list ends at `right`, and so do all the lists that it ends.
    fn end_of_list(&mut self, list: List, right: usize) -> Option<usize> {
        let (mut right, mut rest) = (right, Some(list));
        while let Some(list) = rest {
            (right, rest) = self.close(list, right)?;
        }
        Some(right)
    }

    fn close(&mut self, list: List, right: usize) -> Option<(usize, Option<List>)> {
        let List { left, mut branches, outer } = list;
        branches.push(self.between(left, right)?);
        let end = self.node(left, Tree::parallel(branches));
        Some((end, outer.map(|outer| *outer)))
    }

    /// True if `node` is reached from `start` and is another one.
    fn is_behind(&self, node: usize, start: usize) -> bool {
        node != start && self.between(start, node).is_some()
    }

    /// What stands between two nodes.
    fn between(&self, start: usize, end: usize) -> Option<Tree> {
        let mut parts = Vec::new();
        let mut at = end;
        while at != start {
            if at == 0 {
                return None;
            }
            parts.push(self.nodes[at].part.clone());
            at = self.nodes[at].before;
        }
        parts.reverse();
        Some(Tree::series(parts))
    }
}
