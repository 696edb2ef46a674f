//! What a net can be where some conditions are known to hold.

use std::collections::HashMap;

use super::Interval;
use crate::circuit::{Cell, Circuit, Net, Op};

/// How many cells one question looks at. Behind them the interval stands that holds without any
/// condition, so that the time does not grow with the circuit.
const BUDGET: u32 = 200;
/// How many operands of a list are looked at; the others may be any word.
const OPERANDS: usize = 64;

/// Something that holds and of which it is open why.
#[derive(Clone, Copy)]
enum Undecided<'a> {
    /// Some operand is 0 (if true) or 1.
    List(&'a [Net], bool),
    /// One bit or the other, as the first decides, is that value.
    Choice([Net; 3], bool),
}

/// Conditions that hold, and what follows from them.
pub struct Assumptions<'a> {
    circuit: &'a Circuit,
    /// What holds without conditions; a net that is missing can be any word.
    always: &'a HashMap<Net, Interval>,
    /// What is known of nets, the newest last.
    known: Vec<(Net, Interval)>,
    /// What follows as soon as more is known, the newest last.
    undecided: Vec<Undecided<'a>>,
    budget: u32,
}

impl<'a> Assumptions<'a> {
    /// None yet.
    pub fn new(circuit: &'a Circuit, always: &'a HashMap<Net, Interval>) -> Self {
        Assumptions { circuit, always, known: Vec::new(), undecided: Vec::new(), budget: BUDGET }
    }

    /// What a net can be.
    pub fn interval(&mut self, net: Net) -> Interval {
        let found = self.found(net);
        let is_settled = self.known.is_empty() && self.always.contains_key(&net);
        if is_settled || found.single().is_some() || self.budget == 0 {
            return found;
        }
        self.budget -= 1;
        // Where the two contradict each other, the net is never looked at.
        self.computed(net).and_then(|computed| computed.meet(found)).unwrap_or(found)
    }

    /// The bit that a net is in every case that is left.
    pub fn bit(&mut self, net: Net) -> Option<bool> {
        self.interval(net).single().map(|bit| bit != 0)
    }

    /// From now on the one-bit net is that value. False if it cannot be.
    pub fn assume(&mut self, bit: Net, value: bool) -> bool {
        // What is known now may decide what was left open before.
        let open = self.undecided.clone();
        self.follow(bit, value) && open.into_iter().all(|open| self.decide(open))
    }

    /// Learns what follows from a bit alone.
    fn follow(&mut self, bit: Net, value: bool) -> bool {
        if self.budget == 0 {
            return true;
        }
        self.budget -= 1;
        if !self.learn(bit, Interval::bits(u64::from(value), 1)) {
            return false;
        }
        let circuit = self.circuit;
        match circuit.cell(bit).op {
            Op::Not(from) => self.follow(from, !value),
            Op::And(list) => self.assume_list(circuit.list(list), value, true),
            Op::Or(list) => self.assume_list(circuit.list(list), value, false),
            Op::Eq(a, b) => self.assume_equal(a, b, value),
            Op::Less { a, b, signed } if value => self.assume_order(a, b, signed, 1),
            Op::Less { a, b, signed } => self.assume_order(b, a, signed, 0),
            Op::Mux { select, on, off } => {
                let open = Undecided::Choice([select, on, off], value);
                self.undecided.push(open);
                self.decide(open)
            }
            Op::Input(_)
            | Op::Register(_)
            | Op::Port(..)
            | Op::Const(_)
            | Op::Xor(..)
            | Op::Add(..)
            | Op::Sub(..)
            | Op::Mul(..)
            | Op::Div(..)
            | Op::Rem(..)
            | Op::Extend { .. }
            | Op::Slice { .. }
            | Op::Concat(_) => true,
        }
    }

    /// Runs `then` as if a condition held, and forgets it again. Nothing if it cannot hold.
    pub fn under<T>(
        &mut self,
        bit: Net,
        value: bool,
        then: impl FnOnce(&mut Self) -> T,
    ) -> Option<T> {
        let (known, undecided) = (self.known.len(), self.undecided.len());
        let result = if self.assume(bit, value) { Some(then(self)) } else { None };
        self.known.truncate(known);
        self.undecided.truncate(undecided);
        result
    }

    /// Runs `then` as if a net were that word, and forgets it again. Nothing if it cannot be.
    pub fn where_is<T>(
        &mut self,
        net: Net,
        bits: u64,
        then: impl FnOnce(&mut Self) -> T,
    ) -> Option<T> {
        self.where_in(net, Interval::bits(bits, self.circuit.width(net)), then)
    }

    /// Runs `then` as if a net were in an interval, and forgets it again. Nothing if it cannot be.
    pub fn where_in<T>(
        &mut self,
        net: Net,
        interval: Interval,
        then: impl FnOnce(&mut Self) -> T,
    ) -> Option<T> {
        let known = self.known.len();
        let result = if self.learn(net, interval) { Some(then(self)) } else { None };
        self.known.truncate(known);
        result
    }

