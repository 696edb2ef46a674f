//! A report as text.

use std::fmt::Write;

use super::Report;
use super::formula::{Formula, FormulaId};
use super::listing::{Equation, Left};
use super::names::{Names, Newest};
use super::parts::Parts;
use crate::model::{Edge, Program};
use crate::quantity;
use crate::types::Type;

/// How tightly what stands around a formula binds.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Around {
    /// Nothing, or brackets.
    Nothing,
    /// `|`
    Any,
    /// `&`
    All,
    /// `!`, an operator in braces
    Tight,
}

impl Report<'_> {
    /// The whole report.
    pub fn text(&self) -> String {
        let mut text = String::new();
        if let Some(order) = self.order() {
            order.text(&mut text).expect("a text takes all");
        }
        self.equations(&mut text).expect("a text takes all");
        self.graph_text(&mut text).expect("a text takes all");
        text
    }

    fn equations(&self, text: &mut String) -> std::fmt::Result {
        let mut parts = Parts::new(&self.listing);
        let mut newest = self.names.start();
        let mut rung = None;
        for equation in self.listing.shown() {
            if rung.replace(equation.rung) != Some(equation.rung) {
                self.heading(text, equation.rung)?;
            }
            self.names.go_to(&mut newest, equation);
            for part in parts.introduce(&self.listing.formulas, equation) {
                let writer = Writer { report: self, parts: &parts, newest: &newest };
                let number = parts.number(part).expect("it was introduced");
                writeln!(text, "        @{number} <- {}", writer.inside(part, Around::Nothing))?;
            }
            let writer = Writer { report: self, parts: &parts, newest: &newest };
            writeln!(text, "  {:4}  {}", equation.number, writer.equation(equation))?;
        }
        Ok(())
    }

    fn heading(&self, text: &mut String, rung: u32) -> std::fmt::Result {
        if !text.is_empty() && !text.ends_with("\n\n") {
            writeln!(text)?;
        }
        let written = &self.program.rungs[rung as usize];
        let title = written.title.as_ref().map(|title| format!(" \"{title}\"")).unwrap_or_default();
        writeln!(text, "rung {}{title}, line {}", written.number, written.line)
    }

    /// An equation on one line.
    pub(super) fn line(&self, parts: &Parts, newest: &Newest, equation: &Equation) -> String {
        Writer { report: self, parts, newest }.equation(equation)
    }
}

/// Writes formulas at a place of the listing. Their depth is bounded by the parts.
struct Writer<'r> {
    report: &'r Report<'r>,
    parts: &'r Parts,
    newest: &'r Newest,
}

impl Writer<'_> {
    fn equation(&self, equation: &Equation) -> String {
        let names: &Names<'_> = &self.report.names;
        let right = self.formula(equation.right, Around::Nothing);
        match &equation.left {
            Left::Variable(variable) => format!("{} <- {right}", names.variable(*variable)),
            Left::Reset(instance) => format!("(R {}) <- {right}", names.instance(*instance)),
            Left::Call(instance, shape) => {
                let given = equation.arguments.iter();
                let given =
                    given.map(|&(name, value)| (name, self.formula(value, Around::Nothing)));
                let all: Vec<String> = given
                    .chain(names.settings(shape))
                    .map(|(name, value)| format!("{name} := {value}"))
                    .collect();
                let (name, kind) = (names.instance(*instance), shape.block.name);
                format!("{name}:{kind}({}) <- {right}", all.join(", "))
            }
        }
    }

    /// A formula, or the name of the part that it is.
    fn formula(&self, id: FormulaId, around: Around) -> String {
        match self.parts.number(id) {
            Some(number) => format!("@{number}"),
            None => self.inside(id, around),
        }
    }

    /// A formula written out.
    fn inside(&self, id: FormulaId, around: Around) -> String {
        let program = self.report.program;
        match &self.report.listing.formulas.arena[id] {
            Formula::Number(value, ty) => number(program, *value, *ty),
            Formula::Value(variable, writer) => {
                self.report.names.value(self.newest, *variable, *writer)
            }
            Formula::Edge(edge, now) => {
                let word = match edge {
                    Edge::Rise => "rise",
                    Edge::Fall => "fall",
                };
                format!("{word}({})", self.formula(*now, Around::Nothing))
            }
            Formula::Not(operand) => format!("!{}", self.formula(*operand, Around::Tight)),
            Formula::All(list) => self.list(list, " & ", Around::All, around),
            Formula::Any(list) => self.list(list, " | ", Around::Any, around),
            Formula::Infix(symbol, [a, b], ty) => {
                let (a, b) = (self.formula(*a, Around::Tight), self.formula(*b, Around::Tight));
                match (ty, around) {
                    (Type::Bool, _) => format!("{{ {a} {symbol} {b} }}"),
                    (_, Around::Nothing) => format!("{a} {symbol} {b}"),
                    _ => format!("({a} {symbol} {b})"),
                }
            }
            Formula::Bit(whole, bit) => format!("{}.{bit}", self.formula(*whole, Around::Tight)),
            Formula::Apply(function, list, _) => {
                let list: Vec<String> =
                    list.iter().map(|&one| self.formula(one, Around::Nothing)).collect();
                format!("{function}({})", list.join(", "))
            }
        }
    }

    fn list(&self, list: &[FormulaId], between: &str, own: Around, around: Around) -> String {
        let list: Vec<String> = list.iter().map(|&one| self.formula(one, own)).collect();
        let text = list.join(between);
        if around > own { format!("({text})") } else { text }
    }
}

/// A number as a program writes it.
fn number(program: &Program, value: i64, ty: Type) -> String {
    match ty {
        Type::Bool => if value == 0 { "FALSE" } else { "TRUE" }.to_owned(),
        Type::Word | Type::Dword => format!("16#{value:X}"),
        Type::Time => quantity::ticks_text(value, program.tick_ns),
        Type::Int | Type::Uint | Type::Dint | Type::Udint => value.to_string(),
    }
}
