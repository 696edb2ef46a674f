//! The words of the processor: 2 bits of code, 4 of attribute or operation, 10 of address or
//! number.

use std::fmt;

/// A place in the image.
pub type Address = u16;

/// Bits of the image.
pub const IMAGE_BITS: usize = 1024;
/// Words of the code memory.
pub const CODE_WORDS: usize = 1024;
/// Registers of 16 bits.
pub const REGISTERS: usize = 2047;
/// Bits that each of the two stacks holds.
pub const STACK_DEPTH: usize = 4;
/// Units for timers and counters.
pub const UNITS: u16 = 64;
/// Drum counters.
pub const DRUMS: u16 = 16;
/// Shift functions, and registers that one of them may cascade.
pub const SHIFTS: u16 = 32;
/// Taps of a drum.
pub const TAPS: u16 = 16;
/// The flag that is always 1.
pub const ONE: Address = 1023;
/// The first address of the outputs; below it are the inputs.
pub const FIRST_OUTPUT: Address = 256;
/// The first address of the flags.
pub const FIRST_FLAG: Address = 512;
/// The register of the count of unit 0; that of unit 1 is the next.
pub const FIRST_COUNT: u16 = 512;
/// The register of the count of drum 0.
pub const FIRST_DRUM: u16 = FIRST_COUNT + UNITS;
/// The first register that the hardware uses for nothing of its own.
pub const FIRST_FREE: u16 = FIRST_DRUM + DRUMS;

/// What a contact does with the stacks: its bits are the links at its ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Attribute {
    /// Keeps the power at its left in stack 1.
    pub open: bool,
    /// Joins the power at its right with the top of stack 2.
    pub up: bool,
    /// Ends a branch: the result goes to stack 2, the power at the left of the list comes back
    /// from stack 1.
    pub ret: bool,
}

/// The attribute of each code from 1 to 8, with its name.
const ATTRIBUTES: [(&str, Attribute); 8] = [
    ("NIL", Attribute { open: false, up: false, ret: false }),
    ("OPEN", Attribute { open: true, up: false, ret: false }),
    ("RETURN", Attribute { open: false, up: false, ret: true }),
    ("UP", Attribute { open: false, up: true, ret: false }),
    ("OPEN/UP", Attribute { open: true, up: true, ret: false }),
    ("OPEN/RETURN", Attribute { open: true, up: false, ret: true }),
    ("RETURN/UP", Attribute { open: false, up: true, ret: true }),
    ("OPEN/UP/RETURN", Attribute { open: true, up: true, ret: true }),
];

impl Attribute {
    /// The attribute with these three bits.
    pub fn new(open: bool, up: bool, ret: bool) -> Self {
        Attribute { open, up, ret }
    }

    /// The attribute of a code, if there is one.
    pub fn of_code(code: u16) -> Option<Self> {
        let index = usize::from(code).checked_sub(1)?;
        ATTRIBUTES.get(index).map(|(_, attribute)| *attribute)
    }

    fn index(self) -> usize {
        let place = ATTRIBUTES.iter().position(|(_, attribute)| *attribute == self);
        place.expect("every combination of the three has a code")
    }

    /// Its code, 1 to 8.
    pub fn code(self) -> u16 {
        self.index() as u16 + 1
    }

    /// Its name, such as `OPEN/RETURN`.
    pub fn name(self) -> &'static str {
        ATTRIBUTES[self.index()].0
    }

    /// True if it takes the power at the left of the list from stack 1. A single contact that is
    /// a branch of its own keeps that power in hand instead.
    pub fn pops_left(self) -> bool {
        self.ret && !self.open
    }

    /// True if it puts the power at its left on stack 1.
    pub fn pushes_left(self) -> bool {
        self.open && !self.ret
    }
}

/// What an output word does with the power.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operation {
    /// Timer in seconds.
    TimerSeconds,
    /// Timer in tenths of a second.
    TimerTenths,
    /// Up counter.
    CountUp,
    /// Down counter.
    CountDown,
    /// Sets a bit of a register when powered; the coil shows that the bit is 1.
    BitSet,
    /// Clears a bit of a register when powered; the coil shows that the bit is 0.
    BitClear,
    /// Drum counter with taps.
    Drum,
    /// Shifts registers towards their low end.
    ShiftRight,
    /// Shifts registers towards their high end.
    ShiftLeft,
    /// The coil follows the power.
    Coil,
    /// The coil becomes 1 when powered.
    Set,
    /// The coil becomes 0 when powered.
    Reset,
    /// The coil follows the inverted power.
    Inverted,
    /// The scan ends here.
    End,
}

