//! An image as a table for people.

use std::collections::BTreeSet;
use std::fmt::Write;

use super::emulator::clocks_of_scan;
use super::rom::{Rom, region};
use super::sizes::Sizes;
use super::word::{Address, Prefix, TimerType, Word};
use crate::quantity;

/// What a listing says besides the words.
pub struct Symbols<'a> {
    /// What each bit of the image is called, if it has a name.
    pub bit: &'a dyn Fn(Address) -> Option<String>,
    /// What each register is called.
    pub register: &'a dyn Fn(u16) -> Option<String>,
    /// The smallest processor that holds it.
    pub needs: Sizes,
    /// The line to be put before a word, such as the title of its rung.
    pub heading: &'a dyn Fn(usize) -> Option<String>,
}

/// The listing of an image that the processor can run.
pub fn listing(rom: &Rom, symbols: &Symbols<'_>) -> String {
    let mut text = String::new();
    let words = rom.code.len();
    let (inputs, outputs) = (rom.pins.inputs, rom.pins.outputs);
    writeln!(
        text,
        "{words} of {} words, {inputs} inputs, {outputs} outputs, a tick of {}",
        rom.sizes.code_words,
        quantity::time_text(rom.tick_ns.into())
    )
    .expect("fits");
    writeln!(text, "{} clocks a scan", clocks_of_scan(rom)).expect("fits");
    writeln!(text, "at least {}\n", needs(rom, symbols.needs)).expect("fits");
    writeln!(text, "addr  word  what       attribute            at").expect("fits");
    for (at, &bits) in rom.code.iter().enumerate() {
        if let Some(heading) = (symbols.heading)(at) {
            writeln!(text, "{heading}").expect("fits");
        }
        let Ok(word) = Word::decode(bits) else {
            writeln!(text, " {at:03X}  {bits:04X}  illegal").expect("fits");
            continue;
        };
        let (what, attribute, operand) = fields(word);
        let name = match word {
            Word::Contact { address, .. } => (symbols.bit)(address),
            Word::END => None,
            Word::Output { coil, .. } => (symbols.bit)(coil),
            Word::Prefix(Prefix::Register(register)) => (symbols.register)(register),
            Word::Prefix(_) => None,
        };
        let name = name.unwrap_or_default();
        let line =
            format!(" {at:03X}  {bits:04X}  {what:<9}  {attribute:<16}  {operand:>5}  {name}");
        writeln!(text, "{}", line.trim_end()).expect("fits");
    }
    contents(rom, symbols, &mut text);
    text
}

/// The parameters of the hardware that it needs.
fn needs(rom: &Rom, sizes: Sizes) -> String {
    let operations = rom.code.iter().filter_map(|&bits| match Word::decode(bits) {
        Ok(Word::Output { operation, .. }) => operation.parameter(),
        _ => None,
    });
    let functions: BTreeSet<&str> = operations.collect();
    let named = sizes.named().into_iter();
    // Without functions there is no register array.
    let sizes = named.filter(|(name, _)| *name != "REGISTERS" || !functions.is_empty());
    let mut parts: Vec<String> = sizes.map(|(name, size)| format!("{name} {size}")).collect();
    parts.push(match functions.is_empty() {
        true => "no functions".to_owned(),
        false => functions.into_iter().collect::<Vec<_>>().join(", "),
    });
    parts.join(", ")
}

/// What a word is, its attribute, and its address or number.
fn fields(word: Word) -> (&'static str, &'static str, String) {
    match word {
        Word::Contact { negated, attribute, address } => {
            (if negated { "NC" } else { "NO" }, attribute.name(), address.to_string())
        }
        Word::END => ("END", "", String::new()),
        Word::Output { operation, coil } => (operation.name(), "", coil.to_string()),
        Word::Prefix(Prefix::Enable) => ("prefix", "ENABLE", String::new()),
        Word::Prefix(Prefix::Serial) => ("prefix", "SERIAL", String::new()),
        Word::Prefix(Prefix::Unit { unit, timer }) => {
            let name = match timer {
                TimerType::OffDelay => "UNIT",
                TimerType::OnDelay => "UNIT, on-delay",
                TimerType::Interval => "UNIT, interval",
            };
            ("prefix", name, unit.to_string())
        }
        Word::Prefix(Prefix::Number(number)) => ("prefix", "NUMBER", number.to_string()),
        Word::Prefix(Prefix::Register(register)) => ("prefix", "REGISTER", register.to_string()),
    }
}

/// What registers and bits are at reset.
fn contents(rom: &Rom, symbols: &Symbols<'_>, text: &mut String) {
    if !rom.registers.is_empty() {
        writeln!(text, "\nregisters at reset").expect("fits");
        for (&register, &value) in &rom.registers {
            let name = (symbols.register)(register).unwrap_or_default();
            let line = format!("{register:>5}  {value:>5}  {name}");
            writeln!(text, "{}", line.trim_end()).expect("fits");
        }
    }
    if !rom.image.is_empty() {
        writeln!(text, "\nbits that are 1 at reset").expect("fits");
        for &address in &rom.image {
            let name = (symbols.bit)(address).unwrap_or_default();
            let line = format!("{address:>5}  {} {name}", region(address));
            writeln!(text, "{}", line.trim_end()).expect("fits");
        }
    }
}
