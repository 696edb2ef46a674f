//! Sets of words, as intervals.

use crate::circuit::mask;

/// The words of `width` bits that some number from `low` to `high` has as its lowest bits.
///
/// A number and the same number plus 2^width are one word, so an interval serves signed and
/// unsigned words alike. `low` is a number of `width` bits in two's complement, and there are 1 to
/// 2^width numbers in the interval.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Interval {
    low: i128,
    high: i128,
    width: u32,
}

impl Interval {
    /// Every word of that width.
    pub fn full(width: u32) -> Self {
        let half = 1 << (width - 1);
        Interval { low: -half, high: half - 1, width }
    }

    /// These bits alone.
    pub fn bits(bits: u64, width: u32) -> Self {
        Interval::new(i128::from(bits), i128::from(bits), width)
    }

    /// The numbers from `low` to `high`, wrapped.
    pub fn new(low: i128, high: i128, width: u32) -> Self {
        let modulus: i128 = 1 << width;
        if high - low >= modulus - 1 {
            return Interval::full(width);
        }
        let half = modulus / 2;
        // The lowest bits of a number are what is left of it modulo a power of two.
        let shift = ((low + half) & (modulus - 1)) - half - low;
        Interval { low: low + shift, high: high + shift, width }
    }

    /// The smallest and the largest of them, read as unsigned numbers.
    pub fn unsigned(self) -> (u64, u64) {
        let modulus = 1 << self.width;
        let shift = if self.low < 0 { modulus } else { 0 };
        match self.high + shift < modulus {
            true => ((self.low + shift) as u64, (self.high + shift) as u64),
            false => (0, mask(self.width)),
        }
    }

    /// The smallest and the largest of them, read as numbers in two's complement.
    pub fn signed(self) -> (i64, i64) {
        let half: i128 = 1 << (self.width - 1);
        let (low, high) = if self.high < half { (self.low, self.high) } else { (-half, half - 1) };
        (low as i64, high as i64)
    }

    /// The smallest and the largest of them.
    pub fn bounds(self, signed: bool) -> (i128, i128) {
        match signed {
            true => (self.signed().0.into(), self.signed().1.into()),
            false => (self.unsigned().0.into(), self.unsigned().1.into()),
        }
    }

    /// The only word of the interval.
    pub fn single(self) -> Option<u64> {
        (self.low == self.high).then_some(self.low as u64 & mask(self.width))
    }

    /// How many bits hold every word when zeros are put before them.
    pub fn unsigned_width(self) -> u32 {
        (64 - self.unsigned().1.leading_zeros()).max(1)
    }

    /// How many bits hold every word when copies of the top bit are put before them.
    pub fn signed_width(self) -> u32 {
        let bits = |number: i64| 65 - (if number < 0 { !number } else { number }).leading_zeros();
        bits(self.signed().0).max(bits(self.signed().1))
    }

    /// True if every word of the other one is in this one.
    pub fn contains(self, other: Interval) -> bool {
        self.shifts(other).any(|(low, high)| self.low <= low && high <= self.high)
            || self == Interval::full(self.width)
    }

    /// The smallest interval that holds both.
    pub fn join(self, other: Interval) -> Interval {
        let hulls = self.shifts(other).map(|(low, high)| (self.low.min(low), self.high.max(high)));
        let (low, high) = hulls.min_by_key(|(low, high)| high - low).expect("there are three");
        Interval::new(low, high, self.width)
    }

    /// An interval that holds what is in both; nothing if that is no word.
    pub fn meet(self, other: Interval) -> Option<Interval> {
        let overlaps =
            self.shifts(other).map(|(low, high)| (self.low.max(low), self.high.min(high)));
        let mut overlaps = overlaps.filter(|(low, high)| low <= high);
        let (low, high) = overlaps.next()?;
        match overlaps.next() {
            None => Some(Interval::new(low, high, self.width)),
            // Two pieces are no interval.
            Some(_) if self.high - self.low <= other.high - other.low => Some(self),
            Some(_) => Some(other),
        }
    }

    /// The words of `self` moved by a word of `other`.
    pub fn add(self, other: Interval) -> Interval {
        Interval::new(self.low + other.low, self.high + other.high, self.width)
    }

    /// The words of `self` moved back by a word of `other`.
    pub fn sub(self, other: Interval) -> Interval {
        Interval::new(self.low - other.high, self.high - other.low, self.width)
    }

    /// The products of a word of `self` and one of `other`.
    pub fn mul(self, other: Interval) -> Interval {
        let ((low, high), (least, most)) = (self.unsigned(), other.unsigned());
        match high.checked_mul(most) {
            // The low ends are smaller still.
            Some(largest) => Interval::new((low * least).into(), largest.into(), self.width),
            None => Interval::full(self.width),
        }
    }

    /// The quotients of a word of `self` by one of `other`, both unsigned; 0 for a quotient by 0.
    pub fn div(self, other: Interval) -> Interval {
        let ((low, high), (least, most)) = (self.unsigned(), other.unsigned());
        let smallest = if least == 0 { 0 } else { low / most };
        Interval::new(smallest.into(), (high / least.max(1)).into(), self.width)
    }

