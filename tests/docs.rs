//! Every piece of ladder in the documents is a program that compiles, and whose tests pass.
//!
//! A fenced block is tagged `ladder`. If it does not start with the word `ladder` it is a fragment:
//! what it needs besides is written into a comment right before it, which no reader sees:
//!
//! ```text
//! <!-- with: input a  output y -->
//! ```
//!
//! A code after the tag, as in `ladder E0006`, says that every line is a mistake of that kind.

use std::fs;
use std::path::Path;

use hotrail::blocks::Follows;
use hotrail::diagnostic;
use hotrail::eval::{Outcome, run_test};
use hotrail::lint;
use hotrail::source::Source;

const DOCUMENTS: &[&str] =
    &["docs/language.md", "docs/schedules.md", "docs/timers.md", "README.md"];

struct Block {
    /// Document and line.
    place: String,
    /// The code that every line has, if they are mistakes.
    fails: Option<String>,
    /// What a fragment needs.
    with: String,
    text: String,
}

impl Block {
    /// A whole program, made of the block's text or of a part of it.
    fn program(&self, text: &str) -> Source {
        let is_whole = text
            .lines()
            .find(|line| !line.is_empty() && !line.starts_with("//"))
            .is_some_and(|line| line.starts_with("ladder "));
        let text = match is_whole {
            true => text.to_owned(),
            // The fragment's own declarations and rungs come first.
            false => format!("ladder fragment\n{text}\n{}\n", self.with),
        };
        Source::new(self.place.clone(), text)
    }
}

fn blocks(document: &str) -> Vec<Block> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(document);
    let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{document}: {error}"));
    let mut blocks = Vec::new();
    let mut with = "";
    let mut open: Option<Block> = None;
    for (number, line) in text.lines().enumerate() {
        match (&mut open, line.strip_prefix("```")) {
            (None, Some(tag)) => {
                let fails = tag.strip_prefix("ladder ").map(str::to_owned);
                let place = format!("{document}:{}", number + 1);
                let with = std::mem::take(&mut with).to_owned();
                // Blocks of other languages are read to their end and dropped.
                let place = if tag.starts_with("ladder") { place } else { String::new() };
                open = Some(Block { place, fails, with, text: String::new() });
            }
            (Some(block), None) => {
                block.text += line;
                block.text.push('\n');
            }
            (Some(_), Some(_)) => blocks.extend(open.take().filter(|b| !b.place.is_empty())),
            (None, None) => {
                let comment = line.strip_prefix("<!-- with: ");
                with = comment.and_then(|rest| rest.strip_suffix(" -->")).unwrap_or_default();
            }
        }
    }
    assert!(open.is_none(), "{document}: a block is not closed");
    blocks
}

fn all_blocks() -> Vec<Block> {
    DOCUMENTS.iter().flat_map(|document| blocks(document)).collect()
}

#[test]
fn every_ladder_compiles_and_passes_its_tests() {
    let mut tests = 0;
    for block in all_blocks().iter().filter(|block| block.fails.is_none()) {
        let source = block.program(&block.text);
        // A fragment shows one thing; what it leaves unused says nothing about it.
        let lints = lint::Options { off: true, ..lint::Options::default() };
        let (program, findings) = hotrail::analyze_with(&source, &lints);
        let texts: String =
            findings.iter().map(|finding| diagnostic::render(finding, &source, false)).collect();
        assert!(findings.is_empty(), "{}\n{texts}", block.place);
        let program = program.expect("nothing was found");
        for test in &program.tests {
            let outcome = run_test(&program, test);
            assert_eq!(outcome, Outcome::Passed, "{}: {}", block.place, test.title);
            tests += 1;
        }
    }
    assert!(tests > 10, "only {tests} tests");
}

#[test]
fn every_mistake_is_reported_as_it_says() {
    let mut lines = 0;
    for block in all_blocks() {
        let Some(code) = &block.fails else { continue };
        for line in block.text.lines() {
            let (_, findings) = hotrail::analyze(&block.program(line));
            let found: Vec<_> = findings.iter().map(|finding| finding.code.id).collect();
            assert_eq!(found, [code], "{}: {line}", block.place);
            lines += 1;
        }
    }
    assert!(lines > 3, "only {lines} lines");
}

/// The blocks' own diagrams and ports are what the document shows of them.
#[test]
fn the_reference_shows_every_block() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/language.md");
    let text = fs::read_to_string(path).unwrap();
    for block in hotrail::blocks::ALL {
        let is_about = |section: &&str| {
            let heading = section.lines().next().unwrap();
            heading.split([' ', ',']).any(|word| word == block.name)
        };
        let section = text.split("\n### ").skip(1).find(is_about);
        let section = section.unwrap_or_else(|| panic!("no section about {}", block.name));
        let section = section.split("\n## ").next().unwrap();
        // The other diagrams stand in the block reference.
        let rows = block.waves[0].lines().filter(|line| !line.contains(" = "));
        let rows = rows.collect::<Vec<_>>().join("\n");
        assert!(section.contains(&rows), "the diagram of {} is\n{rows}", block.name);
        let is_shown = |role: hotrail::blocks::PortRole| role.is_parameter() || role.is_member();
        for port in block.ports.iter().filter(|port| is_shown(port.role)) {
            let row = match port.follows {
                Follows::TypeOf(setting) => format!("| `{}` | `{setting}` |", port.name),
                Follows::ItemOf(_, item) if item > 0 => continue,
                _ => format!("| `{}` | `{}` |", port.name, port.ty),
            };
            assert!(section.contains(&row), "{}: {row}", block.name);
        }
        for setting in block.settings {
            assert!(section.contains(&format!("| `{}` |", setting.name)), "{}", block.name);
        }
    }
}

/// The table of types is the one that the compiler has.
#[test]
fn the_reference_shows_every_type() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/language.md");
    let text = fs::read_to_string(path).unwrap();
    for ty in hotrail::types::Type::ALL {
        let bits = if ty.width() == 1 { "bit" } else { "bits" };
        let row = format!("| `{ty}` | {} {bits} | ", ty.width());
        let start = text.find(&row).unwrap_or_else(|| panic!("no row {row}"));
        if ty.is_number() {
            let (low, high) = ty.range();
            let values = format!("{low} to {high}");
            assert!(text[start + row.len()..].starts_with(&values), "{ty} has {values}");
        }
    }
}
