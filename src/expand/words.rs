//! Operations of the language on words, made of those of circuits.

use crate::circuit::{Circuit, Net};
use crate::model::{BinaryOp, Function, Relation};
use crate::types::Type;

/// A value and the type that says how its bits are read.
#[derive(Clone, Copy)]
pub(super) struct Typed {
    pub net: Net,
    pub ty: Type,
}

pub(super) fn compare(circuit: &mut Circuit, relation: Relation, a: Typed, b: Typed) -> Net {
    let signed = a.ty.is_signed();
    let (a, b) = (a.net, b.net);
    let (holds, inverted) = match relation {
        Relation::Equal => (circuit.eq(a, b), false),
        Relation::NotEqual => (circuit.eq(a, b), true),
        Relation::Less => (circuit.less(a, b, signed), false),
        Relation::GreaterOrEqual => (circuit.less(a, b, signed), true),
        Relation::Greater => (circuit.less(b, a, signed), false),
        Relation::LessOrEqual => (circuit.less(b, a, signed), true),
    };
    if inverted { circuit.not(holds) } else { holds }
}

pub(super) fn binary(circuit: &mut Circuit, op: BinaryOp, a: Typed, b: Typed) -> Net {
    match op {
        BinaryOp::Add => circuit.add(a.net, b.net),
        BinaryOp::Subtract => circuit.sub(a.net, b.net),
        BinaryOp::Multiply => {
            let factor = circuit.resize(b.net, a.ty.width(), b.ty.is_signed());
            circuit.mul(a.net, factor)
        }
        BinaryOp::Divide => quotient(circuit, a, b),
        BinaryOp::Modulo => remainder(circuit, a, b),
        BinaryOp::And => circuit.and([a.net, b.net]),
        BinaryOp::Or => circuit.or([a.net, b.net]),
        BinaryOp::Xor => circuit.xor(a.net, b.net),
    }
}

/// The sign of a number and its distance from 0, unsigned and of that width.
fn magnitude(circuit: &mut Circuit, number: Typed, width: u32) -> (Net, Net) {
    let signed = number.ty.is_signed();
    let net = circuit.resize(number.net, width, signed);
    let sign = if signed { circuit.slice(net, width - 1, 1) } else { circuit.bit(false) };
    let opposite = negated(circuit, net);
    (sign, circuit.mux(sign, opposite, net))
}

fn negated(circuit: &mut Circuit, net: Net) -> Net {
    let zero = circuit.constant(0, circuit.width(net));
    circuit.sub(zero, net)
}

/// The number of zeros of a constant power of two.
fn shift_of(circuit: &Circuit, divisor: Net) -> Option<u32> {
    let value = circuit.constant_value(divisor).filter(|value| value.is_power_of_two())?;
    Some(value.trailing_zeros())
}

/// The quotient, truncated toward zero: that of the magnitudes, with the sign that it then has.
fn quotient(circuit: &mut Circuit, a: Typed, b: Typed) -> Net {
    let width = a.ty.width();
    let (divisor_sign, divisor) = magnitude(circuit, b, width);
    if !a.ty.is_signed() {
        return circuit.div(a.net, divisor);
    }
    let (quotient, sign) = match shift_of(circuit, divisor) {
        Some(0) => (a.net, divisor_sign),
        Some(zeros) => (shifted_toward_zero(circuit, a.net, zeros), divisor_sign),
        None => {
            let (sign, dividend) = magnitude(circuit, a, width);
            (circuit.div(dividend, divisor), circuit.xor(sign, divisor_sign))
        }
    };
    let opposite = negated(circuit, quotient);
    circuit.mux(sign, opposite, quotient)
}

/// A signed number without its lowest bits. A negative one is first moved toward zero, so that
/// nothing is left to round.
fn shifted_toward_zero(circuit: &mut Circuit, number: Net, zeros: u32) -> Net {
    let width = circuit.width(number);
    let sign = circuit.slice(number, width - 1, 1);
    let ones = circuit.resize(sign, zeros, true);
    let correction = circuit.resize(ones, width, false);
    let moved = circuit.add(number, correction);
    let kept = circuit.slice(moved, zeros, width - zeros);
    circuit.resize(kept, width, true)
}

/// What a division leaves: of the magnitudes, with the sign of the dividend.
fn remainder(circuit: &mut Circuit, a: Typed, b: Typed) -> Net {
    let width = a.ty.width();
    let (_, divisor) = magnitude(circuit, b, width);
    if !a.ty.is_signed() {
        return circuit.rem(a.net, divisor);
    }
    match shift_of(circuit, divisor) {
        Some(0) => circuit.constant(0, width),
        Some(bits) => {
            // The low bits as they stand; above them ones, if the rest is negative.
            let rest = circuit.slice(a.net, 0, bits);
            let sign = circuit.slice(a.net, width - 1, 1);
            let none = circuit.constant(0, bits);
            let nothing_left = circuit.eq(rest, none);
            let something_left = circuit.not(nothing_left);
            let negative = circuit.and([sign, something_left]);
            let above = circuit.resize(negative, width - bits, true);
            circuit.concat([above, rest])
        }
        None => {
            let (sign, dividend) = magnitude(circuit, a, width);
            let rest = circuit.rem(dividend, divisor);
            let opposite = negated(circuit, rest);
            circuit.mux(sign, opposite, rest)
        }
    }
}

