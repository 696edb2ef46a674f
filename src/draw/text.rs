//! A drawing as text.

use unicode_width::UnicodeWidthChar;

use super::cells::{Point, Shape, Symbol};
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

const LEFT: u8 = 1;
const RIGHT: u8 = 2;
const UP: u8 = 4;
const DOWN: u8 = 8;
const RAIL: u8 = 16;

/// What meets in a cell, by the sum of its sides.
const WIRES: [&str; 16] =
    [" ", "─", "─", "─", "│", "┘", "└", "┴", "│", "┐", "┌", "┬", "│", "┤", "├", "┼"];
const ASCII_WIRES: [&str; 16] =
    [" ", "-", "-", "-", "|", "+", "+", "+", "|", "+", "+", "+", "|", "+", "+", "+"];
/// A rail with what leaves it to the left and to the right.
const RAILS: [&str; 4] = ["┃", "┨", "┠", "╂"];

impl Glyphs {
    fn wires(self, sides: u8) -> &'static str {
        match (self, sides & RAIL != 0) {
            (Glyphs::Unicode, true) => RAILS[usize::from(sides & (LEFT | RIGHT))],
            (Glyphs::Ascii, true) => "|",
            (Glyphs::Unicode, false) => WIRES[usize::from(sides)],
            (Glyphs::Ascii, false) => ASCII_WIRES[usize::from(sides)],
        }
    }

    fn pick(self, unicode: &'static str, ascii: &'static str) -> &'static str {
        match self {
            Glyphs::Unicode => unicode,
            Glyphs::Ascii => ascii,
        }
    }

    /// A text in these glyphs, as wide as it was.
    fn written(self, text: &str) -> String {
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

impl Drawing {
    /// The drawing as lines of text, none wider than the drawing.
    pub fn text(&self, glyphs: Glyphs) -> String {
        let mut text = String::new();
        let mut line = |line: &str| {
            text += glyphs.written(line).trim_end();
            text.push('\n');
        };
        let title = self.title.as_ref().map_or(String::new(), |title| format!(": {title}"));
        lines(&format!("{}{title}", self.name), self.width).iter().for_each(|part| line(part));
        for comment in self.comment.iter().flat_map(|comment| lines(comment, self.width)) {
            line(&comment);
        }
        for rung in &self.rungs {
            text.push('\n');
            self.caption(rung, glyphs, &mut text);
            let mut grid = Grid::new(self.width, rung.height);
            rung.parts.iter().for_each(|part| grid.shape(&part.shape, glyphs));
            grid.print(glyphs, &mut text);
        }
        text
    }

    /// Number, title and line of a rung, and its comment.
    fn caption(&self, rung: &Rung, glyphs: Glyphs, text: &mut String) {
        let number = format!("{}  ", rung.number);
        let place = format!("line {}", rung.line);
        let room = self.width - width(&number) - width(&place) - 2;
        let title = lines(rung.title.as_deref().unwrap_or(""), room);
        for (index, part) in title.iter().enumerate() {
            let is_first = index == 0;
            let (before, after) = if is_first { (&number[..], &place[..]) } else { ("", "") };
            let part = glyphs.written(part);
            let (indent, room) = (number.len(), room as usize + 2 - width(&part) as usize);
            let line = format!("{before:indent$}{part}{blank:room$}{after}", blank = "");
            *text += line.trim_end();
            text.push('\n');
        }
        let indent = number.len();
        let room = self.width - indent as i32;
        for part in rung.comment.iter().flat_map(|comment| lines(comment, room)) {
            *text += &format!("{:indent$}{}\n", "", glyphs.written(&part));
        }
    }
}

/// The cells of a rung.
struct Grid {
    width: usize,
    /// Which sides of each cell a wire leaves by.
    sides: Vec<u8>,
    /// For each row, texts with their first cell and their width.
    texts: Vec<Vec<(usize, usize, String)>>,
}

impl Grid {
    fn new(width: i32, height: i32) -> Self {
        let (width, height) = (width as usize, height as usize);
        Grid { width, sides: vec![0; width * height], texts: vec![Vec::new(); height] }
    }

    fn shape(&mut self, shape: &Shape, glyphs: Glyphs) {
        match shape {
            Shape::Wire { from, to, .. } => self.wire(*from, *to),
            Shape::Rail { x, top, bottom } => {
                (*top..=*bottom).for_each(|y| self.add(Point { x: *x, y }, RAIL));
            }
            Shape::Symbol { at, symbol } => self.symbol(*at, *symbol, glyphs),
            Shape::Frame { from, to } => {
                let (right, left) = (Point { x: to.x, ..*from }, Point { x: from.x, ..*to });
                self.wire(*from, right);
                self.wire(left, *to);
                self.wire(*from, left);
                self.wire(right, *to);
            }
            Shape::Text(text) => self.write(text.at, &text.text, glyphs),
            Shape::References { at, references, .. } => {
                self.write(*at, &references.to_string(), glyphs);
            }
            Shape::Arrow { at, both_ways } => {
                self.write(*at, glyphs.pick("►", ">"), glyphs);
                if *both_ways {
                    let left = Point { x: at.x - 1, ..*at };
                    self.write(left, glyphs.pick("◄", "<"), glyphs);
                }
            }
            Shape::Dot(at) => self.write(*at, glyphs.pick("●", "o"), glyphs),
        }
    }

    fn symbol(&mut self, at: Point, symbol: Symbol, glyphs: Glyphs) {
        let (left, right) = (glyphs.pick("┤", "|"), glyphs.pick("├", "|"));
        let text = match symbol {
            Symbol::Contact(sign) => format!("{left}{sign}{right}"),
            Symbol::Coil(sign) => format!("({sign})"),
            Symbol::Operator(word) => format!("{left}{word}{right}"),
        };
        let start = at.x - symbol.span() / 2;
        self.texts[at.y as usize].push((start as usize, width(&text) as usize, text));
    }

    fn write(&mut self, at: Point, text: &str, glyphs: Glyphs) {
        let cells = width(text) as usize;
        self.texts[at.y as usize].push((at.x as usize, cells, glyphs.written(text)));
    }

    fn wire(&mut self, from: Point, to: Point) {
        let (forward, back) = if from.y == to.y { (RIGHT, LEFT) } else { (DOWN, UP) };
        self.add(from, forward);
        self.add(to, back);
        let cells = (from.x + 1..to.x).map(|x| Point { x, ..from });
        cells.for_each(|cell| self.add(cell, forward | back));
        let cells = (from.y + 1..to.y).map(|y| Point { y, ..from });
        cells.for_each(|cell| self.add(cell, forward | back));
    }

    fn add(&mut self, at: Point, sides: u8) {
        self.sides[at.y as usize * self.width + at.x as usize] |= sides;
    }

    fn print(&mut self, glyphs: Glyphs, text: &mut String) {
        for (row, sides) in self.texts.iter_mut().zip(self.sides.chunks(self.width)) {
            row.sort_by_key(|(start, ..)| *start);
            let start = text.len();
            let mut x = 0;
            for (at, cells, written) in row {
                sides[x..(*at).max(x)].iter().for_each(|&sides| *text += glyphs.wires(sides));
                *text += written;
                x = *at + *cells;
            }
            sides[x..].iter().for_each(|&sides| *text += glyphs.wires(sides));
            text.truncate(start + text[start..].trim_end().len());
            text.push('\n');
        }
    }
}
