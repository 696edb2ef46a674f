//! The printed VHDL and the printed Verilog are proved to be the same hardware, by Yosys, from
//! GHDL's reading of the VHDL: every example, and random programs.

mod common;

use std::path::Path;

use common::proof::{both_editions_are_equal, both_editions_differ};
use common::{Example, amount, examples, generate, require_tool, run};

fn build(ladder: &Path, schedule: &str, folder: &Path) {
    let (out, ladder) = (folder.display().to_string(), ladder.display().to_string());
    let emit = ["--emit", "verilog,vhdl", "--schedule", schedule];
    let build = [&["build", &ladder, "-o", &out], &emit[..]].concat();
    run(Path::new("."), env!("CARGO_BIN_EXE_hotrail"), &build);
}

fn prove(ladder: &Path, name: &str, schedule: &str) {
    let folder = tempfile::tempdir().unwrap();
    build(ladder, schedule, folder.path());
    let (verilog, vhdl) = (format!("{name}.v"), format!("{name}.vhd"));
    both_editions_are_equal(folder.path(), name, &verilog, &vhdl);
}

fn can_prove() -> bool {
    require_tool("yosys") && require_tool("ghdl")
}

#[test]
fn vhdl_and_verilog_of_examples_are_the_same_hardware() {
    if !can_prove() {
        return;
    }
    for example in examples() {
        prove(&example.ladder, &example.name(), "flat");
    }
}

/// The schedules of several clocks take turns.
#[test]
fn vhdl_and_verilog_of_examples_in_schedules_of_several_clocks_are_the_same_hardware() {
    if !can_prove() {
        return;
    }
    let divides = |example: &Example| {
        let text = std::fs::read_to_string(&example.ladder).unwrap();
        // A quotient that waits for its clock in a register is beyond the solver.
        text.contains("allow(divider)")
    };
    let provable = examples().into_iter().filter(|example| !divides(example));
    for (example, schedule) in provable.zip(["levels", "serial"].into_iter().cycle()) {
        prove(&example.ladder, &example.name(), schedule);
    }
}

#[test]
fn vhdl_and_verilog_of_random_programs_are_the_same_hardware() {
    if !can_prove() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    for seed in 0..amount("HOTRAIL_RANDOM_PROOFS", 5) {
        let name = format!("random_{seed}");
        let ladder = folder.path().join(format!("{name}.ladder"));
        std::fs::write(&ladder, generate::program_without_products(seed)).unwrap();
        for schedule in ["flat", ["levels", "serial"][seed as usize % 2]] {
            prove(&ladder, &name, schedule);
        }
    }
}

/// A product or quotient is proved by its operands: both editions must have the same operator on
/// the same nets.
#[test]
fn vhdl_and_verilog_multiply_and_divide_the_same() {
    if !can_prove() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let ladder = folder.path().join("arithmetic.ladder");
    let mut text = String::from("ladder arithmetic\n");
    for ty in ["INT", "UINT", "DINT", "UDINT"] {
        let [a, b, x] = ["a", "b", "x"].map(|name| format!("{name}_{ty}"));
        text += &format!("input {a}, {b} : {ty}\noutput {x} : {ty}[8]\n");
        for (place, value) in
            ["* b", "/ b", "MOD b", "* 10", "/ 10", "MOD 10", "/ 8", "MOD 8"].iter().enumerate()
        {
            text += &format!("rung {{ {x}[{place}] := {a} {} }}\n", value.replace('b', &b));
        }
    }
    std::fs::write(&ladder, text).unwrap();
    prove(&ladder, "arithmetic", "flat");
}

#[test]
fn a_difference_is_found() {
    if !can_prove() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    build(Path::new("examples/start_stop/start_stop.ladder"), "flat", folder.path());
    let file = folder.path().join("start_stop.v");
    let verilog = std::fs::read_to_string(&file).unwrap();
    let changed = verilog.replacen(" | ", " & ", 1);
    assert_ne!(verilog, changed);
    std::fs::write(file, changed).unwrap();
    assert!(both_editions_differ(folder.path(), "start_stop", "start_stop.v", "start_stop.vhd"));
}
