//! The ladder as a drawing: laid out once in cells, then printed as text or as SVG.
//!
//! ```
//! use hotrail::draw::{Drawing, Glyphs, Options};
//! use hotrail::source::Source;
//!
//! let source = Source::new(
//!     "start_stop.ladder",
//!     "ladder start_stop  input start, stop  output motor
//!      rung \"seal-in\"  [ start | motor ] !stop ( motor )",
//! );
//! let drawing = Drawing::new(&source, &Options::default());
//! assert!(drawing.text(Glyphs::Unicode).contains("┤/├"));
//! assert!(drawing.svg().contains("<svg "));
//! ```

mod build;
mod call;
mod captions;
mod cells;
mod fit;
mod grid;
mod net;
mod node;
mod pins;
mod place;
mod references;
mod rung;
mod svg;
mod text;
mod timing;
mod words;

pub use cells::{Align, ElementId, Form, Part, Point, Power, Shape, Style, Symbol, Text};
pub use references::{References, Run};
pub use rung::Rung;
pub use svg::bears_header;
pub use text::{Glyphs, Line, Look, Piece};
pub use timing::Timing;
pub use words::harmless;

use crate::eval::{Flow, ShownRung};
use crate::source::Source;
use crate::syntax::{self, ast::Item};
use build::Builder;
use captions::Captions;
use references::Uses;

/// The fewest columns of a drawing.
pub const NARROWEST: usize = 80;
/// The most columns of a drawing.
pub const WIDEST: usize = 1000;

/// How a ladder is drawn.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// Columns of the drawing, from [`NARROWEST`] to [`WIDEST`].
    pub width: usize,
}

impl Default for Options {
    fn default() -> Self {
        Options { width: 100 }
    }
}

/// A program laid out on a grid of cells.
#[derive(Debug)]
pub struct Drawing {
    /// The program's name.
    pub name: String,
    /// Its title.
    pub title: Option<String>,
    /// The comment above its header, line by line.
    pub comment: Vec<String>,
    /// The moment that is shown, if the power of one is.
    pub moment: Option<String>,
    /// The source, without folders.
    pub source: String,
    /// Columns, both rails among them.
    pub width: i32,
    /// The rungs in text order.
    pub rungs: Vec<Rung>,
}

impl Drawing {
    /// Draws a source in which `analyze` finds no error. Of any other text it draws what can be
    /// read.
    pub fn new(source: &Source, options: &Options) -> Self {
        Drawing::laid_out(source, options, None)
    }

    /// The same with the power of a scan in it, and room for values beside comparisons,
    /// assignments and the pins of blocks. The room is that of the widest values: a drawing can
    /// [show](Drawing::show) one scan after the other and keeps its layout.
    ///
    /// `flow` is of the program that `analyze` makes of this source.
    pub fn with_flow(source: &Source, options: &Options, flow: &Flow) -> Self {
        let mut drawing = Drawing::laid_out(source, options, Some(flow));
        drawing.show(flow);
        drawing
    }

    /// The rungs of an explanation in its order, each in its scan; a rung may come several times.
    #[must_use]
    pub fn of_explanation(mut self, shown: &[ShownRung]) -> Self {
        let drawn = |shown: &ShownRung| {
            let rung = &self.rungs[shown.rung - 1];
            Rung { seen: Some(shown.seen.clone()), scan: Some(shown.scan), ..rung.clone() }
        };
        self.rungs = shown.iter().map(drawn).collect();
        self
    }

    /// Says which moment is shown.
    pub fn say(&mut self, moment: &str) {
        self.moment = Some(words::harmless(moment));
    }

    /// Shows another scan, of the same program.
    pub fn show(&mut self, flow: &Flow) {
        for rung in &mut self.rungs {
            rung.seen = Some(flow.rungs[rung.number - 1].clone());
        }
    }

    fn laid_out(source: &Source, options: &Options, flow: Option<&Flow>) -> Self {
        let (file, _) = syntax::parse(source);
        let uses = Uses::of(&file);
        let captions = Captions { source, comments: &file.comments };
        let width = options.width.clamp(NARROWEST, WIDEST) as i32;
        let mut drawing = Drawing {
            name: String::new(),
            title: None,
            comment: Vec::new(),
            moment: None,
            source: words::harmless(source.file_name()),
            width,
            rungs: Vec::new(),
        };
        for item in &file.items {
            match item {
                Item::Header(header) => {
                    drawing.name = words::harmless(header.name.text);
                    drawing.title = header.title.map(|title| words::harmless(title.text));
                    drawing.comment = captions.above(header.name.span.start);
                }
                Item::Rung(rung) => {
                    let (comments, uses) = (&file.comments[..], &uses);
                    let seen = flow.map(|flow| &flow.rungs[drawing.rungs.len()][..]);
                    let mut builder = Builder { source, comments, uses, seen, elements: 0 };
                    let series = builder.series(&rung.network);
                    let span = rung.network.span;
                    drawing.rungs.push(Rung {
                        number: drawing.rungs.len() + 1,
                        title: rung.title.map(|title| words::harmless(title.text)),
                        line: source.line(rung.span.start),
                        comment: captions.above(rung.span.start),
                        written: words::written(source, span, comments),
                        elements: builder.elements,
                        ..Rung::laid_out(series, width)
                    });
                }
                _ => {}
            }
        }
        drawing
    }
}
