//! From the tree of a rung to elements with their room.

use super::call::{Call, Fed, Input};
use super::cells::{ElementId, Symbol};
use super::net::{Connection, Net};
use super::node::{Node, Series};
use super::references::{References, Uses, coil_sign};
use super::words::{harmless, lines, written};
use crate::blocks::{self, PortRole};
use crate::source::{Source, Span};
use crate::syntax::ast::{self, ArgumentValue, Edge, ElementKind, Reference};

/// Columns of a name before it goes on in the next line.
const NAME: i32 = 24;
/// Columns of an expression in a box.
const FORMULA: i32 = 32;
/// Columns of what a pin of a block is given, and of a node's name.
const BESIDE: i32 = 16;

/// Builds the elements of one rung.
pub(super) struct Builder<'a, 's> {
    pub source: &'a Source,
    pub comments: &'a [Span],
    pub uses: &'a Uses<'s>,
    /// How many elements there are so far.
    pub elements: ElementId,
}

impl<'s> Builder<'_, 's> {
    pub fn series(&mut self, series: &ast::Series<'s>) -> Series {
        Series::new(series.elements.iter().map(|element| self.element(element)).collect())
    }

    fn element(&mut self, element: &ast::Element<'s>) -> Node {
        let id = self.elements;
        self.elements += 1;
        match &element.kind {
            ElementKind::Constant(true) => Node::wire(id),
            ElementKind::Constant(false) => {
                let label = vec!["FALSE".to_owned()];
                Node::symbol(id, Symbol::Contact(" "), label, References::default())
            }
            ElementKind::FirstScan { negated } => {
                let label = vec!["first_scan".to_owned()];
                Node::symbol(id, contact(*negated), label, References::default())
            }
            ElementKind::Contact { operand, negated } => {
                let writers = self.uses.writers(operand.name.text);
                Node::symbol(id, contact(*negated), self.label(operand), writers)
            }
            ElementKind::Edge { edge, operand } => {
                let sign = match edge {
                    Edge::Rise => "P",
                    Edge::Fall => "N",
                };
                let writers = self.uses.writers(operand.name.text);
                Node::symbol(id, Symbol::Contact(sign), self.label(operand), writers)
            }
            ElementKind::Parallel(branches) => {
                Node::list(id, branches.iter().map(|branch| self.series(branch)).collect())
            }
            ElementKind::OneShot(edge) => {
                let word = match edge {
                    Edge::Rise => "rising",
                    Edge::Fall => "falling",
                };
                Node::symbol(id, Symbol::Operator(word), Vec::new(), References::default())
            }
            ElementKind::Invert => {
                Node::symbol(id, Symbol::Operator("NOT"), Vec::new(), References::default())
            }
            ElementKind::Compare(value) => {
                let writers = self.uses.writers_of_operands(value);
                Node::formula(id, self.formula(element.span), writers, false)
            }
            ElementKind::Coil { action, target } => {
                let readers = self.uses.readers(target.name.text);
                Node::symbol(id, Symbol::Coil(coil_sign(*action)), self.label(target), readers)
            }
            ElementKind::Assign { target, .. } => {
                let readers = self.uses.readers(target.name.text);
                Node::formula(id, self.formula(element.span), readers, true)
            }
            ElementKind::Call(call) => self.call(id, call, element.span),
            ElementKind::Net(net) => self.net(net).into_node(id),
        }
    }

    /// What stands in braces.
    fn formula(&self, span: Span) -> Vec<String> {
        let text = written(self.source, span, self.comments);
        lines(text.trim_matches(['{', '}', ' ']), FORMULA)
    }

    /// A name without back-ticks, and what follows it.
    fn label(&self, reference: &Reference<'s>) -> Vec<String> {
        let after = Span { start: reference.name.span.end, end: reference.span().end };
        let path = written(self.source, after, self.comments);
        lines(&(harmless(reference.name.text) + &path), NAME)
    }

    fn call(&mut self, id: ElementId, call: &ast::Call<'s>, span: Span) -> Node {
        let ends = call.arguments.iter().skip(1).map(|argument| argument.name.span.start);
        let ends = ends.chain([span.end]);
        let given = call.arguments.iter().zip(ends);
        let mut given: Vec<(&str, Fed)> =
            given.map(|(argument, end)| (argument.name.text, self.fed(argument, end))).collect();
        let block = blocks::named(call.kind.text);
        let ports = block.map_or(&[][..], |block| block.ports);
        let main = block.and_then(|block| block.main).unwrap_or("");
        // The order of the ports: a box looks the same wherever it stands.
        let parameters = ports.iter().filter(|port| port.role.is_parameter());
        let inputs = parameters.map(|port| {
            let found = given.iter().position(|(name, _)| *name == port.name);
            let fed = found.map_or(Fed::Open, |index| given.swap_remove(index).1);
            Input { name: port.name.to_owned(), fed }
        });
        let inputs = inputs.collect();
        let outputs = ports
            .iter()
            .filter(|port| port.role == PortRole::Output && port.name != main)
            .map(|port| port.name.to_owned());
        let drawn = Call {
            name: lines(&harmless(call.name.text), NAME),
            kind: harmless(call.kind.text),
            inputs,
            main: main.to_owned(),
            outputs: outputs.collect(),
            references: self.uses.readers(call.name.text),
        };
        drawn.into_node(id)
    }

    /// What an argument, which ends before `end`, gives to its pin.
    fn fed(&mut self, argument: &ast::Argument<'s>, end: u32) -> Fed {
        match &argument.value {
            ArgumentValue::Network(network) => Fed::Circuit(self.series(network)),
            ArgumentValue::Expr(_) | ArgumentValue::List(..) => {
                // The tree does not have the brackets around an expression.
                let span = Span { start: argument.name.span.end, end };
                let text = written(self.source, span, self.comments);
                let text = text.trim_start_matches([':', '=', ' ']);
                let text = text.strip_suffix([',', ')']).unwrap_or(text);
                Fed::Value(lines(text, BESIDE))
            }
        }
    }

    fn net(&mut self, net: &ast::Net<'s>) -> Net {
        let connection = |connection: &ast::Connection<'s>| Connection {
            from: lines(&harmless(connection.from.text), BESIDE),
            to: lines(&harmless(connection.to.text), BESIDE),
            both_ways: connection.both_ways,
            network: self.series(&connection.network),
        };
        Net { connections: net.connections.iter().map(connection).collect() }
    }
}

fn contact(negated: bool) -> Symbol {
    Symbol::Contact(if negated { "/" } else { " " })
}
