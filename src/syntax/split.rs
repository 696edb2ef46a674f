//! Cuts a text into items before anything is parsed.
//!
//! The words that start an item are reserved, so one pass over the bytes finds where each item
//! begins. Whatever is wrong inside one item then stays inside it, and items can be parsed on
//! several cores. The pass also sees to everything that would make parsing dangerous or its
//! messages poor: brackets that do not match, what is never closed, nesting without bound.

use std::ops::Range;

use super::MAX_NESTING;
use super::fault::{Fault, found};
use crate::diagnostic::{Diagnostic, code};
use crate::source::Span;

/// What starts an item.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Keyword {
    /// Nothing: the text before the first item, which should be blank.
    Nothing,
    Ladder,
    Clock,
    Tick,
    Input,
    Output,
    Var,
    Const,
    Rung,
    Test,
    /// `assert`, `assume`, `block`, `use`
    Later,
}

impl Keyword {
    fn of(word: &[u8]) -> Option<Keyword> {
        Some(match word {
            b"rung" => Keyword::Rung,
            b"test" => Keyword::Test,
            b"input" => Keyword::Input,
            b"output" => Keyword::Output,
            b"var" => Keyword::Var,
            b"const" => Keyword::Const,
            b"ladder" => Keyword::Ladder,
            b"clock" => Keyword::Clock,
            b"tick" => Keyword::Tick,
            b"assert" | b"assume" | b"block" | b"use" => Keyword::Later,
            _ => return None,
        })
    }

    /// True for the items that can declare an array, which have to be known before any rung.
    pub(super) fn declares(self) -> bool {
        matches!(self, Keyword::Input | Keyword::Output | Keyword::Var)
    }
}

/// One item, not parsed yet.
#[derive(Debug)]
pub(super) struct Chunk {
    pub keyword: Keyword,
    /// The word that starts it.
    pub word: Span,
    /// What follows the word, up to the next item.
    pub body: Span,
    /// Which of the comments lie in the body.
    pub comments: Range<usize>,
    /// Why it must not be parsed.
    pub fault: Option<Box<Fault>>,
}

/// A text cut into items.
#[derive(Debug, Default)]
pub(super) struct Split {
    pub chunks: Vec<Chunk>,
    pub comments: Vec<Span>,
    /// Mistakes that belong to no item.
    pub diagnostics: Vec<Diagnostic>,
}

/// Cuts a text into items.
pub(super) fn split(text: &str) -> Split {
    let start = if text.starts_with('\u{FEFF}') { '\u{FEFF}'.len_utf8() } else { 0 };
    let mut splitter = Splitter { text, bytes: text.as_bytes(), at: start, ..Splitter::default() };
    splitter.split.diagnostics.extend(old_line_end(text));
    splitter.start_chunk(Keyword::Nothing, Span::new(start, start));
    splitter.run();
    let end = Span::new(text.len(), text.len());
    splitter.finish_chunk(end);
    splitter.split
}

/// The first CR without an LF, as a mistake. A comment would run on to the next LF, so people
/// and the compiler would see different programs.
fn old_line_end(text: &str) -> Option<Diagnostic> {
    let bytes = text.as_bytes();
    let at = (0..bytes.len()).find(|&at| is_lone_cr(bytes, at))?;
    let message = "a line ends with CR alone";
    let diagnostic = Diagnostic::new(code::SYNTAX, Span::new(at, at + 1), message)
        .label("a line end of old Mac text")
        .help("save the file with LF or CRLF line ends");
    Some(diagnostic)
}

fn is_lone_cr(bytes: &[u8], at: usize) -> bool {
    bytes[at] == b'\r' && bytes.get(at + 1) != Some(&b'\n')
}

/// Letters, digits, `_` and every byte of a character beyond ASCII: what a word goes on with.
fn continues_word(byte: u8) -> bool {
    byte.is_ascii_alphanumeric() || byte == b'_' || byte >= 0x80
}

fn closer_of(open: u8) -> char {
    match open {
        b'(' => ')',
        b'[' => ']',
        _ => '}',
    }
}

#[derive(Default)]
struct Splitter<'s> {
    text: &'s str,
    bytes: &'s [u8],
    at: usize,
    /// The open brackets of the current item with their places.
    open: Vec<(u8, usize)>,
    /// The bracket that the item before left open, if its end came in the middle of a line.
    left_open: Option<u8>,
    split: Split,
}

