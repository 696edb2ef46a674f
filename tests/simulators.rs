//! What is emitted runs in real simulators as the evaluator says, and real tools accept it.

mod common;

use std::path::Path;
use std::process::Command;

use common::recorded::with_recorded_test;
use common::{amount, bulk, checks, examples, generate, require_tool, run};
use fastrand::Rng;
use hotrail::backend::hdl::Language;
use hotrail::source::Source;

const HOTRAIL: &str = env!("CARGO_BIN_EXE_hotrail");

/// The simulators that are installed, as `hotrail test --on` names them.
fn simulators() -> Vec<&'static str> {
    let all = [("iverilog", "icarus"), ("ghdl", "ghdl")];
    all.into_iter().filter(|(tool, _)| require_tool(tool)).map(|(_, name)| name).collect()
}

#[test]
fn tests_of_examples_pass_in_every_simulator() {
    for simulator in simulators() {
        for example in examples() {
            let ladder = example.ladder.display().to_string();
            let text = run(Path::new("."), HOTRAIL, &["test", "--on", simulator, &ladder]);
            assert!(!text.contains("running 0 tests"), "{text}");
        }
    }
}

/// The schedules of several clocks take turns; the flat one is above.
const SCHEDULES: [&str; 2] = ["levels", "serial"];

#[test]
fn tests_of_examples_pass_in_schedules_of_several_clocks() {
    for simulator in simulators() {
        for (example, schedule) in examples().iter().zip(SCHEDULES.into_iter().cycle()) {
            let ladder = example.ladder.display().to_string();
            let arguments = ["test", "--on", simulator, "--schedule", schedule, &ladder];
            let text = run(Path::new("."), HOTRAIL, &arguments);
            assert!(!text.contains("running 0 tests"), "{text}");
        }
    }
}

#[test]
fn a_wrong_expectation_fails_everywhere_with_the_same_words() {
    let folder = tempfile::tempdir().unwrap();
    let text = "ladder wrong  input a, b  output y, z  var n : INT
        rung a b (y)
        rung rise(a) { n := n - 3 } t:TON(PT := 2ms) (z)
        test \"contact\"     a := 1  scan  expect a y  b := 1  scan  expect a !y
        test \"number\"      repeat 2 { pulse a }  expect { n = -6 } { n > 0 }
        test \"list\"        expect [ y | z a ]
        test \"right\"       a := 1  b := 1  scan  expect y { t.ET = 0ms }";
    std::fs::write(folder.path().join("wrong.ladder"), text).unwrap();
    let failures = |executor: &str, schedule: &str| {
        let output = Command::new(HOTRAIL)
            .args(["test", "wrong.ladder", "--on", executor, "--schedule", schedule])
            .current_dir(folder.path())
            .output()
            .unwrap();
        assert_eq!(output.status.code(), Some(1), "{executor}");
        let shown = [output.stdout, output.stderr].concat();
        // `hotrail why` explains what the evaluator did, so it alone leads there.
        let shown = String::from_utf8_lossy(&shown).replace(executor, "EXECUTOR");
        let (mut kept, mut lines) = (String::new(), shown.lines().peekable());
        while let Some(line) = lines.next() {
            match lines.next_if(|next| next.contains("help: the cause: hotrail why")) {
                Some(_) => assert_eq!((line, executor), ("  |", "evaluator")),
                None => kept += &format!("{line}\n"),
            }
        }
        kept
    };
    let meant = failures("evaluator", "flat");
    for expected in ["y is 0", "n is -6", "y is 0, z is 0, a is 0", "1 passed; 3 failed"] {
        assert!(meant.contains(expected), "no {expected} in\n{meant}");
    }
    for simulator in simulators() {
        for schedule in ["flat", "levels", "serial"] {
            assert_eq!(failures(simulator, schedule), meant, "{simulator}, {schedule}");
        }
    }
}

/// A program whose inputs have these names, with a test that reads them all.
fn with_inputs(names: &[&str]) -> String {
    let quoted: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
    format!(
        "ladder named  input {}  output y  rung {} (y)
         test \"# todo \\ the expectation of 100% 'x'\" {} repeat 2 {{ repeat 2 {{ scan }} expect y {} }}",
        quoted.join(", "),
        quoted.join(" "),
        quoted.iter().map(|name| format!("{name} := 1 ")).collect::<String>(),
        quoted.join(" ")
    )
}

#[test]
fn a_testbench_takes_every_name() {
    let folder = tempfile::tempdir().unwrap();
    let templates =
        [include_str!("../templates/testbench.v"), include_str!("../templates/testbench.vhd")];
    let is_word = |c: char| c == '_' || c.is_alphanumeric();
    let mut names: Vec<&str> = templates
        .iter()
        .flat_map(|text| text.split(|c| !is_word(c)))
        .filter(|word| word.starts_with(char::is_alphabetic))
        .chain([
            "scan_done",
            "round",
            "round_2",
            "named_tb",
            "named_test",
            "named_expect",
            "expect_0",
            "expect_0_1",
            "y",
        ])
        .collect();
    names.sort_unstable_by_key(|name| name.to_lowercase());
    names.dedup_by_key(|name| name.to_lowercase());
    names.retain(|&name| name != "y");
    std::fs::write(folder.path().join("named.ladder"), with_inputs(&names)).unwrap();
    for executor in ["evaluator"].iter().chain(&simulators()) {
        for schedule in ["flat", "serial"] {
            let arguments = ["test", "named.ladder", "--on", executor, "--schedule", schedule];
            let text = run(folder.path(), HOTRAIL, &arguments);
            assert!(text.contains("1 passed"), "{text}");
        }
    }
}

