//! `=` or `<>` on the elapsed time of a timer.

use super::index::Index;
use super::walk::Comparison;
use crate::blocks::{Port, PortRole};
use crate::diagnostic::{Diagnostic, code};
use crate::model::{ArgumentValue, Expr, ExprKind, Instance, InstanceId, Relation, Role};
use crate::types::Type;

pub(super) fn check(index: &Index, found: &mut Vec<Diagnostic>) {
    for comparison in &index.comparisons {
        let Comparison { relation: Relation::Equal | Relation::NotEqual, sides, span } = comparison
        else {
            continue;
        };
        let [a, b] = sides;
        let running = elapsed_time(index, a)
            .map(|instance| (instance, b))
            .or_else(|| elapsed_time(index, b).map(|instance| (instance, a)));
        let Some((instance, other)) = running else { continue };
        if stands_still_at(index, instance, other) {
            continue;
        }
        let Instance { name, shape, .. } = &index.program.instances[instance];
        let (member, unit) = match shape.port_named("ET") {
            Some(_) => ("ET", "tick"),
            None => ("ACC", "unit of time"),
        };
        let output = shape.block.main.unwrap_or("DN");
        let message = format!("`{name}.{member}` is compared for equality while it runs");
        found.push(
            Diagnostic::new(code::RUNNING_EQUALITY, *span, message)
                .label(format!("holds for one {unit}, with all the scans in it"))
                .help(format!(
                    "compare with >= or <, or give the timer this time and read its {output}"
                )),
        );
    }
}

/// The timer whose elapsed time this is, in ticks or in units of its own.
fn elapsed_time(index: &Index, expr: &Expr) -> Option<InstanceId> {
    let ExprKind::Read(place) = &expr.kind else { return None };
    let variable = place.as_variable()?;
    let Role::Member(instance, port) = index.program.variables[variable].role else { return None };
    let shape = &index.program.instances[instance].shape;
    let counts_units = shape.unit_ns(index.program.tick_ns).is_some();
    let is_elapsed = match shape.ports[port] {
        Port { ty: Type::Time, role: PortRole::Output, .. } => true,
        Port { ty: Type::Bool, .. } => false,
        Port { role: PortRole::Output | PortRole::Accumulator(_), .. } => counts_units,
        _ => false,
    };
    is_elapsed.then_some(instance)
}

/// True if the elapsed time rests at that value: at 0 before it runs, at the preset after.
fn stands_still_at(index: &Index, id: InstanceId, value: &Expr) -> bool {
    let timer = &index.program.instances[id];
    let preset = ["PT", "PV", "PRE"].iter().find_map(|name| timer.shape.port_named(name));
    match &value.kind {
        ExprKind::Constant(0) => true,
        ExprKind::Constant(value) => {
            let given = preset.and_then(|port| index.argument(id, port));
            matches!(
                given.map(|argument| &argument.value),
                Some(ArgumentValue::Value(Expr { kind: ExprKind::Constant(given), .. }))
                    if given == value
            )
        }
        ExprKind::Read(place) => {
            preset.is_some_and(|port| place.as_variable() == Some(timer.members[port]))
        }
        _ => false,
    }
}
