//! Texts of a program, made fit to be drawn: harmless, measured, cut into lines.

use unicode_width::UnicodeWidthStr;

use crate::source::{Source, Span, is_plain};

/// How many cells a text takes.
pub(super) fn width(text: &str) -> i32 {
    text.width() as i32
}

/// A text in which no character acts on a terminal, a browser or the texts around it.
pub fn harmless(text: &str) -> String {
    let shown = |c| match c {
        '\t' => ' ',
        c if is_plain(c) => c,
        _ => '?',
    };
    text.chars().map(shown).collect()
}

/// What is written in a span, on one line and without comments. `comments` are those of the whole
/// file, in text order.
pub(super) fn written(source: &Source, span: Span, comments: &[Span]) -> String {
    let first = comments.partition_point(|comment| comment.end <= span.start);
    let mut pieces = String::new();
    let mut at = span.start;
    for comment in comments[first..].iter().take_while(|comment| comment.start < span.end) {
        pieces += source.slice(Span { start: at, end: comment.start.max(at) });
        pieces.push(' ');
        at = comment.end.min(span.end);
    }
    pieces += source.slice(Span { start: at, end: span.end });
    let words: Vec<&str> =
        pieces.split([' ', '\t', '\r', '\n']).filter(|w| !w.is_empty()).collect();
    harmless(&words.join(" "))
}

/// A text of at most `limit` cells: its start, and two dots for the rest.
pub(super) fn shortened(text: &str, limit: i32) -> String {
    match width(text) <= limit {
        true => text.to_owned(),
        false => format!("{}..", &text[..cut(text, limit - 2)]),
    }
}

/// Cuts a text into lines of at most `limit` cells, at blanks where there are some. There is one
/// line at least.
pub(super) fn lines(text: &str, limit: i32) -> Vec<String> {
    let mut lines = Vec::new();
    let mut line = String::new();
    for word in text.split(' ').filter(|word| !word.is_empty()) {
        if !line.is_empty() && width(&line) + 1 + width(word) > limit {
            lines.push(std::mem::take(&mut line));
        }
        if !line.is_empty() {
            line.push(' ');
        }
        line += word;
        while width(&line) > limit {
            let rest = line.split_off(cut(&line, limit));
            lines.push(std::mem::replace(&mut line, rest));
        }
    }
    if !line.is_empty() || lines.is_empty() {
        lines.push(line);
    }
    lines
}

/// Where a text that is too wide is cut: after one character at least.
fn cut(text: &str, limit: i32) -> usize {
    let mut ends = text.char_indices().map(|(at, c)| at + c.len_utf8());
    let first = ends.next().unwrap_or(0);
    ends.take_while(|&end| width(&text[..end]) <= limit).last().unwrap_or(first)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_end_at_blanks_or_where_they_must() {
        assert_eq!(lines("a bc def", 4), ["a bc", "def"]);
        assert_eq!(lines("abcdefg h", 3), ["abc", "def", "g h"]);
        assert_eq!(lines("", 3), [""]);
        assert_eq!(lines("你好吗", 4), ["你好", "吗"]);
        assert_eq!(lines("你", 1), ["你"]);
    }

    #[test]
    fn a_long_text_is_cut() {
        assert_eq!(shortened("abcdef", 6), "abcdef");
        assert_eq!(shortened("abcdefg", 6), "abcd..");
        assert_eq!(shortened("你好世界", 6), "你好..");
    }

    #[test]
    fn comments_and_line_ends_are_not_drawn() {
        let source = Source::new("a", "a /* b */+\n\tc // d\n");
        let comments = [Span::new(2, 9), Span::new(14, 18)];
        assert_eq!(written(&source, Span::new(0, 13), &comments), "a + c");
        assert_eq!(written(&source, Span::new(0, 19), &comments), "a + c");
        assert_eq!(written(&source, Span::new(4, 19), &comments), "+ c");
    }

    #[test]
    fn nothing_acts_on_a_terminal() {
        assert_eq!(harmless("a\u{1b}[1m\u{202e}b\tc\u{ffff}"), "a?[1m?b c?");
    }
}
