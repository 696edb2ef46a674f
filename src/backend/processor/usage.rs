//! Which variables the rungs of a program name.

use std::collections::HashSet;

use crate::model::{ArgumentValue, Element, Expr, ExprKind, Program, VariableId};

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
            Element::Contact { variable, .. } | Element::Edge { variable, .. } => {
                named.insert(*variable);
            }
            Element::Coil { target, .. } => {
                named.insert(*target);
            }
            Element::Assign { target, value, .. } => {
                named.insert(*target);
                expression(value, named);
            }
            Element::Compare(expr, _) => expression(expr, named),
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
                        ArgumentValue::Value(expr) => expression(expr, named),
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

fn expression(expr: &Expr, named: &mut HashSet<VariableId>) {
    match &expr.kind {
        ExprKind::Constant(_) => {}
        ExprKind::Read(variable) => {
            named.insert(*variable);
        }
        ExprKind::Not(operand) => expression(operand, named),
        ExprKind::Binary(_, a, b) | ExprKind::Compare(_, a, b) => {
            expression(a, named);
            expression(b, named);
        }
    }
}
