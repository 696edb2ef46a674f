//! `CTD`, the down counter.

use super::{Block, COUNTS, LOWEST, Logic, Port, Start, Step};
use crate::types::Type;

/// The down counter of IEC 61131-3.
pub const CTD: Block = Block {
    name: "CTD",
    title: "down counter",
    doc: "CV starts at PV and counts down with each rise of the power, to -32768. LD puts it back \
          to PV and holds it there; rises are seen then and not counted. Q is on while CV is 0 or \
          less. A power that is on in the first scan counts as a rise. CV starts at the constant \
          PV, or at what PV is at reset. (R name) puts CV back to this start; Q is off then until \
          the next call. Source: IEC 61131-3, counter function blocks.",
    settings: &[],
    ports: &[
        Port::circuit("LD", "holds CV at PV"),
        Port::preset("PV", Type::Int, COUNTS, "where CV starts; negative acts as 0"),
        Port::output("Q", Type::Bool, "the count has come down to 0"),
        Port::output("CV", Type::Int, "the count, -32768 to 32767")
            .starting_at(Start::Preset("PV")),
        Port::memory("was", "the power at the call before"),
    ],
    main: Some("Q"),
    partner: None,
    can_reset: true,
    keeps: |_| Some(&["LD"]),
    step,
    build,
    waves: &[
        "\
PV = 2
IN  _##_#__#_#_
LD  ______##___
Q   ____##_____
CV  21110022211",
        "\
PV = 1
IN   #_#_#_
Q    ######
CV+2 221100",
        "\
PV = 5
CV = -32767
IN       _#_#_
Q        #####
CV+32768 10000",
        "\
IN   ____
PV   3355
LD   _#_#
Q    #___
CV   0335",
        "\
PV = -4
IN   _#_
LD   __#
Q    ###
CV+1 101",
        "\
PV = 2
IN   #_###_#
(R)  ___#___
Q    __#____
CV   1102221",
        "\
PV = 0
IN   ___
(R)  _#_
Q    #_#
CV   000",
    ],
};

fn step(call: &mut Step) {
    let mut count = call.get("CV");
    if call.is_on("LD") {
        count = call.preset("PV");
    } else if call.power && !call.is_on("was") && count > LOWEST {
        count -= 1;
    }
    call.set("CV", count);
    call.set("Q", count <= 0);
    call.set("was", call.power);
}

fn build(logic: &mut Logic) {
    let (power, load) = (logic.power, logic.get("LD"));
    let (preset, count) = (logic.preset("PV"), logic.get("CV"));
    let lowest = logic.constant("CV", LOWEST);
    let rise = logic.rise(power, "was");
    let room = logic.circuit.less(lowest, count, true);
    let down = logic.circuit.and([rise, room]);
    let counted = logic.count_down(count, down);
    let count = logic.circuit.mux(load, preset, counted);
    let zero = logic.constant("CV", 0);
    let q = logic.reached(zero, count);
    logic.set("CV", count);
    logic.set("Q", q);
    logic.set("was", power);
}