impl Splitter<'_> {
    fn run(&mut self) {
        while let Some(&byte) = self.bytes.get(self.at) {
            match byte {
                b' ' | b'\n' | b'\t' | b'\r' => self.at += 1,
                b'a'..=b'z' | b'A'..=b'Z' | b'_' | b'0'..=b'9' | 0x80.. => self.word(),
                b'(' | b'[' | b'{' => self.open_bracket(byte),
                b')' | b']' | b'}' => self.close_bracket(byte),
                b'"' => self.quoted("a string", '"'),
                b'`' => self.quoted("a quoted name", '`'),
                b'/' => match self.bytes.get(self.at + 1) {
                    Some(b'/') => self.line_comment(),
                    Some(b'*') => self.block_comment(),
                    _ => self.at += 1,
                },
                0..0x20 | 0x7F => self.control_character(),
                _ => self.at += 1,
            }
        }
    }

    fn word(&mut self) {
        let start = self.at;
        let length = self.bytes[start..].iter().position(|&byte| !continues_word(byte));
        self.at = length.map_or(self.bytes.len(), |length| start + length);
        if let Some(keyword) = Keyword::of(&self.bytes[start..self.at]) {
            let word = Span::new(start, self.at);
            self.finish_chunk(word);
            self.start_chunk(keyword, word);
        }
    }

    fn start_chunk(&mut self, keyword: Keyword, word: Span) {
        let comments = self.split.comments.len();
        let body = Span { start: word.end, end: word.end };
        let comments = comments..comments;
        self.split.chunks.push(Chunk { keyword, word, body, comments, fault: None });
    }

    /// Ends the current item where the next one, or the end of the file, stands.
    fn finish_chunk(&mut self, next: Span) {
        self.left_open = None;
        if let Some(&(open, at)) = self.open.last() {
            if starts_mid_line(self.text, next) {
                self.left_open = Some(open);
            }
            let here =
                if next.start == next.end { "the file ends" } else { "the next item starts" };
            let diagnostic = Diagnostic::new(
                code::UNCLOSED,
                Span::new(at, at + 1),
                format!("`{}` is never closed", open as char),
            )
            .label("opened here")
            .also(next, format!("{here} here"))
            .help(format!("close it with `{}`", closer_of(open)));
            self.fault(Fault { diagnostic, at_start: false, at_end: true });
        }
        self.open.clear();
        let comments = self.split.comments.len();
        if let Some(chunk) = self.split.chunks.last_mut() {
            chunk.body.end = next.start;
            chunk.comments.end = comments;
        }
    }

    /// Notes the first mistake of the current item; what follows it may only be its consequence.
    fn fault(&mut self, fault: Fault) {
        if let Some(chunk) = self.split.chunks.last_mut() {
            chunk.fault.get_or_insert_with(|| Box::new(fault));
        }
        self.open.clear();
    }

    fn is_broken(&self) -> bool {
        self.split.chunks.last().is_some_and(|chunk| chunk.fault.is_some())
    }

    fn open_bracket(&mut self, open: u8) {
        let at = self.at;
        self.at += 1;
        if self.is_broken() {
            return;
        }
        if self.open.len() == MAX_NESTING {
            let message = format!("brackets are nested more than {MAX_NESTING} deep");
            let diagnostic = Diagnostic::new(code::TOO_DEEP, Span::new(at, at + 1), message)
                .label(format!("{MAX_NESTING} brackets are open before this one"))
                .help("give a part of the rung a coil of its own and use its contact here");
            self.fault(diagnostic.into());
            return;
        }
        self.open.push((open, at));
    }

    fn close_bracket(&mut self, close: u8) {
        let span = Span::new(self.at, self.at + 1);
        self.at += 1;
        if self.is_broken() {
            return;
        }
        let close = close as char;
        match self.open.pop() {
            Some((open, _)) if closer_of(open) == close => {}
            Some((open, at)) => {
                let message = format!("`{close}` does not close `{}`", open as char);
                let help = format!("close `{}` with `{}` first", open as char, closer_of(open));
                let diagnostic = Diagnostic::new(code::UNCLOSED, span, message)
                    .label("the wrong closing bracket")
                    .also(Span::new(at, at + 1), "this bracket is open")
                    .help(help);
                self.fault(diagnostic.into());
            }
            None => {
                let diagnostic =
                    Diagnostic::new(code::UNCLOSED, span, format!("`{close}` closes nothing"))
                        .label("no bracket is open here")
                        .help("remove it, or open the bracket in the same rung or test");
                // With a bracket left open just before, the reserved word between the two is
                // what is wrong: it was meant as a name.
                let at_start = self.left_open.map(closer_of) == Some(close);
                self.fault(Fault { diagnostic, at_start, at_end: false });
            }
        }
    }

    /// A string or a quoted name: neither goes beyond its line.
    fn quoted(&mut self, what: &str, mark: char) {
        let start = self.at;
        self.at = self.line_end(start + 1, mark as u8);
        if self.bytes.get(self.at) == Some(&(mark as u8)) {
            self.at += 1;
            return;
        }
        let line = self.text[start..self.at].trim_end().len();
        let diagnostic = Diagnostic::new(
            code::UNCLOSED,
            Span::new(start, start + line),
            format!("{what} is not closed"),
        )
        .label("this goes on to the end of the line")
        .help(format!("close it with {} on the same line", found(&mark.to_string())));
        self.fault(diagnostic.into());
    }

    fn line_comment(&mut self) {
        let start = self.at;
        self.at = self.line_end(start, b'\n');
        let ends_with_cr = self.bytes[self.at - 1] == b'\r';
        self.split.comments.push(Span::new(start, self.at - usize::from(ends_with_cr)));
    }

    /// Where the line that holds `start` ends, or a mark stands before that.
    fn line_end(&self, start: usize, mark: u8) -> usize {
        let ends = |&at: &usize| {
            let byte = self.bytes[at];
            byte == mark || byte == b'\n' || is_lone_cr(self.bytes, at)
        };
        (start..self.bytes.len()).find(ends).unwrap_or(self.bytes.len())
    }

    fn block_comment(&mut self) {
        let start = self.at;
        let mut depth = 0;
        let mut too_deep = None;
        while let Some(pair) = self.bytes.get(self.at..self.at + 2) {
            match pair {
                b"/*" if depth == MAX_NESTING => {
                    too_deep.get_or_insert(self.at);
                    depth += 1;
                    self.at += 2;
                }
                b"/*" => {
                    depth += 1;
                    self.at += 2;
                }
                b"*/" => {
                    depth -= 1;
                    self.at += 2;
                    if depth == 0 {
                        break;
                    }
                }
                _ => self.at += 1,
            }
        }
        if depth > 0 {
            self.at = self.bytes.len();
            let span = Span::new(start, start + 2);
            let diagnostic = Diagnostic::new(code::UNCLOSED, span, "a comment is not closed")
                .label("everything from here to the end of the file is a comment")
                .help("close it with `*/`; comments nest, so every `/*` needs its own `*/`");
            self.fault(diagnostic.into());
        } else if let Some(at) = too_deep {
            let message = format!("comments are nested more than {MAX_NESTING} deep");
            let diagnostic = Diagnostic::new(code::TOO_DEEP, Span::new(at, at + 2), message)
                .label(format!("{MAX_NESTING} comments are open before this one"))
                .help("`//` at the start of each line takes a whole passage out as well");
            self.split.diagnostics.push(diagnostic);
        }
        self.split.comments.push(Span::new(start, self.at));
    }

    /// Control characters mean nothing, and two of them mark indexes in what the grammar reads.
    fn control_character(&mut self) {
        let span = Span::new(self.at, self.at + 1);
        let character = found(&self.text[span.range()]);
        let diagnostic = Diagnostic::new(
            code::SYNTAX,
            span,
            format!("the control character {character} cannot stand here"),
        )
        .label("an invisible character")
        .help("remove it; white space is blanks, tabs and line ends");
        self.fault(diagnostic.into());
        self.at += 1;
    }
}

/// True if something other than white space stands before `word` on its line.
pub(super) fn starts_mid_line(text: &str, word: Span) -> bool {
    // Looking for the start of the line instead would take long where everything is one line.
    let before = text[..word.start as usize].trim_end_matches([' ', '\t']);
    !before.is_empty() && !before.ends_with(['\n', '\r', '\u{FEFF}'])
}

#[cfg(test)]
#[path = "split_tests.rs"]
mod tests;
