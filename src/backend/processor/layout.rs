//! Where the variables of a program live in the processor.

use std::collections::BTreeMap;

use super::rom::{Pins, region};
use super::shortage::{NoRoom, Shortages};
use super::sizes::{FIRST_OF_HALF, Sizes};
use super::word::{
    Address, DRUMS, FIRST_COUNT, FIRST_DRUM, FIRST_FLAG, FIRST_FREE, FIRST_OUTPUT, ONE, REGISTERS,
    SHIFTS, UNITS,
};
use crate::diagnostic::{Diagnostic, code};
use crate::index::index;
use crate::model::{Program, Role, VariableId};
use crate::source::Span;
use crate::types::Type;

/// Addresses, registers and units that a program takes, each in the order of the text, so that
/// they stay where they are from build to build.
#[derive(Clone, Debug)]
pub struct Layout {
    sizes: Sizes,
    /// The bit of each variable that has one.
    bits: Vec<Option<Address>>,
    /// The first register of each variable that has one.
    registers: Vec<Option<u16>>,
    /// What the user calls each bit that is taken, and each register.
    pub bit_names: BTreeMap<Address, String>,
    /// What each register holds.
    pub register_names: BTreeMap<u16, String>,
    next_preset: u16,
    next_word: u16,
    next_timer: u16,
    next_drum: u16,
    next_shift: u16,
    /// What there is too little of.
    pub(super) shortages: Shortages,
}

/// A class of units.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UnitClass {
    /// Timers and counters.
    Timer,
    /// Drum counters.
    Drum,
    /// Shifts.
    Shift,
}

impl Layout {
    /// Every `BOOL` that a program declares, and what its edge elements and blocks remember.
    ///
    /// # Errors
    /// More of them than there are addresses.
    pub fn new(program: &Program, sizes: Sizes) -> Result<Layout, Vec<Diagnostic>> {
        let mut layout = Layout {
            sizes,
            bits: vec![None; program.variables.len()],
            registers: vec![None; program.variables.len()],
            bit_names: BTreeMap::from([(ONE, "TRUE".to_owned())]),
            register_names: BTreeMap::new(),
            next_preset: 0,
            next_word: FIRST_FREE,
            next_timer: 0,
            next_drum: 0,
            next_shift: 0,
            shortages: Shortages::default(),
        };
        let mut findings = Vec::new();
        let bits = || program.variables.iter().filter(|(_, variable)| variable.ty == Type::Bool);
        for (id, variable) in bits() {
            if let Some(address) = variable.address {
                if !sizes.has_bit(address) {
                    let message =
                        format!("the ladder processor has no {} {address}", region(address));
                    let finding = Diagnostic::new(code::PROCESSOR_FULL, variable.span, message)
                        .label(format!("its image has {} bits", sizes.image_bits))
                        .help("leave `at` out, or build a processor with a larger IMAGE_BITS");
                    findings.push(finding);
                }
                layout.take(id, address, &variable.name);
            }
        }
        for (id, variable) in bits().filter(|(_, variable)| variable.address.is_none()) {
            let first = match variable.role {
                Role::Input => 0,
                Role::Output => FIRST_OUTPUT,
                Role::Local | Role::EdgeMemory | Role::FirstScan => FIRST_FLAG,
                // A block that the processor has gets its flags where it is called.
                Role::Member(..) => continue,
            };
            if let Ok(address) = layout.free_bits(first, 1, variable.span) {
                layout.take(id, address, &variable.name);
            }
        }
        findings.extend(layout.shortages.findings(sizes));
        if findings.is_empty() { Ok(layout) } else { Err(findings) }
    }

    fn take(&mut self, variable: VariableId, address: Address, name: &str) {
        self.bits[index(variable)] = Some(address);
        self.bit_names.insert(address, name.to_owned());
    }

    /// The first of so many free addresses in a row of the region that begins at `first`.
    fn free_bits(&mut self, first: Address, count: u16, span: Span) -> Result<Address, NoRoom> {
        let end = match first {
            0 => self.sizes.pins(),
            FIRST_OUTPUT => FIRST_OUTPUT + self.sizes.pins(),
            _ => FIRST_FLAG + 2 * self.sizes.pins() - 1,
        };
        let is_free = |address: &Address| {
            (*address..address + count).all(|bit| !self.bit_names.contains_key(&bit))
        };
        let found = (first..end).take_while(|address| address + count <= end).find(is_free);
        let what = match first {
            0 => "inputs",
            FIRST_OUTPUT => "outputs",
            _ => "flags",
        };
        let has = usize::from(end - first);
        found.ok_or_else(|| self.shortages.ask(what, has, count.into(), span))
    }

