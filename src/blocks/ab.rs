//! What the blocks of Allen-Bradley have in common: numbers that any rung may assign, of the size
//! of the SLC or of Logix, and time bases with a fraction of their own.

use super::{COUNTS, Choice, Logic, Port, Setting, Step};
use crate::circuit::Net;
use crate::types::Type;

/// One of the two sizes of `PRE` and `ACC`.
pub(super) const SIZE: Setting = Setting {
    name: "SIZE",
    choice: Choice::Word(&["INT", "DINT"]),
    doc: "the type of PRE and ACC: INT as in the SLC, DINT as in Logix",
};

/// The settings of a timer.
pub(super) const TIMER_SETTINGS: &[Setting] = &[
    Setting {
        name: "BASE",
        choice: Choice::Time(&[1_000_000, 10_000_000, 100_000_000, 1_000_000_000], 10_000_000),
        doc: "the unit in which PRE and ACC count; 10 ms as in the SLC, 1 ms in Logix",
    },
    SIZE,
];

/// The ports of a timer with that accumulator.
pub(super) const fn timer_ports(accumulator: Port) -> [Port; 7] {
    [
        Port::loaded("PRE", COUNTS, "the preset in units of BASE; negative acts as 0")
            .of_type("SIZE"),
        accumulator.of_type("SIZE").with_fraction("fraction"),
        Port::output("EN", Type::Bool, "the power"),
        Port::output("TT", Type::Bool, "the timer is timing"),
        Port::output("DN", Type::Bool, "the timer is done"),
        Port::shared("fraction", Type::Dint, false, "ticks of a unit that is not full"),
        Port::memory("was", "the power at the call before"),
    ]
}

/// An accumulator to which the call may give a start.
pub(super) const fn accumulator() -> Port {
    Port::accumulator("ACC", Some(COUNTS), "units of BASE that have been timed")
}

/// One tick goes by for a timer that is timing.
pub(super) fn advance(call: &mut Step) {
    let (units, ticks) = (call.get("ACC"), call.get("fraction") + 1);
    let (_, most) = call.shape.ty("ACC").range();
    if ticks < call.shape.number("BASE") {
        call.set("fraction", ticks);
    } else {
        call.set("fraction", 0);
        call.set("ACC", (units + 1).min(most));
    }
}

/// The accumulator and the fraction, one tick on where `timing` is 1.
pub(super) fn advanced(logic: &mut Logic, timing: Net) -> (Net, Net) {
    let (units, ticks) = (logic.get("ACC"), logic.get("fraction"));
    let base = logic.shape.number("BASE");
    let (_, most) = logic.shape.ty("ACC").range();
    let (zero, last) = (logic.constant("fraction", 0), logic.constant("fraction", base - 1));
    let is_full = match base {
        1 => logic.circuit.bit(true),
        _ => logic.circuit.eq(ticks, last),
    };
    let carry = logic.circuit.and([timing, is_full]);
    let counted = logic.count_up(ticks, timing);
    let ticks = logic.circuit.mux(carry, zero, counted);
    let most = logic.constant("ACC", most);
    let room = logic.circuit.less(units, most, true);
    let up = logic.circuit.and([carry, room]);
    (logic.count_up(units, up), ticks)
}
