//! Declared names that the program does not use, or uses halfway.
//!
//! Tests do not count: what only a test reads is not in the hardware. For a constant they do, as
//! it is text and never hardware.

use super::index::Index;
use crate::diagnostic::{Diagnostic, code};
use crate::model::{Role, Variable, VariableId};

pub(super) fn check(index: &Index, found: &mut Vec<Diagnostic>) {
    for (id, variable) in index.program.variables.iter() {
        if index.is_further_element(id) {
            continue;
        }
        let is_read = index.is_read(id);
        let is_written = !index.writes_of(id).is_empty();
        found.extend(match (variable.role, is_read, is_written) {
            (Role::Input, false, _) => Some(unread_input(index, id, variable)),
            (Role::Output, _, false) if !variable.is_initialised => {
                Some(unwritten_output(index, id, variable))
            }
            (Role::Local, false, false) => Some(unused(index, id, variable)),
            (Role::Local, false, true) => Some(unread(index, id, variable)),
            _ => None,
        });
    }
    unwritten(index, found);
    for constant in index.program.constants.iter().filter(|constant| !constant.is_used) {
        let message = format!("the constant `{}` is declared and never used", constant.name);
        found.push(
            Diagnostic::new(code::UNUSED, constant.span, message)
                .label("nothing names it")
                .help("remove it, or use it"),
        );
    }
}

fn unread_input(index: &Index, id: VariableId, variable: &Variable) -> Diagnostic {
    let message = format!("the input `{}` is never read", index.name(id));
    Diagnostic::new(code::INPUT_NEVER_READ, variable.span, message)
        .label("no rung looks at it")
        .help("remove it, or put its contact into a rung")
}

fn unwritten_output(index: &Index, id: VariableId, variable: &Variable) -> Diagnostic {
    let message = format!("the output `{}` is never written", index.name(id));
    Diagnostic::new(code::OUTPUT_NEVER_WRITTEN, variable.span, message)
        .label("always 0")
        .help("write it in a rung, or give it the value that it shall keep: output y := 0")
}

fn unused(index: &Index, id: VariableId, variable: &Variable) -> Diagnostic {
    let message = format!("`{}` is declared and never used", index.name(id));
    let only_tests = index.is_read_by_tests(id);
    Diagnostic::new(code::UNUSED, variable.span, message)
        .label(if only_tests { "only a test looks at it" } else { "no rung reads or writes it" })
        .help("remove it, or use it")
}

fn unread(index: &Index, id: VariableId, variable: &Variable) -> Diagnostic {
    let message = format!("`{}` is written and never read", index.name(id));
    let only_tests = index.is_read_by_tests(id);
    Diagnostic::new(code::NEVER_READ, variable.span, message)
        .label(if only_tests { "only a test looks at it" } else { "no rung looks at it" })
        .also(index.writes_of(id)[0].span, "written here")
        .help("read it, declare it as an output, or remove it: the hardware does not hold it")
}

/// Variables that a rung reads and nothing writes, each at its declaration.
fn unwritten(index: &Index, found: &mut Vec<Diagnostic>) {
    let mut reported = vec![false; index.program.variables.len()];
    for read in &index.reads {
        let Variable { role, is_initialised, span, .. } = &index.program.variables[read.variable];
        let is_constant =
            *role == Role::Local && !is_initialised && index.writes_of(read.variable).is_empty();
        if is_constant
            && !std::mem::replace(&mut reported[crate::index::index(read.variable)], true)
        {
            let message = format!("nothing writes `{}`", index.name(read.variable));
            found.push(
                Diagnostic::new(code::NEVER_WRITTEN, *span, message)
                    .label("always 0")
                    .also(read.span, "read here")
                    .help("write it in a rung, or declare it as an input or with const"),
            );
        }
    }
}
