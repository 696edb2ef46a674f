//! Random programs, as text, of all that the ladder processor can do. One seed is one program.

use std::fmt::Write;

use fastrand::Rng;

struct Generator {
    random: Rng,
    bits: Vec<String>,
    coils: Vec<String>,
    /// Blocks that are not called yet, with their kinds.
    uncalled: Vec<(String, &'static str)>,
    latches: Vec<String>,
}

const KINDS: [&str; 7] = ["SR", "RS", "R_TRIG", "F_TRIG", "TON", "TOF", "TP"];

/// The text of the random program of a seed.
pub fn program(seed: u64) -> String {
    let mut generator = Generator {
        random: Rng::with_seed(seed),
        bits: vec!["first_scan".to_owned()],
        coils: Vec::new(),
        uncalled: Vec::new(),
        latches: Vec::new(),
    };
    let tick = if generator.random.bool() { "100ms" } else { "1s" };
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
    fn chance(&mut self, one_in: u32) -> bool {
        self.random.u32(..one_in) == 0
    }

    fn pick<T: Clone>(&mut self, list: &[T]) -> T {
        list[self.random.usize(..list.len())].clone()
    }

    fn declarations(&mut self, text: &mut String) {
        for (kind, first, most) in [("input", 0, 5), ("output", 256, 4), ("var", 512, 4)] {
            for index in 0..1 + self.random.usize(..most) {
                let name = format!("{}{index}", &kind[..1]);
                let at = match self.chance(5) {
                    true => format!(" at {}", first + 20 * index + self.random.usize(..20)),
                    false => String::new(),
                };
                let initial = if kind != "input" && self.chance(4) { " := 1" } else { "" };
                writeln!(text, "{kind} {name}{at}{initial}").unwrap();
                self.bits.push(name.clone());
                if kind != "input" {
                    self.coils.push(name);
                }
            }
        }
        for index in 0..self.random.usize(..4) {
            let (name, kind) = (format!("b{index}"), self.pick(&KINDS));
            self.bits.push(format!("{name}.Q"));
            if KINDS[..4].contains(&kind) {
                self.latches.push(name.clone());
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
            2 => self.pick(&["rising", "falling", "not"]).to_owned(),
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
            0 => self.pick(&["TRUE", "FALSE"]).to_owned(),
            1 => {
                let (edge, bit) = (self.pick(&["rise", "fall"]), self.pick(&plain));
                format!("{edge}({bit})")
            }
            2 => format!("{{ {} }}", self.condition(2)),
            3..=8 if depth > 0 => {
                let branches = 1 + self.random.usize(..4);
                let list: Vec<String> = (0..branches).map(|_| self.looks(depth - 1)).collect();
                format!("[ {} ]", list.join(" | "))
            }
            _ => {
                let bit = self.pick(&self.bits.clone());
                format!("{}{bit}", self.pick(&["", "", "!"]))
            }
        }
    }

    fn condition(&mut self, depth: u32) -> String {
        let plain: Vec<String> = self.bits[1..].to_vec();
        if depth == 0 || self.chance(3) {
            return format!("{}{}", self.pick(&["", "NOT "]), self.pick(&plain));
        }
        let (a, b) = (self.condition(depth - 1), self.condition(depth - 1));
        let operator = self.pick(&["AND", "OR", "XOR", "=", "<>", "<", "<=", ">", ">="]);
        format!("({a}) {operator} ({b})")
    }

    fn output(&mut self) -> String {
        let coil = self.pick(&self.coils.clone());
        match self.random.u32(..12) {
            0 => format!("{{ {coil} := {} }}", self.condition(2)),
            1 if !self.latches.is_empty() => format!("(R {})", self.pick(&self.latches.clone())),
            _ => {
                let action = self.pick(&["", "", "", "", "!", "S ", "R ", "rise ", "fall "]);
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
            "SR" | "RS" if self.chance(4) => String::new(),
            "SR" => format!("R := [ {} ]", self.looks(1)),
            "RS" => format!("R1 := [ {} | not ]", self.looks(1)),
            "TON" | "TOF" | "TP" => {
                let shortest = u32::from(kind == "TON");
                format!("PT := {}s", self.random.u32(shortest..4))
            }
            _ => String::new(),
        };
        Some(format!("{name}:{kind}({arguments})"))
    }
}
