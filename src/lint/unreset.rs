//! A counter or retentive timer that nothing puts back.

use super::index::Index;
use crate::blocks::PortRole;
use crate::diagnostic::{Diagnostic, code};

pub(super) fn check(index: &Index, found: &mut Vec<Diagnostic>) {
    for call in index.calls() {
        let instance = &index.program.instances[call.instance];
        let Some(resets) = (call.shape.block.keeps)(&call.shape) else { continue };
        let is_used = |name: &&str| {
            let port = instance.shape.port_named(name).expect("a block keeps until its own ports");
            instance.given[port] || !index.writes_of(instance.members[port]).is_empty()
        };
        // A rung that gives the count another value is as good as a reset.
        let is_assigned =
            std::iter::zip(&instance.shape.ports, &instance.members).any(|(port, &member)| {
                matches!(port.role, PortRole::Accumulator(_)) && !index.writes_of(member).is_empty()
            });
        if is_assigned || index.is_reset(call.instance) || resets.iter().any(is_used) {
            continue;
        }
        let title = call.shape.block.title;
        let message = format!("nothing resets the {title} `{}`", instance.name);
        let help = match resets.first() {
            Some(first) => {
                format!("give {first}, or reset it in a rung with (R {})", instance.name)
            }
            None => format!("reset it in a rung with (R {})", instance.name),
        };
        found.push(
            Diagnostic::new(code::NEVER_RESET, instance.span, message)
                .label("keeps its value until the hardware is reset")
                .help(help),
        );
    }
}
