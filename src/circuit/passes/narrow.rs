//! Makes every word as wide as the largest number that it can be, and comparisons as simple as the
//! numbers that they compare allow.
//!
//! Before: any circuit. After: the same outputs in every scan; a register that counts to 50 has six
//! bits, `n >= 50` is `n = 50`, and what can be one word only is a constant. Whoever reads a
//! narrower word puts zeros, or copies of its sign, before it.

use super::rebuild::{Rebuild, rebuild};
use crate::circuit::ranges::{Interval, Ranges};
use crate::circuit::{Cell, Circuit, Net, Op, RegisterId};

/// The circuit with narrower words.
pub fn narrow(circuit: &Circuit) -> Option<Circuit> {
    let ranges = Ranges::of(circuit);
    if ranges.is_empty() {
        return None;
    }
    let narrowed = rebuild(circuit, |rebuild, net, cell| {
        let interval = ranges.interval(circuit, net);
        if let Some(bits) = interval.single() {
            return match cell.op {
                // Inputs keep their places.
                Op::Input(_) => rebuild.copy(cell),
                _ => rebuild.to.constant(bits, cell.width),
            };
        }
        let fit = Fit::of(interval);
        match cell.op {
            Op::Register(id) => register(rebuild, id, cell, fit),
            Op::Eq(a, b) => equal(rebuild, &ranges, a, b),
            Op::Less { a, b, signed } => less(rebuild, &ranges, a, b, signed),
            Op::Not(_)
            | Op::And(_)
            | Op::Or(_)
            | Op::Xor(..)
            | Op::Mux { .. }
            | Op::Add(..)
            | Op::Sub(..)
            | Op::Mul(..)
                if fit.width < cell.width =>
            {
                computed(rebuild, cell, fit)
            }
            Op::Div(a, b) => divided(rebuild, &ranges, [a, b], cell, Circuit::div),
            Op::Rem(a, b) => divided(rebuild, &ranges, [a, b], cell, Circuit::rem),
            Op::Input(_)
            | Op::Port(..)
            | Op::Const(_)
            | Op::Not(_)
            | Op::And(_)
            | Op::Or(_)
            | Op::Xor(..)
            | Op::Mux { .. }
            | Op::Add(..)
            | Op::Sub(..)
            | Op::Mul(..)
            | Op::Extend { .. }
            | Op::Slice { .. }
            | Op::Concat(_) => rebuild.copy(cell),
        }
    });
    Some(narrowed)
}

/// The fewest bits that hold a word, and what goes before them.
#[derive(Clone, Copy)]
struct Fit {
    width: u32,
    signed: bool,
}

impl Fit {
    fn of(interval: Interval) -> Self {
        let (unsigned, signed) = (interval.unsigned_width(), interval.signed_width());
        match signed < unsigned {
            true => Fit { width: signed, signed: true },
            false => Fit { width: unsigned, signed: false },
        }
    }
}

fn register(rebuild: &mut Rebuild<'_>, id: RegisterId, cell: Cell, fit: Fit) -> Net {
    let width = fit.width.min(cell.width);
    let net = rebuild.register(id, width);
    rebuild.to.resize(net, cell.width, fit.signed)
}

/// The lowest bits of the result need the lowest bits of the operands only.
fn computed(rebuild: &mut Rebuild<'_>, cell: Cell, fit: Fit) -> Net {
    let cut = |rebuild: &mut Rebuild<'_>, net: Net| {
        let copy = rebuild.net(net);
        rebuild.to.slice(copy, 0, fit.width)
    };
    let list = |rebuild: &mut Rebuild<'_>, operands| -> Vec<Net> {
        let from = rebuild.from;
        from.list(operands).iter().map(|&net| cut(rebuild, net)).collect()
    };
    let narrow = match cell.op {
        Op::Not(from) => {
            let from = cut(rebuild, from);
            rebuild.to.not(from)
        }
        Op::And(operands) => {
            let operands = list(rebuild, operands);
            rebuild.to.and(operands)
        }
        Op::Or(operands) => {
            let operands = list(rebuild, operands);
            rebuild.to.or(operands)
        }
        Op::Xor(a, b) => {
            let (a, b) = (cut(rebuild, a), cut(rebuild, b));
            rebuild.to.xor(a, b)
        }
        Op::Mux { select, on, off } => {
            let (select, on, off) = (rebuild.net(select), cut(rebuild, on), cut(rebuild, off));
            rebuild.to.mux(select, on, off)
        }
        Op::Add(a, b) => {
            let (a, b) = (cut(rebuild, a), cut(rebuild, b));
            rebuild.to.add(a, b)
        }
        Op::Sub(a, b) => {
            let (a, b) = (cut(rebuild, a), cut(rebuild, b));
            rebuild.to.sub(a, b)
        }
        Op::Mul(a, b) => {
            let (a, b) = (cut(rebuild, a), cut(rebuild, b));
            rebuild.to.mul(a, b)
        }
        Op::Input(_)
        | Op::Register(_)
        | Op::Port(..)
        | Op::Const(_)
        | Op::Div(..)
        | Op::Rem(..)
        | Op::Eq(..)
        | Op::Less { .. }
        | Op::Extend { .. }
        | Op::Slice { .. }
        | Op::Concat(_) => return rebuild.copy(cell),
    };
    rebuild.to.resize(narrow, cell.width, fit.signed)
}

