//! Where each element of a program stands.

use std::collections::HashMap;

use crate::eval::recorder::Place;
use crate::model::{CoilAction, Element, Program, VariableId};

/// Index in [`Sites::all`].
pub(super) type SiteId = usize;

/// An element and its place.
#[derive(Clone, Copy)]
pub(super) struct Site<'p> {
    pub(super) element: &'p Element,
    /// The series that it stands in.
    pub(super) series: &'p [Element],
    /// Its index in that.
    pub(super) index: usize,
    /// The list whose branch the series is; its power feeds it. Other series are fed with 1.
    pub(super) list: Option<SiteId>,
    /// Index of its rung.
    pub(super) rung: usize,
    /// Its number in the rung, in text order, as in [`crate::eval::Flow`].
    pub(super) number: usize,
    /// For a call, its number in the order of execution.
    pub(super) call: Option<usize>,
}

/// The elements of a program.
pub(super) struct Sites<'p> {
    all: Vec<Site<'p>>,
    by_place: HashMap<Place, SiteId>,
    /// The set coils of each variable that has one; those on bits and elements are not followed.
    setters: HashMap<VariableId, Vec<SiteId>>,
    calls: usize,
    /// The first element of the rung that is being looked at.
    first: SiteId,
}

impl<'p> Sites<'p> {
    pub(super) fn new(program: &'p Program) -> Self {
        let mut sites = Sites {
            all: Vec::new(),
            by_place: HashMap::new(),
            setters: HashMap::new(),
            calls: 0,
            first: 0,
        };
        for (rung, written) in program.rungs.iter().enumerate() {
            sites.first = sites.all.len();
            sites.series(&written.network, None, rung);
        }
        sites
    }

    pub(super) fn of(&self, element: &Element) -> Site<'p> {
        self.all[self.by_place[&Place::of(element)]]
    }

    pub(super) fn at(&self, place: Place) -> Site<'p> {
        self.all[self.by_place[&place]]
    }

    pub(super) fn get(&self, id: SiteId) -> Site<'p> {
        self.all[id]
    }

    /// The set coils of a variable.
    pub(super) fn setters(&self, variable: VariableId) -> impl Iterator<Item = Site<'p>> {
        let ids = self.setters.get(&variable).map_or(&[][..], Vec::as_slice);
        ids.iter().map(|&id| self.all[id])
    }

    fn series(&mut self, series: &'p [Element], list: Option<SiteId>, rung: usize) {
        for (index, element) in series.iter().enumerate() {
            let id = self.all.len();
            let number = id - self.first;
            self.all.push(Site { element, series, index, list, rung, number, call: None });
            self.by_place.insert(Place::of(element), id);
            match element {
                Element::Parallel(branches) => {
                    branches.iter().for_each(|branch| self.series(branch, Some(id), rung));
                }
                Element::Net(net) => {
                    let connections = net.connections.iter();
                    connections.for_each(|c| self.series(&c.network, None, rung));
                }
                Element::Call(call) => {
                    self.all[id].call = Some(self.calls);
                    self.calls += 1;
                    call.networks().for_each(|network| self.series(network, None, rung));
                }
                Element::Coil { target, action: CoilAction::Set, .. } => {
                    if let Some(variable) = target.as_variable() {
                        self.setters.entry(variable).or_default().push(id);
                    }
                }
                Element::Constant(_)
                | Element::Contact { .. }
                | Element::Edge { .. }
                | Element::OneShot { .. }
                | Element::Invert
                | Element::Compare(..)
                | Element::Coil { .. }
                | Element::ResetInstance(_)
                | Element::Assign { .. } => {}
            }
        }
    }
}
