//! What a call fixes for good: words, units of time and lists of constants.

use super::{Block, Follows, Port, PortRole, Start};
use crate::types::Type;

/// A parameter that takes a constant and decides how the block is built.
#[derive(Debug)]
pub struct Setting {
    /// As written before `:=` in a call.
    pub name: &'static str,
    /// What it can be.
    pub choice: Choice,
    /// Meaning.
    pub doc: &'static str,
}

/// What a setting can be.
#[derive(Debug)]
pub enum Choice {
    /// One of these words; the first where the call gives none. Kept as its number.
    Word(&'static [&'static str]),
    /// One of these lengths of time in nanoseconds; the second is what it is where the call gives
    /// none. Kept in ticks.
    Time(&'static [u64], u64),
    /// A register of so many words at most: a `WORD` or an array of them. Kept as a list with an
    /// item for each word.
    Register {
        /// The number of words at most.
        most: usize,
    },
    /// A list of numbers; empty where the call gives none.
    List {
        /// Smallest number.
        low: i64,
        /// Largest number.
        high: i64,
        /// The number of items at most.
        most: usize,
    },
}

impl Choice {
    /// What it is where the call gives none, with ticks of so many nanoseconds. `None` if a time
    /// is no whole number of ticks.
    pub fn otherwise(&self, tick_ns: u64) -> Option<Vec<i64>> {
        match self {
            Choice::Word(_) => Some(vec![0]),
            Choice::Time(_, ns) => ns.is_multiple_of(tick_ns).then(|| vec![(ns / tick_ns) as i64]),
            Choice::Register { .. } => Some(vec![0]),
            Choice::List { .. } => Some(Vec::new()),
        }
    }
}

/// A block with its settings: the ports that it has then.
#[derive(Clone, Debug)]
pub struct Shape {
    /// The kind.
    pub block: &'static Block,
    /// What each of the block's settings is.
    pub chosen: Vec<Vec<i64>>,
    /// Its ports.
    pub ports: Vec<Port>,
}

impl Shape {
    /// The block with these settings, in the order of [`Block::settings`].
    pub fn new(block: &'static Block, chosen: Vec<Vec<i64>>) -> Shape {
        let mut shape = Shape { block, chosen, ports: Vec::new() };
        for port in block.ports {
            match port.follows {
                Follows::Nothing => shape.ports.push(*port),
                Follows::TypeOf(setting) => {
                    let ty = Type::named(shape.word(setting)).expect("the words are types");
                    shape.ports.push(port.fitted(ty));
                }
                Follows::ItemOf(setting, item) if item < shape.list(setting).len() => {
                    shape.ports.push(*port);
                }
                Follows::ItemOf(..) => {}
            }
        }
        shape
    }

    /// The block as a call without settings has it, with a tick of a millisecond.
    pub fn plain(block: &'static Block) -> Shape {
        let tick_ns = 1_000_000;
        let otherwise = |setting: &Setting| setting.choice.otherwise(tick_ns);
        let chosen = block.settings.iter().map(otherwise).collect::<Option<_>>();
        Shape::new(block, chosen.expect("every unit is a multiple of 1 ms"))
    }

    /// The word that a setting is.
    pub fn word(&self, setting: &str) -> &'static str {
        match self.block.settings[self.setting(setting)].choice {
            Choice::Word(words) => words[self.number(setting) as usize],
            _ => panic!("{setting} is no word"),
        }
    }

    /// The number that a setting is: for a time the number of ticks.
    pub fn number(&self, setting: &str) -> i64 {
        self.chosen[self.setting(setting)][0]
    }

    /// The list that a setting is.
    pub fn list(&self, setting: &str) -> &[i64] {
        &self.chosen[self.setting(setting)]
    }

    fn setting(&self, name: &str) -> usize {
        let found = self.block.settings.iter().position(|setting| setting.name == name);
        found.unwrap_or_else(|| panic!("{} has no setting {name}", self.block.name))
    }

    /// The settings that are not what they are where a call gives none, as a call would say them.
    pub fn described(&self) -> Vec<String> {
        let described = |(setting, chosen): (&Setting, &Vec<i64>)| match setting.choice {
            Choice::Word(words) => (chosen[0] != 0)
                .then(|| format!("{} = {}", setting.name, words[chosen[0] as usize])),
            Choice::Time(..) => {
                let unit = if chosen[0] == 1 { "tick" } else { "ticks" };
                Some(format!("{} = {} {unit}", setting.name, chosen[0]))
            }
            Choice::Register { .. } => {
                let bits = 16 * chosen.len();
                Some(format!("{} has {bits} bits", setting.name))
            }
            Choice::List { .. } => {
                let items: Vec<String> = chosen.iter().map(i64::to_string).collect();
                (!items.is_empty()).then(|| format!("{} = [{}]", setting.name, items.join(", ")))
            }
        };
        self.block.settings.iter().zip(&self.chosen).filter_map(described).collect()
    }

    /// The index of the port of that name.
    pub fn port_named(&self, name: &str) -> Option<usize> {
        self.ports.iter().position(|port| port.name == name)
    }

    /// The unit of time that the block counts instead of ticks, in nanoseconds.
    pub fn unit_ns(&self, tick_ns: u64) -> Option<u64> {
        let pulse = self.ports.iter().find_map(|port| match port.role {
            PortRole::Pulse(unit) => Some(unit),
            _ => None,
        });
        let is_time = |setting: &Setting| matches!(setting.choice, Choice::Time(..));
        let base = self.block.settings.iter().position(is_time);
        pulse.or_else(|| base.map(|base| self.chosen[base][0] as u64 * tick_ns))
    }

    /// The type of a port.
    pub fn ty(&self, port: &str) -> Type {
        self.ports[self.expect_port(port)].ty
    }

    /// The index of the output that goes on to the right, if it is not the power itself.
    pub fn main_port(&self) -> Option<usize> {
        self.block.main.and_then(|name| self.port_named(name))
    }

    /// What each port is at reset, given what the call says about it, as it is at reset.
    pub fn starts(&self, given: impl Fn(usize) -> Option<i64>) -> Vec<i64> {
        let start = |(index, port): (usize, &Port)| match (port.start, given(index)) {
            (_, Some(value)) if port.role.is_loaded() => value,
            (Start::Value(value), _) => value,
            (Start::Preset(name), _) => {
                let preset = self.expect_port(name);
                self.ports[preset].role.within(given(preset).unwrap_or(0))
            }
        };
        self.ports.iter().enumerate().map(start).collect()
    }

    pub(super) fn expect_port(&self, name: &str) -> usize {
        self.port_named(name).unwrap_or_else(|| panic!("{} has no port {name}", self.block.name))
    }
}
