//! `DC`, the down counter with an enable circuit.

use super::{Block, Logic, Port, Start, Step, UNIT_COUNTS};
use crate::types::Type;

/// The down counter of Modicon and of the function paper.
pub const DC: Block = Block {
    name: "DC",
    title: "down counter with enable",
    doc: "ACC starts at PV and counts down with each rise of the power while EN is on, to 0, \
          where it stops. EN off puts it to PV; rises are seen then and not counted. Q is on while \
          ACC is 0, also without power. A power that is on in the first scan counts. (R name) puts \
          ACC back to its start; Q is off then until the next call. Source: Shobha and \
          Ramachandran, Realization of Timers, Counters and Shift Registers for Programmable \
          Controller Using Ladder Diagram; Modicon 984 instruction set, DCTR.",
    settings: &[],
    ports: &[
        Port::enable("lets ACC count; off, it puts ACC to PV"),
        Port::preset(
            "PV",
            Type::Int,
            UNIT_COUNTS,
            "where the count starts; negative acts as 0, more than 9999 as 9999",
        ),
        Port::output("Q", Type::Bool, "the count has come down to 0"),
        Port::output("ACC", Type::Int, "the count, 9999 to 0").starting_at(Start::Preset("PV")),
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
IN  _#_##_#_#__
EN  #######__##
Q   ___####____
ACC 21100002222",
        "\
PV = 0
IN  _#_
EN  _##
Q   ###
ACC 000",
        "\
ACC = 3
IN  _#_#_#
PV  555555
EN  ####_#
Q   ______
ACC 322154",
        "\
PV = 10000
IN       _#
EN       __
Q        __
ACC-9990 99",
        "\
PV = 3
IN  #_##_#
(R) __#___
Q   ______
ACC 223332",
    ],
};

fn step(call: &mut Step) {
    let mut count = call.get("ACC");
    if !call.is_on("EN") {
        count = call.preset("PV");
    } else if call.power && !call.is_on("was") && count != 0 {
        count -= 1;
    }
    call.set("ACC", count);
    call.set("Q", count == 0);
    call.set("was", call.power);
}

fn build(logic: &mut Logic) {
    let (power, enable) = (logic.power, logic.get("EN"));
    let (preset, count) = (logic.preset("PV"), logic.get("ACC"));
    let zero = logic.constant("ACC", 0);
    let rise = logic.rise(power, "was");
    let is_down = logic.circuit.eq(count, zero);
    let room = logic.circuit.not(is_down);
    let down = logic.circuit.and([rise, room]);
    let counted = logic.count_down(count, down);
    let count = logic.circuit.mux(enable, counted, preset);
    let q = logic.circuit.eq(count, zero);
    logic.set("ACC", count);
    logic.set("Q", q);
    logic.set("was", power);
}
