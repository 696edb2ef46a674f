//! One circuit without instances, for whoever needs the bare function: simulation, proof.

use std::collections::BTreeSet;

use super::{Cell, Circuit, Design, Instance, Net, Op, Output, Valid};
use crate::index::index;

/// Why a net of the flat circuit is there.
const COPIED: &str = "every cell that is needed was copied";

/// Net in the flat circuit of each net of an instance, made when it is first needed.
struct Inlined<'d> {
    name: &'d str,
    module: &'d Circuit,
    inputs: &'d [Net],
    enable: Option<Net>,
    nets: Vec<Option<Net>>,
}

struct Flattener {
    flat: Circuit,
    /// Net in the flat circuit of each input port of the top.
    inputs: Vec<Net>,
    /// Net in the flat circuit of each net of the top.
    nets: Vec<Option<Net>>,
}

impl Valid<Design> {
    /// The top circuit with every instance put in its place; registers of an instance are named
    /// `instance.register`. What enables a register is a choice between two values then.
    pub fn flatten(&self) -> Circuit {
        let top = self.top();
        let mut flat = Circuit::new(&top.name);
        let inputs =
            top.inputs.iter().map(|port| flat.input(port.name.clone(), port.width)).collect();
        let mut flattener = Flattener { flat, inputs, nets: vec![None; top.len()] };
        let mut inlined: Vec<Inlined> = top
            .instances
            .values()
            .map(|instance| {
                let module = &self.modules[instance.module];
                let nets = vec![None; module.len()];
                let Instance { name, inputs, enable, .. } = instance;
                Inlined { name, module, inputs, enable: *enable, nets }
            })
            .collect();
        for (net, cell) in top.cells() {
            let copy = match cell.op {
                Op::Port(instance, output) => {
                    let inlined = &mut inlined[index(instance)];
                    flattener.inline(inlined, inlined.module.outputs[output as usize].net)
                }
                _ => flattener.copy_top(top, cell),
            };
            flattener.nets[index(net)] = Some(copy);
        }
        for inlined in &mut inlined {
            for (_, register) in inlined.module.registers.iter() {
                flattener.inline(inlined, register.next);
                register.enable.map(|enable| flattener.inline(inlined, enable));
            }
            let enable = inlined.enable.map(|net| flattener.nets[index(net)].expect(COPIED));
            flattener.drive(inlined.module, &inlined.nets, enable);
        }
        let nets = std::mem::take(&mut flattener.nets);
        flattener.drive(top, &nets, None);
        for Output { name, net } in &top.outputs {
            flattener.flat.output(name.clone(), nets[index(*net)].expect(COPIED));
        }
        flattener.flat.has_scan_ports = top.has_scan_ports;
        flattener.flat
    }
}

impl Flattener {
    fn copy_top(&mut self, top: &Circuit, cell: Cell) -> Net {
        match cell.op {
            Op::Input(port) => self.inputs[port as usize],
            Op::Register(id) => {
                let register = &top.registers[id];
                self.flat.register(register.name.clone(), register.width, register.reset).1
            }
            _ => {
                let Flattener { flat, nets, .. } = self;
                copy_cell(flat, top, cell, |net| nets[index(net)].expect("operands come first"))
            }
        }
    }

    /// Copies what `target` needs within the instance and was not needed before.
    fn inline(&mut self, inlined: &mut Inlined, target: Net) -> Net {
        let module = inlined.module;
        let mut open = vec![target];
        let mut needed = BTreeSet::new();
        while let Some(net) = open.pop() {
            if inlined.nets[index(net)].is_none() && needed.insert(index(net)) {
                module.for_each_operand(module.cell(net), |operand| open.push(operand));
            }
        }
        for at in needed {
            let cell = module.cell(Net::from_raw((at as u32).into()));
            let copy = match cell.op {
                Op::Input(port) => self.nets[index(inlined.inputs[port as usize])]
                    .expect("a valid design has no combinational loop"),
                Op::Register(id) => {
                    let register = &module.registers[id];
                    let name = format!("{}.{}", inlined.name, register.name);
                    self.flat.register(name, register.width, register.reset).1
                }
                _ => copy_cell(&mut self.flat, module, cell, |net| {
                    inlined.nets[index(net)].expect("operands come first")
                }),
            };
            inlined.nets[at] = Some(copy);
        }
        inlined.nets[index(target)].expect("the target was copied")
    }

    /// Gives the copies of a circuit's registers their next values. `enable` enables them all.
    fn drive(&mut self, from: &Circuit, nets: &[Option<Net>], enable: Option<Net>) {
        for (net, cell) in from.cells() {
            let (Op::Register(id), Some(copy)) = (cell.op, nets[index(net)]) else { continue };
            let Op::Register(register) = self.flat.cell(copy).op else {
                unreachable!("a register's copy is a register")
            };
            let get = |net: Net| nets[index(net)].expect(COPIED);
            let mut next = get(from.registers[id].next);
            for enable in from.registers[id].enable.map(get).into_iter().chain(enable) {
                next = self.flat.mux(enable, next, copy);
            }
            self.flat.drive(register, next);
        }
    }
}

/// Makes a cell anew with other operands; inputs, registers and ports are the caller's.
pub(super) fn copy_cell(
    to: &mut Circuit,
    from: &Circuit,
    cell: Cell,
    map: impl Fn(Net) -> Net,
) -> Net {
    let is_constant = |net: Net| from.constant_value(net).is_some();
    let list = |operands| from.list(operands).iter().map(|&net| map(net));
    match cell.op {
        Op::Input(_) | Op::Register(_) | Op::Port(..) => unreachable!("the caller copies these"),
        Op::Const(value) => to.constant(value, cell.width),
        Op::Not(from) => to.not(map(from)),
        Op::And(operands) => to.and(list(operands)),
        Op::Or(operands) => to.or(list(operands)),
        Op::Xor(a, b) => to.xor(map(a), map(b)),
        // What was a choice on purpose stays one.
        Op::Mux { select, on, off } if is_constant(on) || is_constant(off) => {
            to.choice(map(select), map(on), map(off))
        }
        Op::Mux { select, on, off } => to.mux(map(select), map(on), map(off)),
        Op::Add(a, b) => to.add(map(a), map(b)),
        Op::Sub(a, b) => to.sub(map(a), map(b)),
        Op::Mul(a, b) => to.mul(map(a), map(b)),
        Op::Div(a, b) => to.div(map(a), map(b)),
        Op::Rem(a, b) => to.rem(map(a), map(b)),
        Op::Eq(a, b) => to.eq(map(a), map(b)),
        Op::Less { a, b, signed } => to.less(map(a), map(b), signed),
        Op::Extend { from, signed } => to.resize(map(from), cell.width, signed),
        Op::Slice { from, low } => to.slice(map(from), low, cell.width),
        Op::Concat(operands) => to.concat(list(operands)),
    }
}
