//! Contacts that stand above the rung with their coil, and so see the value of the scan before.

use std::collections::HashMap;

use super::index::Index;
use super::more_places;
use super::walk::{Part, Read, Write, Writing};
use crate::diagnostic::{Diagnostic, code};
use crate::index::index as at;
use crate::model::VariableId;

pub(super) fn check(index: &Index, found: &mut Vec<Diagnostic>) {
    let mut stale: Vec<(Write, Read)> =
        index.reads.iter().filter_map(|&read| Some((coil_below(index, read)?, read))).collect();
    if stale.is_empty() {
        return;
    }
    // By the rung of the coil, so that what that rung reads is marked once.
    stale.sort_by_key(|(coil, read)| (coil.rung, read.span));
    let mut marks = vec![u32::MAX; index.program.variables.len()];
    let mut counts: HashMap<(VariableId, Part), usize> = HashMap::new();
    let mut first_reads: Vec<(Write, Read)> = Vec::new();
    for of_rung in stale.chunk_by(|(a, _), (b, _)| a.rung == b.rung) {
        let writer = of_rung[0].0.rung;
        for read in index.reads_in(writer) {
            marks[at(read.variable)] = writer;
        }
        for &(coil, read) in of_rung {
            // Where each of the two rungs reads the other's coil, no order helps: an interlock.
            let mut written = index.writes_in(read.rung).iter();
            if written.any(|write| marks[at(write.variable)] == writer) {
                continue;
            }
            let count = counts.entry((read.variable, read.part)).or_default();
            *count += 1;
            if *count == 1 {
                first_reads.push((coil, read));
            }
        }
    }
    found.extend(first_reads.into_iter().map(|(coil, read)| {
        let name = index.part_name(read.variable, read.part);
        let message = format!("`{name}` is read above the rung that writes it");
        let and = more_places(counts[&(read.variable, read.part)] - 1)
            .map(|places| format!("; so do {places}"));
        Diagnostic::new(code::READ_ABOVE, read.span, message)
            .label(format!("sees the value of the scan before{}", and.unwrap_or_default()))
            .also(coil.span, "written here")
            .help("if it shall follow in the same scan, move the rung that writes it up")
    }));
}

/// The first write of what is read, if that is a coil in a rung below.
fn coil_below(index: &Index, read: Read) -> Option<Write> {
    let mut writes = index.writes_of(read.variable).iter();
    let first = writes.find(|write| write.part.overlaps(read.part))?;
    let is_its_coil = first.how == Writing::Coil && first.part == read.part;
    (is_its_coil && first.rung > read.rung).then_some(*first)
}
