//! The cells of a rung as characters: where wires meet, how heavy they are, what lies over them.

use super::Rung;
use super::cells::{Align, ElementId, Part, Point, Shape, Style, Symbol, Text};
use super::text::{Glyphs, Line, Look, Piece};
use super::words::width;

/// The sides of a cell that a line leaves it by.
const LEFT: u8 = 1;
const RIGHT: u8 = 2;
const UP: u8 = 4;
const DOWN: u8 = 8;
/// A rail goes through the cell.
const RAIL: u8 = 16;

/// What meets in a cell: the sum of 1 for a light line to the left or 2 for a heavy one, three
/// times that to the right, nine times upwards, 27 times downwards.
const MEETINGS: &str = " \
    ─━──╾━╼━│┘┙└┴┵┕┶┷┃┚┛┖┸┹┗┺┻\
    │┐┑┌┬┭┍┮┯│┤┥├┼┽┝┾┿╿┦┩┞╀╃┡╄╇\
    ┃┒┓┎┰┱┏┲┳╽┧┪┟╁╅┢╆╈┃┨┫┠╂╉┣╊╋";

impl Glyphs {
    /// What meets in a cell that lines leave by these sides, by some of them heavy ones.
    fn meeting(self, sides: u8, heavy: u8) -> char {
        let wires = sides & !RAIL;
        match (self, wires) {
            (Glyphs::Ascii, _) if sides & RAIL != 0 => '|',
            (Glyphs::Ascii, 0) => ' ',
            (Glyphs::Ascii, _) if wires & (UP | DOWN) == 0 => {
                if heavy != 0 {
                    '='
                } else {
                    '-'
                }
            }
            (Glyphs::Ascii, _) if heavy != 0 => '#',
            (Glyphs::Ascii, _) if wires & (LEFT | RIGHT) == 0 => '|',
            (Glyphs::Ascii, _) => '+',
            (Glyphs::Unicode, _) => {
                let rail = if sides & RAIL != 0 { UP | DOWN } else { 0 };
                let weight = |side: u8| {
                    let is_heavy = (heavy | rail) & side != 0;
                    usize::from((wires | rail) & side != 0) + usize::from(is_heavy)
                };
                let place = weight(LEFT) + 3 * weight(RIGHT) + 9 * weight(UP) + 27 * weight(DOWN);
                MEETINGS.chars().nth(place).expect("there are 81")
            }
        }
    }

    /// A bar of a contact between these wires; that of one which conducts is heavy.
    fn bar(self, at_left: bool, is_on: bool, has_power: bool) -> char {
        match (self, is_on) {
            (Glyphs::Ascii, false) => '|',
            (Glyphs::Ascii, true) => {
                if at_left {
                    '['
                } else {
                    ']'
                }
            }
            (Glyphs::Unicode, _) => {
                let side = if at_left { LEFT } else { RIGHT };
                let power = if has_power { side } else { 0 };
                self.meeting(side | UP | DOWN, power | if is_on { UP | DOWN } else { 0 })
            }
        }
    }
}

/// A text over the wires.
struct Over {
    start: usize,
    text: String,
    look: Look,
}

/// The cells of a rung.
pub(super) struct Grid<'r> {
    rung: &'r Rung,
    glyphs: Glyphs,
    width: usize,
    /// Which sides of each cell a line leaves by.
    sides: Vec<u8>,
    /// By which of them a heavy one does.
    heavy: Vec<u8>,
    /// For each row, what lies over it.
    texts: Vec<Vec<Over>>,
}

impl<'r> Grid<'r> {
    /// The cells of a rung in a drawing of that width.
    pub fn of(rung: &'r Rung, glyphs: Glyphs, columns: i32) -> Self {
        let (width, height) = (columns as usize, rung.height as usize);
        let cells = || vec![0; width * height];
        let texts = (0..height).map(|_| Vec::new()).collect();
        let mut grid = Grid { rung, glyphs, width, sides: cells(), heavy: cells(), texts };
        rung.parts.iter().for_each(|part| grid.part(part));
        grid
    }

    fn is_on(&self, element: Option<ElementId>) -> bool {
        self.rung.seen(element).is_some_and(|seen| seen.is_on)
    }

    fn decides(&self, element: Option<ElementId>) -> bool {
        self.rung.seen(element).is_some_and(|seen| seen.decides)
    }

