//! The signals of a testbench, one for each port of the tested design, and where each variable
//! stands in them.

use std::collections::HashMap;

use super::super::names::{Namer, SCAN_DONE, SCAN_START, TICK};
use super::super::{Language, PortNames};
use crate::model::{Program, Role, VariableId};

/// A signal at a port of the tested design.
pub struct Signal {
    pub name: String,
    pub width: u32,
    pub is_input: bool,
}

/// Where a variable stands.
struct Wire {
    signal: String,
    /// The width of the signal.
    of: u32,
    /// Its lowest bit there, and how many it has.
    low: u32,
    width: u32,
    /// Its index, if it is an element of an array.
    element: Option<u32>,
}

/// Where every variable that a test drives or looks at stands.
pub struct Wires {
    language: Language,
    by_variable: HashMap<VariableId, Wire>,
}

/// A value in the report of a failure.
pub struct Shown {
    /// How it is announced, without white space.
    pub label: String,
    /// What is shown.
    pub text: String,
}

impl Wires {
    /// A variable, or one bit of it, as the language has it.
    pub fn text(&self, variable: VariableId, bit: Option<u32>) -> String {
        let Wire { signal, of, low, width, .. } = &self.by_variable[&variable];
        let (low, width) = bit.map_or((*low, *width), |bit| (low + bit, 1));
        let high = low + width - 1;
        match (self.language, width) {
            _ if width == *of => signal.clone(),
            (Language::Verilog, 1) => format!("{signal}[{low}]"),
            (Language::Verilog, _) => format!("{signal}[{high}:{low}]"),
            (Language::Vhdl, 1) => format!("{signal}({low})"),
            (Language::Vhdl, _) => format!("{signal}({high} downto {low})"),
        }
    }

    /// A variable in a report.
    pub fn shown(&self, variable: VariableId) -> Shown {
        let Wire { signal, element, .. } = &self.by_variable[&variable];
        let index = element.map(|index| format!("[{index}]")).unwrap_or_default();
        Shown { label: format!("{signal}{index}"), text: self.text(variable, None) }
    }
}

/// A signal for each port of the tested design, which shows the `observed` variables beside its
/// own ports.
pub fn signals(
    program: &Program,
    observed: &[VariableId],
    ports: &PortNames,
    mut namer: Namer<'_>,
    language: Language,
) -> (Vec<Signal>, Wires) {
    // The first input is the tick, which is no variable.
    let tick = namer.fix(TICK);
    // Nor are those that say when a scan starts and ends.
    let scan = ports.has_scan_ports.then(|| [SCAN_START, SCAN_DONE].map(|name| namer.fix(name)));
    let inputs = ports.inputs.iter().skip(1 + usize::from(scan.is_some()));
    let outputs = ports.outputs.len() - usize::from(scan.is_some());
    let inputs = inputs.map(|port| (port, true));
    let outputs = ports.outputs[..outputs].iter().map(|port| (port, false));
    let named: Vec<_> = inputs
        .chain(outputs)
        .map(|(port, is_input)| (namer.take(&port.name, ""), port, is_input))
        .collect();
    let names = namer.finish();
    let with_role = |role| program.with_role(role).map(|(id, _)| id);
    let mut variables =
        with_role(Role::Input).chain(with_role(Role::Output)).chain(observed.iter().copied());
    let bit = |id, is_input| Signal { name: names.get(id).to_owned(), width: 1, is_input };
    let mut signals = vec![bit(tick, true)];
    signals.extend(scan.map(|[start, _]| bit(start, true)));
    let mut by_variable = HashMap::new();
    for (id, port, is_input) in named {
        let signal = names.get(id).to_owned();
        let elements = port.elements.unwrap_or(1);
        let width = port.width / elements;
        for (place, variable) in (0..elements).zip(&mut variables) {
            let element = port.elements.map(|_| place);
            let (signal, of, low) = (signal.clone(), port.width, place * width);
            by_variable.insert(variable, Wire { signal, of, low, width, element });
        }
        signals.push(Signal { name: signal, width: port.width, is_input });
    }
    signals.extend(scan.map(|[_, done]| bit(done, false)));
    (signals, Wires { language, by_variable })
}
