//! Times and frequencies as people write them.

/// The clock of a program that names none, in Hz.
pub const DEFAULT_CLOCK_HZ: u64 = 12_000_000;
/// The fastest clock of a board, in Hz.
pub const FASTEST_CLOCK_HZ: u64 = 1_000_000_000_000;
/// The longest tick, in nanoseconds: an hour.
pub const LONGEST_TICK_NS: u64 = 3_600_000_000_000;

/// Units of time and their length in nanoseconds; a unit that another one ends in comes after it.
const TIME_UNITS: [(&str, i128); 7] = [
    ("ns", 1),
    ("us", 1_000),
    ("ms", 1_000_000),
    ("s", 1_000_000_000),
    ("m", 60_000_000_000),
    ("h", 3_600_000_000_000),
    ("d", 86_400_000_000_000),
];

/// Units of frequency and their size in hertz; longer ones first.
const FREQUENCY_UNITS: [(&str, i128); 4] =
    [("GHz", 1_000_000_000), ("MHz", 1_000_000), ("kHz", 1_000), ("Hz", 1)];

/// The length in nanoseconds that a time literal says; `None` if it is no time or too long for
/// any use, or if a part of it is no whole nanosecond.
pub fn time_ns(text: &str) -> Option<i128> {
    let text = match text.split_once('#') {
        Some((prefix, time))
            if ["T", "TIME"].iter().any(|one| one.eq_ignore_ascii_case(prefix)) =>
        {
            time
        }
        _ => text,
    };
    let mut rest = text.replace('_', "");
    let mut total: i128 = 0;
    while !rest.is_empty() {
        let number = rest.find(|c: char| !c.is_ascii_digit() && c != '.')?;
        let unit_end = rest[number..]
            .find(|c: char| c.is_ascii_digit())
            .map_or(rest.len(), |length| number + length);
        let (_, unit) = *TIME_UNITS.iter().find(|(name, _)| *name == &rest[number..unit_end])?;
        total = total.checked_add(scaled(&rest[..number], unit)?)?;
        rest.drain(..unit_end);
    }
    (!text.is_empty()).then_some(total)
}

/// The frequency in hertz that a text like `50MHz` says; `None` if it is none or no whole number.
pub fn frequency_hz(text: &str) -> Option<i128> {
    let (digits, unit) =
        FREQUENCY_UNITS.iter().find_map(|(name, size)| Some((text.strip_suffix(name)?, size)))?;
    scaled(&digits.replace('_', ""), *unit)
}

/// A decimal number times a unit, if that is a whole number.
fn scaled(number: &str, unit: i128) -> Option<i128> {
    let (whole, fraction) = number.split_once('.').unwrap_or((number, ""));
    let fraction = fraction.trim_end_matches('0');
    if whole.len() > 20 || fraction.len() > 12 {
        return None;
    }
    let parse = |digits: &str| if digits.is_empty() { Some(0) } else { digits.parse().ok() };
    let (whole, fraction_value): (i128, i128) = (parse(whole)?, parse(fraction)?);
    let scale = 10_i128.pow(fraction.len() as u32);
    let part = fraction_value.checked_mul(unit)?;
    (part % scale == 0).then(|| whole.checked_mul(unit))?.map(|whole| whole + part / scale)
}

/// A number of ticks as a time: `1500ms`, `-2m30s`. A tick has that many nanoseconds.
pub fn ticks_text(ticks: i64, tick_ns: u64) -> String {
    time_text(i128::from(ticks) * i128::from(tick_ns))
}

/// A length in nanoseconds as a person would write it, without fractions: `1ms`, `2m30s`, `1500us`,
/// `-7ns`.
pub fn time_text(ns: i128) -> String {
    if ns == 0 {
        return "0s".to_owned();
    }
    if ns < 0 {
        return format!("-{}", time_text(-ns));
    }
    if ns % 1_000_000 != 0 {
        let (name, unit) = if ns % 1_000 == 0 { ("us", 1_000) } else { ("ns", 1) };
        return format!("{}{name}", ns / unit);
    }
    if ns % 1_000_000_000 != 0 {
        return format!("{}ms", ns / 1_000_000);
    }
    let mut rest = ns;
    let mut text = String::new();
    for (name, unit) in TIME_UNITS[3..].iter().rev() {
        if rest >= *unit {
            text += &format!("{}{name}", rest / unit);
            rest %= unit;
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_sums_of_units() {
        assert_eq!(time_ns("500ms"), Some(500_000_000));
        assert_eq!(time_ns("1.3s"), Some(1_300_000_000));
        assert_eq!(time_ns("2m30s"), Some(150_000_000_000));
        assert_eq!(time_ns("T#2m_30s"), Some(150_000_000_000));
        assert_eq!(time_ns("1d2h"), Some(93_600_000_000_000));
        for text in ["t#5s", "TIME#5s", "time#5s", "Time#5s"] {
            assert_eq!(time_ns(text), Some(5_000_000_000), "{text}");
        }
        assert_eq!(time_ns("TIME#"), None);
        assert_eq!(time_ns("TIMES#5s"), None);
        assert_eq!(time_ns("T#T#5s"), None);
        assert_eq!(time_ns("0.5ns"), None);
        assert_eq!(time_ns("5"), None);
        assert_eq!(time_ns("T#"), None);
        assert_eq!(time_ns("99999999999999999999999d"), None);
        for text in ["1ms", "1500ms", "2m30s", "1h", "15us", "7ns", "1d1s"] {
            assert_eq!(time_text(time_ns(text).unwrap()), text);
            assert_eq!(time_text(-time_ns(text).unwrap()), format!("-{text}"));
        }
        assert_eq!(ticks_text(-3, 30_000_000_000), "-1m30s");
    }

    #[test]
    fn frequencies_have_units() {
        assert_eq!(frequency_hz("50MHz"), Some(50_000_000));
        assert_eq!(frequency_hz("33.333kHz"), Some(33_333));
        assert_eq!(frequency_hz("0.5Hz"), None);
        assert_eq!(frequency_hz("50"), None);
    }
}
