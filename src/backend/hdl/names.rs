//! Names in printed hardware, decided once for both languages.
//!
//! The rule, from the user's name to the printed one:
//! 1. Every run of characters other than ASCII letters and digits becomes one `_`; a `_` at
//!    either end is dropped.
//! 2. `n` is put in front of a leading digit and stands for an empty name.
//! 3. What is longer than [`MAX_LENGTH`] is cut.
//! 4. A keyword of either language, a word that the printed text relies on, a fixed port and the
//!    name of a module get `_u`, for "user", at their end.
//! 5. A name that is taken, ignoring case, gets the first free of `_2`, `_3`, ....
//!
//! Ports choose first, in their order, so that nothing inside a module can change them; then
//! registers, signals, instances and at last the wires that only the printed text has.

use std::collections::{HashMap, HashSet};
use std::fmt::{self, Write};
use std::num::NonZeroU32;
use std::sync::LazyLock;

use super::keywords;

/// The longest name that is printed.
pub const MAX_LENGTH: usize = 64;

/// The ports that every printed program has, in all their forms. They are fixed.
pub const FIXED_PORTS: [&str; 6] = [CLOCK, "rst", "rst_n", SCAN_DONE, SCAN_START, TICK];
/// The clock port.
pub const CLOCK: &str = "clk";
/// The port that says that a scan has the tick.
pub const TICK: &str = "tick";
/// The port that starts a scan, where a scan takes several clocks.
pub const SCAN_START: &str = "scan_start";
/// The port that is 1 in the last clock of such a scan.
pub const SCAN_DONE: &str = "scan_done";

/// A name in a table of [`Names`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct NameId(NonZeroU32);

/// The names of one module in one piece of text.
#[derive(Clone, Debug, Default)]
pub struct Names {
    text: String,
    ends: Vec<u32>,
}

impl Names {
    /// The text of a name.
    pub fn get(&self, id: NameId) -> &str {
        self.nth(id.0.get() as usize - 1)
    }

    /// All names in the order in which they were given out.
    pub fn iter(&self) -> impl Iterator<Item = &str> {
        (0..self.ends.len()).map(|index| self.nth(index))
    }

    fn nth(&self, index: usize) -> &str {
        let start = if index == 0 { 0 } else { self.ends[index - 1] as usize };
        &self.text[start..self.ends[index] as usize]
    }

    fn push(&mut self, name: &str) -> NameId {
        self.text.push_str(name);
        self.ends.push(self.text.len() as u32);
        let count = NonZeroU32::new(self.ends.len() as u32);
        NameId(count.expect("a module has fewer than 2^32 names"))
    }
}

/// Gives out the names of one scope: a module, or the modules of a file.
///
/// Every name given out is legal in both languages and, ignoring case, not given out before.
#[derive(Debug)]
pub struct Namer<'a> {
    names: Names,
    /// Each name in lower case, with the number that the last equal one got.
    taken: HashMap<Box<str>, u32>,
    /// Names of the scope around, in lower case.
    outer: &'a HashSet<String>,
    word: Word,
    candidate: String,
}

impl<'a> Namer<'a> {
    /// An empty scope; `outer` are names that it must not hide, in lower case.
    pub fn new(outer: &'a HashSet<String>) -> Self {
        Namer {
            names: Names::default(),
            taken: HashMap::new(),
            outer,
            word: Word::default(),
            candidate: String::new(),
        }
    }

    /// Takes a fixed name as it is.
    pub fn fix(&mut self, name: &'static str) -> NameId {
        self.taken.insert(name.into(), 1);
        self.names.push(name)
    }

    /// A free name like `base` followed by `suffix`, which is made of legal characters.
    pub fn take(&mut self, base: impl fmt::Display, suffix: &str) -> NameId {
        self.word.set(base);
        let mut mark = "";
        self.put_together(suffix, mark);
        let mut first = self.lower();
        if RESERVED.contains(first.as_str()) || self.outer.contains(&first) {
            mark = "_u";
            self.put_together(suffix, mark);
            first = self.lower();
        }
        if let Some(mut number) = self.taken.get(first.as_str()).copied() {
            loop {
                number += 1;
                self.put_together(suffix, &format!("{mark}_{number}"));
                let lower = self.lower();
                if !self.taken.contains_key(lower.as_str()) && !self.outer.contains(&lower) {
                    self.taken.insert(lower.into(), 1);
                    break;
                }
            }
            self.taken.insert(first.into(), number);
        } else {
            self.taken.insert(first.into(), 1);
        }
        self.names.push(&self.candidate)
    }

    /// The table, when every name has been given out.
    pub fn finish(self) -> Names {
        self.names
    }

    fn put_together(&mut self, suffix: &str, mark: &str) {
        let room = MAX_LENGTH - suffix.len() - mark.len();
        let base = &self.word.text[..self.word.text.len().min(room)];
        self.candidate.clear();
        self.candidate.push_str(base.trim_end_matches('_'));
        self.candidate.push_str(suffix);
        self.candidate.push_str(mark);
    }

    fn lower(&self) -> String {
        self.candidate.to_ascii_lowercase()
    }
}

/// The legal part of what is written into it: steps 1 and 2 of the rule.
#[derive(Debug, Default)]
struct Word {
    text: String,
    gap: bool,
}

impl Word {
    fn set(&mut self, base: impl fmt::Display) {
        self.text.clear();
        self.gap = false;
        // A Word takes every character, so that an error could only be base's own.
        let _ = write!(self, "{base}");
        if self.text.is_empty() {
            self.text.push('n');
        }
    }
}

