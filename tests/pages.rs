//! Every code has a page; what its examples show is true.

use std::path::Path;
use std::process::{Command, Output};

use hotrail::backend::processor;
use hotrail::diagnostic::{self, Code, code};
use hotrail::eval::{Outcome, run_test};
use hotrail::source::Source;

/// Marks the page of a code that is about files and not about what stands in them.
const NO_LADDER: &str = "<!-- no ladder shows it -->";

/// The ladder under a heading of a page.
fn example(code: Code, heading: &str) -> Source {
    let section = code.page().split(&format!("\n## {heading}\n\n```ladder\n")).nth(1);
    let text = section.and_then(|rest| rest.split_once("```")).map(|(text, _)| text);
    let text = text.unwrap_or_else(|| panic!("{}: no example under {heading}", code.id));
    Source::new(format!("{}.md", code.id), text)
}

/// What check and test find in a source, and how it reads.
fn findings(source: &Source) -> (Vec<&'static str>, String) {
    let (program, findings) = hotrail::analyze(source);
    let mut codes: Vec<_> = findings.iter().map(|finding| finding.code.id).collect();
    let texts = findings.iter().map(|finding| diagnostic::render(finding, source, false)).collect();
    // What is wrong for one target is found where a program is built for it.
    if source.name().starts_with("E08") {
        let program = program.as_ref().expect("the program is sound");
        let refused = processor::compile(program).err().into_iter().flatten();
        codes.extend(refused.map(|finding| finding.code.id));
    }
    for test in program.iter().flat_map(|program| &program.tests) {
        if run_test(program.as_ref().unwrap(), test) != Outcome::Passed {
            codes.push(code::EXPECTATION.id);
        }
    }
    (codes, texts)
}

fn shown_by_ladder() -> impl Iterator<Item = Code> {
    code::ALL.iter().copied().filter(|code| !code.page().contains(NO_LADDER))
}

#[test]
fn the_bad_example_has_the_code_of_its_page_and_no_other() {
    for code in shown_by_ladder() {
        let (found, texts) = findings(&example(code, "Has it"));
        assert_eq!(found, [code.id], "{texts}");
    }
}

#[test]
fn the_good_example_has_nothing() {
    for code in shown_by_ladder() {
        let (found, texts) = findings(&example(code, "Does not"));
        assert!(found.is_empty(), "{}: {texts}", code.id);
    }
}

#[test]
fn only_codes_about_files_have_no_ladder() {
    let without = code::ALL.iter().filter(|code| code.page().contains(NO_LADDER));
    let without: Vec<_> = without.map(|code| code.id).collect();
    assert_eq!(
        without,
        ["E0005", "E0601", "E0602", "E0603", "E0701", "E0702", "E0703", "E0803", "E0804"]
    );
}

#[test]
fn a_page_starts_with_its_code_and_says_how_to_mend_it() {
    for code in code::ALL {
        let heading = format!("# {}: {}\n\n", code.id, code.title);
        assert!(code.page().starts_with(&heading), "{} does not start with {heading}", code.id);
        assert!(code.page().contains("\n## How to mend it\n\n"), "{}", code.id);
        let too_wide = code
            .page()
            .lines()
            .find(|line| line.chars().count() > 120 && !line.starts_with("input"));
        assert_eq!(too_wide, None, "{}", code.id);
        assert!(code.summary().ends_with(['.', ';']), "{}: {}", code.id, code.summary());
    }
}

#[test]
fn the_folder_holds_no_page_without_a_code() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/errors");
    for entry in std::fs::read_dir(folder).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        let id = name.strip_suffix(".md").unwrap_or_else(|| panic!("{name} is no page"));
        assert!(code::ALL.iter().any(|code| code.id == id), "{name} belongs to no code");
    }
}

#[test]
fn the_page_about_lints_lists_every_one() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/lints.md");
    let text = std::fs::read_to_string(path).unwrap();
    for code in code::ALL.iter().filter(|code| code.is_lint()) {
        let row =
            format!("| [{0}](errors/{0}.md) | `{1}` | {2} |", code.id, code.name(), code.severity);
        assert!(text.contains(&row), "no row {row}");
    }
}

#[test]
fn the_page_about_lints_allows_what_its_example_has() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/lints.md");
    let text = std::fs::read_to_string(path).unwrap();
    let ladder = text.split("```ladder\n").nth(1).unwrap().split("```").next().unwrap();
    assert_eq!(findings(&Source::new("lints.md", ladder)).0, [""; 0]);
    let bare = ladder.replace("allow(", "(");
    assert_eq!(findings(&Source::new("lints.md", bare)).0, ["W0103", "W0303", "W0305"]);
}

fn explain(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_hotrail")).arg("explain").args(arguments).output().unwrap()
}

#[test]
fn explain_prints_the_page_of_a_code_or_name() {
    for name in ["W0301", "w0301", "double-coil"] {
        let output = explain(&[name]);
        assert!(output.status.success());
        assert_eq!(String::from_utf8(output.stdout).unwrap(), code::DOUBLE_COIL.page());
    }
    let unknown = explain(&["W0331"]);
    assert_eq!(unknown.status.code(), Some(2));
    let text = String::from_utf8(unknown.stderr).unwrap();
    assert!(text.contains("is W0301 meant?"), "{text}");
}

#[test]
fn explain_lists_every_code_with_its_title() {
    let text = String::from_utf8(explain(&[]).stdout).unwrap();
    assert_eq!(text.lines().count(), code::ALL.len());
    for (code, line) in code::ALL.iter().zip(text.lines()) {
        assert!(line.starts_with(code.id) && line.ends_with(code.title), "{line}");
    }
}
