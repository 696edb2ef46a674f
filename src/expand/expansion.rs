//! The circuit under construction, expression by expression and step by step.

use std::collections::HashMap;

use la_arena::Arena;

use super::schedule::{Schedule, Sequence, Written};
use super::shapes::shapes;
use super::words::{self, Typed};
use super::{Expansion, Options};
use crate::blocks::{self, PortRole};
use crate::circuit::{Circuit, Design, Net, Signal, Vector, Version};
use crate::equations::{Equations, ExprId, ExprOp, Operands, Step, StepKind};
use crate::index::index;
use crate::model::{Array, Program, Role, VariableId};

impl<'p> Expansion<'p> {
    pub(super) fn new(program: &'p Program, equations: &'p Equations) -> Self {
        let variables = program.variables.len();
        let shapes = shapes(program, equations);
        let mut last_write = vec![None; variables];
        for (number, step) in equations.steps.iter().enumerate() {
            match &step.kind {
                StepKind::Assign { target, .. } => last_write[index(*target)] = Some(number as u32),
                StepKind::Call { instance, shape, arguments, .. } => {
                    let members = &program.instances[*instance].members;
                    let shape = shapes.get(instance).unwrap_or(shape);
                    let outside = |port: &usize| shape.ports[*port].role.is_outside();
                    let outside = (0..members.len()).filter(outside);
                    for port in arguments.iter().map(|&(port, _)| port).chain(outside) {
                        last_write[index(members[port])] = Some(number as u32);
                    }
                }
                StepKind::Reset { instance, .. } => {
                    let declared = &program.instances[*instance];
                    let shape = shapes.get(instance).unwrap_or(&declared.shape);
                    for (_, member, _) in declared.cleared(program) {
                        if let Role::Member(_, port) = program.variables[member].role
                            && shape.ports[port].role.is_outside()
                        {
                            last_write[index(member)] = Some(number as u32);
                        }
                    }
                }
            }
        }
        Expansion {
            program,
            equations,
            circuit: Circuit::default(),
            modules: Arena::new(),
            by_block: HashMap::new(),
            nets: Vec::with_capacity(equations.exprs.len()),
            sequence: None,
            stage: 0,
            made_in: Vec::new(),
            written: vec![Written::default(); variables],
            held: HashMap::new(),
            pending: program.instances.iter().map(|_| None).collect(),
            before: vec![None; variables],
            registers: Vec::new(),
            instances: program.instances.iter().map(|_| None).collect(),
            shapes,
            partners: Vec::new(),
            last_write,
        }
    }

    pub(super) fn ports(&mut self, schedule: Schedule) {
        let tick = self.circuit.input(blocks::TICK, 1);
        let Expansion { program, equations, circuit, .. } = self;
        self.sequence = Sequence::new(schedule, program, equations, circuit, tick);
        // The tick stands before the program's inputs.
        let first = self.circuit.inputs.len();
        for (id, variable) in self.program.with_role(Role::Input) {
            let net = self.circuit.input(variable.name.clone(), variable.ty.width());
            self.before[index(id)] = Some(net);
        }
        self.vectors(Role::Input, first);
        self.prepare_pending();
    }

    /// Makes one port of the ports of each array of a role; those of the role begin there.
    fn vectors(&mut self, role: Role, start: usize) {
        let is_input = role == Role::Input;
        let ports = self.program.with_role(role).zip(start..);
        for ((id, _), first) in ports {
            let Some(array) = self.program.array_of(id) else { continue };
            let Array { name, elements } = &self.program.arrays[array];
            if elements.first == id {
                let (name, length) = (name.clone(), elements.length as usize);
                self.circuit.vectors.push(Vector { name, is_input, first, length });
            }
        }
    }

    pub(super) fn section(&mut self, rung: u32, options: &Options) {
        if rung == Step::NO_RUNG {
            self.circuit.section("units of time, each a pulse that all blocks share", 0);
        }
        let Some(written) = self.program.rungs.get(rung as usize) else { return };
        let title = written.title.as_ref().map(|title| format!(" \"{title}\"")).unwrap_or_default();
        let place = format!("{}:{}", options.source, written.line);
        let sequence = self.sequence.as_ref();
        let stage = sequence.map(|sequence| sequence.remark(rung));
        let stage = stage.unwrap_or_default();
        let number = written.number;
        self.circuit.section(format!("rung {number}{title}, {place}{stage}"), number);
    }

    /// What is made from now on acts in the clock of a step.
    pub(super) fn enter(&mut self, step: &Step) {
        if let Some(sequence) = &self.sequence {
            self.stage = sequence.stage_of(self.program, step);
        }
    }

    /// The value that the last scan left, or, where a scan takes several clocks, that its clocks so
    /// far have left.
    pub(super) fn before(&mut self, variable: VariableId) -> Net {
        if let Some(net) = self.before[index(variable)] {
            return match self.program.variables[variable].role {
                Role::Input => self.input(variable, net),
                _ => net,
            };
        }
        let declared = &self.program.variables[variable];
        let width = declared.ty.width();
        let net = match declared.role {
            Role::Member(instance, port)
                if self.shape(instance).ports[port].role == PortRole::Output =>
            {
                let shape = self.shape(instance);
                let called = self.called(instance, &shape);
                let (id, module) = (called.id, called.module);
                let name = shape.ports[port].name;
                let left = self.instance_output(id, module, &blocks::last(name), width);
                self.unless_cleared(instance, port, left)
            }
            _ if self.last_write[index(variable)].is_none() => {
                self.circuit.constant(declared.ty.bits(declared.initial), width)
            }
            _ => {
                let reset = declared.ty.bits(declared.initial);
                let name = declared.name.clone();
                let (register, net) = self.circuit.register(name, width, reset);
                self.registers.push((variable, register));
                net
            }
        };
        self.before[index(variable)] = Some(net);
        net
    }

