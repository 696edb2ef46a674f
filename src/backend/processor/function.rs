//! Timers, counters, drums, shifts and bits of registers.

use super::rom::Rom;
use super::word::{
    DRUMS, FIRST_COUNT, FIRST_DRUM, Operation, Prefix, REGISTERS, SHIFTS, TimerType, UNITS,
};

/// The largest preset and count of a timer or counter.
const LARGEST_COUNT: u16 = 9999;
/// The largest preset and count of a drum.
const LARGEST_STEP: u16 = 2047;

/// What an operation leaves.
#[derive(Debug, Default)]
pub(super) struct Outcome {
    /// The new value of the coil; nothing where it keeps its own.
    pub coil: Option<bool>,
    /// The coils of the taps.
    pub taps: Vec<bool>,
}

/// The register array, the units and what the prefixes have given.
#[derive(Clone, Debug)]
pub(super) struct Functions {
    pub registers: Vec<u16>,
    timers: Vec<Unit>,
    drums: Vec<Unit>,
    shifts: Vec<Unit>,
    tenths: Divider,
    seconds: Divider,
    enable: bool,
    serial: bool,
    unit: usize,
    timer: TimerType,
    register: u16,
    number: u16,
}

/// What a unit keeps besides its count.
#[derive(Clone, Copy, Debug, Default)]
struct Unit {
    /// Its circuit at the call before.
    was: bool,
    /// Its circuit and the enable circuit, both at the call before.
    was_enabled: bool,
    /// A delay or an interval runs.
    runs: bool,
}

/// Makes a pulse of every Nth tick.
#[derive(Clone, Copy, Debug)]
struct Divider {
    ticks: u64,
    count: u64,
    pulse: bool,
}

impl Divider {
    fn new(unit_ns: u64, tick_ns: u64) -> Self {
        // A tick that does not divide the unit gives no pulses; the compiler refuses it.
        let fits = tick_ns > 0 && unit_ns.is_multiple_of(tick_ns);
        Divider { ticks: if fits { unit_ns / tick_ns } else { 0 }, count: 0, pulse: false }
    }

    fn scan(&mut self, tick: bool) {
        self.count += u64::from(tick);
        self.pulse = tick && self.count == self.ticks;
        if self.pulse {
            self.count = 0;
        }
    }
}

impl Functions {
    /// Registers and units at reset.
    pub fn new(rom: &Rom) -> Self {
        let mut registers = vec![0; REGISTERS];
        for (&register, &value) in &rom.registers {
            registers[usize::from(register)] = value;
        }
        let units = |count: u16| vec![Unit::default(); count.into()];
        Functions {
            registers,
            timers: units(UNITS),
            drums: units(DRUMS),
            shifts: units(SHIFTS),
            tenths: Divider::new(100_000_000, rom.tick_ns),
            seconds: Divider::new(1_000_000_000, rom.tick_ns),
            enable: true,
            serial: false,
            unit: 0,
            timer: TimerType::OffDelay,
            register: 0,
            number: 0,
        }
    }

    /// The start of a scan.
    pub fn begin(&mut self, tick: bool) {
        self.tenths.scan(tick);
        self.seconds.scan(tick);
        (self.enable, self.serial) = (true, false);
    }

    /// Takes what a prefix gives.
    pub fn prefix(&mut self, prefix: Prefix, power: bool) {
        match prefix {
            Prefix::Enable => self.enable = power,
            Prefix::Serial => self.serial = power,
            Prefix::Unit { unit, timer } => (self.unit, self.timer) = (unit.into(), timer),
            Prefix::Register(register) => self.register = register,
            Prefix::Number(number) => self.number = number,
        }
    }

    /// Clocks of a function besides that of its word.
    pub fn clocks(&self, operation: Operation) -> u64 {
        clocks(operation, self.number)
    }

    /// Executes a function; the circuits that prefixes have latched are used up.
    pub fn run(&mut self, operation: Operation, power: bool) -> Outcome {
        let outcome = match operation {
            Operation::TimerSeconds => self.timer(power, self.seconds.pulse),
            Operation::TimerTenths => self.timer(power, self.tenths.pulse),
            Operation::CountUp => self.count_up(power),
            Operation::CountDown => self.count_down(power),
            Operation::Drum => self.drum(power),
            Operation::BitSet => self.bit(power, true),
            Operation::BitClear => self.bit(power, false),
            Operation::ShiftLeft => self.shift(power, true),
            Operation::ShiftRight => self.shift(power, false),
            Operation::Coil
            | Operation::Set
            | Operation::Reset
            | Operation::Inverted
            | Operation::End => unreachable!("no function"),
        };
        (self.enable, self.serial) = (true, false);
        outcome
    }

    /// The preset: 0 if its sign bit is set, never more than the largest.
    fn preset(&self, largest: u16) -> u16 {
        let preset = self.registers[usize::from(self.register)];
        if preset > i16::MAX as u16 { 0 } else { preset.min(largest) }
    }

