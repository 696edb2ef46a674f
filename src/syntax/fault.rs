//! Mistakes of one item, and words for what stands where something else should.

use std::borrow::Cow;

use crate::diagnostic::{Diagnostic, code, shortened};
use crate::source::Span;

/// The first mistake of an item. Where it lies tells if the word that starts the item, or the
/// next one, was meant as a name.
#[derive(Debug)]
pub(super) struct Fault {
    pub diagnostic: Diagnostic,
    /// It is the first thing after the item's own word.
    pub at_start: bool,
    /// The item ends where more should follow.
    pub at_end: bool,
}

impl From<Diagnostic> for Fault {
    fn from(diagnostic: Diagnostic) -> Self {
        Fault { diagnostic, at_start: false, at_end: false }
    }
}

/// A name as it stands in a program: in back-ticks where it needs them.
pub fn written_name(name: &str) -> Cow<'_, str> {
    let is_plain = name.chars().all(|c| c == '_' || c.is_ascii_alphanumeric())
        && !name.starts_with(|c: char| c.is_ascii_digit())
        && !is_reserved(name);
    if is_plain { name.into() } else { format!("`{name}`").into() }
}

/// Words that the grammar keeps for itself.
pub(super) fn is_reserved(word: &str) -> bool {
    matches!(
        word,
        "ladder"
            | "input"
            | "output"
            | "var"
            | "const"
            | "clock"
            | "tick"
            | "rung"
            | "net"
            | "test"
            | "scan"
            | "wait"
            | "expect"
            | "repeat"
            | "pulse"
            | "reset"
            | "assert"
            | "assume"
            | "block"
            | "use"
            | "rise"
            | "fall"
            | "rising"
            | "falling"
            | "not"
            | "at"
            | "first_scan"
            | "TRUE"
            | "FALSE"
            | "AND"
            | "OR"
            | "XOR"
            | "NOT"
            | "MOD"
    )
}

/// What to do about a reserved word that was meant as a name.
const ANOTHER_NAME: &str = "choose another name";

/// A reserved word stands where a name belongs.
pub(super) fn reserved_name(word: &str, span: Span) -> Diagnostic {
    Diagnostic::new(
        code::RESERVED_NAME,
        span,
        format!("`{word}` is a reserved word and cannot be a name"),
    )
    .label("a name belongs here")
    .help(match word {
        "AND" | "OR" | "XOR" | "NOT" => format!(
            "`{word}` stands in expressions: `{{ a AND NOT b }}`; contacts are written `a !b` in \
             series, `[ a | b ]` in parallel"
        ),
        _ => format!("{ANOTHER_NAME}, or write it in back-ticks: `` `{word}` ``"),
    })
}

/// True for a finding about a reserved word that was meant as a name, and not as an operator.
pub(super) fn is_reserved_name(found: &Diagnostic) -> bool {
    found.code == code::RESERVED_NAME
        && found.help.first().is_some_and(|help| help.starts_with(ANOTHER_NAME))
}

/// The token at the start of a text.
pub(super) fn first_token(text: &str) -> &str {
    const OPERATORS: [&str; 15] =
        ["<->", "->", "<-", ":=", "=:", "<=", ">=", "<>", "=>", "==", "!=", "&&", "||", "..", "*/"];
    let Some(first) = text.chars().next() else {
        return "";
    };
    let is_word = |c: char| c == '_' || c.is_alphanumeric();
    let length = match first {
        '"' | '`' => text[1..].find(first).map_or(text.len(), |length| length + 2),
        '0'..='9' => text.find(|c: char| !is_word(c) && c != '#' && c != '.').unwrap_or(text.len()),
        _ if is_word(first) => text.find(|c: char| !is_word(c)).unwrap_or(text.len()),
        _ => {
            let operator = OPERATORS.iter().find(|&&operator| text.starts_with(operator));
            operator.map_or(first.len_utf8(), |operator| operator.len())
        }
    };
    &text[..length]
}

/// A token as a message shows it.
pub(super) fn found(token: &str) -> String {
    match token.chars().next() {
        None => "the end of the file".to_owned(),
        Some('"') if token.len() > 1 => {
            format!("the string \"{}\"", shortened(token.trim_matches('"')))
        }
        Some('`') if token.len() > 1 => {
            format!("the name `{}`", shortened(token.trim_matches('`')))
        }
        Some('`') => "a back-tick".to_owned(),
        Some(character) if is_invisible(character) => format!("U+{:04X}", character as u32),
        Some(_) => format!("`{}`", shortened(token)),
    }
}

/// True for a character that leaves nothing to be seen in a message: control characters, blanks
/// beyond ASCII, and what only joins, parts or turns the characters around it.
pub(super) fn is_invisible(character: char) -> bool {
    character.is_control()
        || character.is_whitespace()
        || matches!(
            character,
            '\u{AD}'
                | '\u{180E}'
                | '\u{200B}'..='\u{200F}'
                | '\u{202A}'..='\u{202E}'
                | '\u{2060}'..='\u{206F}'
                | '\u{FEFF}'
        )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tokens_are_shown_whole() {
        for (text, token) in [
            ("<-> b", "<->"),
            ("16#FFx y", "16#FFx"),
            ("1.3s)", "1.3s"),
            ("größe_1+", "größe_1"),
            ("\"a b\" c", "\"a b\""),
            ("→ x", "→"),
            ("|| x", "||"),
            ("", ""),
        ] {
            assert_eq!(first_token(text), token);
        }
    }
}
