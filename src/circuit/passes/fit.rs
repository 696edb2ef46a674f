//! Fits every module to what its instances need: constants go in, unread outputs and what only
//! they used go out. Behaviour at the top's ports stays the same.

use std::collections::HashMap;

use la_arena::Arena;

use crate::circuit::flatten::copy_cell;
use crate::circuit::{
    Cell, Circuit, Design, Input, Instance, InstanceId, ModuleId, Net, Op, Operands, Output,
    Reading, Register, Section, Signal, Version, as_signed,
};
use crate::index::index;

/// A set of a module's input or output ports; a module has at most 64 of each.
type PortSet = u64;

/// Fits the modules of a design to their instances and drops what no output of the top needs.
/// Modules that hold instances themselves are left as they are, but for the top.
pub fn fit(design: Design) -> Design {
    let mut modules: Vec<Circuit> = design.modules.into_iter().map(|(_, module)| module).collect();
    let mut top = modules.pop().expect("a design has a top");
    let mut fitted = Fitted::default();
    let folded: Vec<usize> =
        top.instances.values().map(|instance| fitted.fold(&modules, &top, instance)).collect();

    let live = Liveness::of(&top, |instance, outputs| fitted.needs(folded[instance], outputs));
    let mut result = Arena::new();
    let mut pruned: HashMap<(usize, PortSet), ModuleId> = HashMap::new();
    let mut instances = Arena::new();
    for ((_, instance), &module) in top.instances.iter().zip(&folded) {
        let outputs = live.outputs[instances.len()];
        if outputs == 0 {
            // Nobody reads it, so it is not kept; it only holds its place in the numbering.
            instances.alloc(instance.clone());
            continue;
        }
        let inputs = fitted.needs(module, outputs);
        let id = *pruned.entry((module, outputs)).or_insert_with(|| {
            let mut small = prune_module(&fitted.modules[module], outputs, inputs);
            fitted.describe(&modules, module, outputs, &mut small);
            result.alloc(small)
        });
        let inputs = select(&instance.inputs, inputs).copied().collect();
        let Instance { name, enable, .. } = instance.clone();
        instances.alloc(Instance { name, module: id, inputs, enable });
    }
    top.instances = instances;
    let top = prune(&top, &live.nets, &live.outputs);
    result.alloc(top);
    Design { modules: result }
}

fn select<T>(ports: &[T], set: PortSet) -> impl Iterator<Item = &T> {
    ports.iter().enumerate().filter(move |(port, _)| set >> port & 1 == 1).map(|(_, port)| port)
}

/// Modules with constants put in for inputs, each made once.
#[derive(Default)]
struct Fitted {
    modules: Vec<Circuit>,
    /// Of what each is a copy, and its constants.
    origins: Vec<(ModuleId, Vec<Option<u64>>)>,
    by_constants: HashMap<(ModuleId, Vec<Option<u64>>), usize>,
    needs: HashMap<(usize, PortSet), PortSet>,
}

impl Fitted {
    /// The index of the module that fits an instance.
    fn fold(&mut self, modules: &[Circuit], top: &Circuit, instance: &Instance) -> usize {
        let constants: Vec<_> =
            instance.inputs.iter().map(|&net| top.constant_value(net)).collect();
        let key = (instance.module, constants);
        if let Some(&fitted) = self.by_constants.get(&key) {
            return fitted;
        }
        let module = &modules[index(instance.module)];
        self.modules.push(fold(module, &key.1));
        self.origins.push(key.clone());
        self.by_constants.insert(key, self.modules.len() - 1);
        self.modules.len() - 1
    }

