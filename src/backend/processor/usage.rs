//! Which variables the rungs of a program name.

use std::collections::HashSet;

use crate::model::{ArgumentValue, Element, Program, VariableId};

/// Every variable that a rung reads or writes by its name.
pub(super) fn named(program: &Program) -> HashSet<VariableId> {
    let mut named = HashSet::new();
    for rung in &program.rungs {
        elements(&rung.network, &mut named);
    }
    named
}

fn elements(network: &[Element], named: &mut HashSet<VariableId>) {
    for element in network {
        match element {
            Element::Contact { place, .. }
            | Element::Edge { place, .. }
            | Element::Coil { target: place, .. } => place.for_each_variable(&mut name(named)),
            Element::Assign { target, value, .. } => {
                target.for_each_variable(&mut name(named));
                value.for_each_variable(&mut name(named));
            }
            Element::Compare(expr, _) => expr.for_each_variable(&mut name(named)),
            Element::Parallel(branches) => {
                branches.iter().for_each(|branch| elements(branch, named));
            }
            Element::Net(net) => {
                net.connections.iter().for_each(|way| elements(&way.network, named));
            }
            Element::Call(call) => {
                for argument in call.arguments.iter().chain(&call.starts) {
                    match &argument.value {
                        ArgumentValue::Network(network) => elements(network, named),
                        ArgumentValue::Value(expr) => expr.for_each_variable(&mut name(named)),
                    }
                }
            }
            Element::Constant(_)
            | Element::OneShot { .. }
            | Element::Invert
            | Element::ResetInstance(_) => {}
        }
    }
}

fn name(named: &mut HashSet<VariableId>) -> impl FnMut(VariableId) {
    |variable| {
        named.insert(variable);
    }
}
