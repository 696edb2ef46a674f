//! Coils and assignments: what a rung writes, and what it may not.

use std::sync::Arc;

use super::reference::Resolved;
use super::{Checked, Checker};
use crate::blocks::Shape;
use crate::diagnostic::{Diagnostic, code};
use crate::model::{self, CoilAction, Element, Place, Role, Variable};
use crate::source::Span;
use crate::syntax::ast::{self, Edge, Reference};
use crate::syntax::written_name;
use crate::types::Type;

impl<'s> Checker<'s> {
    pub(super) fn coil(
        &mut self,
        action: ast::CoilAction,
        target: &Reference<'s>,
        span: Span,
    ) -> Checked<Element> {
        let place = match self.resolve(target)? {
            Resolved::Instance(instance) if action == ast::CoilAction::Reset => {
                self.resettable(instance, span)?;
                return Ok(Element::ResetInstance(instance));
            }
            resolved => self.writable(resolved, target)?,
        };
        let (name, ty) = (place.name(&self.program), place.ty(&self.program));
        if ty != Type::Bool {
            let message = format!("a coil writes a BOOL, `{name}` is {ty}");
            let diagnostic = Diagnostic::new(code::TYPE_MISMATCH, target.span(), message)
                .label(format!("of type {ty}"))
                .help(format!("assign to it, for instance: {{ {name} := 1 }}"));
            return Err(self.report(diagnostic));
        }
        let memory = |checker: &mut Self| {
            let name = format!("{}_power_before", place.name(&checker.program));
            checker.edge_memory(name, span)
        };
        let action = match action {
            ast::CoilAction::Plain => CoilAction::Plain,
            ast::CoilAction::Negated => CoilAction::Negated,
            ast::CoilAction::Set => CoilAction::Set,
            ast::CoilAction::Reset => CoilAction::Reset,
            ast::CoilAction::Rise => CoilAction::Edge(Edge::Rise, memory(self)),
            ast::CoilAction::Fall => CoilAction::Edge(Edge::Fall, memory(self)),
        };
        Ok(Element::Coil { target: place, action, span })
    }

    fn resettable(&mut self, instance: model::InstanceId, span: Span) -> Checked<()> {
        let instance = &self.program.instances[instance];
        let block = instance.shape.block;
        if block.can_reset {
            return Ok(());
        }
        let message = format!("the {} `{}` cannot be reset", block.title, instance.name);
        let diagnostic = Diagnostic::new(code::MISPLACED, span, message)
            .label("a reset of an off-delay timer")
            .help(how_to_put_back(instance));
        Err(self.report(diagnostic))
    }

    pub(super) fn assignment(
        &mut self,
        target: &Reference<'s>,
        value: &ast::Expr<'s>,
        span: Span,
    ) -> Checked<Element> {
        let resolved = self.resolve(target);
        let place = resolved.and_then(|resolved| self.writable(resolved, target));
        let parameter = place.as_ref().ok().and_then(|place| self.parameter_at(place));
        let value = match parameter {
            Some((shape, port)) => self.value_of_parameter(value, &shape, port),
            None => {
                let want = place.as_ref().ok().map(|place| place.ty(&self.program));
                self.expression(value, want)
            }
        };
        Ok(Element::Assign { target: place?, value: value?, span })
    }

    /// The number or time of a block that a place is.
    fn parameter_at(&self, place: &Place) -> Option<(Arc<Shape>, usize)> {
        let variable = &self.program.variables[place.as_variable()?];
        let Role::Member(instance, port) = variable.role else { return None };
        let shape = &self.program.instances[instance].shape;
        shape.ports[port].role.range().map(|_| (shape.clone(), port))
    }

    /// The place, if a rung may write it.
    fn writable(&mut self, resolved: Resolved, target: &Reference<'s>) -> Checked<Place> {
        let name = target.name.text;
        let (problem, label, help) = match resolved {
            Resolved::Constant(_) => (
                format!("the constant `{name}` cannot be written"),
                "a constant",
                "declare it with var or output".to_owned(),
            ),
            Resolved::Instance(instance) => {
                let instance = &self.program.instances[instance];
                (
                    format!("`{name}` is a block ({}), not a variable", instance.shape.block.name),
                    "a block instance",
                    how_to_put_back(instance),
                )
            }
            Resolved::Array(array) => return Err(self.array_is_no_value(array, target)),
            Resolved::Place(place) => {
                let Variable { role, .. } = self.program.variables[place.declared()];
                match role {
                    Role::Output | Role::Local => return Ok(place),
                    Role::Member(instance, port) => {
                        match self.unassignable_member(instance, port) {
                            None => return Ok(place),
                            Some(problem) => problem,
                        }
                    }
                    Role::Input | Role::EdgeMemory | Role::FirstScan => (
                        format!("the input `{name}` cannot be written"),
                        "an input",
                        "declare it with var or output, or write another variable".to_owned(),
                    ),
                }
            }
        };
        let diagnostic =
            Diagnostic::new(code::NOT_WRITABLE, target.span(), problem).label(label).help(help);
        Err(self.report(diagnostic))
    }

    /// Why a member cannot be assigned, if it cannot.
    fn unassignable_member(
        &self,
        instance: model::InstanceId,
        port: usize,
    ) -> Option<(String, &'static str, String)> {
        let instance = &self.program.instances[instance];
        let member = &instance.shape.ports[port];
        let name = format!("{}.{}", instance.name, member.name);
        if member.role.is_loaded() {
            return None;
        }
        if !member.role.is_parameter() {
            return Some((
                format!("`{name}` is an output of the block {}", instance.shape.block.name),
                "written by the block alone",
                how_to_put_back(instance),
            ));
        }
        instance.given[port].then(|| {
            (
                format!("`{name}` is given in the call"),
                "given anew in every scan",
                format!("leave {} out of the call", member.name),
            )
        })
    }
}

/// How a program puts a block back to its start.
fn how_to_put_back(instance: &model::Instance) -> String {
    let name = written_name(&instance.name);
    match instance.shape.block.can_reset {
        true => format!("to reset it write (R {name})"),
        false => format!("to end the delay, assign the preset: {{ {name}.ACC := {name}.PRE }}"),
    }
}
