//! The sizes of the processor's memories. An address means the same in a machine of every size; a
//! smaller one has less of each region.

use std::str::FromStr;

use super::word::{
    Address, CODE_WORDS, FIRST_COUNT, FIRST_FLAG, FIRST_OUTPUT, IMAGE_BITS, ONE, REGISTERS,
    STACK_DEPTH,
};

/// The parameters of the hardware that say how much it holds; by default those of the papers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sizes {
    /// Words of the code memory, 2 to 1024.
    pub code_words: usize,
    /// Bits of the image, 8 to 1024: a quarter inputs, a quarter outputs, half flags.
    pub image_bits: usize,
    /// Registers, 8 to 2047: a quarter from 0 on, a quarter from 512 on, half from 1024 on.
    pub registers: usize,
    /// Bits of each stack, 2 to 16.
    pub stack_depth: usize,
}

impl Default for Sizes {
    fn default() -> Self {
        Sizes {
            code_words: CODE_WORDS,
            image_bits: IMAGE_BITS,
            registers: REGISTERS,
            stack_depth: STACK_DEPTH,
        }
    }
}

/// The first of the registers that take half of the array.
pub const FIRST_OF_HALF: u16 = 1024;

impl Sizes {
    /// The least that the hardware can be built with.
    pub const LEAST: Sizes = Sizes { code_words: 2, image_bits: 8, registers: 8, stack_depth: 2 };

    /// The most that words can address; deeper stacks than these are of no use.
    pub const MOST: Sizes = Sizes {
        code_words: CODE_WORDS,
        image_bits: IMAGE_BITS,
        registers: REGISTERS,
        stack_depth: 16,
    };

    /// The sizes with the names of the parameters.
    pub fn named(&self) -> [(&'static str, usize); 4] {
        [
            ("CODE_WORDS", self.code_words),
            ("IMAGE_BITS", self.image_bits),
            ("REGISTERS", self.registers),
            ("STACK_DEPTH", self.stack_depth),
        ]
    }

    /// Sets a size by the name of its parameter.
    ///
    /// # Errors
    /// If no size has this name, or none of the hardware is that large or small.
    pub fn set(&mut self, name: &str, value: usize) -> Result<(), String> {
        let names = Sizes::MOST.named().map(|(name, _)| name);
        let Some(index) = names.iter().position(|known| *known == name) else {
            return Err(format!("`{name}` is none of the sizes {}", names.join(", ")));
        };
        let (least, most) = (Sizes::LEAST.named()[index].1, Sizes::MOST.named()[index].1);
        if !(least..=most).contains(&value) {
            return Err(format!("{name} is {least} to {most}"));
        }
        let sizes = [
            &mut self.code_words,
            &mut self.image_bits,
            &mut self.registers,
            &mut self.stack_depth,
        ];
        *sizes.into_iter().nth(index).expect("each has a name") = value;
        Ok(())
    }

    fn quarter_of_image(&self) -> usize {
        self.image_bits.next_power_of_two() / 4
    }

    /// How many registers begin at 0, and how many at 512.
    pub(super) fn quarter_of_registers(&self) -> usize {
        self.registers.next_power_of_two() / 4
    }

    /// How many inputs there are, how many outputs.
    pub fn pins(&self) -> u16 {
        self.quarter_of_image() as u16
    }

    /// True if the image has this bit.
    pub fn has_bit(&self, address: Address) -> bool {
        let (from, many) = match address {
            ONE => return true,
            // The last one is the constant 1.
            FIRST_FLAG.. => (FIRST_FLAG, 2 * self.quarter_of_image() - 1),
            FIRST_OUTPUT.. => (FIRST_OUTPUT, self.quarter_of_image()),
            _ => (0, self.quarter_of_image()),
        };
        usize::from(address - from) < many
    }

    /// True if the array has this register.
    pub fn has_register(&self, register: u16) -> bool {
        let (from, many) = match register {
            FIRST_OF_HALF.. => (FIRST_OF_HALF, 2 * self.quarter_of_registers()),
            FIRST_COUNT.. => (FIRST_COUNT, self.quarter_of_registers()),
            _ => (0, self.quarter_of_registers()),
        };
        usize::from(register) < REGISTERS && usize::from(register - from) < many
    }

    /// True if the array has all of these registers.
    pub fn has_registers(&self, first: u16, last: u16) -> bool {
        (first..=last).all(|register| self.has_register(register))
    }

    /// The place of a bit in the memory.
    pub(super) fn place_of_bit(&self, address: Address) -> usize {
        let quarter = self.quarter_of_image();
        if address == ONE { 4 * quarter - 1 } else { place(address, FIRST_OUTPUT, quarter) }
    }

    /// The bit at a place of the memory.
    pub(super) fn bit_at(&self, place: usize) -> Address {
        let quarter = self.quarter_of_image();
        if place == 4 * quarter - 1 { ONE } else { address(place, FIRST_OUTPUT, quarter) }
    }

    /// The place of a register in the memory.
    pub(super) fn place_of_register(&self, register: u16) -> usize {
        place(register, FIRST_COUNT, self.quarter_of_registers())
    }

    /// The register at a place of the memory.
    pub(super) fn register_at(&self, place: usize) -> u16 {
        address(place, FIRST_COUNT, self.quarter_of_registers())
    }

    /// The places of the memory that holds the image.
    pub(super) fn bit_places(&self) -> usize {
        self.image_bits.next_power_of_two()
    }

    /// The places of the memory that holds the registers; the last of all 2048 has no register.
    pub(super) fn register_places(&self) -> usize {
        self.registers.next_power_of_two().min(REGISTERS)
    }

    /// Grows until it has this bit.
    pub(super) fn need_bit(&mut self, address: Address) {
        while !self.has_bit(address) {
            self.image_bits = 2 * self.bit_places();
        }
    }

    /// Grows until it has this register.
    pub(super) fn need_register(&mut self, register: u16) {
        while !self.has_register(register) && self.registers < REGISTERS {
            self.registers = (2 * self.registers.next_power_of_two()).min(REGISTERS);
        }
    }
}

/// The place of an address in a memory with this quarter; the second quarter begins at the address
/// `second` when no address is left out.
fn place(address: u16, second: u16, quarter: usize) -> usize {
    let (address, second) = (usize::from(address), usize::from(second));
    match address / second {
        0 => address % quarter,
        1 => quarter + (address - second) % quarter,
        _ => 2 * quarter + (address - 2 * second) % (2 * quarter),
    }
}

fn address(place: usize, second: u16, quarter: usize) -> u16 {
    let address = match place / quarter {
        0 => place,
        1 => usize::from(second) + place - quarter,
        _ => 2 * usize::from(second) + place - 2 * quarter,
    };
    address as u16
}

impl FromStr for Sizes {
    type Err = String;

