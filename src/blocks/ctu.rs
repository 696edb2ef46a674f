//! `CTU`, the up counter.

use super::{Block, COUNTS, HIGHEST, Logic, Port, Step};
use crate::types::Type;

/// The up counter of IEC 61131-3.
pub const CTU: Block = Block {
    name: "CTU",
    title: "up counter",
    doc: "CV counts the rises of the power, up to 32767. R puts it back to 0 and holds it there. \
          Q is on while CV is PV or more. A power that is on in the first scan counts as a rise. \
          Source: IEC 61131-3, counter function blocks.",
    settings: &[],
    ports: &[
        Port::circuit("R", "holds CV at 0"),
        Port::preset("PV", Type::Int, COUNTS, "the count at which Q comes on; negative acts as 0"),
        Port::output("Q", Type::Bool, "the count has reached PV"),
        Port::output("CV", Type::Int, "the count, 0 to 32767"),
        Port::memory("was", "the power at the call before"),
    ],
    main: Some("Q"),
    partner: None,
    can_reset: true,
    keeps: |_| Some(&["R"]),
    step,
    build,
    waves: &[
        "\
PV = 2
IN  _#_##_#_#__#_#_
R   _________##____
Q   ___######____##
CV  011222334001122",
        "\
PV = 32767
CV = 32766
IN       _#_#_
Q        _####
CV-32760 67777",
        "\
PV = 0
IN   __#
(R)  _#_
Q    #_#
CV   001",
        "\
PV = 1
IN   ###_#
(R)  _#___
Q    #___#
CV   10001",
    ],
};

fn step(call: &mut Step) {
    let count = call.get("CV");
    let count = if call.is_on("R") {
        0
    } else if call.power && !call.is_on("was") && count < HIGHEST {
        count + 1
    } else {
        count
    };
    call.set("CV", count);
    call.set("Q", count >= call.get("PV"));
    call.set("was", call.power);
}

fn build(logic: &mut Logic) {
    let power = logic.power;
    let (reset, preset) = (logic.get("R"), logic.get("PV"));
    let (count, was) = (logic.get("CV"), logic.get("was"));
    let highest = logic.constant("CV", HIGHEST);
    let full = logic.circuit.eq(count, highest);
    let (idle, room) = (logic.circuit.not(was), logic.circuit.not(full));
    let rise = logic.circuit.and([power, idle, room]);
    let counted = logic.count_up(count, rise);
    let zero = logic.constant("CV", 0);
    let count = logic.circuit.mux(reset, zero, counted);
    let short = logic.circuit.less(count, preset, true);
    let q = logic.circuit.not(short);
    logic.set("CV", count);
    logic.set("Q", q);
    logic.set("was", power);
}
