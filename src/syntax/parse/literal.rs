//! Numbers, times and quantities: what they are by their looks.

use super::grammar::{Pair, Rule};
use super::{Lower, Parsed};
use crate::diagnostic::{Diagnostic, code, shortened};
use crate::syntax::ast::{Amount, Literal, LiteralKind, Text};

const BASES: &str = "the base of a number is 2, 8 or 16";
const UNDERSCORE: &str = "one `_` stands between two digits";

/// Units of time, from large to small.
const UNITS: [&str; 7] = ["d", "h", "m", "s", "ms", "us", "ns"];

impl<'s> Lower<'s> {
    /// A title without its quotes.
    pub(super) fn title(&self, pair: &Pair<'_>) -> Text<'s> {
        let span = self.span(pair);
        Text { text: &self.text[span.start as usize + 1..span.end as usize - 1], span }
    }

    /// A number or a time.
    pub(super) fn literal(&self, pair: &Pair<'_>) -> Parsed<Literal<'s>> {
        let span = self.span(pair);
        let text = &self.text[span.range()];
        let mistake = match kind(text) {
            Ok(kind) => return Ok(Literal { kind, text, span }),
            Err(mistake) => mistake,
        };
        let message = format!("`{}` is no number and no time", shortened(text));
        if let Some(based) = based_elsewhere(text) {
            let diagnostic = Diagnostic::new(code::SYNTAX, span, message).label(BASES);
            return self.fault(diagnostic.help(format!("write {}", shortened(&based))));
        }
        let diagnostic = Diagnostic::new(code::SYNTAX, span, message).label(mistake);
        self.fault(diagnostic.help(match mistake {
            BASES => "write 2#1010, 8#17, 16#FF, or a decimal number without `#`",
            UNDERSCORE => "write 1_000 or 16#FF_FF",
            _ => "numbers are 10, 1_000, 16#FF; times are 500ms, 1.3s, 2m30s",
        }))
    }

    /// A whole number.
    pub(super) fn integer(&self, pair: &Pair<'_>, what: &str) -> Parsed<Literal<'s>> {
        self.literal_of(pair, LiteralKind::Integer, what)
    }

    /// A whole number, or a constant that stands for one.
    pub(super) fn count(&self, pair: &Pair<'_>, what: &str) -> Parsed<Amount<'s>> {
        self.amount(pair, LiteralKind::Integer, what)
    }

    /// A literal of one kind, or a constant that stands for one.
    pub(super) fn amount(
        &self,
        pair: &Pair<'_>,
        kind: LiteralKind,
        what: &str,
    ) -> Parsed<Amount<'s>> {
        match pair.as_rule() {
            Rule::name => self.name(pair).map(Amount::Constant),
            _ => self.literal_of(pair, kind, what).map(Amount::Literal),
        }
    }

    /// A literal of one kind.
    pub(super) fn literal_of(
        &self,
        pair: &Pair<'_>,
        kind: LiteralKind,
        what: &str,
    ) -> Parsed<Literal<'s>> {
        let literal = self.literal(pair)?;
        if literal.kind == kind {
            return Ok(literal);
        }
        let message = format!("expected {what}, found `{}`", shortened(literal.text));
        let (label, help) = match kind {
            LiteralKind::Time => ("this has no unit of time", "times are 500ms, 1.3s, 2m30s"),
            _ => ("this is a time", "write a whole number without a unit"),
        };
        self.fault(Diagnostic::new(code::SYNTAX, literal.span, message).label(label).help(help))
    }
}

/// How a number with a base is written that is written as in C or as in an assembler.
fn based_elsewhere(text: &str) -> Option<String> {
    let lower = text.to_ascii_lowercase();
    let prefixed = [("0x", 16), ("0b", 2), ("0o", 8)]
        .into_iter()
        .find_map(|(prefix, base)| Some((lower.strip_prefix(prefix)?.len(), base)));
    let (digits, base) = match prefixed {
        Some((length, base)) => (&text[text.len() - length..], base),
        None => (text.strip_suffix(['h', 'H'])?, 16),
    };
    are_digits(digits, base).then(|| format!("{base}#{digits}"))
}

fn kind(text: &str) -> Result<LiteralKind, &'static str> {
    match text.split_once('#') {
        Some((base, digits)) if base.starts_with(|c: char| c.is_ascii_digit()) => {
            let base = match base {
                "2" => 2,
                "8" => 8,
                "16" => 16,
                _ => return Err(BASES),
            };
            if has_stray_underscore(digits) {
                return Err(UNDERSCORE);
            }
            if !are_digits(digits, base) {
                return Err("these are no digits of that base");
            }
            Ok(LiteralKind::Integer)
        }
        Some((_, time)) => time_parts(time).map(|()| LiteralKind::Time),
        None if are_digits(text, 10) => Ok(LiteralKind::Integer),
        None if has_stray_underscore(text) => Err(UNDERSCORE),
        None => time_parts(text).map(|()| LiteralKind::Time),
    }
}

/// True if an underscore stands at the end or beside another one.
fn has_stray_underscore(text: &str) -> bool {
    text.ends_with('_') || text.starts_with('_') || text.contains("__")
}

/// Digits with single underscores between them.
fn are_digits(text: &str, base: u32) -> bool {
    text.split('_').all(|part| !part.is_empty() && part.chars().all(|c| c.is_digit(base)))
}

/// Numbers with units, from large units to small; the last number may have a fraction.
fn time_parts(text: &str) -> Result<(), &'static str> {
    let mut rest = text;
    let mut units = UNITS.as_slice();
    loop {
        let end = rest.find(|c: char| c.is_alphabetic()).unwrap_or(rest.len());
        let (number, tail) = rest.split_at(end);
        let (whole, fraction) = number.split_once('.').unwrap_or((number, "0"));
        if !are_digits(whole, 10) || !are_digits(fraction, 10) {
            return Err("a number belongs before each unit of time");
        }
        let end = tail.find(|c: char| !c.is_alphabetic()).unwrap_or(tail.len());
        let (unit, tail) = tail.split_at(end);
        if unit.is_empty() {
            return Err("a unit of time belongs after a fraction: d h m s ms us ns");
        }
        let Some(at) = units.iter().position(|&known| known == unit) else {
            let is_unit = UNITS.contains(&unit);
            return Err(if is_unit { "units go from large to small" } else { "unknown unit" });
        };
        units = &units[at + 1..];
        if tail.is_empty() {
            return Ok(());
        }
        if number.contains('.') {
            return Err("only the last part of a time can have a fraction");
        }
        rest = tail.strip_prefix('_').unwrap_or(tail);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn literals_are_known_by_their_looks() {
        for text in ["0", "10", "1_000", "16#FF", "2#10_10", "8#17"] {
            assert_eq!(kind(text), Ok(LiteralKind::Integer), "{text}");
        }
        for text in [
            "500ms",
            "1.3s",
            "2m30s",
            "T#1.5s",
            "T#2m_30s",
            "1_000us",
            "TIME#1d2h",
            "Time#5s",
            "3ns",
        ] {
            assert_eq!(kind(text), Ok(LiteralKind::Time), "{text}");
        }
        for text in
            ["1__0", "10_", "3#1", "2#12", "16#", "1.5", "5x", "5S", "30s2m", "1.5m3s", "T#"]
        {
            assert!(kind(text).is_err(), "{text}");
        }
    }

    #[test]
    fn bases_of_other_languages_are_known() {
        for (text, here) in [
            ("0x1F", "16#1F"),
            ("0XfF_00", "16#fF_00"),
            ("0b101", "2#101"),
            ("0o17", "8#17"),
            ("1Fh", "16#1F"),
        ] {
            assert!(kind(text).is_err(), "{text}");
            assert_eq!(based_elsewhere(text).as_deref(), Some(here), "{text}");
        }
        for text in ["0x", "0b2", "1G", "5x", "xh"] {
            assert_eq!(based_elsewhere(text), None, "{text}");
        }
    }
}
