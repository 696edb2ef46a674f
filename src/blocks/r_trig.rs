//! `R_TRIG`, the rising edge.

use super::{Block, Logic, Port, Step};
use crate::types::Type;

/// The rising edge detector of IEC 61131-3.
pub const R_TRIG: Block = Block {
    name: "R_TRIG",
    title: "rising edge",
    doc: "Q is on in a scan in which the power is on and was off at the call before. A power that \
          is on in the first scan is a rise. (R name) ends the pulse; a held power gives no other. \
          Source: IEC 61131-3, edge detection function blocks.",
    settings: &[],
    ports: &[
        Port::output("Q", Type::Bool, "the power has come on"),
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
IN  ##__#_##_
Q   #___#_#__",
        "\
IN   ##_#
(R)  #___
Q    ___#",
    ],
};

fn step(call: &mut Step) {
    call.set("Q", call.power && !call.is_on("was"));
    call.set("was", call.power);
}

fn build(logic: &mut Logic) {
    let power = logic.power;
    let rise = logic.rise(power, "was");
    logic.set("Q", rise);
    logic.set("was", power);
}
