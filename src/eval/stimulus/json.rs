//! A stimulus as JSON lines: one object for each scan, with the inputs that it drives.

use serde_json::{Map, Value};

use super::Reader;
use crate::diagnostic::{Diagnostic, code};
use crate::source::{Source, Span};

/// Reads a whole text; lines without anything in them are no rows.
pub(super) fn read(reader: &mut Reader<'_>, source: &Source) {
    let mut start = 0;
    for line in source.text().split_inclusive('\n') {
        let text = line.trim_start_matches('\u{feff}');
        let here = start + line.len() - text.len();
        start += line.len();
        if text.trim().is_empty() {
            continue;
        }
        if reader.is_full() {
            return;
        }
        take_row(reader, text.trim_end(), here);
    }
}

fn take_row(reader: &mut Reader<'_>, text: &str, start: usize) {
    let row: Map<String, Value> = match serde_json::from_str(text) {
        Ok(row) => row,
        Err(error) => {
            // serde counts bytes from 1, and 0 or one more where the line ends too early.
            let before = text.char_indices().take_while(|(at, _)| *at < error.column().max(1));
            let (at, found) = before.last().unwrap_or((0, '{'));
            let at = start + at;
            let problem = error.to_string();
            let problem = problem.split(" at line ").next().unwrap_or_default();
            let finding = Diagnostic::new(
                code::BAD_STIMULUS,
                Span::new(at, at + found.len_utf8()),
                "this line is no JSON object",
            );
            let help = r#"one object stands in each line: {"start": 1, "level": -20}"#;
            return reader.report(finding.label(problem).help(help));
        }
    };
    let mut tick = true;
    for (name, value) in &row {
        let place = || place_of(text, start, name);
        let Some(column) = reader.column(name, place) else { continue };
        match value {
            Value::Null => {}
            Value::String(text) => reader.cell(column, text.trim(), &mut tick, place),
            other => reader.cell(column, &other.to_string(), &mut tick, place),
        }
    }
    reader.end_row(tick);
}

/// Where an object names a column, if it writes the name as it is.
fn place_of(text: &str, start: usize, name: &str) -> Span {
    let quoted = Value::from(name).to_string();
    match text.find(&quoted) {
        Some(at) => Span::new(start + at, start + at + quoted.len()),
        None => Span::new(start, start + text.len()),
    }
}