    /// The bit of a variable.
    pub fn bit(&self, variable: VariableId) -> Option<Address> {
        self.bits[index(variable)]
    }

    /// The first register of a variable.
    pub fn register(&self, variable: VariableId) -> Option<u16> {
        self.registers[index(variable)]
    }

    /// Flags in a row for variables of a block.
    pub fn flags(
        &mut self,
        variables: &[(VariableId, String)],
        span: Span,
    ) -> Result<Address, NoRoom> {
        let first = self.free_bits(FIRST_FLAG, variables.len() as u16, span)?;
        for (address, (variable, name)) in (first..).zip(variables) {
            self.take(*variable, address, name);
        }
        Ok(first)
    }

    /// A flag for a value between two circuits.
    pub fn flag(&mut self, name: String, span: Span) -> Result<Address, NoRoom> {
        let address = self.free_bits(FIRST_FLAG, 1, span)?;
        self.bit_names.insert(address, name);
        Ok(address)
    }

    /// Registers in a row for presets.
    pub fn presets(&mut self, names: &[String], span: Span) -> Result<u16, NoRoom> {
        let first = self.next_preset;
        let most = self.sizes.quarter_of_registers();
        if usize::from(first) + names.len() > most {
            // What is left is too little for these, and what they lack of it counts.
            let left = most - usize::from(first);
            self.next_preset = most as u16;
            let lacks = names.len() - left;
            return Err(self.shortages.ask("registers for presets", most, lacks, span));
        }
        self.next_preset += names.len() as u16;
        for (register, name) in (first..).zip(names) {
            self.register_names.insert(register, name.clone());
        }
        Ok(first)
    }

    /// Registers for words that the program changes.
    pub fn words(&mut self, names: &[String], span: Span) -> Result<u16, NoRoom> {
        let many = names.len();
        let holds = |first: &u16| {
            let last = u16::try_from(usize::from(*first) + many - 1);
            last.is_ok_and(|last| self.sizes.has_registers(*first, last))
        };
        // Where the second quarter is smaller, words that do not fit there follow in the half.
        let Some(first) =
            [self.next_word, self.next_word.max(FIRST_OF_HALF)].into_iter().find(holds)
        else {
            let held = |from: u16| {
                (from..REGISTERS as u16).filter(|one| self.sizes.has_register(*one)).count()
            };
            // What is left is too little for these, and what they lack of it counts.
            let (count, left) = (held(FIRST_FREE), held(self.next_word));
            self.next_word = REGISTERS as u16;
            let lacks = many.saturating_sub(left).max(1);
            return Err(self.shortages.ask("registers for words", count, lacks, span));
        };
        self.next_word = first + many as u16;
        for (register, name) in (first..).zip(names) {
            self.register_names.insert(register, name.clone());
        }
        Ok(first)
    }

    /// Says where a number variable lives.
    pub fn place(&mut self, variable: VariableId, register: u16) {
        self.registers[index(variable)] = Some(register);
    }

    /// A unit of its own for a function.
    pub fn unit(&mut self, class: UnitClass, span: Span) -> Result<u16, NoRoom> {
        let sizes = self.sizes;
        // Each has a register for its count.
        let counts = |first: u16, most: u16| {
            (first..first + most).filter(|count| sizes.has_register(*count)).count() as u16
        };
        let (next, count, what) = match class {
            UnitClass::Timer => {
                (&mut self.next_timer, counts(FIRST_COUNT, UNITS), "timers and counters")
            }
            UnitClass::Drum => (&mut self.next_drum, counts(FIRST_DRUM, DRUMS), "drums"),
            UnitClass::Shift => (&mut self.next_shift, SHIFTS, "shift functions"),
        };
        if *next == count {
            return Err(self.shortages.ask(what, count.into(), 1, span));
        }
        *next += 1;
        Ok(*next - 1)
    }

    /// As many inputs and outputs as reach the highest address of each.
    pub fn pins(&self) -> Pins {
        let end = |from: Address, to: Address| {
            self.bit_names.range(from..to).next_back().map_or(0, |(&last, _)| last + 1 - from)
        };
        Pins { inputs: end(0, FIRST_OUTPUT), outputs: end(FIRST_OUTPUT, FIRST_FLAG) }
    }
}
