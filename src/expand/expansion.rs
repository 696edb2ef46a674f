//! The circuit under construction, expression by expression and step by step.

use std::collections::HashMap;

use la_arena::Arena;

use super::words::{self, Typed};
use super::{Expansion, Options};
use crate::blocks::{self, PortRole};
use crate::circuit::{Circuit, Design, Net, Signal, Vector, Version};
use crate::equations::{Equations, ExprId, ExprOp, Step, StepKind};
use crate::index::index;
use crate::model::{Array, Program, Role, VariableId};

impl<'p> Expansion<'p> {
    pub(super) fn new(program: &'p Program, equations: &'p Equations) -> Self {
        let variables = program.variables.len();
        let mut last_write = vec![None; variables];
        for (number, step) in equations.steps.iter().enumerate() {
            match &step.kind {
                StepKind::Assign { target, .. } => last_write[index(*target)] = Some(number as u32),
                StepKind::Call { instance, shape, arguments, .. } => {
                    let members = &program.instances[*instance].members;
                    let outside = |port: &usize| shape.ports[*port].role.is_outside();
                    let outside = (0..members.len()).filter(outside);
                    for port in arguments.iter().map(|&(port, _)| port).chain(outside) {
                        last_write[index(members[port])] = Some(number as u32);
                    }
                }
                StepKind::Reset { instance, .. } => {
                    for (port, member, _) in program.instances[*instance].cleared(program) {
                        if port.role.is_outside() {
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
            now: vec![None; variables],
            before: vec![None; variables],
            registers: Vec::new(),
            instances: program.instances.iter().map(|_| None).collect(),
            partners: Vec::new(),
            last_write,
        }
    }

    pub(super) fn ports(&mut self) {
        self.circuit.input(blocks::TICK, 1);
        for (id, variable) in self.program.with_role(Role::Input) {
            let net = self.circuit.input(variable.name.clone(), variable.ty.width());
            self.before[index(id)] = Some(net);
        }
        // The tick stands before the program's inputs.
        self.vectors(Role::Input, 1);
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
        self.circuit.section(format!("rung {}{title}, {place}", rung + 1), rung + 1);
    }

    /// The value that the last scan left.
    pub(super) fn before(&mut self, variable: VariableId) -> Net {
        if let Some(net) = self.before[index(variable)] {
            return net;
        }
        let declared = &self.program.variables[variable];
        let width = declared.ty.width();
        let net = match declared.role {
            Role::Member(instance, port)
                if self.program.instances[instance].shape.ports[port].role == PortRole::Output =>
            {
                let shape = &self.program.instances[instance].shape;
                let called = self.called(instance, shape);
                let (id, module) = (called.id, called.module);
                let name = shape.ports[port].name;
                self.instance_output(id, module, &blocks::last(name), width)
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
        match self.now[index(variable)] {
            Some(net) => net,
            None => self.before(variable),
        }
    }

    pub(super) fn expr(&mut self, id: ExprId) {
        let expr = self.equations.exprs[id];
        let get = |expansion: &Self, expr: ExprId| expansion.nets[index(expr)];
        let net = match expr.op {
            ExprOp::Constant(value) => self.circuit.constant(expr.ty.bits(value), expr.ty.width()),
            ExprOp::Read { variable, .. } => self.newest(variable),
            ExprOp::Not(operand) => {
                let operand = get(self, operand);
                self.circuit.not(operand)
            }
            ExprOp::All(operands) | ExprOp::Any(operands) => {
                let list =
                    self.equations.list(operands).iter().map(|&operand| self.nets[index(operand)]);
                match expr.op {
                    ExprOp::All(_) => self.circuit.and(list),
                    _ => self.circuit.or(list),
                }
            }
            ExprOp::Select { power, on, off } => {
                let (power, on, off) = (get(self, power), get(self, on), get(self, off));
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
                let whole = get(self, whole);
                self.circuit.slice(whole, bit, 1)
            }
            ExprOp::WithBit { whole, bit, value } => {
                let (whole, value) = (get(self, whole), get(self, value));
                self.circuit.with_bit(whole, bit, value)
            }
            ExprOp::Element { index, elements } => {
                let index = self.typed(index);
                let list = self.equations.list(elements).iter();
                let elements: Vec<Net> = list.map(|&element| get(self, element)).collect();
                words::element(&mut self.circuit, index, &elements)
            }
        };
        self.nets.push(net);
    }

    fn typed(&self, expr: ExprId) -> Typed {
        Typed { net: self.nets[index(expr)], ty: self.equations.exprs[expr].ty }
    }

    pub(super) fn step(&mut self, number: u32, step: &Step) {
        match &step.kind {
            StepKind::Assign { target, value } => {
                let net = self.nets[index(*value)];
                self.now[index(*target)] = Some(net);
                let declared = &self.program.variables[*target];
                if declared.role.is_named() {
                    let is_last = self.last_write[index(*target)] == Some(number);
                    let version =
                        if is_last { Version::Last } else { Version::Rung(step.rung + 1) };
                    let section = self.circuit.sections.len() - 1;
                    let name = declared.name.clone();
                    self.circuit.signals.push(Signal { net, name, version, section });
                }
            }
            StepKind::Call { instance, shape, power, arguments } => {
                self.call(*instance, shape, *power, arguments);
            }
            StepKind::Reset { instance, power } => self.reset(*instance, *power),
        }
    }

    pub(super) fn finish(mut self, observe: &[VariableId]) -> Design {
        let outputs: Vec<VariableId> =
            self.program.with_role(Role::Output).map(|(id, _)| id).collect();
        self.vectors(Role::Output, 0);
        for &variable in outputs.iter().chain(observe) {
            let net = self.before(variable);
            self.circuit.output(self.program.variables[variable].name.clone(), net);
        }
        for (variable, register) in std::mem::take(&mut self.registers) {
            if let Some(next) = self.now[index(variable)] {
                self.circuit.drive(register, next);
            }
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
