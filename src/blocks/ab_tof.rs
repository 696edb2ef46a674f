//! `AB_TOF`, Allen-Bradley's off-delay timer.

use super::{Block, Logic, Port, Start, Step, ab};

/// The off-delay timer of Allen-Bradley.
pub const AB_TOF: Block = Block {
    name: "AB_TOF",
    title: "off-delay timer of Allen-Bradley",
    doc: "DN comes on with the power and goes off when the power has been off for PRE units of \
          BASE. ACC is 0 while the power is on, and counts while it is off and DN is on. The power \
          goes on to the right as it is: there is no Q. EN is the power, TT is on while the timer \
          is timing. The tick of the scan in which the power goes off does not count. ACC starts \
          at the start of PRE: a power that is off in the first scan starts nothing. PRE and ACC \
          may be assigned anywhere. (R name) is an error: a RES makes an off-delay timer \
          unpredictable. Source: Rockwell Automation, SLC 500 Instruction Set and Logix 5000 \
          General Instructions, TOF.",
    settings: ab::TIMER_SETTINGS,
    ports: PORTS,
    main: None,
    partner: None,
    can_reset: false,
    keeps: |_| None,
    step,
    build,
    waves: &[
        "\
PRE = 3
BASE = 1
IN  _##_____#__#_____
EN  _##_____#__#_____
TT  ___###___##_###__
DN  _#####__#######__
ACC 30001233001001233",
        "\
PRE = 1
BASE = 2
IN   #_______
tick ##_#__##
TT   _#####__
DN   ######__
ACC  00000011",
        "\
PRE = 0
BASE = 1
IN  _##_
TT  ____
DN  _##_
ACC 0000",
        "\
BASE = 1
IN  #____
PRE 11155
TT  _#___
DN  ##___
ACC 00111",
    ],
};

const PORTS: &[Port] = &ab::timer_ports(
    Port::accumulator("ACC", None, "units of BASE that have been timed, PRE at the end")
        .starting_at(Start::Preset("PRE")),
);

fn step(call: &mut Step) {
    if call.power {
        call.set("ACC", 0);
        call.set("fraction", 0);
        call.set("DN", 1);
    } else if call.is_on("DN") {
        if !call.is_on("was") && call.tick {
            ab::advance(call);
        }
        call.set("DN", call.get("ACC") < call.preset("PRE"));
    }
    call.set("EN", call.power);
    call.set("TT", !call.power && call.is_on("DN"));
    call.set("was", call.power);
}

fn build(logic: &mut Logic) {
    let (power, tick) = (logic.power, logic.tick);
    let (preset, done, was) = (logic.preset("PRE"), logic.get("DN"), logic.get("was"));
    let (off, was_off) = (logic.circuit.not(power), logic.circuit.not(was));
    let timing = logic.circuit.and([off, was_off, done, tick]);
    let (units, ticks) = ab::advanced(logic, timing);
    let (no_units, no_ticks) = (logic.constant("ACC", 0), logic.constant("fraction", 0));
    let short = logic.circuit.less(units, preset, true);
    let goes_on = logic.circuit.and([done, short]);
    let units = logic.circuit.mux(power, no_units, units);
    let ticks = logic.circuit.mux(power, no_ticks, ticks);
    let done = logic.circuit.or([power, goes_on]);
    let timing = logic.circuit.and([off, done]);
    logic.set("ACC", units);
    logic.set("fraction", ticks);
    logic.set("EN", power);
    logic.set("TT", timing);
    logic.set("DN", done);
    logic.set("was", power);
}
