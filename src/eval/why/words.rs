//! How an element of a program is told to people.

use super::Place;
use super::explain::Explainer;
use super::sites::Site;
use crate::model::{Edge, Element};
use crate::source::Span;

impl<'p> Explainer<'_, 'p> {
    /// Where an element stands.
    pub(super) fn place(&self, site: &Site<'p>) -> Place {
        let rung = &self.why.program.rungs[site.rung];
        let line = span(site.element).map_or(rung.line, |span| self.why.source.line(span.start));
        Place {
            rung: rung.number as usize,
            title: rung.title.clone(),
            line,
            element: site.number,
            text: self.text(site.element),
        }
    }

    /// An element as written, on one line.
    pub(super) fn text(&self, element: &Element) -> String {
        let program = self.why.program;
        if let Some(span) = span(element) {
            let words: Vec<&str> = self.why.source.slice(span).split_whitespace().collect();
            return crate::diagnostic::shortened(&words.join(" ")).into_owned();
        }
        match element {
            Element::Edge { place, edge, .. } => {
                let word = if *edge == Edge::Rise { "rise" } else { "fall" };
                format!("{word}({})", place.name(program))
            }
            Element::OneShot { edge: Edge::Rise, .. } => "rising".to_owned(),
            Element::OneShot { edge: Edge::Fall, .. } => "falling".to_owned(),
            Element::Constant(true) => "TRUE".to_owned(),
            Element::Constant(false) => "FALSE".to_owned(),
            Element::Invert => "not".to_owned(),
            Element::ResetInstance(instance) => {
                format!("(R {})", program.instances[*instance].name)
            }
            Element::Call(call) => {
                let instance = &program.instances[call.instance];
                format!("{}:{}", instance.name, call.shape.block.name)
            }
            Element::Net(_) => "net".to_owned(),
            Element::Parallel(_)
            | Element::Contact { .. }
            | Element::Compare(..)
            | Element::Coil { .. }
            | Element::Assign { .. } => String::new(),
        }
    }
}

/// The place of an element that has one of its own.
fn span(element: &Element) -> Option<Span> {
    match element {
        Element::Contact { span, .. }
        | Element::Compare(_, span)
        | Element::Coil { span, .. }
        | Element::Assign { span, .. } => Some(*span),
        Element::Constant(_)
        | Element::Edge { .. }
        | Element::Parallel(_)
        | Element::OneShot { .. }
        | Element::Invert
        | Element::ResetInstance(_)
        | Element::Call(_)
        | Element::Net(_) => None,
    }
}
