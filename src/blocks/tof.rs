//! `TOF`, the off-delay timer.

use super::{Block, Logic, Port, Step, TIMES};
use crate::types::Type;

/// The off-delay timer of IEC 61131-3.
pub const TOF: Block = Block {
    name: "TOF",
    title: "off-delay timer",
    doc: "Q comes on with the power and goes off when the power has been off for PT. ET counts \
          the ticks since the power went off, up to PT, and stays there until the power comes \
          on. The tick of the scan in which the power goes off does not count. PT = 0 passes the \
          power through. A power that is off in the first scan starts nothing. (R name) ends a \
          delay; a held power puts Q on again at the next call. Source: IEC 61131-3, timer \
          function blocks.",
    settings: &[],
    ports: &[
        Port::preset(
            "PT",
            Type::Time,
            TIMES,
            "how long Q stays on after the power, in ticks; negative acts as 0",
        ),
        Port::output("Q", Type::Bool, "the power, prolonged"),
        Port::output("ET", Type::Time, "ticks since the power went off, 0 to PT"),
        Port::state("run", "the power is on, or the delay runs"),
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
IN  _##_____#__#_____
Q   _#####__#######__
ET  00001233001001233",
        "\
PT = 2
IN   #_______
tick ##__#_#_
Q    ######__
ET   00001122",
        "\
PT = 0
IN  _##_#_
Q   _##_#_
ET  000000",
        "\
IN  #______
PT  5555111
Q   ####___
ET  0012222",
        "\
PT = 3
IN   ##__#____###
(R)  _#_____#__#_
Q    #___###__#_#
ET   000000100000",
    ],
};

fn step(call: &mut Step) {
    let (preset, mut elapsed, mut run) = (call.get("PT"), call.get("ET"), call.is_on("run"));
    if call.power {
        run = true;
        elapsed = 0;
    } else if run {
        if call.is_on("was") {
            elapsed = 0;
        } else if call.tick && elapsed < preset {
            elapsed += 1;
        }
        run = elapsed < preset;
    }
    call.set("ET", elapsed);
    call.set("run", run);
    call.set("Q", call.power || run);
    call.set("was", call.power);
}

fn build(logic: &mut Logic) {
    let (power, tick) = (logic.power, logic.tick);
    let (preset, elapsed) = (logic.get("PT"), logic.get("ET"));
    let (run, was) = (logic.get("run"), logic.get("was"));
    let zero = logic.constant("ET", 0);
    let below = logic.circuit.less(elapsed, preset, true);
    let count = logic.circuit.and([tick, below]);
    let counted = logic.count_up(elapsed, count);
    let delayed = logic.circuit.mux(was, zero, counted);
    let goes_on = logic.circuit.less(delayed, preset, true);
    let off = logic.circuit.mux(run, delayed, elapsed);
    let elapsed = logic.circuit.mux(power, zero, off);
    let delays = logic.circuit.and([run, goes_on]);
    let run = logic.circuit.or([power, delays]);
    logic.set("ET", elapsed);
    logic.set("run", run);
    logic.set("Q", run);
    logic.set("was", power);
}
