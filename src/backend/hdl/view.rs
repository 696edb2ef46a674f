//! What the templates of both languages walk through: a module's ports, statements and registers.

use std::fmt;
use std::marker::PhantomData;

use super::expression::{Dialect, Value};
use super::module::Module;
use super::order::Item;
use crate::circuit::{InstanceId, Net};
use crate::index::index;

/// A module in one language.
pub struct View<'a, D> {
    /// The module.
    pub module: &'a Module<'a>,
    /// All modules of the file.
    pub modules: &'a [Module<'a>],
    dialect: PhantomData<D>,
}

/// A port, a register's or a wire's declaration.
pub struct Declared<'a> {
    /// The printed name.
    pub name: &'a str,
    /// Width in bits.
    pub width: u32,
}

/// A port.
pub struct Port<'a> {
    /// The printed name.
    pub name: &'a str,
    /// Width in bits.
    pub width: u32,
    /// It goes into the module.
    pub is_input: bool,
}

/// Some bits of a port.
pub struct Part<'a> {
    /// The port.
    pub name: &'a str,
    /// The lowest of them; none for a port of a single bit.
    pub low: Option<u32>,
    /// How many.
    pub width: u32,
}

/// The wire of an element of an array, and the bits that it takes from the port.
pub struct Element<'a> {
    /// The wire.
    pub wire: Declared<'a>,
    /// The bits.
    pub part: Part<'a>,
}

/// A register.
pub struct Stored<'a, D> {
    /// The printed name.
    pub name: &'a str,
    /// Width in bits.
    pub width: u32,
    /// The bits at reset.
    pub reset: u64,
    /// What it takes at the clock.
    pub next: Source<'a, D>,
}

/// Registers that take their values at the same clocks.
pub struct Process<'a, D> {
    /// The bit that says at which clocks; without it at all of them.
    pub enable: Option<Source<'a, D>>,
    /// The registers.
    pub registers: Vec<Stored<'a, D>>,
}

/// What goes into a register or a port.
pub enum Source<'a, D> {
    /// A net.
    Net(Value<'a, D>),
    /// A wire or a port of that name.
    Name(&'a str),
    /// Nothing is connected.
    Open,
}

impl<D: Dialect> fmt::Display for Source<'_, D> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Source::Net(value) => value.fmt(f),
            Source::Name(name) => f.write_str(name),
            Source::Open => f.write_str(D::OPEN),
        }
    }
}

/// A connection of an instance.
pub struct Pin<'a, D> {
    /// The instance's port.
    pub port: &'a str,
    /// What it is connected to.
    pub to: Source<'a, D>,
}

