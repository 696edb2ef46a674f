//! The block reference, written from the registry: what `docs/blocks.md` and `hotrail blocks` say.

use std::fmt::Write;

use super::{ALL, Block, Choice, Follows, Port, PortRole, Setting, Start};
use crate::quantity::time_text;
use crate::types::Type;

const INTRODUCTION: &str = "\
# Function blocks

This page is made from the compiler's own tables; a test holds it to them. How a block is called, what
`(R name)` does and how members are read says [the language reference](language.md#blocks).

In a timing diagram one column is one scan. `IN` is the power that arrives. `_` and `#` are off and on, a
digit is a number, and `CV+2` stands for `CV` with 2 added. Where there is no row `tick`, every scan has the
tick. `(R)` is the power of an `(R name)` that stands below the call. A line `CV = 32766` says where a value
starts. For blocks that count units of time a row `unit` says which scans have the pulse of the unit; where
there is none, all have.
";

/// The whole reference, as Markdown.
pub fn page() -> String {
    let mut text = INTRODUCTION.to_owned();
    for block in ALL {
        text.push('\n');
        text += &section(block);
    }
    text
}

/// One line for each block: its kind and what it is called in words.
pub fn list() -> String {
    let width = ALL.iter().map(|block| block.name.len()).max().unwrap_or(0);
    ALL.iter().fold(String::new(), |mut text, block| {
        let _ = writeln!(text, "{:width$}  {}", block.name, block.title);
        text
    })
}

/// What the reference says about one block, as Markdown.
pub fn section(block: &Block) -> String {
    let mut text = format!("## {}, the {}\n\n", block.name, block.title);
    wrap(&mut text, block.doc);
    text += "\n| name | type | kind | meaning |\n|---|---|---|---|\n";
    for setting in block.settings {
        let (ty, range) = constants(setting);
        let Setting { name, doc, .. } = setting;
        let _ = writeln!(text, "| `{name}` | {ty} | parameter, {range} | {doc} |");
    }
    let is_shown = |port: &&Port| {
        let is_further_item = matches!(port.follows, Follows::ItemOf(_, item) if item > 0);
        (port.role.is_parameter() || port.role.is_member()) && !is_further_item
    };
    for port in block.ports.iter().filter(is_shown) {
        let (name, ty) = (name(port), type_name(port));
        let _ = writeln!(text, "| {name} | {ty} | {} | {} |", kind(block, port), port.doc);
    }
    for wave in block.waves {
        let _ = write!(text, "\n```text\n{wave}\n```\n");
    }
    text
}

/// What a setting takes, in words.
fn constants(setting: &Setting) -> (&'static str, String) {
    let time = |ns: u64| format!("`{}`", time_text(ns.into()));
    match setting.choice {
        Choice::Word(words) => {
            let all: Vec<String> = words.iter().map(|word| format!("`{word}`")).collect();
            ("word", format!("{}; else {}", all.join(", "), all[0]))
        }
        Choice::Time(lengths, otherwise) => {
            let all: Vec<String> = lengths.iter().map(|&ns| time(ns)).collect();
            ("`TIME`", format!("{}; else {}", all.join(", "), time(otherwise)))
        }
        Choice::Register { most } => {
            ("`WORD`", format!("a variable or an array of 1 to {most}, must be given"))
        }
        Choice::List { low, high, most } => {
            ("list", format!("1 to {most} constants {low} to {high}"))
        }
    }
}

fn name(port: &Port) -> String {
    match port.follows {
        Follows::ItemOf(..) => format!("`{}` and on", port.name),
        _ => format!("`{}`", port.name),
    }
}

fn type_name(port: &Port) -> String {
    match port.follows {
        Follows::TypeOf(setting) => format!("`{setting}`"),
        _ => format!("`{}`", port.ty),
    }
}

/// What a port is there for, in words.
fn kind(block: &Block, port: &Port) -> String {
    let mut words = match port.role {
        PortRole::Circuit => "parameter, a network".to_owned(),
        PortRole::Preset { low, high } => {
            let unit = if port.ty == Type::Time { " ticks" } else { "" };
            format!("parameter, constants {low} to {high}{unit}")
        }
        PortRole::Loaded { low, high } | PortRole::Accumulator(Some((low, high))) => {
            format!("parameter, its start, constants {low} to {high}; can be assigned")
        }
        PortRole::Accumulator(None) => "can be assigned".to_owned(),
        PortRole::Output if block.main == Some(port.name) => "output, goes on to the right".into(),
        PortRole::Output
        | PortRole::State
        | PortRole::Memory
        | PortRole::Pulse(_)
        | PortRole::Register
        | PortRole::Shared { .. } => "output".to_owned(),
        PortRole::Idle { .. } => {
            format!("output of {}", block.partner.expect("another call writes it"))
        }
    };
    match port.start {
        Start::Value(0) => {}
        Start::Value(1) if port.role == PortRole::Circuit => words += "; left out, it is on",
        Start::Value(value) => words += &format!(", starts at {value}"),
        Start::Preset(preset) => words += &format!(", starts at `{preset}`"),
    }
    words
}

/// Appends a text in lines of at most 100 characters.
fn wrap(text: &mut String, words: &str) {
    let mut length = 0;
    for word in words.split(' ') {
        if length > 0 && length + word.len() >= 100 {
            text.push('\n');
            length = 0;
        } else if length > 0 {
            text.push(' ');
            length += 1;
        }
        text.push_str(word);
        length += word.len();
    }
    text.push('\n');
}
