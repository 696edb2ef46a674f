//! `TS` and `TT`, the function paper's timers of seconds and tenths in three modes.

use super::{Block, Choice, Logic, Port, Setting, Step, UNIT_PRESETS, unit_timer};
use crate::circuit::Net;
use crate::types::Type;

const fn timer(name: &'static str, title: &'static str, ports: &'static [Port; 9]) -> Block {
    Block {
        name,
        title,
        doc: "MODE := ON counts like T1_0 (TS) and T0_1 (TT): ACC grows with the units of time in which the power \
              and EN are on, Q comes on when it reaches PV. MODE := OFF is an off-delay: Q comes \
              on with the power and goes off when the power has been off for PV units. MODE := \
              INTERVAL is a pulse: Q is on for PV units from the rise of the power. QN is the \
              opposite of Q. EN off puts ACC to 0 and ends a delay or a pulse; a power that is on \
              when EN comes on again starts no pulse. The pulses of the unit are the same for all \
              blocks and run free. A pulse counts if the power and EN are on and were on at the \
              call before; in the other modes those of the scan in which the delay or the pulse \
              starts do not count. (R name) puts ACC to 0 and ends a delay or a pulse; Q and QN \
              are off then until the next call. Source: Shobha and Ramachandran, Realization of \
              Timers, Counters and Shift Registers for Programmable Controller Using Ladder \
              Diagram, timer_type 01, 00 and 1x.",
        settings: &[Setting {
            name: "MODE",
            choice: Choice::Word(&["ON", "OFF", "INTERVAL"]),
            doc: "on-delay, off-delay or pulse",
        }],
        ports,
        main: Some("Q"),
        partner: None,
        can_reset: true,
        keeps: |shape| (shape.word("MODE") == "ON").then_some(&["EN"]),
        step,
        build,
        waves: WAVES,
    }
}

/// The timer of seconds.
pub const TS: Block = timer("TS", "timer of seconds in three modes", &ports(1_000_000_000));
/// The timer of tenths of a second.
pub const TT: Block =
    timer("TT", "timer of tenths of a second in three modes", &ports(100_000_000));

const fn ports(unit_ns: u64) -> [Port; 9] {
    [
        Port::enable("off, it holds the timer in its reset state"),
        Port::preset(
            "PV",
            Type::Int,
            UNIT_PRESETS,
            "the delay or the length of the pulse, in units; negative acts as 0, more than 9999 \
             as 9999",
        ),
        Port::pulse(unit_ns),
        Port::output("Q", Type::Bool, "the power, delayed, prolonged or as a pulse"),
        Port::output("QN", Type::Bool, "the opposite of Q"),
        Port::output("ACC", Type::Int, "units counted, 0 to 9999"),
        Port::state("run", "a delay or a pulse runs"),
        Port::memory("was", "the power at the call before"),
        Port::memory("ran", "the power and EN were on at the call before"),
    ]
}

/// The on-delay ones are those of the timers of one mode.
const WAVES: &[&str] = &[
    unit_timer::WAVES[0],
    "\
MODE = OFF
PV = 3
IN  _##_____#__#_____
Q   _#####__#######__
QN  #_____##_______##
ACC 00001233001001233",
    "\
MODE = INTERVAL
PV = 3
IN  _#####_#_#__
Q   _###___###__
QN  #___###___##
ACC 001233001200",
    unit_timer::WAVES[1],
    unit_timer::WAVES[2],
    unit_timer::WAVES[3],
    unit_timer::WAVES[4],
    unit_timer::WAVES[5],
    unit_timer::WAVES[6],
    "\
MODE = OFF
PV = 2
IN  ##____###___
EN  ###_###_#__#
Q   ###___#_#___
QN  ___###_#_###
ACC 000000000000",
    "\
MODE = OFF
PV = 2
IN   #_______
unit ##__#_#_
Q    ######__
ACC  00001122",
    "\
MODE = OFF
PV = 0
IN  _##_
EN  ###_
Q   _##_
ACC 0000",
    "\
MODE = OFF
PV = 3
IN  ##__#____###
(R) _#_____#__#_
Q   #___###__#_#
QN  __##____#___
ACC 000000100000",
    "\
MODE = INTERVAL
PV = 3
IN  _########_##_
EN  ####__#######
Q   _###______###
ACC 0012000000012",
    "\
MODE = INTERVAL
PV = 1
IN  _###
EN  __##
Q   ____
ACC 0000",
    "\
MODE = INTERVAL
PV = 0
IN  _##_#
Q   _____
ACC 00000",
    "\
MODE = INTERVAL
PV = 3
IN  ###_#__##
(R) _#___#___
Q   #___#__##
QN  __##__#__
ACC 000000001",
];

