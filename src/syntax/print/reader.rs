//! Follows the source while the tree is printed.
//!
//! The tree knows what the tokens mean, the source knows what stands between them. Every token
//! that is printed is first taken from the source, so none can be lost, doubled or swapped, and
//! the comments before it are found at exactly their place.

use std::ops::Range;

use crate::source::Span;

/// A place in the source that moves from token to token.
pub(super) struct Reader<'s> {
    text: &'s str,
    comments: &'s [Span],
    /// The first comment that has not been passed.
    next_comment: usize,
    at: usize,
    /// What stands between the last token and `at`, once it has been looked at.
    gap: Option<Gap>,
}

/// What stands between two tokens.
#[derive(Default)]
pub(super) struct Gap {
    /// The comments, one cluster for each line of them.
    pub clusters: Vec<Cluster>,
    /// The next token starts a line.
    pub newline: bool,
    /// A blank line stands before the next token.
    pub blank: bool,
}

/// Comments that stand on one line.
pub(super) struct Cluster {
    /// Which of the comments.
    pub comments: Range<usize>,
    /// They start a line.
    pub newline_before: bool,
    /// A blank line stands before them.
    pub blank_before: bool,
    /// They end their line.
    pub newline_after: bool,
    /// They go on with the comment at the end of the line before, right below it.
    pub continues: bool,
}

impl Cluster {
    /// They have their line for themselves.
    pub(super) fn is_alone(&self) -> bool {
        self.newline_before && self.newline_after
    }
}

impl Gap {
    /// True if the line ends anywhere between the two tokens, the insides of comments aside.
    pub(super) fn has_newline(&self) -> bool {
        self.newline || self.clusters.iter().any(|c| c.newline_before || c.newline_after)
    }
}

impl<'s> Reader<'s> {
    /// Follows a text with these comments.
    pub(super) fn new(text: &'s str, comments: &'s [Span]) -> Self {
        let at = if text.starts_with('\u{FEFF}') { '\u{FEFF}'.len_utf8() } else { 0 };
        Reader { text, comments, next_comment: 0, at, gap: None }
    }

    /// What follows in the source, from the next token on.
    pub(super) fn rest(&mut self) -> &'s str {
        self.look();
        &self.text[self.at..]
    }

    /// Where the next token starts.
    pub(super) fn position(&mut self) -> usize {
        self.look();
        self.at
    }

    /// What stands before the next token. Taken once: what is asked for later is empty.
    pub(super) fn take_gap(&mut self) -> Gap {
        self.look();
        self.gap.replace(Gap::default()).unwrap_or_default()
    }

    /// Puts comments back that should be seen together with the gap that follows, after a token
    /// between the two was taken.
    pub(super) fn join_gap(&mut self, mut before: Vec<Cluster>) {
        let Some(last) = before.last_mut() else { return };
        let mut gap = self.take_gap();
        let mut after = gap.clusters.drain(..).peekable();
        match after.peek_mut() {
            Some(first) if last.newline_after => first.newline_before = true,
            Some(first) if first.newline_before => last.newline_after = true,
            Some(first) => {
                last.comments.end = first.comments.end;
                last.newline_after = first.newline_after;
                after.next();
            }
            None => last.newline_after |= gap.newline,
        }
        before.extend(after);
        gap.clusters = before;
        self.gap = Some(gap);
    }

    /// What stands before the next token, to look at.
    pub(super) fn gap(&mut self) -> &Gap {
        self.look();
        self.gap.get_or_insert_default()
    }

    /// Passes a token.
    ///
    /// # Panics
    /// If another one stands there: the printer is at fault, and going on would harm the file.
    pub(super) fn take(&mut self, token: &str) -> &'s str {
        let rest = self.rest();
        assert!(rest.starts_with(token), "the formatter lost its place at {}", self.at);
        self.take_until(self.at + token.len())
    }

    /// Passes everything up to a place, comments included.
    pub(super) fn take_until(&mut self, end: usize) -> &'s str {
        let start = self.position();
        self.at = end;
        self.gap = None;
        while self.comments.get(self.next_comment).is_some_and(|c| (c.start as usize) < end) {
            self.next_comment += 1;
        }
        &self.text[start..end]
    }

    /// True if a line ends between two places.
    pub(super) fn has_newline(&self, start: usize, end: usize) -> bool {
        self.text[start..end].contains('\n')
    }

    /// The text of a comment.
    pub(super) fn comment(&self, index: usize) -> &'s str {
        &self.text[self.comments[index].range()]
    }

    /// The column of a comment, from 0.
    pub(super) fn comment_column(&self, index: usize) -> usize {
        self.column(self.comments[index].start as usize)
    }

    /// The column of a place, from 0, with a tab stop at every fourth. This takes long where a
    /// line is long, so it is asked for only after a line end, or once a line.
    pub(super) fn column(&self, at: usize) -> usize {
        let start = self.text[..at].rfind('\n').map_or(0, |line_end| line_end + 1);
        column_after(0, self.text[start..at].trim_start_matches('\u{FEFF}'))
    }

    fn look(&mut self) {
        if self.gap.is_some() {
            return;
        }
        let mut gap = Gap::default();
        // The start of the file is the start of a line.
        let mut newlines =
            usize::from(self.text[..self.at].trim_start_matches('\u{FEFF}').is_empty());
        loop {
            let rest = &self.text[self.at..];
            let blank =
                &rest[..rest.len() - rest.trim_start_matches([' ', '\n', '\t', '\r']).len()];
            newlines += blank.bytes().filter(|&byte| byte == b'\n').count();
            self.at += blank.len();
            let last = gap.clusters.last_mut();
            let comment = self.comments.get(self.next_comment);
            let Some(comment) = comment.filter(|comment| comment.start as usize == self.at) else {
                gap.newline = newlines > 0 || self.at == self.text.len();
                gap.blank = newlines > 1;
                if let Some(last) = last {
                    last.newline_after = gap.newline;
                }
                break;
            };
            let index = self.next_comment;
            match last {
                Some(last) if newlines == 0 => last.comments.end = index + 1,
                last => {
                    let mut continues = false;
                    if let Some(last) = last {
                        last.newline_after = true;
                        continues = newlines == 1 && self.is_below(last, index);
                    }
                    gap.clusters.push(Cluster {
                        comments: index..index + 1,
                        newline_before: newlines > 0,
                        blank_before: newlines > 1,
                        newline_after: false,
                        continues,
                    });
                }
            }
            newlines = 0;
            self.next_comment += 1;
            self.at = comment.end as usize;
        }
        self.gap = Some(gap);
    }

    /// True if a line comment stands exactly below another one that stands at the end of a line.
    fn is_below(&self, above: &Cluster, index: usize) -> bool {
        let last = above.comments.end - 1;
        (above.continues || !above.newline_before)
            && [last, index].iter().all(|&index| self.comment(index).starts_with("//"))
            && self.comment_column(last) == self.comment_column(index)
    }
}

/// The column after a text that starts in another one, with a tab stop at every fourth.
pub(super) fn column_after(column: usize, text: &str) -> usize {
    text.chars().fold(column, |column, c| if c == '\t' { column / 4 * 4 + 4 } else { column + 1 })
}
