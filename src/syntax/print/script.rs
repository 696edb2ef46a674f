//! The page as a list of instructions: texts, and places where a line may end.
//!
//! Instructions are given in text order. The width of everything between two places where a line
//! may end is known by the time the list is complete, so the page (`page.rs`) is laid out in one
//! pass that never looks ahead.

/// One instruction.
pub(super) enum Op<'s> {
    /// A token.
    Text(&'s str),
    /// A comma: no blank comes before it.
    Comma,
    /// Blanks before the next text.
    Blanks(usize),
    /// A place where the line may end.
    Line(Line),
    /// The start of a list of elements: the line ends only where a comment demands it.
    Start,
    /// A place where the line ends, with a blank line after it or not.
    Break { offset: usize, blank: bool },
    /// A comment that starts a line follows.
    Own { offset: usize, blank: bool },
    /// A comment follows that goes on with the one at the end of the line before.
    Below,
    /// A comment, or an item that is not understood, with the column where it stood.
    Comment { text: &'s str, column: usize },
    /// Nothing may follow on this line.
    EndLine,
    /// The start of a frame.
    Open(Frame),
    /// Its end.
    Close,
}

impl Op<'_> {
    fn width(&mut self) -> Option<&mut Option<usize>> {
        match self {
            Op::Line(Line { width, .. }) | Op::Open(Frame { width, .. }) => Some(width),
            _ => None,
        }
    }
}

/// A place where the line may end.
pub(super) struct Line {
    /// Blanks if it does not end.
    pub blanks: usize,
    /// How far the next line is indented within the frame.
    pub offset: usize,
    /// The width up to the next such place; `None` if that cannot stand on one line.
    pub width: Option<usize>,
}

/// Text that breaks together.
pub(super) struct Frame {
    pub style: Style,
    /// How far it is indented within the frame around it.
    pub base: usize,
    /// How far lines are indented that go on with the one before.
    pub hang: usize,
    /// The width on one line; `None` if it cannot stand on one line.
    pub width: Option<usize>,
}

/// What happens where a frame does not fit on the line.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Style {
    /// Every line ends that may.
    All,
    /// A line ends where the next piece does not fit.
    Fill,
}

/// Collects instructions and measures them.
#[derive(Default)]
pub(super) struct Script<'s> {
    pub ops: Vec<Op<'s>>,
    open: Vec<Opened>,
    end: Mark,
    /// Blanks that come before the next text.
    blanks: usize,
    /// The next text belongs to what is before it in spite of those blanks.
    is_glued: bool,
    /// Instructions whose width ends here: a text that follows without a blank is a part of it.
    ending: Vec<usize>,
}

struct Opened {
    op: usize,
    start: Mark,
    /// The last place in this frame where the line may end.
    line: Option<(usize, Mark)>,
}

/// How much has been written.
#[derive(Clone, Copy, Default)]
struct Mark {
    columns: usize,
    /// How often a line must end.
    breaks: usize,
}

impl<'s> Script<'s> {
    pub(super) fn text(&mut self, text: &'s str) {
        self.measure(text);
        self.ops.push(Op::Text(text));
    }

    pub(super) fn comma(&mut self) {
        self.blanks = 0;
        self.measure(",");
        self.ops.push(Op::Comma);
    }

    pub(super) fn blank(&mut self) {
        self.blanks(1);
    }

    /// A blank at which no line may end: what comes next must fit too.
    pub(super) fn glue(&mut self) {
        self.blank();
        self.is_glued = true;
    }

    pub(super) fn blanks(&mut self, count: usize) {
        self.blanks = self.blanks.max(count);
        self.ops.push(Op::Blanks(count));
    }

    pub(super) fn line(&mut self, blanks: usize, offset: usize) {
        self.end_piece();
        self.ending.clear();
        self.blanks = self.blanks.max(blanks);
        let mark = self.mark();
        if let Some(opened) = self.open.last_mut() {
            opened.line = Some((self.ops.len(), mark));
        }
        self.ops.push(Op::Line(Line { blanks, offset, width: None }));
    }

    pub(super) fn start(&mut self) {
        self.ops.push(Op::Start);
    }

    pub(super) fn line_break(&mut self, offset: usize, blank: bool) {
        self.end_piece();
        self.must_break();
        self.ops.push(Op::Break { offset, blank });
    }

    pub(super) fn own(&mut self, offset: usize, blank: bool) {
        self.must_break();
        self.ops.push(Op::Own { offset, blank });
    }

    pub(super) fn below(&mut self) {
        self.must_break();
        self.ops.push(Op::Below);
    }

    pub(super) fn comment(&mut self, text: &'s str, column: usize) {
        self.blanks = self.blanks.max(1);
        self.is_glued = false;
        self.measure(text);
        self.blanks = 1;
        self.end.breaks += usize::from(text.contains('\n'));
        self.ops.push(Op::Comment { text, column });
    }

    pub(super) fn end_line(&mut self) {
        self.must_break();
        self.ops.push(Op::EndLine);
    }

    pub(super) fn open(&mut self, style: Style, base: usize, hang: usize) {
        let (op, start) = (self.ops.len(), self.mark());
        self.open.push(Opened { op, start, line: None });
        self.ops.push(Op::Open(Frame { style, base, hang, width: None }));
    }

    pub(super) fn close(&mut self) {
        self.end_piece();
        if let Some(opened) = self.open.pop() {
            self.end_width(opened.op, opened.start);
        }
        self.ops.push(Op::Close);
    }

    /// Ends the piece that the last place in this frame where the line may end is followed by:
    /// what comes now, a comment at the end of the line, need not fit.
    pub(super) fn end_piece(&mut self) {
        if let Some((op, start)) = self.open.last_mut().and_then(|opened| opened.line.take()) {
            self.end_width(op, start);
        }
    }

    fn end_width(&mut self, op: usize, start: Mark) {
        let measured = (self.end.breaks == start.breaks)
            .then(|| self.end.columns.saturating_sub(start.columns));
        if let Some(width) = self.ops[op].width() {
            *width = measured;
            self.ending.push(op);
        }
    }

    fn measure(&mut self, text: &str) {
        let columns = text.chars().count();
        let mut glued = 0;
        if self.is_glued {
            glued = self.blanks;
        } else if self.blanks > 0 {
            self.ending.clear();
        }
        self.is_glued = false;
        for &op in &self.ending {
            if let Some(Some(width)) = self.ops[op].width() {
                *width += glued + columns;
            }
        }
        self.end.columns += self.blanks + columns;
        self.blanks = 0;
    }

    fn must_break(&mut self) {
        self.end.breaks += 1;
        self.blanks = 0;
        self.is_glued = false;
        self.ending.clear();
    }

    fn mark(&self) -> Mark {
        Mark { columns: self.end.columns + self.blanks, breaks: self.end.breaks }
    }
}
