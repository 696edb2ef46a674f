//! From networks to equations: series become `All`, parallel branches `Any`.

use super::write::Change;
use super::{Equations, Expr, ExprId, ExprOp, Operands, Step, StepId, StepKind};
use crate::index::index;
use crate::model::{
    ArgumentValue, Call, CoilAction, Edge, Element, Place, Program, Role, Series, VariableId,
};
use crate::types::Type;

/// The equations of a program.
pub fn lower(program: &Program) -> Equations {
    let mut lowering = Lowering::new(program);
    let first_scan = program.with_role(Role::FirstScan).next().map(|(id, _)| id);
    lowering.rung = Step::NO_RUNG;
    for unit in &program.units {
        let power = lowering.constant(false);
        lowering.call(unit, power);
    }
    for (index, rung) in program.rungs.iter().enumerate() {
        lowering.rung = index as u32;
        lowering.series(&rung.network, Vec::new());
    }
    if let Some(first_scan) = first_scan {
        let off = lowering.constant(false);
        lowering.assign(first_scan, off);
    }
    lowering.equations
}

/// The equations of an expectation's elements alone, one expression for each element of its
/// series.
pub fn lower_expectation(program: &Program, network: &Series) -> (Equations, Vec<ExprId>) {
    let mut lowering = Lowering::new(program);
    let elements = network
        .iter()
        .map(|element| {
            let power = lowering.element(element, Vec::new());
            lowering.all(power)
        })
        .collect();
    (lowering.equations, elements)
}

pub(super) struct Lowering<'p> {
    pub(super) program: &'p Program,
    pub(super) equations: Equations,
    rung: u32,
    /// The newest write of each variable.
    writer: Vec<Option<StepId>>,
    /// The expression that reads the newest value of each variable, once there is one.
    reads: Vec<Option<ExprId>>,
}

/// The power at a place, as factors that must all be 1; none means power 1.
pub(super) type Power = Vec<ExprId>;

impl<'p> Lowering<'p> {
    fn new(program: &'p Program) -> Self {
        let variables = program.variables.len();
        Lowering {
            program,
            equations: Equations::default(),
            rung: 0,
            writer: vec![None; variables],
            reads: vec![None; variables],
        }
    }

    pub(super) fn add(&mut self, op: ExprOp, ty: Type) -> ExprId {
        self.equations.exprs.alloc(Expr { op, ty })
    }

    pub(super) fn constant(&mut self, value: bool) -> ExprId {
        self.add(ExprOp::Constant(value.into()), Type::Bool)
    }

    pub(super) fn not(&mut self, operand: ExprId) -> ExprId {
        let ty = self.equations.exprs[operand].ty;
        self.add(ExprOp::Not(operand), ty)
    }

    pub(super) fn operands(&mut self, list: &[ExprId]) -> Operands {
        let start = self.equations.operands.len() as u32;
        self.equations.operands.extend_from_slice(list);
        Operands { start, len: list.len() as u32 }
    }

    /// One expression for the power.
    pub(super) fn all(&mut self, power: Power) -> ExprId {
        match power.as_slice() {
            [] => self.constant(true),
            [one] => *one,
            many => {
                let operands = self.operands(many);
                self.add(ExprOp::All(operands), Type::Bool)
            }
        }
    }

    pub(super) fn any(&mut self, branches: &[ExprId]) -> ExprId {
        if let [one] = branches {
            return *one;
        }
        let operands = self.operands(branches);
        self.add(ExprOp::Any(operands), Type::Bool)
    }

    pub(super) fn read(&mut self, variable: VariableId) -> ExprId {
        if let Some(read) = self.reads[index(variable)] {
            return read;
        }
        let writer = self.writer[index(variable)];
        let read = self.add(ExprOp::Read { variable, writer }, self.program.variables[variable].ty);
        self.reads[index(variable)] = Some(read);
        read
    }

    fn step(&mut self, kind: StepKind) -> StepId {
        let exprs = self.equations.exprs.len() as u32;
        self.equations.steps.push(Step { kind, rung: self.rung, exprs });
        self.equations.steps.len() as u32 - 1
    }

    fn written(&mut self, variable: VariableId, writer: StepId) {
        self.writer[index(variable)] = Some(writer);
        self.reads[index(variable)] = None;
    }

    pub(super) fn assign(&mut self, target: VariableId, value: ExprId) {
        let step = self.step(StepKind::Assign { target, value });
        self.written(target, step);
    }

