//! The function blocks. A block is defined in one file and one line of [`ALL`]: ports and
//! documentation, the plain step that the reference evaluator runs, the circuit that becomes
//! hardware, and timing diagrams that both must follow.

mod ab;
mod ab_counter;
mod ab_ons;
mod ab_rto;
mod ab_tof;
mod ab_ton;
mod ctd;
mod ctu;
mod ctud;
mod dc;
mod divider;
mod drum;
mod f_trig;
mod mode_timer;
mod module;
mod port;
mod r_trig;
pub mod reference;
mod rs;
mod setting;
mod shift;
mod sr;
mod tof;
mod ton;
mod tonr;
mod tp;
mod uc;
mod unit_timer;
pub mod wave;

use crate::circuit::{Circuit, Net};

pub use divider::DIVIDER;
pub use module::{CLEAR_AFTER, CLEAR_BEFORE, Key, POWER, TICK, before, key, last, module};
pub use port::{Follows, Port, PortRole, Start};
pub use setting::{Choice, Setting, Shape};

/// Constants that a time preset takes.
const TIMES: (i64, i64) = (0, i32::MAX as i64);
/// Constants that the preset of a counter takes.
const COUNTS: (i64, i64) = (0, i16::MAX as i64);
/// Constants that the preset of a two-circuit timer takes.
const UNIT_PRESETS: (i64, i64) = (1, 9999);
/// Constants that the preset of a two-circuit counter takes: its counts.
const UNIT_COUNTS: (i64, i64) = (0, 9999);
/// Smallest and largest count of an IEC counter.
const LOWEST: i64 = i16::MIN as i64;
const HIGHEST: i64 = i16::MAX as i64;

/// Every block, in the order of the block reference.
pub const ALL: &[&Block] = &[
    &ton::TON,
    &tof::TOF,
    &tp::TP,
    &tonr::TONR,
    &ctu::CTU,
    &ctd::CTD,
    &ctud::CTUD,
    &r_trig::R_TRIG,
    &f_trig::F_TRIG,
    &sr::SR,
    &rs::RS,
    &ab_ton::AB_TON,
    &ab_tof::AB_TOF,
    &ab_rto::AB_RTO,
    &ab_counter::AB_CTU,
    &ab_counter::AB_CTD,
    &ab_ons::AB_ONS,
    &unit_timer::T1_0,
    &unit_timer::T0_1,
    &unit_timer::T_01,
    &mode_timer::TS,
    &mode_timer::TT,
    &uc::UC,
    &dc::DC,
    &drum::DRUM,
    &shift::SHL,
    &shift::SHR,
];

/// The block of that kind.
pub fn named(kind: &str) -> Option<&'static Block> {
    ALL.iter().copied().find(|block| block.name == kind)
}

/// A kind of function block.
#[derive(Debug)]
pub struct Block {
    /// The kind as written in a call.
    pub name: &'static str,
    /// What it is called in words.
    pub title: &'static str,
    /// What it does, and the document that says so.
    pub doc: &'static str,
    /// Parameters that are fixed for good.
    pub settings: &'static [Setting],
    /// Parameters, outputs and hidden state, as far as settings want them.
    pub ports: &'static [Port],
    /// The output that goes on to the right; the power itself where there is none.
    pub main: Option<&'static str>,
    /// The other kind that may be called on the same instance: it has the same ports.
    pub partner: Option<&'static str>,
    /// True if `(R name)` may stand on it.
    pub can_reset: bool,
    /// For a block that keeps what it has counted until it is put back: the parameters, besides
    /// `(R name)`, that do so.
    pub keeps: fn(&Shape) -> Option<&'static [&'static str]>,
    /// One call as a PLC would do it.
    pub step: fn(&mut Step),
    /// The same as a circuit.
    pub build: fn(&mut Logic),
    /// Timing diagrams, drawn from the document; see [`wave`].
    pub waves: &'static [&'static str],
}

