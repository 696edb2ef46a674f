//! What drives the inputs of a program from outside, scan by scan: a table of values, as CSV with
//! a header or as one JSON object in a line.

mod cell;
mod csv;
mod json;
mod of_test;

use super::Row;
use crate::diagnostic::{Diagnostic, code, shortened, similar_name};
use crate::model::{Names, Program, Role, VariableId};
use crate::source::{Source, Span};

/// The column that says which scans have the tick.
pub const TICK: &str = "tick";

/// Nobody mends more than these before looking again.
const MOST_FINDINGS: usize = 100;

/// The rows of a stimulus. An input keeps its value until a row drives it again.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Stimulus {
    /// What the rows drive, one after the other.
    drives: Vec<(VariableId, i64)>,
    /// For each row, where its part of `drives` ends, and whether it has the tick.
    rows: Vec<(usize, bool)>,
}

impl Stimulus {
    /// Reads a stimulus. A text whose first character is `{` is JSON lines, any other is CSV.
    ///
    /// # Errors
    /// What is wrong with it, by place.
    pub fn parse(program: &Program, source: &Source) -> Result<Stimulus, Vec<Diagnostic>> {
        let names = Names::of(program);
        let (stimulus, findings) = (Stimulus::default(), Vec::new());
        let mut reader = Reader { program, names, stimulus, findings };
        let text = source.text().trim_start_matches('\u{feff}');
        match text.trim_start().starts_with('{') {
            true => json::read(&mut reader, source),
            false => csv::read(&mut reader, source),
        }
        match reader.findings.is_empty() {
            true => Ok(reader.stimulus),
            false => {
                reader.findings.sort_by_key(|finding| finding.primary.span);
                Err(reader.findings)
            }
        }
    }

    /// Adds a row. Values are in range of their input's type.
    pub fn push(&mut self, tick: bool, drives: impl IntoIterator<Item = (VariableId, i64)>) {
        self.drives.extend(drives);
        self.rows.push((self.drives.len(), tick));
    }

    /// Keeps so many rows and forgets those behind them.
    pub fn truncate(&mut self, rows: usize) {
        self.rows.truncate(rows);
        self.drives.truncate(self.rows.last().map_or(0, |&(end, _)| end));
    }

    /// The stimulus as CSV, which [`Stimulus::parse`] reads back: a column for the tick and one for
    /// each input. A cell is empty where an input keeps its value; the first row has no empty cell.
    pub fn to_csv(&self, program: &Program) -> String {
        csv::write(self, program)
    }

    /// The value for an input that a person writes as in a stimulus.
    ///
    /// # Errors
    /// What should be written.
    pub fn value(program: &Program, input: VariableId, text: &str) -> Result<i64, String> {
        cell::value(program, input, text)
    }

    /// The number of rows.
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// True if there is no row.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// What happens in the scan of that number, from 0. Behind the last row its values are held,
    /// that of the tick too; without any row every scan has the tick.
    pub fn row(&self, scan: usize) -> Row<'_> {
        let Some(&(end, tick)) = self.rows.get(scan) else {
            return Row { tick: self.rows.last().is_none_or(|&(_, tick)| tick), drives: &[] };
        };
        let start = scan.checked_sub(1).map_or(0, |before| self.rows[before].0);
        Row { tick, drives: &self.drives[start..end] }
    }
}

/// What a column stands for.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
enum Column {
    Tick,
    Input(VariableId),
}

/// A stimulus that is being read, and what is wrong with it so far.
struct Reader<'p> {
    program: &'p Program,
    names: Names<'p>,
    stimulus: Stimulus,
    findings: Vec<Diagnostic>,
}

impl Reader<'_> {
    fn report(&mut self, finding: Diagnostic) {
        self.findings.push(finding);
    }

    fn is_full(&self) -> bool {
        self.findings.len() >= MOST_FINDINGS
    }

    /// Ends a row: what was driven since the last one belongs to it.
    fn end_row(&mut self, tick: bool) {
        self.stimulus.push(tick, []);
    }

    /// What a column of that name stands for, or a finding.
    fn column(&mut self, name: &str, span: impl Fn() -> Span) -> Option<Column> {
        if name == TICK {
            return Some(Column::Tick);
        }
        let variable = self.names.variable(name);
        match variable.map(|id| (id, self.program.variables[id].role)) {
            Some((id, Role::Input)) => return Some(Column::Input(id)),
            Some(_) => {
                let message = format!("`{}` is no input of the program", shortened(name));
                let finding = Diagnostic::new(code::BAD_COLUMN, span(), message)
                    .label("the program writes it")
                    .help("a stimulus drives inputs; take the column out");
                self.report(finding);
            }
            None => {
                let message = format!("no input is named `{}`", shortened(name));
                let label = if name.is_empty() { "an empty name" } else { "not declared" };
                let finding = Diagnostic::new(code::BAD_COLUMN, span(), message).label(label);
                self.report(finding.help(self.which_columns(name)));
            }
        }
        None
    }

    /// What a column may be named.
    fn which_columns(&self, name: &str) -> String {
        const MOST: usize = 12;
        let inputs: Vec<&str> =
            self.program.with_role(Role::Input).map(|(_, input)| &*input.name).collect();
        if let Some(similar) = similar_name(name, inputs.iter().copied()) {
            return format!("did you mean `{similar}`?");
        }
        let more = if inputs.len() > MOST { ", ..." } else { "" };
        let list: String = inputs.iter().take(MOST).map(|name| format!("`{name}`, ")).collect();
        format!("columns are {list}`tick`{more}")
    }

    /// Takes a cell that is not empty; a finding if its value does not fit.
    fn cell(&mut self, column: Column, text: &str, tick: &mut bool, place: impl Fn() -> Span) {
        let taken = match column {
            Column::Tick => cell::bit(text).map(|value| *tick = value),
            Column::Input(input) => cell::value(self.program, input, text)
                .map(|value| self.stimulus.drives.push((input, value))),
        };
        if let Err(help) = taken {
            let name = match column {
                Column::Tick => TICK,
                Column::Input(input) => &self.program.variables[input].name,
            };
            let message = format!("`{}` is no value for `{name}`", shortened(text));
            let label = match column {
                Column::Tick => "says whether the scan has the tick".to_owned(),
                Column::Input(input) => {
                    format!("`{name}` is of type {}", self.program.variables[input].ty)
                }
            };
            let finding = Diagnostic::new(code::BAD_CELL, place(), message);
            self.report(finding.label(label).help(help));
        }
    }
}