    pub(super) fn series(&mut self, series: &Series, power: Power) -> Power {
        series.iter().fold(power, |power, element| self.element(element, power))
    }

    /// The power behind an element, given the power before it.
    fn element(&mut self, element: &Element, mut power: Power) -> Power {
        match element {
            Element::Constant(true) => {}
            Element::Constant(false) => power.push(self.constant(false)),
            Element::Contact { place, negated, .. } => {
                let read = self.read_place(place);
                power.push(if *negated { self.not(read) } else { read });
            }
            Element::Edge { place, edge, memory } => {
                let now = self.read_place(place);
                power.push(self.edge(now, *edge, *memory));
            }
            Element::Parallel(branches) => return self.parallel(branches, power),
            Element::OneShot { edge, memory } => {
                let now = self.all(power);
                power = vec![self.edge(now, *edge, *memory)];
            }
            Element::Invert => {
                let now = self.all(power);
                power = vec![self.not(now)];
            }
            Element::Compare(expr, _) => power.push(self.expr(expr)),
            Element::Coil { target, action, .. } => {
                let now = self.all(power);
                self.coil(target, *action, now);
                power = vec![now];
            }
            Element::ResetInstance(instance) => {
                let now = self.all(power);
                let step = self.step(StepKind::Reset { instance: *instance, power: now });
                for (port, member, _) in self.program.instances[*instance].cleared(self.program) {
                    if port.role.is_result() {
                        self.written(member, step);
                    }
                }
                power = vec![now];
            }
            Element::Assign { target, value, .. } => {
                let now = self.all(power);
                let value = self.expr(value);
                self.write(target, Change::When { power: now, value });
                power = vec![now];
            }
            Element::Call(call) => {
                let now = self.all(power);
                power = vec![self.call(call, now)];
            }
            Element::Net(net) => power.extend(self.net(net)),
        }
        power
    }

    /// 1 if `now` has changed since this element saw it last.
    fn edge(&mut self, now: ExprId, edge: Edge, memory: VariableId) -> ExprId {
        let before = self.read(memory);
        let (on, off) = match edge {
            Edge::Rise => (now, before),
            Edge::Fall => (before, now),
        };
        let off = self.not(off);
        let changed = self.all(vec![on, off]);
        self.assign(memory, now);
        changed
    }

    /// The power before a list is computed once. It is a common factor of branches that only
    /// look; a branch that acts on the power must have it.
    fn parallel(&mut self, branches: &[Series], mut power: Power) -> Power {
        let only_looks = branches.iter().flatten().all(Element::only_looks);
        let start = if only_looks || power.is_empty() {
            Vec::new()
        } else {
            vec![self.all(std::mem::take(&mut power))]
        };
        let ends: Vec<ExprId> = branches
            .iter()
            .map(|branch| {
                let end = self.series(branch, start.clone());
                self.all(end)
            })
            .collect();
        power.push(self.any(&ends));
        power
    }

    fn coil(&mut self, target: &Place, action: CoilAction, power: ExprId) {
        let change = match action {
            CoilAction::Plain => Change::To(power),
            CoilAction::Negated => Change::To(self.not(power)),
            CoilAction::Set => Change::Set(power),
            CoilAction::Reset => Change::Reset(power),
            CoilAction::Edge(edge, memory) => Change::To(self.edge(power, edge, memory)),
        };
        self.write(target, change);
    }

    fn call(&mut self, call: &Call, power: ExprId) -> ExprId {
        let instance = &self.program.instances[call.instance];
        let arguments: Vec<(usize, ExprId)> = call
            .arguments
            .iter()
            .map(|argument| {
                let value = match &argument.value {
                    ArgumentValue::Network(network) => {
                        let power = self.series(network, Vec::new());
                        self.all(power)
                    }
                    ArgumentValue::Value(expr) => self.expr(expr),
                };
                (argument.port, value)
            })
            .collect();
        let given: Vec<usize> = arguments.iter().map(|&(port, _)| port).collect();
        let shape = call.shape.clone();
        let step = self.step(StepKind::Call { instance: call.instance, shape, power, arguments });
        for (index, (port, &member)) in call.shape.ports.iter().zip(&instance.members).enumerate() {
            if port.role.is_result() || given.contains(&index) {
                self.written(member, step);
            }
        }
        match call.shape.main_port() {
            Some(port) => self.read(instance.members[port]),
            None => power,
        }
    }
}
