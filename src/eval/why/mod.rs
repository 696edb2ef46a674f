//! Why a variable is what it is: the contacts that conduct or block, followed back through coils,
//! blocks and scans to the inputs that decided it.

mod call;
mod explain;
mod power;
mod shown;
mod sites;
mod trace;
mod words;

pub use shown::ShownRung;

use super::Row;
use crate::model::{Program, VariableId};
use crate::source::Source;
use crate::types::Type;
use sites::Sites;
use trace::Trace;

/// A run that can be asked.
pub struct Why<'p> {
    program: &'p Program,
    source: &'p Source,
    sites: Sites<'p>,
    trace: Trace<'p>,
}

/// Something that holds, and why.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cause {
    /// What it is about.
    pub subject: Subject,
    /// Its value in that scan; of a condition whether it conducts.
    pub value: i64,
    /// Of which type that is.
    pub ty: Type,
    /// The scan in which it is looked at, from 0.
    pub scan: usize,
    /// The scan that is told of: that one, or the one before it that left the value.
    pub told_of: usize,
    /// The scan since which it has that value; nothing if since reset.
    pub since: Option<usize>,
    /// Where that comes from.
    pub reason: Reason,
    /// The contact or block in which it decided something, if that is what it did.
    pub looked: Option<Looked>,
    /// What made it so: all of these together.
    pub causes: Vec<Cause>,
}

/// What a cause is about.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Subject {
    /// A variable or member, by its name.
    Variable(String),
    /// An element that conducts or does not, as written.
    Condition(String),
    /// A coil that would write something else if it had power, as written.
    IdleCoil(String),
}

/// An element that looked at a variable, or at its own output.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Looked {
    /// The scan in which it did.
    pub scan: usize,
    /// Number of its rung, from 1.
    pub rung: usize,
    /// Its number in the rung, from 0 in text order.
    pub element: usize,
}

/// Where a value comes from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Reason {
    /// From outside.
    Input,
    /// Nothing has written it since reset.
    Reset,
    /// It is the first scan after reset, or is not.
    FirstScan,
    /// An element wrote it, or is it.
    Element(Place),
    /// A block's call wrote it.
    Call(Place, Power),
    /// Nothing wrote it in this scan: it is what it was.
    Kept,
    /// It has been explained above.
    Above,
    /// It lies deeper than asked for.
    Deeper,
}

/// An element of the program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// Number of the rung, from 1.
    pub rung: usize,
    /// The rung's title.
    pub title: Option<String>,
    /// The line, from 1.
    pub line: u32,
    /// Its number in the rung, from 0 in text order.
    pub element: usize,
    /// The element as written, short.
    pub text: String,
}

/// How a block is called.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Power {
    /// The power that arrives.
    pub is_on: bool,
    /// The scan since which it does; nothing if since reset.
    pub since: Option<usize>,
    /// The block's members after the call.
    pub members: Vec<(String, Type, i64)>,
}

impl<'p> Why<'p> {
    /// Runs a program from reset on these rows, one a scan.
    pub fn new<'r>(
        program: &'p Program,
        source: &'p Source,
        rows: impl Iterator<Item = Row<'r>>,
    ) -> Self {
        Why { program, source, sites: Sites::new(program), trace: Trace::new(program, rows) }
    }

    /// The number of scans.
    pub fn scans(&self) -> usize {
        self.trace.len()
    }

    /// Why a variable is what it is after a scan, back to that many steps.
    ///
    /// # Panics
    /// If there was no such scan.
    pub fn explain(&self, variable: VariableId, scan: usize, depth: usize) -> Cause {
        assert!(scan < self.scans(), "scan {scan} of {}", self.scans());
        let cause = explain::Explainer::new(self).variable(variable, scan, None, depth);
        // What nothing wrote in that scan is told of the scan that wrote it.
        Cause { scan, ..cause }
    }
}
