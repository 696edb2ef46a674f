//! Finds what nothing reads, which lint tools want said.

use std::collections::HashSet;

use super::module::Module;
use super::names::NameId;
use super::plan::{Origin, origin};
use crate::circuit::mask;
use crate::index::index;

/// The bits that are read of everything that has a name.
struct ReadBits {
    inputs: Vec<u64>,
    registers: Vec<u64>,
    /// The wires of which not all bits are read.
    wires: Vec<NameId>,
}

impl Module<'_> {
    /// The names of everything of which no part or only a part is read, in order of declaration.
    pub fn unread(&self, modules: &[Module<'_>]) -> Vec<&str> {
        let reads_clock = !self.circuit.registers.is_empty()
            || self.circuit.instances.values().any(|inner| modules[index(inner.module)].has_clock);
        let ports = [self.naming.clock, self.naming.reset];
        let mut unread = if self.has_clock && !reads_clock { ports.to_vec() } else { Vec::new() };
        let read = self.read_bits();
        let partly = |&(_, bits, width): &(NameId, u64, u32)| bits & mask(width) != mask(width);
        let inputs = self.naming.inputs.iter().zip(&read.inputs).zip(&self.circuit.inputs);
        let inputs = inputs.map(|((&id, &bits), input)| (id, bits, input.width));
        let registers = self.naming.registers.iter().zip(&read.registers);
        let registers = registers.zip(self.circuit.registers.values());
        let registers = registers.map(|((&id, &bits), register)| (id, bits, register.width));
        unread.extend(inputs.chain(registers).filter(partly).map(|(id, ..)| id));
        unread.extend(read.wires);
        let taken: HashSet<NameId> = self.naming.next_aliases.values().copied().collect();
        let aliases = self.naming.aliases.iter().map(|alias| alias.name);
        unread.extend(aliases.filter(|name| !taken.contains(name)));
        unread.into_iter().map(|id| self.text(id)).collect()
    }

    fn read_bits(&self) -> ReadBits {
        let mut read = ReadBits {
            inputs: vec![0; self.circuit.inputs.len()],
            registers: vec![0; self.circuit.registers.len()],
            wires: Vec::new(),
        };
        let mut ports: Vec<u64> = vec![0; self.naming.port_slots()];
        for (net, cell) in self.circuit.cells() {
            let bits = self.plan.read_bits(net);
            match origin(cell.op) {
                Origin::Input(input) => read.inputs[input] |= bits,
                Origin::Register(id) => read.registers[index(id)] |= bits,
                Origin::Port(id, output) => ports[self.naming.port_slot(id, output)] |= bits,
                Origin::Cell => {}
            }
        }
        for (net, cell) in self.circuit.cells() {
            let (name, bits) = match origin(cell.op) {
                Origin::Input(_) | Origin::Register(_) => continue,
                Origin::Port(id, output) => {
                    let slot = self.naming.port_slot(id, output);
                    // The first of its cells tells for all.
                    let bits = std::mem::replace(&mut ports[slot], u64::MAX);
                    (self.naming.port_wire(id, output), bits)
                }
                Origin::Cell => (self.naming.wire(net), self.plan.read_bits(net)),
            };
            if let Some(name) = name
                && bits & mask(cell.width) != mask(cell.width)
            {
                read.wires.push(name);
            }
        }
        read
    }
}
