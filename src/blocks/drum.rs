//! `DRUM`, the drum counter: one count that switches several outputs.

use super::{Block, Choice, Logic, Port, Setting, Step};
use crate::types::Type;

/// Smallest and largest step of a drum.
const STEPS: (i64, i64) = (0, 2047);
/// What the taps are called.
const TAPS: [&str; 16] = [
    "TAP0", "TAP1", "TAP2", "TAP3", "TAP4", "TAP5", "TAP6", "TAP7", "TAP8", "TAP9", "TAP10",
    "TAP11", "TAP12", "TAP13", "TAP14", "TAP15",
];

/// The drum counter of the function paper.
pub const DRUM: Block = Block {
    name: "DRUM",
    title: "drum counter",
    doc: "ACC counts the rises of the power while EN is on, past PV up to 2047. EN off puts it to \
          0; rises are seen then and not counted. Q is on while ACC is PV or more, and each tap \
          while ACC is the constant of that tap or more, all of them also without power. A power \
          that is on in the first scan counts. (R name) puts ACC to 0; the outputs are off then \
          until the next call. Source: Shobha and Ramachandran, Realization of Timers, Counters \
          and Shift Registers for Programmable Controller Using Ladder Diagram, drum counter.",
    settings: &[Setting {
        name: "TAPS",
        choice: Choice::List { low: STEPS.0, high: STEPS.1, most: TAPS.len() },
        doc: "the counts at which TAP0, TAP1 and so on come on",
    }],
    ports: &ports(),
    main: Some("Q"),
    partner: None,
    can_reset: true,
    keeps: |_| Some(&["EN"]),
    step,
    build,
    waves: &[
        "\
PV = 3
TAPS = [1, 2]
IN   _#_#_#_#___
EN   #########_#
Q    _____####__
TAP0 _########__
TAP1 ___######__
ACC  01122334400",
        "\
PV = 2047
TAPS = [2047, 2046]
ACC = 2045
IN       #_#_#_#
Q        __#####
TAP0     __#####
TAP1     #######
ACC-2040 6677777",
        "\
PV = 2048
ACC = 2046
IN       _#
Q        _#
ACC-2040 67",
        "\
PV = 0
TAPS = [0]
IN   #__##
EN   _####
Q    #####
TAP0 #####
ACC  00011",
        "\
PV = 2
TAPS = [1]
IN   #_###_#
(R)  ___#___
Q    __#____
TAP0 ###___#
ACC  1120001",
    ],
};

const fn ports() -> [Port; 21] {
    let mut ports = [Port::memory("was", "the power at the call before"); 21];
    ports[0] = Port::enable("lets ACC count; off, it puts ACC to 0");
    ports[1] = Port::preset(
        "PV",
        Type::Int,
        STEPS,
        "the count at which Q comes on; negative acts as 0, more than 2047 as 2047",
    );
    ports[2] = Port::output("Q", Type::Bool, "the count has reached PV");
    ports[3] = Port::output("ACC", Type::Int, "the count, 0 to 2047");
    let mut tap = 0;
    while tap < TAPS.len() {
        let port = Port::output(TAPS[tap], Type::Bool, "the count has reached that tap's constant");
        ports[4 + tap] = port.for_item("TAPS", tap);
        tap += 1;
    }
    ports
}

fn step(call: &mut Step) {
    let mut count = call.get("ACC");
    if !call.is_on("EN") {
        count = 0;
    } else if call.power && !call.is_on("was") && count < STEPS.1 {
        count += 1;
    }
    call.set("ACC", count);
    call.set("Q", count >= call.preset("PV"));
    for (name, &tap) in TAPS.iter().zip(call.shape.list("TAPS")) {
        call.set(name, count >= tap);
    }
    call.set("was", call.power);
}

fn build(logic: &mut Logic) {
    let (power, enable) = (logic.power, logic.get("EN"));
    let (preset, count) = (logic.preset("PV"), logic.get("ACC"));
    let (zero, most) = (logic.constant("ACC", 0), logic.constant("ACC", STEPS.1));
    let rise = logic.rise(power, "was");
    let room = logic.circuit.less(count, most, true);
    let up = logic.circuit.and([rise, room]);
    let counted = logic.count_up(count, up);
    let count = logic.circuit.mux(enable, counted, zero);
    let q = logic.reached(count, preset);
    logic.set("ACC", count);
    logic.set("Q", q);
    for (name, &tap) in TAPS.iter().zip(logic.shape.list("TAPS")) {
        let tap = logic.constant("ACC", tap);
        let is_on = logic.reached(count, tap);
        logic.set(name, is_on);
    }
    logic.set("was", power);
}
