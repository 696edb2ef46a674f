//! What lets power pass and what stops it, within one scan.

use super::sites::{Site, Sites};
use crate::eval::recorder::Recording;
use crate::index::index;
use crate::model::{Connection, Edge, Element, Expr, ExprKind, Net, Place, VariableId};

/// One scan, seen element by element.
pub(super) struct Scene<'a, 'p> {
    pub(super) sites: &'a Sites<'p>,
    pub(super) recording: &'a Recording,
    /// What every variable held when the scan began.
    pub(super) start: &'a [i64],
}

impl<'p> Scene<'_, 'p> {
    /// What a variable held when so much had been written in the scan.
    pub(super) fn value(&self, variable: VariableId, until: usize) -> i64 {
        match self.recording.last_write(variable, until) {
            Some(write) => self.recording.writes[write].value,
            None => self.start[index(variable)],
        }
    }

    /// The variables that an expression reads when so much has been written: of an array the
    /// elements that are meant then.
    pub(super) fn variables(&self, expr: &Expr, until: usize, read: &mut Vec<VariableId>) {
        match &expr.kind {
            ExprKind::Read(place) => self.variables_of(place, until, read),
            _ => expr.parts().into_iter().for_each(|part| self.variables(part, until, read)),
        }
    }

    /// The variable of a place, and those of its index.
    pub(super) fn variables_of(&self, place: &Place, until: usize, read: &mut Vec<VariableId>) {
        read.extend(place.variable(&|variable| self.value(variable, until)));
        if let Some(index) = place.index() {
            self.variables(index, until, read);
        }
    }

    /// The elements that decide the power in front of an element: those that conduct if there is
    /// power, else those that do not. A block, a one-shot or an inverter decides alone for all
    /// that stands before it.
    pub(super) fn deciders(&self, site: Site<'p>) -> Vec<Site<'p>> {
        let power = self.recording.visit(site.element).power;
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
            if self.recording.visit(list.element).power == power {
                self.before(list, power, found);
            }
        }
    }

    /// Adds the deciders of a part of a series, in text order; true if one of them decides alone.
    fn within(&self, part: &'p [Element], power: bool, found: &mut Vec<Site<'p>>) -> bool {
        let first = part.iter().rposition(|element| self.makes_power(element));
        for element in &part[first.unwrap_or(0)..] {
            if self.is_passed(element) || self.conducts(element) != power {
                continue;
            }
            match element {
                Element::Parallel(branches) if power => {
                    let by_power = self.recording.visit(element).out;
                    let leads = |branch: &&'p Vec<Element>| match branch.last() {
                        Some(last) if by_power => self.recording.visit(last).out,
                        _ => self.series_conducts(branch),
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

    /// True if an element lets power pass, or has power behind it where it makes its own.
    pub(super) fn conducts(&self, element: &'p Element) -> bool {
        let visit = self.recording.visit(element);
        match element {
            Element::Constant(value) => *value,
            Element::Contact { place, negated, .. } => {
                (place.value(&|v| self.value(v, visit.start)) != 0) != *negated
            }
            Element::Edge { place, edge, memory } => {
                let now = place.value(&|v| self.value(v, visit.start)) != 0;
                let before = self.value(*memory, visit.start) != 0;
                match edge {
                    Edge::Rise => now && !before,
                    Edge::Fall => before && !now,
                }
            }
            Element::Compare(expr, _) => expr.value(&|v| self.value(v, visit.start)) != 0,
            Element::Parallel(branches) => {
                visit.out || branches.iter().any(|branch| self.series_conducts(branch))
            }
            Element::Net(net) => self.powered(net)[Net::RIGHT],
            Element::OneShot { .. } | Element::Invert | Element::Call(_) => visit.out,
            Element::Coil { .. } | Element::ResetInstance(_) | Element::Assign { .. } => true,
        }
    }

    fn series_conducts(&self, series: &'p [Element]) -> bool {
        let first = series.iter().rposition(|element| self.makes_power(element)).unwrap_or(0);
        series[first..].iter().all(|element| self.is_passed(element) || self.conducts(element))
    }

    /// The nodes of a network to which a conducting path leads.
    fn powered(&self, net: &'p Net) -> Vec<bool> {
        let mut powered = vec![false; net.nodes.len()];
        powered[Net::LEFT] = true;
        while let Some((_, _, to)) = self.next_way(net, &powered, true) {
            powered[to] = true;
        }
        powered
    }

    /// A way from a node with power to one without, over a connection that conducts or not.
    fn next_way(
        &self,
        net: &'p Net,
        powered: &[bool],
        conducts: bool,
    ) -> Option<(&'p Connection, usize, usize)> {
        let ways = net.connections.iter().flat_map(|c| c.ways().map(move |(a, b)| (c, a, b)));
        ways.into_iter().find(|&(connection, from, to)| {
            powered[from] && !powered[to] && self.series_conducts(&connection.network) == conducts
        })
    }

    /// With power, a path that conducts; without, the connections that would lead on from where
    /// the power has come to.
    fn net(&self, net: &'p Net, power: bool, found: &mut Vec<Site<'p>>) {
        let mut powered = vec![false; net.nodes.len()];
        powered[Net::LEFT] = true;
        let mut came_over: Vec<Option<(&'p Connection, usize)>> = vec![None; net.nodes.len()];
        while let Some((connection, from, to)) = self.next_way(net, &powered, true) {
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

    /// True for what has power behind it for reasons of its own.
    fn makes_power(&self, element: &Element) -> bool {
        match element {
            Element::OneShot { .. } | Element::Invert => true,
            Element::Call(call) => call.shape.main_port().is_some(),
            Element::Constant(_)
            | Element::Contact { .. }
            | Element::Edge { .. }
            | Element::Parallel(_)
            | Element::Net(_)
            | Element::Compare(..)
            | Element::Coil { .. }
            | Element::ResetInstance(_)
            | Element::Assign { .. } => false,
        }
    }

    /// True for what passes the power on as it comes.
    fn is_passed(&self, element: &Element) -> bool {
        match element {
            Element::Coil { .. } | Element::ResetInstance(_) | Element::Assign { .. } => true,
            Element::Call(_) => !self.makes_power(element),
            Element::Constant(_)
            | Element::Contact { .. }
            | Element::Edge { .. }
            | Element::Parallel(_)
            | Element::Net(_)
            | Element::Compare(..)
            | Element::OneShot { .. }
            | Element::Invert => false,
        }
    }
}
