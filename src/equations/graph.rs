//! What must stand before what: the dependencies between rungs.

use std::collections::HashMap;

use super::{Equations, ExprId, ExprOp, Step, StepKind};
use crate::blocks::PortRole;
use crate::index::index;
use crate::model::{InstanceId, Program, Role, VariableId};

/// The dependencies between the rungs of a program. A rung depends on rungs above it only.
///
/// It names each place's nearest partners: what follows from other dependencies, such as that of
/// a read on the last write but one, is left out. So there are about as many as reads and writes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Graph {
    /// Sorted by the later rung, then by the earlier one.
    pub dependencies: Vec<Dependency>,
    /// For each rung its level, from 1: the first in which all that it depends on is done.
    pub levels: Vec<u32>,
}

/// One rung has to act after another one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Dependency {
    /// Index of the rung that acts first.
    pub from: u32,
    /// Index of the rung that acts later.
    pub to: u32,
    /// Why.
    pub kind: Kind,
    /// What both use.
    pub through: Resource,
}

/// Why one rung acts after another one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Kind {
    /// The later one reads what the earlier one writes.
    ReadAfterWrite,
    /// The later one writes what the earlier one reads as it was before.
    WriteAfterRead,
    /// Both write: the later one wins.
    WriteAfterWrite,
}

/// What two rungs can both use.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Resource {
    /// An input is read only, any other variable is read and written.
    Variable(VariableId),
    /// A block instance as a whole: a call, a reset and an assignment of a member write it, a look
    /// at a member reads it.
    Instance(InstanceId),
}

/// Who has used a resource so far.
#[derive(Default)]
struct Users {
    writer: Option<u32>,
    /// Since then.
    readers: Vec<u32>,
}

impl Graph {
    /// The graph of a program.
    pub fn new(program: &Program, equations: &Equations) -> Self {
        let mut linker = Linker { users: HashMap::new(), dependencies: Vec::new() };
        for one in uses(program, equations) {
            match one.is_write {
                false => linker.reads(one.rung, one.resource),
                true => linker.writes(one.rung, one.resource),
            }
        }
        let rungs = program.rungs.len();
        let mut dependencies = linker.dependencies;
        // What stands in no rung is done before all of them.
        dependencies.retain(|one| (one.from as usize) < rungs && (one.to as usize) < rungs);
        dependencies.sort_by_key(|one| (one.to, one.from, one.kind, one.through));
        let mut levels = vec![1; rungs];
        for one in &dependencies {
            let after = levels[one.from as usize] + 1;
            let level = &mut levels[one.to as usize];
            *level = after.max(*level);
        }
        Graph { dependencies, levels }
    }
}

/// That a rung reads or writes something.
#[derive(Clone, Copy, Debug)]
pub(super) struct Use {
    pub(super) rung: u32,
    pub(super) resource: Resource,
    pub(super) is_write: bool,
}

/// What the rungs read and write, in the order in which they do.
pub(super) fn uses(program: &Program, equations: &Equations) -> Vec<Use> {
    let live = equations.live();
    let mut uses = Vec::new();
    let mut exprs = equations.exprs.iter().map(|(id, _)| id);
    let mut made = 0;
    for (number, step) in equations.steps.iter().enumerate() {
        let mut add = |resource: Option<Resource>, is_write| {
            uses.extend(resource.map(|resource| Use { rung: step.rung, resource, is_write }));
        };
        let mut read = |expr: ExprId| {
            if let ExprOp::Read { variable, .. } = equations.exprs[expr].op {
                add(resource(program, variable), false);
            }
        };
        for expr in exprs.by_ref().take((step.exprs - made) as usize) {
            if live[index(expr)] {
                equations.operands_of(expr, &mut read);
            }
        }
        made = step.exprs;
        equations.taken_by(number as u32).into_iter().for_each(read);
        for variable in in_place(program, step) {
            add(resource(program, variable), false);
            add(resource(program, variable), true);
        }
        add(written(program, step), true);
    }
    uses
}

/// What one resource stands for; `None` for what one rung has for itself.
fn resource(program: &Program, variable: VariableId) -> Option<Resource> {
    match program.variables[variable].role {
        Role::Input | Role::Output | Role::Local => Some(Resource::Variable(variable)),
        Role::Member(instance, _) => Some(Resource::Instance(instance)),
        Role::EdgeMemory | Role::FirstScan => None,
    }
}

fn written(program: &Program, step: &Step) -> Option<Resource> {
    match step.kind {
        StepKind::Assign { target, .. } => resource(program, target),
        StepKind::Call { instance, .. } | StepKind::Reset { instance, .. } => {
            Some(Resource::Instance(instance))
        }
    }
}

/// The variables of the program that a call reads and writes in place: a shift register's words.
fn in_place(program: &Program, step: &Step) -> Vec<VariableId> {
    let StepKind::Call { instance, shape, .. } = &step.kind else { return Vec::new() };
    let ports = shape.ports.iter().zip(&program.instances[*instance].members);
    let words = ports.filter(|(port, _)| port.role == PortRole::Register);
    words.map(|(_, &variable)| variable).collect()
}

struct Linker {
    users: HashMap<Resource, Users>,
    dependencies: Vec<Dependency>,
}

impl Linker {
    fn reads(&mut self, rung: u32, through: Resource) {
        let users = self.users.entry(through).or_default();
        if users.readers.last() == Some(&rung) {
            return;
        }
        users.readers.push(rung);
        let kind = Kind::ReadAfterWrite;
        let writer = users.writer.filter(|&writer| writer != rung);
        self.dependencies.extend(writer.map(|from| Dependency { from, to: rung, kind, through }));
    }

    fn writes(&mut self, rung: u32, through: Resource) {
        let users = self.users.entry(through).or_default();
        let readers = users.readers.drain(..).map(|reader| (reader, Kind::WriteAfterRead));
        let writer = users.writer.replace(rung).map(|writer| (writer, Kind::WriteAfterWrite));
        let before = readers.chain(writer).filter(|&(from, _)| from != rung);
        self.dependencies.extend(before.map(|(from, kind)| Dependency {
            from,
            to: rung,
            kind,
            through,
        }));
    }
}

impl Equations {
    /// For each expression, whether some step needs it.
    pub(super) fn live(&self) -> Vec<bool> {
        let mut live = vec![false; self.exprs.len()];
        for step in 0..self.steps.len() {
            self.taken_by(step as u32).into_iter().for_each(|expr| live[index(expr)] = true);
        }
        for (expr, _) in self.exprs.iter().rev() {
            if live[index(expr)] {
                self.operands_of(expr, |operand| live[index(operand)] = true);
            }
        }
        live
    }
}
