//! What a call fixes for good: its settings, and the units of time that it needs.

use std::sync::Arc;

use super::reference::Resolved;
use super::{Checked, Checker};
use crate::blocks::{self, Block, Choice, PortRole, Setting, Shape};
use crate::diagnostic::{Diagnostic, code, similar_name};
use crate::model::{Argument, ArgumentValue, Call, Expr, ExprKind, Role, Variable, VariableId};
use crate::quantity::{self, time_text};
use crate::source::Span;
use crate::syntax::ast::{self, LiteralKind};
use crate::types::Type;

impl<'s> Checker<'s> {
    /// The block with the settings of a call. What is wrong with one is reported, and then it is as
    /// if the call did not give it.
    pub(super) fn shape(&mut self, call: &ast::Call<'s>, block: &'static Block) -> Arc<Shape> {
        let plain = Shape::plain(block);
        let mut chosen = Vec::new();
        for (setting, otherwise) in block.settings.iter().zip(plain.chosen) {
            let given = call.arguments.iter().find(|argument| argument.name.text == setting.name);
            let value = match given {
                Some(argument) => self.setting(block, setting, &argument.value),
                None => self.otherwise(call, block, setting),
            };
            chosen.push(value.unwrap_or(otherwise));
        }
        Arc::new(Shape::new(block, chosen))
    }

    /// What a setting is that the call leaves out.
    fn otherwise(
        &mut self,
        call: &ast::Call<'s>,
        block: &'static Block,
        setting: &Setting,
    ) -> Checked<Vec<i64>> {
        if let Choice::Register { .. } = setting.choice {
            return Err(self.register_is_missing(call, setting));
        }
        match (setting.choice.otherwise(self.program.tick_ns), &setting.choice) {
            (Some(chosen), _) => Ok(chosen),
            (None, Choice::Time(_, unit)) => {
                let others = format!("give another {}", setting.name);
                Err(self.unit_does_not_fit(block, *unit, call.kind.span, &others))
            }
            (None, _) => unreachable!("only a time depends on the tick"),
        }
    }

    /// The words that a shift register changes in place.
    fn register(
        &mut self,
        setting: &Setting,
        most: usize,
        value: &ast::ArgumentValue<'s>,
    ) -> Checked<Vec<i64>> {
        let problem = match value {
            ast::ArgumentValue::Expr(ast::Expr {
                kind: ast::ExprKind::Reference(reference),
                ..
            }) => {
                let words: Vec<VariableId> = match self.resolve(reference)? {
                    Resolved::Place(place) => place.as_variable().into_iter().collect(),
                    Resolved::Array(array) => self.program.arrays[array].elements.iter().collect(),
                    Resolved::Constant(_) | Resolved::Instance(_) => Vec::new(),
                };
                let is_word = |word: &&VariableId| {
                    let Variable { ty, role, .. } = &self.program.variables[**word];
                    *ty == Type::Word && matches!(role, Role::Local | Role::Output)
                };
                if !words.is_empty() && words.iter().filter(is_word).count() == words.len() {
                    if words.len() <= most {
                        self.register = words;
                        return Ok(vec![0; self.register.len()]);
                    }
                    format!("{} has {most} words at most", setting.name)
                } else {
                    format!("{} takes a variable of type WORD or an array of them", setting.name)
                }
            }
            _ => format!("{} takes a variable of type WORD or an array of them", setting.name),
        };
        let diagnostic = Diagnostic::new(code::BAD_ARGUMENT, value.span(), problem)
            .label("cannot be shifted")
            .help("declare it, for instance: var line : WORD[3], and give its name");
        Err(self.report(diagnostic))
    }

    fn register_is_missing(&mut self, call: &ast::Call<'s>, setting: &Setting) -> super::Reported {
        let (kind, name) = (call.kind.text, setting.name);
        let message = format!("{kind} needs {name}, the register that it shifts");
        let diagnostic = Diagnostic::new(code::BAD_ARGUMENT, call.kind.span, message)
            .label("without a register")
            .help(format!(
                "declare one, for instance: var line : WORD[3], and give {name} := line"
            ));
        self.report(diagnostic)
    }

