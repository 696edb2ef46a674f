//! The equations of a program: in the order of the text, or each as a function of inputs and of
//! what the last scan left.

use std::sync::Arc;

use super::formula::{Formula, FormulaId, Formulas};
use crate::blocks::Shape;
use crate::equations::{Equations, ExprId, ExprOp, StepKind};
use crate::index::index;
use crate::model::{BinaryOp, Edge, Function, InstanceId, Program, Role, VariableId};
use crate::types::Type;

/// Equations, and the formulas that they take.
pub(super) struct Listing {
    /// One for each coil, assignment, call and reset, in the order of the text.
    pub equations: Vec<Equation>,
    pub formulas: Formulas,
    /// For each step, the number of its equation from 1; 0 if it has none.
    pub numbers: Vec<u32>,
}

/// One equation.
pub(super) struct Equation {
    /// Its number, from 1, in the order of the text.
    pub number: u32,
    /// Index of the rung that it stands in.
    pub rung: u32,
    /// What is written.
    pub left: Left,
    /// What is written to it, or the power that arrives.
    pub right: FormulaId,
    /// False for what a flat listing leaves out.
    pub is_shown: bool,
    /// The arguments of a call by their names, in text order.
    pub arguments: Vec<(&'static str, FormulaId)>,
}

/// The left side of an equation.
pub(super) enum Left {
    Variable(VariableId),
    /// With the kind that is called on the instance, and its settings.
    Call(InstanceId, Arc<Shape>),
    Reset(InstanceId),
}

impl Equation {
    /// Every formula that it takes.
    pub fn roots(&self) -> impl Iterator<Item = FormulaId> {
        self.arguments.iter().map(|&(_, formula)| formula).chain([self.right])
    }
}

impl Listing {
    /// The equations in the order of the text; if `flat`, with what other equations say put in.
    pub fn new(program: &Program, equations: &Equations, flat: bool) -> Self {
        let mut lister = Lister {
            program,
            equations,
            formulas: Formulas::default(),
            made: Vec::with_capacity(equations.exprs.len()),
            now: flat.then(|| vec![None; program.variables.len()]),
        };
        let mut listed: Vec<Equation> = Vec::new();
        let mut numbers = vec![0; equations.steps.len()];
        let mut ids = equations.exprs.iter().map(|(id, _)| id);
        let mut done = 0;
        let mut next = 1;
        for (at, step) in equations.steps.iter().enumerate() {
            for id in ids.by_ref().take((step.exprs - done) as usize) {
                let formula = lister.formula(id);
                lister.made.push(formula);
            }
            done = step.exprs;
            let Some((left, right, arguments)) = lister.step(at as u32, &step.kind) else {
                continue;
            };
            numbers[at] = next;
            let (number, rung) = (next, step.rung);
            listed.push(Equation { number, rung, left, right, is_shown: true, arguments });
            next += 1;
        }
        let mut listing = Listing { equations: listed, formulas: lister.formulas, numbers };
        if flat {
            listing.show_what_stays(program);
        }
        listing
    }

    /// Shows of what is written to a variable only what is left at the end of the scan, and only
    /// if it is an output or something reads it in the next scan.
    fn show_what_stays(&mut self, program: &Program) {
        let mut wanted: Vec<bool> =
            program.variables.values().map(|variable| variable.role == Role::Output).collect();
        for formula in self.formulas.arena.values() {
            if let Formula::Value(variable, None) = formula {
                wanted[index(*variable)] = true;
            }
        }
        for equation in self.equations.iter_mut().rev() {
            equation.is_shown = match equation.left {
                // A call takes what stands in its members.
                Left::Variable(variable)
                    if matches!(program.variables[variable].role, Role::Member(..)) =>
                {
                    true
                }
                Left::Variable(variable) => std::mem::take(&mut wanted[index(variable)]),
                Left::Call(..) | Left::Reset(_) => true,
            };
        }
    }

    /// The equations that the listing has.
    pub fn shown(&self) -> impl Iterator<Item = &Equation> {
        self.equations.iter().filter(|equation| equation.is_shown)
    }
}

struct Lister<'p> {
    program: &'p Program,
    equations: &'p Equations,
    formulas: Formulas,
    /// The formula of each expression so far.
    made: Vec<FormulaId>,
    /// What each variable holds at this place, if it is put in where the variable is read.
    now: Option<Vec<Option<FormulaId>>>,
}

