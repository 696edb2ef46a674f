//! The files of an image: code, registers and bits at reset, in each form, and back.

use super::memory::{Form, Memory, Unreadable};
use super::parameters::Parameters;
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

    /// The image of these memories. Where nothing says what the processor is built with, its pins
    /// are those that the words name, and a tick is 1 ms.
    pub fn of_memories(
        code: &Memory,
        registers: &Memory,
        bits: &Memory,
        parameters: &Parameters,
    ) -> Rom {
        let sizes = parameters.sizes;
        let code = code.dense();
        let filled = |memory: &Memory| -> Vec<(usize, u16)> {
            let some = memory.words.iter().filter(|(_, word)| **word != 0);
            some.map(|(at, word)| (*at, *word)).collect()
        };
        let register = |(at, word)| (sizes.register_at(at), word);
        let bit = |(at, _)| sizes.bit_at(at);
        let named = pins(&code);
        Rom {
            pins: Pins {
                inputs: parameters.inputs.unwrap_or(named.inputs),
                outputs: parameters.outputs.unwrap_or(named.outputs),
            },
            tick_ns: parameters.tick_ns.unwrap_or(1_000_000),
            registers: filled(registers).into_iter().map(register).collect(),
            image: filled(bits).into_iter().map(bit).filter(|at| *at != ONE).collect(),
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
