//! General networks as contacts: by series and parallel, by the bridge, or by taking out nodes.

use super::compile::{Compiler, Done};
use super::tree::{Bridge, Tree};
use crate::model::Net;

/// A connection that is left.
#[derive(Clone)]
struct Way {
    from: usize,
    to: usize,
    both_ways: bool,
    tree: Tree,
}

impl Way {
    fn touches(&self, node: usize) -> bool {
        self.from == node || self.to == node
    }

    fn enters(&self, node: usize) -> bool {
        self.to == node || (self.both_ways && self.from == node)
    }

    fn leaves(&self, node: usize) -> bool {
        self.from == node || (self.both_ways && self.to == node)
    }

    fn other(&self, node: usize) -> usize {
        if self.from == node { self.to } else { self.from }
    }
}

impl Compiler<'_> {
    /// The contacts of a network.
    pub(super) fn net(&mut self, net: &Net) -> Done<Tree> {
        let mut ways = Vec::with_capacity(net.connections.len());
        for connection in &net.connections {
            let tree = match self.all_contacts(&connection.network)? {
                wire if wire.is_wire() => Tree::constant(true),
                tree => tree,
            };
            let (from, to, both_ways) = (connection.from, connection.to, connection.both_ways);
            ways.push(Way { from, to, both_ways, tree });
        }
        loop {
            reduce(&mut ways, net.nodes.len());
            let inner: Vec<usize> = (0..net.nodes.len())
                .filter(|&node| node != Net::LEFT && node != Net::RIGHT)
                .filter(|&node| ways.iter().any(|way| way.touches(node)))
                .collect();
            match *inner.as_slice() {
                [] => {
                    // Reduced, at most one connection is left between the two ends.
                    let tree = ways.pop().map(|way| way.tree);
                    return Ok(tree.unwrap_or_else(|| Tree::constant(false)));
                }
                [a, b] if is_bridge(&ways, a, b) => return self.bridge(ways, a, b),
                _ => self.take_out(&mut ways, &inner)?,
            }
        }
    }

    /// The five arms, and what leads past them.
    fn bridge(&mut self, ways: Vec<Way>, a: usize, b: usize) -> Done<Tree> {
        let arm = |x: usize, y: usize| {
            let way = ways.iter().find(|way| way.touches(x) && way.touches(y));
            way.map(|way| way.tree.clone())
        };
        let present = |tree: Option<Tree>| tree.expect("a bridge has five arms");
        let middle = present(arm(a, b));
        let middle = match middle.single() {
            Some(contact) => contact,
            None => self.flagged(&middle)?,
        };
        let bridge = Tree::Bridge(Box::new(Bridge {
            upper_left: present(arm(Net::LEFT, a)),
            lower_left: present(arm(Net::LEFT, b)),
            middle,
            upper_right: present(arm(a, Net::RIGHT)),
            lower_right: present(arm(b, Net::RIGHT)),
        }));
        Ok(Tree::parallel([bridge].into_iter().chain(arm(Net::LEFT, Net::RIGHT))))
    }

    /// Connects the neighbours of an inner node directly, that of the fewest pairs. No power goes
    /// through a node twice, so that is all that it does.
    fn take_out(&mut self, ways: &mut Vec<Way>, inner: &[usize]) -> Done<()> {
        let count = |node: usize| {
            let entering = ways.iter().filter(|way| way.enters(node)).count();
            entering * ways.iter().filter(|way| way.leaves(node)).count()
        };
        let node = inner.iter().copied().min_by_key(|&node| count(node)).expect("one is left");
        let (mut near, far): (Vec<Way>, Vec<Way>) =
            ways.drain(..).partition(|way| way.touches(node));
        // Each of them will stand in several connections.
        for way in &mut near {
            if way.tree.single().is_none() {
                way.tree = Tree::Contact(self.flagged(&way.tree)?);
            }
        }
        *ways = far;
        for first in near.iter().filter(|way| way.enters(node)) {
            for second in near.iter().filter(|way| way.leaves(node)) {
                let (from, to) = (first.other(node), second.other(node));
                let tree = Tree::series([first.tree.clone(), second.tree.clone()]);
                ways.push(Way { from, to, both_ways: false, tree });
            }
        }
        Ok(())
    }
}

/// True if these are the arms of a bridge, and perhaps one that leads past it.
fn is_bridge(ways: &[Way], a: usize, b: usize) -> bool {
    let has = |from: usize, to: usize| {
        ways.iter().any(|way| !way.both_ways && way.from == from && way.to == to)
    };
    let past = usize::from(has(Net::LEFT, Net::RIGHT));
    let middle = ways.iter().any(|way| way.both_ways && way.touches(a) && way.touches(b));
    middle
        && ways.len() == 5 + past
        && [(Net::LEFT, a), (Net::LEFT, b), (a, Net::RIGHT), (b, Net::RIGHT)]
            .into_iter()
            .all(|(from, to)| has(from, to))
}

/// Takes away what leads nowhere, and joins what stands in series and in parallel.
fn reduce(ways: &mut Vec<Way>, nodes: usize) {
    loop {
        let before = ways.len();
        for way in ways.iter_mut() {
            // Power neither comes back to the left end nor leaves the right one.
            if way.both_ways && (way.to == Net::LEFT || way.from == Net::RIGHT) {
                std::mem::swap(&mut way.from, &mut way.to);
            }
            way.both_ways &= way.from != Net::LEFT && way.to != Net::RIGHT;
        }
        ways.retain(|way| way.from != way.to && way.to != Net::LEFT && way.from != Net::RIGHT);
        join_parallel(ways);
        for node in (0..nodes).filter(|&node| node != Net::LEFT && node != Net::RIGHT) {
            join_series(ways, node);
        }
        if ways.len() == before {
            return;
        }
    }
}

fn join_parallel(ways: &mut Vec<Way>) {
    let mut joined: Vec<Way> = Vec::with_capacity(ways.len());
    for way in ways.drain(..) {
        let same = joined.iter_mut().find(|other| {
            other.both_ways == way.both_ways
                && ((other.from, other.to) == (way.from, way.to)
                    || (way.both_ways && (other.from, other.to) == (way.to, way.from)))
        });
        match same {
            Some(other) => {
                let first = std::mem::replace(&mut other.tree, Tree::WIRE);
                other.tree = Tree::parallel([first, way.tree]);
            }
            None => joined.push(way),
        }
    }
    *ways = joined;
}

/// A node with two connections is a place in a series; one with a single connection leads nowhere.
fn join_series(ways: &mut Vec<Way>, node: usize) {
    let touching: Vec<usize> = (0..ways.len()).filter(|&way| ways[way].touches(node)).collect();
    match *touching.as_slice() {
        [only] => {
            ways.remove(only);
        }
        [one, two] => {
            let (two, one) = (ways.remove(two), ways.remove(one));
            let (ends_one, ends_two) = (one.other(node), two.other(node));
            let join = |first: Way, second: Way, both_ways| {
                let (from, to) = (first.other(node), second.other(node));
                Way { from, to, both_ways, tree: Tree::series([first.tree, second.tree]) }
            };
            if ends_one == ends_two {
                // There and back: power at the one end is all that it brings.
            } else if one.both_ways && two.both_ways {
                ways.push(join(one, two, true));
            } else if one.enters(node) && two.leaves(node) {
                ways.push(join(one, two, false));
            } else if two.enters(node) && one.leaves(node) {
                ways.push(join(two, one, false));
            }
        }
        _ => {}
    }
}
