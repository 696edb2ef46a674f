//! A timer that does not wait, a counter that does not count.

use super::index::Index;
use crate::blocks::PortRole;
use crate::diagnostic::{Diagnostic, code};
use crate::model::{ArgumentValue, ExprKind, Instance};

pub(super) fn check(index: &Index, found: &mut Vec<Diagnostic>) {
    for call in index.calls() {
        let instance = &index.program.instances[call.instance];
        for (number, port) in instance.shape.ports.iter().enumerate() {
            // A start that is 0 counts only if it stays.
            let stays_given = match port.role {
                PortRole::Preset { .. } => true,
                PortRole::Loaded { .. } => false,
                _ => continue,
            };
            let argument = index.argument(call.instance, number);
            let is_assigned = !index.writes_of(instance.members[number]).is_empty();
            if is_assigned && !stays_given {
                continue;
            }
            let (span, label) = match argument.map(|argument| (&argument.value, argument.span)) {
                Some((ArgumentValue::Value(expr), span))
                    if matches!(expr.kind, ExprKind::Constant(0)) =>
                {
                    (span, "nothing to wait for")
                }
                None if !is_assigned && !is_tally(index, instance) => {
                    (instance.span, "never given and never assigned")
                }
                _ => continue,
            };
            let message = format!("the preset {} of `{}` is 0", port.name, instance.name);
            found.push(
                Diagnostic::new(code::PRESET_ZERO, span, message)
                    .label(label)
                    .help(format!("give {} a value, or remove the block", port.name)),
            );
        }
    }
}

/// A counter whose count is read: without a preset it counts as well.
fn is_tally(index: &Index, instance: &Instance) -> bool {
    let ports = instance.shape.ports.iter().zip(&instance.members);
    ports.filter(|(port, _)| port.name == "CV").any(|(_, &member)| index.is_read(member))
}
