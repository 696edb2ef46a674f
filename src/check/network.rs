//! Rungs: what stands between the rails.

use super::reference::Resolved;
use super::{Checked, Checker, Reported};
use crate::diagnostic::{Diagnostic, code};
use crate::model::{self, Element, Place, Role, Variable, VariableId};
use crate::source::Span;
use crate::syntax::ast::{self, BinaryOperator, Edge, ElementKind, Reference, Rung, Series};
use crate::types::Type;

/// Where a network stands, which decides what may stand in it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Site {
    /// A rung: everything.
    Rung,
    /// An argument of a call: no outputs, no blocks.
    Argument,
    /// A connection of a general network: only what conducts or not, whatever the power.
    Connection,
    /// An expectation of a test: only what looks and keeps nothing.
    Expectation,
}

impl<'s> Checker<'s> {
    pub(super) fn rung_network(&mut self, rung: &Rung<'s>) -> model::Series {
        let word = Span { start: rung.span.start, end: rung.span.start + 4 };
        let Some(last) = rung.network.elements.last() else {
            let diagnostic = Diagnostic::new(code::EMPTY_BRANCH, word, "the rung is empty")
                .label("nothing follows")
                .help("a rung has contacts and a coil, for instance: start ( motor )");
            self.report(diagnostic);
            return Vec::new();
        };
        let network = self.series(&rung.network, Site::Rung);
        if !has_output(&rung.network) {
            let diagnostic = Diagnostic::new(
                code::NO_OUTPUT,
                word,
                "a rung needs a coil, an assignment or a block",
            )
            .label("this rung drives nothing")
            .help("end it with a coil, for instance: ( lamp )");
            let diagnostic = match &last.kind {
                ElementKind::Edge { edge, .. } => {
                    let (contact, one_shot) = match edge {
                        Edge::Rise => ("rise", "rising"),
                        Edge::Fall => ("fall", "falling"),
                    };
                    diagnostic.also(last.span, "a contact").help(format!(
                        "`{contact}(y)` is a contact; for a coil after an edge write \
                         `{one_shot} (y)` or `({contact} y)`"
                    ))
                }
                ElementKind::Compare(expr) => match assigned(expr) {
                    Some(name) => diagnostic
                        .also(last.span, "a comparison")
                        .help(format!("to write `{name}`, assign with `:=`: {{ {name} := ... }}")),
                    None => diagnostic,
                },
                _ => diagnostic,
            };
            self.report(diagnostic);
        }
        network
    }

    /// A series of elements. What is wrong is reported and left out, so the result counts only if
    /// nothing was.
    pub(super) fn series(&mut self, series: &Series<'s>, site: Site) -> model::Series {
        if series.elements.is_empty() {
            let diagnostic = Diagnostic::new(code::EMPTY_BRANCH, series.span, "a branch is empty")
                .label("nothing stands here")
                .help("write TRUE for a wire, FALSE for an open contact");
            self.report(diagnostic);
        }
        let mut elements = Vec::with_capacity(series.elements.len());
        let mut rest = series.elements.as_slice();
        while let [element, after @ ..] = rest {
            rest = after;
            if self.is_misspelt_edge(element, after) || self.is_element_of_nothing(element, after) {
                rest = &after[1..];
                continue;
            }
            elements.extend(self.element(element, site).ok());
        }
        elements
    }

    fn element(&mut self, element: &ast::Element<'s>, site: Site) -> Checked<Element> {
        self.check_site(element, site)?;
        Ok(match &element.kind {
            ElementKind::Constant(value) => Element::Constant(*value),
            ElementKind::FirstScan { negated } => {
                let place = self.first_scan(element.span).into();
                Element::Contact { place, negated: *negated, span: element.span }
            }
            ElementKind::Contact { operand, negated } => {
                self.contact(operand, *negated, element.span)?
            }
            ElementKind::Edge { edge, operand } => match self.bool_operand(operand)? {
                Operand::Place(place) => {
                    let name = format!("{}_before", place.name(&self.program));
                    let memory = self.edge_memory(name, element.span);
                    Element::Edge { place, edge: *edge, memory }
                }
                Operand::Constant(_) => {
                    let message = "a constant has no edge";
                    let diagnostic = Diagnostic::new(code::NOT_WRITABLE, operand.span(), message)
                        .label("never changes")
                        .help("use a variable, or first_scan for the first scan");
                    return Err(self.report(diagnostic));
                }
            },
            ElementKind::Parallel(branches) => {
                Element::Parallel(branches.iter().map(|branch| self.series(branch, site)).collect())
            }
            ElementKind::OneShot(edge) => Element::OneShot {
                edge: *edge,
                memory: self.edge_memory("power_before".to_owned(), element.span),
            },
            ElementKind::Invert => Element::Invert,
            ElementKind::Compare(expr) => {
                Element::Compare(self.expression(expr, Some(Type::Bool))?, element.span)
            }
            ElementKind::Coil { action, target } => self.coil(*action, target, element.span)?,
            ElementKind::Assign { target, value } => {
                self.assignment(target, value, element.span)?
            }
            ElementKind::Call(call) => Element::Call(self.call(call)?),
            ElementKind::Net(net) => Element::Net(self.net(net, element.span)?),
        })
    }

