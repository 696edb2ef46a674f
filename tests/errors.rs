//! What analysis says about wrong programs: one file for each case in `tests/errors`, with the
//! text that a user reads beside it. A case is named after the one code that it shows; a case
//! whose name starts with `several` shows how findings stand together.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use hotrail::backend::processor;
use hotrail::diagnostic::{self, Diagnostic, code};
use hotrail::source::Source;

/// Codes that no text can have, because they are about files and runs of tests.
const COMMAND_LINE_ONLY: &[&str] =
    &["E0005", "E0502", "E0601", "E0602", "E0603", "E0701", "E0702", "E0703", "E0803", "E0804"];

struct Case {
    name: String,
    source: Source,
    findings: Vec<Diagnostic>,
}

fn cases() -> Vec<Case> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/errors");
    let entries = fs::read_dir(&folder).expect("the folder of cases is there");
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    paths.retain(|path| path.extension().is_some_and(|ending| ending == "ladder"));
    paths.sort();
    let case = |path: PathBuf| {
        let name = path.file_stem().unwrap().to_str().unwrap().to_owned();
        let text = fs::read_to_string(&path).unwrap();
        let source = Source::new(format!("{name}.ladder"), text);
        let (program, mut findings) = hotrail::analyze(&source);
        let failed = findings.iter().any(Diagnostic::is_error);
        assert_eq!(program.is_none(), failed, "{name}: a program is there if and only if no error");
        // These are sound programs that one target cannot do.
        if name.starts_with("E08") {
            let program = program.expect("the program is sound");
            findings.extend(processor::compile(&program).err().into_iter().flatten());
        }
        Case { name, source, findings }
    };
    paths.into_iter().map(case).collect()
}

#[test]
fn findings_read_as_kept() {
    for Case { name, source, findings } in cases() {
        let texts: Vec<String> =
            findings.iter().map(|finding| diagnostic::render(finding, &source, false)).collect();
        insta::with_settings!({
            snapshot_path => "errors",
            prepend_module_to_snapshot => false,
            omit_expression => true,
        }, {
            insta::assert_snapshot!(name, texts.join("\n"));
        });
    }
}

#[test]
fn a_case_has_the_one_finding_of_its_name() {
    for Case { name, findings, .. } in cases() {
        let found: Vec<_> = findings.iter().map(|finding| finding.code.id).collect();
        if name.starts_with("several") {
            assert!(found.len() > 1, "{name}: {found:?}");
        } else {
            assert_eq!(found, [&name[..5]], "{name}");
        }
    }
}

#[test]
fn every_code_has_a_case() {
    let hit: BTreeSet<_> = cases()
        .iter()
        .flat_map(|case| case.findings.iter().map(|finding| finding.code.id))
        .collect();
    let all: BTreeSet<_> = code::ALL.iter().map(|code| code.id).collect();
    let outside: BTreeSet<_> = COMMAND_LINE_ONLY.iter().copied().collect();
    assert_eq!(all.difference(&hit).copied().collect::<BTreeSet<_>>(), outside);
}

#[test]
fn a_finding_says_what_stands_there_and_how_to_mend_it() {
    for Case { name, findings, .. } in cases() {
        for finding in findings {
            assert!(!finding.primary.text.is_empty(), "{name}: no label");
            assert!(!finding.help.is_empty(), "{name}: no help");
            assert!(!finding.message.ends_with('.'), "{name}: {}", finding.message);
        }
    }
}

#[test]
fn several_findings_are_in_the_order_of_the_text() {
    for Case { name, findings, .. } in cases() {
        let places: Vec<_> = findings.iter().map(|finding| finding.primary.span).collect();
        assert!(places.is_sorted(), "{name}: {places:?}");
    }
}