    /// Such as `CODE_WORDS=256,REGISTERS=64`; what is not named is as large as in the papers.
    fn from_str(text: &str) -> Result<Self, String> {
        let mut sizes = Sizes::default();
        for pair in text.split(',') {
            let number = pair.split_once('=').and_then(|(name, value)| {
                value.trim().parse().ok().map(|value| (name.trim(), value))
            });
            let Some((name, value)) = number else {
                return Err(format!("`{pair}` is not of the form CODE_WORDS=256"));
            };
            sizes.set(name, value)?;
        }
        Ok(sizes)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_memory_has_stands_in_places_of_its_own() {
        for bits in 3..=10 {
            let sizes = Sizes { image_bits: 1 << bits, registers: 1 << bits, ..Sizes::default() };
            let held: Vec<u16> = (0..=ONE).filter(|bit| sizes.has_bit(*bit)).collect();
            assert_eq!(held.len(), 1 << bits);
            for (at, &bit) in held.iter().enumerate() {
                assert_eq!((sizes.place_of_bit(bit), sizes.bit_at(at)), (at, bit));
            }
            let held: Vec<u16> = (0..2047).filter(|place| sizes.has_register(*place)).collect();
            assert_eq!(held.len(), 1 << bits);
            for (at, &register) in held.iter().enumerate() {
                assert_eq!(
                    (sizes.place_of_register(register), sizes.register_at(at)),
                    (at, register)
                );
            }
        }
    }

    #[test]
    fn the_papers_sizes_leave_every_address_where_it_is() {
        let sizes = Sizes::default();
        assert!((0..=ONE).all(|bit| sizes.place_of_bit(bit) == usize::from(bit)));
        assert!((0..2047).all(|place| sizes.place_of_register(place) == usize::from(place)));
        assert!((0..2047).all(|place| sizes.has_register(place)) && !sizes.has_register(2047));
        assert_eq!((sizes.bit_places(), sizes.register_places()), (1024, 2047));
    }

    #[test]
    fn it_grows_no_more_than_it_has_to() {
        for (bit, needed) in [(0, 8), (1, 8), (2, 16), (257, 8), (258, 16), (514, 8), (515, 16)] {
            let mut sizes = Sizes::LEAST;
            sizes.need_bit(bit);
            assert_eq!(sizes.image_bits, needed, "bit {bit}");
        }
        for (register, needed) in [(1, 8), (2, 16), (513, 8), (592, 512), (1027, 8), (2046, 2047)] {
            let mut sizes = Sizes::LEAST;
            sizes.need_register(register);
            assert_eq!(sizes.registers, needed, "register {register}");
        }
    }

    #[test]
    fn a_size_that_cannot_be_built_is_refused() {
        let sizes: Sizes = "CODE_WORDS=256, STACK_DEPTH=6".parse().unwrap();
        assert_eq!(sizes, Sizes { code_words: 256, stack_depth: 6, ..Sizes::default() });
        for wrong in ["", "CODE_WORDS", "CODE_WORDS=1", "REGISTERS=2048", "CODE=4", "IMAGE_BITS=x"]
        {
            assert!(wrong.parse::<Sizes>().is_err(), "{wrong}");
        }
    }
}