    pub(super) fn newest(&mut self, variable: VariableId) -> Net {
        match self.written[index(variable)].at(self.stage) {
            Some(net) => net,
            None => self.before(variable),
        }
    }

    /// The net of an expression, as the stage sees it for which something is made now.
    pub(super) fn net(&mut self, expr: ExprId) -> Net {
        let net = self.nets[index(expr)];
        if self.sequence.is_none() || self.made_in[index(expr)] == self.stage {
            return net;
        }
        // Only reads are shared by rungs. A rung stands in a later stage than what it reads is written in; units of
        // time, which stand in no rung, are first read in the first stage.
        match self.equations.exprs[expr].op {
            ExprOp::Read { variable, .. } => self.before(variable),
            _ => net,
        }
    }

    pub(super) fn expr(&mut self, id: ExprId) {
        let expr = self.equations.exprs[id];
        let net = match expr.op {
            ExprOp::Constant(value) => self.circuit.constant(expr.ty.bits(value), expr.ty.width()),
            ExprOp::Read { variable, .. } => self.newest(variable),
            ExprOp::Not(operand) => {
                let operand = self.net(operand);
                self.circuit.not(operand)
            }
            ExprOp::All(operands) | ExprOp::Any(operands) => {
                let list = self.list(operands);
                match expr.op {
                    ExprOp::All(_) => self.circuit.and(list),
                    _ => self.circuit.or(list),
                }
            }
            ExprOp::Select { power, on, off } => {
                let (power, on, off) = (self.net(power), self.net(on), self.net(off));
                self.circuit.mux(power, on, off)
            }
            ExprOp::Binary(op, a, b) => {
                let (a, b) = (self.typed(a), self.typed(b));
                words::binary(&mut self.circuit, op, a, b)
            }
            ExprOp::Compare(relation, a, b) => {
                let (a, b) = (self.typed(a), self.typed(b));
                words::compare(&mut self.circuit, relation, a, b)
            }
            ExprOp::Call(function, arguments) => {
                let list = self.equations.list(arguments).iter();
                let arguments: Vec<Typed> = list.map(|&argument| self.typed(argument)).collect();
                words::call(&mut self.circuit, function, &arguments)
            }
            ExprOp::Convert(operand) => {
                let from = self.typed(operand);
                words::converted(&mut self.circuit, from, expr.ty)
            }
            ExprOp::Bit(whole, bit) => {
                let whole = self.net(whole);
                self.circuit.slice(whole, bit, 1)
            }
            ExprOp::WithBit { whole, bit, value } => {
                let (whole, value) = (self.net(whole), self.net(value));
                self.circuit.with_bit(whole, bit, value)
            }
            ExprOp::Element { index, elements } => {
                let index = self.typed(index);
                let elements = self.list(elements);
                words::element(&mut self.circuit, index, &elements)
            }
        };
        self.nets.push(net);
        if self.sequence.is_some() {
            self.made_in.push(self.stage);
        }
    }

    fn list(&mut self, operands: Operands) -> Vec<Net> {
        self.equations.list(operands).iter().map(|&operand| self.net(operand)).collect()
    }

    fn typed(&mut self, expr: ExprId) -> Typed {
        Typed { net: self.net(expr), ty: self.equations.exprs[expr].ty }
    }

    pub(super) fn step(&mut self, number: u32, step: &Step) {
        match &step.kind {
            StepKind::Assign { target, value } => {
                let net = self.net(*value);
                self.written[index(*target)].set(self.stage, net);
                let declared = &self.program.variables[*target];
                if declared.role.is_named() {
                    let version = match self.program.rungs.get(step.rung as usize) {
                        Some(rung) if self.last_write[index(*target)] != Some(number) => {
                            Version::Rung(rung.number)
                        }
                        _ => Version::Last,
                    };
                    let section = self.circuit.sections.len() - 1;
                    let name = declared.name.clone();
                    self.circuit.signals.push(Signal { net, name, version, section });
                }
            }
            StepKind::Call { instance, shape, power, arguments } => {
                let shape = self.shapes.get(instance).unwrap_or(shape).clone();
                self.call(*instance, &shape, *power, arguments);
            }
            StepKind::Reset { instance, power } => self.reset(*instance, *power),
        }
    }

    pub(super) fn finish(mut self, observe: &[VariableId]) -> Design {
        let outputs: Vec<VariableId> =
            self.program.with_role(Role::Output).map(|(id, _)| id).collect();
        self.vectors(Role::Output, 0);
        for &variable in outputs.iter().chain(observe) {
            let net = self.shown(variable);
            self.circuit.output(self.program.variables[variable].name.clone(), net);
        }
        self.end_of_scan();
        for (variable, register) in std::mem::take(&mut self.registers) {
            let written = std::mem::take(&mut self.written[index(variable)]);
            self.drive(register, &written);
        }
        for pending in std::mem::take(&mut self.pending).into_iter().flatten() {
            self.drive(pending.register, &pending.written);
        }
        let partners = std::mem::take(&mut self.partners);
        for called in std::mem::take(&mut self.instances).into_iter().flatten().chain(partners) {
            self.connect(called);
        }
        let mut modules = self.modules;
        modules.alloc(self.circuit);
        Design { modules }
    }
}
