//! The printed ports of a circuit: one for each port of it, but one for all elements of an array.

use std::ops::Range;

use super::names::{NameId, Namer, SCAN_DONE, SCAN_START, TICK};
use crate::circuit::Circuit;

/// A printed port.
#[derive(Clone, Debug)]
pub struct Port {
    /// Its name.
    pub name: NameId,
    /// Its width in bits, that of all its elements together.
    pub width: u32,
    /// The circuit's ports that it shows, the first lowest.
    pub parts: Range<usize>,
    /// They are elements of an array.
    pub is_array: bool,
}

impl Port {
    /// The bits of each element: the circuit's port, its lowest bit, its width.
    pub fn elements(&self) -> impl Iterator<Item = (usize, u32, u32)> + use<> {
        let width = self.width / self.parts.len() as u32;
        self.parts.clone().zip(0..).map(move |(part, place)| (part, place * width, width))
    }
}

/// Names the input and output ports, as everything outside of the module needs them.
pub fn name(circuit: &Circuit, namer: &mut Namer) -> (Vec<Port>, Vec<Port>) {
    let inputs = circuit.inputs.iter().map(|input| (&*input.name, input.width));
    let outputs = circuit.outputs.iter().map(|output| (&*output.name, circuit.width(output.net)));
    (ports(circuit, namer, inputs, true), ports(circuit, namer, outputs, false))
}

fn ports<'c>(
    circuit: &Circuit,
    namer: &mut Namer,
    all: impl Iterator<Item = (&'c str, u32)>,
    is_input: bool,
) -> Vec<Port> {
    let mut vectors =
        circuit.vectors.iter().filter(|vector| vector.is_input == is_input).peekable();
    let mut ports: Vec<Port> = Vec::new();
    let has_scan = circuit.has_scan_ports;
    let last = circuit.outputs.len().wrapping_sub(1);
    for (index, (name, width)) in all.enumerate() {
        if let Some(port) = ports.last_mut()
            && port.parts.contains(&index)
        {
            port.width += width;
            continue;
        }
        let vector = vectors.next_if(|vector| vector.first == index);
        let name = match (name, vector) {
            (_, Some(vector)) => namer.take(&vector.name, ""),
            (TICK, None) if is_input && index == 0 => namer.fix(TICK),
            _ if has_scan && is_input && index == 1 => namer.fix(SCAN_START),
            _ if has_scan && !is_input && index == last => namer.fix(SCAN_DONE),
            (name, None) => namer.take(name, ""),
        };
        let parts = index..index + vector.map_or(1, |vector| vector.length);
        ports.push(Port { name, width, parts, is_array: vector.is_some() });
    }
    ports
}
