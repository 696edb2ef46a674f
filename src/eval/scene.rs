//! One scan, seen element by element: what lets power pass, and what every variable held when.

use super::recorder::Recording;
use crate::index::index;
use crate::model::{Connection, Edge, Element, Expr, ExprKind, Net, Place, VariableId};

/// One scan of a program.
#[derive(Clone, Copy)]
pub(super) struct Scene<'a> {
    pub(super) recording: &'a Recording,
    /// What every variable held when the scan began.
    pub(super) start: &'a [i64],
}

impl Scene<'_> {
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

    /// True if an element lets power pass, or has power behind it where it makes its own.
    pub(super) fn conducts(&self, element: &Element) -> bool {
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

    pub(super) fn series_conducts(&self, series: &[Element]) -> bool {
        let first = series.iter().rposition(makes_power).unwrap_or(0);
        series[first..].iter().all(|element| is_passed(element) || self.conducts(element))
    }

    /// The nodes of a network to which a conducting path leads.
    pub(super) fn powered(&self, net: &Net) -> Vec<bool> {
        let mut powered = vec![false; net.nodes.len()];
        powered[Net::LEFT] = true;
        while let Some((_, _, to)) = self.next_way(net, &powered, true) {
            powered[to] = true;
        }
        powered
    }

    /// A way from a node with power to one without, over a connection that conducts or not.
    pub(super) fn next_way<'n>(
        &self,
        net: &'n Net,
        powered: &[bool],
        conducts: bool,
    ) -> Option<(&'n Connection, usize, usize)> {
        let ways = net.connections.iter().flat_map(|c| c.ways().map(move |(a, b)| (c, a, b)));
        ways.into_iter().find(|&(connection, from, to)| {
            powered[from] && !powered[to] && self.series_conducts(&connection.network) == conducts
        })
    }
}

/// True for what has power behind it for reasons of its own.
pub(super) fn makes_power(element: &Element) -> bool {
    way(element) == Way::Makes
}

/// True for what passes the power on as it comes.
pub(super) fn is_passed(element: &Element) -> bool {
    way(element) == Way::Passes
}

/// What an element has to do with the power behind it.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Way {
    /// Has power behind it for reasons of its own.
    Makes,
    /// Lets power pass or not.
    Decides,
    /// Passes it on as it comes.
    Passes,
}

fn way(element: &Element) -> Way {
    match element {
        Element::OneShot { .. } | Element::Invert => Way::Makes,
        Element::Call(call) if call.shape.main_port().is_some() => Way::Makes,
        Element::Constant(_)
        | Element::Contact { .. }
        | Element::Edge { .. }
        | Element::Parallel(_)
        | Element::Net(_)
        | Element::Compare(..) => Way::Decides,
        Element::Coil { .. }
        | Element::ResetInstance(_)
        | Element::Assign { .. }
        | Element::Call(_) => Way::Passes,
    }
}
