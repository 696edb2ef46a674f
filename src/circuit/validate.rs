//! The proof token: a design that keeps every rule that the operations state.

use std::collections::HashMap;
use std::fmt;
use std::ops::Deref;

use super::{Cell, Circuit, Design, ModuleId, Net, Op};
use crate::index::index;

/// Something that keeps its rules. Only [`Design::validate`] makes it.
#[derive(Clone, Debug)]
pub struct Valid<T>(T);

impl<T> Deref for Valid<T> {
    type Target = T;

    fn deref(&self) -> &T {
        &self.0
    }
}

/// A broken rule: a mistake in the compiler, never in a program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Invalid {
    /// Name of the circuit.
    pub circuit: String,
    /// The rule and where it is broken.
    pub message: String,
}

impl fmt::Display for Invalid {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "circuit {}: {}", self.circuit, self.message)
    }
}

impl std::error::Error for Invalid {}

impl Design {
    /// Checks every circuit.
    ///
    /// # Errors
    /// The first broken rule.
    pub fn validate(self) -> Result<Valid<Design>, Invalid> {
        for (id, circuit) in self.modules.iter() {
            check_circuit(&self, id, circuit)
                .map_err(|message| Invalid { circuit: circuit.name.clone(), message })?;
        }
        Ok(Valid(self))
    }
}

fn ensure(holds: bool, message: impl FnOnce() -> String) -> Result<(), String> {
    if holds { Ok(()) } else { Err(message()) }
}

fn check_circuit(design: &Design, id: ModuleId, circuit: &Circuit) -> Result<(), String> {
    for (net, cell) in circuit.cells() {
        let mut ordered = true;
        circuit.for_each_operand(cell, |operand| ordered &= operand.into_raw() < net.into_raw());
        ensure(ordered, || format!("{net:?} uses a cell behind it"))?;
        ensure((1..=64).contains(&cell.width), || format!("{net:?} has {} bits", cell.width))?;
        ensure(has_right_widths(design, circuit, cell), || {
            format!("the widths around {net:?}, {cell:?}, do not fit")
        })?;
    }
    check_ports(design, circuit)?;
    let exists = |net: Net| (index(net)) < circuit.len();
    for (_, register) in circuit.registers.iter() {
        ensure(exists(register.next) && circuit.width(register.next) == register.width, || {
            format!("register {} has no next value of its width", register.name)
        })?;
    }
    let enables = circuit.registers.values().filter_map(|register| register.enable);
    let mut enables = enables.chain(circuit.instances.values().filter_map(|one| one.enable));
    ensure(enables.all(|net| exists(net) && circuit.width(net) == 1), || {
        "what enables is no bit".to_owned()
    })?;
    for (_, instance) in circuit.instances.iter() {
        let module = &design.modules[instance.module];
        ensure(module.inputs.len().max(module.outputs.len()) <= 64, || {
            format!("module {} has more than 64 ports of one kind", module.name)
        })?;
        let inputs = &module.inputs;
        let fit = inputs.len() == instance.inputs.len()
            && inputs
                .iter()
                .zip(&instance.inputs)
                .all(|(input, &net)| exists(net) && circuit.width(net) == input.width);
        ensure(fit && instance.module.into_raw() < id.into_raw(), || {
            format!("the inputs of instance {} do not fit its module", instance.name)
        })?;
    }
    ensure(circuit.outputs.iter().all(|output| exists(output.net)), || {
        "an output shows nothing".to_owned()
    })
}

/// An output of an instance may stand only behind those inputs that it depends on in the scan.
fn check_ports(design: &Design, circuit: &Circuit) -> Result<(), String> {
    let mut needs: HashMap<ModuleId, Vec<u64>> = HashMap::new();
    for (net, cell) in circuit.cells() {
        let Op::Port(id, output) = cell.op else { continue };
        let instance = &circuit.instances[id];
        let module = instance.module;
        let needs =
            needs.entry(module).or_insert_with(|| inputs_of_outputs(&design.modules[module]));
        let mut inputs = instance.inputs.iter().enumerate();
        let given = inputs.all(|(port, input)| {
            needs[output as usize] >> port & 1 == 0 || input.into_raw() < net.into_raw()
        });
        ensure(given, || format!("{net:?} of instance {} depends on itself", instance.name))?;
    }
    Ok(())
}

/// For each output port the set of input ports that it depends on within the scan.
fn inputs_of_outputs(module: &Circuit) -> Vec<u64> {
    let mut needs: Vec<u64> = Vec::with_capacity(module.len());
    for (_, cell) in module.cells() {
        let mut set = 0;
        module.for_each_operand(cell, |operand| set |= needs[index(operand)]);
        if let Op::Input(port) = cell.op {
            set = 1 << port;
        }
        needs.push(set);
    }
    module.outputs.iter().map(|output| needs[index(output.net)]).collect()
}

fn has_right_widths(design: &Design, circuit: &Circuit, cell: Cell) -> bool {
    let width = |net: Net| circuit.width(net);
    let same = |nets: &[Net]| nets.iter().all(|&net| width(net) == cell.width);
    match cell.op {
        Op::Input(index) => circuit.inputs[index as usize].width == cell.width,
        Op::Register(id) => circuit.registers[id].width == cell.width,
        Op::Port(instance, output) => {
            let module = &design.modules[circuit.instances[instance].module];
            module.outputs.get(output as usize).is_some_and(|o| module.width(o.net) == cell.width)
        }
        Op::Const(value) => value & !super::mask(cell.width) == 0,
        Op::Not(from) => same(&[from]),
        Op::And(operands) | Op::Or(operands) => {
            circuit.list(operands).len() > 1 && same(circuit.list(operands))
        }
        Op::Xor(a, b)
        | Op::Add(a, b)
        | Op::Sub(a, b)
        | Op::Mul(a, b)
        | Op::Div(a, b)
        | Op::Rem(a, b) => same(&[a, b]),
        Op::Mux { select, on, off } => width(select) == 1 && same(&[on, off]),
        Op::Eq(a, b) | Op::Less { a, b, .. } => cell.width == 1 && width(a) == width(b),
        Op::Extend { from, .. } => width(from) < cell.width,
        Op::Slice { from, low } => low + cell.width <= width(from),
        Op::Concat(operands) => {
            let list = circuit.list(operands);
            list.len() > 1 && list.iter().map(|&net| width(net)).sum::<u32>() == cell.width
        }
    }
}
