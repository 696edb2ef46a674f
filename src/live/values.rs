//! The lists beside the ladder: what can be worked and what can be watched.

use super::Session;
use super::layout::LISTS;
use crate::draw::harmless;
use crate::model::{InstanceId, Program, Role, VariableId};
use crate::quantity;
use crate::types::Type;

/// A row of a list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Entry {
    /// A variable and its value.
    Variable(VariableId),
    /// A block with its members.
    Instance(InstanceId),
}

/// Inputs, outputs, and what is kept inside.
pub(super) fn lists(program: &Program) -> [Vec<Entry>; LISTS] {
    let with = |role| program.with_role(role).map(|(id, _)| Entry::Variable(id));
    let instances = program.instances.iter().filter(|(_, instance)| !instance.is_hidden);
    let instances = instances.map(|(id, _)| Entry::Instance(id));
    let inside = instances.chain(with(Role::Local)).collect();
    [with(Role::Input).collect(), with(Role::Output).collect(), inside]
}

/// The name of a row, and whether what it shows is on.
pub(super) fn name(session: &Session<'_>, entry: Entry) -> (String, bool) {
    let program = session.program();
    match entry {
        Entry::Variable(id) => (harmless(&program.variables[id].name), session.value(id) != 0),
        Entry::Instance(id) => {
            let instance = &program.instances[id];
            let main = instance.shape.main_port().map(|port| instance.members[port]);
            (harmless(&instance.name), main.is_some_and(|main| session.value(main) != 0))
        }
    }
}

/// The value of a row.
pub(super) fn value(session: &Session<'_>, entry: Entry) -> String {
    match entry {
        Entry::Variable(id) => text(session.program(), id, session.value(id)),
        Entry::Instance(id) => members(session, id),
    }
}

/// A value of a variable: a time with its unit, anything else in decimal.
pub(super) fn text(program: &Program, variable: VariableId, value: i64) -> String {
    match program.variables[variable].ty {
        Type::Time => quantity::ticks_text(value, program.tick_ns),
        _ => value.to_string(),
    }
}

/// The members of a block, what it puts out in front of what it is given.
fn members(session: &Session<'_>, instance: InstanceId) -> String {
    let program = session.program();
    let instance = &program.instances[instance];
    let ports = instance.shape.ports.iter().zip(&instance.members);
    let (given, shown): (Vec<_>, Vec<_>) =
        ports.filter(|(port, _)| port.role.is_member()).partition(|(port, _)| port.role.is_input());
    let words = shown.into_iter().chain(given).map(|(port, &member)| {
        format!("{} {}", port.name, text(program, member, session.value(member)))
    });
    words.collect::<Vec<_>>().join("  ")
}
