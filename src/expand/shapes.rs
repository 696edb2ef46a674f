//! Which state of a block its module holds, and which the program holds for it.

use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use crate::blocks::{PortRole, Shape};
use crate::equations::{Equations, StepKind};
use crate::model::{InstanceId, Program};

/// The shapes of the instances in which the block holds more than its kind says: what a rung could
/// write, and none does but the one that calls it. There it has its place beside what counts it,
/// and becomes as narrow as its presets allow.
pub(super) fn shapes(program: &Program, equations: &Equations) -> HashMap<InstanceId, Arc<Shape>> {
    let mut written = HashSet::new();
    let mut called = HashMap::new();
    for step in &equations.steps {
        match &step.kind {
            StepKind::Assign { target, .. } => {
                written.insert(*target);
            }
            StepKind::Call { instance, shape, .. } => {
                called.insert(*instance, shape);
            }
            StepKind::Reset { .. } => {}
        }
    }
    called.retain(|instance, _| !program.instances[*instance].has_partner);
    let with_more = called.into_iter().filter_map(|(instance, shape)| {
        let members = &program.instances[instance].members;
        let mut more = Shape::clone(shape);
        let mut is_more = false;
        for (port, member) in more.ports.iter_mut().zip(members) {
            let inside = match port.role {
                PortRole::Accumulator(_) | PortRole::Shared { shown: true } => PortRole::Output,
                PortRole::Shared { shown: false } => PortRole::State,
                _ => continue,
            };
            if !written.contains(member) {
                (port.role, is_more) = (inside, true);
            }
        }
        is_more.then(|| (instance, Arc::new(more)))
    });
    with_more.collect()
}
