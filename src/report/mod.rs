//! What a program says, for people and for tools: its equations, and what depends on what.

mod document;
mod formula;
mod graph;
mod listing;
mod names;
mod order;
mod parts;
mod text;

use crate::equations::{self, Chain, Graph, Order};
use crate::model::Program;
use listing::Listing;
use names::Names;

pub use order::order_summary;

/// The equations of a program and the dependencies between its rungs.
pub struct Report<'p> {
    program: &'p Program,
    listing: Listing,
    names: Names<'p>,
    graph: Graph,
    chain: Chain,
    is_flat: bool,
    order: Option<Order>,
}

impl<'p> Report<'p> {
    /// Reports on a program: in the order of its text, or, if `flat`, each value as a function of
    /// inputs, of what blocks show, and of what the last scan left.
    pub fn new(program: &'p Program, flat: bool) -> Self {
        let equations = equations::lower(program);
        let listing = Listing::new(program, &equations, flat);
        Report {
            program,
            names: Names::new(program, &equations, &listing, flat),
            listing,
            graph: Graph::new(program, &equations),
            chain: Chain::new(program, &equations),
            is_flat: flat,
            order: None,
        }
    }

    /// Says also what the order changes into which the rungs were put before.
    pub fn set_order(&mut self, order: Order) {
        self.order = Some(order);
    }

    fn order(&self) -> Option<order::Names<'_>> {
        let names = |order| order::Names { program: self.program, order };
        self.order.as_ref().map(names)
    }

    /// The number of a rung in the text.
    fn number(&self, rung: u32) -> u32 {
        self.program.rungs[rung as usize].number
    }

    /// What each rung writes, each name once, in the order of the text.
    fn written(&self) -> Vec<Vec<String>> {
        let mut written: Vec<Vec<String>> = vec![Vec::new(); self.program.rungs.len()];
        for equation in &self.listing.equations {
            let names = &mut written[equation.rung as usize];
            let name = self.names.left(&equation.left);
            if !names.contains(&name) {
                names.push(name);
            }
        }
        written
    }
}
