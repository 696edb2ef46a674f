//! The divider that makes a unit of time of the tick. No program calls it: the compiler makes one
//! for each unit that some block counts.

use super::{Block, Choice, Logic, Port, Setting, Step};
use crate::types::Type;

/// The divider of a unit of time.
pub const DIVIDER: Block = Block {
    name: "DIVIDER",
    title: "divider of the tick",
    doc: "Q is on in the scan of every Nth tick after reset. Source: the language reference, \
          units of time.",
    settings: &[Setting {
        name: "N",
        // The times are never looked up: the compiler says the number of ticks itself.
        choice: Choice::Time(&[], 1_000_000),
        doc: "ticks of one unit",
    }],
    ports: &[
        Port::output("Q", Type::Bool, "one unit of time has gone by"),
        Port::output("CV", Type::Dint, "ticks since then, 0 to N - 1"),
    ],
    main: Some("Q"),
    partner: None,
    can_reset: false,
    keeps: |_| None,
    step,
    build,
    waves: &[
        "\
N = 3
tick ####_#__##
IN   ##########
Q    __#_____#_
CV   1201122201",
        "\
N = 1
tick #_##_
IN   #####
Q    #_##_
CV   00000",
    ],
};

fn step(call: &mut Step) {
    let fires = call.tick && call.get("CV") + 1 == call.shape.number("N");
    if fires {
        call.set("CV", 0);
    } else if call.tick {
        call.set("CV", call.get("CV") + 1);
    }
    call.set("Q", fires);
}

fn build(logic: &mut Logic) {
    let (tick, count) = (logic.tick, logic.get("CV"));
    let (zero, last) = (logic.constant("CV", 0), logic.shape.number("N") - 1);
    let last = logic.constant("CV", last);
    let is_last = logic.circuit.eq(count, last);
    let fires = logic.circuit.and([tick, is_last]);
    let counted = logic.count_up(count, tick);
    let count = logic.circuit.mux(fires, zero, counted);
    logic.set("CV", count);
    logic.set("Q", fires);
}
