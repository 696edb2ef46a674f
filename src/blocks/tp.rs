//! `TP`, the pulse timer.

use super::{Block, Logic, Port, Step, TIMES};
use crate::types::Type;

/// The pulse timer of IEC 61131-3.
pub const TP: Block = Block {
    name: "TP",
    title: "pulse timer",
    doc: "A rise of the power starts a pulse: Q is on for PT, whatever the power does meanwhile. \
          ET counts the ticks since the rise, up to PT, and goes back to 0 when the pulse is over \
          and the power is off. The tick of the scan of the rise does not count. A rise during a \
          pulse, or in the scan in which one ends, starts none. PT = 0 gives no pulse. A power \
          that is on in the first scan is a rise. (R name) ends a pulse; a held power does not \
          start another. Source: IEC 61131-3, timer function blocks.",
    settings: &[],
    ports: &[
        Port::preset("PT", Type::Time, TIMES, "length of the pulse, in ticks; negative acts as 0"),
        Port::output("Q", Type::Bool, "the pulse"),
        Port::output("ET", Type::Time, "ticks since the pulse began, 0 to PT"),
        Port::state("run", "a pulse runs"),
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
IN  _#####_#_#__
Q   _###___###__
ET  001233001200",
        "\
PT = 2
IN  #_##_###
Q   ##___##_
ET  01220012",
        "\
PT = 2
IN   ##______
tick #__#_##_
Q    #####___
ET   00011000",
        "\
PT = 0
IN  _##_#
Q   _____
ET  00000",
        "\
PT = 3
IN   ###_#__##
(R)  _#___#___
Q    #___#__##
ET   000000001",
    ],
};

fn step(call: &mut Step) {
    let (preset, mut elapsed, mut run) = (call.get("PT"), call.get("ET"), call.is_on("run"));
    if run {
        if call.tick && elapsed < preset {
            elapsed += 1;
        }
        run = elapsed < preset;
    } else if call.power && !call.is_on("was") && preset > 0 {
        run = true;
        elapsed = 0;
    }
    if !run && !call.power {
        elapsed = 0;
    }
    call.set("ET", elapsed);
    call.set("run", run);
    call.set("Q", run);
    call.set("was", call.power);
}

fn build(logic: &mut Logic) {
    let (power, tick) = (logic.power, logic.tick);
    let (preset, elapsed, run) = (logic.get("PT"), logic.get("ET"), logic.get("run"));
    let zero = logic.constant("ET", 0);
    let below = logic.circuit.less(elapsed, preset, true);
    let count = logic.circuit.and([tick, below]);
    let counted = logic.count_up(elapsed, count);
    let goes_on = logic.circuit.less(counted, preset, true);
    let rise = logic.rise(power, "was");
    let some = logic.circuit.less(zero, preset, true);
    let start = logic.circuit.and([rise, some]);
    let idle = logic.circuit.mux(start, zero, elapsed);
    let elapsed = logic.circuit.mux(run, counted, idle);
    let run = logic.circuit.mux(run, goes_on, start);
    let keep = logic.circuit.or([run, power]);
    let elapsed = logic.circuit.mux(keep, elapsed, zero);
    logic.set("ET", elapsed);
    logic.set("run", run);
    logic.set("Q", run);
    logic.set("was", power);
}