/// The operations with their codes and names.
const OPERATIONS: [(u16, &str, Operation); 14] = [
    (0b0000, "TS", Operation::TimerSeconds),
    (0b0001, "TT", Operation::TimerTenths),
    (0b0010, "UC", Operation::CountUp),
    (0b0011, "DC", Operation::CountDown),
    (0b0100, "BIT SET", Operation::BitSet),
    (0b0101, "BIT CLEAR", Operation::BitClear),
    (0b0110, "DRUM", Operation::Drum),
    (0b0111, "SHIFT RIGHT", Operation::ShiftRight),
    (0b1000, "SHIFT LEFT", Operation::ShiftLeft),
    (0b1001, "COIL", Operation::Coil),
    (0b1010, "SET", Operation::Set),
    (0b1011, "RESET", Operation::Reset),
    (0b1100, "INVERTED", Operation::Inverted),
    (0b1111, "END", Operation::End),
];

impl Operation {
    /// The operation of a code, if there is one.
    pub fn of_code(code: u16) -> Option<Self> {
        OPERATIONS.iter().find(|(c, ..)| *c == code).map(|&(.., operation)| operation)
    }

    fn entry(self) -> (u16, &'static str) {
        let entry = OPERATIONS.iter().find(|(.., operation)| *operation == self);
        entry.map(|&(code, name, _)| (code, name)).expect("every operation is in the table")
    }

    /// Its code, 4 bits.
    pub fn code(self) -> u16 {
        self.entry().0
    }

    /// Its name in listings.
    pub fn name(self) -> &'static str {
        self.entry().1
    }

    /// The parameter of the hardware without which it does nothing, if it is a function.
    pub fn parameter(self) -> Option<&'static str> {
        match self {
            Operation::TimerSeconds | Operation::TimerTenths => Some("TIMERS"),
            Operation::CountUp | Operation::CountDown => Some("COUNTERS"),
            Operation::Drum => Some("DRUMS"),
            Operation::ShiftRight | Operation::ShiftLeft => Some("SHIFTS"),
            Operation::BitSet | Operation::BitClear => Some("BITS"),
            Operation::Coil
            | Operation::Set
            | Operation::Reset
            | Operation::Inverted
            | Operation::End => None,
        }
    }

    /// True for what a prefix must give further numbers.
    pub fn is_function(self) -> bool {
        self.code() < Operation::Coil.code()
    }
}

/// What a prefix gives to the operation that follows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Prefix {
    /// The power so far is the enable circuit.
    Enable,
    /// The power so far is the serial data.
    Serial,
    /// The number of the unit, and with a timer its type.
    Unit {
        /// Timers and counters 0 to 63, drums 0 to 15, shifts 0 to 31.
        unit: u16,
        /// What a timer does; [`TimerType::OffDelay`] elsewhere.
        timer: TimerType,
    },
    /// A register: the preset; of those that are shifted the one where the serial data enters, the
    /// low word to the left and the high word to the right; the one with the bit.
    Register(u16),
    /// A number: of taps, of cascaded registers, or of the bit.
    Number(u16),
}

/// What a timer delays.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TimerType {
    /// The coil goes off later than the power.
    OffDelay,
    /// The coil comes on later than the power.
    OnDelay,
    /// The coil is on for the time, from the rise of the power.
    Interval,
}

impl TimerType {
    /// Its code, two bits; of the two codes for an interval the smaller.
    pub fn code(self) -> u16 {
        match self {
            TimerType::OffDelay => 0,
            TimerType::OnDelay => 1,
            TimerType::Interval => 2,
        }
    }

    fn of_code(code: u16) -> Self {
        match code & 3 {
            0 => TimerType::OffDelay,
            1 => TimerType::OnDelay,
            _ => TimerType::Interval,
        }
    }
}

/// One word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Word {
    /// A contact.
    Contact {
        /// Normally closed.
        negated: bool,
        /// Its links.
        attribute: Attribute,
        /// What it looks at.
        address: Address,
    },
    /// An output.
    Output {
        /// What it does.
        operation: Operation,
        /// The coil; 0 at the end of the scan.
        coil: Address,
    },
    /// Goes before a function.
    Prefix(Prefix),
}