/// The left side, the right side, and the arguments of a call.
type Sides = (Left, FormulaId, Vec<(&'static str, FormulaId)>);

impl Lister<'_> {
    fn get(&self, expr: ExprId) -> FormulaId {
        self.made[index(expr)]
    }

    fn formula(&mut self, id: ExprId) -> FormulaId {
        let expr = self.equations.exprs[id];
        match expr.op {
            ExprOp::Constant(value) => self.formulas.add(Formula::Number(value, expr.ty)),
            ExprOp::Read { variable, writer } => {
                let now = self.now.as_ref().and_then(|now| now[index(variable)]);
                now.unwrap_or_else(|| self.formulas.add(Formula::Value(variable, writer)))
            }
            ExprOp::Not(operand) if expr.ty == Type::Bool => {
                let operand = self.get(operand);
                self.formulas.not(operand)
            }
            ExprOp::Not(operand) => self.apply("NOT", &[operand], expr.ty),
            ExprOp::All(list) => match self.edge(self.equations.list(list)) {
                Some((edge, now)) => self.formulas.add(Formula::Edge(edge, now)),
                None => {
                    let list = self.list(self.equations.list(list));
                    self.formulas.all(&list)
                }
            },
            ExprOp::Any(list) => {
                let list = self.list(self.equations.list(list));
                self.formulas.any(&list)
            }
            ExprOp::Select { power, on, off } => {
                let (power, on, off) = (self.get(power), self.get(on), self.get(off));
                self.formulas.select(power, on, off, expr.ty)
            }
            ExprOp::Convert(operand) => self.apply(conversion(expr.ty), &[operand], expr.ty),
            ExprOp::Bit(whole, bit) => {
                let whole = self.get(whole);
                self.formulas.add(Formula::Bit(whole, bit))
            }
            ExprOp::WithBit { whole, bit, value } => {
                let number = self.formulas.add(Formula::Number(bit.into(), Type::Int));
                let list = vec![self.get(whole), number, self.get(value)];
                self.formulas.add(Formula::Apply("WITH_BIT", list, expr.ty))
            }
            ExprOp::Element { index, elements } => {
                let mut list = vec![self.get(index)];
                list.extend(self.list(self.equations.list(elements)));
                self.formulas.add(Formula::Apply("ELEMENT", list, expr.ty))
            }
            ExprOp::Call(Function::Select, list) => {
                match self.list(self.equations.list(list))[..] {
                    [power, off, on] => self.formulas.select(power, on, off, expr.ty),
                    _ => unreachable!("the checker counts arguments"),
                }
            }
            ExprOp::Call(function, list) => {
                self.apply(function.name(), self.equations.list(list), expr.ty)
            }
            ExprOp::Binary(op, a, b) => self.binary(op, [self.get(a), self.get(b)], expr.ty),
            ExprOp::Compare(relation, a, b) => {
                let pair = [self.get(a), self.get(b)];
                self.formulas.add(Formula::Infix(relation.symbol(), pair, Type::Bool))
            }
        }
    }

    fn list(&self, list: &[ExprId]) -> Vec<FormulaId> {
        list.iter().map(|&one| self.get(one)).collect()
    }

    fn apply(&mut self, function: &'static str, list: &[ExprId], ty: Type) -> FormulaId {
        let list = self.list(list);
        self.formulas.add(Formula::Apply(function, list, ty))
    }

    fn binary(&mut self, op: BinaryOp, pair: [FormulaId; 2], ty: Type) -> FormulaId {
        let symbol = match op {
            BinaryOp::And if ty == Type::Bool => return self.formulas.all(&pair),
            BinaryOp::Or if ty == Type::Bool => return self.formulas.any(&pair),
            BinaryOp::Add => "+",
            BinaryOp::Subtract => "-",
            BinaryOp::Multiply => "*",
            BinaryOp::Divide => "/",
            BinaryOp::Modulo => "MOD",
            BinaryOp::And => "AND",
            BinaryOp::Or => "OR",
            BinaryOp::Xor => "XOR",
        };
        self.formulas.add(Formula::Infix(symbol, pair, ty))
    }

    /// What changes, if these factors are those of an edge: nothing else reads its memory.
    fn edge(&self, factors: &[ExprId]) -> Option<(Edge, FormulaId)> {
        let op = |expr: ExprId| self.equations.exprs[expr].op;
        let inverted = |expr: ExprId| match op(expr) {
            ExprOp::Not(operand) => Some(operand),
            _ => None,
        };
        let is_memory = |expr: ExprId| match op(expr) {
            ExprOp::Read { variable, .. } => {
                self.program.variables[variable].role == Role::EdgeMemory
            }
            _ => false,
        };
        let &[first, second] = factors else { return None };
        let second = inverted(second)?;
        if is_memory(second) {
            Some((Edge::Rise, self.get(first)))
        } else if is_memory(first) {
            Some((Edge::Fall, self.get(second)))
        } else {
            None
        }
    }

    fn step(&mut self, number: u32, kind: &StepKind) -> Option<Sides> {
        match kind {
            StepKind::Assign { target, value } => {
                let value = self.get(*value);
                self.write(*target, value);
                let role = self.program.variables[*target].role;
                role.is_named().then(|| (Left::Variable(*target), value, Vec::new()))
            }
            StepKind::Call { instance, shape, power, arguments } => {
                let called = &self.program.instances[*instance];
                let power = self.get(*power);
                let given: Vec<(usize, FormulaId)> =
                    arguments.iter().map(|&(port, value)| (port, self.get(value))).collect();
                for (port, &member) in shape.ports.iter().zip(&called.members) {
                    if port.role.is_result() {
                        let value = self.formulas.add(Formula::Value(member, Some(number)));
                        self.write(member, value);
                    }
                }
                for &(port, value) in &given {
                    self.write(called.members[port], value);
                }
                let mut arguments = self.starts(*instance, shape);
                // Pulses of units and the dividers that make them are not in the program.
                let named = given.iter().filter(|(port, _)| shape.ports[*port].role.is_parameter());
                arguments.extend(named.map(|&(port, value)| (shape.ports[port].name, value)));
                (!called.is_hidden)
                    .then(|| (Left::Call(*instance, shape.clone()), power, arguments))
            }
            StepKind::Reset { instance, power } => {
                let power = self.get(*power);
                self.reset(*instance, power);
                Some((Left::Reset(*instance), power, Vec::new()))
            }
        }
    }

    /// What a call gives at reset only: the first one of an instance says it for both.
    fn starts(&mut self, instance: InstanceId, shape: &Shape) -> Vec<(&'static str, FormulaId)> {
        let called = &self.program.instances[instance];
        if shape.block.name != called.shape.block.name {
            return Vec::new();
        }
        let mut starts = Vec::new();
        for (at, port) in shape.ports.iter().enumerate() {
            if called.given[at] && port.role.is_loaded() {
                let start = self.program.variables[called.members[at]].initial;
                starts.push((port.name, self.formulas.add(Formula::Number(start, port.ty))));
            }
        }
        starts
    }

    /// Notes what a variable holds from here on.
    fn write(&mut self, variable: VariableId, value: FormulaId) {
        if let Some(now) = &mut self.now {
            now[index(variable)] = Some(value);
        }
    }

    fn reset(&mut self, instance: InstanceId, power: FormulaId) {
        let program = self.program;
        for (port, member, value) in program.instances[instance].cleared(program) {
            let Some(now) = &self.now else { return };
            if port.role.is_result() {
                let now = now[index(member)];
                let off = now.unwrap_or_else(|| self.formulas.add(Formula::Value(member, None)));
                let on = self.formulas.add(Formula::Number(value, port.ty));
                let value = self.formulas.select(power, on, off, port.ty);
                self.write(member, value);
            }
        }
    }
}

fn conversion(to: Type) -> &'static str {
    match to {
        Type::Bool => "TO_BOOL",
        Type::Int => "TO_INT",
        Type::Uint => "TO_UINT",
        Type::Dint => "TO_DINT",
        Type::Udint => "TO_UDINT",
        Type::Word => "TO_WORD",
        Type::Dword => "TO_DWORD",
        Type::Time => "TO_TIME",
    }
}
