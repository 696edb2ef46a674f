//! One value of a stimulus.

use crate::model::{Program, VariableId};
use crate::quantity;
use crate::types::Type;

/// 0 or 1, in one of the ways in which tools write it.
pub fn bit(text: &str) -> Result<bool, String> {
    match text {
        "0" => Ok(false),
        "1" => Ok(true),
        _ if text.eq_ignore_ascii_case("false") => Ok(false),
        _ if text.eq_ignore_ascii_case("true") => Ok(true),
        _ => Err("write 0 or 1".to_owned()),
    }
}

/// The value of a variable that a cell says, or what the cell should be.
pub fn value(program: &Program, variable: VariableId, text: &str) -> Result<i64, String> {
    let ty = program.variables[variable].ty;
    let (low, high) = ty.range();
    match ty {
        Type::Bool => bit(text).map(i64::from),
        Type::Time => {
            let tick = quantity::time_text(program.tick_ns.into());
            number(text)
                .or_else(|| time(text, program.tick_ns))
                .filter(|&ticks| ty.holds(ticks))
                .map(|ticks| ticks as i64)
                .ok_or_else(|| {
                    format!(
                        "write a number of ticks, {low} to {high}, or a time such as 500ms; \
                         the tick is {tick}"
                    )
                })
        }
        Type::Int | Type::Uint | Type::Dint | Type::Udint | Type::Word | Type::Dword => {
            number(text)
                .filter(|&value| ty.holds(value))
                .map(|value| value as i64)
                .ok_or_else(|| format!("write a whole number, {low} to {high}"))
        }
    }
}

/// A whole number as a ladder writes it: `-3`, `1_000`, `16#FF`.
fn number(text: &str) -> Option<i128> {
    let (sign, digits) = match text.strip_prefix('-') {
        Some(digits) => (-1, digits),
        None => (1, text),
    };
    let (base, digits) = match digits.split_once('#') {
        Some((base, digits)) => (base.parse().ok().filter(|b| [2, 8, 16].contains(b))?, digits),
        None => (10, digits),
    };
    let digits = digits.replace('_', "");
    let is_number = digits.starts_with(|c: char| c.is_ascii_alphanumeric());
    let magnitude = is_number.then(|| i128::from_str_radix(&digits, base).ok()).flatten()?;
    Some(sign * magnitude)
}

/// A whole number of ticks, written as a time with its unit.
fn time(text: &str, tick_ns: u64) -> Option<i128> {
    let (sign, text) = text.strip_prefix('-').map_or((1, text), |text| (-1, text));
    let ns = quantity::time_ns(text)?;
    (ns % i128::from(tick_ns) == 0).then(|| sign * ns / i128::from(tick_ns))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_written_as_in_a_ladder() {
        assert_eq!(number("-3"), Some(-3));
        assert_eq!(number("1_000"), Some(1000));
        assert_eq!(number("16#fF"), Some(255));
        assert_eq!(number("2#1010"), Some(10));
        for text in ["", "-", "--1", "+1", "1.0", "16#", "3#1", "_", "0x10", "1e3", "16#-1"] {
            assert_eq!(number(text), None, "{text}");
        }
    }

    #[test]
    fn times_are_whole_ticks() {
        assert_eq!(time("500ms", 10_000_000), Some(50));
        assert_eq!(time("-1s", 1_000_000), Some(-1000));
        assert_eq!(time("5ms", 10_000_000), None);
        assert_eq!(time("5", 1_000_000), None);
    }
}
