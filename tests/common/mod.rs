//! What several test files need.
#![allow(dead_code, reason = "each test file uses a part of it")]

pub mod bench;
pub mod bulk;
pub mod checks;
pub mod designs;
pub mod dice;
pub mod emulated;
pub mod folder;
pub mod generate;
pub mod interpreter;
pub mod lockstep;
pub mod lp;
pub mod proof;
pub mod recorded;
pub mod relay;
pub mod reordered;
pub mod scheduled;
pub mod shrink;
#[cfg(feature = "cli")]
pub mod targets;
pub mod trees;
pub mod variants;

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use hotrail::diagnostic;
use hotrail::model::Program;
use hotrail::source::Source;

/// The checked program of a text, or what a user reads.
pub fn analyze(name: &str, text: &str) -> Result<Program, String> {
    let source = Source::new(name, text);
    let (program, diagnostics) = hotrail::analyze(&source);
    program.ok_or_else(|| {
        diagnostics.iter().map(|found| diagnostic::render(found, &source, false)).collect()
    })
}

/// True if a tool can be started. Where it is missing the test says so and passes, unless
/// `HOTRAIL_REQUIRE_TOOLS=1`.
///
/// # Panics
/// If the tool is missing and required.
pub fn require_tool(name: &str) -> bool {
    let found = Command::new(name)
        .arg(if name == "iverilog" { "-V" } else { "--version" })
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status()
        .is_ok();
    if !found {
        let required = std::env::var_os("HOTRAIL_REQUIRE_TOOLS").is_some_and(|value| value == "1");
        assert!(!required, "{name} is missing and HOTRAIL_REQUIRE_TOOLS=1");
        eprintln!("SKIPPED: {name} is missing");
    }
    found
}

/// Runs a tool in a folder and returns what it wrote.
///
/// # Panics
/// If it fails; the message has all that it wrote.
pub fn run(folder: &Path, tool: &str, arguments: &[&str]) -> String {
    let output = Command::new(tool)
        .args(arguments)
        .current_dir(folder)
        .stdin(Stdio::null())
        .output()
        .unwrap_or_else(|error| panic!("{tool}: {error}"));
    let text = String::from_utf8_lossy(&[output.stdout, output.stderr].concat()).into_owned();
    assert!(output.status.success(), "{tool} {arguments:?}: {}\n{text}", output.status);
    text
}

/// What an example's `golden` folder holds, as `hotrail build --emit` takes it.
pub const GOLDEN: &str = "verilog,vhdl,testbench,wrapper";
/// What it holds besides where the ladder processor can do the example.
pub const GOLDEN_ROM: &str = "rom,listing";

/// One folder of `examples/`.
pub struct Example {
    /// The folder.
    pub folder: PathBuf,
    /// The ladder in it.
    pub ladder: PathBuf,
}

impl Example {
    /// The name of the folder, of the ladder and of its program.
    pub fn name(&self) -> String {
        let name = self.folder.file_name().expect("a folder has a name");
        name.to_string_lossy().into_owned()
    }
}

/// A number from the environment, for how much a random test does.
pub fn amount(variable: &str, otherwise: u64) -> u64 {
    let given = std::env::var(variable).ok();
    given.map_or(otherwise, |text| text.parse().expect("an amount is a number"))
}

/// The programs of the examples, with their paths.
pub fn example_programs() -> impl Iterator<Item = (String, Program)> {
    examples().into_iter().map(|example| checked(&example.ladder))
}

/// Programs that once showed a mistake, or show what chance seldom brings, with their paths:
/// `tests/lockstep`. They are kept as texts, because a change to the generator changes what a seed means.
///
/// # Panics
/// If there is none.
pub fn kept_programs() -> impl Iterator<Item = (String, Program)> {
    kept_paths().into_iter().map(|path| checked(&path))
}

/// Where the kept programs are, in order of their names.
pub fn kept_paths() -> Vec<PathBuf> {
    let entries = std::fs::read_dir("tests/lockstep").expect("there are kept programs");
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    assert!(!paths.is_empty());
    paths
}

fn checked(path: &Path) -> (String, Program) {
    let name = path.display().to_string();
    let text = std::fs::read_to_string(path).unwrap();
    let program = analyze(&name, &text).unwrap_or_else(|findings| panic!("{findings}"));
    (name, program)
}

/// Every example, in order of its name.
///
/// # Panics
/// If there is none, or one has no ladder of its own name.
pub fn examples() -> Vec<Example> {
    let entries = std::fs::read_dir("examples").expect("there are examples");
    let folders = entries.map(|entry| entry.expect("the folder can be read").path());
    let mut folders: Vec<PathBuf> = folders.filter(|path| path.is_dir()).collect();
    folders.sort();
    assert!(!folders.is_empty());
    let examples = folders.into_iter().map(|folder| {
        let name = folder.file_name().expect("a folder has a name").to_owned();
        let ladder = folder.join(name).with_extension("ladder");
        assert!(ladder.is_file(), "{} is missing", ladder.display());
        Example { folder, ladder }
    });
    examples.collect()
}

/// What a node of a network is called: the ends of it are 0 and 1.
pub fn node_name(node: usize) -> String {
    match node {
        0 => "left".to_owned(),
        1 => "right".to_owned(),
        _ => format!("n{node}"),
    }
}
