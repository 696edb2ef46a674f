//! Makes the output ports of modules as wide as what they show.

use super::rebuild::rebuild;
use crate::circuit::{Circuit, Op};
use crate::index::index;

/// What a module shows at an output port.
pub enum Shown {
    /// A word of the port's width.
    Word {
        /// Copies of its top bit go before it where it is read, else zeros.
        signed: bool,
    },
    /// These bits, always.
    Constant(u64),
}

/// Takes what only fills up a word from the output ports of a module, and says what is left.
pub fn narrow_outputs(module: &mut Circuit) -> Vec<Shown> {
    let mut outputs = std::mem::take(&mut module.outputs);
    let shown = outputs.iter_mut().map(|output| match module.cell(output.net).op {
        Op::Const(bits) => Shown::Constant(bits),
        Op::Extend { from, signed } => {
            output.net = from;
            Shown::Word { signed }
        }
        _ => Shown::Word { signed: false },
    });
    let shown = shown.collect();
    module.outputs = outputs;
    shown
}

/// The circuit with every word from a module's port filled up to its old width. `modules` are
/// those that it instantiates, with what [`narrow_outputs`] said of each.
pub fn read_narrow(circuit: &Circuit, modules: &[(Circuit, Vec<Shown>)]) -> Circuit {
    rebuild(circuit, |rebuild, _, cell| {
        let Op::Port(instance, output) = cell.op else { return rebuild.copy(cell) };
        let (module, shown) = &modules[index(circuit.instances[instance].module)];
        let output = output as usize;
        match shown[output] {
            Shown::Constant(bits) => rebuild.to.constant(bits, cell.width),
            Shown::Word { signed } => {
                let width = module.width(module.outputs[output].net);
                let port = rebuild.to.port(instance, output, width);
                rebuild.to.resize(port, cell.width, signed)
            }
        }
    })
}
