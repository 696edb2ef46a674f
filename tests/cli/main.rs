//! The command line as a user meets it. Each side of it has a file; here is what goes over all.

mod build;
#[path = "../common/mod.rs"]
mod common;
mod draw;
mod findings;
mod fmt;
mod help;
mod test;
mod writing;

use std::fs;

use common::folder::Folder;

/// A sound program without a warning.
const GOOD: &str = "ladder good  input a  output y  rung a (y)";

/// A folder with this program as `good.ladder`.
fn good() -> Folder {
    let folder = Folder::new();
    folder.write("good.ladder", GOOD);
    folder
}

#[test]
fn exit_codes_tell_success_fault_and_wrong_use() {
    let folder = good();
    folder.write("bad.ladder", "ladder bad  output y  rung a (y)");
    assert_eq!(folder.run(&["check", "good.ladder"]).code, 0);
    assert_eq!(folder.run(&["check", "good.ladder", "bad.ladder"]).code, 1);
    assert_eq!(folder.run(&["check"]).code, 2);
    assert_eq!(folder.run(&["chekc", "good.ladder"]).code, 2);
    let missing = folder.run(&["check", "missing.ladder"]);
    assert_eq!(missing.code, 1);
    assert!(missing.err.starts_with("error[E0601]: missing.ladder: "), "{}", missing.err);
}

#[test]
fn equations_have_three_forms() {
    let folder = good();
    folder.write("bad.ladder", "ladder bad  output y  rung a (y)");
    let text = folder.run(&["equations", "good.ladder"]);
    assert!(
        text.code == 0 && text.out.starts_with("rung 1, line 1\n     1  y <- a\n"),
        "{}",
        text.out
    );
    let json = folder.run(&["equations", "good.ladder", "--format", "json", "--flat"]);
    let json: serde_json::Value = serde_json::from_str(&json.out).unwrap();
    assert_eq!((&json["format"], &json["flat"]), (&1.into(), &true.into()));
    let dot = folder.run(&["equations", "good.ladder", "--format", "dot"]);
    assert!(dot.out.starts_with("digraph \"good\" {"), "{}", dot.out);
    let bad = folder.run(&["equations", "bad.ladder"]);
    assert!(bad.code == 1 && bad.out.is_empty() && bad.err.contains("E0101"), "{}", bad.err);
}

#[test]
fn standard_input_is_a_source() {
    let run = Folder::new().run_with(&["check", "-"], "ladder x rung (y)");
    assert_eq!(run.code, 1);
    assert!(run.err.contains("<stdin>:1:"), "{}", run.err);
}

#[test]
fn a_new_project_works_as_its_readme_says() {
    let folder = Folder::new();
    let made = folder.run(&["new", "pump"]);
    assert_eq!(made.code, 0, "{}", made.err);
    let readme = folder.read("pump/README.md");
    let commands: Vec<&str> = readme.lines().filter(|line| line.starts_with("hotrail ")).collect();
    assert_eq!(commands.len(), 3);
    for line in commands {
        let run = folder.shell(&format!("cd pump && {line}"));
        assert_eq!((run.code, run.err.as_str()), (0, ""), "{line}");
    }
    assert!(folder.read("pump/hdl/pump.v").contains("module pump ("));

    for name in ["pump", "1st", "a b", "nul"] {
        let refused = folder.run(&["new", name]);
        assert_eq!(refused.code, 1, "{name}: {}", refused.err);
    }
    assert_eq!(fs::read_dir(folder.path("")).unwrap().count(), 1);
}

#[test]
fn a_reader_that_goes_away_is_no_mistake() {
    let folder = good();
    let build = "hotrail build good.ladder -o out --check --emit testbench,wrapper,verilog,vhdl";
    assert_eq!(folder.shell(&format!("{build} | true")).err, "");
}
