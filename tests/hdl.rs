//! The printed Verilog and VHDL: how it reads, that tools take it, and that it does what the
//! circuit says.

mod common;

use std::fmt::Write;
use std::fs;
use std::path::Path;

use common::bench::Bench;
use common::interpreter::Interpreter;
use common::{amount, designs, proof, require_tool, run};
use hotrail::backend::hdl::{self, Language, Options, ResetStyle};
use hotrail::circuit::{Design, Valid};

const RESETS: [ResetStyle; 3] = [ResetStyle::SyncHigh, ResetStyle::SyncLow, ResetStyle::AsyncLow];

fn options(source: &str, reset: ResetStyle) -> Options {
    Options { source: source.to_owned(), reset, version: "0.1.0".to_owned() }
}

/// Prints a design in both languages into a folder.
fn print_into(folder: &Path, design: &Valid<Design>, reset: ResetStyle) {
    let options = options("test.ladder", reset);
    for (language, file) in [(Language::Verilog, "core.v"), (Language::Vhdl, "core.vhd")] {
        fs::write(folder.join(file), hdl::print(design, language, &options)).expect("can write");
    }
}

#[test]
fn a_program_with_a_timer_reads_well() {
    let design = designs::start_stop();
    let options = options("start_stop.ladder", ResetStyle::SyncHigh);
    insta::assert_snapshot!("start_stop.v", hdl::print(&design, Language::Verilog, &options));
    insta::assert_snapshot!("start_stop.vhd", hdl::print(&design, Language::Vhdl, &options));
}

#[test]
fn lint_tools_are_content() {
    let random = (1..=6).map(|seed| (designs::random(seed), RESETS[seed as usize % 3]));
    let plain = RESETS.map(|reset| (designs::start_stop(), reset));
    let odd = [designs::hostile(), designs::blinker()].map(|design| (design, RESETS[0]));
    for (design, reset) in plain.into_iter().chain(odd).chain(random) {
        let folder = tempfile::tempdir().expect("can make a folder");
        print_into(folder.path(), &design, reset);
        let folder = folder.path();
        if require_tool("iverilog") {
            let said = run(folder, "iverilog", &["-g2005", "-Wall", "-o", "core", "core.v"]);
            assert_eq!(said, "", "iverilog warns");
        }
        if require_tool("verilator") {
            let top = &hdl::port_names(&design, &Options::default()).module;
            let file = format!("{top}.v");
            fs::copy(folder.join("core.v"), folder.join(&file)).expect("can copy");
            let said =
                run(folder, "verilator", &["--lint-only", "-Wall", "--top-module", top, &file]);
            assert_eq!(said, "", "verilator warns");
        }
        if require_tool("ghdl") {
            let said = run(folder, "ghdl", &["-a", "--std=93", "core.vhd"]);
            assert_eq!(said, "", "ghdl warns");
        }
    }
}

#[test]
fn yosys_makes_gates_of_it() {
    if !require_tool("yosys") {
        return;
    }
    let folder = tempfile::tempdir().expect("can make a folder");
    print_into(folder.path(), &designs::start_stop(), ResetStyle::SyncHigh);
    let script = "read_verilog core.v; synth_ice40 -top start_stop; check -assert";
    let said = run(folder.path(), "yosys", &["-q", "-p", script]);
    assert!(!said.contains("Warning"), "{said}");
}

/// The inputs of each scan, in the order of the circuit's ports.
fn stimulus(design: &Design, scans: usize) -> Vec<Vec<u64>> {
    let mut random = fastrand::Rng::with_seed(1);
    let inputs = &design.top().inputs;
    let mut row = || inputs.iter().map(|input| random.u64(..) >> (64 - input.width)).collect();
    (0..scans).map(|_| row()).collect()
}

fn expected(design: &Design, stimulus: &[Vec<u64>]) -> String {
    let circuit = design.top();
    let mut interpreter = Interpreter::new(circuit);
    let mut text = String::new();
    for inputs in stimulus {
        for (value, output) in interpreter.step(inputs).iter().zip(&circuit.outputs) {
            let width = circuit.width(output.net) as usize;
            write!(text, "{value:0width$b} ").expect("a string takes it");
        }
        text.push('\n');
    }
    text
}

#[test]
fn simulators_agree_with_the_circuit() {
    for seed in 1..=amount("HOTRAIL_RANDOM_DESIGNS", 6) {
        let design = designs::random_with_products(seed);
        let folder = tempfile::tempdir().expect("can make a folder");
        print_into(folder.path(), &design, ResetStyle::SyncHigh);
        let stimulus = stimulus(&design, 40);
        let expected = expected(&design, &stimulus);
        let bench = Bench::of_core(&design, &Options::default());
        for (language, file) in [(Language::Verilog, "core.v"), (Language::Vhdl, "core.vhd")] {
            if let Some(said) = bench.run(language, folder.path(), &[file], &stimulus) {
                assert_eq!(said, expected, "{language:?}, random design {seed}");
            }
        }
    }
}

#[test]
fn a_timer_follows_its_diagram_in_every_style_of_reset() {
    let design = designs::timer();
    for reset in RESETS {
        let folder = tempfile::tempdir().expect("can make a folder");
        print_into(folder.path(), &design, reset);
        let rows: Vec<Vec<u64>> =
            "_#######__###__##_".chars().map(|c| vec![1, u64::from(c == '#')]).collect();
        let expected = "____####__________".chars().map(|c| if c == '#' { "1 \n" } else { "0 \n" });
        let expected: String = expected.collect();
        let bench = Bench::of_core(&design, &options("", reset));
        for (language, file) in [(Language::Verilog, "core.v"), (Language::Vhdl, "core.vhd")] {
            if let Some(said) = bench.run(language, folder.path(), &[file], &rows) {
                assert_eq!(said, expected, "{language:?} {reset:?}");
            }
        }
    }
}

#[test]
fn both_languages_are_proved_equal() {
    if !require_tool("ghdl") || !require_tool("yosys") {
        return;
    }
    for design in (1..=4).map(designs::random).chain([designs::start_stop(), designs::blinker()]) {
        let folder = tempfile::tempdir().expect("can make a folder");
        let folder = folder.path();
        print_into(folder, &design, ResetStyle::SyncHigh);
        proof::both_editions_are_equal(folder, &design.top().name, "core.v", "core.vhd");
    }
}
