//! `AB_TON`, Allen-Bradley's on-delay timer.

use super::{Block, Logic, Port, Step, ab};

/// The on-delay timer of Allen-Bradley.
pub const AB_TON: Block = Block {
    name: "AB_TON",
    title: "on-delay timer of Allen-Bradley",
    doc: "ACC counts units of BASE while the power is on, until it is PRE or more: then DN comes on \
          and counting stops. When the power goes off, ACC and DN go back to 0. The power goes on \
          to the right as it is: there is no Q. EN is the power, TT is on while the timer is \
          timing. The tick of the scan in which the power comes on does not count. PRE and ACC may \
          be assigned anywhere; DN, once on, stays on if PRE grows. (R name) is RES: it puts ACC, \
          EN, TT and DN to 0, and a timer whose power is held starts again with the next tick. \
          Source: Rockwell Automation, SLC 500 Instruction Set and Logix 5000 General \
          Instructions, TON.",
    settings: ab::TIMER_SETTINGS,
    ports: PORTS,
    main: None,
    partner: None,
    can_reset: true,
    keeps: |_| None,
    step,
    build,
    waves: &[
        "\
PRE = 3
BASE = 1
IN  _#######__###_
EN  _#######__###_
TT  _###______###_
DN  ____####______
ACC 00123333000120",
        "\
PRE = 2
BASE = 2
IN   ########
tick ##_#####
TT   #####___
DN   _____###
ACC  00011222",
        "\
BASE = 1
IN  #######_
PRE 22225555
TT  ##______
DN  __#####_
ACC 01222220",
        "\
PRE = 0
BASE = 1
IN  _##_
TT  ____
DN  _##_
ACC 0000",
        "\
PRE = 3
ACC = 2
BASE = 1
IN  ###_
TT  #___
DN  _##_
ACC 2330",
        "\
PRE = 2
BASE = 1
IN  ######
(R) ___#__
EN  ###_##
TT  ##__#_
DN  __#__#
ACC 012012",
        "\
PRE = 32767
ACC = 32766
BASE = 1
IN        ####
TT        #___
DN        _###
ACC-32760 6777",
    ],
};

const PORTS: &[Port] = &ab::timer_ports(ab::accumulator());

fn step(call: &mut Step) {
    if !call.power {
        call.set("ACC", 0);
        call.set("fraction", 0);
        call.set("DN", 0);
    } else if !call.is_on("DN") {
        if call.is_on("was") && call.tick {
            ab::advance(call);
        }
        call.set("DN", call.get("ACC") >= call.preset("PRE"));
    }
    call.set("EN", call.power);
    call.set("TT", call.power && !call.is_on("DN"));
    call.set("was", call.power);
}

fn build(logic: &mut Logic) {
    let (power, tick) = (logic.power, logic.tick);
    let (preset, done, was) = (logic.preset("PRE"), logic.get("DN"), logic.get("was"));
    let not_done = logic.circuit.not(done);
    let timing = logic.circuit.and([power, was, not_done, tick]);
    let (units, ticks) = ab::advanced(logic, timing);
    let reached = logic.reached(units, preset);
    let done = logic.circuit.or([done, reached]);
    let done = logic.circuit.and([power, done]);
    let (no_units, no_ticks) = (logic.constant("ACC", 0), logic.constant("fraction", 0));
    let units = logic.circuit.mux(power, units, no_units);
    let ticks = logic.circuit.mux(power, ticks, no_ticks);
    let not_done = logic.circuit.not(done);
    let timing = logic.circuit.and([power, not_done]);
    logic.set("ACC", units);
    logic.set("fraction", ticks);
    logic.set("EN", power);
    logic.set("TT", timing);
    logic.set("DN", done);
    logic.set("was", power);
}
