//! The files of an image: code, registers and bits at reset, in each form, and back.

use super::memory::{Form, Memory, Unreadable};
use super::rom::{Pins, Rom};
use super::word::{
    Address, CODE_WORDS, FIRST_FLAG, FIRST_OUTPUT, IMAGE_BITS, ONE, REGISTERS, Word,
};

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

    fn depth(self) -> usize {
        match self {
            Part::Code => CODE_WORDS,
            Part::Registers => REGISTERS,
            Part::Bits => IMAGE_BITS,
        }
    }

    /// Reads a file of this memory.
    ///
    /// # Errors
    /// Where it does not follow its form or does not fit the memory.
    pub fn read(self, form: Form, bytes: &[u8]) -> Result<Memory, Unreadable> {
        Memory::read(form, bytes, self.width(), self.depth())
    }
}

/// What the processor is built with for an image: a line for people that is read back.
pub fn parameters(rom: &Rom) -> String {
    let Pins { inputs, outputs } = rom.pins;
    format!("ladder processor: INPUTS {inputs}, OUTPUTS {outputs}, TICK_NS {}", rom.tick_ns)
}

impl Rom {
    /// What a memory holds at reset.
    pub fn memory(&self, part: Part) -> Memory {
        let mut memory = Memory::new(part.width(), part.depth());
        match part {
            Part::Code => memory.words.extend(self.code.iter().copied().enumerate()),
            Part::Registers => {
                memory.words.extend(self.registers.iter().map(|(&at, &value)| (at.into(), value)));
            }
            Part::Bits => {
                memory.words.extend(self.image.iter().chain([&ONE]).map(|&at| (at.into(), 1)));
            }
        }
        memory
    }

    /// The image of these memories. Pins and tick are taken from a comment of the code's file
    /// where [`parameters`] stands there; else the pins are those that the words name, and a tick
    /// is 1 ms.
    pub fn of_memories(code: &Memory, registers: &Memory, bits: &Memory, text: &str) -> Rom {
        let code = code.dense();
        let filled = |memory: &Memory| -> Vec<(u16, u16)> {
            let some = memory.words.iter().filter(|(_, word)| **word != 0);
            some.map(|(at, word)| (*at as u16, *word)).collect()
        };
        let number = |name: &str| -> Option<u64> {
            let behind = text.split("ladder processor: ").nth(1)?.lines().next()?;
            let word = behind.split(name).nth(1)?.trim_start();
            word.split(|c: char| !c.is_ascii_digit()).next()?.parse().ok()
        };
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
            registers: filled(registers).into_iter().collect(),
            image: filled(bits).into_iter().map(|(at, _)| at).filter(|at| *at != ONE).collect(),
            code,
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
