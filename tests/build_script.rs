//! The library in a build.rs: without the command line, with errors as values.

use std::process::Command;

use hotrail::{Build, Emit};

/// Runs cargo on the fixture crate with what was downloaded for this one.
fn cargo(arguments: &[&str]) -> String {
    let output = Command::new(env!("CARGO"))
        .args(arguments)
        .args(["--offline", "--locked"])
        .env("CARGO_TARGET_DIR", concat!(env!("CARGO_TARGET_TMPDIR"), "/fixture"))
        .current_dir("tests/fixture")
        .output()
        .unwrap();
    let err = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success(), "{arguments:?}\n{err}");
    String::from_utf8(output.stdout).unwrap()
}

#[test]
fn a_crate_compiles_ladders_in_its_build_script() {
    let verilog = cargo(&["run", "--quiet"]);
    assert!(verilog.contains("module blink ("), "{verilog}");
}

#[test]
fn the_library_alone_brings_no_command_line() {
    let tree = cargo(&["tree", "--edges", "build,normal", "--prefix", "none"]);
    for absent in ["clap ", "anyhow ", "similar "] {
        assert!(!tree.contains(absent), "{absent}is among\n{tree}");
    }
    assert!(tree.contains("pest "), "{tree}");
}

#[test]
fn errors_are_values_with_spans_and_the_usual_text() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("bad.ladder");
    std::fs::write(&file, "ladder bad\noutput y\nrung nobody (y)\n").unwrap();
    let out = folder.path().join("out");
    let missing = folder.path().join("missing.ladder");
    let build = Build::new().files([&file, &missing]).emit(Emit::Vhdl).out_dir(&out);
    let error = build.run().unwrap_err();
    let [finding] = &error.findings[..] else { panic!("{error:?}") };
    assert_eq!(finding.source.slice(finding.diagnostic.primary.span), "nobody");
    let text = error.to_string();
    assert!(text.contains("bad.ladder:3:6"), "{text}");
    assert!(text.contains("error[E0601]"), "{text}");
    assert!(!out.exists());
}