/// What a plain step sees and changes: parameters, outputs and hidden state as numbers.
pub struct Step<'a> {
    /// The kind and its settings.
    pub shape: &'a Shape,
    /// The power that arrives.
    pub power: bool,
    /// This scan has the tick.
    pub tick: bool,
    /// The value of each port of the block.
    pub values: &'a mut [i64],
}

impl Step<'_> {
    /// The value of a port.
    pub fn get(&self, port: &str) -> i64 {
        self.values[self.shape.expect_port(port)]
    }

    /// What a preset acts as: a value out of its range as the nearest in it.
    pub fn preset(&self, port: &str) -> i64 {
        let role = self.shape.ports[self.shape.expect_port(port)].role;
        role.within(self.get(port))
    }

    /// True if a `BOOL` port is 1.
    pub fn is_on(&self, port: &str) -> bool {
        self.get(port) != 0
    }

    /// Gives a port its new value.
    pub fn set(&mut self, port: &str, value: impl Into<i64>) {
        self.values[self.shape.expect_port(port)] = value.into();
    }
}

/// What a block's circuit is built from: the nets of its ports before the call, to be replaced by
/// those after it.
pub struct Logic<'a> {
    /// The kind and its settings.
    pub shape: &'a Shape,
    /// Where the cells go.
    pub circuit: &'a mut Circuit,
    /// The power that arrives.
    pub power: Net,
    /// This scan has the tick.
    pub tick: Net,
    nets: Vec<Option<Net>>,
}

impl Logic<'_> {
    /// The net of a port.
    pub fn get(&self, port: &str) -> Net {
        let net = self.nets[self.shape.expect_port(port)];
        net.unwrap_or_else(|| panic!("{port} is not for this call"))
    }

    /// Gives an output or a part of the hidden state its new value.
    pub fn set(&mut self, port: &str, net: Net) {
        self.nets[self.shape.expect_port(port)] = Some(net);
    }

    /// A number of the type of a port.
    pub fn constant(&mut self, port: &str, value: i64) -> Net {
        let ty = self.shape.ports[self.shape.expect_port(port)].ty;
        self.circuit.constant(ty.bits(value), ty.width())
    }

    /// What a preset acts as: 0 if it is negative, the largest constant if it is larger.
    pub fn preset(&mut self, port: &str) -> Net {
        let given = self.get(port);
        let Port { ty, role, .. } = self.shape.ports[self.shape.expect_port(port)];
        let zero = self.constant(port, 0);
        let negative = self.circuit.less(given, zero, true);
        let within = self.circuit.mux(negative, zero, given);
        match role.range() {
            Some((_, high)) if high < ty.range().1 => {
                let high = self.constant(port, high);
                let above = self.circuit.less(high, given, true);
                self.circuit.mux(above, high, within)
            }
            _ => within,
        }
    }

    /// One bit: the one-bit `now` is 1 and the one-bit port `memory` is 0.
    pub fn rise(&mut self, now: Net, memory: &str) -> Net {
        let was = self.get(memory);
        let idle = self.circuit.not(was);
        self.circuit.and([now, idle])
    }

    /// One bit: `a` is `b` or more, both signed.
    pub fn reached(&mut self, a: Net, b: Net) -> Net {
        let short = self.circuit.less(a, b, true);
        self.circuit.not(short)
    }

    /// `from` + 1 where the one-bit `count` is 1.
    pub fn count_up(&mut self, from: Net, count: Net) -> Net {
        let width = self.circuit.width(from);
        let step = self.circuit.resize(count, width, false);
        self.circuit.add(from, step)
    }

    /// `from` - 1 where the one-bit `count` is 1.
    pub fn count_down(&mut self, from: Net, count: Net) -> Net {
        let width = self.circuit.width(from);
        let step = self.circuit.resize(count, width, false);
        self.circuit.sub(from, step)
    }
}
