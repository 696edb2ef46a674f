//! Header, clock, constants and block instances.

use std::sync::Arc;

use super::names::{Constant, Entity, not_a_constant};
use super::{Checked, Checker};
use crate::blocks::{self, PortRole, Shape, Start};
use crate::diagnostic::{Diagnostic, code, shortened, similar_name};
use crate::model::{self, ExprKind, Instance, InstanceId, Role, Variable};
use crate::quantity;
use crate::source::Span;
use crate::syntax::ast::{self, ElementKind, File, Item, Series};
use crate::types::Type;

/// Characters of the longest program name.
const LONGEST_PROGRAM_NAME: usize = 64;
const DEFAULT_TICK_NS: u64 = 1_000_000;

impl<'s> Checker<'s> {
    pub(super) fn declare_header(&mut self, file: &File<'s>) {
        let headers: Vec<_> = file
            .items
            .iter()
            .filter_map(|item| if let Item::Header(header) = item { Some(header) } else { None })
            .collect();
        let Some((first, others)) = headers.split_first() else {
            let end = self.source.text().len();
            let (start, label) = match file.items.is_empty() {
                true => (end, "the file ends here"),
                false => (0, "no header stands before this"),
            };
            let diagnostic = Diagnostic::new(
                code::NO_LADDER,
                Span::new(start, start),
                "the file does not say `ladder NAME`",
            )
            .label(label)
            .help("a program starts with a line such as: ladder conveyor");
            self.report(diagnostic);
            return;
        };
        for other in others {
            let diagnostic =
                Diagnostic::new(code::NO_LADDER, other.name.span, "a file holds one program")
                    .label("a second header")
                    .also(first.name.span, "the first header")
                    .help("move one of them into a file of its own");
            self.report(diagnostic);
        }
        if let Err(why) = program_name(first.name.text) {
            let message = "the program's name cannot name a module and its files";
            let diagnostic = Diagnostic::new(code::BAD_PROGRAM_NAME, first.name.span, message)
                .label(why)
                .help("a good name is short: letters, digits and underscores, a letter first");
            self.report(diagnostic);
        }
        self.program.name = first.name.text.to_owned();
        self.program.title = first.title.map(|title| title.text.to_owned());
    }

    pub(super) fn declare_clock(&mut self, file: &File<'s>) {
        let (mut clock, mut tick) = (None, None);
        for item in &file.items {
            let (slot, quantity) = match item {
                Item::Clock(quantity) => (&mut clock, *quantity),
                Item::Tick(quantity) => (&mut tick, *quantity),
                _ => continue,
            };
            if let Some(first) = slot.replace(quantity) {
                let diagnostic =
                    Diagnostic::new(code::BAD_CLOCK, quantity.span, "this is said twice")
                        .label("said again")
                        .also(first.span, "said here first")
                        .help("keep one of them");
                self.report(diagnostic);
            }
        }
        let up_to = |most: u64| move |value: &i128| (1..=i128::from(most)).contains(value);
        self.program.clock_hz = quantity::DEFAULT_CLOCK_HZ;
        self.program.tick_ns = DEFAULT_TICK_NS;
        if let Some(quantity) = clock {
            match quantity::frequency_hz(quantity.text).filter(up_to(quantity::FASTEST_CLOCK_HZ)) {
                Some(hz) => self.program.clock_hz = hz as u64,
                None => {
                    let diagnostic =
                        Diagnostic::new(code::BAD_CLOCK, quantity.span, "no such clock")
                            .label("not a whole number of hertz up to 1 THz")
                            .help("write a frequency with its unit, such as 12MHz or 50MHz");
                    self.report(diagnostic);
                }
            }
        }
        if let Some(quantity) = tick {
            match quantity::time_ns(quantity.text).filter(up_to(quantity::LONGEST_TICK_NS)) {
                Some(ns) => self.program.tick_ns = ns as u64,
                None => {
                    let diagnostic =
                        Diagnostic::new(code::BAD_CLOCK, quantity.span, "no such tick")
                            .label("not a time from 1ns to an hour")
                            .help("write a time with its unit, such as 1ms or 10ms");
                    self.report(diagnostic);
                }
            }
        }
        let period = u128::from(self.program.clock_hz) * u128::from(self.program.tick_ns);
        if period < 1_000_000_000 {
            let span = tick.or(clock).map_or(Span::default(), |quantity| quantity.span);
            let diagnostic =
                Diagnostic::new(code::BAD_CLOCK, span, "a tick is shorter than one clock")
                    .label("too short for the clock")
                    .help("make the tick longer or the clock faster");
            self.report(diagnostic);
        }
    }

