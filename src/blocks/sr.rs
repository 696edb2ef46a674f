//! `SR`, the latch in which set wins.

use super::{Block, Logic, Port, Step};
use crate::types::Type;

/// The set-dominant bistable of IEC 61131-3.
pub const SR: Block = Block {
    name: "SR",
    title: "latch in which set wins",
    doc: "The power, S1 in the standard, puts Q on; R puts it off. With both Q is on. With \
          neither Q stays. (R name) puts Q off too; a held power puts it on again at the next \
          call. Source: IEC 61131-3, bistable function blocks.",
    settings: &[],
    ports: &[Port::circuit("R", "puts Q off"), Port::output("Q", Type::Bool, "the latch")],
    main: Some("Q"),
    partner: None,
    can_reset: true,
    keeps: |_| Some(&["R"]),
    step,
    build,
    waves: &[
        "\
IN  _#___#_#_
R   ___#_##__
Q   _##__#_##",
        "\
IN   ##__
(R)  #_#_
Q    _#__",
    ],
};

fn step(call: &mut Step) {
    call.set("Q", call.power || call.is_on("Q") && !call.is_on("R"));
}

fn build(logic: &mut Logic) {
    let (power, reset, q) = (logic.power, logic.get("R"), logic.get("Q"));
    let keep = logic.circuit.not(reset);
    let kept = logic.circuit.and([q, keep]);
    let q = logic.circuit.or([power, kept]);
    logic.set("Q", q);
}
