//! `hotrail sim`: tables, and what is said of wrong stimuli.

mod circuit;
#[path = "../common/mod.rs"]
mod common;
mod dumps;
mod pictures;
mod tests;

use std::fs;
use std::path::Path;

use common::folder::Folder;
use hotrail::diagnostic;
use hotrail::eval::Stimulus;
use hotrail::source::Source;

const PROGRAM: &str = "ladder lift
    input up  input load : INT  input patience : TIME
    output motor  output weight : INT
    rung up delay:TON(PT := patience) ( motor )
    rung up { weight := load }
";

fn folder() -> Folder {
    let folder = Folder::new();
    folder.write("lift.ladder", PROGRAM);
    folder
}

#[test]
fn a_table_has_a_row_for_each_scan() {
    let folder = folder();
    folder.write("s.csv", "up,load,patience\n0,,2\n1,-5,\n,,\n,16#7F,0ms\n0,,\n");
    let run = folder.run(&["sim", "lift.ladder", "s.csv"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    let table = "scan,tick,up,load,patience,motor,weight\n0,1,0,0,2,0,0\n1,1,1,-5,2,0,-5\n\
                 2,1,1,-5,2,0,-5\n3,1,1,127,0,1,127\n4,1,0,127,0,0,127\n";
    assert_eq!(run.out, table);
    // The same as JSON lines, from standard input, with another order of names.
    let lines = "{\"patience\": 2}\n\n{\"load\": -5, \"up\": true}\n{}\n\
                 {\"load\": \"16#7F\", \"patience\": \"0ms\", \"up\": null}\n{\"up\": 0}";
    let run = folder.run_with(&["sim", "lift.ladder", "-"], lines);
    assert_eq!((run.out.as_str(), run.err.as_str()), (table, ""));
}

#[test]
fn only_scans_with_the_tick_count_for_timers() {
    let folder = folder();
    let stimulus = "\u{feff}tick;up;patience\r\n1;1;3\r\n0;;\r\n;;\r\n1;;\r\n";
    let arguments = ["sim", "lift.ladder", "-", "--watch", "delay.ET,motor", "--scans", "7"];
    let run = folder.run_with(&arguments, stimulus);
    // The second row has no tick; the third leaves it to the default, and so does the last, held.
    let table = "scan,tick,delay.ET,motor\n0,1,0,0\n1,0,0,0\n2,1,1,0\n3,1,2,0\n4,1,3,1\n5,1,3,1\n\
                 6,1,3,1\n";
    assert_eq!((run.out.as_str(), run.err.as_str()), (table, ""));
}

#[test]
fn scans_alone_are_a_stimulus_and_fewer_scans_cut_one() {
    let folder = folder();
    let run = folder.run(&["sim", "lift.ladder", "--scans", "2", "--format", "jsonl"]);
    let row = |scan| {
        format!(
            "{{\"scan\":{scan},\"tick\":1,\"up\":0,\"load\":0,\"patience\":0,\"motor\":0,\"weight\":0}}\n"
        )
    };
    assert_eq!(run.out, row(0) + &row(1));
    let run = folder.run_with(&["sim", "lift.ladder", "-", "--scans", "1"], "up\n1\n0\n");
    assert_eq!(run.out.lines().count(), 2);
    assert_eq!(folder.run(&["sim", "lift.ladder"]).code, 2);
}

#[test]
fn an_input_named_tick_is_no_tick() {
    let folder = Folder::new();
    let program = "ladder t  input `tick`, `scan`, `a,b`  output y  rung `tick` `scan` `a,b` (y)";
    folder.write("t.ladder", program);
    let stimulus = "tick,`tick`,`scan`,\"a,b\"\n0,1,1,1\n";
    let run = folder.run_with(&["sim", "t.ladder", "-"], stimulus);
    let table = "scan,tick,`tick`,`scan`,\"a,b\",y\n0,0,1,1,1,1\n";
    assert_eq!((run.out.as_str(), run.err.as_str()), (table, ""));
}

#[test]
fn names_that_are_not_there_are_named() {
    let folder = folder();
    let run = folder.run(&["sim", "lift.ladder", "--scans", "1", "--watch", "delay.E"]);
    assert_eq!(run.code, 1);
    assert!(run.err.contains("`delay.E`; did you mean `delay.ET`?"), "{}", run.err);
    assert_eq!(run.out, "");
}

/// What is wrong with each file of `tests/stimulus`, for a program with inputs of every kind.
#[test]
fn wrong_stimuli_are_told_where_they_are_wrong() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/stimulus");
    let ladder = Source::new("any.ladder", fs::read_to_string(root.join("any.ladder")).unwrap());
    let program = hotrail::analyze(&ladder).0.expect("the program is good");
    let paths = fs::read_dir(&root).unwrap().map(|entry| entry.unwrap().path());
    let is_case = |path: &std::path::PathBuf| {
        path.extension().is_some_and(|ending| ending == "csv" || ending == "jsonl")
    };
    let mut paths: Vec<_> = paths.filter(is_case).collect();
    paths.sort();
    assert!(paths.len() > 8);
    for path in paths {
        let name = path.file_name().unwrap().to_str().unwrap();
        let source = Source::new(name, fs::read_to_string(&path).unwrap());
        let findings = Stimulus::parse(&program, &source).expect_err(name);
        let wanted = name.split('_').next().unwrap();
        for finding in &findings {
            assert_eq!(finding.code.id, wanted, "{name}");
            assert!(!finding.primary.text.is_empty() && !finding.help.is_empty(), "{name}");
        }
        let texts: Vec<String> =
            findings.iter().map(|finding| diagnostic::render(finding, &source, false)).collect();
        insta::with_settings!({
            snapshot_path => "../stimulus",
            prepend_module_to_snapshot => false,
            omit_expression => true,
        }, {
            insta::assert_snapshot!(name.replace('.', "_"), texts.join("\n"));
        });
    }
}
