//! Names of values: which one is meant where a scan writes a variable several times.

use super::listing::{Equation, Left, Listing};
use crate::blocks::{Choice, Shape};
use crate::equations::{Equations, StepId, StepKind};
use crate::index::index;
use crate::model::{InstanceId, Program, Role, VariableId};
use crate::quantity;
use crate::syntax::written_name;

/// The names of values at a place of a listing.
pub(super) struct Names<'p> {
    program: &'p Program,
    numbers: Vec<u32>,
    /// For each step, what it writes.
    written: Vec<Vec<VariableId>>,
    /// For each variable, whether a step writes it.
    is_written: Vec<bool>,
    is_flat: bool,
    /// For each instance, whether it is called several times.
    called_again: Vec<bool>,
}

/// For each variable, the step that wrote it last above a place.
pub(super) struct Newest {
    writers: Vec<Option<StepId>>,
    next: usize,
}

impl<'p> Names<'p> {
    pub fn new(program: &'p Program, equations: &Equations, listing: &Listing, flat: bool) -> Self {
        let mut is_written = vec![false; program.variables.len()];
        let mut calls = vec![0; program.instances.len()];
        let mut written = Vec::with_capacity(equations.steps.len());
        for step in &equations.steps {
            let of_step = match &step.kind {
                StepKind::Assign { target, .. } => vec![*target],
                StepKind::Call { instance, .. } => {
                    calls[index(*instance)] += 1;
                    program.instances[*instance].members.clone()
                }
                StepKind::Reset { instance, .. } => program.instances[*instance].members.clone(),
            };
            of_step.iter().for_each(|&variable| is_written[index(variable)] = true);
            written.push(of_step);
        }
        Names {
            program,
            numbers: listing.numbers.clone(),
            written,
            is_written,
            is_flat: flat,
            called_again: calls.into_iter().map(|calls| calls > 1).collect(),
        }
    }

    /// What holds at the top of a listing.
    pub fn start(&self) -> Newest {
        Newest { writers: vec![None; self.program.variables.len()], next: 0 }
    }

    /// Goes on to an equation: what stands above it has been written.
    pub fn go_to(&self, newest: &mut Newest, equation: &Equation) {
        while self.numbers[newest.next] < equation.number {
            for &variable in &self.written[newest.next] {
                newest.writers[index(variable)] = Some(newest.next as StepId);
            }
            newest.next += 1;
        }
    }

    /// The name of a value: `x`, the newest one; `last(x)`, what the last scan left; `x@3`, what
    /// equation 3 wrote.
    pub fn value(&self, newest: &Newest, variable: VariableId, writer: Option<StepId>) -> String {
        let name = self.variable(variable);
        let is_plain = match (self.program.variables[variable].role, writer) {
            (Role::Input | Role::FirstScan, _) => true,
            (Role::Member(instance, _), Some(_)) if self.is_flat => {
                !self.called_again[index(instance)]
            }
            _ if !self.is_written[index(variable)] => true,
            _ if self.is_flat => false,
            _ => newest.writers[index(variable)] == writer,
        };
        match writer {
            _ if is_plain => name,
            None => format!("last({name})"),
            Some(step) => format!("{name}@{}", self.numbers[step as usize]),
        }
    }

    /// The number of the equation that wrote a value; `None` for what stands above all of them.
    pub fn writer(&self, writer: Option<StepId>) -> Option<u32> {
        writer.map(|step| self.numbers[step as usize])
    }

    /// A variable as a program names it.
    pub fn variable(&self, variable: VariableId) -> String {
        variable_name(self.program, variable)
    }

    pub fn instance(&self, instance: InstanceId) -> String {
        instance_name(self.program, instance)
    }

    /// What an equation writes, without arguments.
    pub fn left(&self, left: &Left) -> String {
        match left {
            Left::Variable(variable) => self.variable(*variable),
            Left::Call(instance, _) | Left::Reset(instance) => self.instance(*instance),
        }
    }

    /// The settings of a call that are not what they are where none are given.
    pub fn settings(&self, shape: &Shape) -> Vec<(&'static str, String)> {
        let settings = shape.block.settings.iter().zip(&shape.chosen);
        let text = |choice: &Choice, chosen: &[i64]| match choice {
            Choice::Word(words) => (chosen[0] != 0).then(|| words[chosen[0] as usize].to_owned()),
            Choice::Time(..) => Some(quantity::ticks_text(chosen[0], self.program.tick_ns)),
            // Its words are read and written by name.
            Choice::Register { .. } => None,
            Choice::List { .. } => {
                let items: Vec<String> = chosen.iter().map(i64::to_string).collect();
                (!items.is_empty()).then(|| format!("[{}]", items.join(", ")))
            }
        };
        settings
            .filter_map(|(one, chosen)| text(&one.choice, chosen).map(|text| (one.name, text)))
            .collect()
    }
}

/// A variable as a program names it.
pub(super) fn variable_name(program: &Program, variable: VariableId) -> String {
    let declared = &program.variables[variable];
    match declared.role {
        Role::Member(instance, port) => {
            let shape = &program.instances[instance].shape;
            format!("{}.{}", instance_name(program, instance), shape.ports[port].name)
        }
        Role::FirstScan => declared.name.to_string(),
        _ if let Some(array) = program.array_of(variable) => {
            let array = &program.arrays[array];
            let number = index(variable) - index(array.elements.first);
            format!("{}[{number}]", written_name(&array.name))
        }
        _ => written_name(&declared.name).into_owned(),
    }
}

/// A block instance as a program names it.
pub(super) fn instance_name(program: &Program, instance: InstanceId) -> String {
    written_name(&program.instances[instance].name).into_owned()
}