impl Write for Word {
    fn write_str(&mut self, s: &str) -> fmt::Result {
        for c in s.chars() {
            if !c.is_ascii_alphanumeric() {
                self.gap = true;
                continue;
            }
            if self.text.is_empty() && c.is_ascii_digit() {
                self.text.push('n');
            } else if self.gap && !self.text.is_empty() {
                self.text.push('_');
            }
            self.gap = false;
            self.text.push(c);
        }
        Ok(())
    }
}

/// Every word, in lower case, that the languages or the printed text keep for themselves.
static RESERVED: LazyLock<HashSet<&str>> = LazyLock::new(|| {
    let tables = [keywords::VERILOG, keywords::VHDL, keywords::RELIED_ON, &FIXED_PORTS];
    tables.into_iter().flatten().copied().collect()
});

static CPP: LazyLock<HashSet<&str>> = LazyLock::new(|| keywords::CPP.iter().copied().collect());

/// True for a name of which Verilator warns because C++ has it.
pub fn is_cpp_word(name: &str) -> bool {
    const LONGEST: usize = 16;
    name.len() <= LONGEST && CPP.contains(name)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn named(bases: &[&str]) -> Vec<String> {
        let outer = HashSet::from(["start_stop".to_owned()]);
        let mut namer = Namer::new(&outer);
        for base in bases {
            namer.take(base, "");
        }
        namer.finish().iter().map(str::to_owned).collect()
    }

    #[test]
    fn legal_names_stay() {
        assert_eq!(
            named(&["motor", "Motor_2", "X0", "a1_b2"]),
            ["motor", "Motor_2", "X0", "a1_b2"]
        );
    }

    #[test]
    fn other_characters_become_one_underscore() {
        assert_eq!(
            named(&["w[12]", "_x_", "a__b", "Förderband", "a.\u{202e}b", "t-1.Q"]),
            ["w_12", "x", "a_b", "F_rderband", "a_b_2", "t_1_Q"]
        );
    }

    #[test]
    fn digits_and_nothing_get_an_n() {
        assert_eq!(named(&["1st", "", "___", "_9", "你"]), ["n1st", "n", "n_2", "n9", "n_3"]);
    }

    #[test]
    fn reserved_words_get_a_mark() {
        assert_eq!(
            named(&[
                "out",
                "OUT",
                "Logic",
                "clk",
                "RST_N",
                "tick",
                "Start_Stop",
                "unsigned",
                "bool"
            ]),
            [
                "out_u",
                "OUT_u_2",
                "Logic_u",
                "clk_u",
                "RST_N_u",
                "tick_u",
                "Start_Stop_u",
                "unsigned_u",
                "bool_u"
            ]
        );
    }

    #[test]
    fn equal_names_are_numbered_ignoring_case() {
        assert_eq!(named(&["a_2", "a", "A", "a", "a_2"]), ["a_2", "a", "A_3", "a_4", "a_2_2"]);
    }

    #[test]
    fn long_names_are_cut_and_keep_their_ending() {
        let outer = HashSet::new();
        let mut namer = Namer::new(&outer);
        let long = "x".repeat(80);
        let ids = [namer.take(&long, ""), namer.take(&long, "_next"), namer.take(&long, "_next")];
        let names = namer.finish();
        let [plain, next, second] = ids.map(|id| names.get(id));
        assert_eq!(plain, "x".repeat(64));
        assert_eq!(next, format!("{}_next", "x".repeat(59)));
        assert_eq!(second, format!("{}_next_2", "x".repeat(57)));
    }

    #[test]
    fn a_cut_leaves_no_underscore_before_the_ending() {
        let outer = HashSet::new();
        let mut namer = Namer::new(&outer);
        let id = namer.take(format_args!("{}_yyyyyyyy", "x".repeat(58)), "_next");
        assert_eq!(namer.finish().get(id), format!("{}_next", "x".repeat(58)));
    }

    #[test]
    fn many_equal_names_take_linear_time() {
        let outer = HashSet::new();
        let mut namer = Namer::new(&outer);
        let last = (0..50_000).map(|_| namer.take("same", "")).last().expect("there are some");
        assert_eq!(namer.finish().get(last), "same_50000");
    }

    #[test]
    fn tables_are_sorted_and_in_lower_case() {
        for table in
            [keywords::VERILOG, keywords::VHDL, keywords::RELIED_ON, keywords::CPP, &FIXED_PORTS]
        {
            assert!(table.windows(2).all(|pair| pair[0] < pair[1]));
            assert!(table.iter().all(|word| *word == word.to_ascii_lowercase()));
        }
    }

    #[test]
    fn every_name_is_legal_and_unique_whatever_the_user_writes() {
        let mut random = fastrand::Rng::with_seed(7);
        let alphabet = ["a", "B", "_", "1", "ü", "[", "\n", "out", "reg", "x".repeat(40).as_str()]
            .map(str::to_owned);
        let outer = HashSet::from(["breg".to_owned()]);
        let mut namer = Namer::new(&outer);
        for _ in 0..5_000 {
            let base: String = (0..random.usize(..6))
                .map(|_| alphabet[random.usize(..alphabet.len())].as_str())
                .collect();
            namer.take(base, ["", "_next", "_reg"][random.usize(..3)]);
        }
        let names = namer.finish();
        let mut seen = HashSet::new();
        for name in names.iter() {
            assert!(
                name.len() <= MAX_LENGTH && name.starts_with(|c: char| c.is_ascii_alphabetic())
            );
            assert!(name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_'), "{name}");
            assert!(!name.contains("__") && !name.ends_with('_'), "{name}");
            let lower = name.to_ascii_lowercase();
            assert!(!RESERVED.contains(lower.as_str()) && !outer.contains(&lower), "{name}");
            assert!(seen.insert(lower), "{name} is there twice");
        }
    }
}