    fn setting(
        &mut self,
        block: &'static Block,
        setting: &Setting,
        value: &ast::ArgumentValue<'s>,
    ) -> Checked<Vec<i64>> {
        match &setting.choice {
            Choice::Word(words) => self.word(setting, words, value),
            Choice::Register { most } => self.register(setting, *most, value),
            Choice::Time(lengths, _) => self.length(block, setting, lengths, value),
            Choice::List { low, high, most } => self.list(setting, (*low, *high), *most, value),
        }
    }

    fn word(
        &mut self,
        setting: &Setting,
        words: &'static [&'static str],
        value: &ast::ArgumentValue<'s>,
    ) -> Checked<Vec<i64>> {
        let given = match value {
            ast::ArgumentValue::Expr(ast::Expr {
                kind: ast::ExprKind::Reference(reference),
                ..
            }) if reference.path.is_empty() => Some(reference.name.text),
            _ => None,
        };
        if let Some(word) = words.iter().position(|&word| Some(word) == given) {
            return Ok(vec![word as i64]);
        }
        let all = words.join(" or ");
        let message = format!("{} is {all}", setting.name);
        let help = match given.and_then(|given| similar_name(given, words.iter().copied())) {
            Some(similar) => format!("is `{similar}` meant?"),
            None => format!("write one of these words: {} := {}", setting.name, words[0]),
        };
        let diagnostic = Diagnostic::new(code::BAD_ARGUMENT, value.span(), message)
            .label("none of these words")
            .help(help);
        Err(self.report(diagnostic))
    }

    /// A unit of time, in ticks.
    fn length(
        &mut self,
        block: &'static Block,
        setting: &Setting,
        lengths: &[u64],
        value: &ast::ArgumentValue<'s>,
    ) -> Checked<Vec<i64>> {
        let tick = self.program.tick_ns;
        let ns = match value {
            // A literal need not be a whole number of ticks to be known.
            ast::ArgumentValue::Expr(ast::Expr {
                kind: ast::ExprKind::Literal(literal), ..
            }) if literal.kind == LiteralKind::Time => quantity::time_ns(literal.text),
            ast::ArgumentValue::Expr(expr) => {
                let (_, ticks) = self.constant(expr, Some(Type::Time))?;
                Some(i128::from(ticks) * i128::from(tick))
            }
            _ => None,
        };
        let Some(&unit) = lengths.iter().find(|&&length| Some(i128::from(length)) == ns) else {
            let all: Vec<String> = lengths.iter().map(|&ns| time_text(ns.into())).collect();
            let message = format!("{} is {}", setting.name, all.join(" or "));
            let diagnostic = Diagnostic::new(code::BAD_ARGUMENT, value.span(), message)
                .label("none of these times")
                .help("these are the time bases that such timers have");
            return Err(self.report(diagnostic));
        };
        if !unit.is_multiple_of(tick) {
            let others = format!("give another {}", setting.name);
            return Err(self.unit_does_not_fit(block, unit, value.span(), &others));
        }
        Ok(vec![(unit / tick) as i64])
    }

    fn list(
        &mut self,
        setting: &Setting,
        (low, high): (i64, i64),
        most: usize,
        value: &ast::ArgumentValue<'s>,
    ) -> Checked<Vec<i64>> {
        let (items, span): (&[_], _) = match value {
            ast::ArgumentValue::List(items, span) => (items, *span),
            ast::ArgumentValue::Network(series) if is_empty_list(series) => (&[], series.span),
            _ => return Err(self.not_a_list(setting, value.span())),
        };
        if !(1..=most).contains(&items.len()) {
            let message = format!("{} has 1 to {most} constants", setting.name);
            let diagnostic = Diagnostic::new(code::BAD_ARGUMENT, span, message)
                .label(format!("this has {}", items.len()))
                .help(match items.len() {
                    0 => format!("give one at least: {} := [10, 20]", setting.name),
                    _ => "leave some of them out, or use a second block".to_owned(),
                });
            return Err(self.report(diagnostic));
        }
        let mut numbers = Vec::new();
        for item in items {
            let (_, number) = self.constant(item, Some(Type::Int))?;
            if !(low..=high).contains(&number) {
                let message = format!("the constants of {} are {low} to {high}", setting.name);
                let diagnostic = Diagnostic::new(code::OUT_OF_RANGE, item.span, message)
                    .label(format!("this is {number}"))
                    .help("use a value in that range");
                return Err(self.report(diagnostic));
            }
            numbers.push(number);
        }
        Ok(numbers)
    }

    fn not_a_list(&mut self, setting: &Setting, span: Span) -> super::Reported {
        let message = format!("{} takes a list of constants", setting.name);
        let diagnostic = Diagnostic::new(code::BAD_ARGUMENT, span, message)
            .label("not a list")
            .help(format!("put the constants in brackets: {} := [10, 20]", setting.name));
        self.report(diagnostic)
    }

    /// Arguments for the pulses of time that a block needs. Their dividers are made for the first
    /// one and shared by all.
    pub(super) fn pulses(&mut self, shape: &Shape, kind: ast::Name<'s>) -> Vec<Argument> {
        let mut arguments = Vec::new();
        for (port, needed) in shape.ports.iter().enumerate() {
            let PortRole::Pulse(unit) = needed.role else { continue };
            if !unit.is_multiple_of(self.program.tick_ns) {
                let another = "use a timer of a longer unit";
                self.unit_does_not_fit(shape.block, unit, kind.span, another);
                continue;
            }
            let kind_of = ExprKind::Read(self.unit(unit, kind.span).into());
            let value = ArgumentValue::Value(Expr { ty: Type::Bool, kind: kind_of });
            arguments.push(Argument { port, value, span: kind.span });
        }
        arguments
    }

    /// The pulse of a unit of time.
    fn unit(&mut self, unit: u64, span: Span) -> VariableId {
        if let Some(&pulse) = self.units.get(&unit) {
            return pulse;
        }
        let ticks = (unit / self.program.tick_ns) as i64;
        let shape = Arc::new(Shape::new(&blocks::DIVIDER, vec![vec![ticks]]));
        let name = format!("every_{}", time_text(unit.into()).replace('.', "_"));
        let main = shape.main_port().expect("a divider has a pulse");
        let id = self.instance(&name, shape.clone(), span, Vec::new());
        self.program.instances[id].is_hidden = true;
        self.program.units.push(Call {
            instance: id,
            shape,
            arguments: Vec::new(),
            starts: Vec::new(),
        });
        let pulse = self.program.instances[id].members[main];
        self.units.insert(unit, pulse);
        pulse
    }

    fn unit_does_not_fit(
        &mut self,
        block: &'static Block,
        unit: u64,
        span: Span,
        another: &str,
    ) -> super::Reported {
        let (unit, tick) = (time_text(unit.into()), time_text(self.program.tick_ns.into()));
        let message =
            format!("{} counts units of {unit}, which is no whole number of ticks", block.name);
        let diagnostic = Diagnostic::new(code::BAD_TIME, span, message)
            .label(format!("a tick is {tick}"))
            .help(format!("declare a tick that divides {unit}, or {another}"));
        self.report(diagnostic)
    }
}

/// True for brackets with nothing in them, which may be a list of anything.
fn is_empty_list(series: &ast::Series<'_>) -> bool {
    let is_empty = |branch: &ast::Series<'_>| branch.elements.is_empty();
    match series.elements.as_slice() {
        [element] => match &element.kind {
            ast::ElementKind::Parallel(branches) => branches.iter().all(is_empty),
            _ => false,
        },
        _ => false,
    }
}
