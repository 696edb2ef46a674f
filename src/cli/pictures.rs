//! Pictures of a run: the ladder with the power of a scan, and timing diagrams.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use anyhow::bail;

use hotrail::draw::{self, Drawing, Glyphs, Look};
use hotrail::eval::{Evaluator, Flow, Stimulus};
use hotrail::files::{FileError, NewFile};
use hotrail::model::Program;
use hotrail::source::Source;

use super::report::Report;

/// The moment of a scan, as drawings say it.
pub fn moment(scan: usize) -> String {
    format!("power in scan {scan}")
}

/// What goes on in a scan of a run, from 0, and which one it is; in the last one of the stimulus if none is said. Behind
/// the last row its values are held.
pub fn at(
    program: &Program,
    stimulus: &Stimulus,
    scan: Option<usize>,
) -> anyhow::Result<(Flow, String)> {
    let Some(last) = scan.or(stimulus.len().checked_sub(1)) else {
        bail!("the stimulus has no row, so there is no scan; --at SCAN holds all inputs at 0");
    };
    let mut evaluator = Evaluator::new(program);
    for scan in 0..last {
        let row = stimulus.row(scan);
        row.drives.iter().for_each(|&(input, value)| evaluator.drive(input, value));
        evaluator.scan(row.tick);
    }
    let row = stimulus.row(last);
    row.drives.iter().for_each(|&(input, value)| evaluator.drive(input, value));
    Ok((evaluator.scan_seen(row.tick), moment(last)))
}

/// The ladder with the power of a scan.
pub fn power(source: &Source, flow: &Flow, scan: usize) -> Drawing {
    let drawing = Drawing::with_flow(source, &draw::Options::default(), flow);
    Drawing { moment: Some(moment(scan)), ..drawing }
}

/// Writes a picture into a file, which must not be one of the sources.
pub fn write(path: &Path, picture: &str, sources: &[PathBuf]) -> Result<(), FileError> {
    let mut file = NewFile::create(path, sources)?;
    file.write(picture.as_bytes())?;
    file.finish()
}

/// The text of a drawing, with colours where they can be seen.
pub fn terminal_text(drawing: &Drawing, glyphs: Glyphs, report: &Report) -> String {
    if !report.colors_results() {
        return drawing.text(glyphs);
    }
    let mut text = String::new();
    for line in drawing.lines(glyphs) {
        for piece in line {
            match color(piece.look) {
                None => text += &piece.text,
                Some(color) => {
                    write!(text, "\x1b[{color}m{}\x1b[0m", piece.text)
                        .expect("memory can be written");
                }
            }
        }
        text.push('\n');
    }
    text
}

/// The terminal's code for a look.
fn color(look: Look) -> Option<&'static str> {
    match look {
        Look::Plain => None,
        Look::Live => Some("1;32"),
        Look::Value => Some("36"),
        Look::Decides => Some("1;33"),
    }
}
