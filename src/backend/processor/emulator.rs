//! Runs an image word by word, as the processor does, and counts its clocks.

use super::function::{self, Functions};
use super::rom::{Fault, Rom};
use super::word::{Address, Attribute, FIRST_OUTPUT, IMAGE_BITS, ONE, Operation, Prefix, Word};

/// Clocks of a scan besides one for each word, each input and each output: one to sample, two
/// until the first word is there, one behind the last output, one to show them.
pub const CLOCKS_AROUND: u64 = 5;

/// The clocks of each scan: there are no jumps, so all scans take the same.
pub fn clocks_of_scan(rom: &Rom) -> u64 {
    let mut number = 0;
    let mut clocks = CLOCKS_AROUND + u64::from(rom.pins.inputs) + u64::from(rom.pins.outputs);
    for &bits in &rom.code {
        clocks += 1;
        match Word::decode(bits) {
            Ok(Word::Prefix(Prefix::Number(given))) => number = given,
            Ok(Word::Output { operation, .. }) => clocks += function::clocks(operation, number),
            _ => {}
        }
    }
    clocks
}

/// A processor that runs an image.
#[derive(Clone, Debug)]
pub struct Machine<'r> {
    rom: &'r Rom,
    words: Vec<Word>,
    inputs: Vec<bool>,
    /// The state of the power circuit, for who wants to watch it.
    pub power: PowerCircuit,
    /// Every bit of the image.
    image: Vec<bool>,
    functions: Functions,
    next: usize,
    clocks: u64,
}

/// The power, the stacks and the latched circuits.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct PowerCircuit {
    /// The power in hand: at the left of the next contact.
    pub pwra: bool,
    /// Powers at the left ends of lists.
    pub stack1: Vec<bool>,
    /// Results of branches.
    pub stack2: Vec<bool>,
    /// The next contact starts a circuit.
    pub ended: bool,
}

impl PowerCircuit {
    /// A contact that conducts or not.
    fn contact(&mut self, attribute: Attribute, conducts: bool) {
        if self.ended {
            *self = PowerCircuit { pwra: true, ..PowerCircuit::default() };
        }
        let left = self.pwra;
        let mut right = left && conducts;
        let branch = attribute.up.then(|| pop(&mut self.stack2));
        if let Some(branch) = branch {
            right |= branch;
        }
        if attribute.pushes_left() {
            // Where the list above joins at this contact, its power comes back through it.
            let back = branch.is_some_and(|branch| conducts && branch);
            self.stack1.push(left || back);
        }
        if attribute.ret {
            self.stack2.push(right);
            right = if attribute.pops_left() { pop(&mut self.stack1) } else { left };
        }
        self.pwra = right;
    }
}

/// The image was checked before it runs.
fn pop(stack: &mut Vec<bool>) -> bool {
    stack.pop().expect("the image takes no more than was put")
}

impl<'r> Machine<'r> {
    /// The processor at reset, inputs 0.
    ///
    /// # Errors
    /// What the image has that the processor cannot run.
    pub fn new(rom: &'r Rom) -> Result<Self, Vec<Fault>> {
        let faults = rom.faults();
        if !faults.is_empty() {
            return Err(faults);
        }
        let words = rom.code.iter().map(|&bits| Word::decode(bits).expect("checked")).collect();
        let mut machine = Machine {
            rom,
            words,
            inputs: Vec::new(),
            power: PowerCircuit::default(),
            image: Vec::new(),
            functions: Functions::new(rom),
            next: 0,
            clocks: 0,
        };
        machine.reset();
        Ok(machine)
    }

    /// Back to reset, inputs to 0.
    pub fn reset(&mut self) {
        self.inputs = vec![false; self.rom.pins.inputs.into()];
        self.image = vec![false; IMAGE_BITS];
        self.image[usize::from(ONE)] = true;
        self.rom.image.iter().for_each(|&address| self.image[usize::from(address)] = true);
        self.functions = Functions::new(self.rom);
        self.power = PowerCircuit::default();
        self.next = self.words.len();
    }

    /// Drives an input from the next scan on.
    pub fn drive(&mut self, input: Address, value: bool) {
        self.inputs[usize::from(input)] = value;
    }

    /// An input as it is driven.
    pub fn driven(&self, input: Address) -> bool {
        self.inputs[usize::from(input)]
    }

    /// A bit of the image.
    pub fn bit(&self, address: Address) -> bool {
        self.image[usize::from(address)]
    }

    /// A register.
    pub fn register(&self, register: u16) -> u16 {
        self.functions.registers[usize::from(register)]
    }

    /// Writes a register, as a host does over the bus.
    pub fn write_register(&mut self, register: u16, value: u16) {
        self.functions.registers[usize::from(register)] = value;
    }

    /// The outputs as the pins show them after a scan.
    pub fn outputs(&self) -> impl Iterator<Item = bool> {
        (0..self.rom.pins.outputs).map(|output| self.bit(FIRST_OUTPUT + output))
    }

    /// Clocks of all scans so far.
    pub fn clocks(&self) -> u64 {
        self.clocks
    }

    /// One scan, with the tick or without.
    pub fn scan(&mut self, tick: bool) {
        self.begin(tick);
        while self.step().is_some() {}
    }

    /// Samples the inputs and stands before the first word.
    pub fn begin(&mut self, tick: bool) {
        let inputs = self.inputs.len();
        self.image[..inputs].copy_from_slice(&self.inputs);
        self.functions.begin(tick);
        self.power = PowerCircuit { ended: true, ..PowerCircuit::default() };
        self.next = 0;
        let pins = self.rom.pins;
        self.clocks += CLOCKS_AROUND + u64::from(pins.inputs) + u64::from(pins.outputs);
    }

    /// Executes the next word and returns its address; nothing at the end of the scan.
    pub fn step(&mut self) -> Option<usize> {
        let at = self.next;
        let word = *self.words.get(at)?;
        self.next += 1;
        self.clocks += 1;
        match word {
            Word::Contact { negated, attribute, address } => {
                let conducts = self.bit(address) != negated;
                self.power.contact(attribute, conducts);
                let held = self.power.stack1.len().max(self.power.stack2.len());
                assert!(held <= self.rom.sizes.stack_depth, "the image puts no more than fits");
            }
            Word::Output { operation, coil } => {
                self.power.ended = true;
                self.output(operation, coil);
            }
            Word::Prefix(prefix) => {
                self.power.ended |= matches!(prefix, Prefix::Enable | Prefix::Serial);
                self.functions.prefix(prefix, self.power.pwra);
            }
        }
        Some(at)
    }

    fn output(&mut self, operation: Operation, coil: Address) {
        let power = self.power.pwra;
        let coil = usize::from(coil);
        match operation {
            Operation::Coil => self.image[coil] = power,
            Operation::Inverted => self.image[coil] = !power,
            Operation::Set => self.image[coil] |= power,
            Operation::Reset => self.image[coil] &= !power,
            Operation::End => {}
            function => {
                self.clocks += self.functions.clocks(function);
                let result = self.functions.run(function, power);
                if let Some(value) = result.coil {
                    self.image[coil] = value;
                }
                for (tap, value) in result.taps.into_iter().enumerate() {
                    self.image[coil + 1 + tap] = value;
                }
            }
        }
    }
}
