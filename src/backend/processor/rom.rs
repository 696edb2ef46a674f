//! What the processor's memories hold at reset, and what makes it an image that it can run.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

use super::word::{
    Address, CODE_WORDS, DRUMS, FIRST_FLAG, FIRST_OUTPUT, Illegal, ONE, Operation, Prefix,
    REGISTERS, SHIFTS, STACK_DEPTH, TAPS, UNITS, Word,
};

/// The contents of the memories at reset.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Rom {
    /// The words of the code memory from 0 on; the last one ends the scan.
    pub code: Vec<u16>,
    /// The registers that are not 0 at reset.
    pub registers: BTreeMap<u16, u16>,
    /// The bits of the image that are 1 at reset, without flag 1023.
    pub image: BTreeSet<Address>,
    /// The pins: how many inputs are sampled, from address 0 on, and how many outputs are shown,
    /// from address 256 on.
    pub pins: Pins,
    /// The length of a tick in nanoseconds, from which the units of the timers are made.
    pub tick_ns: u64,
}

/// How many bits go in and out in each scan.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Pins {
    /// 0 to 256.
    pub inputs: u16,
    /// 0 to 256.
    pub outputs: u16,
}

/// What keeps the processor from running an image, and where.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fault {
    /// The address in the code memory.
    pub at: usize,
    /// What is wrong there.
    pub kind: FaultKind,
}

/// What can be wrong with an image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FaultKind {
    /// A word without a meaning.
    Illegal(Illegal),
    /// More bits than stack 1 or 2 holds.
    Overflow(u8),
    /// A bit is taken from stack 1 or 2 and none is there.
    Underflow(u8),
    /// The constant 1 or an input is written.
    NotWritable(Address),
    /// A function lacks the prefix of that name.
    Missing(&'static str),
    /// A prefix has a number that this function does not take.
    Unfit(&'static str, u16),
    /// Two functions use the unit of that number.
    UnitTwice(u16),
    /// Taps of a drum or registers of a shift run over the end of their memory.
    OverTheEnd,
    /// No word ends the scan.
    NoEnd,
    /// Words follow the end of the scan.
    AfterEnd,
    /// More words than the code memory has.
    TooLong,
}

impl fmt::Display for FaultKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            FaultKind::Illegal(illegal) => illegal.fmt(f),
            FaultKind::Overflow(stack) => {
                write!(f, "stack {stack} would hold more than {STACK_DEPTH} bits")
            }
            FaultKind::Underflow(stack) => write!(f, "a bit is taken from the empty stack {stack}"),
            FaultKind::NotWritable(ONE) => write!(f, "flag {ONE} is the constant 1"),
            FaultKind::NotWritable(address) => write!(f, "{address} is an input"),
            FaultKind::Missing(prefix) => write!(f, "the prefix {prefix} is missing"),
            FaultKind::Unfit(prefix, number) => {
                write!(f, "the prefix {prefix} gives {number}, which this function does not take")
            }
            FaultKind::UnitTwice(unit) => write!(f, "unit {unit} is used by two functions"),
            FaultKind::OverTheEnd => f.write_str("it runs over the end of its memory"),
            FaultKind::NoEnd => f.write_str("no word ends the scan"),
            FaultKind::AfterEnd => f.write_str("words follow the end of the scan"),
            FaultKind::TooLong => write!(f, "the code memory has {CODE_WORDS} words"),
        }
    }
}

impl Rom {
    /// Everything that keeps the processor from running it, in the order of the words. There are
    /// no jumps, so all of it is known before it runs.
    pub fn faults(&self) -> Vec<Fault> {
        let mut check = Check::default();
        let mut ended = None;
        for (at, &bits) in self.code.iter().enumerate() {
            check.at = at;
            if ended.is_some() {
                check.fault(FaultKind::AfterEnd);
                break;
            }
            match Word::decode(bits) {
                Ok(Word::END) => ended = Some(at),
                Ok(word) => check.word(word),
                Err(illegal) => check.fault(FaultKind::Illegal(illegal)),
            }
        }
        check.at = self.code.len();
        if ended.is_none() {
            check.fault(FaultKind::NoEnd);
        }
        if self.code.len() > CODE_WORDS {
            check.at = CODE_WORDS;
            check.fault(FaultKind::TooLong);
        }
        check.faults
    }
}

