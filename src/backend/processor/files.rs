//! The files of an image: code, registers and bits at reset, in each form, and back.

use std::fmt::Write;

use super::memory::{Form, Memory, Unreadable};
use super::rom::{Pins, Rom};
use super::sizes::Sizes;
use super::word::{Address, FIRST_FLAG, FIRST_OUTPUT, ONE, Word};

/// One of the processor's memories.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// The words.
    Code,
    /// What registers hold at reset.
    Registers,
    /// What bits of the image are at reset.
    Bits,
}

impl Part {
    /// Every memory.
    pub const ALL: [Part; 3] = [Part::Code, Part::Registers, Part::Bits];

    /// What stands behind the name of the program in the name of its file.
    pub fn suffix(self) -> &'static str {
        match self {
            Part::Code => "",
            Part::Registers => "_regs",
            Part::Bits => "_image",
        }
    }

    fn width(self) -> u32 {
        if self == Part::Bits { 1 } else { 16 }
    }

    fn depth(self, sizes: Sizes) -> usize {
        match self {
            Part::Code => sizes.code_words,
            Part::Registers => sizes.register_places(),
            Part::Bits => sizes.bit_places(),
        }
    }

    /// Reads a file of this memory in a processor of these sizes.
    ///
    /// # Errors
    /// Where it does not follow its form or does not fit the memory.
    pub fn read(self, form: Form, bytes: &[u8], sizes: Sizes) -> Result<Memory, Unreadable> {
        Memory::read(form, bytes, self.width(), self.depth(sizes))
    }
}

/// What the processor is built with for an image: a line for people that is read back. Sizes stand
/// there where they are not the default.
pub fn parameters(rom: &Rom) -> String {
    let Pins { inputs, outputs } = rom.pins;
    let mut line =
        format!("ladder processor: INPUTS {inputs}, OUTPUTS {outputs}, TICK_NS {}", rom.tick_ns);
    for ((name, size), (_, usual)) in rom.sizes.named().into_iter().zip(Sizes::default().named()) {
        if size != usual {
            write!(line, ", {name} {size}").expect("fits");
        }
    }
    line
}

/// A number of the line [`parameters`] in a text, by its name.
fn parameter(text: &str, name: &str) -> Option<u64> {
    let behind = text.split("ladder processor: ").nth(1)?.lines().next()?;
    let word = behind.split(name).nth(1)?.trim_start();
    word.split(|c: char| !c.is_ascii_digit()).next()?.parse().ok()
}

/// The sizes in the line [`parameters`] of a text; those of the papers where it has none.
pub fn sizes(text: &str) -> Sizes {
    let mut sizes = Sizes::default();
    for (name, _) in Sizes::default().named() {
        let size = parameter(text, name).and_then(|size| usize::try_from(size).ok());
        // Nobody writes such a line by hand: one that cannot be true says nothing.
        if let Some(size) = size {
            let _ = sizes.set(name, size);
        }
    }
    sizes
}

impl Rom {
    /// What a memory holds at reset.
    pub fn memory(&self, part: Part) -> Memory {
        let sizes = self.sizes;
        let mut memory = Memory::new(part.width(), part.depth(sizes));
        match part {
            Part::Code => memory.words.extend(self.code.iter().copied().enumerate()),
            Part::Registers => {
                let place = |at: &u16| sizes.place_of_register(*at);
                memory.words.extend(self.registers.iter().map(|(at, &value)| (place(at), value)));
            }
            Part::Bits => {
                let bits = self.image.iter().chain([&ONE]);
                memory.words.extend(bits.map(|&at| (sizes.place_of_bit(at), 1)));
            }
        }
        memory
    }

    /// The image of these memories of a processor of these sizes. Pins and tick are taken from a
    /// comment of the code's file where [`parameters`] stands there; else the pins are those that
    /// the words name, and a tick is 1 ms.
    pub fn of_memories(
        code: &Memory,
        registers: &Memory,
        bits: &Memory,
        sizes: Sizes,
        text: &str,
    ) -> Rom {
        let code = code.dense();
        let filled = |memory: &Memory| -> Vec<(usize, u16)> {
            let some = memory.words.iter().filter(|(_, word)| **word != 0);
            some.map(|(at, word)| (*at, *word)).collect()
        };
        let register = |(at, word)| (sizes.register_at(at), word);
        let number = |name: &str| parameter(text, name);
        let named = pins(&code);
        let pin = |name, otherwise: u16| {
            number(name)
                .and_then(|pins| u16::try_from(pins).ok())
                .filter(|pins| *pins <= 256)
                .unwrap_or(otherwise)
        };
        Rom {
            pins: Pins {
                inputs: pin("INPUTS", named.inputs),
                outputs: pin("OUTPUTS", named.outputs),
            },
            tick_ns: number("TICK_NS").unwrap_or(1_000_000),
            registers: filled(registers).into_iter().map(register).collect(),
            image: filled(bits)
                .into_iter()
                .map(|(at, _)| sizes.bit_at(at))
                .filter(|at| *at != ONE)
                .collect(),
            code,
            sizes,
        }
    }
}

/// As many pins as reach every input and output that a word names.
fn pins(code: &[u16]) -> Pins {
    let named = code.iter().filter_map(|&bits| match Word::decode(bits) {
        Ok(Word::Contact { address, .. }) => Some(address),
        Ok(Word::END) => None,
        Ok(Word::Output { coil, .. }) => Some(coil),
        _ => None,
    });
    let mut pins = Pins::default();
    for address in named {
        let address: Address = address;
        match address {
            FIRST_FLAG.. => {}
            FIRST_OUTPUT.. => pins.outputs = pins.outputs.max(address - FIRST_OUTPUT + 1),
            _ => pins.inputs = pins.inputs.max(address + 1),
        }
    }
    pins
}
