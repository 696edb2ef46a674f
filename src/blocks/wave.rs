//! Timing diagrams as text: drawn by hand from a block's document, printed in its docs and in the
//! HDL, and run as tests on its plain step and on its circuit.
//!
//! ```text
//! PT = 3
//! IN  _#######__
//! Q   ____####__
//! ET  0012333300
//! ```
//!
//! A line `NAME = value` gives a parameter its value, a setting its word, its number of ticks, its
//! number of words or its list `[1, 2]`, or another port its start. A row gives one character a
//! scan: `_` and `#` for 0 and 1, a digit for a number. A row `CV+2` or `CV-32760` shows `CV` with
//! that added, for numbers that are no digit. `IN` is the power; a row `tick` says which scans have
//! the tick (all, if there is none), a row `unit` which ones have the pulse of the block's unit of
//! time; a row `(R)` is the power of an `(R name)` that stands below the call.

use super::{Block, Choice, Shape};

/// A timing diagram.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Wave {
    /// What settings the call gives.
    pub chosen: Vec<Vec<i64>>,
    /// Parameters with the same value in every scan, and what other ports start with.
    pub constants: Vec<(String, i64)>,
    /// The power in each scan.
    pub power: Vec<bool>,
    /// Which scans have the tick.
    pub ticks: Vec<bool>,
    /// In which scans a reset coil behind the call is powered.
    pub clears: Vec<bool>,
    /// The value of other ports in each scan: parameters are given, outputs expected.
    pub rows: Vec<(String, Vec<i64>)>,
}

impl Wave {
    /// Reads a diagram of a block.
    ///
    /// # Errors
    /// What is wrong with it, in one sentence.
    pub fn parse(block: &'static Block, text: &str) -> Result<Wave, String> {
        let mut chosen = Shape::plain(block).chosen;
        let mut constants = Vec::new();
        let mut rows: Vec<(String, Vec<i64>)> = Vec::new();
        for line in text.lines() {
            if let Some((name, value)) = line.split_once('=') {
                let setting = block.settings.iter().position(|one| one.name == name.trim());
                if let Some(setting) = setting {
                    chosen[setting] = choose(&block.settings[setting].choice, value.trim())
                        .ok_or_else(|| format!("{line}: no such setting"))?;
                    continue;
                }
                let value = value.trim().parse().map_err(|error| format!("{line}: {error}"))?;
                constants.push((name.trim().to_owned(), value));
            } else {
                let (name, columns) =
                    line.split_once(' ').ok_or_else(|| format!("{line}: a row has no columns"))?;
                let (name, added) = offset(name)?;
                let value = |character| column(character).map(|shown| shown - added);
                let values = columns.trim().chars().map(value).collect::<Result<_, _>>()?;
                rows.push((name.to_owned(), values));
            }
        }
        let shape = Shape::new(block, chosen);
        for name in rows.iter().map(|row| &row.0).chain(constants.iter().map(|c| &c.0)) {
            let known =
                matches!(name.as_str(), "IN" | "tick" | "(R)") || shape.port_named(name).is_some();
            known.then_some(()).ok_or_else(|| format!("{} has no port {name}", block.name))?;
        }
        let length = rows.first().map_or(0, |row| row.1.len());
        if rows.iter().any(|row| row.1.len() != length) {
            return Err("the rows differ in length".to_owned());
        }
        let mut take = |name: &str| {
            let at = rows.iter().position(|row| row.0 == name)?;
            Some(rows.remove(at).1.into_iter().map(|value| value != 0).collect())
        };
        let power = take("IN").ok_or("there is no row IN")?;
        let ticks = take("tick").unwrap_or_else(|| vec![true; length]);
        let clears = take("(R)").unwrap_or_else(|| vec![false; length]);
        Ok(Wave { chosen: shape.chosen, constants, power, ticks, clears, rows })
    }
}

/// What a line says about a setting.
fn choose(choice: &Choice, text: &str) -> Option<Vec<i64>> {
    match choice {
        Choice::Word(words) => {
            words.iter().position(|word| *word == text).map(|word| vec![word as i64])
        }
        Choice::Time(..) => Some(vec![text.parse().ok()?]),
        Choice::Register { .. } => Some(vec![0; text.parse().ok()?]),
        Choice::List { .. } => {
            let items = text.strip_prefix('[')?.strip_suffix(']')?;
            items.split(',').map(|item| item.trim().parse().ok()).collect()
        }
    }
}

/// The port that a row shows, and what is added to its value.
fn offset(name: &str) -> Result<(&str, i64), String> {
    let Some(at) = name.find(['+', '-']) else { return Ok((name, 0)) };
    let added = name[at..].parse().map_err(|error| format!("{name}: {error}"))?;
    Ok((&name[..at], added))
}

fn column(character: char) -> Result<i64, String> {
    match character {
        '_' => Ok(0),
        '#' => Ok(1),
        _ => character
            .to_digit(10)
            .map(i64::from)
            .ok_or_else(|| format!("a column cannot be `{character}`")),
    }
}
