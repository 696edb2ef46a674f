//! Gives every port, register, instance and wire of a circuit its printed name.
//!
//! A register bears the name of its variable; where an output port has that name it is the
//! register `x_reg` that the port `x` shows, in both languages, because VHDL-93 cannot read its
//! own output and a proof pairs registers by name; so it is where the output of an instance has the
//! name. The value that a register takes is `x_next`.

use std::collections::{HashMap, HashSet};

use super::names::{NameId, Namer, Names};
use super::plan::{Form, Origin, Plan, Relation, origin};
use super::ports::{self, Port};
use super::{ResetStyle, names};
use crate::circuit::{Circuit, Design, InstanceId, Net, RegisterId, Signal, Version};
use crate::index::index;

/// The names of one circuit.
pub struct Naming {
    /// The texts.
    pub names: Names,
    /// The clock port.
    pub clock: NameId,
    /// The reset port.
    pub reset: NameId,
    /// The port without which no register takes a value.
    pub enable: Option<NameId>,
    /// Printed input ports.
    pub input_ports: Vec<Port>,
    /// Printed output ports.
    pub output_ports: Vec<Port>,
    /// What each input port of the circuit is called inside: as the printed port, or, for an
    /// element of an array, as a wire of its own.
    pub inputs: Vec<NameId>,
    /// Registers.
    pub registers: Vec<NameId>,
    /// Instances.
    pub instances: Vec<NameId>,
    /// Signals that are another name for a net that has one.
    pub aliases: Vec<Alias>,
    /// By register, the alias that is its next value's own name.
    pub next_aliases: HashMap<RegisterId, NameId>,
    /// The wire that takes what nothing reads.
    pub unused: NameId,
    wires: Vec<Option<NameId>>,
    port_wires: Vec<Option<NameId>>,
    first_ports: Vec<u32>,
}

/// A second name of a net.
pub struct Alias {
    /// The name.
    pub name: NameId,
    /// The net.
    pub net: Net,
    /// Index of the section in which it is assigned.
    pub section: usize,
}

impl Naming {
    /// Names everything; `outer` holds the names of modules in lower case. Where the circuit's
    /// instances are enabled it has a port for that.
    pub fn new(
        design: &Design,
        circuit: &Circuit,
        plan: &Plan,
        reset: ResetStyle,
        is_enabled: bool,
        outer: &HashSet<String>,
    ) -> Naming {
        let mut namer = Namer::new(outer);
        let clock = namer.fix(names::CLOCK);
        let reset = namer.fix(reset.port());
        let enable = is_enabled.then(|| namer.take("enable", ""));
        let (input_ports, output_ports) = ports::name(circuit, &mut namer);
        let mut inputs = Vec::with_capacity(circuit.inputs.len());
        for port in &input_ports {
            inputs.extend(
                circuit.inputs[port.parts.clone()].iter().map(|input| {
                    if port.is_array { namer.take(&input.name, "") } else { port.name }
                }),
            );
        }
        let mut naming = Naming {
            names: Names::default(),
            clock,
            reset,
            enable,
            unused: clock,
            input_ports,
            output_ports,
            inputs,
            registers: Vec::with_capacity(circuit.registers.len()),
            instances: Vec::new(),
            aliases: Vec::new(),
            next_aliases: HashMap::new(),
            wires: vec![None; circuit.len()],
            port_wires: Vec::new(),
            first_ports: Vec::new(),
        };
        naming.name_stored(design, circuit, plan, &mut namer);
        naming.instances =
            circuit.instances.values().map(|instance| namer.take(&instance.name, "")).collect();
        naming.name_port_wires(design, circuit, plan, &mut namer);
        naming.name_by_use(design, circuit, plan, &mut namer);
        naming.name_by_kind(circuit, plan, &mut namer);
        naming.unused = namer.take("unused", "");
        naming.names = namer.finish();
        naming
    }

    /// The name of the wire that a cell has for itself.
    pub fn wire(&self, net: Net) -> Option<NameId> {
        self.wires[index(net)]
    }

    /// The wire at an output of an instance.
    pub fn port_wire(&self, instance: InstanceId, output: u32) -> Option<NameId> {
        self.port_wires[self.port_slot(instance, output)]
    }

    /// A running number of all outputs of all instances.
    pub fn port_slot(&self, instance: InstanceId, output: u32) -> usize {
        (self.first_ports[index(instance)] + output) as usize
    }

    /// The number of outputs of all instances.
    pub fn port_slots(&self) -> usize {
        self.port_wires.len()
    }

