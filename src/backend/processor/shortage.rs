//! What a program asks for beyond what the processor has.

use super::sizes::Sizes;
use crate::diagnostic::{Diagnostic, code};
use crate::source::Span;

/// The processor has no more of that. What is asked for has been counted.
#[derive(Clone, Copy, Debug)]
pub struct NoRoom;

/// One kind of thing of which there is too little.
#[derive(Clone, Debug)]
struct Shortage {
    what: &'static str,
    /// How many there are.
    has: usize,
    /// How many more are asked for.
    lacks: usize,
    /// Where the first is asked for that is not there.
    span: Span,
}

/// Everything of which there is too little, each kind once.
#[derive(Clone, Debug, Default)]
pub struct Shortages(Vec<Shortage>);

impl Shortages {
    /// Counts what is asked for of a kind of which the processor has so many.
    pub fn ask(&mut self, what: &'static str, has: usize, lacks: usize, span: Span) -> NoRoom {
        match self.0.iter_mut().find(|known| known.what == what) {
            Some(known) => known.lacks += lacks,
            None => self.0.push(Shortage { what, has, lacks, span }),
        }
        NoRoom
    }

    /// What the user reads; nothing if there is enough of all.
    pub fn findings(&self, sizes: Sizes) -> impl Iterator<Item = Diagnostic> {
        self.0.iter().map(move |&Shortage { what, has, lacks, span }| {
            let need = has + lacks;
            let message =
                format!("the program needs {need} {what}, the ladder processor has {has}");
            full(span, message, sizes).label("from here on there is no room")
        })
    }
}

/// A finding about a limit of a processor of these sizes.
pub fn full(span: Span, message: String, sizes: Sizes) -> Diagnostic {
    let help = if sizes == Sizes::default() {
        "build it with --emit verilog or vhdl, or make two programs of it"
    } else {
        "give the processor more with --processor, or build it with --emit verilog or vhdl"
    };
    Diagnostic::new(code::PROCESSOR_FULL, span, message).help(help)
}