    fn found(&self, net: Net) -> Interval {
        let known = self.known.iter().rev().find(|(other, _)| *other == net);
        let always = || self.always.get(&net).copied();
        let constant = || {
            let Cell { op, width } = self.circuit.cell(net);
            match op {
                Op::Const(bits) => Interval::bits(bits, width),
                Op::Not(from) => self.found(from).not(),
                _ => Interval::full(width),
            }
        };
        known.map(|(_, interval)| *interval).or_else(always).unwrap_or_else(constant)
    }

    fn learn(&mut self, net: Net, interval: Interval) -> bool {
        let Some(met) = self.found(net).meet(interval) else { return false };
        self.known.push((net, met));
        true
    }

    /// `all`: the list is an `And`, else an `Or`.
    fn assume_list(&mut self, list: &'a [Net], value: bool, all: bool) -> bool {
        if value == all {
            return list.iter().take(OPERANDS).all(|&operand| self.follow(operand, value));
        }
        if list.len() > OPERANDS {
            return true;
        }
        let open = Undecided::List(list, all);
        self.undecided.push(open);
        self.decide(open)
    }

    fn decide(&mut self, open: Undecided<'a>) -> bool {
        match open {
            Undecided::List(list, all) => self.decide_list(list, all),
            Undecided::Choice(nets, value) => self.decide_choice(nets, value),
        }
    }

    /// What is chosen is that value; what cannot be it is not chosen.
    fn decide_choice(&mut self, [select, on, off]: [Net; 3], value: bool) -> bool {
        let bit = |net: Net| self.found(net).single().map(|bit| bit != 0);
        let can_be = |net: Net| bit(net) != Some(!value);
        match (bit(select), can_be(on), can_be(off)) {
            (Some(true), true, _) => self.follow(on, value),
            (Some(false), _, true) => self.follow(off, value),
            (None, true, false) => self.follow(select, true) && self.follow(on, value),
            (None, false, true) => self.follow(select, false) && self.follow(off, value),
            (None, true, true) => true,
            _ => false,
        }
    }

    /// One operand at least is not `all`: if only one can be, it is.
    fn decide_list(&mut self, list: &[Net], all: bool) -> bool {
        let mut open = list
            .iter()
            .filter(|&&operand| self.found(operand).single().is_none_or(|bit| (bit != 0) != all));
        match (open.next().copied(), open.next()) {
            (None, _) => false,
            (Some(only), None) => self.follow(only, !all),
            (Some(_), Some(_)) => true,
        }
    }

    fn assume_equal(&mut self, a: Net, b: Net, equal: bool) -> bool {
        let (x, y) = (self.found(a), self.found(b));
        if equal {
            return x.meet(y).is_some_and(|both| self.learn(a, both) && self.learn(b, both));
        }
        match y.single() {
            Some(bits) => self.learn_other_than(a, bits),
            None => true,
        }
    }

    fn learn_other_than(&mut self, net: Net, bits: u64) -> bool {
        let interval = self.found(net);
        let width = self.circuit.width(net);
        let without = |signed| {
            let (low, high) = interval.bounds(signed);
            let number = Interval::bits(bits, width).bounds(signed).0;
            let (low, high) = (low + i128::from(low == number), high - i128::from(high == number));
            (low <= high).then(|| Interval::new(low, high, width))
        };
        match (without(true), without(false)) {
            (Some(signed), Some(unsigned)) => self.learn(net, signed) && self.learn(net, unsigned),
            _ => false,
        }
    }

    /// `a` + `least` <= `b`.
    fn assume_order(&mut self, a: Net, b: Net, signed: bool, least: i128) -> bool {
        let (low, _) = self.found(a).bounds(signed);
        let (_, high) = self.found(b).bounds(signed);
        let width = self.circuit.width(a);
        if low + least > high {
            return false;
        }
        let (lowest, highest) = Interval::full(width).bounds(signed);
        self.learn(a, Interval::new(lowest, high - least, width))
            && self.learn(b, Interval::new(low + least, highest, width))
    }

