//! Copies a circuit, cell by cell, with some cells made in another way.

use crate::circuit::flatten::copy_cell;
use crate::circuit::{Cell, Circuit, Net, Op, RegisterId, Section};
use crate::index::index;

/// A copy under way.
pub struct Rebuild<'c> {
    /// What is copied.
    pub from: &'c Circuit,
    /// The copy.
    pub to: Circuit,
    nets: Vec<Net>,
    registers: Vec<Option<RegisterId>>,
    /// New registers, the net of the circuit that is copied that each takes, maybe inverted, and
    /// what enables it.
    new: Vec<(RegisterId, Net, bool, Option<Net>)>,
}

impl<'c> Rebuild<'c> {
    /// The copy of a net that was met before.
    pub fn net(&self, net: Net) -> Net {
        self.nets[index(net)]
    }

    /// The copy of a register, with another width if need be.
    pub fn register(&mut self, id: RegisterId, width: u32) -> Net {
        self.register_from(id, width, self.from.registers[id].reset)
    }

    /// The copy of a register with another reset value.
    pub fn register_from(&mut self, id: RegisterId, width: u32, reset: u64) -> Net {
        let name = self.from.registers[id].name.clone();
        let (copy, net) = self.to.register(name, width, reset);
        self.registers[index(id)] = Some(copy);
        net
    }

    /// A new register of one bit that takes a net, which may stand behind it, or what it is not,
    /// whenever a register of the circuit that is copied takes something.
    pub fn new_register(
        &mut self,
        name: &str,
        reset: bool,
        next: Net,
        inverted: bool,
        with: RegisterId,
    ) -> Net {
        let (id, net) = self.to.register(name, 1, u64::from(reset));
        self.new.push((id, next, inverted, self.from.registers[with].enable));
        net
    }

    /// A cell as it was.
    pub fn copy(&mut self, cell: Cell) -> Net {
        match cell.op {
            Op::Input(_) => self.to.cells.alloc(cell),
            Op::Register(id) => self.register(id, cell.width),
            Op::Port(instance, output) => self.to.port(instance, output as usize, cell.width),
            Op::Const(_)
            | Op::Not(_)
            | Op::And(_)
            | Op::Or(_)
            | Op::Xor(..)
            | Op::Mux { .. }
            | Op::Add(..)
            | Op::Sub(..)
            | Op::Mul(..)
            | Op::Div(..)
            | Op::Rem(..)
            | Op::Eq(..)
            | Op::Less { .. }
            | Op::Extend { .. }
            | Op::Slice { .. }
            | Op::Concat(_) => {
                let Rebuild { from, to, nets, .. } = self;
                copy_cell(to, from, cell, |net| nets[index(net)])
            }
        }
    }

    fn finish(mut self) -> Circuit {
        let Rebuild { from, to, nets, registers, new } = &mut self;
        for &mut (id, next, inverted, enable) in new {
            let next = nets[index(next)];
            let next = if inverted { to.not(next) } else { next };
            to.drive(id, next);
            to.registers[id].enable = enable.map(|net| nets[index(net)]);
        }
        for ((_, register), copy) in from.registers.iter().zip(registers) {
            if let Some(copy) = *copy {
                let width = to.registers[copy].width;
                let next = to.slice(nets[index(register.next)], 0, width);
                to.drive(copy, next);
                to.registers[copy].enable = register.enable.map(|net| nets[index(net)]);
            }
        }
        let moved = |net: &mut Net| *net = nets[index(*net)];
        for instance in to.instances.values_mut() {
            instance.inputs.iter_mut().chain(&mut instance.enable).for_each(moved);
        }
        for output in &from.outputs {
            to.output(output.name.clone(), nets[index(output.net)]);
        }
        for signal in &from.signals {
            let mut signal = signal.clone();
            signal.net = nets[index(signal.net)];
            // A name belongs to what was computed and not to the zeros before it.
            if let Op::Extend { from, .. } = to.cell(signal.net).op {
                signal.net = from;
            }
            to.signals.push(signal);
        }
        self.to
    }
}

/// Copies a circuit; `make` says what becomes of each cell. Operands come before their users,
/// names and sections stay with what they belong to.
pub fn rebuild(
    from: &Circuit,
    mut make: impl FnMut(&mut Rebuild<'_>, Net, Cell) -> Net,
) -> Circuit {
    let mut to = Circuit::new(&from.name);
    to.comment.clone_from(&from.comment);
    to.inputs.clone_from(&from.inputs);
    to.has_scan_ports = from.has_scan_ports;
    to.vectors.clone_from(&from.vectors);
    to.instances = from.instances.clone();
    let (nets, registers) = (Vec::with_capacity(from.len()), vec![None; from.registers.len()]);
    let mut rebuild = Rebuild { from, to, nets, registers, new: Vec::new() };
    let mut sections = from.sections.iter().peekable();
    for (net, cell) in from.cells() {
        while let Some(section) = sections.next_if(|section| section.start as usize <= index(net)) {
            let start = rebuild.to.len() as u32;
            rebuild.to.sections.push(Section { start, ..section.clone() });
        }
        let copy = make(&mut rebuild, net, cell);
        rebuild.nets.push(copy);
    }
    let end = rebuild.to.len() as u32;
    rebuild.to.sections.extend(sections.map(|section| Section { start: end, ..section.clone() }));
    rebuild.finish()
}
