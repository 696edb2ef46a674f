//! Block instances: what the scan gives them, and what they show.

use super::Expansion;
use crate::blocks::{self, PortRole};
use crate::circuit::{self, Circuit, ModuleId, Net};
use crate::equations::ExprId;
use crate::index::index;
use crate::model::InstanceId;

/// What an instance is given, collected over the scan.
pub(super) struct Called {
    id: circuit::InstanceId,
    module: ModuleId,
    power: Option<Net>,
    /// Values of the parameters at the call.
    parameters: Vec<Option<Net>>,
    clear_before: Vec<Net>,
    clear_after: Vec<Net>,
}

impl Expansion<'_> {
    pub(super) fn called(&mut self, instance: InstanceId) -> &mut Called {
        let program = self.program;
        let declared = &program.instances[instance];
        if self.instances[index(instance)].is_none() {
            let starts: Vec<i64> =
                declared.members.iter().map(|&member| program.variables[member].initial).collect();
            let modules = &mut self.modules;
            let module = *self.by_block.entry((declared.block.name, starts)).or_insert_with_key(
                |(_, starts)| modules.alloc(blocks::module(declared.block, starts)),
            );
            let id = self.circuit.instance(&declared.name, module);
            self.instances[index(instance)] = Some(Called {
                id,
                module,
                power: None,
                parameters: vec![None; declared.block.ports.len()],
                clear_before: Vec::new(),
                clear_after: Vec::new(),
            });
        }
        self.instances[index(instance)].as_mut().expect("it was just made")
    }

    pub(super) fn instance_output(
        &mut self,
        instance: InstanceId,
        output: &str,
        width: u32,
    ) -> Net {
        let Called { id, module, .. } = *self.called(instance);
        let output = self.modules[module].output_named(output).expect("every output has its port");
        self.circuit.port(id, output, width)
    }

    pub(super) fn call(
        &mut self,
        instance: InstanceId,
        power: ExprId,
        arguments: &[(usize, ExprId)],
    ) {
        let declared = &self.program.instances[instance];
        for &(port, value) in arguments {
            self.now[index(declared.members[port])] = Some(self.nets[index(value)]);
        }
        let power = self.nets[index(power)];
        // What the outputs depend on must stand before them.
        let cleared = std::mem::take(&mut self.called(instance).clear_before);
        if !cleared.is_empty() {
            let cleared = self.circuit.or(cleared);
            self.called(instance).clear_before.push(cleared);
        }
        for (number, port) in declared.block.ports.iter().enumerate() {
            let member = declared.members[number];
            let given = match port.role {
                PortRole::Circuit if !declared.given[number] => self.circuit.bit(false),
                PortRole::Circuit | PortRole::Preset { .. } => self.newest(member),
                PortRole::Output | PortRole::State | PortRole::Memory => continue,
            };
            self.called(instance).parameters[number] = Some(given);
        }
        self.called(instance).power = Some(power);
        for (&member, port) in declared.members.iter().zip(declared.block.ports) {
            if port.role == PortRole::Output {
                let net = self.instance_output(instance, port.name, port.ty.width());
                self.now[index(member)] = Some(net);
            }
        }
    }

    pub(super) fn reset(&mut self, instance: InstanceId, power: ExprId) {
        let power = self.nets[index(power)];
        let called = self.called(instance);
        let list = match called.power {
            None => &mut called.clear_before,
            Some(_) => &mut called.clear_after,
        };
        list.push(power);
        let declared = &self.program.instances[instance];
        for (&member, port) in declared.members.iter().zip(declared.block.ports) {
            if port.role == PortRole::Output {
                let start = self.program.variables[member].initial;
                let start = self.circuit.constant(port.ty.bits(start), port.ty.width());
                let off = self.newest(member);
                self.now[index(member)] = Some(self.circuit.mux(power, start, off));
            }
        }
    }

    /// Gives an instance its inputs, in the order of its module's ports.
    pub(super) fn connect(&mut self, called: Called) {
        let circuit = &mut self.circuit;
        let module = &self.modules[called.module];
        let block = blocks::named(&module.name).expect("a module bears its block's name");
        let inputs = module
            .inputs
            .iter()
            .map(|input| match &*input.name {
                blocks::TICK => circuit.cells().next().expect("the tick is the first cell").0,
                blocks::POWER => called.power.expect("every instance is called"),
                blocks::CLEAR_BEFORE => any(circuit, &called.clear_before),
                blocks::CLEAR_AFTER => any(circuit, &called.clear_after),
                name => {
                    let port = block.port_named(name).expect("the other inputs are parameters");
                    called.parameters[port].expect("every parameter has a value at the call")
                }
            })
            .collect();
        circuit.instances[called.id].inputs = inputs;
    }
}

fn any(circuit: &mut Circuit, nets: &[Net]) -> Net {
    if nets.is_empty() { circuit.bit(false) } else { circuit.or(nets.iter().copied()) }
}
