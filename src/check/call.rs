//! Calls of function blocks: each argument as its parameter asks.

use std::sync::Arc;

use super::function::is_function;
use super::names::Entity;
use super::network::Site;
use super::{Checked, Checker, Reported};
use crate::blocks::{self, Follows, Port, PortRole, Shape};
use crate::diagnostic::{Diagnostic, code, shortened, similar_name};
use crate::model::{
    Argument, ArgumentValue, Call, Element, Expr, ExprKind, InstanceId, VariableId,
};
use crate::quantity::{self, time_text};
use crate::source::Span;
use crate::syntax::ast::{self, BinaryOperator, LiteralKind, Series};
use crate::types::Type;

impl<'s> Checker<'s> {
    pub(super) fn call(&mut self, call: &ast::Call<'s>) -> Checked<Call> {
        let Some(Entity::Instance(instance)) = self.names.get(call.name.text) else {
            return Err(Reported);
        };
        let declared = &self.program.instances[instance];
        let mut shape = declared.shape.clone();
        if declared.has_partner {
            // A kind of which there is no block, and a third kind, were reported where the
            // instances were declared.
            let first = declared.shape.block;
            let kinds = [Some(first.name), first.partner];
            let block = blocks::named(call.kind.text).ok_or(Reported)?;
            if !kinds.contains(&Some(block.name)) {
                return Err(Reported);
            }
            shape = Arc::new(Shape::new(block, shape.chosen.clone()));
            if block.name != first.name {
                return self.second_call(call, instance, shape);
            }
        }
        let mut arguments: Vec<Argument> = Vec::new();
        let mut names: Vec<ast::Name<'s>> = Vec::new();
        for argument in &call.arguments {
            let first = names.iter().find(|name: &&ast::Name| name.text == argument.name.text);
            if let Some(first) = first {
                let message = format!("{} is given twice", argument.name.text);
                let diagnostic = Diagnostic::new(code::BAD_ARGUMENT, argument.name.span, message)
                    .label("given again")
                    .also(first.span, "given here first")
                    .help("keep one of them");
                self.report(diagnostic);
                continue;
            }
            names.push(argument.name);
            if shape.block.settings.iter().any(|setting| setting.name == argument.name.text) {
                continue; // Checked when the instance was declared.
            }
            let Ok(port) = self.parameter(&shape, argument.name) else { continue };
            let value = match shape.ports[port].role.range() {
                Some(_) => self.preset(&argument.value, &shape, port),
                None => self.circuit(&argument.value),
            };
            if let Ok(value) = value {
                let span = argument.name.span.to(argument.value.span());
                arguments.push(Argument { port, value, span });
            }
        }
        self.start_values(instance, &arguments);
        let is_start = |argument: &mut Argument| shape.ports[argument.port].role.is_loaded();
        let starts = arguments.extract_if(.., is_start).collect();
        arguments.extend(self.pulses(&shape, call.kind));
        Ok(Call { instance, shape, arguments, starts })
    }

    /// The second call of a pair of counters: the first one has said everything.
    fn second_call(
        &mut self,
        call: &ast::Call<'s>,
        instance: InstanceId,
        shape: Arc<Shape>,
    ) -> Checked<Call> {
        if let [first, ..] = call.arguments.as_slice() {
            let name = call.name.text;
            let message = format!("the first call of `{name}` gives the arguments of both");
            let diagnostic = Diagnostic::new(code::BAD_ARGUMENT, first.name.span, message)
                .label("given in a second call")
                .also(self.program.instances[instance].span, "called here first")
                .help(format!("write {name}:{}(), and give everything above", call.kind.text));
            return Err(self.report(diagnostic));
        }
        Ok(Call { instance, shape, arguments: Vec::new(), starts: Vec::new() })
    }

    /// Gives the members their values at reset, which may be those of presets then. A start value
    /// that is worked out from another block's counts as 0 unless that is called further up.
    fn start_values(&mut self, instance: InstanceId, arguments: &[Argument]) {
        let called = &self.program.instances[instance];
        let initial = |variable: VariableId| self.program.variables[variable].initial;
        let starts = called.shape.starts(|port| {
            let given = arguments.iter().find(|argument| argument.port == port);
            match &given?.value {
                ArgumentValue::Value(expr) => Some(expr.value(&initial)),
                ArgumentValue::Network(_) => None,
            }
        });
        for ((&member, start), port) in called.members.iter().zip(starts).zip(&called.shape.ports) {
            // A register has the initial values of its own declaration.
            if port.role != PortRole::Register {
                self.program.variables[member].initial = start;
            }
        }
    }

