//! The tables of examples in docs/processor.md: which of them the ladder processor can do, with its
//! clocks for a scan, and what keeps the others from it. The tests of those that it can do pass
//! there.

mod common;

use std::collections::BTreeMap;
use std::fmt::Write;
use std::fs;

use common::analyze;
use hotrail::backend::processor::{self, Runner, clocks_of_scan};
use hotrail::eval::{self, Outcome};

const BEGIN: &str = "<!-- examples: written by tests/processor_examples.rs -->\n";
const END: &str = "<!-- end of examples -->\n";

/// Both tables.
fn tables() -> String {
    let mut can = String::from(
        "| example | words | clocks a scan | as a circuit, `flat` |\n|---|---|---|---|\n",
    );
    let mut cannot = String::from("| example | not on the processor |\n|---|---|\n");
    for example in common::examples() {
        let name = example.name();
        let text = fs::read_to_string(&example.ladder).unwrap();
        let program = analyze(&name, &text).unwrap();
        let link = format!("[{name}](../examples/{name})");
        match processor::compile(&program) {
            Ok(image) => {
                let (words, clocks) = (image.rom.code.len(), clocks_of_scan(&image.rom));
                writeln!(can, "| {link} | {words} | {clocks} | 1 |").unwrap();
            }
            Err(findings) => {
                let mut counts: BTreeMap<String, usize> = BTreeMap::new();
                for finding in findings {
                    let what = finding.message.replace("the ladder processor cannot do ", "");
                    *counts.entry(what).or_default() += 1;
                }
                let list: Vec<String> = counts
                    .into_iter()
                    .map(|(what, count)| match count {
                        1 => what,
                        _ => format!("{what} ({count} times)"),
                    })
                    .collect();
                writeln!(cannot, "| {link} | {} |", list.join(", ")).unwrap();
            }
        }
    }
    format!("\n{can}\n{cannot}\n")
}

#[test]
fn the_document_has_the_tables_of_examples() {
    let path = "docs/processor.md";
    let text = fs::read_to_string(path).unwrap();
    let (before, rest) = text.split_once(BEGIN).expect("the place is marked");
    let (_, after) = rest.split_once(END).expect("its end is marked");
    let meant = format!("{before}{BEGIN}{}{END}{after}", tables());
    if std::env::var_os("INSTA_UPDATE").is_some_and(|value| value == "always") {
        fs::write(path, meant).unwrap();
    } else {
        assert_eq!(text, meant, "run INSTA_UPDATE=always cargo test --test processor_examples");
    }
}

#[test]
fn tests_of_examples_pass_on_the_processor() {
    let mut ran = 0;
    for example in common::examples() {
        let text = fs::read_to_string(&example.ladder).unwrap();
        let program = analyze(&example.name(), &text).unwrap();
        let observed = eval::variables_of_tests(&program);
        let Ok(image) = processor::compile_observing(&program, &observed) else { continue };
        let mut runner = Runner::new(&program, &image);
        for test in &program.tests {
            let outcome = eval::run_test_on(&mut runner, &program, test);
            assert_eq!(outcome, Outcome::Passed, "{}: {}", example.name(), test.title);
        }
        ran += 1;
    }
    assert!(ran >= 21, "{ran}");
}