    /// Writes into the name and the head of what is left of a module which constants it was made
    /// for: those without which it would be another one.
    fn describe(&self, modules: &[Circuit], module: usize, outputs: PortSet, left: &mut Circuit) {
        let (origin, constants) = &self.origins[module];
        let origin = &modules[index(*origin)];
        let mut fitted = Vec::new();
        for (port, input) in origin.inputs.iter().enumerate() {
            let Some(bits) = constants[port].filter(|&bits| bits != 0 || input.width > 1) else {
                continue;
            };
            let mut others = constants.clone();
            others[port] = None;
            let general = fold(origin, &others);
            let live = Liveness::from_outputs(&general, select(&general.outputs, outputs));
            let is_port = |(_, cell): &(Net, Cell)| cell.op == Op::Input(port as u32);
            if general.cells().find(is_port).is_some_and(|(net, _)| live.nets[index(net)]) {
                left.name += &constant_name(input, bits);
                fitted.push(constant_text(input, bits));
            }
        }
        if !fitted.is_empty() {
            let line = left.comment.len().min(1);
            left.comment.insert(line, format!("Fitted to {}.", fitted.join(", ")));
        }
    }

    /// The inputs that a module needs to show these outputs.
    fn needs(&mut self, module: usize, outputs: PortSet) -> PortSet {
        let modules = &self.modules;
        *self.needs.entry((module, outputs)).or_insert_with(|| {
            let circuit = &modules[module];
            let live = Liveness::from_outputs(circuit, select(&circuit.outputs, outputs));
            circuit.cells().fold(0, |set, (net, cell)| match cell.op {
                Op::Input(port) if live.nets[index(net)] => set | 1 << port,
                _ => set,
            })
        })
    }
}

/// Which nets and which outputs of instances somebody needs.
struct Liveness {
    nets: Vec<bool>,
    outputs: Vec<PortSet>,
}

impl Liveness {
    fn from_outputs<'c>(circuit: &Circuit, outputs: impl Iterator<Item = &'c Output>) -> Self {
        Liveness::follow(circuit, outputs.map(|output| output.net).collect(), |_, _| 0)
    }

    fn of(circuit: &Circuit, needs: impl FnMut(usize, PortSet) -> PortSet) -> Self {
        let open = circuit.outputs.iter().map(|output| output.net).collect();
        Liveness::follow(circuit, open, needs)
    }

    /// `needs` tells which inputs an instance needs to show a set of its outputs.
    fn follow(
        circuit: &Circuit,
        mut open: Vec<Net>,
        mut needs: impl FnMut(usize, PortSet) -> PortSet,
    ) -> Self {
        let mut live = Liveness {
            nets: vec![false; circuit.len()],
            outputs: vec![0; circuit.instances.len()],
        };
        while let Some(net) = open.pop() {
            if std::mem::replace(&mut live.nets[index(net)], true) {
                continue;
            }
            let cell = circuit.cell(net);
            circuit.for_each_operand(cell, |operand| open.push(operand));
            match cell.op {
                Op::Register(id) => {
                    let Register { next, enable, .. } = circuit.registers[id];
                    open.extend([Some(next), enable].into_iter().flatten());
                }
                Op::Port(id, output) => {
                    let instance = index(id);
                    live.outputs[instance] |= 1 << output;
                    let inputs = needs(instance, live.outputs[instance]);
                    open.extend(select(&circuit.instances[id].inputs, inputs));
                    open.extend(circuit.instances[id].enable);
                }
                _ => {}
            }
        }
        live
    }
}

fn number(input: &Input, bits: u64) -> i64 {
    match input.reading {
        Reading::Signed => as_signed(bits, input.width),
        Reading::Unsigned | Reading::Ticks => bits as i64,
    }
}

/// A constant for an input as a part of a module's name.
fn constant_name(input: &Input, bits: u64) -> String {
    let number = number(input, bits);
    let sign = if number < 0 { "_minus" } else { "" };
    format!("_{}{sign}{}", input.name, number.unsigned_abs())
}

/// A constant for an input as people read it.
fn constant_text(input: &Input, bits: u64) -> String {
    let number = number(input, bits);
    let unit = match (input.reading, number) {
        (Reading::Ticks, 1) => " tick",
        (Reading::Ticks, _) => " ticks",
        (Reading::Unsigned | Reading::Signed, _) => "",
    };
    format!("{} = {number}{unit}", input.name)
}

