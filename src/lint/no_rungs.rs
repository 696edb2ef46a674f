//! A program that does nothing at all.

use crate::diagnostic::{Diagnostic, code};
use crate::syntax::ast::{File, Item};

/// True if the program has no rungs.
pub(super) fn check(file: &File<'_>, found: &mut Vec<Diagnostic>) -> bool {
    if file.items.iter().any(|item| matches!(item, Item::Rung(_))) {
        return false;
    }
    let header = file.items.iter().find_map(|item| match item {
        Item::Header(header) => Some(header),
        _ => None,
    });
    found.extend(header.map(|header| {
        let message = format!("the program `{}` has no rungs", header.name.text);
        Diagnostic::new(code::NO_RUNGS, header.name.span, message)
            .label("does nothing")
            .help("write what it does, for instance: rung start !stop ( motor )")
    }));
    true
}
