//! The block reference, written from the registry: what `docs/blocks.md` and `hotrail blocks` say.

use std::fmt::Write;

use super::{ALL, Block, Port, PortRole, Start};
use crate::types::Type;

const INTRODUCTION: &str = "\
# Function blocks

This page is made from the compiler's own tables; a test holds it to them. How a block is called, what
`(R name)` does and how members are read says [the language reference](language.md#blocks).

In a timing diagram one column is one scan. `IN` is the power that arrives. `_` and `#` are off and on, a
digit is a number, and `CV+2` stands for `CV` with 2 added. Where there is no row `tick`, every scan has the
tick. `(R)` is the power of an `(R name)` that stands below the call. A line `CV = 32766` says where a value
starts.
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
    let is_shown = |port: &&Port| port.role.is_parameter() || port.role.is_member();
    for port in block.ports.iter().filter(is_shown) {
        let _ = writeln!(
            text,
            "| `{}` | `{}` | {} | {} |",
            port.name,
            port.ty,
            kind(block, port),
            port.doc
        );
    }
    for wave in block.waves {
        let _ = write!(text, "\n```text\n{wave}\n```\n");
    }
    text
}

/// What a port is there for, in words.
fn kind(block: &Block, port: &Port) -> String {
    let mut words = match port.role {
        PortRole::Circuit => "parameter, a network".to_owned(),
        PortRole::Preset { low, high } => {
            let unit = if port.ty == Type::Time { " ticks" } else { "" };
            format!("parameter, constants {low} to {high}{unit}")
        }
        PortRole::Output if block.main == Some(port.name) => "output, goes on to the right".into(),
        PortRole::Output | PortRole::State | PortRole::Memory => "output".to_owned(),
    };
    match port.start {
        Start::Value(0) => {}
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