    fn name_stored(&mut self, design: &Design, circuit: &Circuit, plan: &Plan, namer: &mut Namer) {
        let plain = self.output_ports.iter().filter(|port| !port.is_array);
        let shown: HashSet<&str> =
            plain.map(|port| &*circuit.outputs[port.parts.start].name).collect();
        // What a block shares with others is kept outside of its module, and the module's output
        // has the name.
        let pins: HashSet<String> = circuit
            .instances
            .values()
            .flat_map(|instance| {
                let outputs = design.modules[instance.module].outputs.iter();
                outputs.map(|output| format!("{}.{}", instance.name, output.name))
            })
            .collect();
        let mut stored = HashMap::with_capacity(circuit.registers.len());
        for (id, register) in circuit.registers.iter() {
            let name = &*register.name;
            let suffix = if shown.contains(name) || pins.contains(name) { "_reg" } else { "" };
            self.registers.push(namer.take(&register.name, suffix));
            stored.entry(&*register.name).or_insert(id);
        }
        for signal in &circuit.signals {
            let register = stored.get(&*signal.name).copied();
            let name = match signal.version {
                Version::Rung(rung) => namer.take(format_args!("{}_rung{rung}", signal.name), ""),
                Version::Last if register.is_some() || shown.contains(&*signal.name) => {
                    namer.take(&signal.name, "_next")
                }
                Version::Last => namer.take(&signal.name, ""),
            };
            self.name_signal(circuit, plan, signal, name, register);
        }
    }

    fn name_signal(
        &mut self,
        circuit: &Circuit,
        plan: &Plan,
        signal: &Signal,
        name: NameId,
        register: Option<RegisterId>,
    ) {
        let &Signal { net, section, version, .. } = signal;
        if plan.has_wire(net) && self.wire(net).is_none() {
            self.wires[index(net)] = Some(name);
            return;
        }
        self.aliases.push(Alias { name, net, section });
        if let Some(id) = register
            && version == Version::Last
            && circuit.registers[id].next == net
        {
            self.next_aliases.insert(id, name);
        }
    }

    fn name_port_wires(
        &mut self,
        design: &Design,
        circuit: &Circuit,
        plan: &Plan,
        namer: &mut Namer,
    ) {
        let mut slots = 0;
        for instance in circuit.instances.values() {
            self.first_ports.push(slots as u32);
            slots += design.modules[instance.module].outputs.len();
        }
        self.port_wires.resize(slots, None);
        for (net, cell) in circuit.cells() {
            if let Origin::Port(id, output) = origin(cell.op)
                && plan.is_live(net)
            {
                let slot = self.port_slot(id, output);
                self.port_wires[slot].get_or_insert_with(|| {
                    let instance = &circuit.instances[id];
                    let port = &design.modules[instance.module].outputs[output as usize];
                    namer.take(format_args!("{}_{}", instance.name, port.name), "")
                });
            }
        }
    }

    /// Wires without a name bear that of the register, instance or port that they go to.
    fn name_by_use(&mut self, design: &Design, circuit: &Circuit, plan: &Plan, namer: &mut Namer) {
        let mut name = |net: Net, base: std::fmt::Arguments<'_>, suffix: &str| {
            if plan.has_wire(net) && self.wires[index(net)].is_none() {
                self.wires[index(net)] = Some(namer.take(base, suffix));
            }
        };
        for register in circuit.registers.values() {
            name(register.next, format_args!("{}", register.name), "_next");
        }
        for instance in circuit.instances.values() {
            for (port, &net) in design.modules[instance.module].inputs.iter().zip(&instance.inputs)
            {
                name(net, format_args!("{}_{}", instance.name, port.name), "");
            }
        }
        for output in &circuit.outputs {
            name(output.net, format_args!("{}", output.name), "_value");
        }
    }

    /// The other wires bear the number of their rung and what they compute.
    fn name_by_kind(&mut self, circuit: &Circuit, plan: &Plan, namer: &mut Namer) {
        let mut sections = circuit.sections.iter().peekable();
        let mut rung = 0;
        for (net, _) in circuit.cells() {
            let start = |start: u32| start as usize <= index(net);
            while let Some(section) = sections.next_if(|section| start(section.start)) {
                rung = section.rung;
            }
            if plan.has_wire(net) && self.wires[index(net)].is_none() {
                let kind = kind(plan.form(circuit, net), circuit.width(net), rung);
                self.wires[index(net)] = Some(match rung {
                    0 => namer.take(kind, ""),
                    _ => namer.take(format_args!("rung{rung}_{kind}"), ""),
                });
            }
        }
    }
}

fn kind(form: Form, width: u32, rung: u32) -> &'static str {
    match form {
        Form::Leaf => "constant",
        Form::Not(_) | Form::And(_) | Form::Or(_) | Form::Xor(..) | Form::Above(..) => {
            match (width, rung) {
                (1, 0) => "condition",
                (1, _) => "power",
                _ => "bits",
            }
        }
        Form::Choice(..) => "choice",
        Form::Sum(..) => "sum",
        Form::Difference(..) => "difference",
        Form::Product(..) => "product",
        Form::Quotient(..) => "quotient",
        Form::Rest(..) => "rest",
        Form::Compare(Relation::Equal, ..) => "equal",
        Form::Compare(Relation::Unequal, ..) => "unequal",
        Form::Compare(Relation::Less(_), ..) => "less",
        Form::Compare(Relation::AtLeast(_), ..) => "at_least",
        Form::Compare(Relation::Greater(_), ..) => "greater",
        Form::Compare(Relation::AtMost(_), ..) => "at_most",
        Form::Extend(..) => "extended",
        Form::Slice(..) => "part",
        Form::Concat(_) => "joined",
    }
}
