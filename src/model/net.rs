//! General contact networks: what no nesting of series and parallel can draw.

use super::Series;
use crate::source::Span;

/// Nodes and what connects them. Power enters at the node [`Net::LEFT`] and leaves at
/// [`Net::RIGHT`]; connections alone lead from the one to the other.
#[derive(Debug)]
pub struct Net {
    /// The two ends, then the inner nodes in the order of their first use.
    pub nodes: Vec<Node>,
    /// The connections in text order.
    pub connections: Vec<Connection>,
}

/// A place where connections meet.
#[derive(Debug)]
pub struct Node {
    /// The user's name, known in this network only.
    pub name: String,
    /// Where it is used first; for an end that is not used, the network.
    pub span: Span,
}

/// What stands between two nodes.
#[derive(Debug)]
pub struct Connection {
    /// Index of the node at its left.
    pub from: usize,
    /// Index of the node at its right, another one.
    pub to: usize,
    /// Conducts from right to left too.
    pub both_ways: bool,
    /// Conducts or not, whatever the power: contacts, edges, comparisons, constants and lists.
    pub network: Series,
    /// The place of its nodes and of the arrow.
    pub span: Span,
}

impl Net {
    /// Where the power enters.
    pub const LEFT: usize = 0;
    /// Where the power leaves.
    pub const RIGHT: usize = 1;

    /// Each way in which power may pass a connection: from a node to another one.
    pub fn ways(&self) -> impl Iterator<Item = (usize, usize)> {
        self.connections.iter().flat_map(Connection::ways)
    }

    /// For each node, whether power comes to it if every connection conducts.
    pub fn reached(&self) -> Vec<bool> {
        self.follow(Net::LEFT, self.ways())
    }

    /// For each node, whether its power comes to the right end if every connection conducts.
    pub fn leading(&self) -> Vec<bool> {
        self.follow(Net::RIGHT, self.ways().map(|(from, to)| (to, from)))
    }

    fn follow(&self, start: usize, ways: impl Iterator<Item = (usize, usize)>) -> Vec<bool> {
        let mut next = vec![Vec::new(); self.nodes.len()];
        ways.for_each(|(from, to)| next[from].push(to));
        let mut met = vec![false; self.nodes.len()];
        let mut waiting = vec![start];
        while let Some(node) = waiting.pop() {
            if !std::mem::replace(&mut met[node], true) {
                waiting.extend(&next[node]);
            }
        }
        met
    }
}

impl Connection {
    /// The one or two ways in which power may pass it.
    pub fn ways(&self) -> impl Iterator<Item = (usize, usize)> + use<> {
        let back = self.both_ways.then_some((self.to, self.from));
        [(self.from, self.to)].into_iter().chain(back)
    }
}