    fn parameter(&mut self, shape: &Shape, name: ast::Name<'s>) -> Checked<usize> {
        let is_parameter = |port: &usize| shape.ports[*port].role.is_parameter();
        if let Some(port) = shape.port_named(name.text).filter(is_parameter) {
            return Ok(port);
        }
        let block = shape.block;
        let parameters = || {
            let ports = shape.ports.iter().filter(|port| port.role.is_parameter());
            let settings = block.settings.iter().map(|setting| setting.name);
            ports.map(|port| port.name).chain(settings)
        };
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
        shape: &Shape,
        port: usize,
    ) -> Checked<ArgumentValue> {
        let expr = match value {
            ast::ArgumentValue::Expr(expr) => expr,
            ast::ArgumentValue::Network(Series { span, .. })
            | ast::ArgumentValue::List(_, span) => {
                let port = &shape.ports[port];
                let message = format!("{} takes a value of type {}", port.name, port.ty);
                let diagnostic = Diagnostic::new(code::BAD_ARGUMENT, *span, message)
                    .label("a network or list")
                    .help("give a number or time, a variable or an expression");
                return Err(self.report(diagnostic));
            }
        };
        self.value_of_parameter(expr, shape, port).map(ArgumentValue::Value)
    }

    /// What a call gives to a number or time of its block, or a rung assigns to it: a constant has
    /// to lie in the range of that parameter.
    pub(super) fn value_of_parameter(
        &mut self,
        expr: &ast::Expr<'s>,
        shape: &Shape,
        port: usize,
    ) -> Checked<Expr> {
        let port = &shape.ports[port];
        if port.ty != Type::Time
            && let ast::ExprKind::Literal(literal) = expr.kind
            && literal.kind == LiteralKind::Time
        {
            return Err(self.time_for_a_count(shape, port.name, literal));
        }
        let Some((low, high)) = port.role.range() else {
            return self.expression(expr, Some(port.ty));
        };
        // A number of which no type says how large it may be: the range of the parameter does.
        let checked = match port.ty != Type::Time && self.takes_any_type(expr) {
            true => Err(self.number(expr)?),
            false => Ok(self.expression(expr, Some(port.ty))?),
        };
        let constant = match &checked {
            Ok(expr) => expr.constant().map(i128::from),
            Err(number) => Some(*number),
        };
        if let Some(constant) = constant
            && !(low.into()..=high.into()).contains(&constant)
        {
            return Err(self.preset_out_of_range(expr.span, constant, shape, port, (low, high)));
        }
        let number = |value| Expr { ty: port.ty, kind: ExprKind::Constant(value as i64) };
        Ok(checked.unwrap_or_else(number))
    }

    fn preset_out_of_range(
        &mut self,
        span: Span,
        value: i128,
        shape: &Shape,
        port: &Port,
        (low, high): (i64, i64),
    ) -> Reported {
        let (unit, shown) = match port.ty {
            Type::Time => {
                let tick = i128::from(self.program.tick_ns);
                (" ticks", value.checked_mul(tick).map_or_else(String::new, time_text))
            }
            _ => ("", value.to_string()),
        };
        let (_, widest) = Type::Dint.range();
        let fits_a_size = (i128::from(high)..=widest.into()).contains(&value);
        let help = match port.follows {
            Follows::TypeOf(size) if fits_a_size => {
                format!("use a value in that range, or give {size} := DINT for up to {widest}")
            }
            _ => "use a value in that range".to_owned(),
        };
        let message = format!("{} of {} is {low} to {high}{unit}", port.name, shape.block.name);
        let diagnostic = Diagnostic::new(code::OUT_OF_RANGE, span, message)
            .label(format!("this is {shown}"))
            .help(help);
        self.report(diagnostic)
    }

    /// Other makers' timers take a number of units, where IEC timers take a time.
    fn time_for_a_count(
        &mut self,
        shape: &Shape,
        port: &str,
        literal: ast::Literal<'s>,
    ) -> Reported {
        let unit = shape.unit_ns(self.program.tick_ns).map(i128::from);
        let help = match (unit, quantity::time_ns(literal.text)) {
            (Some(unit), Some(ns)) if ns % unit == 0 => {
                format!("it counts units of {}: {port} := {}", time_text(unit), ns / unit)
            }
            (Some(unit), _) => format!("it counts units of {}", time_text(unit)),
            (None, _) => "write how often it has to count, without a unit".to_owned(),
        };
        let message = format!("{port} of {} is a number, not a time", shape.block.name);
        let diagnostic =
            Diagnostic::new(code::TYPE_MISMATCH, literal.span, message).label("a time").help(help);
        self.report(diagnostic)
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
            // `a (y)` looks like a function and is a contact and a coil.
            ast::ExprKind::Function(name, _) if !is_function(name.text) => {
                self.names.find(*name).map_err(|diagnostic| self.report(*diagnostic))?;
                Err(self.output_in_an_argument(expr.span))
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
