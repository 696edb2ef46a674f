//! What a layout must not change: the tree, and the comments with their places among the tokens.

use hotrail::source::Source;
use hotrail::syntax;

/// The items without the places of its parts.
pub fn tree(text: &str) -> Vec<String> {
    let source = Source::new("test.ladder", text);
    let (file, diagnostics) = syntax::parse(&source);
    assert_eq!(diagnostics, [], "{text}");
    file.items.iter().map(|item| without_spans(item, text)).collect()
}

fn without_spans(item: &syntax::ast::Item<'_>, text: &str) -> String {
    if let syntax::ast::Item::Reserved(reserved) = item {
        let words: Vec<&str> = text[reserved.span.range()].split_whitespace().collect();
        return words.join(" ");
    }
    let shown = format!("{item:?}");
    let mut parts = shown.split("Span {");
    let first = parts.next().unwrap_or_default().to_owned();
    parts.fold(first, |tree, part| tree + part.split_once('}').map_or("", |(_, rest)| rest))
}

/// A piece of a source.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Piece<'t> {
    Token(&'t str),
    Comment(&'t str),
}

/// Cuts a text into tokens and comments. Where two words touch there is a blank between them.
pub fn pieces(text: &str) -> Vec<Piece<'_>> {
    let text = text.trim_start_matches('\u{FEFF}');
    let mut pieces = Vec::new();
    let mut rest = text.trim_start();
    while !rest.is_empty() {
        let comment = comment_length(rest);
        let length = comment.unwrap_or_else(|| token_length(rest));
        let piece = &rest[..length];
        pieces.push(if comment.is_some() { Piece::Comment(piece) } else { Piece::Token(piece) });
        rest = rest[length..].trim_start();
    }
    pieces
}

fn comment_length(text: &str) -> Option<usize> {
    if text.starts_with("//") {
        return Some(text.find('\n').unwrap_or(text.len()));
    }
    let mut depth = 0;
    let mut at = 0;
    while text.starts_with("/*") {
        let pair = &text.as_bytes()[at..at + 2];
        depth += i32::from(pair == b"/*") - i32::from(pair == b"*/");
        at += if pair == b"/*" || pair == b"*/" { 2 } else { 1 };
        if depth == 0 {
            return Some(at);
        }
    }
    None
}

fn token_length(text: &str) -> usize {
    const SIGNS: [&str; 7] = ["<->", "->", ":=", "<=", ">=", "<>", "//"];
    let first = text.chars().next().expect("the text is not empty");
    let is_word = |c: char| c == '_' || c.is_alphanumeric() || matches!(c, '.' | '#');
    match first {
        '"' => 2 + text[1..].find(first).expect("strings are closed"),
        '`' => {
            let name = 2 + text[1..].find(first).expect("quoted names are closed");
            name + text[name..].find(|c| !is_word(c)).unwrap_or(text.len() - name)
        }
        // A member or a bit of an element has its point right after the bracket.
        ']' if text[1..].starts_with('.') => 1 + text[1..].find(|c| !is_word(c)).unwrap_or(0),
        _ if is_word(first) => text.find(|c| !is_word(c)).unwrap_or(text.len()),
        _ => SIGNS.iter().find(|sign| text.starts_with(**sign)).map_or(1, |sign| sign.len()),
    }
}

/// Every comment with the number of tokens before it. Commas may change places with comments, and
/// brackets that are doubled go, so neither counts; the words of an item always do.
pub fn comments_and_places(text: &str) -> Vec<(usize, String)> {
    let mut tokens = 0;
    let mut comments = Vec::new();
    for piece in pieces(text) {
        match piece {
            Piece::Token("," | "(" | ")") => {}
            Piece::Token(_) => tokens += 1,
            Piece::Comment(comment) => {
                let lines: Vec<&str> = comment.lines().map(str::trim).collect();
                comments.push((tokens, lines.join("\n")));
            }
        }
    }
    comments
}