/// The module with constants for some of its inputs. The inputs stay, so that ports keep their
/// numbers.
fn fold(module: &Circuit, constants: &[Option<u64>]) -> Circuit {
    let mut folded = Circuit::new(&module.name);
    folded.comment.clone_from(&module.comment);
    folded.signals.clone_from(&module.signals);
    let mut nets: Vec<Net> = Vec::with_capacity(module.len());
    for (_, cell) in module.cells() {
        let net = match cell.op {
            Op::Input(port) => {
                let Input { name, reading, .. } = module.inputs[port as usize].clone();
                let input = folded.input_of(name, cell.width, reading);
                match constants[port as usize] {
                    Some(value) => folded.constant(value, cell.width),
                    None => input,
                }
            }
            Op::Register(id) => {
                let register = &module.registers[id];
                folded.register(register.name.clone(), register.width, register.reset).1
            }
            Op::Port(..) => unreachable!("block modules hold no instances"),
            _ => copy_cell(&mut folded, module, cell, |net| nets[index(net)]),
        };
        nets.push(net);
    }
    for ((id, _), (_, register)) in folded.registers.clone().iter().zip(module.registers.iter()) {
        folded.drive(id, nets[index(register.next)]);
        folded.registers[id].enable = register.enable.map(|net| nets[index(net)]);
    }
    for output in &module.outputs {
        folded.output(output.name.clone(), nets[index(output.net)]);
    }
    for signal in &mut folded.signals {
        signal.net = nets[index(signal.net)];
    }
    folded
}

fn prune_module(module: &Circuit, outputs: PortSet, inputs: PortSet) -> Circuit {
    let mut module = module.clone();
    module.outputs = select(&module.outputs, outputs).cloned().collect();
    let live = Liveness::from_outputs(&module, module.outputs.iter());
    let mut pruned = prune(&module, &live.nets, &[]);
    let renumbered: Vec<u32> =
        (0..module.inputs.len()).map(|port| (inputs & ((1 << port) - 1)).count_ones()).collect();
    for cell in pruned.cells.values_mut() {
        if let Op::Input(port) = &mut cell.op {
            *port = renumbered[*port as usize];
        }
    }
    pruned.inputs = select(&module.inputs, inputs).cloned().collect();
    pruned
}

/// The circuit with its live cells only; input ports stay. Instances whose outputs nobody reads
/// go, output ports of instances are renumbered to those that are read.
fn prune(circuit: &Circuit, live: &[bool], read: &[PortSet]) -> Circuit {
    let mut keep = Keep::new(circuit, live, read);
    let mut pruned = Circuit::new(&circuit.name);
    pruned.comment.clone_from(&circuit.comment);
    pruned.inputs.clone_from(&circuit.inputs);
    pruned.vectors.clone_from(&circuit.vectors);
    pruned.has_scan_ports = circuit.has_scan_ports;
    for (net, cell) in circuit.cells().filter(|(net, _)| live[index(*net)]) {
        let cell = keep.cell(circuit, &mut pruned, cell);
        keep.nets[index(net)] = Some(pruned.cells.alloc(cell));
    }
    keep.finish(circuit, &mut pruned);
    pruned
}

/// Where the kept parts of a circuit have gone.
struct Keep<'a> {
    read: &'a [PortSet],
    live: &'a [bool],
    nets: Vec<Option<Net>>,
    instances: Vec<Option<InstanceId>>,
}

impl<'a> Keep<'a> {
    fn new(circuit: &Circuit, live: &'a [bool], read: &'a [PortSet]) -> Self {
        let (nets, instances) = (vec![None; circuit.len()], vec![None; circuit.instances.len()]);
        Keep { read, live, nets, instances }
    }

    fn net(&self, net: Net) -> Net {
        self.nets[index(net)].expect("what a live cell needs is live")
    }

