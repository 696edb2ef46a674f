//! Chains of rungs that each read what the one above has written, so many that one clock may be
//! too short for them.

use super::index::Index;
use super::unwieldy::word;
use crate::diagnostic::{Diagnostic, code};
use crate::equations::{self, Chain};

pub(super) fn check(index: &Index, found: &mut Vec<Diagnostic>) {
    let program = index.program;
    let chain = Chain::new(program, &equations::lower(program));
    let clock_ns = 1_000_000_000 / index.clock_hz;
    let [fast_ns, slow_ns] = chain.ns();
    let (Some(&first), Some(&last)) = (chain.rungs.first(), chain.rungs.last()) else { return };
    if fast_ns <= clock_ns {
        return;
    }
    let message = format!("the longest chain of one scan is about {} gates", chain.gates);
    let last = word(&program.rungs[last as usize]);
    let first = word(&program.rungs[first as usize]);
    let mut diagnostic = Diagnostic::new(code::LONG_CHAIN, last, message).label("ends here");
    if first != last {
        let rungs = chain.rungs.len();
        diagnostic = diagnostic.also(first, format!("starts here and passes {rungs} rungs"));
    }
    found.push(diagnostic.help(format!(
        "a fast small FPGA takes some {fast_ns} ns for it, a slow one {slow_ns} ns, and the clock \
         leaves {clock_ns} ns: try it with your tools, declare a slower clock, build with \
         --schedule levels, or let a rung read the scan before"
    )));
}
