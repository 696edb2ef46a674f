//! `TONR`, the retentive on-delay timer.

use super::{Block, Logic, Port, Step, TIMES};
use crate::types::Type;

/// The time accumulator of Siemens' S7-1200.
pub const TONR: Block = Block {
    name: "TONR",
    title: "retentive on-delay timer",
    doc: "ET adds up the ticks while the power is on, up to PT, and keeps its value while the \
          power is off. Q is on from when ET has reached PT, also after the power went off, until \
          R. R puts ET back to 0 and holds it there. The tick of a scan in which the power comes \
          on does not count; where the power stays on over an R, the first tick after R does. \
          With PT = 0, Q is on unless R is. (R name) puts ET back to 0 too; Q is off then until \
          the next call. Source: Siemens S7-1200, timer operations, TONR.",
    settings: &[],
    ports: &[
        Port::preset(
            "PT",
            Type::Time,
            TIMES,
            "how long the power must have been on in all, in ticks; negative acts as 0",
        ),
        Port::circuit("R", "holds ET at 0 and Q off"),
        Port::output("Q", Type::Bool, "the time is up"),
        Port::output("ET", Type::Time, "ticks with the power on, 0 to PT"),
        Port::memory("was", "the power at the call before, also while R is on"),
    ],
    main: Some("Q"),
    partner: None,
    can_reset: true,
    keeps: |_| Some(&["R"]),
    step,
    build,
    waves: &[
        "\
PT = 3
IN  _##_###____######
R   _________#___#___
Q   ______###_______#
ET  00111233300010123",
        "\
PT = 2
IN   #######_
tick #_#__#_#
Q    _____###
ET   00111222",
        "\
PT = 0
IN  __#__
R   _#_#_
Q   #_#_#
ET  00000",
        "\
PT = 2
IN   ######___
(R)  ___#___#_
Q    __#__##__
ET   012012200",
        "\
PT = 0
IN   ___
(R)  _#_
Q    #_#
ET   000",
    ],
};

fn step(call: &mut Step) {
    let (preset, mut elapsed) = (call.get("PT"), call.get("ET"));
    if call.is_on("R") {
        elapsed = 0;
    } else if call.power && call.is_on("was") && call.tick && elapsed < preset {
        elapsed += 1;
    }
    call.set("ET", elapsed);
    call.set("Q", !call.is_on("R") && elapsed >= preset);
    call.set("was", call.power);
}

fn build(logic: &mut Logic) {
    let (power, tick, reset) = (logic.power, logic.tick, logic.get("R"));
    let (preset, elapsed, was) = (logic.get("PT"), logic.get("ET"), logic.get("was"));
    let below = logic.circuit.less(elapsed, preset, true);
    let count = logic.circuit.and([power, was, tick, below]);
    let counted = logic.count_up(elapsed, count);
    let zero = logic.constant("ET", 0);
    let elapsed = logic.circuit.mux(reset, zero, counted);
    let reached = logic.reached(elapsed, preset);
    let runs = logic.circuit.not(reset);
    let q = logic.circuit.and([runs, reached]);
    logic.set("ET", elapsed);
    logic.set("Q", q);
    logic.set("was", power);
}
