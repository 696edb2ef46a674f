//! A coil and a set or reset coil on one bit: the coil undoes what the latch keeps.

use super::index::{Index, Written};
use super::walk::{Write, Writing};
use crate::diagnostic::{Diagnostic, code};

pub(super) fn check(index: &Index, found: &mut Vec<Diagnostic>) {
    for Written { variable, part, writes } in index.written() {
        let mut writes = writes.iter().filter(|write| write.part == part);
        let is_latch = |write: &&Write| matches!(write.how, Writing::Set | Writing::Reset);
        let coil = writes.clone().find(|write| write.how == Writing::Coil);
        let (Some(coil), Some(latch)) = (coil, writes.find(is_latch)) else { continue };
        let kind = if latch.how == Writing::Set { "set" } else { "reset" };
        let message = format!("`{}` has a coil and a {kind} coil", index.part_name(variable, part));
        found.push(
            Diagnostic::new(code::COIL_AND_LATCH, latch.span, message)
                .label(format!("a {kind} coil, to be kept"))
                .also(coil.span, "a coil, which writes it in every scan")
                .help("use set and reset coils alone, or put the condition into the coil's rung"),
        );
    }
}
