//! Who reads and who writes: the rungs that a drawing names below its elements.

use std::collections::HashMap;

use crate::syntax::ast::{
    Accessor, ArgumentValue, CoilAction, Element, ElementKind, Expr, ExprKind, File, Item,
    Reference, Series,
};

/// Most rungs, or runs of rungs, that are named at one place.
const MOST: usize = 4;

/// Numbers of the first and the last of some rungs one after another, from 1.
pub type Run = (u32, u32);

/// Rungs that read or write what an element is about, or nothing.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct References {
    /// What becomes of the pieces: `←` for rungs that write, `→` for rungs that read.
    pub sign: char,
    /// In the order of the text.
    pub runs: Vec<Run>,
    /// There are more.
    pub has_more: bool,
}

impl References {
    /// Of runs in the order of their rungs.
    fn new<'r>(sign: char, runs: impl IntoIterator<Item = &'r Run>) -> Self {
        let mut joined: Vec<Run> = Vec::new();
        for &(first, last) in runs {
            match joined.last_mut() {
                Some((_, end)) if *end + 1 >= first => *end = last.max(*end),
                _ => joined.push((first, last)),
            }
        }
        let has_more = joined.len() > MOST;
        joined.truncate(MOST);
        References { sign, runs: joined, has_more }
    }

    /// True if there is nothing to name.
    pub fn is_empty(&self) -> bool {
        self.runs.is_empty()
    }

    /// Each run with what stands before it.
    pub fn pieces(&self) -> impl Iterator<Item = (String, String, u32)> {
        self.runs.iter().enumerate().map(|(index, &(first, last))| {
            let before = if index == 0 { self.sign.to_string() } else { ",".to_owned() };
            let run = match last - first {
                0 => first.to_string(),
                1 => format!("{first},{last}"),
                _ => format!("{first}-{last}"),
            };
            (before, run, first)
        })
    }
}

impl std::fmt::Display for References {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        for (before, run, _) in self.pieces() {
            write!(f, "{before}{run}")?;
        }
        f.write_str(if self.has_more { ",.." } else { "" })
    }
}

/// For each declared name and each block, the rungs that read and that write it.
#[derive(Default)]
pub(super) struct Uses<'s> {
    reads: HashMap<&'s str, Vec<Run>>,
    writes: HashMap<&'s str, Vec<Run>>,
    /// Number of the rung, from 1.
    rung: u32,
}

impl<'s> Uses<'s> {
    /// Of all rungs of a file.
    pub(super) fn of(file: &File<'s>) -> Self {
        let mut uses = Uses::default();
        for item in &file.items {
            if let Item::Rung(rung) = item {
                uses.rung += 1;
                uses.series(&rung.network);
            }
        }
        uses
    }

    /// The rungs that read a name.
    pub(super) fn readers(&self, name: &str) -> References {
        References::new('→', self.reads.get(name).into_iter().flatten())
    }

    /// The rungs that write a name.
    pub(super) fn writers(&self, name: &str) -> References {
        References::new('←', self.writes.get(name).into_iter().flatten())
    }

    /// The rungs that write one of the names in an expression.
    pub(super) fn writers_of_operands(&self, value: &Expr<'s>) -> References {
        let mut operands = Uses { rung: 1, ..Uses::default() };
        operands.expression(value);
        let named = operands.reads.keys().filter_map(|name| self.writes.get(name));
        let mut runs: Vec<Run> = named.flatten().copied().collect();
        runs.sort_unstable();
        References::new('←', &runs)
    }

    fn series(&mut self, series: &Series<'s>) {
        series.elements.iter().for_each(|element| self.element(element));
    }

    fn element(&mut self, element: &Element<'s>) {
        match &element.kind {
            ElementKind::Constant(_)
            | ElementKind::FirstScan { .. }
            | ElementKind::OneShot(_)
            | ElementKind::Invert => {}
            ElementKind::Contact { operand, .. } | ElementKind::Edge { operand, .. } => {
                self.read(operand);
            }
            ElementKind::Parallel(branches) => branches.iter().for_each(|b| self.series(b)),
            ElementKind::Compare(value) => self.expression(value),
            ElementKind::Coil { target, action: _ } => self.write(target),
            ElementKind::Assign { target, value } => {
                self.expression(value);
                self.write(target);
            }
            ElementKind::Call(call) => {
                for argument in &call.arguments {
                    match &argument.value {
                        ArgumentValue::Expr(value) => self.expression(value),
                        ArgumentValue::List(values, _) => self.expressions(values),
                        ArgumentValue::Network(network) => self.series(network),
                    }
                }
                note(&mut self.writes, call.name.text, self.rung);
            }
            ElementKind::Net(net) => net.connections.iter().for_each(|c| self.series(&c.network)),
        }
    }

    fn expressions(&mut self, values: &[Expr<'s>]) {
        values.iter().for_each(|value| self.expression(value));
    }

    fn expression(&mut self, value: &Expr<'s>) {
        match &value.kind {
            ExprKind::Literal(_) => {}
            ExprKind::Reference(reference) => self.read(reference),
            ExprKind::Unary(_, operand) => self.expression(operand),
            ExprKind::Binary(_, left, right) => {
                self.expression(left);
                self.expression(right);
            }
            ExprKind::Function(_, values) => self.expressions(values),
        }
    }

    fn read(&mut self, reference: &Reference<'s>) {
        note(&mut self.reads, reference.name.text, self.rung);
        self.indexes(reference);
    }

    fn write(&mut self, reference: &Reference<'s>) {
        note(&mut self.writes, reference.name.text, self.rung);
        self.indexes(reference);
    }

    fn indexes(&mut self, reference: &Reference<'s>) {
        for accessor in &reference.path {
            match accessor {
                Accessor::Member(_) | Accessor::Bit(_) => {}
                Accessor::Index(index, _) => self.expression(index),
            }
        }
    }
}

/// Notes a rung, as long as there are not more runs than anybody names.
fn note<'s>(uses: &mut HashMap<&'s str, Vec<Run>>, name: &'s str, rung: u32) {
    let runs = uses.entry(name).or_default();
    let count = runs.len();
    match runs.last_mut() {
        Some((_, last)) if *last + 1 >= rung => *last = rung,
        _ if count <= MOST => runs.push((rung, rung)),
        _ => {}
    }
}

/// The sign in the brackets of a coil.
pub(super) fn coil_sign(action: CoilAction) -> &'static str {
    match action {
        CoilAction::Plain => " ",
        CoilAction::Negated => "/",
        CoilAction::Set => "S",
        CoilAction::Reset => "R",
        CoilAction::Rise => "P",
        CoilAction::Fall => "N",
    }
}
