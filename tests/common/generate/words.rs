//! Arrays, bits, arithmetic, functions and conversions of random programs.

use std::fmt::Write;

use super::{Generator, NUMBERS};
use crate::common::dice::Dice;

const INTEGERS: [&str; 4] = ["INT", "UINT", "DINT", "UDINT"];

/// An array that is declared.
#[derive(Clone)]
pub struct Array {
    name: String,
    ty: &'static str,
    length: usize,
    is_written: bool,
}

fn width(ty: &str) -> usize {
    match ty {
        "BOOL" => 1,
        "INT" | "UINT" | "WORD" => 16,
        _ => 32,
    }
}

/// True for the types whose bits have numbers.
fn has_bits(ty: &str) -> bool {
    ty != "TIME" && ty != "BOOL"
}

impl Generator {
    /// Declares an array now and then, and makes its elements known.
    pub fn array(&mut self, kind: &str, letter: &str, text: &mut String) {
        if !self.random.chance(3) {
            return;
        }
        let ty = if self.random.chance(3) { "BOOL" } else { self.random.pick(&NUMBERS) };
        let (name, length) = (format!("{letter}_array"), 1 + self.random.usize(..5));
        let initial = if kind != "input" && self.random.chance(2) {
            let values = self.random.usize(..=length);
            let bit = |generator: &mut Self| generator.random.pick(&["0", "1"]).to_owned();
            let values: Vec<String> = (0..values)
                .map(|_| if ty == "BOOL" { bit(self) } else { self.literal(ty) })
                .collect();
            format!(" := [{}]", values.join(", "))
        } else {
            String::new()
        };
        writeln!(text, "{kind} {name} : {ty}[{length}]{initial}").unwrap();
        let is_written = kind != "input";
        for index in 0..length {
            let element = format!("{name}[{index}]");
            if ty == "BOOL" {
                self.bits.push(element.clone());
                self.coils.extend(is_written.then_some(element));
            } else {
                self.numbers.push((element.clone(), ty));
                self.targets.extend(is_written.then_some((element, ty)));
            }
        }
        self.arrays.push(Array { name, ty, length, is_written });
    }

    /// An element of an array of a type, chosen while the program runs.
    fn chosen(&mut self, is_right: impl Fn(&Array) -> bool) -> Option<(String, &'static str)> {
        let arrays: Vec<Array> =
            self.arrays.iter().filter(|array| is_right(array)).cloned().collect();
        if arrays.is_empty() {
            return None;
        }
        let Array { name, ty, length, .. } = self.random.pick(&arrays);
        let index = self.integer();
        let index = match self.random.u32(..3) {
            0 => index,
            // Mostly in range: a remainder is negative now and then.
            _ if !self.has_products || self.is_literal(&index) => {
                self.random.usize(..length).to_string()
            }
            _ => format!("{index} MOD {}", length + 1),
        };
        let is_outside =
            self.is_literal(&index) && !index.parse().is_ok_and(|index: usize| index < length);
        let index = if is_outside { "0".to_owned() } else { index };
        Some((format!("{name}[{index}]"), ty))
    }

    fn is_literal(&self, text: &str) -> bool {
        text.starts_with(|c: char| c == '-' || c.is_ascii_digit())
    }

    /// An integer of any type, by which something is counted.
    fn integer(&mut self) -> String {
        let known: Vec<String> = self
            .numbers
            .iter()
            .filter(|number| INTEGERS.contains(&number.1))
            .map(|number| number.0.clone())
            .collect();
        if known.is_empty() || self.random.chance(4) {
            return self
                .random
                .pick(&["0", "1", "2", "3", "7", "15", "16", "33", "-1", "-5"])
                .to_owned();
        }
        self.random.pick(&known)
    }

