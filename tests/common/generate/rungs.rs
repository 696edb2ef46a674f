//! Rungs of random programs: series, lists, networks and what they end with.

use std::fmt::Write;

use super::Generator;
use crate::common::dice::Dice;

impl Generator {
    pub fn rung(&mut self, text: &mut String) {
        let title = if self.random.chance(3) { " \"a title\"" } else { "" };
        write!(text, "rung{title}").unwrap();
        if !self.steps.is_empty() && self.random.chance(4) {
            let step = self.step();
            writeln!(text, " {step}").unwrap();
            return;
        }
        if !self.random.chance(4) {
            let network = self.series(2);
            write!(text, " {network}").unwrap();
        }
        let outputs = if self.random.chance(3) { self.output_branches() } else { self.output() };
        writeln!(text, " {outputs}").unwrap();
    }

    /// Outputs one below the other, some behind contacts of their own.
    fn output_branches(&mut self) -> String {
        let branches: Vec<String> = (0..2 + self.random.usize(..2))
            .map(|_| {
                let contacts =
                    if self.random.chance(2) { self.looks(1) + " " } else { String::new() };
                contacts + &self.output()
            })
            .collect();
        format!("[ {} ]", branches.join(" | "))
    }

    /// A step of a sequence: in it, and when something happens, the next one.
    fn step(&mut self) -> String {
        let name = self.random.pick(&self.steps);
        let (here, next) = (self.random.u32(..5), self.random.u32(..5));
        let condition = self.looks(1);
        let once = if self.random.chance(3) { " rising" } else { "" };
        let output = if self.random.chance(2) { self.output() + " " } else { String::new() };
        format!("{{ {name} = {here} }} {output}{condition}{once} {{ {name} := {next} }}")
    }

    /// A series that may act on the power and hold outputs.
    fn series(&mut self, depth: u32) -> String {
        let elements = 1 + self.random.usize(..4);
        let list: Vec<String> = (0..elements).map(|_| self.element(depth)).collect();
        list.join(" ")
    }

    fn element(&mut self, depth: u32) -> String {
        match self.random.u32(..24) {
            0 => self.output(),
            1 => "rising".to_owned(),
            2 => "falling".to_owned(),
            3 => "not".to_owned(),
            4 if !self.uncalled.is_empty() => self.call(),
            5..=8 if depth > 0 => {
                let branches = 1 + self.random.usize(..3);
                let list: Vec<String> = (0..branches).map(|_| self.series(depth - 1)).collect();
                format!("[ {} ]", list.join(" | "))
            }
            _ => self.look(depth),
        }
    }

    /// A series that only looks.
    pub fn looks(&mut self, depth: u32) -> String {
        let elements = 1 + self.random.usize(..3);
        let list: Vec<String> = (0..elements).map(|_| self.look(depth)).collect();
        list.join(" ")
    }

    /// A general network, some of whose nodes may lead nowhere.
    fn net(&mut self, depth: u32) -> String {
        self.in_net = true;
        let inner = self.random.usize(..5);
        let mut nodes = vec!["left".to_owned()];
        nodes.extend((0..inner).map(|node| format!("n{node}")));
        nodes.push("right".to_owned());
        // One path at least, then connections between any two nodes.
        let through = self.random.usize(1..=inner + 1);
        let mut ends: Vec<(usize, usize)> = (0..through)
            .map(|node| (node, if node + 1 == through { inner + 1 } else { node + 1 }))
            .collect();
        for _ in 0..self.random.usize(..inner * 2 + 2) {
            let from = self.random.usize(..nodes.len());
            let to = (from + self.random.usize(1..nodes.len())) % nodes.len();
            ends.push((from, to));
        }
        let mut text = "net {".to_owned();
        self.random.shuffle(&mut ends);
        for (from, to) in ends {
            let arrow = self.random.pick(&["->", "<->"]);
            let path = self.looks(depth);
            write!(text, " {} {arrow} {} : {path}", nodes[from], nodes[to]).unwrap();
        }
        self.in_net = false;
        text + " }"
    }

    fn look(&mut self, depth: u32) -> String {
        match self.random.u32(..16) {
            0 if depth > 0 && !self.in_net => self.net(depth - 1),
            0 => self.random.pick(&["TRUE", "FALSE"]).to_owned(),
            1..=2 => {
                let bits: Vec<String> =
                    self.bits.iter().filter(|bit| *bit != "first_scan").cloned().collect();
                let inner = if self.random.chance(4) { self.inner_bit(false) } else { None };
                let (edge, bit) = (self.random.pick(&["rise", "fall"]), self.random.pick(&bits));
                let bit = inner.unwrap_or(bit);
                format!("{edge}({bit})")
            }
            3..=4 => {
                let condition = self.condition(depth);
                format!("{{ {condition} }}")
            }
            5..=6 if depth > 0 => {
                let branches = 1 + self.random.usize(..3);
                let list: Vec<String> = (0..branches).map(|_| self.looks(depth - 1)).collect();
                format!("[ {} ]", list.join(" | "))
            }
            _ => {
                let inner = if self.random.chance(4) { self.inner_bit(false) } else { None };
                let bit = inner.unwrap_or_else(|| self.random.pick(&self.bits));
                format!("{}{bit}", self.random.pick(&["", "", "!"]))
            }
        }
    }

    pub fn output(&mut self) -> String {
        match self.random.u32(..12) {
            0..=2 if !self.targets.is_empty() => {
                let element = if self.random.chance(4) { self.target_element() } else { None };
                let (target, ty) = element.unwrap_or_else(|| self.random.pick(&self.targets));
                let value = self.number(ty, 2);
                // A constant is an error where it is out of a parameter's range.
                let is_member = target.contains('.') && !target.contains('[');
                match is_member && !self.changes(&value) && !is_small(&value) {
                    true => format!("{{ {target} := {target} + {value} }}"),
                    false => format!("{{ {target} := {value} }}"),
                }
            }
            3 if !self.instances.is_empty() => {
                format!("(R {})", self.random.pick(&self.instances))
            }
            _ => {
                let inner = if self.random.chance(4) { self.inner_bit(true) } else { None };
                let coil = inner.unwrap_or_else(|| self.random.pick(&self.coils));
                let action = self.random.pick(&["", "", "", "", "!", "S ", "R ", "rise ", "fall "]);
                format!("({action}{coil})")
            }
        }
    }

    /// True for an expression with a variable in it.
    fn changes(&self, expression: &str) -> bool {
        let names = self.bits.iter().chain(self.numbers.iter().map(|(name, _)| name));
        names.into_iter().any(|name| expression.contains(name.as_str()))
    }
}

/// True for a literal that every parameter takes.
fn is_small(expression: &str) -> bool {
    let digits = expression.strip_suffix("ms").unwrap_or(expression);
    digits.parse().is_ok_and(|number: u32| (1..1000).contains(&number))
}
