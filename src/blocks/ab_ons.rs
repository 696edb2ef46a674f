//! `AB_ONS`, Allen-Bradley's one-shot.

use super::{Block, Logic, Port, Start, Step};
use crate::types::Type;

/// The one-shot of Allen-Bradley.
pub const AB_ONS: Block = Block {
    name: "AB_ONS",
    title: "one-shot of Allen-Bradley",
    doc: "The power goes on to the right in the scan in which it has come on, and not while it \
          stays. A power that is on in the first scan has not come on. Q is the power that goes on \
          to the right; (R name) puts it to 0. Source: Rockwell Automation, Logix 5000 General \
          Instructions, ONS.",
    settings: &[],
    ports: &[
        Port::output("Q", Type::Bool, "the power has come on"),
        Port::memory("was", "the power at the call before").starting_at(Start::Value(1)),
    ],
    main: Some("Q"),
    partner: None,
    can_reset: true,
    keeps: |_| None,
    step,
    build,
    waves: &[
        "\
IN  __##_#_
Q   __#__#_",
        "\
IN  ##_##
(R) ____#
Q   ___#_",
    ],
};

fn step(call: &mut Step) {
    call.set("Q", call.power && !call.is_on("was"));
    call.set("was", call.power);
}

fn build(logic: &mut Logic) {
    let power = logic.power;
    let q = logic.rise(power, "was");
    logic.set("Q", q);
    logic.set("was", power);
}
