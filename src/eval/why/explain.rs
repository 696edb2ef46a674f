//! From a variable to what wrote it, to the power of that, to the variables it depends on.

use std::collections::{HashMap, HashSet};
use std::rc::Rc;

use super::power::Decided;
use super::sites::Site;
use super::{Cause, Looked, Reason, Subject, Why};
use crate::eval::recorder::Recording;
use crate::eval::scene::Scene;
use crate::model::{self, CoilAction, Edge, Element, Expr, Role, Variable, VariableId};
use crate::types::Type;

/// How many scans are kept in all their detail.
const KEPT_SCANS: usize = 32;

/// An explanation under way.
pub(super) struct Explainer<'w, 'p> {
    pub(super) why: &'w Why<'p>,
    scans: HashMap<usize, Rc<Scan>>,
    /// What has been explained: a variable as it was left by a write of a scan, or as the scan
    /// found it.
    explained: HashSet<(VariableId, usize, Option<usize>)>,
    /// Whether to say of what is off why it has not been set: not where it is off as it should be,
    /// behind a normally closed contact.
    blames_idle_coils: bool,
}

/// A scan in detail.
pub(super) struct Scan {
    start: Vec<i64>,
    pub(super) recording: Recording,
}

impl<'w, 'p> Explainer<'w, 'p> {
    pub(super) fn new(why: &'w Why<'p>) -> Self {
        Explainer { why, scans: HashMap::new(), explained: HashSet::new(), blames_idle_coils: true }
    }

    pub(super) fn scan(&mut self, scan: usize) -> Rc<Scan> {
        if let Some(kept) = self.scans.get(&scan) {
            return Rc::clone(kept);
        }
        if self.scans.len() == KEPT_SCANS {
            self.scans.clear();
        }
        let trace = &self.why.trace;
        let made = Rc::new(Scan { start: trace.start(scan), recording: trace.replay(scan) });
        self.scans.insert(scan, Rc::clone(&made));
        made
    }

