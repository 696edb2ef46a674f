//! A stimulus as CSV: a header with the names of inputs, then one row for each scan.

use std::collections::HashMap;

use csv::{ByteRecord, Error, ErrorKind, ReaderBuilder, Trim, Writer};

use super::{Column, Reader, Stimulus, TICK};
use crate::diagnostic::{Diagnostic, code};
use crate::model::{Program, Role, VariableId};
use crate::source::{Source, Span};

/// Reads a whole text.
pub(super) fn read(reader: &mut Reader<'_>, source: &Source) {
    let text = source.text();
    let delimiter = delimiter(text);
    let mut rows = ReaderBuilder::new()
        .delimiter(delimiter)
        .has_headers(false)
        .trim(Trim::All)
        .from_reader(text.as_bytes());
    let mut columns: Option<Vec<Column>> = None;
    let mut row = ByteRecord::new();
    while !reader.is_full() {
        match rows.read_byte_record(&mut row) {
            Ok(false) => break,
            Ok(true) => {}
            Err(error) => return reader.report(ill_formed(&error, text)),
        }
        let place = Place { text, delimiter, row: &row };
        match &columns {
            Some(columns) => take_row(reader, columns, &place),
            None => match header(reader, &place) {
                Some(header) => columns = Some(header),
                None => return,
            },
        }
    }
    if columns.is_none() {
        let finding = Diagnostic::new(code::BAD_STIMULUS, Span::new(0, 0), "the stimulus is empty")
            .label("no header")
            .help("the first row holds the names of inputs, such as start,stop");
        reader.report(finding);
    }
}

/// A whole text of a stimulus.
pub(super) fn write(stimulus: &Stimulus, program: &Program) -> String {
    let inputs: Vec<VariableId> = program.with_role(Role::Input).map(|(id, _)| id).collect();
    // A name in back-ticks is taken neither for the tick nor for a member.
    let is_plain = |c: char| c.is_alphanumeric() || "_[]".contains(c);
    let quoted = |name: &str| match name != TICK && name.chars().all(is_plain) {
        true => name.to_owned(),
        false => format!("`{name}`"),
    };
    let names = inputs.iter().map(|&input| quoted(&program.variables[input].name));
    let header: Vec<String> = [TICK.to_owned()].into_iter().chain(names).collect();
    let column: HashMap<VariableId, usize> = inputs.iter().copied().zip(1..).collect();
    let mut rows = Writer::from_writer(Vec::new());
    rows.write_record(&header).expect("memory can be written");
    for scan in 0..stimulus.len() {
        let row = stimulus.row(scan);
        let blank = if scan == 0 { "0" } else { "" };
        let mut cells = vec![blank.to_owned(); header.len()];
        cells[0] = u8::from(row.tick).to_string();
        row.drives.iter().for_each(|(input, value)| cells[column[input]] = value.to_string());
        rows.write_record(&cells).expect("memory can be written");
    }
    let text = rows.into_inner().expect("memory can be written");
    String::from_utf8(text).expect("names are text")
}

/// What stands between two cells: a comma; a semicolon or a tab where the header has these only.
fn delimiter(text: &str) -> u8 {
    let header = text.lines().find(|line| !line.trim().is_empty()).unwrap_or("");
    let is_used = |delimiter: &u8| header.contains(char::from(*delimiter));
    *b",;\t".iter().find(|delimiter| is_used(delimiter)).unwrap_or(&b',')
}

fn header(reader: &mut Reader<'_>, place: &Place<'_>) -> Option<Vec<Column>> {
    let mut seen: HashMap<Column, usize> = HashMap::new();
    let mut columns = Vec::new();
    for cell in 0..place.row.len() {
        let Some(column) = reader.column(place.cell(cell), || place.span(cell)) else { continue };
        if let Some(first) = seen.insert(column, cell) {
            let message = format!("there are two columns `{}`", place.cell(cell));
            let finding = Diagnostic::new(code::BAD_COLUMN, place.span(cell), message)
                .label("the second")
                .also(place.span(first), "the first")
                .help("take one of them out");
            reader.report(finding);
        }
        columns.push(column);
    }
    (columns.len() == place.row.len() && reader.findings.is_empty()).then_some(columns)
}

fn take_row(reader: &mut Reader<'_>, columns: &[Column], place: &Place<'_>) {
    let mut tick = true;
    for (cell, &column) in columns.iter().enumerate() {
        let text = place.cell(cell);
        if !text.is_empty() {
            reader.cell(column, text, &mut tick, || place.span(cell));
        }
    }
    reader.end_row(tick);
}

fn ill_formed(error: &Error, text: &str) -> Diagnostic {
    let start = error.position().map_or(0, |position| position.byte() as usize);
    let line = text[start..].lines().find(|line| !line.is_empty()).unwrap_or("");
    let start = start + text[start..].find(line).unwrap_or(0);
    let span = Span::new(start, start + line.len());
    let finding = |message: String, label: String| {
        Diagnostic::new(code::BAD_STIMULUS, span, message)
            .label(label)
            .help("an empty cell keeps the value of the row before: a,b then 1,")
    };
    match error.kind() {
        ErrorKind::UnequalLengths { expected_len, len, .. } => {
            let count = |n: u64| if n == 1 { "1 cell".to_owned() } else { format!("{n} cells") };
            let message = format!("a row has {} under a header of {expected_len}", count(*len));
            let missing = if len > expected_len { "too many" } else { "missing" };
            finding(message, format!("{} {missing}", count(expected_len.abs_diff(*len))))
        }
        _ => finding("the stimulus is no table".to_owned(), error.to_string()),
    }
}

/// A row in its text.
struct Place<'a> {
    text: &'a str,
    delimiter: u8,
    row: &'a ByteRecord,
}

impl Place<'_> {
    /// The text of a cell, without quotes.
    fn cell(&self, cell: usize) -> &str {
        let bytes = self.row.get(cell).unwrap_or_default();
        let text = std::str::from_utf8(bytes).expect("cells of a text are cut at its characters");
        text.trim_start_matches('\u{feff}')
    }

    /// Where a cell stands, quotes and all. The reader counts records, not cells.
    fn span(&self, cell: usize) -> Span {
        let from = self.row.position().map_or(0, |position| position.byte() as usize);
        let text = &self.text[from..];
        let blank = text.len() - text.trim_start_matches(['\u{feff}', '\n', '\r']).len();
        let (mut start, mut left, mut quoted) = (from + blank, cell, false);
        for (at, byte) in text.bytes().enumerate().skip(blank) {
            quoted ^= byte == b'"';
            let ends_row = byte == b'\n' || byte == b'\r';
            if quoted || (byte != self.delimiter && !ends_row) {
                continue;
            }
            if left == 0 || ends_row {
                return trimmed(self.text, start, from + at);
            }
            left -= 1;
            start = from + at + 1;
        }
        trimmed(self.text, start, self.text.len())
    }
}

fn trimmed(text: &str, start: usize, end: usize) -> Span {
    let cell = &text[start..end];
    let start = start + cell.len() - cell.trim_start().len();
    Span::new(start, start + cell.trim().len())
}
