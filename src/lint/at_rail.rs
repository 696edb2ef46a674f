//! A `not` or a one-shot at the left rail, written by somebody who means the contact behind it.

use crate::diagnostic::{Diagnostic, code};
use crate::source::Source;
use crate::syntax::ast::{Edge, Element, ElementKind, File, Item, Reference, Series};

pub(super) fn check(source: &Source, file: &File<'_>, found: &mut Vec<Diagnostic>) {
    let mut rule = Rule { source, found };
    for item in &file.items {
        if let Item::Rung(rung) = item {
            rule.series(&rung.network, true);
        }
    }
}

struct Rule<'a> {
    source: &'a Source,
    found: &'a mut Vec<Diagnostic>,
}

impl Rule<'_> {
    /// A series whose power at the left is always on, or not. The parser bounds the nesting.
    fn series(&mut self, series: &Series<'_>, mut always_on: bool) {
        for (number, element) in series.elements.iter().enumerate() {
            let (name, effect) = match &element.kind {
                ElementKind::Parallel(branches) => {
                    branches.iter().for_each(|branch| self.series(branch, always_on));
                    always_on = false;
                    continue;
                }
                ElementKind::Call(call) => {
                    call.networks().for_each(|network| self.series(network, true));
                    always_on = false;
                    continue;
                }
                // They pass the power on.
                ElementKind::Coil { .. } | ElementKind::Assign { .. } => continue,
                ElementKind::Invert => ("not", "so nothing conducts behind it"),
                ElementKind::OneShot(Edge::Rise) => {
                    ("rising", "so it rises in the first scan only")
                }
                ElementKind::OneShot(Edge::Fall) => ("falling", "so it never falls"),
                _ => {
                    always_on = false;
                    continue;
                }
            };
            if always_on {
                let help = help(&element.kind, series.elements.get(number + 1), self.source);
                self.found.push(
                    Diagnostic::new(
                        code::AT_RAIL,
                        element.span,
                        format!("`{name}` stands where the power is always on"),
                    )
                    .label(effect)
                    .help(help),
                );
            }
            always_on = false;
        }
    }
}

/// What is meant, if a contact follows.
fn help(kind: &ElementKind<'_>, next: Option<&Element<'_>>, source: &Source) -> String {
    let contact = match next.map(|next| &next.kind) {
        Some(ElementKind::Contact { operand, negated: false }) => Some(operand),
        _ => None,
    };
    let text = |operand: &Reference<'_>| source.slice(operand.span()).to_owned();
    match (kind, contact.map(text)) {
        (ElementKind::Invert, Some(name)) => format!(
            "`not` inverts the power from the left; a contact that conducts while `{name}` is 0 is \
             written `!{name}`"
        ),
        (ElementKind::OneShot(edge), Some(name)) => {
            let word = match edge {
                Edge::Rise => "rise",
                Edge::Fall => "fall",
            };
            format!(
                "a one-shot acts on the power from the left; an edge of a contact is written \
                 `{word}({name})`"
            )
        }
        _ => "write it behind the elements that it shall act on".to_owned(),
    }
}
