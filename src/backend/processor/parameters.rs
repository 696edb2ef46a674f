//! What a processor is built with for an image, as a line in the image's files.

use std::fmt::{self, Display, Formatter};

use super::rom::{Pins, Rom};
use super::sizes::Sizes;
use crate::quantity;

/// What the line begins with.
const MARK: &str = "ladder processor: ";
/// A quarter of the largest image.
const MOST_PINS: u16 = 256;

/// The parameters of the hardware that an image is made for: a line for people that is read back.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Parameters {
    /// The pins, if something says them.
    pub inputs: Option<u16>,
    /// The same.
    pub outputs: Option<u16>,
    /// The length of a tick in nanoseconds, if something says it.
    pub tick_ns: Option<u64>,
    /// The sizes; those of the papers where nothing says others.
    pub sizes: Sizes,
}

impl Parameters {
    /// Those of an image.
    pub fn of(rom: &Rom) -> Parameters {
        let Pins { inputs, outputs } = rom.pins;
        let (inputs, outputs) = (Some(inputs), Some(outputs));
        Parameters { inputs, outputs, tick_ns: Some(rom.tick_ns), sizes: rom.sizes }
    }

    /// Those that a line of the text tells, if it has such a line.
    ///
    /// # Errors
    /// The first that no processor has.
    pub fn read(text: &str) -> Result<Parameters, String> {
        let mut found = Parameters::default();
        let line = text.split_once(MARK).and_then(|(_, behind)| behind.lines().next());
        for pair in line.unwrap_or_default().split(',').map(str::trim) {
            if !pair.is_empty() && found.set(pair).is_none() {
                let shown: String = pair.chars().take(40).collect();
                return Err(format!("the first lines tell of `{shown}`, which no processor has"));
            }
        }
        Ok(found)
    }

    /// Sets one that is written as its name and its value.
    fn set(&mut self, pair: &str) -> Option<()> {
        let (name, value) = pair.split_once(' ')?;
        let pins = || value.parse().ok().filter(|pins| *pins <= MOST_PINS);
        let ticks = 1..=quantity::LONGEST_TICK_NS;
        match name {
            "INPUTS" => self.inputs = Some(pins()?),
            "OUTPUTS" => self.outputs = Some(pins()?),
            "TICK_NS" => {
                self.tick_ns = Some(value.parse().ok().filter(|tick| ticks.contains(tick))?)
            }
            _ => self.sizes.set(name, value.parse().ok()?).ok()?,
        }
        Some(())
    }
}

impl Display for Parameters {
    /// Sizes stand there where they are not those of the papers.
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(MARK)?;
        let named = [
            ("INPUTS", self.inputs.map(u64::from)),
            ("OUTPUTS", self.outputs.map(u64::from)),
            ("TICK_NS", self.tick_ns),
        ];
        let usual = Sizes::default().named();
        let sizes = self.sizes.named().into_iter().zip(usual);
        let unusual = sizes.filter(|(size, usual)| size != usual);
        let sizes = unusual.map(|((name, size), _)| (name, Some(size as u64)));
        let mut between = "";
        for (name, value) in named.into_iter().chain(sizes) {
            if let Some(value) = value {
                write!(f, "{between}{name} {value}")?;
                between = ", ";
            }
        }
        Ok(())
    }
}