    fn timer(&mut self, power: bool, pulse: bool) -> Outcome {
        let enable = self.enable;
        let preset = self.preset(LARGEST_COUNT);
        let count = usize::from(FIRST_COUNT) + self.unit;
        let unit = &mut self.timers[self.unit];
        let before = *unit;
        let old = self.registers[count];
        let counted = old + u16::from(pulse && old < preset);
        *unit = Unit { was: power, was_enabled: power && enable, runs: false };
        let (new, coil) = match self.timer {
            TimerType::OnDelay => {
                let counts = power && enable && before.was_enabled;
                let new = if !enable {
                    0
                } else if counts {
                    counted
                } else {
                    old
                };
                (new, new >= preset)
            }
            TimerType::OffDelay if !enable => (0, false),
            TimerType::OffDelay if power => {
                unit.runs = true;
                (0, true)
            }
            TimerType::OffDelay if before.runs => {
                let new = if before.was { 0 } else { counted };
                unit.runs = new < preset;
                (new, unit.runs)
            }
            TimerType::OffDelay => (old, false),
            TimerType::Interval if !enable => (0, false),
            TimerType::Interval => {
                let mut new = old;
                if before.runs {
                    new = counted;
                    unit.runs = new < preset;
                } else if power && !before.was {
                    (new, unit.runs) = (0, preset > 0);
                }
                if !unit.runs && !power {
                    new = 0;
                }
                (new, unit.runs)
            }
        };
        self.registers[count] = new;
        Outcome { coil: Some(coil), ..Outcome::default() }
    }

    fn count_up(&mut self, power: bool) -> Outcome {
        let (count, rises) = self.rise(power);
        let old = self.registers[count];
        let new = match self.enable {
            false => 0,
            true => old.wrapping_add(u16::from(rises && old != LARGEST_COUNT)),
        };
        self.registers[count] = new;
        let coil = new >= self.preset(LARGEST_COUNT);
        Outcome { coil: Some(coil), ..Outcome::default() }
    }

    fn count_down(&mut self, power: bool) -> Outcome {
        let (count, rises) = self.rise(power);
        let new = match self.enable {
            false => self.preset(LARGEST_COUNT),
            true => self.registers[count].saturating_sub(rises.into()),
        };
        self.registers[count] = new;
        Outcome { coil: Some(new == 0), ..Outcome::default() }
    }

    /// The register of the count of a timer unit, and whether its circuit rises.
    fn rise(&mut self, power: bool) -> (usize, bool) {
        let unit = &mut self.timers[self.unit];
        let rises = power && !unit.was;
        unit.was = power;
        (usize::from(FIRST_COUNT) + self.unit, rises)
    }

    fn drum(&mut self, power: bool) -> Outcome {
        let unit = &mut self.drums[self.unit];
        let rises = power && !unit.was;
        unit.was = power;
        let count = usize::from(FIRST_DRUM) + self.unit;
        let old = self.registers[count];
        let new = match self.enable {
            false => 0,
            true => old.wrapping_add(u16::from(rises && old != LARGEST_STEP)),
        };
        self.registers[count] = new;
        let tap = |tap: u16| new >= self.registers[usize::from(self.register + 1 + tap)];
        let taps: Vec<bool> = (0..self.number).map(tap).collect();
        let coil = new >= self.preset(LARGEST_STEP);
        Outcome { coil: Some(coil), taps }
    }

    fn bit(&mut self, power: bool, value: bool) -> Outcome {
        let register = &mut self.registers[usize::from(self.register)];
        let mask = 1 << self.number;
        if power {
            *register = if value { *register | mask } else { *register & !mask };
        }
        let coil = (*register & mask != 0) == value;
        Outcome { coil: Some(coil), ..Outcome::default() }
    }

    fn shift(&mut self, power: bool, left: bool) -> Outcome {
        let unit = &mut self.shifts[self.unit];
        let rises = power && !unit.was;
        unit.was = power;
        // It begins at the end where the serial data enters.
        let (begin, count) = (usize::from(self.register), usize::from(self.number));
        let first = if left { begin } else { begin + 1 - count };
        let registers = &mut self.registers[first..first + count];
        if !self.enable {
            registers.fill(0);
            return Outcome { coil: Some(false), ..Outcome::default() };
        }
        if !rises {
            return Outcome::default();
        }
        let mut carry = self.serial;
        let mut one = |register: &mut u16| {
            let out = *register & if left { 1 << 15 } else { 1 } != 0;
            *register = match left {
                true => *register << 1 | u16::from(carry),
                false => *register >> 1 | u16::from(carry) << 15,
            };
            carry = out;
        };
        match left {
            true => registers.iter_mut().for_each(&mut one),
            false => registers.iter_mut().rev().for_each(&mut one),
        }
        Outcome { coil: Some(carry), ..Outcome::default() }
    }
}

/// Clocks of an operation besides that of its word; some depend on what the prefix NUMBER gave.
pub(super) fn clocks(operation: Operation, number: u16) -> u64 {
    match operation {
        Operation::TimerSeconds
        | Operation::TimerTenths
        | Operation::CountUp
        | Operation::CountDown => 7,
        Operation::Drum => 7 + u64::from(number),
        Operation::BitSet | Operation::BitClear => 2,
        Operation::ShiftLeft | Operation::ShiftRight => 2 * u64::from(number),
        Operation::Coil
        | Operation::Set
        | Operation::Reset
        | Operation::Inverted
        | Operation::End => 0,
    }
}
