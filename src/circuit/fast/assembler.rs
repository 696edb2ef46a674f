//! From operations to instructions: each made once, inversions put off until they are needed.

use std::collections::HashMap;

use super::code::{Instruction, Kind, Slot};

/// A condition: a slot, or the inverse of what it holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Bit {
    pub(super) slot: Slot,
    pub(super) inverted: bool,
}

impl Bit {
    pub(super) fn not(self) -> Bit {
        Bit { inverted: !self.inverted, ..self }
    }
}

/// Slots that are given, then instructions that write one slot each.
///
/// Conditions are all ones or all zeros in every lane; slot 0 holds 0.
#[derive(Debug, Default)]
pub(super) struct Assembler {
    /// What the first slots hold: constants, and 0 where something is put in later.
    pub(super) given: Vec<u64>,
    pub(super) instructions: Vec<Instruction>,
    constants: HashMap<u64, Slot>,
    made: HashMap<Instruction, Slot>,
    is_closed: bool,
}

/// Never.
pub(super) const OFF: Bit = Bit { slot: 0, inverted: false };

/// Always.
pub(super) const ON: Bit = Bit { slot: 0, inverted: true };

impl Assembler {
    /// The first slots: the constants, then `free` ones to put something in.
    pub(super) fn new(constants: impl IntoIterator<Item = u64>, free: usize) -> Assembler {
        let mut assembler = Assembler::default();
        for value in [0, u64::MAX].into_iter().chain(constants) {
            if !assembler.constants.contains_key(&value) {
                assembler.constants.insert(value, assembler.given.len() as Slot);
                assembler.given.push(value);
            }
        }
        assembler.given.resize(assembler.given.len() + free, 0);
        assembler.is_closed = true;
        assembler
    }

    /// The first free slot.
    pub(super) fn first_free(&self) -> Slot {
        self.constants.len() as Slot
    }

    /// The slot of a constant that was announced.
    pub(super) fn constant(&self, value: u64) -> Slot {
        self.constants[&value]
    }

    /// A condition that is in a slot.
    pub(super) fn bit(slot: Slot) -> Bit {
        Bit { slot, inverted: false }
    }

    pub(super) fn emit(&mut self, kind: Kind, from: [Slot; 3]) -> Slot {
        debug_assert!(self.is_closed);
        let instruction = Instruction { kind, from };
        let next = (self.given.len() + self.instructions.len()) as Slot;
        let slot = *self.made.entry(instruction).or_insert(next);
        if slot == next {
            self.instructions.push(instruction);
        }
        slot
    }

    pub(super) fn emit2(&mut self, kind: Kind, a: Slot, b: Slot) -> Slot {
        self.emit(kind, [a, b, a])
    }

    /// The slot that holds a condition as it is.
    pub(super) fn plain(&mut self, bit: Bit) -> Slot {
        match bit {
            Bit { slot, inverted: false } => slot,
            ON => self.constant(u64::MAX),
            Bit { slot, inverted: true } => {
                let ones = self.constant(u64::MAX);
                self.emit2(Kind::Xor, slot, ones)
            }
        }
    }

    /// All of them, two or more. With those that are inverted put together by their inverse, none
    /// has to be inverted by itself.
    pub(super) fn all(&mut self, bits: impl Iterator<Item = Bit>) -> Bit {
        let (inverted, plain): (Vec<Bit>, Vec<Bit>) =
            bits.filter(|&bit| bit != ON).partition(|bit| bit.inverted);
        if plain.contains(&OFF) {
            return OFF;
        }
        let plain = self.join(plain, Kind::And, Kind::And3);
        let inverted = self.join(inverted, Kind::Or, Kind::Or3);
        match (plain, inverted) {
            (None, None) => ON,
            (Some(slot), None) => Assembler::bit(slot),
            (None, Some(slot)) => Assembler::bit(slot).not(),
            (Some(a), Some(b)) => Assembler::bit(self.emit2(Kind::AndNot, a, b)),
        }
    }

    /// At least one of them.
    pub(super) fn any(&mut self, bits: impl Iterator<Item = Bit>) -> Bit {
        self.all(bits.map(Bit::not)).not()
    }

    fn join(&mut self, mut bits: Vec<Bit>, two: Kind, three: Kind) -> Option<Slot> {
        bits.sort_unstable_by_key(|bit| bit.slot);
        bits.dedup();
        let mut slots = bits.into_iter().map(|bit| bit.slot);
        let mut joined = slots.next()?;
        while let Some(a) = slots.next() {
            joined = match slots.next() {
                Some(b) => self.emit(three, [joined, a, b]),
                None => self.emit2(two, joined, a),
            };
        }
        Some(joined)
    }

    pub(super) fn xor(&mut self, a: Bit, b: Bit) -> Bit {
        let inverted = a.inverted != b.inverted;
        let slot = match (a.slot, b.slot) {
            (a, b) if a == b => 0,
            (0, other) | (other, 0) => other,
            (a, b) => self.emit2(Kind::Xor, a.min(b), a.max(b)),
        };
        Bit { slot, inverted }
    }

    pub(super) fn mux(&mut self, select: Bit, on: Bit, off: Bit) -> Bit {
        let (on, off) = if select.inverted { (off, on) } else { (on, off) };
        let select = Bit { inverted: false, ..select };
        if on == off {
            return on;
        }
        if select == OFF {
            return off;
        }
        if on == off.not() {
            return self.xor(select, off);
        }
        if on.slot == 0 || off.slot == 0 {
            // One side is fixed: a list of two does it, inverted or not.
            return match (on, off) {
                (Bit { slot: 0, inverted: true }, _) => self.any([select, off].into_iter()),
                (Bit { slot: 0, .. }, _) => self.all([select.not(), off].into_iter()),
                (_, Bit { inverted: true, .. }) => self.any([select.not(), on].into_iter()),
                (_, Bit { .. }) => self.all([select, on].into_iter()),
            };
        }
        let inverted = on.inverted && off.inverted;
        let (on, off) = if inverted { (on.not(), off.not()) } else { (on, off) };
        let (on, off) = (self.plain(on), self.plain(off));
        Bit { slot: self.emit(Kind::Mux, [select.slot, on, off]), inverted }
    }
}
