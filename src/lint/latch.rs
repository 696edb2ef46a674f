//! Half a latch: set and never reset, or reset and never set.

use super::index::{Index, Written};
use super::walk::{Write, Writing};
use crate::diagnostic::{Diagnostic, code};
use crate::model::Role;

pub(super) fn check(index: &Index, found: &mut Vec<Diagnostic>) {
    for Written { variable: id, part, writes } in index.written() {
        let Some(&first) = writes.iter().find(|write| write.part == part) else { continue };
        let variable = &index.program.variables[id];
        // A coil is another rule's business, an assignment may be the other half, and what nobody
        // reads has been reported as that.
        let is_half = writes.iter().all(|write| write.how == first.how);
        if !is_half || (variable.role == Role::Local && !index.is_read(id)) {
            continue;
        }
        let name = index.part_name(id, part);
        found.extend(match first.how {
            Writing::Set => Some(never_reset(&name, first)),
            Writing::Reset => Some(never_set(&name, first, index.initial(part))),
            Writing::Coil | Writing::Assign => None,
        });
    }
}

fn never_reset(name: &str, set: Write) -> Diagnostic {
    Diagnostic::new(code::SET_WITHOUT_RESET, set.span, format!("`{name}` is set and never reset"))
        .label("once on, it stays on until the hardware is reset")
        .help(format!("reset it with (R {name}), or use a coil that follows the power"))
}

fn never_set(name: &str, reset: Write, initial: i64) -> Diagnostic {
    let label = match initial {
        0 => "off in any case",
        _ => "once off, it stays off until the hardware is reset",
    };
    Diagnostic::new(code::RESET_WITHOUT_SET, reset.span, format!("`{name}` is reset and never set"))
        .label(label)
        .help(format!("set it with (S {name}), or use a coil that follows the power"))
}
