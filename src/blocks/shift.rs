//! `SHL` and `SHR`, shift registers over a word or an array of words, which they change in place.

use super::{Block, Choice, Logic, Port, Setting, Step};
use crate::types::Type;

/// Words of the longest register.
const WORDS: usize = 32;
/// The words of the register as the program holds them, low word first.
const REG: [&str; WORDS] = [
    "REG0", "REG1", "REG2", "REG3", "REG4", "REG5", "REG6", "REG7", "REG8", "REG9", "REG10",
    "REG11", "REG12", "REG13", "REG14", "REG15", "REG16", "REG17", "REG18", "REG19", "REG20",
    "REG21", "REG22", "REG23", "REG24", "REG25", "REG26", "REG27", "REG28", "REG29", "REG30",
    "REG31",
];

/// The shift to the left.
pub const SHL: Block = Block {
    name: "SHL",
    title: "shift register to the left",
    doc: "With each rise of the power while EN is on, the register REG is shifted by one bit to the \
          left, in place: DATA enters at bit 0 of its first word, and Q is the bit that has left at \
          the top of its last word. Q stays until the next shift. EN off puts the register and Q to \
          0; rises are seen then and do not shift. A power that is on in the first scan shifts. (R \
          name) puts Q to 0 and keeps the register. Source: Shobha and Ramachandran, Realization \
          of Timers, Counters and Shift Registers for Programmable Controller Using Ladder Diagram, \
          shift left.",
    step: step_left,
    build: build_left,
    waves: &[
        "\
REG = 1
REG0 = 32769
IN   #_#_#_#
DATA __#___#
EN   ####_##
Q    ##_____
REG0 2255001",
        "\
REG = 2
REG0 = 32768
REG1 = 1
IN   #_
Q    __
REG0 00
REG1 33",
        "\
REG = 1
REG0 = 32769
IN   ###
(R)  _#_
Q    #__
REG0 222",
    ],
    ..SHIFT
};

/// The shift to the right.
pub const SHR: Block = Block {
    name: "SHR",
    title: "shift register to the right",
    doc: "With each rise of the power while EN is on, the register REG is shifted by one bit to the \
          right, in place: DATA enters at the top bit of its last word, and Q is the bit that has \
          left at bit 0 of its first word. Q stays until the next shift. EN off puts the register \
          and Q to 0; rises are seen then and do not shift. A power that is on in the first scan \
          shifts. (R name) puts Q to 0 and keeps the register. Source: Shobha and Ramachandran, \
          Realization of Timers, Counters and Shift Registers for Programmable Controller Using \
          Ladder Diagram, shift right.",
    step: step_right,
    build: build_right,
    waves: &[
        "\
REG = 1
REG0 = 3
IN   #_#_#
EN   #####
Q    ####_
REG0 11000",
        "\
REG = 1
REG0 = 1
IN         #_
DATA       #_
Q          ##
REG0-32760 88",
        "\
REG = 2
REG1 = 3
IN         #_
Q          __
REG0-32760 88
REG1       11",
    ],
    ..SHIFT
};

/// What the two have in common.
const SHIFT: Block = Block {
    name: "",
    title: "",
    doc: "",
    settings: &[Setting {
        name: "REG",
        choice: Choice::Register { most: WORDS },
        doc: "the register: a WORD or an array of WORD, low word first",
    }],
    ports: &ports(),
    main: Some("Q"),
    partner: None,
    can_reset: true,
    keeps: |_| None,
    step: step_left,
    build: build_left,
    waves: &[],
};

const fn ports() -> [Port; WORDS + 4] {
    let mut ports = [Port::memory("was", "the power at the call before"); WORDS + 4];
    ports[0] = Port::enable("lets the register shift; off, it puts it to 0");
    ports[1] = Port::circuit("DATA", "enters at the end that a shift leaves free");
    ports[2] = Port::output("Q", Type::Bool, "the bit that has left");
    let mut word = 0;
    while word < WORDS {
        let port = Port::register(REG[word], "a word of the register");
        ports[3 + word] = port.for_item("REG", word);
        word += 1;
    }
    ports
}

/// Shifts the words in an order; `shift` gives a word and the bit that leaves it, from a word and
/// the bit that enters.
fn step<'a>(
    call: &mut Step,
    words: impl Iterator<Item = &'a &'a str>,
    shift: impl Fn(i64, i64) -> (i64, i64),
) {
    let mut bit = call.get("DATA");
    let rise = call.power && !call.is_on("was");
    for word in words {
        if !call.is_on("EN") {
            call.set(word, 0);
        } else if rise {
            let (shifted, leaves) = shift(call.get(word), bit);
            call.set(word, shifted);
            bit = leaves;
        }
    }
    if !call.is_on("EN") {
        call.set("Q", 0);
    } else if rise {
        call.set("Q", bit);
    }
    call.set("was", call.power);
}

fn step_left(call: &mut Step) {
    let count = call.shape.list("REG").len();
    let shift = |word: i64, enters| (word << 1 & 0xFFFF | enters, word >> 15);
    step(call, REG[..count].iter(), shift);
}

fn step_right(call: &mut Step) {
    let count = call.shape.list("REG").len();
    let shift = |word: i64, enters: i64| (word >> 1 | enters << 15, word & 1);
    step(call, REG[..count].iter().rev(), shift);
}

/// The same as a circuit; in a step to the left the upper bit leaves.
fn build<'a>(logic: &mut Logic, words: impl Iterator<Item = &'a &'a str>, left: bool) {
    let (power, enable) = (logic.power, logic.get("EN"));
    let (mut bit, was_out) = (logic.get("DATA"), logic.get("Q"));
    let rise = logic.rise(power, "was");
    let no_bits = logic.circuit.constant(0, 16);
    for name in words {
        let word = logic.get(name);
        let (kept, leaves) = match left {
            true => (logic.circuit.slice(word, 0, 15), logic.circuit.slice(word, 15, 1)),
            false => (logic.circuit.slice(word, 1, 15), logic.circuit.slice(word, 0, 1)),
        };
        let parts = if left { [kept, bit] } else { [bit, kept] };
        let shifted = logic.circuit.concat(parts);
        let next = logic.circuit.mux(rise, shifted, word);
        let next = logic.circuit.mux(enable, next, no_bits);
        logic.set(name, next);
        bit = leaves;
    }
    let out = logic.circuit.mux(rise, bit, was_out);
    let off = logic.circuit.bit(false);
    // In the form of the words, whose enable and reset it shares.
    let out = logic.circuit.choice(enable, out, off);
    logic.set("Q", out);
    logic.set("was", power);
}

fn build_left(logic: &mut Logic) {
    let count = logic.shape.list("REG").len();
    build(logic, REG[..count].iter(), true);
}

fn build_right(logic: &mut Logic) {
    let count = logic.shape.list("REG").len();
    build(logic, REG[..count].iter().rev(), false);
}
