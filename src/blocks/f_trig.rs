//! `F_TRIG`, the falling edge.

use super::{Block, Logic, Port, Step};
use crate::types::Type;

/// The falling edge detector of IEC 61131-3.
pub const F_TRIG: Block = Block {
    name: "F_TRIG",
    title: "falling edge",
    doc: "Q is on in a scan in which the power is off and was on at the call before. A power that \
          is off in the first scan is no fall; the body that the standard prints would give a \
          pulse there. (R name) ends the pulse. Source: IEC 61131-3, edge detection function \
          blocks.",
    settings: &[],
    ports: &[
        Port::output("Q", Type::Bool, "the power has gone off"),
        Port::memory("was", "the power at the call before"),
    ],
    main: Some("Q"),
    partner: None,
    can_reset: true,
    keeps: |_| None,
    step,
    build,
    waves: &[
        "\
IN  __##_#__
Q   ____#_#_",
        "\
IN   #__#_
(R)  _#___
Q    ____#",
    ],
};

fn step(call: &mut Step) {
    call.set("Q", !call.power && call.is_on("was"));
    call.set("was", call.power);
}

fn build(logic: &mut Logic) {
    let (power, was) = (logic.power, logic.get("was"));
    let off = logic.circuit.not(power);
    let fall = logic.circuit.and([off, was]);
    logic.set("Q", fall);
    logic.set("was", power);
}
