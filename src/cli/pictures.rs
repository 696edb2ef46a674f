//! Pictures of a run: the ladder with the power of a scan, and timing diagrams.

use std::collections::HashSet;
use std::fmt::Write;
use std::path::{Path, PathBuf};

use anyhow::bail;

use hotrail::draw::{self, Drawing, Glyphs, Look, Timing};
use hotrail::eval::{self, Evaluator, Flow, Machine, Outcome, Stimulus};
use hotrail::files::{FileError, NewFile};
use hotrail::model::{Program, Test};
use hotrail::source::Source;

use super::dump;
use super::report::Report;

/// The moment of a scan, as drawings say it.
fn moment(scan: usize) -> String {
    format!("power in scan {scan}")
}

/// What a test of that title drives: the whole title, or a part of it that no other one has.
pub fn test_stimulus(program: &Program, title: &str) -> anyhow::Result<Stimulus> {
    let is_it = |test: &&Test| test.title == title;
    let has_it = |test: &&Test| test.title.contains(title);
    let mut found: Vec<&Test> = program.tests.iter().filter(is_it).collect();
    if found.is_empty() {
        found = program.tests.iter().filter(has_it).collect();
    }
    match found[..] {
        [test] => Ok(Stimulus::of_test(program, test).0),
        [] => bail!("no test has `{title}` in its title"),
        _ => bail!("{} tests have `{title}` in their titles: say all of one", found.len()),
    }
}

/// What goes on in a scan of a run, from 0, and which one it is; in the last one of the stimulus if
/// none is said. Behind the last row its values are held.
pub fn at(
    program: &Program,
    stimulus: &Stimulus,
    scan: Option<usize>,
) -> anyhow::Result<(Flow, String)> {
    let Some(last) = scan.or(stimulus.len().checked_sub(1)) else {
        bail!("nothing is run, so there is no scan; --at SCAN holds all inputs at 0");
    };
    let mut evaluator = Evaluator::new(program);
    for scan in 0..last {
        let row = stimulus.row(scan);
        evaluator.drive_row(row);
        evaluator.scan(row.tick);
    }
    let row = stimulus.row(last);
    evaluator.drive_row(row);
    Ok((evaluator.scan_seen(row.tick), moment(last)))
}

/// The ladder with the power of a scan.
pub fn power(source: &Source, flow: &Flow, scan: usize) -> Drawing {
    let mut drawing = Drawing::with_flow(source, &draw::Options::default(), flow);
    drawing.say(&moment(scan));
    drawing
}

/// Draws each test of a program into a folder: the power of its last scan, and what it names.
/// `drawn` are the names of the files so far.
pub fn of_tests(
    program: &Program,
    source: &Source,
    path: &Path,
    folder: &Path,
    drawn: &mut HashSet<String>,
) -> anyhow::Result<()> {
    for (number, test) in program.tests.iter().enumerate() {
        let stem = dump::file_stem(program, number, test);
        if !drawn.insert(stem.to_lowercase()) {
            bail!("two programs would write {stem}.svg: give one of them another name");
        }
        let (stimulus, outcome) = Stimulus::of_test(program, test);
        let verdict = if outcome == Outcome::Passed { "passes" } else { "fails here" };
        let mut evaluator = Evaluator::new(program);
        let mut flow = Flow::at_reset(program);
        let mut timing = Timing::new(program, &eval::variables_of_test(test));
        let title = format!("test \"{}\", {verdict}", test.title);
        timing.note(&title);
        let last = stimulus.len().saturating_sub(1);
        for scan in 0..stimulus.len() {
            let row = stimulus.row(scan);
            evaluator.drive_row(row);
            match scan == last {
                true => flow = evaluator.scan_seen(row.tick),
                false => evaluator.scan(row.tick),
            }
            timing.scan(row.tick, |variable| evaluator.value(variable));
        }
        let mut power = power(source, &flow, last);
        let when =
            if !stimulus.is_empty() { moment(last) } else { "before the first scan".to_owned() };
        power.say(&format!("{title}: {when}"));
        let sources = [path.to_owned()];
        write(&folder.join(format!("{stem}.svg")), &power.svg(), &sources)?;
        if !stimulus.is_empty() {
            write(&folder.join(format!("{stem}_waves.svg")), &timing.svg(), &sources)?;
        }
    }
    Ok(())
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
