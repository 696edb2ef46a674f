//! Calls of function blocks: each argument as its parameter asks.

use super::names::Entity;
use super::network::Site;
use super::{Checked, Checker, Reported};
use crate::blocks::{Block, PortRole};
use crate::diagnostic::{Diagnostic, code, shortened, similar_name};
use crate::model::{Argument, ArgumentValue, Call, Element, ExprKind, InstanceId, VariableId};
use crate::source::Span;
use crate::syntax::ast::{self, BinaryOperator, LiteralKind, Series};
use crate::types::Type;

impl<'s> Checker<'s> {
    pub(super) fn call(&mut self, call: &ast::Call<'s>) -> Checked<Call> {
        let Some(Entity::Instance(instance)) = self.names.get(call.name.text) else {
            return Err(Reported);
        };
        let block = self.program.instances[instance].block;
        let mut arguments: Vec<Argument> = Vec::new();
        let mut places: Vec<Span> = Vec::new();
        for argument in &call.arguments {
            let Ok(port) = self.parameter(block, argument.name) else { continue };
            if let Some(first) = arguments.iter().position(|other| other.port == port) {
                let message = format!("{} is given twice", argument.name.text);
                let diagnostic = Diagnostic::new(code::BAD_ARGUMENT, argument.name.span, message)
                    .label("given again")
                    .also(places[first], "given here first")
                    .help("keep one of them");
                self.report(diagnostic);
                continue;
            }
            let value = match block.ports[port].role {
                PortRole::Preset { low, high } => {
                    self.preset(&argument.value, block, port, low, high)
                }
                _ => self.circuit(&argument.value),
            };
            if let Ok(value) = value {
                let span = argument.name.span.to(argument.value.span());
                arguments.push(Argument { port, value, span });
                places.push(argument.name.span);
            }
        }
        self.start_values(instance, &arguments);
        Ok(Call { instance, arguments })
    }

    /// Gives the members their values at reset, which may be those of presets then. A start value
    /// that is worked out from another block's counts as 0 unless that is called further up.
    fn start_values(&mut self, instance: InstanceId, arguments: &[Argument]) {
        let called = &self.program.instances[instance];
        let initial = |variable: VariableId| self.program.variables[variable].initial;
        let starts = called.block.starts(|port| {
            let given = arguments.iter().find(|argument| argument.port == port);
            match given.map(|argument| &argument.value) {
                Some(ArgumentValue::Value(expr)) => expr.value(&initial),
                _ => initial(called.members[port]),
            }
        });
        for (&member, start) in called.members.iter().zip(starts) {
            self.program.variables[member].initial = start;
        }
    }

    fn parameter(&mut self, block: &'static Block, name: ast::Name<'s>) -> Checked<usize> {
        let is_parameter = |port: &usize| block.ports[*port].role.is_parameter();
        if let Some(port) = block.port_named(name.text).filter(is_parameter) {
            return Ok(port);
        }
        let parameters =
            || block.ports.iter().filter(|port| port.role.is_parameter()).map(|port| port.name);
        let message = format!("{} has no parameter `{}`", block.name, shortened(name.text));
        let help = match similar_name(name.text, parameters()) {
            Some(similar) => format!("is `{similar}` meant?"),
            None if matches!(name.text, "IN" | "CU" | "CD" | "CLK" | "S" | "S1") => {
                "the power that arrives is the block's input: put the contacts before it".to_owned()
            }
            None => match parameters().collect::<Vec<_>>().as_slice() {
                [] => format!("write it without: {}()", block.name),
                [only] => format!("its parameter is {only}"),
                several => format!("its parameters are {}", several.join(", ")),
            },
        };
        let diagnostic = Diagnostic::new(code::BAD_ARGUMENT, name.span, message)
            .label("not a parameter")
            .help(help);
        Err(self.report(diagnostic))
    }

    fn preset(
        &mut self,
        value: &ast::ArgumentValue<'s>,
        block: &'static Block,
        port: usize,
        low: i64,
        high: i64,
    ) -> Checked<ArgumentValue> {
        let port = &block.ports[port];
        let expr = match value {
            ast::ArgumentValue::Expr(expr) => expr,
            ast::ArgumentValue::Network(Series { span, .. })
            | ast::ArgumentValue::List(_, span) => {
                let message = format!("{} takes a value of type {}", port.name, port.ty);
                let diagnostic = Diagnostic::new(code::BAD_ARGUMENT, *span, message)
                    .label("a network or list")
                    .help("give a number or time, a variable or an expression");
                return Err(self.report(diagnostic));
            }
        };
        let checked = self.expression(expr, Some(port.ty))?;
        if let ExprKind::Constant(constant) = checked.kind
            && !(low..=high).contains(&constant)
        {
            let message = format!("{} of {} is {low} to {high}", port.name, block.name);
            let diagnostic = Diagnostic::new(code::OUT_OF_RANGE, expr.span, message)
                .label(format!("this is {constant}"))
                .help("use a value in that range");
            return Err(self.report(diagnostic));
        }
        Ok(ArgumentValue::Value(checked))
    }

    /// A network, also where it looks like an expression or a list of constants.
    fn circuit(&mut self, value: &ast::ArgumentValue<'s>) -> Checked<ArgumentValue> {
        let expr = match value {
            ast::ArgumentValue::Network(network) => {
                return Ok(ArgumentValue::Network(self.series(network, Site::Argument)));
            }
            ast::ArgumentValue::List(items, _) if items.len() == 1 => &items[0],
            ast::ArgumentValue::List(_, span) => {
                let diagnostic =
                    Diagnostic::new(code::BAD_ARGUMENT, *span, "a network is needed here")
                        .label("a list of values")
                        .help("separate branches by |, for instance: [ a | b ]");
                return Err(self.report(diagnostic));
            }
            ast::ArgumentValue::Expr(expr) => expr,
        };
        Ok(ArgumentValue::Network(self.contacts(expr)?))
    }

    /// Contacts that look like an expression: `a`, `TRUE`, and `a /b`, which looks like a division
    /// and is a series with a normally closed contact.
    fn contacts(&mut self, expr: &ast::Expr<'s>) -> Checked<Vec<Element>> {
        match &expr.kind {
            ast::ExprKind::Reference(reference) => {
                Ok(vec![self.contact(reference, false, expr.span)?])
            }
            ast::ExprKind::Literal(literal) if literal.kind != LiteralKind::Time => {
                let (_, value) = self.constant(expr, Some(Type::Bool))?;
                Ok(vec![Element::Constant(value == 1)])
            }
            ast::ExprKind::Binary(BinaryOperator::Divide, left, right)
                if let ast::ExprKind::Reference(right) = &right.kind =>
            {
                let mut contacts = self.contacts(left)?;
                // The mark before the contact stands somewhere between the two.
                contacts.push(self.contact(right, true, right.span())?);
                Ok(contacts)
            }
            _ => {
                let diagnostic =
                    Diagnostic::new(code::BAD_ARGUMENT, expr.span, "a network is needed here")
                        .label("an expression")
                        .help("put the expression in braces: { ... }");
                Err(self.report(diagnostic))
            }
        }
    }
}