    /// What those divisions leave; 0 for one by 0.
    pub fn rem(self, other: Interval) -> Interval {
        let largest = self.unsigned().1.min(other.unsigned().1.saturating_sub(1));
        Interval::new(0, largest.into(), self.width)
    }

    /// Every bit inverted.
    pub fn not(self) -> Interval {
        Interval::new(-1 - self.high, -1 - self.low, self.width)
    }

    /// The words with zeros or copies of the top bit before them.
    pub fn extend(self, width: u32, signed: bool) -> Interval {
        let (low, high) = self.bounds(signed);
        Interval::new(low, high, width)
    }

    /// Bits `low` and up.
    pub fn slice(self, low: u32, width: u32) -> Interval {
        if low == 0 {
            return Interval::new(self.low, self.high, width);
        }
        let (smallest, largest) = self.unsigned();
        Interval::new((smallest >> low).into(), (largest >> low).into(), width)
    }

    /// An interval that holds `self` and reaches up or down to the next of some marks, where
    /// `next` goes beyond it, or as far as it goes.
    pub fn widen(self, next: Interval, marks: &[i128]) -> Interval {
        let joined = self.join(next);
        let shift = joined.low - self.low;
        let grew_down = shift != 0;
        let grew_up = joined.high != self.high;
        let low = match grew_down {
            false => Some(joined.low),
            true => marks.iter().copied().filter(|&mark| mark <= joined.low).max(),
        };
        let high = match grew_up {
            false => Some(joined.high),
            true => marks.iter().copied().filter(|&mark| mark >= joined.high).min(),
        };
        match (low, high) {
            (Some(low), Some(high)) => Interval::new(low, high, self.width),
            _ => Interval::full(self.width),
        }
    }

    /// The three ways to see the other interval next to this one.
    fn shifts(self, other: Interval) -> impl Iterator<Item = (i128, i128)> {
        let modulus = 1 << self.width;
        [0, modulus, -modulus].into_iter().map(move |shift| (other.low + shift, other.high + shift))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const WIDTH: u32 = 4;

    fn words(interval: Interval) -> Vec<u64> {
        (interval.low..=interval.high).map(|number| number as u64 & mask(WIDTH)).collect()
    }

    fn all() -> Vec<Interval> {
        let from = |low: i128| (0..16).map(move |more| Interval::new(low, low + more, WIDTH));
        (-8..8).flat_map(from).collect()
    }

    #[test]
    fn bounds_hold_every_word() {
        for interval in all() {
            let (low, high) = interval.unsigned();
            let (lowest, highest) = interval.signed();
            for word in words(interval) {
                let number = crate::circuit::as_signed(word, WIDTH);
                assert!((low..=high).contains(&word), "{interval:?}");
                assert!((lowest..=highest).contains(&number), "{interval:?}");
                assert!(word <= mask(interval.unsigned_width()), "{interval:?}");
                let kept = word & mask(interval.signed_width().min(WIDTH));
                let back = crate::circuit::as_signed(kept, interval.signed_width().min(WIDTH));
                assert_eq!(back, number, "{interval:?}");
            }
        }
    }

    #[test]
    fn two_intervals_give_what_their_words_give() {
        for a in all() {
            for b in all() {
                let (joined, met) = (words(a.join(b)), a.meet(b).map(words).unwrap_or_default());
                let (sum, difference) = (words(a.add(b)), words(a.sub(b)));
                let marked = words(a.widen(b, &[-8, -1, 0, 3, 7]));
                let (in_a, in_b) = (words(a), words(b));
                assert_eq!(
                    a.contains(b),
                    in_b.iter().all(|word| in_a.contains(word)),
                    "{a:?} {b:?}"
                );
                for x in &in_a {
                    assert!(joined.contains(x) && marked.contains(x), "{a:?} {b:?}");
                    assert!(!in_b.contains(x) || met.contains(x), "{a:?} {b:?}");
                    for y in &in_b {
                        assert!(joined.contains(y) && marked.contains(y), "{a:?} {b:?}");
                        assert!(sum.contains(&(x.wrapping_add(*y) & mask(WIDTH))), "{a:?} {b:?}");
                        let less = x.wrapping_sub(*y) & mask(WIDTH);
                        assert!(difference.contains(&less), "{a:?} {b:?}");
                    }
                }
            }
        }
    }

    #[test]
    fn one_interval_gives_what_its_words_give() {
        for interval in all() {
            let (inverted, wide) = (interval.not(), interval.extend(6, false));
            let (signed, cut) = (interval.extend(6, true), interval.slice(1, 3));
            let within = |outer: Interval, bits: u64, width| {
                assert!(outer.contains(Interval::bits(bits & mask(width), width)), "{interval:?}");
            };
            for word in words(interval) {
                within(inverted, !word, 4);
                within(wide, word, 6);
                within(signed, crate::circuit::as_signed(word, WIDTH) as u64, 6);
                within(cut, word >> 1, 3);
                within(interval.slice(0, 2), word, 2);
            }
        }
    }
}