    pub(super) fn declare_constant(&mut self, constant: &ast::Constant<'s>) {
        let ty = constant.ty.as_ref().map(|name| self.scalar_type(name)).transpose();
        let value = ty.and_then(|ty| {
            let untyped = ty.is_none() && self.takes_any_type(&constant.value);
            let (ty, value) = if untyped {
                (None, self.untyped_constant(&constant.value)?)
            } else {
                let (ty, value) = self.constant(&constant.value, ty)?;
                (Some(ty), value)
            };
            let index = self.program.constants.len();
            self.program.constants.push(model::Constant {
                name: constant.name.text.to_owned(),
                is_used: false,
                span: constant.name.span,
            });
            Ok(Constant { ty, value, is_typed: constant.ty.is_some(), index })
        });
        let entity = value.map_or(Entity::Broken, Entity::Constant);
        if let Err(diagnostic) = self.names.declare(constant.name, entity) {
            self.report(*diagnostic);
        }
    }

    /// The type and value of a constant expression.
    pub(super) fn constant(
        &mut self,
        expr: &ast::Expr<'s>,
        want: Option<Type>,
    ) -> Checked<(Type, i64)> {
        let value = self.expression(expr, want)?;
        match value.kind {
            ExprKind::Constant(constant) => Ok((value.ty, constant)),
            _ => Err(self.report(not_a_constant(expr.span))),
        }
    }

    /// Declares every block that a network calls, before any member is looked up.
    pub(super) fn declare_instances(&mut self, network: &Series<'s>) {
        for element in &network.elements {
            match &element.kind {
                ElementKind::Parallel(branches) => {
                    branches.iter().for_each(|branch| self.declare_instances(branch));
                }
                ElementKind::Call(call) => {
                    self.declare_instance(call);
                    call.networks().for_each(|network| self.declare_misplaced(network));
                }
                ElementKind::Net(net) => {
                    net.connections.iter().for_each(|one| self.declare_misplaced(&one.network));
                }
                _ => {}
            }
        }
    }

    /// A block in an argument or in a connection is a mistake of its own; that nothing bears its
    /// name is not another.
    fn declare_misplaced(&mut self, network: &Series<'s>) {
        for element in &network.elements {
            if let ElementKind::Call(call) = &element.kind {
                // Were the name taken, that would be found again once the block stands elsewhere.
                let _ = self.names.declare(call.name, Entity::Broken);
            }
        }
    }

    fn declare_instance(&mut self, call: &ast::Call<'s>) {
        let block = blocks::named(call.kind.text);
        if let (Some(block), Some(Entity::Instance(first))) =
            (block, self.names.get(call.name.text))
            && self.join(first, block)
        {
            return;
        }
        let entity = match block {
            Some(block) => {
                let findings = self.diagnostics.len();
                let shape = self.shape(call, block);
                let is_sound = self.diagnostics.len() == findings;
                let given = call.arguments.iter().map(|argument| argument.name.text).collect();
                let instance = self.instance(call.name.text, shape, call.name.span, given);
                if !is_sound {
                    self.unsettled.insert(instance);
                }
                Entity::Instance(instance)
            }
            None => {
                self.report(unknown_block(call.kind));
                // Whether it is called twice matters once its kind is known.
                if self.names.get(call.name.text).is_some() {
                    return;
                }
                Entity::Broken
            }
        };
        if let (Some(Entity::Instance(_)), Some(first)) =
            (self.names.get(call.name.text), self.names.place(call.name.text))
        {
            let message = format!("`{}` is called twice", call.name.text);
            let diagnostic = Diagnostic::new(code::CALLED_TWICE, call.name.span, message)
                .label("called again")
                .also(first, "called here first")
                .help("give the second call a name of its own, or read the first one's members");
            self.report(diagnostic);
        } else if let Err(diagnostic) = self.names.declare(call.name, entity) {
            let help = "the name before `:` names the block: `a delay:TON(PT := 5s)`";
            self.report(diagnostic.help(help));
        }
    }