/// A quotient or what is left needs as many bits as the larger of both operands can have.
fn divided(
    rebuild: &mut Rebuild<'_>,
    ranges: &Ranges,
    nets: [Net; 2],
    cell: Cell,
    by: fn(&mut Circuit, Net, Net) -> Net,
) -> Net {
    let widths = nets.map(|net| ranges.interval(rebuild.from, net).unsigned_width());
    let [a, b] = operands(rebuild, nets, widths[0].max(widths[1]));
    let narrow = by(&mut rebuild.to, a, b);
    rebuild.to.resize(narrow, cell.width, false)
}

/// Both words cut to the bits that tell them apart.
fn operands(rebuild: &mut Rebuild<'_>, nets: [Net; 2], width: u32) -> [Net; 2] {
    nets.map(|net| {
        let copy = rebuild.net(net);
        let width = width.min(rebuild.to.width(copy));
        rebuild.to.slice(copy, 0, width)
    })
}

fn equal(rebuild: &mut Rebuild<'_>, ranges: &Ranges, a: Net, b: Net) -> Net {
    let intervals = [a, b].map(|net| ranges.interval(rebuild.from, net));
    let both = intervals[0].join(intervals[1]);
    let [a, b] = operands(rebuild, [a, b], Fit::of(both).width);
    Circuit::eq(&mut rebuild.to, a, b)
}

fn less(rebuild: &mut Rebuild<'_>, ranges: &Ranges, a: Net, b: Net, signed: bool) -> Net {
    let [x, y] = [a, b].map(|net| ranges.interval(rebuild.from, net).bounds(signed));
    // Where one side is a constant at an end of what the other can be, `=` says the same.
    if x.0 == x.1 && (y.1 == x.0 + 1 || y.0 == x.0) {
        let last = y.1 == x.0 + 1;
        return is_number(rebuild, ranges, b, if last { y.1 } else { y.0 }, last);
    }
    if y.0 == y.1 && (x.0 == y.0 - 1 || x.1 == y.0) {
        let first = x.0 == y.0 - 1;
        return is_number(rebuild, ranges, a, if first { x.0 } else { x.1 }, first);
    }
    let width = |signed: bool| {
        let width = |net: Net| {
            let interval = ranges.interval(rebuild.from, net);
            if signed { interval.signed_width() } else { interval.unsigned_width() }
        };
        width(a).max(width(b))
    };
    // Numbers without a sign are in one order either way.
    let signed = signed && (x.0 < 0 || y.0 < 0);
    let [a, b] = operands(rebuild, [a, b], width(signed));
    rebuild.to.less(a, b, signed)
}

/// `net` = `number`, or, if not `equal`, `net` <> `number`.
fn is_number(
    rebuild: &mut Rebuild<'_>,
    ranges: &Ranges,
    net: Net,
    number: i128,
    equal: bool,
) -> Net {
    let width = Fit::of(ranges.interval(rebuild.from, net)).width;
    let [a, _] = operands(rebuild, [net, net], width);
    let width = rebuild.to.width(a);
    let number = rebuild.to.constant(number as u64, width);
    let holds = Circuit::eq(&mut rebuild.to, a, number);
    if equal { holds } else { rebuild.to.not(holds) }
}
