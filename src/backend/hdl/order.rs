//! Puts the statements of a module in the order of the text.

use std::iter::Peekable;
use std::vec::IntoIter;

use super::naming::Naming;
use super::plan::{Origin, Plan, origin};
use crate::circuit::{Circuit, InstanceId, Net};
use crate::index::index;

/// A part of a module's text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Item {
    /// The comment at the head of the section of that index.
    Section(usize),
    /// The wire of a cell and what it computes.
    Wire(Net),
    /// The wires at the outputs of an instance.
    PortWires(InstanceId),
    /// An instance.
    Instance(InstanceId),
    /// The second name of that index.
    Alias(usize),
}

/// Puts the statements in order.
struct Items<'a> {
    circuit: &'a Circuit,
    /// Section of each alias, counted from 1, and its index.
    aliases: Peekable<IntoIter<(usize, usize)>>,
    section: usize,
    items: Vec<Item>,
}

/// Instances, each with the index of the cell at which something of it stands.
type Places = Vec<(usize, InstanceId)>;

/// The text of a circuit: sections in order, each wire at its cell, instances where their last
/// input is there, second names at the end of their section.
pub fn items(circuit: &Circuit, plan: &Plan, naming: &Naming) -> Vec<Item> {
    let mut items = Items::new(circuit, naming);
    items.place(plan, naming);
    items.items
}

impl<'a> Items<'a> {
    fn new(circuit: &'a Circuit, naming: &Naming) -> Items<'a> {
        let mut aliases: Vec<(usize, usize)> = naming
            .aliases
            .iter()
            .enumerate()
            .map(|(place, alias)| (section_of(circuit, alias.net).max(alias.section + 1), place))
            .collect();
        aliases.sort_unstable();
        Items {
            circuit,
            aliases: aliases.into_iter().peekable(),
            section: 0,
            items: Vec::with_capacity(circuit.sections.len() + circuit.signals.len()),
        }
    }

    fn place(&mut self, plan: &Plan, naming: &Naming) {
        let (first_ports, ready) = self.instance_places(plan);
        let mut ready = ready.into_iter().peekable();
        let mut first_ports = first_ports.into_iter().peekable();
        for (net, _) in self.circuit.cells() {
            self.enter_sections(index(net));
            if let Some((_, id)) = first_ports.next_if(|&(first, _)| first == index(net)) {
                self.items.push(Item::PortWires(id));
            }
            if naming.wire(net).is_some() {
                self.items.push(Item::Wire(net));
            }
            while let Some((_, id)) = ready.next_if(|&(last, _)| last <= index(net)) {
                self.items.push(Item::Instance(id));
            }
        }
        self.items.extend(ready.map(|(_, id)| Item::Instance(id)));
        self.enter_sections(usize::MAX);
        self.end_section(usize::MAX);
    }

    /// For each instance, in order, the first cell that reads it, and the cell at which all its
    /// inputs are there.
    fn instance_places(&self, plan: &Plan) -> (Places, Places) {
        let mut first = vec![None; self.circuit.instances.len()];
        let mut declare = Vec::new();
        for (net, cell) in self.circuit.cells() {
            if let Origin::Port(id, _) = origin(cell.op) {
                let first = &mut first[index(id)];
                if plan.is_live(net) && first.is_none() {
                    *first = Some(index(net));
                    declare.push((index(net), id));
                }
            }
        }
        let mut ready: Vec<_> = self
            .circuit
            .instances
            .iter()
            .zip(first)
            .map(|((id, instance), first)| {
                let inputs = instance.inputs.iter().map(|&net| index(net));
                (inputs.chain(first).max().unwrap_or(0), id)
            })
            .collect();
        ready.sort_unstable_by_key(|&(last, id)| (last, id.into_raw()));
        (declare, ready)
    }

    fn enter_sections(&mut self, cell: usize) {
        while let Some(section) = self.circuit.sections.get(self.section)
            && section.start as usize <= cell
        {
            self.end_section(self.section);
            self.items.push(Item::Section(self.section));
            self.section += 1;
        }
    }

    fn end_section(&mut self, section: usize) {
        while let Some((_, alias)) = self.aliases.next_if(|&(place, _)| place <= section) {
            self.items.push(Item::Alias(alias));
        }
    }
}

/// The section of a net, counted from 1; 0 in front of the first.
fn section_of(circuit: &Circuit, net: Net) -> usize {
    circuit.sections.partition_point(|section| section.start as usize <= index(net))
}
