//! `T1_0`, `T0_1` and `T_01`, Modicon's timers: one timing circuit, one enable circuit, both
//! outputs.

use super::{Block, Logic, Port, Step, UNIT_PRESETS};
use crate::types::Type;

/// A timer that counts a unit of so many nanoseconds.
const fn timer(name: &'static str, title: &'static str, ports: &'static [Port; 7]) -> Block {
    Block {
        name,
        title,
        doc: "ACC counts the units of time in which the power and EN are on, up to PV, and keeps \
              its value while the power is off. EN off puts it to 0. Q, which goes on to the \
              right, is on while ACC is PV or more, and QN while Q is off, both also without \
              power. The pulses of the unit are the same for all blocks and run free: the first \
              unit is up to one unit short. A pulse counts if the power and EN are on and were on \
              at the call before. (R name) puts ACC to 0; Q and QN are off then until the next \
              call. Source: Modicon 984 instruction set, timers.",
        settings: &[],
        ports,
        main: Some("Q"),
        partner: None,
        can_reset: true,
        keeps: |_| Some(&["EN"]),
        step,
        build,
        waves: WAVES,
    }
}

/// The timer of seconds.
pub const T1_0: Block = timer("T1_0", "timer of seconds", &ports(1_000_000_000));
/// The timer of tenths of a second.
pub const T0_1: Block = timer("T0_1", "timer of tenths of a second", &ports(100_000_000));
/// The timer of hundredths of a second.
pub const T_01: Block = timer("T_01", "timer of hundredths of a second", &ports(10_000_000));

const fn ports(unit_ns: u64) -> [Port; 7] {
    [
        Port::enable("lets ACC count; off, it puts ACC to 0"),
        Port::preset(
            "PV",
            Type::Int,
            UNIT_PRESETS,
            "how many units the power must have been on; negative acts as 0, more than 9999 as \
             9999",
        ),
        Port::pulse(unit_ns),
        Port::output("Q", Type::Bool, "ACC has reached PV"),
        Port::output("QN", Type::Bool, "ACC has not reached PV"),
        Port::output("ACC", Type::Int, "units with the power on, 0 to 9999"),
        Port::memory("ran", "the power and EN were on at the call before"),
    ]
}

/// The diagrams of a timer that counts while both circuits are on.
pub(super) const WAVES: &[&str] = &[
    "\
PV = 3
IN  _#######__##__
EN  ###########_##
Q   ____#######___
QN  ####_______###
ACC 00123333333000",
    "\
PV = 3
IN  ##_____###__
Q   _________###
QN  #########___
ACC 011111112333",
    "\
PV = 2
IN   #######_
unit ##_#_##_
Q    ___#####
QN   ###_____
ACC  01122222",
    "\
PV = 2
IN  ######
EN  __####
Q   ____##
QN  ####__
ACC 000122",
    "\
PV = 2
IN  ######_
(R) ___#___
Q   __#__##
QN  ##__#__
ACC 0120122",
    "\
PV = 0
IN  _#_
EN  ##_
Q   ###
QN  ___
ACC 000",
    "\
PV = 10000
ACC = 9998
IN       ###
Q        _##
QN       #__
ACC-9990 899",
];

/// Both circuits are on.
pub(super) fn step(call: &mut Step) {
    let (preset, mut units) = (call.preset("PV"), call.get("ACC"));
    let runs = call.power && call.is_on("EN");
    if !call.is_on("EN") {
        units = 0;
    } else if runs && call.is_on("ran") && call.is_on("unit") && units < preset {
        units += 1;
    }
    call.set("ACC", units);
    call.set("Q", units >= preset);
    call.set("QN", units < preset);
    call.set("ran", runs);
}

pub(super) fn build(logic: &mut Logic) {
    let (power, enable, unit) = (logic.power, logic.get("EN"), logic.get("unit"));
    let (preset, units, ran) = (logic.preset("PV"), logic.get("ACC"), logic.get("ran"));
    let runs = logic.circuit.and([power, enable]);
    let below = logic.circuit.less(units, preset, true);
    let count = logic.circuit.and([runs, ran, unit, below]);
    let counted = logic.count_up(units, count);
    let zero = logic.constant("ACC", 0);
    let units = logic.circuit.mux(enable, counted, zero);
    let short = logic.circuit.less(units, preset, true);
    let q = logic.circuit.not(short);
    logic.set("ACC", units);
    logic.set("Q", q);
    logic.set("QN", short);
    logic.set("ran", runs);
}
