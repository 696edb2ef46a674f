//! Random programs, as text, that cover the language. One seed is one program.

mod rungs;
mod words;

use std::fmt::Write;

use fastrand::Rng;
use hotrail::blocks::{self, Block, Choice, Port, PortRole, Setting, Shape};
use hotrail::types::Type;
use words::Array;

use super::dice::Dice;

const NUMBERS: [&str; 7] = ["INT", "UINT", "DINT", "UDINT", "WORD", "DWORD", "TIME"];
/// Lengths of the tick in milliseconds: the longer ones let blocks that count seconds count.
const TICKS: [u64; 8] = [1, 1, 5, 10, 50, 100, 500, 1000];
const RELATIONS: [&str; 6] = ["=", "<>", "<", "<=", ">", ">="];

/// A program under construction.
struct Generator {
    random: Rng,
    has_products: bool,
    /// The tick in milliseconds.
    tick: u64,
    /// Names of type `BOOL` that can be read, and those of them that can be written.
    bits: Vec<String>,
    coils: Vec<String>,
    /// Names and types of numbers that can be read, and those that can be written.
    numbers: Vec<(String, &'static str)>,
    targets: Vec<(String, &'static str)>,
    /// Integers that count the steps of sequences.
    steps: Vec<String>,
    arrays: Vec<Array>,
    /// Blocks still to be called.
    uncalled: Vec<Uncalled>,
    instances: Vec<String>,
    /// Instances on which two kinds may be called and one is.
    paired: Vec<String>,
    /// Declarations of what shift registers shift.
    registers: Vec<String>,
    /// What is made stands in a connection of a general network.
    in_net: bool,
}

/// A block that is not called yet.
struct Uncalled {
    name: String,
    shape: Shape,
    /// The settings as the call says them.
    settings: Vec<String>,
    /// For each port, whether the call leaves it to a member.
    left_out: Vec<bool>,
}

/// The text of the random program of a seed.
pub fn program(seed: u64) -> String {
    program_of(seed, true)
}

/// One without products and quotients, which a solver cannot prove equal bit by bit.
pub fn program_without_products(seed: u64) -> String {
    program_of(seed, false)
}

fn program_of(seed: u64, has_products: bool) -> String {
    let mut generator = Generator {
        random: Rng::with_seed(seed),
        has_products,
        tick: 1,
        bits: vec!["first_scan".to_owned()],
        coils: Vec::new(),
        numbers: Vec::new(),
        targets: Vec::new(),
        steps: Vec::new(),
        arrays: Vec::new(),
        uncalled: Vec::new(),
        instances: Vec::new(),
        paired: Vec::new(),
        registers: Vec::new(),
        in_net: false,
    };
    generator.tick = generator.random.pick(&TICKS);
    let mut text = format!("ladder random_{seed}\ntick {}ms\n", generator.tick);
    generator.declarations(&mut text);
    let rungs = 1 + generator.random.usize(..12);
    for _ in 0..rungs {
        generator.rung(&mut text);
    }
    while !generator.uncalled.is_empty() {
        let call = generator.call();
        let network = generator.looks(1);
        writeln!(text, "rung {network} {call}").unwrap();
    }
    text
}

impl Generator {
    fn declarations(&mut self, text: &mut String) {
        for (kind, letter, most) in [("input", "i", 5), ("output", "o", 4), ("var", "v", 4)] {
            for index in 0..1 + self.random.usize(..most) {
                let name = self.name(letter, index);
                if index > 0 && self.random.chance(3) {
                    let ty = self.random.pick(&NUMBERS);
                    let initial = if kind != "input" && self.random.chance(2) {
                        format!(" := {}", self.literal(ty))
                    } else {
                        String::new()
                    };
                    writeln!(text, "{kind} {name} : {ty}{initial}").unwrap();
                    self.numbers.push((name.clone(), ty));
                    if kind != "input" {
                        self.targets.push((name, ty));
                    }
                } else {
                    let initial =
                        if kind != "input" && self.random.chance(4) { " := 1" } else { "" };
                    writeln!(text, "{kind} {name}{initial}").unwrap();
                    self.bits.push(name.clone());
                    if kind != "input" {
                        self.coils.push(name);
                    }
                }
            }
            self.array(kind, letter, text);
        }
        if self.random.chance(3) {
            writeln!(text, "var step : INT").unwrap();
            for list in [&mut self.numbers, &mut self.targets] {
                list.push(("step".to_owned(), "INT"));
            }
            self.steps.push("step".to_owned());
        }
        for index in 0..self.random.usize(..4) {
            self.block(format!("b{index}"));
        }
        let registers = std::mem::take(&mut self.registers);
        registers.iter().for_each(|line| writeln!(text, "{line}").unwrap());
    }

    /// Makes a block of any kind, and its members known.
    fn block(&mut self, name: String) {
        let counts = |block: &&'static Block| self.is_whole(block);
        let known: Vec<&'static Block> = blocks::ALL.iter().copied().filter(counts).collect();
        let block = self.random.pick(&known);
        let (shape, settings) = self.settings(block);
        let left_out: Vec<bool> = shape.ports.iter().map(|_| self.random.chance(3)).collect();
        for (port, &left_out) in shape.ports.iter().zip(&left_out) {
            let member = format!("{name}.{}", port.name);
            if !port.role.is_member() {
                continue;
            }
            let is_target = port.role.is_loaded() || left_out && port.role.is_parameter();
            if port.ty == Type::Bool {
                if is_target {
                    self.coils.push(member.clone());
                }
                self.bits.push(member);
                continue;
            }
            if is_target {
                self.targets.push((member.clone(), port.ty.name()));
            }
            self.numbers.push((member, port.ty.name()));
        }
        if block.can_reset {
            self.instances.push(name.clone());
        }
        self.uncalled.push(Uncalled { name, shape, settings, left_out });
    }

    /// True if the tick divides the unit that a block counts.
    fn is_whole(&self, block: &Block) -> bool {
        let tick_ns = self.tick * 1_000_000;
        block.ports.iter().all(|port| match port.role {
            PortRole::Pulse(unit) => unit.is_multiple_of(tick_ns),
            _ => true,
        })
    }

    /// A block with settings, and what a call says for them.
    fn settings(&mut self, block: &'static Block) -> (Shape, Vec<String>) {
        let (mut chosen, mut texts) = (Vec::new(), Vec::new());
        for Setting { name, choice, .. } in block.settings {
            let otherwise = match choice {
                Choice::Register { .. } => None,
                _ => choice.otherwise(self.tick * 1_000_000),
            };
            if let Some(otherwise) = otherwise.filter(|_| self.random.u8(..4) == 0) {
                chosen.push(otherwise);
                continue;
            }
            let text;
            chosen.push(match choice {
                Choice::Word(words) => {
                    let word = self.random.usize(..words.len());
                    text = words[word].to_owned();
                    vec![word as i64]
                }
                Choice::Time(lengths, _) => {
                    let milliseconds = lengths.iter().map(|ns| ns / 1_000_000);
                    let whole: Vec<u64> =
                        milliseconds.filter(|ms| ms.is_multiple_of(self.tick)).collect();
                    let length = self.random.pick(&whole);
                    text = format!("{length}ms");
                    vec![(length / self.tick) as i64]
                }
                Choice::Register { .. } => {
                    let words = 1 + self.random.usize(..4);
                    let name = format!("reg{}", self.registers.len());
                    for word in 0..words {
                        self.numbers.push((format!("{name}[{word}]"), "WORD"));
                        self.targets.push((format!("{name}[{word}]"), "WORD"));
                    }
                    let first = self.literal("WORD");
                    self.registers.push(format!("var {name} : WORD[{words}] := [{first}]"));
                    text = name;
                    vec![0; words]
                }
                Choice::List { low, high, most } => {
                    let items: Vec<i64> =
                        (0..1 + self.random.usize(..*most))
                            .map(|_| {
                                if self.random.chance(8) { *high } else { self.random.i64(*low..8) }
                            })
                            .collect();
                    let words: Vec<String> = items.iter().map(i64::to_string).collect();
                    text = format!("[{}]", words.join(", "));
                    items
                }
            });
            texts.push(format!("{name} := {text}"));
        }
        (Shape::new(block, chosen), texts)
    }

    /// A name: mostly plain, sometimes one that hardware cannot take as it is.
    fn name(&mut self, letter: &str, index: usize) -> String {
        let strange = match letter {
            "i" => ["`I:0/1`", "signal", "`2nd`", "clk", "_in"],
            "o" => ["`%QX0.1`", "process", "y__1", "Rst", "`tick`"],
            _ => ["`I_0_1`", "begin", "`motor an`", "Signal_u", "unsigned"],
        };
        if self.random.chance(6) { strange[index].to_owned() } else { format!("{letter}{index}") }
    }

    fn call(&mut self) -> String {
        // The last one that was declared or any other: a member may be read above its call.
        let place = self.random.usize(..self.uncalled.len());
        let Uncalled { name, shape, settings, left_out } = self.uncalled.swap_remove(place);
        let mut arguments = settings;
        for (port, left_out) in shape.ports.iter().zip(left_out) {
            if left_out || !port.role.is_parameter() {
                continue;
            }
            let value = match port.role.range() {
                Some((low, high)) => self.preset(port, low, high),
                None => format!("[ {} ]", self.looks(1)),
            };
            arguments.push(format!("{} := {value}", port.name));
        }
        if let Some(partner) = shape.block.partner.filter(|_| !self.paired.contains(&name)) {
            self.paired.push(name.clone());
            if self.random.bool() {
                let partner = blocks::named(partner).unwrap();
                let shape = Shape::new(partner, shape.chosen.clone());
                // The first call in the text has said everything.
                let left_out = vec![true; shape.ports.len()];
                let (name, settings) = (name.clone(), Vec::new());
                self.uncalled.push(Uncalled { name, shape, settings, left_out });
            }
        }
        self.random.shuffle(&mut arguments);
        format!("{name}:{}({})", shape.block.name, arguments.join(", "))
    }

    /// A value for a preset: mostly a small constant, so that a short run reaches it.
    fn preset(&mut self, port: &Port, low: i64, high: i64) -> String {
        let ty = port.ty.name();
        let variables: Vec<String> =
            self.numbers.iter().filter(|n| n.1 == ty).map(|n| n.0.clone()).collect();
        match self.random.u32(..8) {
            0..=2 if !variables.is_empty() => self.random.pick(&variables),
            3 if !variables.is_empty() => {
                let operator = if port.ty.is_number() { "+" } else { "XOR" };
                format!("{} {operator} {}", self.random.pick(&variables), self.literal(ty))
            }
            choice => {
                let value = if choice == 4 { high } else { self.random.i64(low..low + 6) };
                if port.ty == Type::Time { self.time(value) } else { value.to_string() }
            }
        }
    }

    /// So many ticks.
    fn time(&self, ticks: i64) -> String {
        format!("{}ms", ticks * self.tick as i64)
    }

    fn literal(&mut self, ty: &str) -> String {
        match ty {
            "TIME" => {
                let ticks = self.random.i64(0..6);
                self.time(ticks)
            }
            "INT" => self.random.pick(&["0", "1", "2", "5", "-1", "32767", "-32768"]).to_owned(),
            "DINT" => {
                self.random.pick(&["0", "1", "7", "-1", "2147483647", "-2147483648"]).to_owned()
            }
            "UINT" => self.random.pick(&["0", "1", "3", "65535"]).to_owned(),
            "UDINT" => self.random.pick(&["0", "1", "3", "4294967295"]).to_owned(),
            "WORD" => self.random.pick(&["16#0", "16#FF", "2#1010", "16#FFFF"]).to_owned(),
            _ => self.random.pick(&["16#0", "16#FF00FF", "8#17", "16#FFFFFFFF"]).to_owned(),
        }
    }

    fn number(&mut self, ty: &str, depth: u32) -> String {
        let same: Vec<String> =
            self.numbers.iter().filter(|number| number.1 == ty).map(|n| n.0.clone()).collect();
        let is_pattern = matches!(ty, "WORD" | "DWORD");
        if depth > 0
            && self.random.chance(3)
            && let Some(worked_out) = self.worked_out(ty, depth)
        {
            return worked_out;
        }
        match self.random.u32(..5) {
            0..=1 if depth > 0 => {
                let (a, b) = (self.number(ty, depth - 1), self.number(ty, depth - 1));
                let operators: &[&str] =
                    if is_pattern { &["AND", "OR", "XOR"] } else { &["+", "-"] };
                let text = format!("({a} {} {b})", self.random.pick(operators));
                // Literals alone do not wrap: a sum that does not fit its type is an error.
                match text.contains(|c: char| c.is_ascii_alphabetic()) {
                    true => text,
                    false => self.literal(ty),
                }
            }
            2 if depth > 0 && !same.is_empty() => {
                let operator = if is_pattern { "NOT " } else { "-" };
                format!("({operator}{})", self.random.pick(&same))
            }
            3..=4 if !same.is_empty() => self.random.pick(&same),
            _ => self.literal(ty),
        }
    }

    fn condition(&mut self, depth: u32) -> String {
        if depth > 0 && self.random.chance(3) {
            let (a, b) = (self.condition(depth - 1), self.condition(depth - 1));
            return format!("({a}) {} ({b})", self.random.pick(&["AND", "OR", "XOR"]));
        }
        let bits: Vec<String> =
            self.bits.iter().filter(|bit| *bit != "first_scan").cloned().collect();
        if self.numbers.is_empty() || self.random.chance(4) {
            return format!("{}{}", self.random.pick(&["", "NOT "]), self.random.pick(&bits));
        }
        let (name, ty) = self.random.pick(&self.numbers);
        let other = self.number(ty, 1);
        format!("{name} {} {other}", self.random.pick(&RELATIONS))
    }
}
