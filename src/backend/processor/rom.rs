//! What the processor's memories hold at reset, and what makes it an image that it can run.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

use super::sizes::Sizes;
use super::word::{
    Address, DRUMS, FIRST_COUNT, FIRST_DRUM, FIRST_FLAG, FIRST_OUTPUT, Illegal, ONE, Operation,
    Prefix, REGISTERS, SHIFTS, TAPS, UNITS, Word,
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
    /// What the processor holds that is to run it.
    pub sizes: Sizes,
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
    /// More bits than stack 1 or 2 holds, and how many it does.
    Overflow(u8, usize),
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
    /// More words than the code memory has, and how many it has.
    TooLong(usize),
    /// The image is too small to have this bit.
    NoBit(Address),
    /// The register array is too small to have this register.
    NoRegister(u16),
}

impl fmt::Display for FaultKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            FaultKind::Illegal(illegal) => illegal.fmt(f),
            FaultKind::Overflow(stack, depth) => {
                write!(f, "stack {stack} would hold more than {depth} bits")
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
            FaultKind::TooLong(words) => write!(f, "the code memory has {words} words"),
            FaultKind::NoBit(bit) => {
                write!(f, "an image of this size has no {} {bit}", region(*bit))
            }
            FaultKind::NoRegister(register) => {
                write!(f, "a register array of this size has no register {register}")
            }
        }
    }
}

impl Rom {
    /// Everything that keeps the processor from running it, in the order of the words. There are
    /// no jumps, so all of it is known before it runs.
    pub fn faults(&self) -> Vec<Fault> {
        self.check().faults
    }

    /// The smallest processor that can run it, if one of its sizes can.
    pub fn needs(&self) -> Sizes {
        let needs = self.check().needs;
        Sizes { code_words: self.code.len().max(needs.code_words), ..needs }
    }

    fn check(&self) -> Check {
        let mut check = Check::new(self.sizes);
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
        self.image.iter().for_each(|&bit| check.bit(bit));
        self.registers.keys().for_each(|&register| check.registers(register, register));
        let Pins { inputs, outputs } = self.pins;
        check.bit(inputs.saturating_sub(1));
        check.bit(FIRST_OUTPUT + outputs.saturating_sub(1));
        if self.code.len() > self.sizes.code_words {
            check.at = self.sizes.code_words;
            check.fault(FaultKind::TooLong(self.sizes.code_words));
        }
        check
    }
}

/// What is known before a word.
struct Check {
    sizes: Sizes,
    /// What the words so far take of it.
    needs: Sizes,
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
    fn new(sizes: Sizes) -> Check {
        Check {
            sizes,
            needs: Sizes::LEAST,
            at: 0,
            faults: Vec::new(),
            depths: [0, 0],
            ended: false,
            unit: None,
            register: None,
            number: None,
            used: BTreeSet::new(),
        }
    }

    fn fault(&mut self, kind: FaultKind) {
        self.faults.push(Fault { at: self.at, kind });
    }

    fn word(&mut self, word: Word) {
        match word {
            Word::Contact { attribute, address, .. } => {
                self.bit(address);
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
                self.bit(coil);
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
        if *depth > self.sizes.stack_depth {
            *depth = self.sizes.stack_depth;
            self.fault(FaultKind::Overflow(stack, self.sizes.stack_depth));
        }
        self.needs.stack_depth = self.needs.stack_depth.max(self.depths[usize::from(stack - 1)]);
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

    fn bit(&mut self, address: Address) {
        self.needs.need_bit(address);
        if !self.sizes.has_bit(address) {
            self.fault(FaultKind::NoBit(address));
        }
    }

    fn registers(&mut self, first: u16, last: u16) {
        [first, last].into_iter().for_each(|register| self.needs.need_register(register));
        let missing = |register: &u16| !self.sizes.has_register(*register);
        if let Some(register) = (first..=last).find(missing) {
            self.fault(FaultKind::NoRegister(register));
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
                Some(unit) if class < 2 => {
                    let count = unit + if class == 0 { FIRST_COUNT } else { FIRST_DRUM };
                    self.registers(count, count);
                }
                Some(_) => {}
            }
        }
        let Some(numbers) = numbers else { return self.registers(register, register) };
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
        let Some(last) = last.filter(|last| usize::from(*last) < REGISTERS) else {
            return self.fault(FaultKind::OverTheEnd);
        };
        self.registers(register.min(last), register.max(last));
        if class == 1 {
            match coil + number {
                ONE.. => self.fault(FaultKind::OverTheEnd),
                last => self.bit(last),
            }
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