    pub(super) fn scene<'a>(&self, scan: &'a Scan) -> Scene<'a> {
        Scene { recording: &scan.recording, start: &scan.start }
    }

    pub(super) fn decided<'a>(&self, scan: &'a Scan) -> Decided<'a, 'p>
    where
        'w: 'a,
    {
        Decided { sites: &self.why.sites, scene: self.scene(scan) }
    }

    /// Why a variable is what it is in a scan when so much has been written, or at its end.
    pub(super) fn variable(
        &mut self,
        id: VariableId,
        scan: usize,
        until: Option<usize>,
        depth: usize,
    ) -> Cause {
        let detail = self.scan(scan);
        let until = until.unwrap_or(detail.recording.writes.len());
        let write = self.last_write(&detail, id, until);
        let variable = &self.why.program.variables[id];
        let mut cause = Cause {
            subject: Subject::Variable(variable.name.to_string()),
            value: self.scene(&detail).value(id, until),
            ty: variable.ty,
            scan,
            told_of: scan,
            since: self.since(id, scan, write.is_some()),
            reason: Reason::Deeper,
            looked: None,
            causes: Vec::new(),
        };
        match variable.role {
            Role::Input => return Cause { reason: Reason::Input, ..cause },
            Role::FirstScan => {
                cause.subject = Subject::Condition("first_scan".to_owned());
                return Cause { reason: Reason::FirstScan, ..cause };
            }
            Role::Output | Role::Local | Role::Member(..) | Role::EdgeMemory => {}
        }
        let idle = match write {
            None => self.idle_setters(&detail, id, cause.value),
            Some(_) => Vec::new(),
        };
        if let (None, Some(before), true) = (write, cause.since, idle.is_empty()) {
            return self.variable(id, before, None, depth);
        }
        if !self.explained.insert((id, scan, write)) {
            return Cause { reason: Reason::Above, ..cause };
        }
        if depth == 0 {
            return cause;
        }
        match write.and_then(|write| detail.recording.writes[write].by) {
            Some(by) => self.written(cause, id, self.why.sites.at(by), depth - 1),
            None => self.kept(cause, id, &idle, depth - 1),
        }
    }

    /// The last write that made a variable what it is. A call writes its presets back, mostly as
    /// they are; an accumulator that it counts is a preset too.
    fn last_write(&self, scan: &Scan, id: VariableId, until: usize) -> Option<usize> {
        let Variable { role, .. } = &self.why.program.variables[id];
        let mut until = until;
        loop {
            let write = scan.recording.last_write(id, until)?;
            let by = scan.recording.writes[write].by;
            let Some(Element::Call(call)) = by.map(|by| self.why.sites.at(by).element) else {
                return Some(write);
            };
            let called = &self.why.program.instances[call.instance];
            let is_same =
                || scan.recording.writes[write].value == self.scene(scan).value(id, write);
            match role {
                Role::Member(_, port)
                    if !called.given[*port]
                        && called.shape.ports[*port].role.is_parameter()
                        && is_same() =>
                {
                    until = write;
                }
                _ => return Some(write),
            }
        }
    }

    /// Since when a variable has had the value that it has in a scan: what the scan found, or
    /// what it left if it wrote.
    fn since(&self, id: VariableId, scan: usize, is_written: bool) -> Option<usize> {
        let is_input = self.why.program.variables[id].role == Role::Input;
        match scan.checked_sub(1) {
            _ if is_written || is_input => self.why.trace.since(id, scan),
            Some(before) => self.why.trace.since(id, before),
            None => None,
        }
    }

    /// Set coils that would have put a variable on, had they had power.
    fn idle_setters(&self, scan: &Scan, id: VariableId, value: i64) -> Vec<Site<'p>> {
        let has_no_power = |site: &Site<'p>| !scan.recording.visit(site.element).power;
        match value {
            0 if self.blames_idle_coils => {
                self.why.sites.setters(id).filter(has_no_power).collect()
            }
            _ => Vec::new(),
        }
    }

    /// Nothing has written the variable in this scan.
    fn kept(&mut self, cause: Cause, id: VariableId, idle: &[Site<'p>], depth: usize) -> Cause {
        let Cause { scan, since, .. } = cause;
        let mut causes: Vec<Cause> =
            since.map(|since| self.variable(id, since, None, depth)).into_iter().collect();
        for site in idle {
            let place = self.place(site);
            causes.push(Cause {
                subject: Subject::IdleCoil(place.text.clone()),
                value: 0,
                ty: Type::Bool,
                scan,
                told_of: scan,
                since: None,
                reason: Reason::Element(place),
                looked: None,
                causes: self.deciders(*site, scan, depth),
            });
        }
        let reason = if since.is_some() { Reason::Kept } else { Reason::Reset };
        Cause { reason, causes, ..cause }
    }

    /// An element has written the variable.
    fn written(&mut self, cause: Cause, id: VariableId, by: Site<'p>, depth: usize) -> Cause {
        let scan = cause.scan;
        match by.element {
            Element::Call(call) => self.call(cause, id, by, call, depth),
            Element::Assign { value, .. } => {
                let mut causes = self.deciders(by, scan, depth);
                causes.extend(self.reads(value, by, scan, Some(id), depth));
                Cause { reason: Reason::Element(self.place(&by)), causes, ..cause }
            }
            Element::Coil { action: CoilAction::Edge(edge, memory), .. } if cause.value == 0 => {
                let causes = self.no_edge(by, scan, *edge, *memory, depth);
                Cause { reason: Reason::Element(self.place(&by)), causes, ..cause }
            }
            Element::Coil { .. }
            | Element::ResetInstance(_)
            | Element::Constant(_)
            | Element::Contact { .. }
            | Element::Edge { .. }
            | Element::Parallel(_)
            | Element::Net(_)
            | Element::OneShot { .. }
            | Element::Invert
            | Element::Compare(..) => {
                let causes = self.deciders(by, scan, depth);
                Cause { reason: Reason::Element(self.place(&by)), causes, ..cause }
            }
        }
    }

    /// Why the power in front of an element does not change as it should: it is not there, or
    /// came earlier.
    fn no_edge(
        &mut self,
        site: Site<'p>,
        scan: usize,
        edge: Edge,
        memory: VariableId,
        depth: usize,
    ) -> Vec<Cause> {
        let power = self.scan(scan).recording.visit(site.element).power;
        match (power == (edge == Edge::Rise), self.why.trace.since(memory, scan)) {
            (true, Some(came)) => self.deciders(site, came, depth),
            _ => self.deciders(site, scan, depth),
        }
    }

    /// What decides the power in front of an element.
    pub(super) fn deciders(&mut self, site: Site<'p>, scan: usize, depth: usize) -> Vec<Cause> {
        let detail = self.scan(scan);
        let found = self.decided(&detail).deciders(site);
        found.into_iter().map(|site| self.decider(site, scan, depth)).collect()
    }

    /// Why an element conducts or does not.
    pub(super) fn decider(&mut self, site: Site<'p>, scan: usize, depth: usize) -> Cause {
        let detail = self.scan(scan);
        let visit = detail.recording.visit(site.element);
        let looked = Looked {
            scan,
            rung: self.why.program.rungs[site.rung].number as usize,
            element: site.number,
        };
        let causes = match site.element {
            Element::Contact { place, negated, .. } => {
                if let Some(variable) = place.as_variable() {
                    let looks = std::mem::replace(&mut self.blames_idle_coils, !negated);
                    let cause = self.variable(variable, scan, Some(visit.start), depth);
                    self.blames_idle_coils = looks;
                    return Cause { looked: Some(looked), ..cause };
                }
                self.looked_at(place, site, scan, depth)
            }
            Element::Edge { place, .. } => self.looked_at(place, site, scan, depth),
            Element::Compare(expr, _) => self.reads(expr, site, scan, None, depth),
            Element::OneShot { edge, memory } if !visit.out => {
                self.no_edge(site, scan, *edge, *memory, depth)
            }
            Element::OneShot { .. } => self.deciders(site, scan, depth),
            Element::Call(call) => {
                let instance = &self.why.program.instances[call.instance];
                let main = call.shape.main_port().expect("it makes power");
                let cause = self.variable(instance.members[main], scan, Some(visit.end), depth);
                return Cause { looked: Some(looked), ..cause };
            }
            Element::Constant(_)
            | Element::Parallel(_)
            | Element::Net(_)
            | Element::Invert
            | Element::Coil { .. }
            | Element::ResetInstance(_)
            | Element::Assign { .. } => Vec::new(),
        };
        Cause {
            subject: Subject::Condition(self.text(site.element)),
            value: self.scene(&detail).conducts(site.element).into(),
            ty: Type::Bool,
            scan,
            told_of: scan,
            since: None,
            reason: Reason::Element(self.place(&site)),
            looked: None,
            causes,
        }
    }

    /// Why the variable of a place is what it is, and its index.
    fn looked_at(
        &mut self,
        place: &model::Place,
        site: Site<'p>,
        scan: usize,
        depth: usize,
    ) -> Vec<Cause> {
        let mut read = Vec::new();
        let detail = self.scan(scan);
        let start = detail.recording.visit(site.element).start;
        self.scene(&detail).variables_of(place, start, &mut read);
        read.into_iter().map(|id| self.variable(id, scan, Some(start), depth)).collect()
    }

    /// The variables that an expression reads. What it adds to itself is shown, not explained:
    /// it would be the same story again.
    fn reads(
        &mut self,
        expr: &Expr,
        site: Site<'p>,
        scan: usize,
        itself: Option<VariableId>,
        depth: usize,
    ) -> Vec<Cause> {
        let detail = self.scan(scan);
        let start = detail.recording.visit(site.element).start;
        let mut read = Vec::new();
        self.scene(&detail).variables(expr, start, &mut read);
        let mut seen = HashSet::new();
        read.retain(|id| seen.insert(*id));
        let explain = |id| {
            let depth = if itself == Some(id) { 0 } else { depth };
            self.variable(id, scan, Some(start), depth)
        };
        read.into_iter().map(explain).collect()
    }
}
