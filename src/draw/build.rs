//! From the tree of a rung to elements with their room.

use super::call::{Call, Fed};
use super::cells::{ElementId, Form, Symbol};
use super::net::{Connection, Net};
use super::node::{Node, Series};
use super::pins::Pins;
use super::references::{References, Uses, coil_sign};
use super::words::{harmless, lines, written};
use crate::blocks::{self, PortRole};
use crate::eval::{Reading, Seen};
use crate::source::{Source, Span};
use crate::syntax::ast::{
    self, ArgumentValue, BinaryOperator, Edge, ElementKind, Expr, ExprKind, Reference,
};

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
    /// The elements of the rung in the scan that is shown, if one is.
    pub seen: Option<&'a [Seen]>,
    /// How many elements there are so far.
    pub elements: ElementId,
}

impl<'s> Builder<'_, 's> {
    pub fn series(&mut self, series: &ast::Series<'s>) -> Series {
        Series::new(series.elements.iter().map(|element| self.element(element)).collect())
    }

    fn element(&mut self, element: &ast::Element<'s>) -> Node {
        let id = self.next();
        match &element.kind {
            ElementKind::FirstScan { negated } => {
                let label = vec!["first_scan".to_owned()];
                Node::symbol(id, normally(*negated), label, References::default())
            }
            ElementKind::Contact { operand, negated } => {
                self.contact(id, operand, normally(*negated))
            }
            ElementKind::Edge { edge, operand } => {
                let sign = match edge {
                    Edge::Rise => "P",
                    Edge::Fall => "N",
                };
                self.contact(id, operand, Symbol::Contact(sign))
            }
            ElementKind::Constant(conducts) => constant(id, *conducts),
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
                Node::formula(id, self.formula(element.span), self.values(id), writers, false)
            }
            ElementKind::Coil { action, target } => {
                let readers = self.uses.readers(target.name.text);
                Node::symbol(id, Symbol::Coil(coil_sign(*action)), self.label(target), readers)
            }
            ElementKind::Assign { target, .. } => {
                let readers = self.uses.readers(target.name.text);
                Node::formula(id, self.formula(element.span), self.values(id), readers, true)
            }
            ElementKind::Call(call) => self.call(id, call, element.span),
            ElementKind::Net(net) => self.net(net).into_node(id),
        }
    }

    fn contact(&self, id: ElementId, operand: &Reference<'s>, symbol: Symbol) -> Node {
        Node::symbol(id, symbol, self.label(operand), self.uses.writers(operand.name.text))
    }

    /// The number of the next element.
    fn next(&mut self) -> ElementId {
        self.elements += 1;
        self.elements - 1
    }

    /// What stands in braces.
    fn formula(&self, span: Span) -> Vec<String> {
        let text = written(self.source, span, self.comments);
        lines(text.trim_matches(['{', '}', ' ']), FORMULA)
    }

    /// What is to be seen beside an element.
    fn readings(&self, id: ElementId) -> &[Reading] {
        let seen = self.seen.and_then(|seen| seen.get(id as usize));
        seen.map_or(&[], |seen| &seen.readings)
    }

    /// The room of each value of a comparison or an assignment.
    fn values(&self, id: ElementId) -> Vec<i32> {
        self.readings(id).iter().map(|reading| Form::Named.room(reading)).collect()
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
        let block = blocks::named(call.kind.text);
        let ports = block.map_or(&[][..], |block| block.ports);
        let is_circuit = |name: &str| {
            ports.iter().any(|port| port.name == name && port.role == PortRole::Circuit)
        };
        let given = call.arguments.iter().zip(ends).map(|(argument, end)| {
            let name = argument.name.text;
            let circuit = if is_circuit(name) { self.circuit(&argument.value) } else { None };
            (name, circuit.map_or_else(|| self.value(argument, end), Fed::Circuit))
        });
        let given: Vec<(&str, Fed)> = given.collect();
        let main = block.and_then(|block| block.main).unwrap_or("");
        let readings = self.readings(id);
        let pins = block.map(|block| Pins::of(block, call, given, readings));
        let Pins { inputs, outputs } = pins.unwrap_or_default();
        let drawn = Call {
            name: lines(&harmless(call.name.text), NAME),
            kind: harmless(call.kind.text),
            inputs,
            main: main.to_owned(),
            outputs,
            references: self.uses.readers(call.name.text),
        };
        drawn.into_node(id)
    }

    /// The circuit that a pin is given, which may look like an expression.
    fn circuit(&mut self, value: &ArgumentValue<'s>) -> Option<Series> {
        let mut contacts = Vec::new();
        match value {
            ArgumentValue::Network(network) => return Some(self.series(network)),
            ArgumentValue::List(values, _) => self.contacts(values.first()?, &mut contacts)?,
            ArgumentValue::Expr(value) => self.contacts(value, &mut contacts)?,
        }
        Some(Series::new(contacts))
    }

    /// `a`, `TRUE`, and `a /b`, which looks like a division.
    fn contacts(&mut self, value: &Expr<'s>, contacts: &mut Vec<Node>) -> Option<()> {
        let (operand, negated) = match &value.kind {
            ExprKind::Reference(operand) => (operand, false),
            ExprKind::Binary(BinaryOperator::Divide, left, right) => {
                self.contacts(left, contacts)?;
                let ExprKind::Reference(operand) = &right.kind else { return None };
                (operand, true)
            }
            ExprKind::Literal(literal) => {
                contacts.push(constant(self.next(), is_one(literal.text)));
                return Some(());
            }
            _ => return None,
        };
        let id = self.next();
        contacts.push(self.contact(id, operand, normally(negated)));
        Some(())
    }

    /// What an argument, which ends before `end`, gives to its pin.
    fn value(&self, argument: &ast::Argument<'s>, end: u32) -> Fed {
        // The tree does not have the brackets around an expression.
        let span = Span { start: argument.name.span.end, end };
        let text = written(self.source, span, self.comments);
        let text = text.trim_start_matches([':', '=', ' ']);
        let text = text.strip_suffix([',', ')']).unwrap_or(text);
        Fed::Value(lines(text, BESIDE))
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

/// A contact that is normally open, or closed.
fn normally(closed: bool) -> Symbol {
    Symbol::Contact(if closed { "/" } else { " " })
}

/// A wire, or a contact that is always open.
fn constant(id: ElementId, conducts: bool) -> Node {
    match conducts {
        true => Node::wire(id),
        false => {
            let label = vec!["FALSE".to_owned()];
            Node::symbol(id, normally(false), label, References::default())
        }
    }
}

/// True if a literal is 1 in any of its spellings.
fn is_one(literal: &str) -> bool {
    let digits = literal.rsplit('#').next().unwrap_or(literal).replace('_', "");
    literal.eq_ignore_ascii_case("TRUE") || digits.trim_start_matches('0') == "1"
}
