//! Makes a design small: what a good engineer would have written for this program and no other.
//!
//! Each pass takes a circuit and gives one that shows the same at its outputs in every scan after
//! reset, whatever the inputs are. None looks at names: what is true of a timer is true of a
//! counter that a program makes out of a variable.

mod absorb;
mod ahead;
mod decide;
mod family;
mod fit;
#[cfg(test)]
mod gates;
mod inside;
mod merge;
mod narrow;
mod place;
mod ports;
mod rebuild;
#[cfg(test)]
mod same;
mod saturate;
mod share;
mod together;
mod unseen;

use super::{Circuit, Design};
use ports::Shown;

/// A pass: the better circuit, or nothing if there is nothing to do.
type Pass = fn(&Circuit) -> Option<Circuit>;

/// The passes over a circuit, in their order.
const PASSES: &[Pass] = &[
    absorb::absorb,
    decide::decide,
    merge::merge,
    narrow::narrow,
    saturate::saturate,
    // What stops sooner is narrower.
    narrow::narrow,
    ahead::compare_ahead,
    merge::merge,
    unseen::forget_unseen,
    share::share,
    together::move_together,
];

/// Fits the modules of a design to their instances and makes every circuit small. Behaviour at the
/// top's ports stays the same.
pub fn simplify(design: Design) -> Design {
    let mut fitted = fit::fit(design);
    if let Some(inside) = inside::compare_inside(&fitted) {
        // The words that need not leave any more go.
        fitted = fit::fit(inside);
    }
    let mut circuits: Vec<Circuit> = fitted.modules.into_iter().map(|(_, module)| module).collect();
    let top = circuits.pop().expect("a design has a top");
    if circuits.is_empty() {
        let better = reduce(&top);
        let is_better = better.is_some();
        let design = Design { modules: [better.unwrap_or(top)].into_iter().collect() };
        // Contacts and coils alone are done already: a large program is not copied for nothing.
        return if is_better { fit::fit(design) } else { design };
    }
    let modules: Vec<(Circuit, Vec<Shown>)> = circuits
        .into_iter()
        .map(|module| {
            let mut module = reduce(&module).unwrap_or(module);
            let shown = ports::narrow_outputs(&mut module);
            (module, shown)
        })
        .collect();
    let top = ports::read_narrow(&top, &modules);
    let top = reduce(&top).unwrap_or(top);
    let modules = modules.into_iter().map(|(module, _)| module).chain([top]).collect();
    // What only the larger circuits read goes.
    fit::fit(Design { modules })
}

/// What the passes make of a circuit, or nothing if none has anything to do.
fn reduce(circuit: &Circuit) -> Option<Circuit> {
    let one = |better: Option<Circuit>, pass: &Pass| {
        let next = pass(better.as_ref().unwrap_or(circuit));
        next.or(better)
    };
    PASSES.iter().fold(None, one)
}
