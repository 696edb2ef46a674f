//! A counter or retentive timer that nothing puts back.

use super::index::Index;
use crate::blocks::PortRole;
use crate::diagnostic::{Diagnostic, code};

/// The parameters that put a block's value back. A block that has one keeps its value without it.
const RESETS: &[&str] = &["R", "R1", "LD"];

pub(super) fn check(index: &Index, found: &mut Vec<Diagnostic>) {
    for call in &index.calls {
        let instance = &index.program.instances[call.instance];
        let ports = instance.block.ports.iter().zip(&instance.given);
        let mut resets = ports
            .filter(|(port, _)| port.role == PortRole::Circuit && RESETS.contains(&port.name))
            .peekable();
        let Some((first, _)) = resets.peek() else { continue };
        let name = first.name;
        if index.is_reset(call.instance) || resets.any(|(_, given)| *given) {
            continue;
        }
        let message = format!("nothing resets the {} `{}`", instance.block.title, instance.name);
        found.push(
            Diagnostic::new(code::NEVER_RESET, instance.span, message)
                .label("keeps its value until the hardware is reset")
                .help(format!("give {name}, or reset it in a rung with (R {})", instance.name)),
        );
    }
}
