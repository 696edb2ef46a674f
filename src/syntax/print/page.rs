//! Lays the instructions of a script out on lines.

use super::reader::column_after;
use super::script::{Frame, Line, Op, Style};

/// The longest line, where there is a place to break it.
const COLUMNS: usize = 100;

/// Where a comment at the end of a line starts; after a longer line at the next stop. The places
/// are the same for every line, so that a changed line never moves the comments of its neighbours.
const COMMENTS: usize = 32;
/// From one stop to the next.
const STOP: usize = 8;

/// The text that the instructions make.
pub(super) fn lay_out(ops: &[Op<'_>]) -> String {
    let mut page = Page { at_start: true, ..Page::default() };
    for op in ops {
        page.follow(op);
    }
    if !page.text.is_empty() {
        page.text.push('\n');
    }
    page.text
}

#[derive(Default)]
struct Page {
    text: String,
    column: usize,
    /// Nothing but the indent is on the line.
    at_start: bool,
    /// Blanks that are written if a text follows.
    blanks: usize,
    /// Nothing may follow on this line.
    ended: bool,
    /// Where the last comment started.
    last_comment: usize,
    frames: Vec<Open>,
}

#[derive(Clone, Copy, Default)]
struct Open {
    mode: Mode,
    base: usize,
    hang: usize,
}

#[derive(Clone, Copy, Default, PartialEq, Eq)]
enum Mode {
    /// All on one line.
    #[default]
    Flat,
    All,
    Fill,
}

impl Page {
    fn follow(&mut self, op: &Op<'_>) {
        let frame = self.frames.last().copied().unwrap_or_default();
        match *op {
            Op::Text(text) => self.write(text, frame.hang),
            Op::Comma => {
                self.blanks = 0;
                self.write(",", frame.hang);
            }
            Op::Blanks(count) => self.blanks = self.blanks.max(count),
            Op::Line(ref line) => self.line(line, frame),
            Op::Start if self.ended => self.new_line(frame.base, false),
            Op::Start => {}
            Op::Break { offset, blank } | Op::Own { offset, blank } => {
                self.new_line(frame.base + offset, blank);
            }
            Op::Below => self.new_line(self.last_comment, false),
            Op::Comment { text, column } => self.comment(text, column, frame.hang),
            Op::EndLine => self.ended = true,
            Op::Open(ref frame) => self.open(frame),
            Op::Close => {
                self.frames.pop();
            }
        }
    }

    fn open(&mut self, frame: &Frame) {
        let around = self.frames.last().copied();
        let fits = || {
            let column = if self.ended { around.map_or(0, |o| o.hang) } else { self.column };
            frame.width.is_some_and(|width| column + self.blanks + width <= COLUMNS)
        };
        let mode = match frame.style {
            _ if around.is_some_and(|around| around.mode == Mode::Flat) || fits() => Mode::Flat,
            Style::All => Mode::All,
            Style::Fill => Mode::Fill,
        };
        let around = around.map_or(0, |around| around.base);
        self.frames.push(Open { mode, base: around + frame.base, hang: around + frame.hang });
    }

    fn line(&mut self, line: &Line, frame: Open) {
        let fits_at = |column: usize| line.width.is_some_and(|width| column + width <= COLUMNS);
        if self.ended || frame.mode == Mode::All {
            self.new_line(frame.base + line.offset, false);
        } else {
            let blanks = self.blanks.max(line.blanks);
            if frame.mode == Mode::Flat || fits_at(self.column + blanks) {
                self.blanks = blanks;
            } else {
                // What is too long for a line of its own is drawn from the start of the frame.
                let indent = if fits_at(frame.hang) { frame.hang } else { frame.base };
                self.new_line(indent, false);
            }
        }
    }

    fn new_line(&mut self, indent: usize, blank: bool) {
        self.ended = false;
        self.blanks = 0;
        self.column = indent;
        if self.text.is_empty() {
            return;
        }
        if !self.at_start {
            self.text.push('\n');
            self.at_start = true;
        }
        if blank && !self.text.ends_with("\n\n") {
            self.text.push('\n');
        }
    }

    fn write(&mut self, text: &str, hang: usize) {
        if self.ended {
            self.new_line(hang, false);
        }
        if self.at_start {
            self.blanks = self.column;
            self.column = 0;
        }
        self.text.extend(std::iter::repeat_n(' ', self.blanks));
        self.text.push_str(text);
        self.column = column_after(self.column + self.blanks, text);
        self.at_start = false;
        self.blanks = 0;
    }

    /// Writes a comment with blanks around it. The lines of a long one keep their places to each
    /// other.
    fn comment(&mut self, text: &str, column: usize, hang: usize) {
        if self.ended {
            self.new_line(hang, false);
        }
        let mut lines = text.lines().map(str::trim_end);
        let first = lines.next().unwrap_or_default();
        let is_last = first.starts_with("//");
        let gap = if is_last {
            (self.column + 2).next_multiple_of(STOP).max(COMMENTS) - self.column
        } else {
            1
        };
        self.blanks = self.blanks.max(gap);
        let start = self.column + if self.at_start { 0 } else { self.blanks };
        self.last_comment = start;
        self.write(first, hang);
        for line in lines {
            self.text.push('\n');
            let content = line.trim_start_matches([' ', '\t']);
            self.column = 0;
            if !content.is_empty() {
                let indent = column_after(0, &line[..line.len() - content.len()]);
                self.blanks = (indent + start).saturating_sub(column);
                self.write(content, hang);
            }
        }
        self.blanks = 1;
    }
}
