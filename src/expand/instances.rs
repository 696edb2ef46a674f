//! Block instances: what the scan gives them, and what they show.

use std::sync::Arc;

use super::Expansion;
use super::schedule::Written;
use crate::blocks::{self, PortRole, Shape};
use crate::circuit::{self, Circuit, ModuleId, Net, RegisterId};
use crate::equations::{ExprId, StepKind};
use crate::index::index;
use crate::model::InstanceId;

/// What an instance is given, collected over the scan.
pub(super) struct Called {
    pub(super) id: circuit::InstanceId,
    pub(super) module: ModuleId,
    power: Option<Net>,
    /// What each port reads at the call.
    given: Vec<Option<Net>>,
    clear_before: Vec<Net>,
    clear_after: Vec<Net>,
    /// The clock of the scan in which it is called.
    stage: u32,
}

/// That a reset coil has put an instance back since its last call, where the coil and the call act
/// in clocks of their own: the instance itself is put back when it is called next, and until then
/// readers see what it will be.
pub(super) struct Pending {
    pub(super) register: RegisterId,
    pub(super) written: Written,
    net: Net,
}

impl Expansion<'_> {
    /// What an instance is in the circuit.
    pub(super) fn shape(&self, instance: InstanceId) -> Arc<Shape> {
        let declared = &self.program.instances[instance].shape;
        self.shapes.get(&instance).unwrap_or(declared).clone()
    }

    /// The circuit instance of an instance's only or first call.
    pub(super) fn called(&mut self, instance: InstanceId, shape: &Shape) -> &mut Called {
        if self.instances[index(instance)].is_none() {
            let name = self.program.instances[instance].name.clone();
            let called = self.instantiate(instance, name, shape);
            self.instances[index(instance)] = Some(called);
        }
        self.instances[index(instance)].as_mut().expect("it was just made")
    }

    /// The circuit instance of one call.
    fn instantiate(&mut self, instance: InstanceId, name: String, shape: &Shape) -> Called {
        let program = self.program;
        let starts: Vec<i64> = program.instances[instance]
            .members
            .iter()
            .map(|&member| program.variables[member].initial)
            .collect();
        let modules = &mut self.modules;
        let module = *self
            .by_block
            .entry(blocks::key(shape, &starts))
            .or_insert_with(|| modules.alloc(blocks::module(shape, &starts)));
        Called {
            id: self.circuit.instance(name, module),
            module,
            power: None,
            given: vec![None; shape.ports.len()],
            clear_before: Vec::new(),
            clear_after: Vec::new(),
            stage: self.stage,
        }
    }

    /// Makes what remembers resets, for the instances that have some, where a scan takes several
    /// clocks.
    pub(super) fn prepare_pending(&mut self) {
        if self.sequence.is_none() {
            return;
        }
        for step in &self.equations.steps {
            let StepKind::Reset { instance, .. } = step.kind else { continue };
            let declared = &self.program.instances[instance];
            let shape = self.shape(instance);
            let has_inside = shape.ports.iter().any(|port| port.role.is_inside());
            if has_inside && self.pending[index(instance)].is_none() {
                let name = format!("{}_cleared", declared.name);
                let (register, net) = self.circuit.register(name, 1, 0);
                let written = Written::default();
                self.pending[index(instance)] = Some(Pending { register, written, net });
            }
        }
    }

    /// What an instance shows at an output, which a reset may have put back since its last call.
    pub(super) fn unless_cleared(&mut self, instance: InstanceId, port: usize, left: Net) -> Net {
        let Some(pending) = &self.pending[index(instance)] else { return left };
        let declared = &self.program.instances[instance];
        let member = declared.members[port];
        let mut cleared = declared.cleared(self.program);
        let Some((port, _, value)) = cleared.find(|&(_, other, _)| other == member) else {
            return left;
        };
        let value = self.circuit.constant(port.ty.bits(value), port.ty.width());
        self.circuit.mux(pending.net, value, left)
    }

    pub(super) fn instance_output(
        &mut self,
        id: circuit::InstanceId,
        module: ModuleId,
        output: &str,
        width: u32,
    ) -> Net {
        let output = self.modules[module].output_named(output).expect("every output has its port");
        self.circuit.port(id, output, width)
    }

    pub(super) fn call(
        &mut self,
        instance: InstanceId,
        shape: &Shape,
        power: ExprId,
        arguments: &[(usize, ExprId)],
    ) {
        let declared = &self.program.instances[instance];
        for &(port, value) in arguments {
            let net = self.net(value);
            self.written[index(declared.members[port])].set(self.stage, net);
        }
        let given = shape.ports.iter().zip(&declared.members).map(|(port, &member)| {
            let is_read = !port.role.is_inside() && !matches!(port.role, PortRole::Idle { .. });
            is_read.then(|| self.newest(member))
        });
        let given = given.collect();
        let power = self.net(power);
        let is_second =
            self.instances[index(instance)].as_ref().is_some_and(|first| first.power.is_some());
        let (id, module);
        if is_second {
            let name = format!("{}_{}", declared.name, shape.block.name);
            let called = self.instantiate(instance, name, shape);
            (id, module) = (called.id, called.module);
            self.partners.push(Called { power: Some(power), given, ..called });
        } else {
            let (stage, off) = (self.stage, self.circuit.bit(false));
            let pending = self.pending[index(instance)].as_mut().map(|pending| {
                let net = pending.written.at(stage).unwrap_or(pending.net);
                pending.written.set(stage, off);
                net
            });
            // What the outputs depend on must stand before them.
            let cleared = std::mem::take(&mut self.called(instance, shape).clear_before);
            let cleared = (!cleared.is_empty()).then(|| self.circuit.or(cleared));
            let called = self.called(instance, shape);
            (id, module) = (called.id, called.module);
            called.clear_before.extend(cleared.into_iter().chain(pending));
            called.stage = stage;
            called.power = Some(power);
            called.given = given;
        }
        for (&member, port) in declared.members.iter().zip(&shape.ports) {
            if port.role.is_result() {
                let net = self.instance_output(id, module, port.name, port.ty.width());
                self.written[index(member)].set(self.stage, net);
            }
        }
    }

    pub(super) fn reset(&mut self, instance: InstanceId, power: ExprId) {
        let power = self.net(power);
        let declared = &self.program.instances[instance];
        let shape = self.shape(instance);
        if let Some(pending) = &mut self.pending[index(instance)] {
            let before = pending.written.at(self.stage).unwrap_or(pending.net);
            let now = self.circuit.or([before, power]);
            pending.written.set(self.stage, now);
        } else if shape.ports.iter().any(|port| port.role.is_inside()) {
            let called = self.called(instance, &shape);
            let list = match called.power {
                None => &mut called.clear_before,
                Some(_) => &mut called.clear_after,
            };
            list.push(power);
        }
        for (port, member, value) in declared.cleared(self.program) {
            if port.role.is_result() {
                let cleared = self.circuit.constant(port.ty.bits(value), port.ty.width());
                let off = self.newest(member);
                let net = self.circuit.mux(power, cleared, off);
                self.written[index(member)].set(self.stage, net);
            }
        }
    }

    /// Gives an instance its inputs, in the order of its module's ports.
    pub(super) fn connect(&mut self, called: Called) {
        let tick = self.tick(called.stage);
        let circuit = &mut self.circuit;
        let mut given = called.given.iter().flatten();
        let inputs = self.modules[called.module]
            .inputs
            .iter()
            .map(|input| match &*input.name {
                blocks::TICK => tick,
                blocks::POWER => called.power.expect("every instance is called"),
                blocks::CLEAR_BEFORE => any(circuit, &called.clear_before),
                blocks::CLEAR_AFTER => any(circuit, &called.clear_after),
                // The others stand in the order of the ports that they bring.
                _ => *given.next().expect("every input has a value at the call"),
            })
            .collect();
        circuit.instances[called.id].inputs = inputs;
        let stage = called.stage as usize;
        circuit.instances[called.id].enable = self.sequence.as_ref().map(|s| s.enables[stage]);
    }
}

fn any(circuit: &mut Circuit, nets: &[Net]) -> Net {
    if nets.is_empty() { circuit.bit(false) } else { circuit.or(nets.iter().copied()) }
}
