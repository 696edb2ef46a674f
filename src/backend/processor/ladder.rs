//! An image as the ladder that it came from.

use std::collections::BTreeSet;
use std::fmt::{self, Write};

use super::decode::decode;
use super::rom::Rom;
use super::tree::{Contact, Tree};
use super::word::{Address, FIRST_FLAG, FIRST_OUTPUT, ONE, Operation, Word};
use crate::quantity;

/// What keeps an image from being a ladder.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NotDrawn {
    /// The contacts from the word at this address on are linked as series and parallel never are.
    Links(usize),
    /// The circuit that begins with the word at this address has no output.
    NoOutput(usize),
    /// The word at this address is an output with no contact in front of it.
    NoCircuit(usize),
    /// The word at this address belongs to a function.
    Function(usize),
    /// The word at this address means nothing.
    Illegal(usize),
    /// A register that is not 0 at reset; without functions nothing looks at it.
    Register(u16),
    /// An input that is 1 at reset.
    Input(Address),
}

impl fmt::Display for NotDrawn {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NotDrawn::Links(at) => {
                write!(f, "the circuit from word {at:03X} on is not of series and parallel")
            }
            NotDrawn::NoOutput(at) => write!(f, "the circuit from word {at:03X} on has no output"),
            NotDrawn::NoCircuit(at) => {
                write!(f, "no contact stands before word {at:03X}, an output")
            }
            NotDrawn::Function(at) => write!(f, "word {at:03X} belongs to a function"),
            NotDrawn::Illegal(at) => write!(f, "word {at:03X} means nothing"),
            NotDrawn::Register(register) => write!(f, "register {register} is not 0 at reset"),
            NotDrawn::Input(address) => write!(f, "input {address} is 1 at reset"),
        }
    }
}

/// A ladder that does the same: a rung for each circuit, a name for each address. Built again, it
/// is the same image if the words are those that the compiler writes.
///
/// # Errors
/// The first thing in the image that no ladder draws.
pub fn ladder(rom: &Rom, name: &str) -> Result<String, NotDrawn> {
    let mut rungs = Rungs::default();
    for (at, &bits) in rom.code.iter().enumerate() {
        match Word::decode(bits) {
            Ok(Word::END) => {}
            Ok(word) => rungs.word(at, word)?,
            Err(_) => return Err(NotDrawn::Illegal(at)),
        }
    }
    rungs.end()?;
    if let Some(&register) = rom.registers.keys().next() {
        return Err(NotDrawn::Register(register));
    }
    if let Some(&input) = rom.image.iter().find(|&&address| address < FIRST_OUTPUT) {
        return Err(NotDrawn::Input(input));
    }
    // Every pin keeps its place, and every bit its value at reset, also where no rung names it.
    let (pins, used) = (rom.pins, &mut rungs.used);
    used.extend(&rom.image);
    used.extend(pins.inputs.checked_sub(1));
    used.extend(pins.outputs.checked_sub(1).map(|last| FIRST_OUTPUT + last));
    let mut text = format!("ladder {name}\n");
    if rom.tick_ns > 0 {
        // A tick is no shorter than a clock.
        let slowest = 1_000_000_000_u64.div_ceil(rom.tick_ns);
        if slowest > quantity::DEFAULT_CLOCK_HZ {
            writeln!(text, "clock {slowest}Hz").expect("fits");
        }
        writeln!(text, "tick {}", quantity::time_text(rom.tick_ns.into())).expect("fits");
    }
    text.push('\n');
    text.extend(used.iter().map(|&address| declaration(rom, address)));
    Ok(text + "\n" + &rungs.text)
}

/// The rungs so far, and the circuit that is not yet one.
#[derive(Default)]
struct Rungs {
    text: String,
    used: BTreeSet<Address>,
    /// Where the circuit begins.
    start: usize,
    circuit: Vec<Word>,
    outputs: Vec<String>,
}

impl Rungs {
    fn word(&mut self, at: usize, word: Word) -> Result<(), NotDrawn> {
        match word {
            Word::Contact { address, .. } => {
                if !self.outputs.is_empty() {
                    self.end()?;
                }
                if self.circuit.is_empty() {
                    self.start = at;
                }
                self.circuit.push(word);
                self.used.insert(address);
            }
            Word::Output { operation, coil } => {
                let name = bit_name(coil);
                let drawn = match operation {
                    Operation::Coil => format!("( {name} )"),
                    Operation::Inverted => format!("( !{name} )"),
                    Operation::Set => format!("(S {name})"),
                    Operation::Reset => format!("(R {name})"),
                    _ => return Err(NotDrawn::Function(at)),
                };
                if self.circuit.is_empty() {
                    return Err(NotDrawn::NoCircuit(at));
                }
                self.outputs.push(drawn);
                self.used.insert(coil);
            }
            Word::Prefix(_) => return Err(NotDrawn::Function(at)),
        }
        Ok(())
    }

    /// Ends the circuit, if there is one.
    fn end(&mut self) -> Result<(), NotDrawn> {
        let circuit = std::mem::take(&mut self.circuit);
        if circuit.is_empty() {
            return Ok(());
        }
        let tree = decode(&circuit).ok_or(NotDrawn::Links(self.start))?;
        if self.outputs.is_empty() {
            return Err(NotDrawn::NoOutput(self.start));
        }
        let outputs = std::mem::take(&mut self.outputs).join(" ");
        writeln!(self.text, "rung {} {outputs}", drawn(&tree)).expect("fits");
        Ok(())
    }
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