    fn part(&mut self, Part { element, shape }: &Part) {
        let (is_on, decides) = (self.is_on(*element), self.decides(*element));
        let look = match (decides, is_on) {
            (true, _) => Look::Decides,
            (false, true) => Look::Live,
            (false, false) => Look::Plain,
        };
        let of_power = |has_power: bool| if has_power { Look::Live } else { Look::Plain };
        let glyphs = self.glyphs;
        match shape {
            Shape::Wire { from, to, power } => self.line(*from, *to, self.rung.has_power(*power)),
            Shape::Rail { x, top, bottom } => {
                (*top..=*bottom).for_each(|y| self.add(Point { x: *x, y }, RAIL, false));
            }
            Shape::Symbol { at, symbol } => self.symbol(*element, *at, *symbol, look),
            Shape::Frame { from, to } => {
                let (right, left) = (Point { x: to.x, ..*from }, Point { x: from.x, ..*to });
                for (from, to) in [(*from, right), (left, *to), (*from, left), (right, *to)] {
                    self.line(from, to, is_on);
                }
            }
            Shape::Text(text) => match text.style {
                // A name has a cell to spare at both sides, and so has an expression in its box.
                _ if decides && is_marked(text) => {
                    let (left, right) = (glyphs.pick("»", "*"), glyphs.pick("«", "*"));
                    let at = Point { x: text.at.x - 1, ..text.at };
                    self.write(at, &format!("{left}{}{right}", text.text), look);
                }
                // Those of a network are the names of its nodes.
                Style::Name
                    if self.rung.seen(*element).is_some_and(|seen| seen.ends.is_empty()) =>
                {
                    self.write(text.at, &text.text, look);
                }
                _ => self.write(text.at, &text.text, Look::Plain),
            },
            Shape::References { at, references, .. } => {
                self.write(*at, &references.to_string(), Look::Plain);
            }
            Shape::Arrow { at, both_ways, power } => {
                let look = of_power(self.rung.has_power(*power));
                self.write(*at, glyphs.pick("►", ">"), look);
                if *both_ways {
                    let left = Point { x: at.x - 1, ..*at };
                    self.write(left, glyphs.pick("◄", "<"), look);
                }
            }
            Shape::Dot { at, power } => {
                let look = of_power(self.rung.has_power(*power));
                self.write(*at, glyphs.pick("●", "o"), look);
            }
            Shape::Reading { .. } => {
                if let Some((at, text)) = self.rung.reading(*element, shape) {
                    self.write(at, &text, Look::Value);
                }
            }
        }
    }

    fn symbol(&mut self, element: Option<ElementId>, at: Point, symbol: Symbol, look: Look) {
        let seen = self.rung.seen(element);
        let (power, out) = seen.map_or((false, false), |seen| (seen.power, seen.out));
        let is_on = self.is_on(element);
        let mut start = at.x - symbol.span() / 2;
        let text = match symbol {
            // There is a wire of two cells at least at both sides.
            Symbol::Coil(sign) if is_on => {
                start -= 1;
                format!("(({sign}))")
            }
            Symbol::Coil(sign) => format!("({sign})"),
            Symbol::Operator(sign) if self.decides(element) => {
                start -= 1;
                let left = self.glyphs.bar(true, is_on, power);
                let right = self.glyphs.bar(false, is_on, out);
                let mark = |unicode, ascii| self.glyphs.pick(unicode, ascii);
                format!("{}{left}{sign}{right}{}", mark("»", "*"), mark("«", "*"))
            }
            Symbol::Contact(sign) | Symbol::Operator(sign) => {
                let left = self.glyphs.bar(true, is_on, power);
                let right = self.glyphs.bar(false, is_on, out);
                format!("{left}{sign}{right}")
            }
        };
        self.texts[at.y as usize].push(Over { start: start as usize, text, look });
    }

    fn write(&mut self, at: Point, text: &str, look: Look) {
        let text = self.glyphs.written(text);
        self.texts[at.y as usize].push(Over { start: at.x as usize, text, look });
    }

    fn line(&mut self, from: Point, to: Point, is_heavy: bool) {
        let (forward, back) = if from.y == to.y { (RIGHT, LEFT) } else { (DOWN, UP) };
        self.add(from, forward, is_heavy);
        self.add(to, back, is_heavy);
        let cells = (from.x + 1..to.x).map(|x| Point { x, ..from });
        cells.for_each(|cell| self.add(cell, forward | back, is_heavy));
        let cells = (from.y + 1..to.y).map(|y| Point { y, ..from });
        cells.for_each(|cell| self.add(cell, forward | back, is_heavy));
    }

    fn add(&mut self, at: Point, sides: u8, is_heavy: bool) {
        let cell = at.y as usize * self.width + at.x as usize;
        self.sides[cell] |= sides;
        if is_heavy {
            self.heavy[cell] |= sides;
        }
    }

    /// The rows from top to bottom, without blanks at their ends.
    pub fn lines(mut self) -> Vec<Line> {
        let mut lines = Vec::with_capacity(self.texts.len());
        for (y, mut row) in std::mem::take(&mut self.texts).into_iter().enumerate() {
            row.sort_by_key(|over| over.start);
            let mut line = Line::new();
            let mut x = 0;
            for Over { start, text, look } in row {
                self.wires(y, x..start.max(x), &mut line);
                add_run(&mut line, &text, look);
                x = start + width(&text) as usize;
            }
            self.wires(y, x..self.width, &mut line);
            while let Some(last) = line.last_mut() {
                last.text.truncate(last.text.trim_end().len());
                if !last.text.is_empty() {
                    break;
                }
                line.pop();
            }
            lines.push(line);
        }
        lines
    }

    fn wires(&self, y: usize, cells: std::ops::Range<usize>, line: &mut Line) {
        for x in cells {
            let cell = y * self.width + x;
            let (sides, heavy) = (self.sides[cell], self.heavy[cell]);
            let look = if heavy == 0 { Look::Plain } else { Look::Live };
            add_run(line, self.glyphs.meeting(sides, heavy).encode_utf8(&mut [0; 4]), look);
        }
    }
}

/// True for the texts that say which element it is.
fn is_marked(text: &Text) -> bool {
    match text.style {
        Style::Name | Style::Instance => true,
        Style::Value => text.align == Align::Start,
        Style::Kind | Style::Pin | Style::Mark => false,
    }
}

/// Lengthens a line.
fn add_run(line: &mut Line, text: &str, look: Look) {
    match line.last_mut() {
        Some(last) if last.look == look => last.text += text,
        _ => line.push(Piece { text: text.to_owned(), look }),
    }
}