/// A part of a module's text.
pub enum Statement<'a, D> {
    /// The comment at the head of a section.
    Section(&'a str),
    /// A wire and what it is.
    Wire(Declared<'a>, Value<'a, D>),
    /// The wires at the outputs of an instance.
    PortWires(Vec<Declared<'a>>),
    /// An instance.
    Instance {
        /// The module.
        module: &'a str,
        /// The printed name.
        name: &'a str,
        /// All its ports.
        pins: Vec<Pin<'a, D>>,
    },
}

impl<'a, D: Dialect> View<'a, D> {
    /// All modules of a file.
    pub fn all(modules: &'a [Module<'a>]) -> impl Iterator<Item = View<'a, D>> {
        modules.iter().map(move |module| View { module, modules, dialect: PhantomData })
    }

    /// All ports: clock, reset, inputs, outputs.
    pub fn ports(&self) -> Vec<Port<'a>> {
        let module = self.module;
        let input = |(name, width)| Port { name, width, is_input: true };
        let clock = module.clock_and_reset().into_iter().flatten().chain(module.enable());
        let clock = clock.map(|name| (name, 1));
        let inputs = module.inputs().map(|(name, port)| (name, port.width));
        let outputs = module.outputs();
        let outputs = outputs.map(|(name, port)| Port { name, width: port.width, is_input: false });
        clock.chain(inputs).map(input).chain(outputs).collect()
    }

    /// The elements of input ports that are arrays.
    pub fn elements(&self) -> Vec<Element<'a>> {
        let module = self.module;
        let arrays = module.inputs().filter(|(_, port)| port.is_array);
        let elements = arrays.flat_map(|(name, port)| {
            let is_bit = port.width == 1;
            port.elements().map(move |(input, low, width)| Element {
                wire: Declared { name: module.input(input), width },
                part: Part { name, low: (!is_bit).then_some(low), width },
            })
        });
        elements.collect()
    }

    /// All registers.
    pub fn registers(&self) -> impl Iterator<Item = Stored<'a, D>> + use<'a, D> {
        let module = self.module;
        module.registers().map(move |(id, name, register)| Stored {
            name,
            width: register.width,
            reset: register.reset,
            next: match module.next_alias(id) {
                Some(alias) => Source::Name(alias),
                None => Source::Net(Value::leaf(module, register.next)),
            },
        })
    }

    /// The registers that take their values at the same clocks: those that always do, then the
    /// others in the order of what enables them.
    pub fn processes(&self) -> Vec<Process<'a, D>> {
        let module = self.module;
        let mut enables: Vec<Option<Net>> =
            module.circuit.registers.values().map(|register| register.enable).collect();
        enables.sort_unstable();
        enables.dedup();
        let process = |enable: Option<Net>| {
            let here = module.circuit.registers.values().map(|register| register.enable == enable);
            let registers = self.registers().zip(here).filter(|(_, is_here)| *is_here);
            Process {
                enable: match enable {
                    Some(net) => Some(Source::Net(Value::leaf(module, net))),
                    None => module.enable().map(Source::Name),
                },
                registers: registers.map(|(register, _)| register).collect(),
            }
        };
        enables.into_iter().map(process).collect()
    }

    /// True if there is a register.
    pub fn has_registers(&self) -> bool {
        !self.module.circuit.registers.is_empty()
    }

    /// True if there is an output port.
    pub fn has_outputs(&self) -> bool {
        !self.module.circuit.outputs.is_empty()
    }

    /// True if the statements begin without the comment of a section.
    pub fn begins_plain(&self) -> bool {
        matches!(self.module.items.first(), Some(item) if !matches!(item, Item::Section(_)))
    }

    /// The statements.
    pub fn statements(&self) -> impl Iterator<Item = Statement<'a, D>> + use<'a, D> {
        let View { module, modules, .. } = *self;
        module.items.iter().map(move |&item| match item {
            Item::Section(section) => Statement::Section(&module.section(section).comment),
            Item::Wire(net) => {
                let name = module.name_of(net).expect("a wire has a name");
                let width = module.circuit.width(net);
                let value = Value::definition(module, net, D::lead(name, width));
                Statement::Wire(Declared { name, width }, value)
            }
            Item::Alias(alias) => {
                let (name, net) = module.alias(alias);
                let width = module.circuit.width(net);
                let value = Value::assigned(module, net, D::lead(name, width));
                Statement::Wire(Declared { name, width }, value)
            }
            Item::PortWires(id) => Statement::PortWires(port_wires(module, modules, id)),
            Item::Instance(id) => {
                let (name, instance) = module.instance(id);
                let inner = &modules[index(instance.module)];
                Statement::Instance { module: &inner.name, name, pins: pins(module, inner, id) }
            }
        })
    }

    /// The wires in the order of the statements, those of elements first.
    pub fn wires(&self) -> impl Iterator<Item = Declared<'a>> + use<'a, D> {
        let elements = self.elements().into_iter().map(|element| element.wire);
        elements.chain(self.statement_wires())
    }

    fn statement_wires(&self) -> impl Iterator<Item = Declared<'a>> + use<'a, D> {
        self.statements().flat_map(|statement| match statement {
            Statement::Section(_) | Statement::Instance { .. } => Vec::new(),
            Statement::Wire(wire, _) => vec![wire],
            Statement::PortWires(wires) => wires,
        })
    }

    /// The output ports and what they show.
    pub fn outputs(&self) -> impl Iterator<Item = (Part<'a>, Value<'a, D>)> + use<'a, D> {
        let module = self.module;
        module.outputs().flat_map(move |(name, port)| {
            port.elements().map(move |(output, low, width)| {
                let net = module.circuit.outputs[output].net;
                let low = (port.is_array && port.width > 1).then_some(low);
                let column = D::lead(name, width);
                (Part { name, low, width }, Value::shown(module, net, column))
            })
        })
    }
}

fn port_wires<'a>(
    module: &'a Module<'a>,
    modules: &'a [Module<'a>],
    id: InstanceId,
) -> Vec<Declared<'a>> {
    let (_, instance) = module.instance(id);
    let inner = &modules[index(instance.module)];
    inner
        .outputs()
        .enumerate()
        .filter_map(|(output, (_, port))| {
            let name = module.port_wire(id, output)?;
            Some(Declared { name, width: port.width })
        })
        .collect()
}

fn pins<'a, D: Dialect>(
    module: &'a Module<'a>,
    inner: &'a Module<'a>,
    id: InstanceId,
) -> Vec<Pin<'a, D>> {
    let (_, instance) = module.instance(id);
    let clock = inner.clock_and_reset().into_iter().flatten();
    let clock = clock.map(|port| Pin { port, to: Source::Name(port) });
    let enable = inner.enable().zip(instance.enable);
    let enable = enable.map(|(port, net)| Pin { port, to: Source::Net(Value::leaf(module, net)) });
    let inputs = inner
        .inputs()
        .zip(&instance.inputs)
        .map(|((port, _), &net)| Pin { port, to: Source::Net(Value::leaf(module, net)) });
    let outputs = inner.outputs().enumerate().map(|(output, (port, _))| Pin {
        port,
        to: module.port_wire(id, output).map_or(Source::Open, Source::Name),
    });
    clock.chain(enable).chain(inputs).chain(outputs).collect()
}
