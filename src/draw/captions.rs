//! The comments that stand above an item, as a caption.

use super::words::harmless;
use crate::source::{Source, Span};

/// Looks for comments.
pub(super) struct Captions<'a> {
    pub source: &'a Source,
    /// Every comment of the source, in text order.
    pub comments: &'a [Span],
}

impl Captions<'_> {
    /// The lines of the comments directly above the line of a place: no blank line between them.
    pub fn above(&self, offset: u32) -> Vec<String> {
        let mut start = self.start_of_line(offset);
        let before = self.comments.partition_point(|comment| comment.end <= start);
        let mut found = before;
        while let Some(comment) = found.checked_sub(1).map(|index| self.comments[index]) {
            let between = self.source.slice(Span { start: comment.end, end: start });
            let line = self.start_of_line(comment.start);
            let ahead = self.source.slice(Span { start: line, end: comment.start });
            let is_own = ahead.trim_start_matches('\u{FEFF}').trim().is_empty();
            let is_next = between.trim().is_empty() && between.matches('\n').count() == 1;
            if !is_own || !is_next {
                break;
            }
            found -= 1;
            start = line;
        }
        self.comments[found..before].iter().flat_map(|comment| self.lines(*comment)).collect()
    }

    fn start_of_line(&self, offset: u32) -> u32 {
        let line = self.source.line(offset);
        self.source.lines(line, line).start
    }

    /// What a comment says, without its signs.
    fn lines(&self, comment: Span) -> Vec<String> {
        let text = self.source.slice(comment);
        let inner = match text.strip_prefix("//") {
            Some(line) => line,
            None => text.trim_start_matches("/*").trim_end_matches("*/"),
        };
        let lines = inner.lines().map(|line| harmless(line.trim().trim_start_matches("* ")));
        lines.filter(|line| !line.is_empty()).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_stands_directly_above_is_a_caption() {
        let text = "// far\n\n// one\n/* two\n * three */\nrung\nx // beside\nrung";
        let span = |part: &str| {
            let at = text.find(part).unwrap();
            Span::new(at, at + part.len())
        };
        let comments =
            [span("// far"), span("// one"), span("/* two\n * three */"), span("// beside")];
        let source = Source::new("a", text);
        let captions = Captions { source: &source, comments: &comments };
        let first = text.find("rung").unwrap() as u32;
        assert_eq!(captions.above(first), ["one", "two", "three"]);
        assert!(captions.above(text.rfind("rung").unwrap() as u32).is_empty());
    }
}