    /// What a cell makes of what its operands can be; nothing if no case is left.
    fn computed(&mut self, net: Net) -> Option<Interval> {
        let cell = self.circuit.cell(net);
        let width = cell.width;
        let bit = |value: bool| Interval::bits(u64::from(value), 1);
        Some(match cell.op {
            Op::Input(_) | Op::Register(_) | Op::Port(..) | Op::Const(_) => self.found(net),
            Op::Not(from) => self.interval(from).not(),
            Op::And(list) => self.all_of(self.circuit.list(list), width),
            Op::Or(list) => self.any_of(self.circuit.list(list), width),
            Op::Xor(a, b) => {
                let high = self.interval(a).unsigned().1 | self.interval(b).unsigned().1;
                Interval::new(0, super::filled(high).into(), width)
            }
            Op::Mux { select, on, off } => {
                let chosen = |chosen: Net| {
                    move |under: &mut Self| {
                        let interval = under.interval(chosen);
                        // The condition may have told something of the choice itself.
                        interval.meet(under.found(net)).unwrap_or(interval)
                    }
                };
                self.either(select, chosen(on), chosen(off))?
            }
            Op::Add(a, b) => self.moved(a, b, Interval::add)?,
            Op::Sub(a, b) => self.moved(a, b, Interval::sub)?,
            Op::Eq(a, b) => {
                let (x, y) = (self.interval(a), self.interval(b));
                match (x.meet(y), x.single(), y.single()) {
                    (None, ..) => bit(false),
                    (_, Some(x), Some(y)) => bit(x == y),
                    _ => Interval::full(1),
                }
            }
            Op::Less { a, b, signed } => {
                let (x, y) = (self.interval(a).bounds(signed), self.interval(b).bounds(signed));
                match (x.1 < y.0, x.0 >= y.1) {
                    (true, _) => bit(true),
                    (_, true) => bit(false),
                    _ => Interval::full(1),
                }
            }
            Op::Extend { from, signed } => self.interval(from).extend(width, signed),
            Op::Slice { from, low } => self.interval(from).slice(low, width),
            Op::Mul(a, b) => self.interval(a).mul(self.interval(b)),
            Op::Div(a, b) => self.interval(a).div(self.interval(b)),
            Op::Rem(a, b) => self.interval(a).rem(self.interval(b)),
            Op::Concat(list) => self.side_by_side(self.circuit.list(list), width),
        })
    }

    fn all_of(&mut self, list: &[Net], width: u32) -> Interval {
        let (mut highest, mut lowest) = (super::mask(width), super::mask(width));
        for &operand in list.iter().take(OPERANDS) {
            let (low, high) = self.interval(operand).unsigned();
            highest = highest.min(high);
            lowest = if width == 1 { lowest & low } else { 0 };
        }
        if list.len() > OPERANDS {
            lowest = 0;
        }
        Interval::new(lowest.into(), highest.into(), width)
    }

    fn any_of(&mut self, list: &[Net], width: u32) -> Interval {
        let (mut lowest, mut bits) = (0, 0);
        for &operand in list.iter().take(OPERANDS) {
            let (low, high) = self.interval(operand).unsigned();
            lowest = lowest.max(low);
            bits |= super::filled(high);
        }
        if list.len() > OPERANDS {
            bits = super::mask(width);
        }
        Interval::new(lowest.into(), bits.into(), width)
    }

    fn side_by_side(&mut self, list: &[Net], width: u32) -> Interval {
        let (mut lowest, mut highest) = (0, 0);
        for &operand in list {
            let (low, high) = self.interval(operand).unsigned();
            let part = self.circuit.width(operand);
            lowest = lowest << part | i128::from(low);
            highest = highest << part | i128::from(high);
        }
        Interval::new(lowest, highest, width)
    }

    fn either(
        &mut self,
        select: Net,
        on: impl FnOnce(&mut Self) -> Interval,
        off: impl FnOnce(&mut Self) -> Interval,
    ) -> Option<Interval> {
        let (on, off) = (self.under(select, true, on), self.under(select, false, off));
        match (on, off) {
            (Some(on), Some(off)) => Some(on.join(off)),
            (on, off) => on.or(off),
        }
    }

    /// A sum or a difference. What is counted depends on the condition under which it is counted.
    fn moved(
        &mut self,
        a: Net,
        b: Net,
        by: fn(Interval, Interval) -> Interval,
    ) -> Option<Interval> {
        if self.budget == 0 {
            return Some(by(self.found(a), self.found(b)));
        }
        self.budget -= 1;
        for (choice, other) in [(b, a), (a, b)] {
            let in_order =
                |chosen, other| if choice == b { by(other, chosen) } else { by(chosen, other) };
            match self.circuit.cell(choice).op {
                Op::Extend { from, signed: false } if self.circuit.width(from) == 1 => {
                    let width = self.circuit.width(choice);
                    let with = |bit: u64| {
                        move |under: &mut Self| {
                            in_order(Interval::bits(bit, width), under.interval(other))
                        }
                    };
                    return self.either(from, with(1), with(0));
                }
                Op::Mux { select, on, off } => {
                    let with = |chosen: Net| {
                        move |under: &mut Self| {
                            let (a, b) = if choice == b { (a, chosen) } else { (chosen, b) };
                            under.moved(a, b, by).unwrap_or(Interval::full(under.circuit.width(a)))
                        }
                    };
                    return self.either(select, with(on), with(off));
                }
                _ => {}
            }
        }
        let (a, b) = (self.interval(a), self.interval(b));
        Some(by(a, b))
    }
}
