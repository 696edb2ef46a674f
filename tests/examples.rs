//! Every folder of `examples/`: what it says of itself is true, and its golden files are what is
//! built today.

mod common;

use std::path::{Path, PathBuf};
use std::process::Command;

use common::examples;

fn hotrail(arguments: &[&str], file: &Path) -> (bool, String) {
    let output = Command::new(env!("CARGO_BIN_EXE_hotrail"))
        .args(arguments)
        .arg(file)
        .output()
        .expect("the program can be run");
    let text = String::from_utf8_lossy(&[output.stdout, output.stderr].concat()).into_owned();
    (output.status.success(), text)
}

#[test]
fn golden_files_are_what_is_built() {
    for example in examples() {
        let golden = example.folder.join("golden").display().to_string();
        let text = std::fs::read_to_string(&example.ladder).expect("it is there");
        let emit = match common::emulated::compile(&text) {
            Ok(_) => format!("{},{}", common::GOLDEN, common::GOLDEN_ROM),
            Err(_) => common::GOLDEN.to_owned(),
        };
        let build = ["build", "--check", "--emit", &emit, "--out", &golden];
        let (same, difference) = hotrail(&build, &example.ladder);
        assert!(
            same,
            "{difference}\nIf this is meant, run: hotrail build {} --emit {} -o {golden}",
            example.ladder.display(),
            emit
        );
    }
}

#[test]
fn examples_have_no_warnings_and_no_notes() {
    for example in examples() {
        assert_eq!(hotrail(&["check"], &example.ladder), (true, String::new()));
    }
}

#[test]
fn tests_of_examples_pass() {
    for example in examples() {
        let (passed, text) = hotrail(&["test", "--on", "evaluator,circuit"], &example.ladder);
        assert!(passed && !text.contains("running 0 tests"), "{text}");
    }
}

#[test]
fn every_example_has_a_readme_that_names_it() {
    let list = std::fs::read_to_string("examples/README.md").expect("the examples have a list");
    for example in examples() {
        let readme: PathBuf = example.folder.join("README.md");
        let text = std::fs::read_to_string(&readme).unwrap_or_default();
        assert!(text.starts_with("# "), "{} has no heading", readme.display());
        let name = example.name();
        assert!(list.contains(&format!("({name})")), "examples/README.md does not name {name}");
    }
}