/// What is known before a word.
#[derive(Default)]
struct Check {
    at: usize,
    faults: Vec<Fault>,
    /// How many bits each stack holds.
    depths: [usize; 2],
    /// The next contact starts a circuit.
    ended: bool,
    unit: Option<u16>,
    register: Option<u16>,
    number: Option<u16>,
    used: BTreeSet<(u8, u16)>,
}

impl Check {
    fn fault(&mut self, kind: FaultKind) {
        self.faults.push(Fault { at: self.at, kind });
    }

    fn word(&mut self, word: Word) {
        match word {
            Word::Contact { attribute, .. } => {
                if self.ended {
                    (self.depths, self.ended) = ([0, 0], false);
                }
                if attribute.up {
                    self.pop(2);
                }
                if attribute.pops_left() {
                    self.pop(1);
                }
                if attribute.pushes_left() {
                    self.push(1);
                }
                if attribute.ret {
                    self.push(2);
                }
            }
            Word::Output { operation, coil } => {
                self.ended = true;
                self.writable(coil);
                if operation.is_function() {
                    self.function(operation, coil);
                    (self.unit, self.register, self.number) = (None, None, None);
                }
            }
            Word::Prefix(Prefix::Enable | Prefix::Serial) => self.ended = true,
            Word::Prefix(Prefix::Unit { unit, .. }) => self.unit = Some(unit),
            Word::Prefix(Prefix::Register(register)) => self.register = Some(register),
            Word::Prefix(Prefix::Number(number)) => self.number = Some(number),
        }
    }

    fn push(&mut self, stack: u8) {
        let depth = &mut self.depths[usize::from(stack - 1)];
        *depth += 1;
        if *depth > STACK_DEPTH {
            *depth = STACK_DEPTH;
            self.fault(FaultKind::Overflow(stack));
        }
    }

    fn pop(&mut self, stack: u8) {
        let depth = &mut self.depths[usize::from(stack - 1)];
        match depth.checked_sub(1) {
            Some(less) => *depth = less,
            None => self.fault(FaultKind::Underflow(stack)),
        }
    }

    fn writable(&mut self, coil: Address) {
        if !(FIRST_OUTPUT..ONE).contains(&coil) {
            self.fault(FaultKind::NotWritable(coil));
        }
    }

    fn function(&mut self, operation: Operation, coil: Address) {
        let Some(register) = self.register else {
            return self.fault(FaultKind::Missing("REGISTER"));
        };
        let (class, units, numbers) = match operation {
            Operation::TimerSeconds
            | Operation::TimerTenths
            | Operation::CountUp
            | Operation::CountDown => (0, UNITS, None),
            Operation::Drum => (1, DRUMS, Some(0..=TAPS)),
            Operation::ShiftLeft | Operation::ShiftRight => (2, SHIFTS, Some(1..=SHIFTS)),
            _ => (3, 0, Some(0..=15)),
        };
        if units > 0 {
            match self.unit {
                None => self.fault(FaultKind::Missing("UNIT")),
                Some(unit) if unit >= units => self.fault(FaultKind::Unfit("UNIT", unit)),
                Some(unit) if !self.used.insert((class, unit)) => {
                    self.fault(FaultKind::UnitTwice(unit));
                }
                Some(_) => {}
            }
        }
        let Some(numbers) = numbers else { return };
        let Some(number) = self.number else { return self.fault(FaultKind::Missing("NUMBER")) };
        if !numbers.contains(&number) {
            return self.fault(FaultKind::Unfit("NUMBER", number));
        }
        let last = match operation {
            Operation::Drum => register.checked_add(number),
            Operation::ShiftLeft => register.checked_add(number - 1),
            Operation::ShiftRight => register.checked_sub(number - 1),
            _ => Some(register),
        };
        let ends_outside = last.is_none_or(|last| usize::from(last) >= REGISTERS);
        if ends_outside || (class == 1 && coil + number >= ONE) {
            self.fault(FaultKind::OverTheEnd);
        }
    }
}

/// What an address of the image is for.
pub fn region(address: Address) -> &'static str {
    match address {
        ONE => "constant 1",
        FIRST_FLAG.. => "flag",
        FIRST_OUTPUT.. => "output",
        _ => "input",
    }
}