/// Codes of prefixes.
const ENABLE: u16 = 0;
const SERIAL: u16 = 1;
const UNIT: u16 = 2;
const NUMBER: u16 = 3;
const REGISTER_LOW: u16 = 4;
const REGISTER_HIGH: u16 = 5;

impl Word {
    /// The end of the scan.
    pub const END: Word = Word::Output { operation: Operation::End, coil: 0 };

    /// The word as it stands in the code memory.
    pub fn encode(self) -> u16 {
        let word = |code: u16, field: u16, low: u16| code << 14 | field << 10 | low;
        match self {
            Word::Contact { negated, attribute, address } => {
                word(negated.into(), attribute.code(), address)
            }
            Word::Output { operation, coil } => word(2, operation.code(), coil),
            Word::Prefix(Prefix::Enable) => word(3, ENABLE, 0),
            Word::Prefix(Prefix::Serial) => word(3, SERIAL, 0),
            Word::Prefix(Prefix::Unit { unit, timer }) => word(3, UNIT, timer.code() << 8 | unit),
            Word::Prefix(Prefix::Number(number)) => word(3, NUMBER, number),
            Word::Prefix(Prefix::Register(register)) => {
                let kind = if register < 1024 { REGISTER_LOW } else { REGISTER_HIGH };
                word(3, kind, register & 1023)
            }
        }
    }

    /// What a word of the code memory means.
    ///
    /// # Errors
    /// What is illegal about it.
    pub fn decode(bits: u16) -> Result<Word, Illegal> {
        let (code, field, low) = (bits >> 14, bits >> 10 & 15, bits & 1023);
        match code {
            0 | 1 => {
                let attribute = Attribute::of_code(field).ok_or(Illegal::Attribute(field))?;
                Ok(Word::Contact { negated: code == 1, attribute, address: low })
            }
            2 => {
                let operation = Operation::of_code(field).ok_or(Illegal::Operation(field))?;
                if operation == Operation::End && low != 0 {
                    return Err(Illegal::Number(low));
                }
                Ok(Word::Output { operation, coil: low })
            }
            _ => Word::decode_prefix(field, low).map(Word::Prefix),
        }
    }

    fn decode_prefix(kind: u16, low: u16) -> Result<Prefix, Illegal> {
        let number = |is_legal: bool| if is_legal { Ok(low) } else { Err(Illegal::Number(low)) };
        match kind {
            ENABLE => number(low == 0).map(|_| Prefix::Enable),
            SERIAL => number(low == 0).map(|_| Prefix::Serial),
            UNIT => {
                let legal = low & !(3 << 8) < UNITS;
                number(legal)
                    .map(|low| Prefix::Unit { unit: low & 63, timer: TimerType::of_code(low >> 8) })
            }
            NUMBER => number(low <= SHIFTS).map(Prefix::Number),
            REGISTER_LOW => Ok(Prefix::Register(low)),
            REGISTER_HIGH => {
                number(usize::from(low) + 1024 < REGISTERS).map(|low| Prefix::Register(low + 1024))
            }
            _ => Err(Illegal::Prefix(kind)),
        }
    }
}

/// Why a word means nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Illegal {
    /// No attribute has this code.
    Attribute(u16),
    /// No operation has this code.
    Operation(u16),
    /// No prefix has this code.
    Prefix(u16),
    /// The low ten bits are out of range.
    Number(u16),
}

impl fmt::Display for Illegal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Illegal::Attribute(code) => write!(f, "no attribute has the code {code:04b}"),
            Illegal::Operation(code) => write!(f, "no operation has the code {code:04b}"),
            Illegal::Prefix(code) => write!(f, "no prefix has the code {code:04b}"),
            Illegal::Number(number) => write!(f, "{number} is out of range here"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_legal_word_comes_back() {
        let mut legal = 0_u32;
        for bits in 0..=u16::MAX {
            let Ok(word) = Word::decode(bits) else { continue };
            legal += 1;
            // An interval timer has two codes.
            let same = if bits & 0xFF00 == 0xCB00 { bits & !0x100 } else { bits };
            assert_eq!(word.encode(), same, "{bits:04X}");
        }
        // 2 x 8 contacts and 13 operations with any address, the end, and the prefixes.
        let prefixes = 1 + 1 + 4 * 64 + 33 + 1024 + 1023;
        assert_eq!(legal, (2 * 8 + 13) * 1024 + 1 + prefixes);
    }
}
