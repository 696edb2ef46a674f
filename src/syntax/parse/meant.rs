//! What was meant where the text goes wrong: things that are written so elsewhere, and pieces that
//! belong to what stands before them.

use super::Lower;
use super::grammar::Rule;
use crate::diagnostic::{Diagnostic, code, shortened, similar_name};
use crate::source::Span;

/// The label of an address that only a quoted name can be.
pub(super) const AN_ADDRESS: &str = "an address of a PLC, and no name as it stands";

/// Units that stand right behind a number.
const UNITS: [&str; 11] = ["d", "h", "m", "s", "ms", "us", "ns", "Hz", "kHz", "MHz", "GHz"];

const STATEMENTS: [&str; 6] = ["scan", "wait", "pulse", "repeat", "reset", "expect"];

impl Lower<'_> {
    /// The finding where what stands around a place in the body shows what was meant. A token
    /// stands at the place, white space aside.
    pub(super) fn meant(
        &self,
        rule: Rule,
        body: &str,
        at: usize,
        token: &str,
    ) -> Option<Diagnostic> {
        let at = at + body[at..].len() - body[at..].trim_ascii_start().len();
        self.address_at(body, at)
            .or_else(|| self.parted_unit(rule, body, at, token))
            .or_else(|| self.no_statement(rule, body, at, token))
            .or_else(|| self.small_not(rule, body, at))
    }

    /// `I:0/3`, `%IX0.3`, `I0.3`: what other makers write, which stands in back-ticks here.
    fn address_at(&self, body: &str, at: usize) -> Option<Diagnostic> {
        let is_part = |c: char| c.is_ascii_alphanumeric() || "_.:/%".contains(c);
        let start = body[..at]
            .rfind(|c| !is_part(c))
            .map_or(0, |before| before + body[before..].chars().next().map_or(0, char::len_utf8));
        let end = body[at..].find(|c| !is_part(c)).map_or(body.len(), |length| at + length);
        let word = body[start..end].trim_end_matches([':', '.', '/']);
        let word = word.trim_start_matches('/');
        // The mistake lies in the address: a bit `w1.5` may well stand in front of one.
        if !is_address(word) || end <= at {
            return None;
        }
        let end = start + body[start..end].find(word)? + word.len();
        let span = Span::new(self.base + end - word.len(), self.base + end);
        let message = format!("`{}` can stand in back-ticks only", shortened(word));
        let help = format!("write it in back-ticks: `` `{}` ``", shortened(word));
        Some(Diagnostic::new(code::SYNTAX, span, message).label(AN_ADDRESS).help(help))
    }

    /// `100 ms`: a unit apart from its number.
    fn parted_unit(&self, rule: Rule, body: &str, at: usize, token: &str) -> Option<Diagnostic> {
        // A statement that begins with the unit has been read already.
        let (unit, start) = match last_word(&body[..at]) {
            (word, start) if rule == Rule::want_drive && UNITS.contains(&word) => (word, start),
            _ if UNITS.contains(&token) => (token, at),
            _ => return None,
        };
        let (number, number_start) = last_word(&body[..start]);
        if !number.starts_with(|c: char| c.is_ascii_digit()) {
            return None;
        }
        let span = Span::new(self.base + number_start, self.base + start + unit.len());
        let number = shortened(number);
        let message = format!("a unit stands right behind its number, found `{number} {unit}`");
        let diagnostic = Diagnostic::new(code::SYNTAX, span, message).label("in two parts");
        Some(diagnostic.help(format!("write {number}{unit}")))
    }

    /// `sacn expect y`, `scan 3 times`: a word that begins no statement. It has been read as an
    /// input to drive.
    fn no_statement(&self, rule: Rule, body: &str, at: usize, token: &str) -> Option<Diagnostic> {
        let (word, start) = last_word(&body[..at]);
        if rule != Rule::want_drive || word.is_empty() {
            return None;
        }
        let follows_a_number =
            last_word(&body[..start]).0.starts_with(|c: char| c.is_ascii_digit());
        let is_value = matches!(token, "TRUE" | "FALSE");
        let starts_anew = token.starts_with(|c: char| c.is_alphabetic() || "_!{[".contains(c));
        if !follows_a_number && (is_value || !starts_anew) {
            return None;
        }
        let span = Span::new(self.base + start, self.base + start + word.len());
        let message = format!("expected a statement, found `{}`", shortened(word));
        let help = match similar_name(word, STATEMENTS) {
            Some(similar) => format!("is `{similar}` meant?"),
            None => super::wanted::STATEMENTS.to_owned(),
        };
        Some(Diagnostic::new(code::SYNTAX, span, message).label("begins no statement").help(help))
    }

    /// `not a`: the operator in small letters, which has been read as an operand.
    fn small_not(&self, rule: Rule, body: &str, at: usize) -> Option<Diagnostic> {
        let (word, start) = last_word(&body[..at]);
        if !super::wanted::is_in_expression(rule) || !word.eq_ignore_ascii_case("not") {
            return None;
        }
        let span = Span::new(self.base + start, self.base + start + word.len());
        let message = format!("expected a variable, a number or `(`, found `{word}`");
        let diagnostic = Diagnostic::new(code::SYNTAX, span, message).label("not expected here");
        Some(diagnostic.help("operators have capital letters: `NOT a`"))
    }
}

