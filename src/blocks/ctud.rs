//! `CTUD`, the up-down counter.

use super::{Block, COUNTS, HIGHEST, LOWEST, Logic, Port, Step};
use crate::types::Type;

/// The up-down counter of IEC 61131-3.
pub const CTUD: Block = Block {
    name: "CTUD",
    title: "up-down counter",
    doc: "CV counts up with each rise of the power and down with each rise of CD, from -32768 to \
          32767. Where both rise in one scan it stays. R puts CV to 0 and holds it there; LD, \
          where R is off, does so with PV. Rises are seen then and not counted. QU, which goes on \
          to the right, is on while CV is PV or more, QD while CV is 0 or less. A power or a CD \
          that is on in the first scan counts as a rise. (R name) puts CV back to 0; QU and QD \
          are off then until the next call. Source: IEC 61131-3, counter function blocks.",
    settings: &[],
    ports: &[
        Port::circuit("CD", "counts down with each rise"),
        Port::circuit("R", "holds CV at 0"),
        Port::circuit("LD", "holds CV at PV"),
        Port::preset(
            "PV",
            Type::Int,
            COUNTS,
            "the count at which QU comes on, and that LD loads; negative acts as 0",
        ),
        Port::output("QU", Type::Bool, "the count has reached PV"),
        Port::output("QD", Type::Bool, "the count has come down to 0"),
        Port::output("CV", Type::Int, "the count, -32768 to 32767"),
        Port::memory("was", "the power at the call before"),
        Port::memory("was_down", "CD at the call before"),
    ],
    main: Some("QU"),
    partner: None,
    can_reset: true,
    keeps: |_| Some(&["R", "LD"]),
    step,
    build,
    waves: &[
        "\
PV = 2
IN  _#_#__#______
CD  ____#_#_#____
R   ___________##
LD  __________#_#
QU  ___#______#__
QD  #_______##_##
CV  0112111100200",
        "\
PV = 3
IN  ##_##____
CD  ##___##_#
R   #________
LD  ___#_#___
QU  ___#####_
QD  ###______
CV  000333332",
        "\
PV = 1
IN   _###_
CD   ##_#_
QU   _____
QD   #####
CV+1 01100",
        "\
PV = 32767
CV = 32766
IN       _#_#_##
CD       _____##
QU       _######
QD       _______
CV-32760 6777777",
        "\
PV = 0
CV = -32767
IN       _____#
CD       _#_#_#
QU       ______
QD       ######
CV+32768 100000",
        "\
PV = -3
IN   ___
CD   _#_
LD   __#
QU   #_#
QD   ###
CV+1 101",
        "\
PV = 1
IN   ###_#
CD   _##__
(R)  _#___
QU   #___#
QD   __##_
CV   10001",
    ],
};

fn step(call: &mut Step) {
    let (preset, mut count) = (call.preset("PV"), call.get("CV"));
    let up = call.power && !call.is_on("was");
    let down = call.is_on("CD") && !call.is_on("was_down");
    if call.is_on("R") {
        count = 0;
    } else if call.is_on("LD") {
        count = preset;
    } else if up && !down && count < HIGHEST {
        count += 1;
    } else if down && !up && count > LOWEST {
        count -= 1;
    }
    call.set("CV", count);
    call.set("QU", count >= preset);
    call.set("QD", count <= 0);
    call.set("was", call.power);
    call.set("was_down", call.get("CD"));
}

fn build(logic: &mut Logic) {
    let (power, back) = (logic.power, logic.get("CD"));
    let (preset, count) = (logic.preset("PV"), logic.get("CV"));
    let (highest, lowest) = (logic.constant("CV", HIGHEST), logic.constant("CV", LOWEST));
    let (up, down) = (logic.rise(power, "was"), logic.rise(back, "was_down"));
    let (no_up, no_down) = (logic.circuit.not(up), logic.circuit.not(down));
    let room_above = logic.circuit.less(count, highest, true);
    let room_below = logic.circuit.less(lowest, count, true);
    let up = logic.circuit.and([up, no_down, room_above]);
    let down = logic.circuit.and([down, no_up, room_below]);
    // One adder for both: what is added is 1, -1 or 0.
    let minus_one = logic.constant("CV", -1);
    let width = logic.circuit.width(count);
    let one = logic.circuit.resize(up, width, false);
    let change = logic.circuit.mux(down, minus_one, one);
    let counted = logic.circuit.add(count, change);
    let (reset, load, zero) = (logic.get("R"), logic.get("LD"), logic.constant("CV", 0));
    let loaded = logic.circuit.mux(load, preset, counted);
    let count = logic.circuit.mux(reset, zero, loaded);
    let (qu, qd) = (logic.reached(count, preset), logic.reached(zero, count));
    logic.set("CV", count);
    logic.set("QU", qu);
    logic.set("QD", qd);
    logic.set("was", power);
    logic.set("was_down", back);
}
