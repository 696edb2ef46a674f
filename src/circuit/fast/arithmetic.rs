//! Numbers bit by bit, lowest first, as one calculates on paper.

use super::assembler::{Assembler, Bit, OFF};

pub(super) fn add(to: &mut Assembler, a: &[Bit], b: &[Bit]) -> Vec<Bit> {
    let mut carry = OFF;
    let mut sum = Vec::with_capacity(a.len());
    for (&a, &b) in a.iter().zip(b) {
        let differ = to.xor(a, b);
        sum.push(to.xor(differ, carry));
        carry = to.mux(differ, carry, a);
    }
    sum
}

/// The difference, and whether `a` is less than `b`, both unsigned.
pub(super) fn subtract(to: &mut Assembler, a: &[Bit], b: &[Bit]) -> (Vec<Bit>, Bit) {
    let mut borrow = OFF;
    let mut difference = Vec::with_capacity(a.len());
    for (&a, &b) in a.iter().zip(b) {
        let differ = to.xor(a, b);
        difference.push(to.xor(differ, borrow));
        borrow = to.mux(differ, b, borrow);
    }
    (difference, borrow)
}

/// Whether `a` is less than `b`. With their top bits inverted, numbers with a sign are in the
/// order of those without.
pub(super) fn less(to: &mut Assembler, a: &[Bit], b: &[Bit], signed: bool) -> Bit {
    let ordered = |bits: &[Bit]| {
        let mut bits = bits.to_vec();
        if let (true, Some(top)) = (signed, bits.last_mut()) {
            *top = top.not();
        }
        bits
    };
    subtract(to, &ordered(a), &ordered(b)).1
}

pub(super) fn multiply(to: &mut Assembler, a: &[Bit], b: &[Bit]) -> Vec<Bit> {
    let mut product = vec![OFF; a.len()];
    for (low, &factor) in b.iter().enumerate() {
        let part: Vec<Bit> =
            a[..a.len() - low].iter().map(|&bit| to.all([bit, factor].into_iter())).collect();
        let high = add(to, &product[low..], &part);
        product.splice(low.., high);
    }
    product
}

/// Quotient and rest of unsigned numbers; both 0 where `b` is 0.
pub(super) fn divide(to: &mut Assembler, a: &[Bit], b: &[Bit]) -> (Vec<Bit>, Vec<Bit>) {
    let is_number = to.any(b.iter().copied());
    // One bit more than `b` has, for what is brought down.
    let divisor: Vec<Bit> = b.iter().copied().chain([OFF]).collect();
    let mut rest = vec![OFF; b.len()];
    let mut quotient = vec![OFF; a.len()];
    for (place, &next) in a.iter().enumerate().rev() {
        let wide: Vec<Bit> = [next].into_iter().chain(rest).collect();
        let (difference, is_less) = subtract(to, &wide, &divisor);
        quotient[place] = to.all([is_less.not(), is_number].into_iter());
        let kept = wide.iter().zip(&difference).take(b.len());
        rest = kept.map(|(&as_it_was, &less)| to.mux(is_less, as_it_was, less)).collect();
    }
    let rest = rest.into_iter().map(|bit| to.all([bit, is_number].into_iter())).collect();
    (quotient, rest)
}
