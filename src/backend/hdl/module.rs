//! A module as it is printed in either language: names, and statements in the order of the text.

use std::collections::HashSet;

use super::names::{NameId, Namer, is_cpp_word};
use super::naming::Naming;
use super::order::Item;
use super::plan::{Form, Origin, Plan, is_leaf, origin};
use super::ports::{self, Port};
use super::{ResetStyle, order};
use crate::circuit::{Circuit, Design, Instance, InstanceId, Net, Register, RegisterId, Section};
use crate::index::index;

/// What the names of the wrapper and the test bench end with.
const COMPANIONS: [&str; 2] = ["_top", "_tb"];

/// One module, with everything decided but the words of the language.
pub struct Module<'a> {
    /// What it is made of.
    pub circuit: &'a Circuit,
    /// Its name in the file.
    pub name: String,
    /// It is the program itself and not a part of it.
    pub is_top: bool,
    /// It has the ports clock and reset.
    pub has_clock: bool,
    /// How its registers are reset.
    pub reset: ResetStyle,
    /// What stands in it, in order.
    pub items: Vec<Item>,
    pub(super) plan: Plan,
    pub(super) naming: Naming,
}

/// A port of a printed program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PortName {
    /// Its name.
    pub name: String,
    /// Its width in bits, that of all its elements together.
    pub width: u32,
    /// The number of elements, if it is an array.
    pub elements: Option<u32>,
}

/// The names of a printed program's ports, in the order of the circuit's own.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PortNames {
    /// The module or entity.
    pub module: String,
    /// The wrapper around it.
    pub wrapper: String,
    /// Its test bench.
    pub bench: String,
    /// The clock.
    pub clock: &'static str,
    /// The reset.
    pub reset: &'static str,
    /// The second input starts a scan and the last output tells its end.
    pub has_scan_ports: bool,
    /// The inputs.
    pub inputs: Vec<PortName>,
    /// The outputs.
    pub outputs: Vec<PortName>,
}

impl PortNames {
    /// The names in the program of a design.
    pub fn new(design: &Design, reset: ResetStyle) -> PortNames {
        let ModuleNames { modules, companions: [wrapper, bench], all } = module_names(design);
        let mut namer = Namer::new(&all);
        let (inputs, outputs) = ports::name(design.top(), &mut namer);
        let names = namer.finish();
        let named = |ports: Vec<Port>| {
            let port = |port: Port| PortName {
                name: names.get(port.name).to_owned(),
                width: port.width,
                elements: port.is_array.then_some(port.parts.len() as u32),
            };
            ports.into_iter().map(port).collect()
        };
        PortNames {
            module: modules.last().cloned().unwrap_or_default(),
            wrapper,
            bench,
            clock: super::names::CLOCK,
            reset: reset.port(),
            has_scan_ports: design.top().has_scan_ports,
            inputs: named(inputs),
            outputs: named(outputs),
        }
    }
}

/// The modules of a design, in its order: a module stands behind those that it instantiates.
pub fn modules(design: &Design, reset: ResetStyle) -> Vec<Module<'_>> {
    let ModuleNames { modules: names, all, .. } = module_names(design);
    let mut modules: Vec<Module<'_>> = Vec::new();
    let last = names.len() - 1;
    let instances = design.modules.values().flat_map(|circuit| circuit.instances.values());
    let enabled = instances.filter(|instance| instance.enable.is_some());
    let enabled: HashSet<usize> = enabled.map(|instance| index(instance.module)).collect();
    for (place, (circuit, name)) in design.modules.values().zip(names).enumerate() {
        let is_top = place == last;
        let has_clock = is_top
            || !circuit.registers.is_empty()
            || circuit.instances.values().any(|inner| modules[index(inner.module)].has_clock);
        let plan = Plan::new(circuit);
        let is_enabled = has_clock && enabled.contains(&place);
        let naming = Naming::new(design, circuit, &plan, reset, is_enabled, &all);
        let items = order::items(circuit, &plan, &naming);
        modules.push(Module { circuit, name, is_top, has_clock, reset, items, plan, naming });
    }
    modules
}

/// The names of a file's modules.
struct ModuleNames {
    /// In the order of the design.
    modules: Vec<String>,
    /// Of [`COMPANIONS`].
    companions: [String; 2],
    /// In lower case; those of the files that go with the program are among them.
    all: HashSet<String>,
}

/// The program has its own name, the others that name in front of theirs.
fn module_names(design: &Design) -> ModuleNames {
    let outer = HashSet::new();
    let mut namer = Namer::new(&outer);
    let top = &design.top().name;
    let program = namer.take(top, "");
    let companions = COMPANIONS.map(|companion| namer.take(top, companion));
    let inner = design.modules.values().take(design.modules.len() - 1);
    let mut ids: Vec<NameId> =
        inner.map(|circuit| namer.take(format_args!("{top}_{}", circuit.name), "")).collect();
    ids.push(program);
    let names = namer.finish();
    ModuleNames {
        modules: ids.into_iter().map(|id| names.get(id).to_owned()).collect(),
        companions: companions.map(|id| names.get(id).to_owned()),
        all: names.iter().map(str::to_ascii_lowercase).collect(),
    }
}