    fn check_site(&mut self, element: &ast::Element<'s>, site: Site) -> Checked<()> {
        let (problem, help) = match (&element.kind, site) {
            (
                ElementKind::Coil { .. } | ElementKind::Assign { .. } | ElementKind::Call(_),
                Site::Argument,
            ) => return Err(self.output_in_an_argument(element.span)),
            (
                ElementKind::Coil { .. } | ElementKind::Assign { .. } | ElementKind::Call(_),
                Site::Expectation,
            ) => (
                "an expectation cannot hold outputs and blocks",
                "name the contacts that must conduct, for instance: expect motor !lamp",
            ),
            (
                ElementKind::Coil { .. } | ElementKind::Assign { .. } | ElementKind::Call(_),
                Site::Connection,
            ) => (
                "a connection cannot hold outputs and blocks",
                "put it behind the network, or into a rung of its own",
            ),
            (ElementKind::OneShot(_) | ElementKind::Invert, Site::Connection) => (
                "a connection conducts or not, whatever the power",
                "use contacts, such as `!x` and `rise(x)`, or put it behind the network",
            ),
            (ElementKind::Net(_), Site::Connection) => (
                "a network cannot stand in a connection",
                "connect the inner nodes here, under names of their own",
            ),
            (
                ElementKind::Edge { .. }
                | ElementKind::OneShot(_)
                | ElementKind::Invert
                | ElementKind::Net(_),
                Site::Expectation,
            ) => (
                "an expectation looks at one moment only",
                "use contacts, comparisons and lists of them",
            ),
            _ => return Ok(()),
        };
        let diagnostic = Diagnostic::new(code::MISPLACED, element.span, problem)
            .label("cannot stand here")
            .help(help);
        Err(self.report(diagnostic))
    }

    pub(super) fn output_in_an_argument(&mut self, span: Span) -> Reported {
        let problem = "an argument cannot hold outputs and blocks";
        let diagnostic = Diagnostic::new(code::MISPLACED, span, problem)
            .label("cannot stand here")
            .help("put it into a rung of its own and read its result here");
        self.report(diagnostic)
    }

    pub(super) fn contact(
        &mut self,
        operand: &Reference<'s>,
        negated: bool,
        span: Span,
    ) -> Checked<Element> {
        Ok(match self.bool_operand(operand)? {
            Operand::Place(place) => Element::Contact { place, negated, span },
            Operand::Constant(value) => Element::Constant(value != negated),
        })
    }

    fn bool_operand(&mut self, operand: &Reference<'s>) -> Checked<Operand> {
        match self.resolve(operand)? {
            Resolved::Place(place) => {
                let ty = place.ty(&self.program);
                if ty == Type::Bool {
                    return Ok(Operand::Place(place));
                }
                Err(self.contact_of_a_number(operand, ty))
            }
            Resolved::Constant(constant) => match (constant.ty, constant.value) {
                (Some(Type::Bool) | None, 0 | 1) => Ok(Operand::Constant(constant.value == 1)),
                (ty, _) => Err(self.contact_of_a_number(operand, ty.unwrap_or(Type::Dint))),
            },
            Resolved::Instance(instance) => Err(self.instance_is_no_value(instance, operand)),
            Resolved::Array(array) => Err(self.array_is_no_value(array, operand)),
        }
    }

    fn contact_of_a_number(&mut self, operand: &Reference<'s>, ty: Type) -> Reported {
        let name = self.source.slice(operand.span());
        let message = format!("a contact looks at a BOOL, `{name}` is {ty}");
        let diagnostic = Diagnostic::new(code::TYPE_MISMATCH, operand.span(), message)
            .label(format!("a value of type {ty}"))
            .help(format!("compare it, for instance: {{ {name} > 0 }}"));
        self.report(diagnostic)
    }

    /// What an edge remembers of a bit or of the power.
    pub(super) fn edge_memory(&mut self, name: String, span: Span) -> VariableId {
        let role = Role::EdgeMemory;
        self.program.variables.alloc(Variable {
            name: name.into(),
            ty: Type::Bool,
            initial: 0,
            is_initialised: false,
            role,
            address: None,
            span,
        })
    }

    /// The variable behind `first_scan`, made where it is first used.
    fn first_scan(&mut self, span: Span) -> VariableId {
        if let Some(first_scan) = self.first_scan {
            return first_scan;
        }
        let first_scan = self.program.variables.alloc(Variable {
            name: "first_scan".into(),
            ty: Type::Bool,
            initial: 1,
            is_initialised: true,
            role: Role::FirstScan,
            address: None,
            span,
        });
        self.first_scan = Some(first_scan);
        first_scan
    }
}

/// What a contact looks at.
enum Operand {
    Place(Place),
    Constant(bool),
}

fn has_output(series: &Series<'_>) -> bool {
    series.elements.iter().any(|element| match &element.kind {
        ElementKind::Coil { .. } | ElementKind::Assign { .. } | ElementKind::Call(_) => true,
        ElementKind::Parallel(branches) => branches.iter().any(has_output),
        _ => false,
    })
}

/// The name at the left of a comparison that starts as an assignment would, but for its `:`.
fn assigned<'s>(expr: &ast::Expr<'s>) -> Option<&'s str> {
    let ast::ExprKind::Binary(operator, left, _) = &expr.kind else { return None };
    match (&left.kind, operator) {
        (ast::ExprKind::Reference(target), BinaryOperator::Equal) => Some(target.name.text),
        _ => assigned(left),
    }
}