pub(super) fn call(circuit: &mut Circuit, function: Function, arguments: &[Typed]) -> Net {
    let first = arguments[0];
    match function {
        Function::Abs => magnitude(circuit, first, first.ty.width()).1,
        Function::Min => chosen(circuit, arguments, smaller),
        Function::Max => chosen(circuit, arguments, larger),
        Function::Limit => {
            let raised = larger(circuit, arguments[1], first);
            smaller(circuit, Typed { net: raised, ty: first.ty }, arguments[2])
        }
        Function::Select => circuit.mux(first.net, arguments[2].net, arguments[1].net),
        Function::ShiftLeft => shifted(circuit, first.net, arguments[1], Direction::Left),
        Function::ShiftRight => shifted(circuit, first.net, arguments[1], Direction::Right),
        Function::RotateLeft => moved(circuit, first.net, arguments[1].net, |circuit, word, by| {
            rotated(circuit, word, by)
        }),
        Function::RotateRight => {
            let width = first.ty.width();
            moved(circuit, first.net, arguments[1].net, |circuit, word, by| {
                rotated(circuit, word, width - by)
            })
        }
    }
}

fn chosen(
    circuit: &mut Circuit,
    values: &[Typed],
    choose: impl Fn(&mut Circuit, Typed, Typed) -> Net,
) -> Net {
    let ty = values[0].ty;
    let best = |best, &next: &Typed| Typed { net: choose(circuit, best, next), ty };
    values[1..].iter().fold(values[0], best).net
}

fn smaller(circuit: &mut Circuit, a: Typed, b: Typed) -> Net {
    let is_second = circuit.less(b.net, a.net, a.ty.is_signed());
    circuit.mux(is_second, b.net, a.net)
}

fn larger(circuit: &mut Circuit, a: Typed, b: Typed) -> Net {
    let is_second = circuit.less(a.net, b.net, a.ty.is_signed());
    circuit.mux(is_second, b.net, a.net)
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Direction {
    Left,
    Right,
}

/// A shift: nothing for a negative amount, 0 for one of the width or more.
fn shifted(circuit: &mut Circuit, word: Net, amount: Typed, direction: Direction) -> Net {
    let width = circuit.width(word);
    let inside = moved(circuit, word, amount.net, |circuit, word, by| {
        let zeros = circuit.constant(0, by);
        match direction {
            Direction::Left => {
                let kept = circuit.slice(word, 0, width - by);
                circuit.concat([kept, zeros])
            }
            Direction::Right => {
                let kept = circuit.slice(word, by, width - by);
                circuit.concat([zeros, kept])
            }
        }
    });
    let bits = amount.ty.width();
    let limit = circuit.constant(width.into(), bits);
    let is_inside = circuit.less(amount.net, limit, false);
    let none = circuit.constant(0, width);
    let result = circuit.mux(is_inside, inside, none);
    if !amount.ty.is_signed() {
        return result;
    }
    let is_negative = circuit.slice(amount.net, bits - 1, 1);
    circuit.mux(is_negative, word, result)
}

/// The word turned to the left.
fn rotated(circuit: &mut Circuit, word: Net, by: u32) -> Net {
    let width = circuit.width(word);
    let (kept, out) = (circuit.slice(word, 0, width - by), circuit.slice(word, width - by, by));
    circuit.concat([kept, out])
}

/// The word moved by an amount modulo its width, in one stage for each bit of the amount.
fn moved(
    circuit: &mut Circuit,
    word: Net,
    amount: Net,
    by: impl Fn(&mut Circuit, Net, u32) -> Net,
) -> Net {
    let stages = circuit.width(word).ilog2();
    (0..stages).fold(word, |word, stage| {
        let is_moved = circuit.slice(amount, stage, 1);
        let moved = by(circuit, word, 1 << stage);
        circuit.mux(is_moved, moved, word)
    })
}

/// A value of another type.
pub(super) fn converted(circuit: &mut Circuit, from: Typed, to: Type) -> Net {
    if to != Type::Bool {
        return circuit.resize(from.net, to.width(), from.ty.is_signed());
    }
    let zero = circuit.constant(0, from.ty.width());
    let is_zero = circuit.eq(from.net, zero);
    circuit.not(is_zero)
}

/// The element of an index, 0 if there is none.
pub(super) fn element(circuit: &mut Circuit, index: Typed, elements: &[Net]) -> Net {
    let bits = index.ty.width();
    let width = circuit.width(elements[0]);
    let mut level = elements.to_vec();
    for bit in 0.. {
        if level.len() == 1 {
            break;
        }
        let is_odd = circuit.slice(index.net, bit, 1);
        level = level
            .chunks(2)
            .map(|pair| match *pair {
                [even, odd] => circuit.mux(is_odd, odd, even),
                // Its neighbour would be out of range.
                _ => pair[0],
            })
            .collect();
    }
    // A negative index is a large one here.
    let limit = circuit.constant(elements.len() as u64, bits);
    let is_inside = circuit.less(index.net, limit, false);
    let none = circuit.constant(0, width);
    circuit.mux(is_inside, level[0], none)
}