fn step(call: &mut Step) {
    let (mode, power) = (call.shape.word("MODE"), call.power);
    if mode == "ON" {
        unit_timer::step(call);
        call.set("was", power);
        return;
    }
    let (preset, mut units, mut run) = (call.preset("PV"), call.get("ACC"), call.is_on("run"));
    let (was, unit) = (call.is_on("was"), call.is_on("unit"));
    let q;
    if !call.is_on("EN") {
        (units, run, q) = (0, false, false);
    } else if mode == "OFF" {
        if power {
            (units, run) = (0, true);
        } else if run {
            if was {
                units = 0;
            } else if unit && units < preset {
                units += 1;
            }
            run = units < preset;
        }
        q = power || run;
    } else {
        if run {
            if unit && units < preset {
                units += 1;
            }
            run = units < preset;
        } else if power && !was && preset > 0 {
            (units, run) = (0, true);
        }
        if !run && !power {
            units = 0;
        }
        q = run;
    }
    call.set("ACC", units);
    call.set("run", run);
    call.set("Q", q);
    call.set("QN", !q);
    call.set("was", power);
    call.set("ran", power && call.is_on("EN"));
}

fn build(logic: &mut Logic) {
    let (power, enable) = (logic.power, logic.get("EN"));
    let [units, run, q] = match logic.shape.word("MODE") {
        "ON" => return unit_timer::build(logic),
        "OFF" => off_delay(logic),
        _ => pulse(logic),
    };
    let zero = logic.constant("ACC", 0);
    let units = logic.circuit.mux(enable, units, zero);
    let run = logic.circuit.and([enable, run]);
    let q = logic.circuit.and([enable, q]);
    let not_q = logic.circuit.not(q);
    logic.set("ACC", units);
    logic.set("run", run);
    logic.set("Q", q);
    logic.set("QN", not_q);
    logic.set("was", power);
}

/// Elapsed units, whether the delay runs and the output, with EN on.
fn off_delay(logic: &mut Logic) -> [Net; 3] {
    let (power, unit) = (logic.power, logic.get("unit"));
    let (preset, units) = (logic.preset("PV"), logic.get("ACC"));
    let (run, was) = (logic.get("run"), logic.get("was"));
    let zero = logic.constant("ACC", 0);
    let below = logic.circuit.less(units, preset, true);
    let count = logic.circuit.and([run, unit, below]);
    let counted = logic.count_up(units, count);
    let starts = logic.circuit.and([run, was]);
    let off = logic.circuit.mux(starts, zero, counted);
    let units = logic.circuit.mux(power, zero, off);
    let short = logic.circuit.less(units, preset, true);
    let goes_on = logic.circuit.and([run, short]);
    let run = logic.circuit.or([power, goes_on]);
    [units, run, run]
}

/// The same for a pulse.
fn pulse(logic: &mut Logic) -> [Net; 3] {
    let (power, unit) = (logic.power, logic.get("unit"));
    let (preset, units, run) = (logic.preset("PV"), logic.get("ACC"), logic.get("run"));
    let zero = logic.constant("ACC", 0);
    let below = logic.circuit.less(units, preset, true);
    let count = logic.circuit.and([unit, below]);
    let counted = logic.count_up(units, count);
    let goes_on = logic.circuit.less(counted, preset, true);
    let rise = logic.rise(power, "was");
    let some = logic.circuit.less(zero, preset, true);
    let start = logic.circuit.and([rise, some]);
    let idle = logic.circuit.mux(start, zero, units);
    let units = logic.circuit.mux(run, counted, idle);
    let run = logic.circuit.mux(run, goes_on, start);
    let keep = logic.circuit.or([run, power]);
    let units = logic.circuit.mux(keep, units, zero);
    [units, run, run]
}