#[test]
fn chosen_tests_fail_at_their_own_expectations() {
    let folder = tempfile::tempdir().unwrap();
    let text = "ladder chosen  input a  output y  rung a (y)
        test \"first\" scan expect !y  test \"second\" a := 1 scan expect y expect !y";
    std::fs::write(folder.path().join("chosen.ladder"), text).unwrap();
    for executor in ["evaluator"].iter().chain(&simulators()) {
        let mut command = Command::new(HOTRAIL);
        command.args(["test", "chosen.ladder", "--filter", "second", "--on", executor]);
        let output = command.current_dir(folder.path()).output().unwrap();
        let shown = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(shown.contains("--> chosen.ladder:2:80"), "{executor}: {shown}");
    }
}

/// A whole number of ticks in every example.
const DEBOUNCE: &str = "1s";

/// The files of a build with everything in it.
fn build(ladder: &Path, reset: &str, schedule: &str, folder: &Path) {
    let out = folder.display().to_string();
    let ladder = ladder.display().to_string();
    let files = ["build", &ladder, "-o", &out, "--emit", common::GOLDEN];
    let how = ["--reset", reset, "--debounce", DEBOUNCE, "--schedule", schedule];
    run(Path::new("."), HOTRAIL, &[&files[..], &how].concat());
}

/// Tools that only look say nothing about these files.
fn check_quietly(folder: &Path, name: &str) {
    let file = |ending: &str| format!("{name}{ending}");
    let (core, top) = (file(".v"), file("_top.v"));
    if require_tool("iverilog") {
        let quiet = |files: &[&str]| {
            let arguments = [&["-g2005", "-Wall", "-o", "checked"], files].concat();
            assert_eq!(run(folder, "iverilog", &arguments), "", "{files:?}");
        };
        quiet(&[&core, &top]);
        quiet(&[&core, &file("_tb.v")]);
    }
    if require_tool("verilator") {
        let lint = ["--lint-only", "-Wall", "--top-module"];
        let top_module = format!("{name}_top");
        assert_eq!(run(folder, "verilator", &[&lint[..], &[name, &core]].concat()), "");
        let with_top = [&lint[..], &[&top_module, &top, &core]].concat();
        assert_eq!(run(folder, "verilator", &with_top), "");
    }
    if require_tool("ghdl") {
        for ending in [".vhd", "_top.vhd", "_tb.vhd"] {
            assert_eq!(run(folder, "ghdl", &["-a", "--std=93", &file(ending)]), "");
        }
    }
}

#[test]
fn tools_accept_what_is_emitted_without_a_word() {
    // How a reset is written does not depend on the program, so the examples take turns.
    let resets = ["sync-high", "sync-low", "async-low"];
    let schedules = ["flat", SCHEDULES[0], "flat", SCHEDULES[1]];
    let how = resets.into_iter().cycle().zip(schedules.into_iter().cycle());
    for (example, (reset, schedule)) in examples().iter().zip(how) {
        let folder = tempfile::tempdir().unwrap();
        build(&example.ladder, reset, schedule, folder.path());
        check_quietly(folder.path(), &example.name());
    }
}

#[test]
fn yosys_makes_ice40_cells_of_every_example() {
    if !require_tool("yosys") {
        return;
    }
    for example in examples() {
        let name = example.name();
        let folder = tempfile::tempdir().unwrap();
        build(&example.ladder, "sync-high", "flat", folder.path());
        let script = format!(
            "read_verilog {name}.v {name}_top.v; synth_ice40 -top {name}_top; check -assert"
        );
        run(folder.path(), "yosys", &["-q", "-p", &script]);
    }
}

#[test]
fn random_programs_run_in_simulators_as_in_the_evaluator() {
    let simulators = simulators();
    let folder = tempfile::tempdir().unwrap();
    for seed in 0..amount("HOTRAIL_RANDOM_SIMULATIONS", 5) {
        let text = generate::program(seed);
        let name = format!("random_{seed}");
        let (program, _) = hotrail::analyze(&Source::new(name.clone(), text.clone()));
        let program = program.expect("random programs are right");
        let text = with_recorded_test(&text, &program, &mut Rng::with_seed(seed));
        let file = folder.path().join(format!("{name}.ladder"));
        std::fs::write(&file, &text).unwrap();
        let file = file.display().to_string();
        for schedule in ["flat", SCHEDULES[seed as usize % 2]] {
            for simulator in ["evaluator"].iter().chain(&simulators) {
                let arguments = ["test", "--on", simulator, "--schedule", schedule, &file];
                run(Path::new("."), HOTRAIL, &arguments);
            }
            build(Path::new(&file), "sync-high", schedule, folder.path());
            check_quietly(folder.path(), &name);
        }
    }
}

#[test]
fn kept_programs_run_in_simulators_as_in_the_evaluator() {
    bulk::hold_kept_programs(Language::Verilog);
    bulk::hold_kept_programs(Language::Vhdl);
}

#[test]
fn many_random_programs_run_at_once_as_in_the_evaluator() {
    let programs = 10 * amount("HOTRAIL_RANDOM_SIMULATIONS", 5);
    checks::ICARUS.hold(programs);
    checks::GHDL.hold(programs);
}
