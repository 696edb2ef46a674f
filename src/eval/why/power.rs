//! What decides the power in front of an element, within one scan.

use super::sites::{Site, Sites};
use crate::eval::scene::{Scene, is_passed, makes_power};
use crate::model::{Connection, Element, Net};

/// One scan, and where its elements stand.
pub(super) struct Decided<'a, 'p> {
    pub(super) sites: &'a Sites<'p>,
    pub(super) scene: Scene<'a>,
}

impl<'p> Decided<'_, 'p> {
    /// The elements that decide the power in front of an element: those that conduct if there is
    /// power, else those that do not. A block, a one-shot or an inverter decides alone for all
    /// that stands before it.
    pub(super) fn deciders(&self, site: Site<'p>) -> Vec<Site<'p>> {
        let power = self.scene.recording.visit(site.element).power;
        let mut found = Vec::new();
        self.before(site, power, &mut found);
        found
    }

    /// The same for the power behind a series that is fed with 1.
    pub(super) fn deciders_of(&self, series: &'p [Element], power: bool) -> Vec<Site<'p>> {
        let mut found = Vec::new();
        self.within(series, power, &mut found);
        found
    }

    fn before(&self, site: Site<'p>, power: bool, found: &mut Vec<Site<'p>>) {
        let ended = self.within(&site.series[..site.index], power, found);
        if let (false, Some(list)) = (ended, site.list) {
            let list = self.sites.get(list);
            if self.scene.recording.visit(list.element).power == power {
                self.before(list, power, found);
            }
        }
    }

    /// Adds the deciders of a part of a series, in text order; true if one of them decides alone.
    fn within(&self, part: &'p [Element], power: bool, found: &mut Vec<Site<'p>>) -> bool {
        let first = part.iter().rposition(makes_power);
        for element in &part[first.unwrap_or(0)..] {
            if is_passed(element) || self.scene.conducts(element) != power {
                continue;
            }
            match element {
                Element::Parallel(branches) if power => {
                    let by_power = self.scene.recording.visit(element).out;
                    let leads = |branch: &&'p Vec<Element>| match branch.last() {
                        Some(last) if by_power => self.scene.recording.visit(last).out,
                        _ => self.scene.series_conducts(branch),
                    };
                    if let Some(branch) = branches.iter().find(leads) {
                        self.within(branch, power, found);
                    }
                }
                Element::Parallel(branches) => {
                    branches.iter().for_each(|branch| {
                        self.within(branch, power, found);
                    });
                }
                Element::Net(net) => self.net(net, power, found),
                Element::Invert => self.before(self.sites.of(element), !power, found),
                Element::Constant(_)
                | Element::Contact { .. }
                | Element::Edge { .. }
                | Element::Compare(..)
                | Element::OneShot { .. }
                | Element::Coil { .. }
                | Element::ResetInstance(_)
                | Element::Assign { .. }
                | Element::Call(_) => found.push(self.sites.of(element)),
            }
        }
        first.is_some()
    }

    /// With power, a path that conducts; without, the connections that would lead on from where
    /// the power has come to.
    fn net(&self, net: &'p Net, power: bool, found: &mut Vec<Site<'p>>) {
        let mut powered = vec![false; net.nodes.len()];
        powered[Net::LEFT] = true;
        let mut came_over: Vec<Option<(&'p Connection, usize)>> = vec![None; net.nodes.len()];
        while let Some((connection, from, to)) = self.scene.next_way(net, &powered, true) {
            powered[to] = true;
            came_over[to] = Some((connection, from));
        }
        if power {
            let mut path = Vec::new();
            let mut node = Net::RIGHT;
            while let Some((connection, from)) = came_over[node] {
                path.push(connection);
                node = from;
            }
            path.iter().rev().for_each(|connection| {
                self.within(&connection.network, true, found);
            });
            return;
        }
        let leading = net.leading();
        let leads_on = |(from, to): (usize, usize)| powered[from] && !powered[to] && leading[to];
        for connection in &net.connections {
            if connection.ways().any(leads_on) {
                self.within(&connection.network, false, found);
            }
        }
    }
}