/// The word at the end of a text, white space aside, and where it begins.
fn last_word(text: &str) -> (&str, usize) {
    let text = text.trim_ascii_end();
    let is_part = |c: char| c == '_' || c == '.' || c.is_alphanumeric();
    let word = text.trim_end_matches(is_part).len();
    (&text[word..], word)
}

/// True for the addresses of other makers: `%IX0.3`, `%MW10`, `I:0/3`, `N7:0`, `T4:0.DN`, `I0.3`.
fn is_address(word: &str) -> bool {
    let is_digit = |c: char| c.is_ascii_digit();
    if let Some(word) = word.strip_prefix('%') {
        return word.starts_with(|c: char| c.is_ascii_alphabetic())
            && word.contains(is_digit)
            && !word.contains('%');
    }
    let letters = word.trim_start_matches(|c: char| c.is_ascii_alphabetic());
    let digits = letters.trim_start_matches(is_digit);
    let (has_letters, has_digits) = (letters.len() < word.len(), digits.len() < letters.len());
    match digits.strip_prefix(':') {
        Some(rest) => has_letters && rest.starts_with(is_digit),
        None => {
            let is_short = word.len() - letters.len() <= 2;
            let rest = digits.strip_prefix('.');
            is_short
                && has_letters
                && has_digits
                && rest.is_some_and(|rest| rest.contains(is_digit))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::Source;

    #[test]
    fn addresses_are_known_by_their_looks() {
        for address in [
            "%IX0.3",
            "%MW10",
            "%Q0.1",
            "I:0/3",
            "O:2/1",
            "B3:0/1",
            "N7:0",
            "T4:0/DN",
            "C5:1.ACC",
            "I0.3",
            "Q4.1",
            "DB1.DBX0.0",
        ] {
            assert!(is_address(address), "{address}");
        }
        for other in ["a", "%", "%3", "a:TON", "motor.Q", "x.5", "a/b", "5", "1.5s", "T4", "t1.Q"] {
            assert!(!is_address(other), "{other}");
        }
    }
    fn mistakes(text: &str) -> Vec<String> {
        let source = Source::new("test.ladder", text);
        let (_, found) = crate::syntax::parse(&source);
        found.into_iter().map(|found| found.message).collect()
    }

    #[test]
    fn what_only_looks_like_an_address_or_a_unit_is_none() {
        for (text, message) in [
            ("rung w1.5; (y)", "expected a contact, a coil, a list or the next item, found `;`"),
            ("rung { w1.5 = = 3 } (y)", "expected a variable, a number or `(`, found `=`"),
            ("rung a m, (y)", "expected a contact, a coil, a list or the next item, found `,`"),
            (
                "test \"t\" start 1",
                "expected `:=` and the value to drive the input with, found `1`",
            ),
        ] {
            assert_eq!(mistakes(text), [message], "{text}");
        }
        // An address at the start of an item does not make the item's word a name.
        assert_eq!(
            mistakes("input a, = rung I:0/3 (y)"),
            ["expected a name, found `=`", "`I:0/3` can stand in back-ticks only"]
        );
    }
}
