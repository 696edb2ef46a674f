//! `RS`, the latch in which reset wins.

use super::{Block, Logic, Port, Step};
use crate::types::Type;

/// The reset-dominant bistable of IEC 61131-3.
pub const RS: Block = Block {
    name: "RS",
    title: "latch in which reset wins",
    doc: "The power, S in the standard, puts Q on; R1 puts it off. With both Q is off. With \
          neither Q stays. (R name) puts Q off too; a held power puts it on again at the next \
          call. Source: IEC 61131-3, bistable function blocks.",
    settings: &[],
    ports: &[Port::circuit("R1", "holds Q off"), Port::output("Q", Type::Bool, "the latch")],
    main: Some("Q"),
    partner: None,
    can_reset: true,
    keeps: |_| Some(&["R1"]),
    step,
    build,
    waves: &[
        "\
IN  _#___#_#_
R1  ___#_#___
Q   _##____##",
        "\
IN  ####
R1  _##_
Q   #__#",
        "\
IN   ##__
(R)  #_#_
Q    _#__",
    ],
};

fn step(call: &mut Step) {
    call.set("Q", !call.is_on("R1") && (call.power || call.is_on("Q")));
}

fn build(logic: &mut Logic) {
    let (power, reset, q) = (logic.power, logic.get("R1"), logic.get("Q"));
    let keep = logic.circuit.not(reset);
    let on = logic.circuit.or([power, q]);
    let q = logic.circuit.and([keep, on]);
    logic.set("Q", q);
}
