//! Plants faults in a copy of the project, all at once and each behind a switch, so that one build runs
//! them all: `plant TREE < LIST`, where LIST is what `cargo mutants --list --json` prints.
//!
//! A program built from TREE has the fault of the number that `HOTRAIL_FAULT` says, or none.
//! `TREE/planted.tsv` has a line for each fault: its number, how it is planted, its name. Planted it is behind a
//! `switch`, or `alone` if it cannot stand behind one, or it is `refused` by the compiler of Rust.

mod edit;
mod fault;

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::{env, fs, io};

use anyhow::{Context, Result, bail};
use serde_json::Value;

use fault::{Fault, Genre};

/// What the library of the project gets: the look at the switch.
const SWITCH: &str = "
#[doc(hidden)]
pub fn planted(number: u32) -> bool {
    static NUMBER: std::sync::LazyLock<Option<u32>> =
        std::sync::LazyLock::new(|| std::env::var(\"HOTRAIL_FAULT\").ok()?.parse().ok());
    *NUMBER == Some(number)
}
";

/// The errors of a `match` that misses an arm, and of a call in a function that has to be constant.
const MISSING_ARM: &str = "E0004";
const IN_CONSTANT: &str = "E0015";

fn main() -> Result<()> {
    let tree = PathBuf::from(env::args().nth(1).context("plant TREE < LIST")?);
    let faults: Vec<Fault> = serde_json::from_reader(io::stdin())?;
    let mut texts: BTreeMap<&str, String> = BTreeMap::new();
    for fault in &faults {
        if !texts.contains_key(&*fault.file) {
            texts.insert(&fault.file, fs::read_to_string(tree.join(&fault.file))?);
        }
    }
    let library = tree.join("src/lib.rs");
    fs::write(&library, fs::read_to_string(&library)? + SWITCH)?;

    let mut how = vec![How::Switch; faults.len()];
    loop {
        for (file, text) in &texts {
            let here = |(number, fault): &(usize, &Fault)| {
                fault.file == *file && how[*number] == How::Switch
            };
            let chosen: Vec<_> = faults.iter().enumerate().filter(here).collect();
            let (text, left) = edit::plant(text, &chosen)?;
            fs::write(tree.join(file), text)?;
            left.into_iter().for_each(|number| how[number] = How::Alone);
        }
        let errors = errors(&tree)?;
        eprintln!("{} errors of the compiler of Rust", errors.len());
        if errors.is_empty() {
            break;
        }
        for (number, code) in errors {
            // What a body may not be, a `return` may not have, but for functions that look at no switch.
            let is_refused = faults[number].genre == Genre::FnValue && code != IN_CONSTANT;
            how[number] = if is_refused { How::Refused } else { How::Alone };
        }
    }
    let mut table = String::new();
    for ((number, fault), how) in faults.iter().enumerate().zip(how) {
        let how = format!("{how:?}").to_lowercase();
        writeln!(table, "{number}\t{how}\t{}", fault.name)?;
    }
    fs::write(tree.join("planted.tsv"), table)?;
    Ok(())
}

/// How a fault is planted.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
enum How {
    Switch,
    Alone,
    Refused,
}

/// The errors that the compiler of Rust tells of: the fault that each is of, and its code.
fn errors(tree: &Path) -> Result<Vec<(usize, String)>> {
    let check = Command::new("cargo")
        .args(["check", "--lib", "--quiet", "--message-format=json"])
        .env("RUSTFLAGS", "--cap-lints=allow")
        .current_dir(tree)
        .stderr(Stdio::null())
        .output()?;
    let mut found = Vec::new();
    for line in String::from_utf8(check.stdout)?.lines() {
        let message: Value = serde_json::from_str(line)?;
        let message = &message["message"];
        let (Some(code), "error") =
            (message["code"]["code"].as_str(), message["level"].as_str().unwrap_or_default())
        else {
            continue;
        };
        let number = if code == MISSING_ARM {
            // It tells of the `match`; what it proposes stands behind the last arm.
            let proposals = message["children"].as_array().into_iter().flatten();
            let behind = proposals.filter_map(|proposal| proposal["spans"].get(0));
            behind.filter_map(|span| number_at(tree, span, " if !crate::planted(")).next()
        } else {
            let spans = message["spans"].as_array().into_iter().flatten();
            let (primary, others): (Vec<_>, Vec<_>) =
                spans.partition(|span| span["is_primary"] == true);
            let mut places = primary.into_iter().chain(others);
            places.find_map(|span| number_at(tree, span, "crate::planted("))
        };
        let number =
            number.with_context(|| format!("no planted fault: {}", message["rendered"]))?;
        found.push((number, code.to_owned()));
    }
    if !check.status.success() && found.is_empty() {
        bail!("`cargo check` fails without an error in a file");
    }
    Ok(found)
}

/// The fault at a place that the compiler of Rust tells of: its switch stands before the end of the place, on
/// the same line if there is one.
fn number_at(tree: &Path, span: &Value, switch: &str) -> Option<usize> {
    let text = fs::read_to_string(tree.join(span["file_name"].as_str()?)).ok()?;
    let (before, after) = text.split_at(span["byte_end"].as_u64()? as usize);
    let number = |rest: &str| rest.split_once(')')?.0.parse().ok();
    let last = |text: &str| text.rsplit_once(switch).and_then(|(_, rest)| number(rest));
    let first = |text: &str| text.split_once(switch).and_then(|(_, rest)| number(rest));
    last(before.lines().next_back()?)
        .or_else(|| first(after.lines().next()?))
        .or_else(|| last(before))
}
