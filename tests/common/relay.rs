//! Random programs, as text, of all that the ladder processor can do. One seed is one program.

use std::fmt::Write;

use fastrand::Rng;

use super::dice::Dice;

struct Generator {
    random: Rng,
    bits: Vec<String>,
    coils: Vec<String>,
    /// Blocks that are not called yet, with their kinds.
    uncalled: Vec<(String, &'static str)>,
    latches: Vec<String>,
    is_tick_short: bool,
    is_plain: bool,
}

const LATCHES: [&str; 4] = ["SR", "RS", "R_TRIG", "F_TRIG"];
/// Those of tenths last, for they need a short tick.
const FUNCTIONS: [&str; 12] =
    ["TON", "TOF", "TP", "TS", "T1_0", "UC", "DC", "DRUM", "SHL", "SHR", "TT", "T0_1"];
/// Of these a reset coil reaches all.
const COUNTS: [&str; 8] = ["TON", "T1_0", "T0_1", "UC", "DC", "DRUM", "SHL", "SHR"];

/// The text of the random program of a seed.
pub fn program(seed: u64) -> String {
    text_of(seed, false)
}

/// One whose image is contacts, coils and latches and nothing else.
pub fn plain_program(seed: u64) -> String {
    text_of(seed, true)
}

fn text_of(seed: u64, is_plain: bool) -> String {
    let mut generator = Generator {
        random: Rng::with_seed(seed),
        bits: vec!["first_scan".to_owned()],
        coils: Vec::new(),
        uncalled: Vec::new(),
        latches: Vec::new(),
        is_tick_short: false,
        is_plain,
    };
    generator.is_tick_short = generator.random.bool();
    let tick = if generator.is_tick_short { "100ms" } else { "1s" };
    let mut text = format!("ladder relay_{seed}\ntick {tick}\n");
    generator.declarations(&mut text);
    for _ in 0..1 + generator.random.usize(..6) {
        let network = generator.series(3);
        let output = generator.output();
        writeln!(text, "rung {network} {output}").unwrap();
    }
    while let Some(call) = generator.call() {
        let network = generator.looks(2);
        writeln!(text, "rung {network} {call}").unwrap();
    }
    text
}

impl Generator {
    fn declarations(&mut self, text: &mut String) {
        for (kind, first, most) in [("input", 0, 5), ("output", 256, 4), ("var", 512, 4)] {
            for index in 0..1 + self.random.usize(..most) {
                let name = format!("{}{index}", &kind[..1]);
                let at = match self.random.chance(5) {
                    true => format!(" at {}", first + 20 * index + self.random.usize(..20)),
                    false => String::new(),
                };
                let initial = if kind != "input" && self.random.chance(4) { " := 1" } else { "" };
                writeln!(text, "{kind} {name}{at}{initial}").unwrap();
                self.bits.push(name.clone());
                if kind != "input" {
                    self.coils.push(name);
                }
            }
        }
        if self.is_plain {
            return;
        }
        writeln!(
            text,
            "input level : INT\nvar fixed : INT := 2\nvar word : WORD := 16#0F
var words : WORD[3] := [16#8001, 16#FFFF, 16#7FFE]"
        )
        .unwrap();
        for bit in [0, 3, 15] {
            self.bits.push(format!("word.{bit}"));
            self.coils.push(format!("word.{bit}"));
            self.bits.push(format!("words[1].{bit}"));
        }
        for index in 0..self.random.usize(..4) {
            let name = format!("b{index}");
            self.bits.push(format!("{name}.Q"));
            let functions = if self.is_tick_short { &FUNCTIONS[..] } else { &FUNCTIONS[..10] };
            let kind = if self.random.chance(3) {
                self.random.pick(&LATCHES)
            } else {
                self.random.pick(functions)
            };
            if LATCHES.contains(&kind) || COUNTS.contains(&kind) {
                self.latches.push(name.clone());
            }
            match kind {
                "TS" | "TT" | "T1_0" | "T0_1" => self.bits.push(format!("{name}.QN")),
                "DRUM" => self.bits.extend([format!("{name}.TAP0"), format!("{name}.TAP2")]),
                _ => {}
            }
            self.uncalled.push((name, kind));
        }
    }

    fn series(&mut self, depth: u32) -> String {
        let elements = 1 + self.random.usize(..4);
        let list: Vec<String> = (0..elements).map(|_| self.element(depth)).collect();
        list.join(" ")
    }

    fn element(&mut self, depth: u32) -> String {
        match self.random.u32(..24) {
            0 | 1 => self.output(),
            2 => self.random.pick(&["rising", "falling", "not"]).to_owned(),
            3 => self.call().unwrap_or_else(|| self.look(depth)),
            4..=9 if depth > 0 => {
                let branches = 1 + self.random.usize(..3);
                let list: Vec<String> = (0..branches).map(|_| self.series(depth - 1)).collect();
                format!("[ {} ]", list.join(" | "))
            }
            _ => self.look(depth),
        }
    }

    fn looks(&mut self, depth: u32) -> String {
        let elements = 1 + self.random.usize(..3);
        let list: Vec<String> = (0..elements).map(|_| self.look(depth)).collect();
        list.join(" ")
    }

    fn look(&mut self, depth: u32) -> String {
        let plain: Vec<String> = self.bits[1..].to_vec();
        match self.random.u32(..16) {
            0 => self.random.pick(&["TRUE", "FALSE"]).to_owned(),
            1 => {
                let (edge, bit) = (self.random.pick(&["rise", "fall"]), self.random.pick(&plain));
                format!("{edge}({bit})")
            }
            2 => format!("{{ {} }}", self.condition(2)),
            9 if depth > 1 && !self.is_plain => self.net(),
            3..=8 if depth > 0 => {
                let branches = 1 + self.random.usize(..4);
                let list: Vec<String> = (0..branches).map(|_| self.looks(depth - 1)).collect();
                format!("[ {} ]", list.join(" | "))
            }
            _ => {
                let bit = self.random.pick(&self.bits);
                format!("{}{bit}", self.random.pick(&["", "", "!"]))
            }
        }
    }

    /// A network of few nodes, so that bridges are among them, with random connections besides.
    fn net(&mut self) -> String {
        let nodes = ["left", "right", "n1", "n2", "n3"];
        let nodes = &nodes[..4 + self.random.usize(..2)];
        let mut text = "net { left -> n1 : ".to_owned() + &self.looks(1);
        for (from, arrow, to) in [
            ("left", "->", "n2"),
            ("n1", "<->", "n2"),
            ("n1", "->", "right"),
            ("n2", "->", "right"),
        ] {
            write!(text, " {from} {arrow} {to} : {}", self.looks(1)).unwrap();
        }
        for node in &nodes[4..] {
            write!(text, " n1 <-> {node} : {}", self.looks(0)).unwrap();
            write!(text, " {node} -> right : {}", self.looks(0)).unwrap();
        }
        for _ in 0..self.random.usize(..3) {
            let (from, to) = (self.random.pick(nodes), self.random.pick(nodes));
            if from != to && from != "right" && to != "left" {
                let arrow = self.random.pick(&["->", "<->"]);
                write!(text, " {from} {arrow} {to} : {}", self.looks(0)).unwrap();
            }
        }
        text + " }"
    }

    fn condition(&mut self, depth: u32) -> String {
        let plain: Vec<String> = self.bits[1..].to_vec();
        if depth == 0 || self.random.chance(3) {
            return format!("{}{}", self.random.pick(&["", "NOT "]), self.random.pick(&plain));
        }
        let (a, b) = (self.condition(depth - 1), self.condition(depth - 1));
        let operator = self.random.pick(&["AND", "OR", "XOR", "=", "<>", "<", "<=", ">", ">="]);
        format!("({a}) {operator} ({b})")
    }

    fn output(&mut self) -> String {
        let coil = self.random.pick(&self.coils);
        match self.random.u32(..12) {
            0 => {
                let constant = self.random.chance(4).then(|| self.random.pick(&["TRUE", "FALSE"]));
                let value = constant.map_or_else(|| self.condition(2), str::to_owned);
                format!("{{ {coil} := {value} }}")
            }
            1 if !self.latches.is_empty() => format!("(R {})", self.random.pick(&self.latches)),
            _ => {
                let action = self.random.pick(&["", "", "", "", "!", "S ", "R ", "rise ", "fall "]);
                format!("({action}{coil})")
            }
        }
    }

    fn call(&mut self) -> Option<String> {
        let place = self.random.usize(..self.uncalled.len().max(1));
        let (name, kind) = match self.uncalled.is_empty() {
            true => return None,
            false => self.uncalled.swap_remove(place),
        };
        let arguments = match kind {
            "SR" | "RS" if self.random.chance(4) => String::new(),
            "SR" => format!("R := [ {} ]", self.looks(1)),
            "RS" => format!("R1 := [ {} | not ]", self.looks(1)),
            "TON" | "TOF" | "TP" => {
                format!("PT := {}s", self.random.u32(..4))
            }
            "TS" | "TT" | "T1_0" | "T0_1" | "UC" | "DC" | "DRUM" => self.function(kind),
            "SHL" | "SHR" => {
                let mut arguments = format!("REG := {}", self.random.pick(&["word", "words"]));
                for port in ["EN", "DATA"] {
                    if !self.random.chance(3) {
                        write!(arguments, ", {port} := {}", self.looks(2)).unwrap();
                    }
                }
                arguments
            }
            _ => String::new(),
        };
        Some(format!("{name}:{kind}({arguments})"))
    }

    fn function(&mut self, kind: &str) -> String {
        let constant = self.random.u32(1..4).to_string();
        let mut arguments = vec![match self.random.u32(..4) {
            0 if kind != "DRUM" => "PV := level".to_owned(),
            1 if kind != "DRUM" => "PV := fixed".to_owned(),
            _ => format!("PV := {constant}"),
        }];
        if !self.random.chance(3) {
            arguments.push(format!("EN := [ {} | {} ]", self.looks(1), self.looks(0)));
        }
        match kind {
            "DRUM" => arguments.push("TAPS := [1, 4, 2]".to_owned()),
            "TS" | "TT" => {
                arguments.push(format!("MODE := {}", self.random.pick(&["ON", "OFF", "INTERVAL"])));
            }
            _ => {}
        }
        arguments.join(", ")
    }
}