impl<'a> Module<'a> {
    /// The text of a name.
    pub fn text(&self, id: NameId) -> &str {
        self.naming.names.get(id)
    }

    /// What the cell of a net computes.
    pub fn form(&self, net: Net) -> Form {
        self.plan.form(self.circuit, net)
    }

    /// The name of a net that has one.
    pub fn name_of(&self, net: Net) -> Option<&str> {
        let id = match origin(self.circuit.cell(net).op) {
            Origin::Input(input) => Some(self.naming.inputs[input]),
            Origin::Register(id) => Some(self.naming.registers[index(id)]),
            Origin::Port(instance, output) => self.naming.port_wire(instance, output),
            Origin::Cell => self.naming.wire(net),
        };
        id.map(|id| self.text(id))
    }

    /// True for a port of the program itself that is a vector: VHDL gives it another type.
    pub fn is_vector_port(&self, net: Net) -> bool {
        let cell = self.circuit.cell(net);
        let Origin::Input(input) = origin(cell.op) else { return false };
        let is_element = || {
            let mut arrays = self.naming.input_ports.iter().filter(|port| port.is_array);
            arrays.any(|port| port.parts.contains(&input))
        };
        self.is_top && cell.width > 1 && !is_element()
    }

    /// True for a net that is printed at one place only, where it goes out of the module.
    pub fn is_inline(&self, net: Net) -> bool {
        !self.plan.has_wire(net) && !is_leaf(self.circuit.cell(net).op)
    }

    /// The names of the clock and reset ports, if there are any.
    pub fn clock_and_reset(&self) -> Option<[&str; 2]> {
        self.has_clock.then(|| [self.naming.clock, self.naming.reset].map(|id| self.text(id)))
    }

    /// The name of the port without which no register takes a value, if there is one.
    pub fn enable(&self) -> Option<&str> {
        self.naming.enable.map(|id| self.text(id))
    }

    /// Each printed input port and its name.
    pub fn inputs(&self) -> impl Iterator<Item = (&str, &Port)> {
        self.naming.input_ports.iter().map(|port| (self.text(port.name), port))
    }

    /// Each printed output port and its name.
    pub fn outputs(&self) -> impl Iterator<Item = (&str, &Port)> {
        self.naming.output_ports.iter().map(|port| (self.text(port.name), port))
    }

    /// The name inside of the circuit's input port of that index.
    pub fn input(&self, index: usize) -> &str {
        self.text(self.naming.inputs[index])
    }

    /// Each register and its name.
    pub fn registers(&self) -> impl Iterator<Item = (RegisterId, &str, &'a Register)> {
        let names = self.naming.registers.iter().map(|&id| self.text(id));
        self.circuit.registers.iter().zip(names).map(|((id, register), name)| (id, name, register))
    }

    /// A register's own name for the value that it takes, if it is not that of the net.
    pub fn next_alias(&self, register: RegisterId) -> Option<&str> {
        self.naming.next_aliases.get(&register).map(|&id| self.text(id))
    }

    /// A section.
    pub fn section(&self, place: usize) -> &'a Section {
        &self.circuit.sections[place]
    }

    /// A second name and the net that has it.
    pub fn alias(&self, place: usize) -> (&str, Net) {
        let alias = &self.naming.aliases[place];
        (self.text(alias.name), alias.net)
    }

    /// An instance and its name.
    pub fn instance(&self, id: InstanceId) -> (&str, &'a Instance) {
        let name = self.naming.instances[index(id)];
        (self.text(name), &self.circuit.instances[id])
    }

    /// The wire at an output of an instance, if something reads it.
    pub fn port_wire(&self, instance: InstanceId, output: usize) -> Option<&str> {
        self.naming.port_wire(instance, output as u32).map(|id| self.text(id))
    }

    /// The name of the wire that takes what nothing reads.
    pub fn unused(&self) -> &str {
        self.text(self.naming.unused)
    }

    /// True if some instance has an output that nothing reads.
    pub fn has_open_outputs(&self, modules: &[Module<'_>]) -> bool {
        self.circuit.instances.iter().any(|(id, instance)| {
            let outputs = modules[index(instance.module)].circuit.outputs.len();
            (0..outputs).any(|output| self.port_wire(id, output).is_none())
        })
    }

    /// True if some name is a word of C++.
    pub fn has_cpp_words(&self) -> bool {
        self.naming.names.iter().any(is_cpp_word)
    }
}
