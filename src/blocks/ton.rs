//! `TON`, the on-delay timer.

use super::{Block, Logic, Port, Step, TIMES};
use crate::types::Type;

/// The on-delay timer of IEC 61131-3.
pub const TON: Block = Block {
    name: "TON",
    title: "on-delay timer",
    doc: "Q comes on when the power has been on for PT, and goes off with the power. ET counts \
          the ticks since the power came on, up to PT. The tick of the scan in which the power \
          comes on does not count. PT = 0 passes the power through. Source: IEC 61131-3, timer \
          function blocks.",
    settings: &[],
    ports: &[
        Port::preset(
            "PT",
            Type::Time,
            TIMES,
            "how long the power must have been on, in ticks; negative acts as 0",
        ),
        Port::output("Q", Type::Bool, "the power, delayed"),
        Port::output("ET", Type::Time, "ticks since the power came on, 0 to PT"),
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
PT = 3
IN  _#######__###__##_
Q   ____####__________
ET  001233330001200010",
        "\
PT = 2
IN   #######
tick #_#__#_
Q    _____##
ET   0011122",
        "\
PT = 0
IN  _##_
Q   _##_
ET  0000",
        "\
PT = 2
IN   ######_
(R)  ___#___
Q    __#__#_
ET   0120120",
    ],
};

fn step(call: &mut Step) {
    let (preset, elapsed) = (call.get("PT"), call.get("ET"));
    let elapsed = if !call.power || !call.is_on("was") {
        0
    } else if call.tick && elapsed < preset {
        elapsed + 1
    } else {
        elapsed
    };
    call.set("ET", elapsed);
    call.set("Q", call.power && elapsed >= preset);
    call.set("was", call.power);
}

fn build(logic: &mut Logic) {
    let (power, tick) = (logic.power, logic.tick);
    let (preset, elapsed, was) = (logic.get("PT"), logic.get("ET"), logic.get("was"));
    let timing = logic.circuit.and([power, was]);
    let below = logic.circuit.less(elapsed, preset, true);
    let count = logic.circuit.and([tick, below]);
    let counted = logic.count_up(elapsed, count);
    let zero = logic.constant("ET", 0);
    let elapsed = logic.circuit.mux(timing, counted, zero);
    let short = logic.circuit.less(elapsed, preset, true);
    let reached = logic.circuit.not(short);
    let q = logic.circuit.and([power, reached]);
    logic.set("ET", elapsed);
    logic.set("Q", q);
    logic.set("was", power);
}
