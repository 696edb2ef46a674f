//! The statements of the tests, one line of the testbench's process after the other.

use super::signals::{Shown, Wires};
use crate::backend::hdl::comment::Harmless;
use crate::eval::variables_of;
use crate::model::{Expect, Program, Statement};
use crate::source::Source;

/// A line of the test process.
pub struct Line {
    /// White space that shows how deep it stands in repetitions.
    pub indent: String,
    /// What it does.
    pub kind: LineKind,
}

/// What a line does.
pub enum LineKind {
    /// The test of this title starts, from reset.
    Start(String),
    /// The test of this number, from 1, and title is over.
    End(usize, String),
    /// Drives that many bits of an input with a value.
    Drive(String, u32, u64),
    /// Runs scans, with a tick each (`'1'`) or without.
    Scan(u64, char),
    /// Starts a repetition, counted under a name where the language wants one.
    Repeat(u64, String),
    /// Ends a repetition.
    EndRepeat,
    /// Back to reset.
    Reset,
    /// Checks the expectation of a number at a place, and shows these signals if it fails.
    Expect(usize, String, Vec<Shown>),
}

/// The lines of all tests.
pub fn lines(program: &Program, source: &Source, wires: &Wires) -> Vec<Line> {
    let mut printer = Printer { program, source, wires, lines: Vec::new(), depth: 0 };
    for (index, test) in program.tests.iter().enumerate() {
        // What follows a `#` would be an order to whoever reads the report.
        let title = plain(&test.title).replace('#', "\\#");
        printer.line(LineKind::Start(title.clone()));
        printer.line(LineKind::Reset);
        printer.statements(&test.statements);
        printer.line(LineKind::End(index + 1, title));
    }
    printer.lines
}

struct Printer<'a> {
    program: &'a Program,
    source: &'a Source,
    wires: &'a Wires,
    lines: Vec<Line>,
    depth: usize,
}

impl Printer<'_> {
    fn line(&mut self, kind: LineKind) {
        self.lines.push(Line { indent: "  ".repeat(self.depth), kind });
    }

    fn statements(&mut self, statements: &[Statement]) {
        for statement in statements {
            match statement {
                Statement::Drive(input, value) => {
                    let ty = input.ty(self.program);
                    let signal = self.wires.text(input.declared(), input.bit);
                    self.line(LineKind::Drive(signal, ty.width(), ty.bits(*value)));
                }
                Statement::Scan(scans) => self.line(LineKind::Scan(*scans, '0')),
                Statement::Wait(ticks) => self.line(LineKind::Scan(*ticks, '1')),
                Statement::Repeat(times, statements) => {
                    self.line(LineKind::Repeat(*times, counter(self.depth)));
                    self.depth += 1;
                    self.statements(statements);
                    self.depth -= 1;
                    self.line(LineKind::EndRepeat);
                }
                Statement::Reset => self.line(LineKind::Reset),
                Statement::Expect(expect) => self.expect(expect),
            }
        }
    }

    fn expect(&mut self, expect: &Expect) {
        let line = self.source.line(expect.span.start);
        let place = format!("{}:{line}", plain(self.source.file_name()));
        let values = variables_of(&expect.network)
            .iter()
            .map(|&variable| self.wires.shown(variable))
            .collect();
        self.line(LineKind::Expect(expect.index, place, values));
    }
}

/// What counts a repetition inside `depth` others: one must not hide another.
fn counter(depth: usize) -> String {
    if depth == 0 { "round".to_owned() } else { format!("round_{}", depth + 1) }
}

/// The names of all that count repetitions.
pub fn counters(program: &Program) -> impl Iterator<Item = String> {
    fn deepest(statements: &[Statement]) -> usize {
        let inside = statements.iter().map(|statement| match statement {
            Statement::Repeat(_, statements) => 1 + deepest(statements),
            _ => 0,
        });
        inside.max().unwrap_or(0)
    }
    let deepest = program.tests.iter().map(|test| deepest(&test.statements)).max();
    (0..deepest.unwrap_or(0)).map(counter)
}

/// A text that means the same in a string of either language.
fn plain(text: &str) -> String {
    Harmless::ascii(text).to_string().replace('\\', "/").replace('"', "'")
}

/// A text of [`LineKind`] in a string of Verilog, where a backslash stands for itself if doubled.
pub fn verilog_string(text: &str) -> String {
    text.replace('\\', r"\\")
}

/// The lowest bits of a number, highest first.
pub fn binary(bits: &u64, width: &u32) -> String {
    format!("{bits:0width$b}", width = *width as usize)
}