    fn cell(&mut self, circuit: &Circuit, pruned: &mut Circuit, cell: Cell) -> Cell {
        let mut list = |operands| {
            let start = pruned.operands.len() as u32;
            pruned.operands.extend(circuit.list(operands).iter().map(|&net| self.net(net)));
            Operands { start, len: pruned.operands.len() as u32 - start }
        };
        let op = match cell.op {
            Op::Input(_) | Op::Const(_) => cell.op,
            Op::Register(id) => Op::Register(pruned.registers.alloc(circuit.registers[id].clone())),
            Op::Port(id, output) => {
                let instance = index(id);
                let copy = *self.instances[instance]
                    .get_or_insert_with(|| pruned.instances.alloc(circuit.instances[id].clone()));
                let below = self.read[instance] & ((1 << output) - 1);
                Op::Port(copy, below.count_ones())
            }
            Op::Not(from) => Op::Not(self.net(from)),
            Op::And(operands) => Op::And(list(operands)),
            Op::Or(operands) => Op::Or(list(operands)),
            Op::Xor(a, b) => Op::Xor(self.net(a), self.net(b)),
            Op::Mux { select, on, off } => {
                Op::Mux { select: self.net(select), on: self.net(on), off: self.net(off) }
            }
            Op::Add(a, b) => Op::Add(self.net(a), self.net(b)),
            Op::Sub(a, b) => Op::Sub(self.net(a), self.net(b)),
            Op::Mul(a, b) => Op::Mul(self.net(a), self.net(b)),
            Op::Div(a, b) => Op::Div(self.net(a), self.net(b)),
            Op::Rem(a, b) => Op::Rem(self.net(a), self.net(b)),
            Op::Eq(a, b) => Op::Eq(self.net(a), self.net(b)),
            Op::Less { a, b, signed } => Op::Less { a: self.net(a), b: self.net(b), signed },
            Op::Extend { from, signed } => Op::Extend { from: self.net(from), signed },
            Op::Slice { from, low } => Op::Slice { from: self.net(from), low },
            Op::Concat(operands) => Op::Concat(list(operands)),
        };
        Cell { op, width: cell.width }
    }

    fn finish(&self, circuit: &Circuit, pruned: &mut Circuit) {
        let moved = |net: &mut Net| *net = self.net(*net);
        for Register { next, enable, .. } in pruned.registers.values_mut() {
            [Some(next), enable.as_mut()].into_iter().flatten().for_each(moved);
        }
        for Instance { inputs, enable, .. } in pruned.instances.values_mut() {
            inputs.iter_mut().chain(enable).for_each(moved);
        }
        pruned.outputs = circuit
            .outputs
            .iter()
            .map(|output| Output { name: output.name.clone(), net: self.net(output.net) })
            .collect();
        let mut kept = 0;
        let mut live = self.live.iter();
        pruned.sections = circuit
            .sections
            .iter()
            .map(|section| {
                let already = circuit.len() - live.len();
                let skipped = live.by_ref().take(section.start as usize - already);
                kept += skipped.filter(|&&live| live).count() as u32;
                Section { start: kept, ..section.clone() }
            })
            .collect();
        pruned.signals = self.signals(circuit, pruned);
    }

    /// The names that still say something: of a value that a register takes, or, where a cell has
    /// no such name, the first name it was given.
    fn signals(&self, circuit: &Circuit, pruned: &Circuit) -> Vec<Signal> {
        let next: HashMap<&str, Net> =
            pruned.registers.values().map(|register| (&*register.name, register.next)).collect();
        let moved = circuit.signals.iter().filter_map(|signal| {
            let net = self.nets[index(signal.net)]?;
            Some(Signal { net, ..signal.clone() })
        });
        let is_taken = |signal: &Signal| {
            signal.version == Version::Last && next.get(&*signal.name) == Some(&signal.net)
        };
        let mut named = vec![false; pruned.len()];
        let moved: Vec<Signal> = moved.collect();
        for signal in moved.iter().filter(|signal| is_taken(signal)) {
            named[index(signal.net)] = true;
        }
        let is_leaf = |net| {
            matches!(
                pruned.cell(net).op,
                Op::Input(_) | Op::Register(_) | Op::Port(..) | Op::Const(_)
            )
        };
        moved
            .into_iter()
            .filter(|signal| {
                is_taken(signal)
                    || (!is_leaf(signal.net)
                        && !std::mem::replace(&mut named[index(signal.net)], true))
            })
            .collect()
    }
}
