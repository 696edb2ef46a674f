//! Two elements that were meant as one: after a name that is not declared, what follows right after
//! it belongs to the same mistake.

use super::Checker;
use super::names::Entity;
use crate::diagnostic::similar_name;
use crate::syntax::ast::{CoilAction, Element, ElementKind, Name};

impl<'s> Checker<'s> {
    /// True for `Rise(x)`: a contact on nothing, and a coil that was meant as its operand. Tells
    /// of it once.
    pub(super) fn is_misspelt_edge(
        &mut self,
        element: &Element<'s>,
        after: &[Element<'s>],
    ) -> bool {
        let (Some(name), Some(next)) = (plain_contact(element), after.first()) else {
            return false;
        };
        let ElementKind::Coil { action: CoilAction::Plain, .. } = next.kind else { return false };
        let is_right_after = element.span.end == next.span.start;
        let Some(edge) = similar_name(name.text, ["rise", "fall"])
            .filter(|edge| is_right_after || name.text.eq_ignore_ascii_case(edge))
        else {
            return false;
        };
        match self.names.get(name.text) {
            None => {
                let help = format!("is `{edge}` meant? An edge contact is written {edge}(x)");
                let diagnostic = self.names.unknown(name, help);
                self.report(diagnostic);
                true
            }
            Some(Entity::Broken) => true,
            Some(_) => false,
        }
    }

    /// True for `x[i]` where nothing is declared as `x`. Tells of it once.
    pub(super) fn is_element_of_nothing(
        &mut self,
        element: &Element<'s>,
        after: &[Element<'s>],
    ) -> bool {
        let Some(name) = plain_contact(element).filter(|_| looks_like_an_index(element, after))
        else {
            return false;
        };
        match self.names.get(name.text) {
            None => {
                let help = self.names.help(name, " : BOOL[8]");
                let diagnostic = self.names.unknown(name, help);
                self.report(diagnostic);
                true
            }
            entity => matches!(entity, Some(Entity::Broken)),
        }
    }
}

/// True for `x[i]` where `x` is no array: a contact and a list, where an element was meant.
fn looks_like_an_index(element: &Element<'_>, after: &[Element<'_>]) -> bool {
    let Some(next) = after.first() else { return false };
    let is_one_branch =
        matches!(&next.kind, ElementKind::Parallel(branches) if branches.len() == 1);
    plain_contact(element).is_some() && is_one_branch && element.span.end == next.span.start
}

/// The name of a contact without members, bits and indexes.
fn plain_contact<'s>(element: &Element<'s>) -> Option<Name<'s>> {
    match &element.kind {
        ElementKind::Contact { operand, .. } if operand.path.is_empty() => Some(operand.name),
        _ => None,
    }
}
