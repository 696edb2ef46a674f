//! The tick that is made from the clock.

use std::fmt;

/// What divides the clock down to the tick.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Prescaler {
    /// Clocks from tick to tick, at least 1: the nearest number to what is wanted.
    pub clocks: u64,
    /// How much longer than wanted the time from tick to tick is, in parts of 10^9.
    pub error_ppb: i64,
}

impl Prescaler {
    /// The nearest to that time at that clock.
    pub fn new(clock_hz: u64, tick_ns: u64) -> Self {
        const SECOND: u128 = 1_000_000_000;
        let wanted = u128::from(clock_hz) * u128::from(tick_ns);
        let clocks = ((wanted + SECOND / 2) / SECOND).clamp(1, u64::MAX.into());
        let excess = (clocks * SECOND) as f64 - wanted as f64;
        let error_ppb = (excess / wanted as f64 * 1e9).round() as i64;
        Prescaler { clocks: clocks as u64, error_ppb }
    }

    /// The error in ppm with its sign and at most three decimals.
    pub fn error_ppm(&self) -> impl fmt::Display + use<> {
        struct Ppm(i64);
        impl fmt::Display for Ppm {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                let (whole, rest) = (self.0.unsigned_abs() / 1000, self.0.unsigned_abs() % 1000);
                let sign = match self.0.signum() {
                    1 => "+",
                    -1 => "-",
                    _ => "",
                };
                write!(f, "{sign}{whole}")?;
                let decimals = format!("{rest:03}");
                match decimals.trim_end_matches('0') {
                    "" => f.write_str(" ppm"),
                    decimals => write!(f, ".{decimals} ppm"),
                }
            }
        }
        Ppm(self.error_ppb)
    }
}

/// A number with the largest unit in which it is whole.
pub struct Quantity<'a> {
    /// In the smallest unit.
    pub value: u64,
    /// From small to large, a thousand of one in the next.
    pub units: [&'a str; 4],
}

impl fmt::Display for Quantity<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (mut value, mut units) = (self.value, &self.units[..]);
        while units.len() > 1 && value > 0 && value.is_multiple_of(1000) {
            value /= 1000;
            units = &units[1..];
        }
        write!(f, "{value} {}", units[0])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn prescaler(clock_hz: u64, tick_ns: u64) -> (u64, String) {
        let prescaler = Prescaler::new(clock_hz, tick_ns);
        (prescaler.clocks, prescaler.error_ppm().to_string())
    }

    #[test]
    fn whole_numbers_of_clocks_have_no_error() {
        assert_eq!(prescaler(50_000_000, 1_000_000), (50_000, "0 ppm".to_owned()));
        assert_eq!(prescaler(1_000, 1_000_000), (1, "0 ppm".to_owned()));
    }

    #[test]
    fn the_nearest_number_of_clocks_is_taken() {
        assert_eq!(prescaler(32_768, 1_000_000), (33, "+7080.078 ppm".to_owned()));
        assert_eq!(prescaler(33_333_333, 1_000_000), (33_333, "-9.99 ppm".to_owned()));
        assert_eq!(prescaler(1_500, 1_000_000), (2, "+333333.333 ppm".to_owned()));
    }

    #[test]
    fn a_clock_that_is_too_slow_ticks_at_every_clock() {
        assert_eq!(prescaler(100, 1_000_000), (1, "+9000000 ppm".to_owned()));
    }

    #[test]
    fn extreme_values_do_not_overflow() {
        assert_eq!(Prescaler::new(u64::MAX, u64::MAX).clocks, u64::MAX);
        assert_eq!(Prescaler::new(0, 0).clocks, 1);
    }

    #[test]
    fn quantities_have_the_largest_whole_unit() {
        let hertz = |value| Quantity { value, units: ["Hz", "kHz", "MHz", "GHz"] }.to_string();
        assert_eq!(hertz(12_000_000), "12 MHz");
        assert_eq!(hertz(32_768), "32768 Hz");
        assert_eq!(hertz(7_000_000_000_000), "7000 GHz");
        assert_eq!(hertz(0), "0 Hz");
    }
}
