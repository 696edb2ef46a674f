//! `UC`, the up counter with an enable circuit.

use super::{Block, Logic, Port, Step, UNIT_COUNTS};
use crate::types::Type;

/// The up counter of Modicon and of the function paper.
pub const UC: Block = Block {
    name: "UC",
    title: "up counter with enable",
    doc: "ACC counts the rises of the power while EN is on, past PV up to 9999. EN off puts it to \
          0; rises are seen then and not counted. Q is on while ACC is PV or more, also without \
          power. A power that is on in the first scan counts. (R name) puts ACC to 0; a held \
          power does not count once more, and Q is off until the next call. Source: Shobha and \
          Ramachandran, Realization of Timers, Counters and Shift Registers for Programmable \
          Controller Using Ladder Diagram; Modicon 984 instruction set, UCTR.",
    settings: &[],
    ports: &[
        Port::enable("lets ACC count; off, it puts ACC to 0"),
        Port::preset(
            "PV",
            Type::Int,
            UNIT_COUNTS,
            "the count at which Q comes on; negative acts as 0, more than 9999 as 9999",
        ),
        Port::output("Q", Type::Bool, "the count has reached PV"),
        Port::output("ACC", Type::Int, "the count, 0 to 9999"),
        Port::memory("was", "the power at the call before"),
    ],
    main: Some("Q"),
    partner: None,
    can_reset: true,
    keeps: |_| Some(&["EN"]),
    step,
    build,
    waves: &[
        "\
PV = 2
IN  _#_##_#_#__#_#_
EN  #########__####
Q   ___######____##
ACC 011222334001122",
        "\
PV = 1
IN  #__###
EN  ##__##
Q   ##____
ACC 110000",
        "\
PV = 9999
ACC = 9998
IN       _#_#
Q        _###
ACC-9990 8999",
        "\
PV = 0
IN  _#
EN  _#
Q   ##
ACC 01",
        "\
PV = 2
IN  #_###_#
(R) ___#___
Q   __#____
ACC 1120001",
    ],
};

fn step(call: &mut Step) {
    let mut count = call.get("ACC");
    if !call.is_on("EN") {
        count = 0;
    } else if call.power && !call.is_on("was") && count < UNIT_COUNTS.1 {
        count += 1;
    }
    call.set("ACC", count);
    call.set("Q", count >= call.preset("PV"));
    call.set("was", call.power);
}

fn build(logic: &mut Logic) {
    let (power, enable) = (logic.power, logic.get("EN"));
    let (preset, count) = (logic.preset("PV"), logic.get("ACC"));
    let (zero, most) = (logic.constant("ACC", 0), logic.constant("ACC", UNIT_COUNTS.1));
    let rise = logic.rise(power, "was");
    let room = logic.circuit.less(count, most, true);
    let up = logic.circuit.and([rise, room]);
    let counted = logic.count_up(count, up);
    let count = logic.circuit.mux(enable, counted, zero);
    let q = logic.reached(count, preset);
    logic.set("ACC", count);
    logic.set("Q", q);
    logic.set("was", power);
}
