//! An image as a table for people, and as the ladder that it came from.

use std::collections::BTreeSet;
use std::fmt::Write;

use super::decode::decode;
use super::emulator::clocks_of_scan;
use super::rom::{Rom, region};
use super::sizes::Sizes;
use super::tree::{Contact, Tree};
use super::word::{Address, FIRST_FLAG, FIRST_OUTPUT, ONE, Operation, Prefix, TimerType, Word};
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

/// A ladder with the same image: a rung for each circuit, a name for each address. Nothing if
/// there is something in it that no nesting of series and parallel draws, with the address.
///
/// # Errors
/// The address of the first word that is not drawn.
pub fn ladder(rom: &Rom, name: &str) -> Result<String, usize> {
    let mut used = BTreeSet::new();
    let mut rungs = String::new();
    let mut circuit: Vec<Word> = Vec::new();
    let mut outputs: Vec<String> = Vec::new();
    let mut start = 0;
    for (at, &bits) in rom.code.iter().enumerate() {
        let word = Word::decode(bits).map_err(|_| at)?;
        match word {
            Word::Contact { address, .. } => {
                if !outputs.is_empty() {
                    rung(&circuit, &outputs, &mut rungs).ok_or(start)?;
                    (circuit, outputs) = (Vec::new(), Vec::new());
                }
                if circuit.is_empty() {
                    start = at;
                }
                circuit.push(word);
                used.insert(address);
            }
            Word::END => {}
            Word::Output { operation, coil } => {
                let mark = match operation {
                    Operation::Coil => " ",
                    Operation::Inverted => " !",
                    Operation::Set => "S ",
                    Operation::Reset => "R ",
                    _ => return Err(at),
                };
                outputs.push(format!(
                    "({mark}{}{})",
                    bit_name(coil),
                    if mark.starts_with(' ') { " " } else { "" }
                ));
                used.insert(coil);
            }
            Word::Prefix(_) => return Err(at),
        }
    }
    if !circuit.is_empty() {
        rung(&circuit, &outputs, &mut rungs).ok_or(start)?;
    }
    // Every pin keeps its place, and every bit its value at reset, also where no rung names it.
    let pins = rom.pins;
    used.extend(&rom.image);
    used.extend(pins.inputs.checked_sub(1));
    used.extend(pins.outputs.checked_sub(1).map(|last| FIRST_OUTPUT + last));
    let mut text = format!("ladder {name}\n");
    if rom.tick_ns > 0 {
        writeln!(text, "tick {}", quantity::time_text(rom.tick_ns.into())).expect("fits");
    }
    text.push('\n');
    text.extend(used.iter().map(|&address| declaration(rom, address)));
    Ok(text + "\n" + &rungs)
}

/// The line that declares a bit; none for the one that is always on.
fn declaration(rom: &Rom, address: Address) -> String {
    let kind = match address {
        ONE => return String::new(),
        FIRST_FLAG.. => "var",
        FIRST_OUTPUT.. => "output",
        _ => "input",
    };
    let initial = if rom.image.contains(&address) { " := 1" } else { "" };
    format!("{kind:<6} {} at {address}{initial}\n", bit_name(address))
}

fn bit_name(address: Address) -> String {
    match address {
        FIRST_FLAG.. => format!("M{address}"),
        FIRST_OUTPUT.. => format!("Y{address}"),
        _ => format!("X{address}"),
    }
}

/// One circuit with its outputs; one without outputs does nothing.
fn rung(circuit: &[Word], outputs: &[String], rungs: &mut String) -> Option<()> {
    let tree = decode(circuit)?;
    if outputs.is_empty() {
        return None;
    }
    writeln!(rungs, "rung {} {}", drawn(&tree), outputs.join(" ")).expect("fits");
    Some(())
}

fn drawn(tree: &Tree) -> String {
    let join =
        |parts: &[Tree], between: &str| parts.iter().map(drawn).collect::<Vec<_>>().join(between);
    match tree {
        Tree::Contact(Contact { address: ONE, negated }) => {
            if *negated { "FALSE" } else { "TRUE" }.to_owned()
        }
        Tree::Contact(Contact { address, negated }) => {
            format!("{}{}", if *negated { "!" } else { "" }, bit_name(*address))
        }
        Tree::Series(parts) => join(parts, " "),
        Tree::Parallel(parts) => format!("[ {} ]", join(parts, " | ")),
        Tree::Bridge(_) => unreachable!("it is not read back"),
    }
}
