//! The forms in which memory contents go to tools.

use std::collections::BTreeMap;
use std::fmt::Write;

/// A form of file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// For `$readmemh`.
    Hex,
    /// Intel HEX.
    IntelHex,
    /// Xilinx COE.
    Coe,
    /// Altera MIF.
    Mif,
    /// The bytes themselves.
    Binary,
}

impl Form {
    /// Every form.
    pub const ALL: [Form; 5] = [Form::Hex, Form::IntelHex, Form::Coe, Form::Mif, Form::Binary];

    /// The ending of its files.
    pub fn extension(self) -> &'static str {
        match self {
            Form::Hex => "hex",
            Form::IntelHex => "ihex",
            Form::Coe => "coe",
            Form::Mif => "mif",
            Form::Binary => "bin",
        }
    }

    /// True if its files have room for lines that only people read.
    pub fn has_comments(self) -> bool {
        !matches!(self, Form::IntelHex | Form::Binary)
    }

    /// The form of files of that ending.
    pub fn of_extension(extension: &str) -> Option<Form> {
        Form::ALL.into_iter().find(|form| form.extension() == extension)
    }
}

/// What a memory holds where it is not 0.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Memory {
    /// Bits of a word, 1 or 16.
    pub width: u32,
    /// How many words it has.
    pub depth: usize,
    /// The words by their addresses.
    pub words: BTreeMap<usize, u16>,
}

/// What is wrong with a file of memory contents.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unreadable {
    /// The line, from 1, where the form has lines.
    pub line: Option<usize>,
    /// What is wrong there.
    pub problem: String,
}

impl Memory {
    /// Holds 0 everywhere.
    pub fn new(width: u32, depth: usize) -> Memory {
        Memory { width, depth, words: BTreeMap::new() }
    }

    /// The words from 0 to the last that is not 0, at least one.
    pub fn dense(&self) -> Vec<u16> {
        let last = self.words.iter().rev().find(|(_, word)| **word != 0).map_or(0, |(at, _)| *at);
        (0..=last).map(|at| self.words.get(&at).copied().unwrap_or(0)).collect()
    }

    /// The file; forms with comments begin with these lines.
    pub fn write(&self, form: Form, comments: &[String]) -> Vec<u8> {
        match form {
            Form::Hex => self.hex(comments).into_bytes(),
            Form::IntelHex => self.intel_hex().into_bytes(),
            Form::Coe => self.coe(comments).into_bytes(),
            Form::Mif => self.mif(comments).into_bytes(),
            Form::Binary => self.bytes(),
        }
    }

    fn digits(&self) -> usize {
        self.width.div_ceil(4) as usize
    }

    fn hex(&self, comments: &[String]) -> String {
        let mut text = String::new();
        comments.iter().for_each(|line| writeln!(text, "// {line}").expect("fits"));
        let mut next = None;
        for (at, word) in self.shown() {
            if next != Some(at) {
                writeln!(text, "@{at:03X}").expect("fits");
            }
            writeln!(text, "{word:0digits$X}", digits = self.digits()).expect("fits");
            next = Some(at + 1);
        }
        text
    }

    /// The words that are not 0, or that at 0 if there is none.
    fn shown(&self) -> Vec<(usize, u16)> {
        let some: Vec<_> = self
            .words
            .iter()
            .filter(|(_, word)| **word != 0)
            .map(|(at, word)| (*at, *word))
            .collect();
        if some.is_empty() { vec![(0, 0)] } else { some }
    }

    fn coe(&self, comments: &[String]) -> String {
        let mut text = String::new();
        comments.iter().for_each(|line| writeln!(text, "; {line}").expect("fits"));
        text.push_str("memory_initialization_radix=16;\nmemory_initialization_vector=\n");
        let digits = self.digits();
        let words: Vec<String> =
            self.dense().iter().map(|word| format!("{word:0digits$X}")).collect();
        text + &words.join(",\n") + ";\n"
    }

    fn mif(&self, comments: &[String]) -> String {
        let mut text = String::new();
        comments.iter().for_each(|line| writeln!(text, "-- {line}").expect("fits"));
        let (width, depth) = (self.width, self.depth);
        writeln!(text, "WIDTH={width};\nDEPTH={depth};\nADDRESS_RADIX=HEX;\nDATA_RADIX=HEX;")
            .expect("fits");
        text.push_str("CONTENT BEGIN\n");
        for (at, word) in self.shown() {
            writeln!(text, "  {at:03X} : {word:0digits$X};", digits = self.digits()).expect("fits");
        }
        text + "END;\n"
    }

    /// Words of 16 bits with the low byte first; of one bit, eight in a byte, the lowest address in
    /// the lowest bit.
    fn bytes(&self) -> Vec<u8> {
        let words = self.dense();
        match self.width {
            1 => words
                .chunks(8)
                .map(|bits| (0..).zip(bits).map(|(at, bit)| (*bit as u8) << at).sum())
                .collect(),
            _ => words.iter().flat_map(|word| word.to_le_bytes()).collect(),
        }
    }

    fn intel_hex(&self) -> String {
        let mut text = String::new();
        for (row, bytes) in self.bytes().chunks(16).enumerate() {
            let at = (row * 16) as u16;
            let mut record = vec![bytes.len() as u8, (at >> 8) as u8, at as u8, 0];
            record.extend(bytes);
            push_record(&mut text, &record);
        }
        push_record(&mut text, &[0, 0, 0, 1]);
        text
    }
}

fn push_record(text: &mut String, record: &[u8]) {
    let sum = record.iter().fold(0_u8, |sum, byte| sum.wrapping_add(*byte));
    text.push(':');
    for byte in record.iter().chain([&sum.wrapping_neg()]) {
        write!(text, "{byte:02X}").expect("fits");
    }
    text.push('\n');
}
