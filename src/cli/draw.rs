//! `hotrail draw`

use std::path::PathBuf;

use anyhow::bail;
use clap::ValueEnum;

use hotrail::backend::{self, Artifact};
use hotrail::draw::{self, Drawing, Glyphs, NARROWEST, Rung, WIDEST};
use hotrail::files;
use hotrail::lint;

use super::pictures;
use super::report::Report;
use super::sim::read_stimulus;
use super::{Sources, Verdict};

/// Draw ladder files: contacts, coils and blocks between their rails
#[derive(clap::Args)]
#[command(after_help = "Below a contact stand the rungs that write it (←), below a coil those \
that read it (→).

Examples:
  hotrail draw conveyor.ladder
  hotrail draw conveyor.ladder --rung 3 --rung belt
  hotrail draw conveyor.ladder --stimulus stimulus.csv --at 120
  hotrail draw conveyor.ladder --format svg > conveyor.svg
  hotrail draw *.ladder --format svg -o pictures")]
pub struct Options {
    #[command(flatten)]
    sources: Sources,
    /// Text, or an SVG picture for a browser or a document
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    /// Draw with ASCII characters only
    #[arg(long)]
    ascii: bool,
    /// Columns of the drawing; longer rungs go on in the next line
    #[arg(long, value_name = "COLUMNS", value_parser = width(), default_value_t = default_width())]
    width: u16,
    /// Draw only this rung: its number, or a part of its title; may be given several times
    #[arg(long = "rung", value_name = "RUNG")]
    rungs: Vec<String>,
    /// Draw the power of a scan too: the stimulus, as for `hotrail sim`, of one program
    #[arg(long, value_name = "FILE", group = "run")]
    stimulus: Option<PathBuf>,
    /// Draw the power of a scan of this test: its title, or a part that no other one has
    #[arg(long, value_name = "TITLE", group = "run", conflicts_with = "stimulus")]
    test: Option<String>,
    /// The scan that is drawn, from 0; the last one of the stimulus or of the test if it is not
    /// said
    #[arg(long, value_name = "SCAN", requires = "run")]
    at: Option<usize>,
    /// Folder for the pictures, NAME.svg each; without it they go to standard output
    #[arg(short, long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Replace files that were not made by hotrail
    #[arg(long, requires = "out")]
    force: bool,
}

#[derive(ValueEnum, Clone, Copy, PartialEq, Eq)]
enum Format {
    /// Lines of characters
    Text,
    /// One SVG picture for each program
    Svg,
}

fn width() -> clap::builder::RangedI64ValueParser<u16> {
    clap::value_parser!(u16).range(NARROWEST as i64..=WIDEST as i64)
}

fn default_width() -> u16 {
    draw::Options::default().width as u16
}

pub fn run(options: &Options, report: &mut Report) -> anyhow::Result<Verdict> {
    let is_text = options.format == Format::Text;
    if is_text && options.out.is_some() {
        bail!("a text goes to standard output; for files say --format svg");
    }
    if !is_text && options.out.is_none() && options.sources.files.len() > 1 {
        bail!("several pictures need a folder: say -o DIR");
    }
    let is_run = options.stimulus.is_some() || options.test.is_some();
    if is_run && options.sources.files.len() > 1 {
        bail!("a run is one of one program: say one file");
    }
    let standard_inputs = options.sources.files.iter().chain(&options.stimulus);
    if standard_inputs.filter(|path| path.as_os_str() == "-").count() > 1 {
        bail!("standard input can be read once only");
    }
    let Some(mut drawings) = draw_all(options, report)? else { return Ok(Verdict::Bad) };
    for wanted in &options.rungs {
        let mut rungs = drawings.iter().flat_map(|(_, drawing)| &drawing.rungs);
        if !rungs.any(|rung| is_meant(wanted, rung)) {
            bail!("no rung has the number or the title `{wanted}`");
        }
    }
    if !options.rungs.is_empty() {
        for (_, drawing) in &mut drawings {
            drawing.rungs.retain(|rung| options.rungs.iter().any(|wanted| is_meant(wanted, rung)));
        }
    }
    if is_text {
        let glyphs = if options.ascii { Glyphs::Ascii } else { Glyphs::Unicode };
        let texts: Vec<String> = drawings
            .iter()
            .map(|(_, drawing)| pictures::terminal_text(drawing, glyphs, report))
            .collect();
        report.result(&texts.join("\n"));
        return Ok(Verdict::Good);
    }
    let made =
        drawings.iter().map(|(path, drawing)| (path.clone(), vec![backend::drawing(drawing)]));
    let made: Vec<(PathBuf, Vec<Artifact>)> = made.collect();
    let clashes = files::shared_names(&made);
    clashes.iter().for_each(|error| report.file_error(error));
    if !clashes.is_empty() {
        return Ok(Verdict::Bad);
    }
    let artifacts: Vec<Artifact> = made.into_iter().flat_map(|(_, artifacts)| artifacts).collect();
    match &options.out {
        Some(folder) => {
            files::write_all(folder, &artifacts, &options.sources.files, options.force)?;
        }
        None => artifacts.iter().for_each(|picture| report.result(&picture.text())),
    }
    Ok(Verdict::Good)
}

/// The drawing of each file, or nothing if one of them is wrong.
fn draw_all(
    options: &Options,
    report: &mut Report,
) -> anyhow::Result<Option<Vec<(PathBuf, Drawing)>>> {
    // Who wants to see a ladder asks whether it can be drawn; `check` tells the rest.
    let lints = lint::Options { off: true, ..lint::Options::default() };
    let look = draw::Options { width: options.width.into() };
    let mut drawings = Vec::new();
    let mut is_good = true;
    for path in &options.sources.files {
        let Some((source, program)) = report.analyze(path, &lints) else {
            is_good = false;
            continue;
        };
        let stimulus = match (&options.stimulus, &options.test) {
            (None, None) => None,
            (None, Some(title)) => Some(pictures::test_stimulus(&program, title)?),
            (Some(file), _) => match read_stimulus(&program, Some(file), report)? {
                Some(stimulus) => Some(stimulus),
                None => return Ok(None),
            },
        };
        let drawing = match &stimulus {
            None => Drawing::new(&source, &look),
            Some(stimulus) => {
                let (flow, moment) = pictures::at(&program, stimulus, options.at)?;
                let mut drawing = Drawing::with_flow(&source, &look, &flow);
                drawing.say(&moment);
                drawing
            }
        };
        drawings.push((path.clone(), drawing));
    }
    Ok(is_good.then_some(drawings))
}

/// True if a rung is the one of that number, or has that text in its title.
fn is_meant(wanted: &str, rung: &Rung) -> bool {
    match wanted.parse::<usize>() {
        Ok(number) => rung.number == number,
        Err(_) => rung.title.as_ref().is_some_and(|title| title.contains(wanted)),
    }
}
