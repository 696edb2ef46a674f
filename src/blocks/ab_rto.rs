//! `AB_RTO`, Allen-Bradley's retentive timer.

use super::{Block, Logic, Port, Step, ab};

/// The retentive on-delay timer of Allen-Bradley.
pub const AB_RTO: Block = Block {
    name: "AB_RTO",
    title: "retentive timer of Allen-Bradley",
    doc: "ACC counts units of BASE while the power is on, until it is PRE or more: then DN comes on \
          and counting stops. While the power is off ACC, the fraction of a unit and DN stay as \
          they are. The power goes on to the right as it is: there is no Q. EN is the power, TT is \
          on while the timer is timing. The tick of a scan in which the power comes on does not \
          count. PRE and ACC may be assigned anywhere; DN, once on, stays on if PRE grows. (R \
          name) is RES: it puts ACC, EN, TT and DN to 0, and a timer whose power is held starts \
          again with the next tick. Source: Rockwell Automation, SLC 500 Instruction Set and Logix \
          5000 General Instructions, RTO and RES.",
    settings: ab::TIMER_SETTINGS,
    ports: PORTS,
    main: None,
    partner: None,
    can_reset: true,
    keeps: |_| Some(&[]),
    step,
    build,
    waves: &[
        "\
PRE = 3
BASE = 1
IN  _##_###____#_##
(R) ____________#__
EN  _##_###____#_##
TT  _##_##_______##
DN  ______######___
ACC 001112333333001",
        "\
PRE = 2
BASE = 2
IN  ##__####
TT  ##__###_
DN  _______#
ACC 00000112",
        "\
PRE = 2
BASE = 2
IN  #####
(R) _#___
EN  #_###
ACC 00011",
        "\
PRE = 3
BASE = 1
IN  #####
(R) __#__
TT  ##_##
ACC 01012",
        "\
BASE = 1
IN  ####
PRE 1155
TT  #___
DN  _###
ACC 0111",
        "\
SIZE = DINT
PRE = 2147483647
ACC = 2147483646
BASE = 1
IN             ###_
DN             _###
ACC-2147483640 6777",
    ],
};

const PORTS: &[Port] = &ab::timer_ports(ab::accumulator());

fn step(call: &mut Step) {
    if call.power && !call.is_on("DN") {
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
    let comes = logic.circuit.and([power, reached]);
    let done = logic.circuit.or([done, comes]);
    let not_done = logic.circuit.not(done);
    let timing = logic.circuit.and([power, not_done]);
    logic.set("ACC", units);
    logic.set("fraction", ticks);
    logic.set("EN", power);
    logic.set("TT", timing);
    logic.set("DN", done);
    logic.set("was", power);
}
