//! Text from a program as a comment that ends where its line ends and that no tool obeys.

use std::fmt::{self, Write};

use crate::source::is_plain;

/// First words by which tools recognise an order in a comment.
const ORDERS: [&str; 22] = [
    "altera",
    "ambit",
    "cadence",
    "coverage",
    "exemplar",
    "ghdl",
    "leda",
    "lint",
    "mentor",
    "pragma",
    "psl",
    "quartus",
    "rtl_synthesis",
    "spyglass",
    "synopsys",
    "synplify",
    "synthesis",
    "vcs",
    "verilator",
    "vivado",
    "xilinx",
    "yosys",
];

/// Displays a text so that it can stand behind a comment sign: control, line-breaking, invisible
/// and bidirectional characters become `?`, so does a backslash at the end; an order to a tool
/// gets a word put in front.
pub struct Harmless<'a> {
    text: &'a str,
    ascii: bool,
}

impl<'a> Harmless<'a> {
    /// Keeps the characters of all scripts.
    pub fn unicode(text: &'a str) -> Self {
        Harmless { text, ascii: false }
    }

    /// Keeps ASCII only: VHDL-93 is written in Latin-1.
    pub fn ascii(text: &'a str) -> Self {
        Harmless { text, ascii: true }
    }

    fn keeps(&self, c: char) -> bool {
        match c {
            ' '..='~' => true,
            _ => !self.ascii && is_plain(c),
        }
    }
}

impl fmt::Display for Harmless<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = self.text.trim_end();
        if is_order(text) {
            f.write_str("note: ")?;
        }
        let (body, backslash) = match text.strip_suffix('\\') {
            Some(body) => (body, "?"),
            None => (text, ""),
        };
        let mut rest = body;
        while let Some(at) = rest.find(|c| !self.keeps(c)) {
            f.write_str(&rest[..at])?;
            f.write_char('?')?;
            rest = &rest[at..];
            rest = rest.strip_prefix(|_: char| true).unwrap_or(rest);
        }
        f.write_str(rest)?;
        f.write_str(backslash)
    }
}

fn is_order(text: &str) -> bool {
    let text = text.trim_start_matches(|c: char| !c.is_ascii_alphanumeric());
    let word = text.split(|c: char| !c.is_ascii_alphanumeric() && c != '_').next();
    word.is_some_and(|word| ORDERS.iter().any(|order| order.eq_ignore_ascii_case(word)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn plain_text_stays() {
        assert_eq!(
            Harmless::unicode("rung 1 \"Förderband 你\"").to_string(),
            "rung 1 \"Förderband 你\""
        );
        assert_eq!(
            Harmless::ascii("rung 1 \"Förderband 你\"").to_string(),
            "rung 1 \"F?rderband ?\""
        );
    }

    #[test]
    fn no_character_ends_or_turns_the_line() {
        for c in [
            '\n', '\r', '\t', '\u{0b}', '\u{85}', '\u{2028}', '\u{2029}', '\u{202e}', '\u{2066}',
            '\0',
        ] {
            assert_eq!(Harmless::unicode(&format!("a{c}b")).to_string(), "a?b");
        }
    }

    #[test]
    fn a_backslash_does_not_join_lines() {
        assert_eq!(Harmless::unicode(r"a\b\\").to_string(), r"a\b\?");
        assert_eq!(Harmless::unicode("a\\ ").to_string(), "a?");
    }

    #[test]
    fn tools_do_not_take_orders() {
        for order in
            ["verilator lint_off WIDTH", " Synopsys translate_off", "(pragma) x", "psl assert x"]
        {
            assert!(Harmless::unicode(order).to_string().starts_with("note: "));
        }
        assert_eq!(Harmless::unicode("lamps").to_string(), "lamps");
    }
}
