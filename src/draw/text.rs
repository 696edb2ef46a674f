//! A drawing as text.

use unicode_width::UnicodeWidthChar;

use super::grid::Grid;
use super::words::{lines, width};
use super::{Drawing, Rung};

/// What a text is drawn with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Glyphs {
    /// Box-drawing characters.
    Unicode,
    /// Nothing beyond ASCII, in names and titles too.
    Ascii,
}

impl Glyphs {
    pub(super) fn pick(self, unicode: &'static str, ascii: &'static str) -> &'static str {
        match self {
            Glyphs::Unicode => unicode,
            Glyphs::Ascii => ascii,
        }
    }

    /// A text in these glyphs, as wide as it was.
    pub(super) fn written(self, text: &str) -> String {
        let ascii = |c: char| match c {
            '→' => ">".to_owned(),
            '←' => "<".to_owned(),
            c if c.is_ascii() => c.to_string(),
            c => "?".repeat(c.width().unwrap_or(0)),
        };
        match self {
            Glyphs::Unicode => text.to_owned(),
            Glyphs::Ascii => text.chars().map(ascii).collect(),
        }
    }
}

/// A line of a drawing, from left to right.
pub type Line = Vec<Piece>;

/// A piece of a line that looks the same all over.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Piece {
    /// Its characters.
    pub text: String,
    /// How it looks.
    pub look: Look,
}

/// How a piece of a drawing looks where there is colour. Without, wires with power and what is on
/// are heavier.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Look {
    /// As everything does where no scan is shown.
    Plain,
    /// A wire with power, or what is on.
    Live,
    /// A value.
    Value,
    /// What decided.
    Decides,
}

impl Drawing {
    /// The drawing as lines of text, none wider than the drawing.
    pub fn text(&self, glyphs: Glyphs) -> String {
        let mut text = String::new();
        for line in self.lines(glyphs) {
            line.iter().for_each(|run| text += &run.text);
            text.push('\n');
        }
        text
    }

    /// The same lines with what a terminal needs to colour them.
    pub fn lines(&self, glyphs: Glyphs) -> Vec<Line> {
        let mut all: Vec<Line> = Vec::new();
        let title = self.title.as_ref().map_or(String::new(), |title| format!(": {title}"));
        let heading = lines(&format!("{}{title}", self.name), self.width);
        let notes = self.comment.iter().chain(&self.moment);
        let notes = notes.flat_map(|note| lines(note, self.width));
        all.extend(heading.into_iter().chain(notes).map(|line| plain(glyphs.written(&line))));
        for rung in &self.rungs {
            all.push(Line::new());
            all.extend(rung.caption(glyphs, self.width));
            all.extend(rung.lines(glyphs, self.width));
        }
        all
    }
}

impl Rung {
    /// Number, title and line of a rung, and its comment, over a drawing of that width.
    pub fn caption(&self, glyphs: Glyphs, columns: i32) -> Vec<Line> {
        let number = format!("{}  ", self.number);
        let place = self.place();
        let room = columns - width(&number) - width(&place) - 2;
        let mut caption = Vec::new();
        let title = lines(self.title.as_deref().unwrap_or(""), room);
        for (index, part) in title.iter().enumerate() {
            let is_first = index == 0;
            let (before, after) = if is_first { (&number[..], &place[..]) } else { ("", "") };
            let part = glyphs.written(part);
            let (indent, room) = (number.len(), room as usize + 2 - width(&part) as usize);
            caption.push(plain(format!("{before:indent$}{part}{blank:room$}{after}", blank = "")));
        }
        let indent = number.len();
        let room = columns - indent as i32;
        for part in self.comment.iter().flat_map(|comment| lines(comment, room)) {
            caption.push(plain(format!("{:indent$}{}", "", glyphs.written(&part))));
        }
        caption
    }

    /// What is between the rails, in a drawing of that width.
    pub fn lines(&self, glyphs: Glyphs, columns: i32) -> Vec<Line> {
        Grid::of(self, glyphs, columns).lines()
    }
}

/// A line without colour.
fn plain(text: String) -> Line {
    let text = text.trim_end().to_owned();
    if text.is_empty() { Line::new() } else { vec![Piece { text, look: Look::Plain }] }
}