    /// Lets a second kind be called on an instance, if the two belong together and it is the only
    /// second call.
    fn join(&mut self, instance: InstanceId, block: &'static blocks::Block) -> bool {
        let first = &mut self.program.instances[instance];
        if first.shape.block.partner != Some(block.name) || first.has_partner {
            return false;
        }
        first.has_partner = true;
        let second = Shape::new(block, first.shape.chosen.clone());
        let mut shape = (*first.shape).clone();
        for (port, other) in shape.ports.iter_mut().zip(second.ports) {
            if other.role.is_outside() {
                port.role = other.role;
            }
        }
        first.shape = Arc::new(shape);
        true
    }

    /// Makes an instance with a variable for each of its ports.
    pub(super) fn instance(
        &mut self,
        name: &str,
        shape: Arc<Shape>,
        span: Span,
        given: Vec<&str>,
    ) -> InstanceId {
        let given = shape.ports.iter().map(|port| given.contains(&port.name)).collect();
        let (members, is_hidden, has_partner) = (Vec::new(), false, false);
        let ports = shape.clone();
        let instance =
            Instance { name: name.to_owned(), shape, is_hidden, has_partner, members, given, span };
        let id = self.program.instances.alloc(instance);
        let mut words = self.register.drain(..).collect::<Vec<_>>().into_iter();
        for (index, port) in ports.ports.iter().enumerate() {
            if port.role == PortRole::Register
                && let Some(word) = words.next()
            {
                self.program.instances[id].members.push(word);
                continue;
            }
            let initial = match port.start {
                Start::Value(value) => value,
                // Known when the call has been checked.
                Start::Preset(_) => 0,
            };
            let variable = self.program.variables.alloc(Variable {
                name: format!("{name}.{}", port.name).into(),
                ty: port.ty,
                initial,
                is_initialised: false,
                role: Role::Member(id, index),
                address: None,
                span,
            });
            self.program.instances[id].members.push(variable);
        }
        id
    }
}

fn unknown_block(kind: ast::Name<'_>) -> Diagnostic {
    let kinds = || blocks::ALL.iter().map(|block| block.name);
    let all = || format!("the blocks are {}", kinds().collect::<Vec<_>>().join(", "));
    let help = match similar_name(kind.text, kinds()) {
        Some(similar) => format!("is `{similar}` meant?"),
        None => all(),
    };
    let message = format!("there is no block `{}`", shortened(kind.text));
    Diagnostic::new(code::UNKNOWN_BLOCK, kind.span, message).label("not a block").help(help)
}

/// Whether a name can be a program's: it names its module and its files.
///
/// # Errors
/// What is wrong with it.
pub fn program_name(name: &str) -> Result<(), String> {
    let upper = name.to_ascii_uppercase();
    let is_device = matches!(upper.as_str(), "CON" | "PRN" | "AUX" | "NUL")
        || (upper.len() == 4
            && (upper.starts_with("COM") || upper.starts_with("LPT"))
            && upper.ends_with(|c: char| c.is_ascii_digit()));
    if name.len() > LONGEST_PROGRAM_NAME {
        return Err(format!("longer than {LONGEST_PROGRAM_NAME} characters"));
    }
    if is_device {
        return Err("a device on some systems".to_owned());
    }
    let is_letter = |c: char| c.is_ascii_alphabetic() || c == '_';
    if !name.starts_with(is_letter) || name.contains(|c| !is_letter(c) && !c.is_ascii_digit()) {
        return Err("not an identifier".to_owned());
    }
    Ok(())
}
