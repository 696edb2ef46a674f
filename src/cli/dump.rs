//! A run of a test, written down as a value change dump.

use std::path::Path;

use hotrail::backend::Vcd;
use hotrail::eval::{Machine, Outcome, run_test_on};
use hotrail::files::{FileError, NewFile};
use hotrail::model::{Program, Test, VariableId};

/// How much is kept back before it is written, in scans.
const PIECE: u64 = 1024;

/// The longest part of a title in a file's name, in characters.
const LONGEST_TITLE: usize = 48;

/// The name, without its ending, of the files in which the test of that number, from 0, is written
/// down.
pub fn file_stem(program: &Program, number: usize, test: &Test) -> String {
    let is_word = |c: char| c.is_ascii_alphanumeric();
    let words: Vec<&str> = test.title.split(|c| !is_word(c)).filter(|w| !w.is_empty()).collect();
    let mut title = words.join("_");
    title.truncate(LONGEST_TITLE);
    format!("{}_{}_{title}", program.name, number + 1).trim_end_matches('_').to_owned()
}

/// Runs a test on a machine and writes every scan into a file.
pub fn run_test_dumped(
    machine: &mut impl Machine,
    program: &Program,
    test: &Test,
    path: &Path,
    source: &Path,
) -> Result<Outcome, FileError> {
    let variables: Vec<VariableId> = program.named_variables().map(|(id, _)| id).collect();
    let mut dumped = Dumped {
        machine,
        vcd: Vcd::new(program, &variables),
        file: NewFile::create(path, &[source.to_owned()])?,
        scans: 0,
        failure: None,
    };
    let outcome = run_test_on(&mut dumped, program, test);
    let Dumped { vcd, mut file, failure, .. } = dumped;
    if let Some(failure) = failure {
        return Err(failure);
    }
    file.write(&vcd.finish())?;
    file.finish()?;
    Ok(outcome)
}

/// A machine whose scans are written down.
struct Dumped<'m, M> {
    machine: &'m mut M,
    vcd: Vcd,
    file: NewFile,
    scans: u64,
    /// Why nothing can be written any more.
    failure: Option<FileError>,
}

impl<M: Machine> Machine for Dumped<'_, M> {
    fn reset(&mut self) {
        self.machine.reset();
    }

    fn drive(&mut self, input: VariableId, value: i64) {
        self.machine.drive(input, value);
    }

    fn scan(&mut self, tick: bool) {
        self.machine.scan(tick);
        if self.failure.is_some() {
            return;
        }
        self.vcd.scan(tick, |variable| self.machine.value(variable));
        self.scans += 1;
        if self.scans.is_multiple_of(PIECE) {
            self.failure = self.file.write(&self.vcd.take()).err();
        }
    }

    fn value(&self, variable: VariableId) -> i64 {
        self.machine.value(variable)
    }
}
