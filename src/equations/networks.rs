//! General networks: the power at the right end as one expression, without a list of all paths.
//!
//! Inner nodes are taken out one by one. What conducted through a node conducts directly then,
//! from each node before it to each node behind it. A way round through a node back to itself adds
//! nothing, so no step needs a loop, and the effort grows with the cube of the nodes at most, not
//! with the number of paths.

use std::collections::HashMap;

use super::lower::{Lowering, Power};
use super::{ExprId, ExprOp};
use crate::model::Net;

/// What conducts from one node to another: paths in parallel, each a series of factors. A path
/// without factors is a wire, a link without paths is none.
type Link = Vec<Power>;

struct Mesh<'l, 'p> {
    lowering: &'l mut Lowering<'p>,
    /// `links[a][b]` leads from `a` to `b`. None leads to the left end, from the right end or from
    /// a node to itself.
    links: Vec<Vec<Link>>,
    /// The expressions made here, by their sorted operands: what conducts both ways is made once.
    series: HashMap<Vec<ExprId>, ExprId>,
    parallel: HashMap<Vec<ExprId>, ExprId>,
}

impl Lowering<'_> {
    /// The factors of what conducts from the left end to the right one. Every connection is
    /// executed, whether power reaches it or not.
    pub(super) fn net(&mut self, net: &Net) -> Power {
        let nodes = net.nodes.len();
        let paths: Vec<Power> = net
            .connections
            .iter()
            .map(|connection| self.series(&connection.network, Vec::new()))
            .collect();
        let mut mesh = Mesh {
            lowering: self,
            links: vec![vec![Link::new(); nodes]; nodes],
            series: HashMap::new(),
            parallel: HashMap::new(),
        };
        for (connection, path) in net.connections.iter().zip(&paths) {
            connection.ways().for_each(|(from, to)| mesh.add(from, to, path));
        }
        let mut inner: Vec<usize> = (0..nodes).filter(|&node| node > Net::RIGHT).collect();
        while let Some(place) = (0..inner.len()).min_by_key(|&place| mesh.cost(inner[place])) {
            mesh.take_out(inner.remove(place));
        }
        match mesh.links[Net::LEFT][Net::RIGHT].len() {
            0 => vec![self.constant(false)],
            _ => mesh.factors(Net::LEFT, Net::RIGHT),
        }
    }
}

impl Mesh<'_, '_> {
    /// One more path between two nodes, unless others make it needless.
    fn add(&mut self, from: usize, to: usize, path: &[ExprId]) {
        let exprs = &self.lowering.equations.exprs;
        let never = path.iter().any(|&factor| matches!(exprs[factor].op, ExprOp::Constant(0)));
        if never || from == to || to == Net::LEFT || from == Net::RIGHT {
            return;
        }
        let link = &mut self.links[from][to];
        let needs = |more: &[ExprId], less: &[ExprId]| less.iter().all(|one| more.contains(one));
        if !link.iter().any(|other| needs(path, other)) {
            link.retain(|other| !needs(other, path));
            link.push(path.to_vec());
        }
    }

    /// The nodes before and behind a node.
    fn neighbours(&self, node: usize) -> (Vec<usize>, Vec<usize>) {
        let all = 0..self.links.len();
        let before = all.clone().filter(|&from| !self.links[from][node].is_empty());
        let behind = all.filter(|&to| !self.links[node][to].is_empty());
        (before.collect(), behind.collect())
    }

    /// How many links replace a node: one or less for what is in series.
    fn cost(&self, node: usize) -> usize {
        let (before, behind) = self.neighbours(node);
        let there_and_back = before.iter().filter(|from| behind.contains(from)).count();
        before.len() * behind.len() - there_and_back
    }

    /// Connects the nodes before a node with those behind it.
    fn take_out(&mut self, node: usize) {
        let (before, behind) = self.neighbours(node);
        let only_once = self.cost(node) == 1;
        let ways = |mesh: &mut Self, from, to| {
            let factors = mesh.factors(from, to);
            // What several links share is one expression.
            if only_once || factors.is_empty() { factors } else { vec![mesh.all(&factors)] }
        };
        let first: Vec<Power> = before.iter().map(|&from| ways(self, from, node)).collect();
        let second: Vec<Power> = behind.iter().map(|&to| ways(self, node, to)).collect();
        for (&from, first) in before.iter().zip(&first) {
            for (&to, second) in behind.iter().zip(&second) {
                let mut path = first.clone();
                path.extend(second.iter().filter(|factor| !first.contains(factor)));
                self.add(from, to, &path);
            }
        }
        for other in 0..self.links.len() {
            self.links[other][node].clear();
            self.links[node][other].clear();
        }
    }

    /// What conducts from one node to another, as factors.
    fn factors(&mut self, from: usize, to: usize) -> Power {
        if let [path] = self.links[from][to].as_slice() {
            return path.clone();
        }
        let link = std::mem::take(&mut self.links[from][to]);
        let paths: Vec<ExprId> = link.iter().map(|path| self.all(path)).collect();
        self.links[from][to] = link;
        let mut key = paths.clone();
        key.sort_unstable();
        let lowering = &mut self.lowering;
        vec![*self.parallel.entry(key).or_insert_with(|| lowering.any(&paths))]
    }

    fn all(&mut self, factors: &[ExprId]) -> ExprId {
        let mut key = factors.to_vec();
        key.sort_unstable();
        let lowering = &mut self.lowering;
        *self.series.entry(key).or_insert_with(|| lowering.all(factors.to_vec()))
    }
}