    /// A bit that a contact can look at, or a coil can write: of a number, of an element that is
    /// chosen while the program runs, of all of an array.
    pub fn inner_bit(&mut self, is_written: bool) -> Option<String> {
        let choose = move |array: &Array| array.is_written || !is_written;
        match self.random.u32(..4) {
            0 => {
                let is_right = move |array: &Array| choose(array) && array.ty != "TIME";
                let (element, ty) = self.chosen(is_right)?;
                Some(self.bit_of(&element, ty))
            }
            1 => {
                let arrays: Vec<Array> = self
                    .arrays
                    .iter()
                    .filter(|array| choose(array) && array.ty != "TIME")
                    .cloned()
                    .collect();
                if arrays.is_empty() {
                    return None;
                }
                let Array { name, ty, length, .. } = self.random.pick(&arrays);
                Some(format!("{name}.{}", self.random.usize(..length * width(ty))))
            }
            _ => {
                let all = if is_written { &self.targets } else { &self.numbers };
                let numbers: Vec<_> =
                    all.iter().filter(|number| has_bits(number.1)).cloned().collect();
                if numbers.is_empty() {
                    return None;
                }
                let (name, ty) = self.random.pick(&numbers);
                Some(self.bit_of(&name, ty))
            }
        }
    }

    fn bit_of(&mut self, name: &str, ty: &str) -> String {
        match ty {
            "BOOL" => name.to_owned(),
            _ => format!("{name}.{}", self.random.usize(..width(ty))),
        }
    }

    /// A number that an assignment can write, chosen while the program runs.
    pub fn target_element(&mut self) -> Option<(String, &'static str)> {
        self.chosen(|array| array.is_written && array.ty != "BOOL")
    }

    /// A value of a type by a function, a conversion or costly arithmetic; none if chance wants
    /// it plain.
    pub fn worked_out(&mut self, ty: &str, depth: u32) -> Option<String> {
        let is_pattern = matches!(ty, "WORD" | "DWORD");
        let number = |generator: &mut Self| generator.number(ty, depth - 1);
        Some(match self.random.u32(..10) {
            0 => {
                let (a, b) = (number(self), number(self));
                format!("{}({a}, {b})", self.random.pick(&["MIN", "MAX"]))
            }
            1 => {
                let list: Vec<String> = (0..3).map(|_| number(self)).collect();
                format!("LIMIT({})", list.join(", "))
            }
            2 => {
                let (a, b, condition) = (number(self), number(self), self.condition(0));
                format!("SEL({condition}, {a}, {b})")
            }
            3 => {
                let (to, from) = (format!("TO_{ty}"), self.random.pick(&self.numbers_and_bits()));
                format!("{to}({from})")
            }
            4 | 5 if is_pattern => {
                let (word, amount) = (number(self), self.integer());
                format!("{}({word}, {amount})", self.random.pick(&["SHL", "SHR", "ROL", "ROR"]))
            }
            4 if matches!(ty, "INT" | "DINT") => format!("ABS({})", number(self)),
            5 | 6 if !self.has_products => return None,
            5 | 6 if ty == "TIME" => {
                let (time, factor) = (number(self), self.integer());
                match self.random.u32(..3) {
                    0 => format!("({factor} * {time})"),
                    1 => format!("({time} * {factor})"),
                    _ => format!("({time} / {factor})"),
                }
            }
            5 | 6 if !is_pattern => {
                let operator = self.random.pick(&["*", "*", "/", "MOD"]);
                let a = number(self);
                let b = match operator {
                    // Divisors that are constant powers of two are circuits of their own.
                    "/" | "MOD" if self.random.bool() => self.divisor(ty).to_owned(),
                    _ => number(self),
                };
                if [&a, &b].into_iter().all(|side| self.is_literal(side)) {
                    return None;
                }
                format!("({a} {operator} {b})")
            }
            7 => {
                let wanted = ty.to_owned();
                self.chosen(move |array| array.ty == wanted)?.0
            }
            _ => return None,
        })
    }

    fn divisor(&mut self, ty: &str) -> &'static str {
        match ty {
            "INT" | "DINT" => self.random.pick(&["2", "4", "16", "10", "-8", "-1", "16384"]),
            _ => self.random.pick(&["2", "4", "16", "10", "32768"]),
        }
    }

    fn numbers_and_bits(&self) -> Vec<String> {
        let numbers = self.numbers.iter().map(|number| number.0.clone());
        let bits = self.bits.iter().filter(|bit| *bit != "first_scan").cloned();
        numbers.chain(bits).collect()
    }
}
