//! The command line as a user meets it: exit codes, files, and what is never overwritten.

mod common;

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

use common::folder::{Folder, Run};

const GOOD: &str = "ladder good  input a  output y  rung a (y)";

fn is_empty(folder: &Path) -> bool {
    fs::read_dir(folder).is_ok_and(|mut entries| entries.next().is_none())
}

#[test]
fn exit_codes_tell_success_fault_and_wrong_use() {
    let folder = Folder::new();
    folder.write("good.ladder", GOOD);
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
    let folder = Folder::new();
    folder.write("good.ladder", GOOD);
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
fn a_file_larger_than_allowed_is_one_finding_in_every_form() {
    let folder = Folder::new();
    folder.write("large.ladder", &format!("{GOOD}{}", " ".repeat(1 << 20)));
    let form = |form| {
        let run =
            folder.run(&["check", "large.ladder", "--max-size", "1", "--message-format", form]);
        assert_eq!(run.code, 1);
        run.err
    };
    assert!(form("human").contains("--max-size"), "{}", form("human"));
    assert_eq!(form("short"), "large.ladder: error[E0601]: larger than 1 MiB\n");
    let found: serde_json::Value = serde_json::from_str(&form("json")).unwrap();
    assert_eq!(found["code"], "E0601");
    assert_eq!(found["file"], "large.ladder");
    assert!(found["primary"].is_null());
    assert_eq!(folder.run(&["check", "large.ladder", "--max-size", "2"]).code, 0);
    assert_eq!(folder.run(&["check", "large.ladder", "--max-size", "0"]).code, 2);
}

#[test]
fn a_wrapper_with_an_inexact_tick_is_remarked() {
    let folder = Folder::new();
    folder.write("good.ladder", GOOD);
    let build = |arguments: &[&str]| {
        let run = folder.run(&[&["build", "good.ladder", "-o", "out"], arguments].concat());
        assert_eq!(run.code, 0, "{}", run.err);
        run.err
    };
    let said = "good.ladder: the wrapper makes the tick every 33 clocks of 32768 Hz, \
                wanted every 1 ms, error +7080.078 ppm";
    assert_eq!(build(&["--emit", "wrapper", "--clock", "32768Hz"]), format!("note: {said}\n"));
    assert_eq!(build(&["--emit", "wrapper", "--clock", "50MHz"]), "");
    assert_eq!(build(&["--emit", "verilog", "--clock", "32768Hz"]), "");
}

#[test]
fn findings_have_three_forms() {
    let folder = Folder::new();
    folder.write("bad.ladder", "ladder bad\noutput y\nrung nobody (y)\n");
    let form = |form| folder.run(&["check", "bad.ladder", "--message-format", form]).err;
    assert!(form("human").contains("--> bad.ladder:3:6"), "{}", form("human"));
    assert_eq!(form("short"), "bad.ladder:3:6: error[E0101]: nothing is named `nobody`\n");
    let json: serde_json::Value = serde_json::from_str(&form("json")).unwrap();
    assert_eq!(json["code"], "E0101");
    assert_eq!(json["primary"]["line"], 3);
}

#[test]
fn standard_input_is_a_source() {
    let mut command = Command::new(env!("CARGO_BIN_EXE_hotrail"));
    let mut child =
        command.args(["check", "-"]).stdin(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    std::io::Write::write_all(&mut child.stdin.take().unwrap(), b"ladder x rung (y)").unwrap();
    let run = Run::new(child.wait_with_output().unwrap());
    assert_eq!(run.code, 1);
    assert!(run.err.contains("<stdin>:1:"), "{}", run.err);
}

#[test]
fn nothing_is_written_when_one_of_several_fails() {
    let folder = Folder::new();
    folder.write("good.ladder", GOOD);
    folder.write("bad.ladder", "ladder bad  output y  rung a (y)");
    assert_eq!(folder.run(&["build", "good.ladder", "bad.ladder", "-o", "out"]).code, 1);
    assert!(!folder.path("out").exists());
}

#[test]
fn building_again_replaces_our_own_files_only() {
    let folder = Folder::new();
    folder.write("good.ladder", GOOD);
    let build = ["build", "good.ladder", "-o", "out", "--emit", "vhdl,verilog"];
    assert_eq!(folder.run(&build).code, 0);
    let first = folder.read("out/good.v");
    assert_eq!(folder.run(&build).code, 0);
    assert_eq!(folder.read("out/good.v"), first);

    folder.write("out/good.v", "module mine; endmodule\n");
    let refused = folder.run(&build);
    assert_eq!(refused.code, 1);
    assert!(refused.err.contains("E0602") && refused.err.contains("--force"), "{}", refused.err);
    assert_eq!(folder.read("out/good.v"), "module mine; endmodule\n");
    assert_eq!(folder.run(&[&build[..], &["--force"]].concat()).code, 0);
    assert_eq!(folder.read("out/good.v"), first);
    let names = fs::read_dir(folder.path("out")).unwrap();
    assert_eq!(names.count(), 2, "no temporary file is left");
}

#[cfg(unix)]
#[test]
fn a_symbolic_link_is_never_followed() {
    let folder = Folder::new();
    folder.write("good.ladder", GOOD);
    folder.write("precious", "");
    fs::create_dir(folder.path("out")).unwrap();
    std::os::unix::fs::symlink(folder.path("precious"), folder.path("out/good.v")).unwrap();
    let run = folder.run(&["build", "good.ladder", "-o", "out", "--force"]);
    assert_eq!(run.code, 1);
    assert!(run.err.contains("symbolic link"), "{}", run.err);
    assert_eq!(folder.read("precious"), "");
}

#[test]
fn a_source_is_never_overwritten() {
    let folder = Folder::new();
    folder.write("good.v", GOOD);
    let run = folder.run(&["build", "good.v", "-o", ".", "--force"]);
    assert_eq!(run.code, 1);
    assert!(run.err.contains("is a source"), "{}", run.err);
    assert_eq!(folder.read("good.v"), GOOD);
}

#[test]
fn two_programs_of_one_name_are_refused() {
    let folder = Folder::new();
    folder.write("a.ladder", GOOD);
    folder.write("b.ladder", &GOOD.replace("good", "GOOD"));
    let run = folder.run(&["build", "a.ladder", "b.ladder", "-o", "out"]);
    assert_eq!(run.code, 1);
    assert!(run.err.contains("E0603") && run.err.contains("a.ladder"), "{}", run.err);
    assert!(!folder.path("out").exists());
}

#[test]
fn check_shows_a_difference_and_writes_nothing() {
    let folder = Folder::new();
    folder.write("good.ladder", GOOD);
    let check = ["build", "good.ladder", "-o", "out", "--check"];
    let missing = folder.run(&check);
    assert_eq!(missing.code, 1);
    assert!(missing.out.contains("+module good"), "{}", missing.out);
    assert!(!folder.path("out").exists() || is_empty(&folder.path("out")));

    assert_eq!(folder.run(&["build", "good.ladder", "-o", "out"]).code, 0);
    let same = folder.run(&check);
    assert_eq!((same.code, same.out.as_str()), (0, ""));

    folder.write("good.ladder", &GOOD.replace("rung a", "rung !a"));
    let changed = folder.run(&check);
    assert_eq!(changed.code, 1);
    assert!(changed.out.contains("-  wire y_next = a;"), "{}", changed.out);
    assert!(changed.out.contains("+  wire y_next = ~a;"), "{}", changed.out);
}

#[test]
fn options_that_do_not_fit_the_program_are_refused() {
    let folder = Folder::new();
    folder.write("good.ladder", GOOD);
    for (option, value, words) in [
        ("--observe", "nobody", "no variable or member `nobody`"),
        ("--debounce", "1500us", "no whole number of ticks"),
        ("--clock", "100Hz", "slower than the tick"),
    ] {
        let run = folder.run(&["build", "good.ladder", "-o", "out", option, value]);
        assert_eq!(run.code, 1, "{option}");
        assert!(run.err.contains(words), "{}", run.err);
    }
    assert_eq!(folder.run(&["build", "good.ladder", "-o", "out", "--clock", "fast"]).code, 2);
}

#[test]
fn a_scan_that_takes_longer_than_a_tick_is_refused() {
    let folder = Folder::new();
    let rungs = "input a output x, y, z  rung a (x) rung x (y) rung y (z)";
    folder.write("slow.ladder", &format!("ladder slow  tick 1ms  clock 2kHz  {rungs}"));
    let build = |more: &[&str]| {
        let arguments = ["build", "slow.ladder", "-o", "out", "--schedule", "serial"];
        folder.run(&[&arguments[..], more].concat())
    };
    let refused = build(&[]);
    assert_ne!(refused.code, 0);
    let said = "a scan takes 3 clocks in this schedule, and from tick to tick there are 2 clocks";
    assert!(refused.err.contains(said), "{}", refused.err);
    assert_eq!(build(&["--clock", "3kHz"]).code, 0);
}

#[test]
fn another_order_is_remarked_and_obeyed() {
    let folder = Folder::new();
    folder.write(
        "late.ladder",
        "ladder late input a output x, y rung x (y) rung a (x)
         test \"at once\" a := 1 scan expect y",
    );
    let test = |order: &str| folder.run(&["test", "late.ladder", "--order", order]);
    assert_eq!(test("text").code, 1);
    let flows = test("dataflow");
    assert_eq!(flows.code, 0);
    let said = "1 rung reads another value than in the order of the text; y may differ";
    assert!(flows.err.contains(said), "{}", flows.err);
    let build = folder.run(&["build", "late.ladder", "-o", "out", "--order", "dataflow"]);
    assert!(!build.err.contains("W0305"), "{}", build.err);
    let sim = folder.run(&["sim", "late.ladder", "--scans", "2", "--order", "dataflow"]);
    assert_eq!((sim.code, sim.err.contains(said)), (0, true));
}

#[test]
fn observed_variables_get_ports() {
    let folder = Folder::new();
    let text = "ladder seen  input a  output y  var n : INT
        rung rise(a) { n := n + 1 } t:TON(PT := 3ms) (y)";
    folder.write("seen.ladder", text);
    let build = ["build", "seen.ladder", "-o", "out", "--observe", "n,t.ET"];
    assert_eq!(folder.run(&build).code, 0);
    let verilog = folder.read("out/seen.v");
    assert!(verilog.contains("output wire [15:0] n"), "{verilog}");
    assert!(verilog.contains("output wire [31:0] t_ET"), "{verilog}");
}

#[test]
fn tests_can_be_chosen_by_title() {
    let folder = Folder::new();
    let text = "test \"on\"  a := 1  scan  expect y   test \"off\"  scan  expect !y";
    folder.write("good.ladder", &format!("{GOOD} {text}"));
    let run = folder.run(&["test", "good.ladder", "--filter", "of"]);
    assert_eq!(run.code, 0);
    assert!(run.out.contains("test off ... ok"), "{}", run.out);
    assert!(run.out.contains("1 passed; 0 failed; 1 filtered out"), "{}", run.out);
}

#[test]
fn a_new_project_works_as_its_readme_says() {
    let folder = Folder::new();
    let made = folder.run(&["new", "pump"]);
    assert_eq!(made.code, 0, "{}", made.err);
    let readme = folder.read("pump/README.md");
    let commands: Vec<&str> = readme.lines().filter(|line| line.starts_with("hotrail ")).collect();
    assert_eq!(commands.len(), 3);
    let project = folder.path("pump");
    for line in commands {
        let mut command = Command::new(env!("CARGO_BIN_EXE_hotrail"));
        let run =
            Run::new(command.args(line.split(' ').skip(1)).current_dir(&project).output().unwrap());
        assert_eq!((run.code, run.err.as_str()), (0, ""), "{line}");
    }
    assert!(folder.read("pump/hdl/pump.v").contains("module pump ("));

    for name in ["pump", "1st", "a b", "nul"] {
        let refused = folder.run(&["new", name]);
        assert_eq!(refused.code, 1, "{name}: {}", refused.err);
    }
    assert_eq!(fs::read_dir(folder.path("")).unwrap().count(), 1);
}

/// A write that fails halfway leaves the folder as it was.
#[cfg(unix)]
#[test]
fn a_full_disk_leaves_the_old_files() {
    let folder = Folder::new();
    folder.write("good.ladder", GOOD);
    assert_eq!(folder.run(&["build", "good.ladder", "-o", "out"]).code, 0);
    let before = folder.read("out/good.v");
    folder.write("good.ladder", &GOOD.replace("rung a", "rung !a"));
    // A file may grow to no size at all; the signal that says so is ignored, as for a full disk.
    let script = format!(
        "trap '' XFSZ; ulimit -f 0; exec {} build good.ladder -o out --emit verilog,vhdl",
        env!("CARGO_BIN_EXE_hotrail")
    );
    let mut shell = Command::new("sh");
    let run = Run::new(shell.args(["-c", &script]).current_dir(folder.path("")).output().unwrap());
    assert_eq!(run.code, 1);
    assert!(run.err.contains("E0602"), "{}", run.err);
    assert_eq!(folder.read("out/good.v"), before);
    assert_eq!(fs::read_dir(folder.path("out")).unwrap().count(), 1, "nothing is left behind");
}

#[test]
fn a_folder_that_cannot_be_made_is_one_clear_error() {
    let folder = Folder::new();
    folder.write("good.ladder", GOOD);
    let run = folder.run(&["build", "good.ladder", "-o", "good.ladder/out"]);
    assert_eq!(run.code, 1);
    assert!(run.err.starts_with("error[E0602]: good.ladder/out"), "{}", run.err);
}

#[test]
fn runs_at_the_same_time_do_not_meet() {
    let folder = Folder::new();
    folder.write("good.ladder", GOOD);
    let build = ["build", "good.ladder", "-o", "out", "--emit", "verilog,vhdl,testbench,wrapper"];
    std::thread::scope(|scope| {
        for _ in 0..8 {
            scope.spawn(|| {
                let run = folder.run(&build);
                assert_eq!(run.code, 0, "{}", run.err);
            });
        }
    });
    assert_eq!(folder.run(&[&build[..], &["--check"]].concat()).code, 0);
    assert_eq!(fs::read_dir(folder.path("out")).unwrap().count(), 6);
}

#[test]
fn a_hostile_title_stays_a_comment() {
    let folder = Folder::new();
    let text = "ladder sly input a output y
        rung \"\u{202e} */ endmodule \u{2028} `include \\\" a (y)";
    folder.write("sly.ladder", text);
    let build = ["build", "sly.ladder", "-o", "out", "--emit", "verilog,vhdl"];
    assert_eq!(folder.run(&build).code, 0);
    for file in ["out/sly.v", "out/sly.vhd"] {
        let printed = folder.read(file);
        let line = printed.lines().find(|line| line.contains("rung 1")).unwrap();
        let line = line.trim_start();
        assert!(line.starts_with("//") || line.starts_with("--"), "{line}");
        assert!(!printed.contains(['\u{202e}', '\u{2028}']), "{line}");
        assert!(!line.ends_with('\\'), "{line}");
    }
}

const CARELESS: &str = "ladder careless\ninput a, b\noutput y\nrung a (y)\nrung b (y)\n";

#[test]
fn warnings_are_shown_and_stop_nothing_unless_denied() {
    let folder = Folder::new();
    folder.write("careless.ladder", CARELESS);
    let check = |more: &[&str]| {
        folder.run(&[&["check", "careless.ladder", "--message-format", "short"], more].concat())
    };
    let shown = "careless.ladder:5:8: warning[W0301]: `y` has two coils\n";
    let as_error = shown.replace("warning", "error");
    for (options, code, text) in [
        (&[][..], 0, shown),
        (&["--allow", "double-coil"], 0, ""),
        (&["--allow", "w0302,W0301"], 0, ""),
        (&["--deny", "warnings"], 1, &as_error),
        (&["--deny", "W0301"], 1, &as_error),
        (&["--deny", "unused,read-above"], 0, shown),
        (&["--deny", "warnings", "--allow", "W0301"], 0, ""),
    ] {
        let run = check(options);
        assert_eq!((run.code, run.err.as_str()), (code, text), "{options:?}");
    }
    for (option, words) in [
        ("W0999", "there is no such code"),
        ("E0101", "E0101 is an error in any case"),
        ("dobule-coil", "is double-coil meant?"),
    ] {
        let run = check(&["--allow", option]);
        assert!(run.code == 2 && run.err.contains(words), "{option}: {}", run.err);
    }
}

#[test]
fn build_warns_and_writes_test_keeps_quiet() {
    let folder = Folder::new();
    folder.write("careless.ladder", &format!("{CARELESS}test \"off\"  scan  expect !y\n"));
    let built = folder.run(&["build", "careless.ladder", "-o", "out"]);
    assert!(built.code == 0 && built.err.contains("warning[W0301]"), "{}", built.err);
    assert!(folder.path("out/careless.v").exists());
    let denied = folder.run(&["build", "careless.ladder", "-o", "not", "--deny", "warnings"]);
    assert!(denied.code == 1 && denied.err.contains("error[W0301]"), "{}", denied.err);
    assert!(!folder.path("not").exists());
    let tested = folder.run(&["test", "careless.ladder"]);
    assert_eq!((tested.code, tested.err.as_str()), (0, ""));
}

#[test]
fn sarif_is_one_document_on_standard_output() {
    let folder = Folder::new();
    folder.write("careless.ladder", CARELESS);
    folder.write("failing.ladder", &format!("{GOOD}\ntest \"on\"  scan  expect y"));
    let sarif = |arguments: &[&str]| {
        let run = folder.run(&[arguments, &["--message-format", "sarif"]].concat());
        let log: serde_json::Value = serde_json::from_str(&run.out).unwrap();
        assert_eq!(log["version"], "2.1.0");
        let results = log["runs"][0]["results"].as_array().unwrap().clone();
        let brief = |result: &serde_json::Value| {
            let place = &result["locations"][0]["physicalLocation"];
            let line = place["region"]["startLine"].as_u64().unwrap_or(0);
            let [rule, level, file] =
                [&result["ruleId"], &result["level"], &place["artifactLocation"]["uri"]]
                    .map(|text| text.as_str().unwrap());
            format!("{rule} {level} {file} {line}")
        };
        (run.code, results.iter().map(brief).collect::<Vec<_>>(), run.err)
    };
    let (code, results, err) = sarif(&["check", "careless.ladder", "missing.ladder"]);
    assert_eq!(results, ["W0301 warning careless.ladder 5", "E0601 error missing.ladder 0"]);
    assert_eq!((code, err.as_str()), (1, ""));
    // A document also where nothing is found, so that a service closes what was open.
    folder.write("good.ladder", GOOD);
    assert_eq!(sarif(&["check", "good.ladder"]), (0, vec![], String::new()));
    let (code, results, err) = sarif(&["test", "failing.ladder"]);
    assert_eq!((code, results), (1, vec!["E0502 error failing.ladder 2".to_owned()]));
    assert!(err.contains("test on ... FAILED"), "{err}");
    let (code, results, err) = sarif(&["build", "good.ladder", "-o", "out", "--check"]);
    assert_eq!((code, results), (1, vec![]));
    assert!(err.contains("+module good"), "{err}");
    folder.write("taken", "");
    let (code, results, _) = sarif(&["build", "good.ladder", "-o", "taken"]);
    assert_eq!((code, results), (1, vec!["E0602 error taken 0".to_owned()]));
}

#[test]
fn github_takes_commands_from_standard_output() {
    let folder = Folder::new();
    folder.write("careless.ladder", CARELESS);
    let check = ["check", "careless.ladder", "missing.ladder", "--message-format", "github"];
    let run = folder.run(&check);
    let lines: Vec<&str> = run.out.lines().collect();
    let warning = "::warning file=careless.ladder,line=5,col=8,endColumn=11,title=W0301::`y` has";
    assert!(lines[0].starts_with(warning), "{}", run.out);
    assert!(lines[1].starts_with("::error file=missing.ladder,title=E0601::"), "{}", run.out);
    assert_eq!((run.code, lines.len(), run.err.as_str()), (1, 2, ""));
}

/// The names of all sub-commands, as the help lists them.
fn commands(folder: &Folder) -> Vec<String> {
    let help = folder.run(&["--help"]).out;
    let list = help.split("Commands:\n").nth(1).unwrap().split("\n\n").next().unwrap();
    let names = list.lines().filter(|line| line.starts_with("  ") && !line.starts_with("   "));
    names.map(|line| line.split_whitespace().next().unwrap().to_owned()).collect()
}

#[test]
fn help_ends_with_an_example() {
    let folder = Folder::new();
    let commands = commands(&folder);
    assert!(commands.len() > 5, "{commands:?}");
    for command in commands.iter().filter(|command| *command != "help") {
        let help = folder.run(&[command, "--help"]).out;
        let last = help.trim_end().rsplit("\n\n").next().unwrap();
        let shows = last.starts_with("Example") && last.contains(&format!("\n  hotrail {command}"));
        assert!(shows, "{command}: {last}");
    }
}

#[test]
fn completions_know_every_command() {
    let folder = Folder::new();
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let run = folder.run(&["completions", shell]);
        assert_eq!(run.code, 0, "{shell}");
        for command in commands(&folder) {
            assert!(run.out.contains(&command), "{shell} does not know {command}");
        }
    }
    assert_eq!(folder.run(&["completions", "csh"]).code, 2);
}

#[test]
fn names_to_observe_may_stand_in_back_ticks() {
    let folder = Folder::new();
    let text = "ladder seen  input a  output y  var `x,y` : INT  var `t.Q` : INT
        rung a { `x,y` := `x,y` + 1 } { `t.Q` := `x,y` } t:TON(PT := 3ms) (y)";
    folder.write("seen.ladder", text);
    let observe =
        |names: &str| folder.run(&["build", "seen.ladder", "-o", "out", "--observe", names]);
    assert_eq!(observe("`x,y`,t.Q,`t.Q`").code, 0);
    let verilog = folder.read("out/seen.v");
    for port in ["output wire [15:0] x_y", "output wire        t_Q,", "output wire [15:0] t_Q_2"] {
        assert!(verilog.contains(port), "{port}\n{verilog}");
    }
    let hidden = observe("t.was");
    assert_eq!(hidden.code, 1);
    assert!(hidden.err.contains("no variable or member `t.was`"), "{}", hidden.err);
}

#[test]
fn a_filter_that_chooses_no_test_fails() {
    let folder = Folder::new();
    folder.write("good.ladder", &format!("{GOOD} test \"on\"  a := 1  scan  expect y"));
    let run = folder.run(&["test", "good.ladder", "--filter", "off"]);
    assert_eq!(run.code, 1);
    assert!(run.err.contains("no test has a title with `off`"), "{}", run.err);
}

#[test]
fn what_is_no_folder_is_said_so() {
    let folder = Folder::new();
    folder.write("good.ladder", GOOD);
    for (out, words) in [("good.ladder", "is a file, not a folder"), ("-", "name a folder")] {
        let run = folder.run(&["build", "good.ladder", "-o", out]);
        assert_eq!(run.code, 1);
        assert!(run.err.contains(words), "{}", run.err);
    }
    let twice = folder.run(&["build", "good.ladder", "good.ladder", "-o", "out"]);
    assert!(twice.err.contains("is named twice"), "{}", twice.err);
    assert!(folder.run(&["new", ".."]).err.contains("no name for a new folder"));
}

#[test]
fn a_reader_that_goes_away_is_no_mistake() {
    let folder = Folder::new();
    folder.write("good.ladder", GOOD);
    let script = format!(
        "{} build good.ladder -o out --check --emit testbench,wrapper,verilog,vhdl | true",
        env!("CARGO_BIN_EXE_hotrail")
    );
    let mut shell = Command::new("sh");
    let run = Run::new(shell.args(["-c", &script]).current_dir(folder.path("")).output().unwrap());
    assert_eq!(run.err, "");
}

#[test]
fn blocks_tells_what_the_block_reference_says() {
    let folder = Folder::new();
    let list = folder.run(&["blocks"]);
    assert_eq!(list.out.lines().count(), hotrail::blocks::ALL.len());
    assert!(list.out.contains("CTUD    up-down counter\n"), "{}", list.out);
    let one = folder.run(&["blocks", "ctd"]);
    assert_eq!((list.code, one.code), (0, 0));
    let page = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/blocks.md"));
    assert!(one.out.starts_with("## CTD, the down counter\n"), "{}", one.out);
    assert!(page.unwrap().contains(&one.out), "{}", one.out);
    let unknown = folder.run(&["blocks", "TOFF"]);
    assert_eq!(unknown.code, 2);
    assert!(unknown.err.contains("'TOF'"), "{}", unknown.err);
}

#[test]
fn very_many_findings_are_cut_for_people_only() {
    let folder = Folder::new();
    let names: String = (0..500).map(|number| format!(" u{number}")).collect();
    folder.write("many.ladder", &format!("ladder many  output y  rung{names} (y)"));
    let human = folder.run(&["check", "many.ladder"]).err;
    assert_eq!(human.matches("error[E0101]").count(), 100);
    assert!(human.ends_with("400 more findings; --message-format short shows all\n"), "{human}");
    let short = folder.run(&["check", "many.ladder", "--message-format", "short"]).err;
    assert_eq!(short.lines().count(), 500);
}

/// The text of a file, and what `fmt` makes of it.
const LOOSE: &str = "ladder good  input a\noutput y  rung  /a (y) // seen\n";
const LAID_OUT: &str =
    "ladder good\ninput  a\noutput y\n\nrung !a ( y )                   // seen\n";

#[test]
fn fmt_rewrites_files_in_place_and_once() {
    let folder = Folder::new();
    folder.write("loose.ladder", LOOSE);
    folder.write("good.ladder", LAID_OUT);
    let modified = || fs::metadata(folder.path("good.ladder")).unwrap().modified().unwrap();
    let before = modified();
    let run = folder.run(&["fmt", "loose.ladder", "good.ladder"]);
    assert_eq!((run.code, run.out.as_str(), run.err.as_str()), (0, "", ""));
    assert_eq!(folder.read("loose.ladder"), LAID_OUT);
    assert_eq!(modified(), before, "what is formatted already is not written again");
    assert_eq!(fs::read_dir(folder.path("")).unwrap().count(), 2, "no temporary file is left");
    assert_eq!(folder.run(&["fmt", "--check", "loose.ladder", "good.ladder"]).code, 0);
}

#[test]
fn fmt_check_shows_a_difference_and_writes_nothing() {
    let folder = Folder::new();
    folder.write("loose.ladder", LOOSE);
    let run = folder.run(&["fmt", "--check", "loose.ladder"]);
    assert_eq!(run.code, 1);
    for line in ["--- loose.ladder", "-output y  rung  /a (y) // seen", "+output y"] {
        assert!(run.out.lines().any(|found| found == line), "{line}\n{}", run.out);
    }
    assert_eq!(folder.read("loose.ladder"), LOOSE);
}

#[test]
fn fmt_writes_nothing_when_one_of_several_fails() {
    let folder = Folder::new();
    folder.write("loose.ladder", LOOSE);
    folder.write("bad.ladder", "ladder bad  rung [ a");
    let run = folder.run(&["fmt", "loose.ladder", "bad.ladder"]);
    assert_eq!(run.code, 1);
    assert!(run.err.contains("error[E0002]") && run.err.contains("bad.ladder:1:18"), "{}", run.err);
    assert_eq!(folder.read("loose.ladder"), LOOSE);
    assert_eq!(folder.run(&["fmt"]).code, 2);
}

#[test]
fn fmt_passes_standard_input_on() {
    let fmt = |arguments: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_hotrail"));
        command.args(arguments).stdin(Stdio::piped()).stdout(Stdio::piped());
        let mut child = command.stderr(Stdio::piped()).spawn().unwrap();
        std::io::Write::write_all(&mut child.stdin.take().unwrap(), LOOSE.as_bytes()).unwrap();
        Run::new(child.wait_with_output().unwrap())
    };
    let run = fmt(&["fmt", "-"]);
    assert_eq!((run.code, run.out.as_str()), (0, LAID_OUT));
    let run = fmt(&["fmt", "--check", "-"]);
    assert_eq!(run.code, 1);
    assert!(run.out.starts_with("--- <stdin>\n"), "{}", run.out);
}

#[cfg(unix)]
#[test]
fn fmt_keeps_permissions_and_follows_no_link() {
    use std::os::unix::fs::PermissionsExt;
    let folder = Folder::new();
    folder.write("loose.ladder", LOOSE);
    let path = folder.path("loose.ladder");
    let set_mode = |mode| fs::set_permissions(&path, fs::Permissions::from_mode(mode)).unwrap();

    std::os::unix::fs::symlink(&path, folder.path("link.ladder")).unwrap();
    let run = folder.run(&["fmt", "link.ladder"]);
    assert_eq!(run.code, 1);
    assert!(run.err.contains("E0602") && run.err.contains("symbolic link"), "{}", run.err);

    set_mode(0o440);
    let run = folder.run(&["fmt", "loose.ladder"]);
    assert_eq!(run.code, 1);
    assert!(run.err.contains("read-only"), "{}", run.err);
    assert_eq!(folder.read("loose.ladder"), LOOSE);

    set_mode(0o640);
    assert_eq!(folder.run(&["fmt", "loose.ladder"]).code, 0);
    assert_eq!(folder.read("loose.ladder"), LAID_OUT);
    assert_eq!(fs::metadata(&path).unwrap().permissions().mode() & 0o777, 0o640);
}

#[test]
fn a_ladder_is_drawn_on_standard_output() {
    let folder = Folder::new();
    folder.write("a.ladder", "ladder one  input a  output y, z  rung \"lamp\" a (y)  rung !a (z)");
    let all = folder.run(&["draw", "a.ladder"]);
    assert_eq!((all.code, all.err.as_str()), (0, ""));
    assert!(all.out.contains("┤ ├") && all.out.contains("┤/├"), "{}", all.out);
    let first = folder.run(&["draw", "a.ladder", "--rung", "lam", "--ascii"]);
    assert!(first.out.contains("| |") && !first.out.contains("|/|"), "{}", first.out);
    let second = folder.run(&["draw", "a.ladder", "--rung", "2"]);
    assert!(!second.out.contains("┤ ├") && second.out.contains("┤/├"), "{}", second.out);
    let none = folder.run(&["draw", "a.ladder", "--rung", "pump"]);
    assert_eq!((none.code, none.out.as_str()), (1, ""));
    assert!(none.err.contains("no rung has the number or the title `pump`"), "{}", none.err);
    assert_eq!(folder.run(&["draw", "a.ladder", "--width", "20"]).code, 2);
    folder.write("bad.ladder", "ladder bad  rung q (y)");
    let bad = folder.run(&["draw", "a.ladder", "bad.ladder"]);
    assert_eq!((bad.code, bad.out.as_str()), (1, ""));
}

#[test]
fn pictures_go_to_a_folder_or_to_standard_output() {
    let folder = Folder::new();
    folder.write("a.ladder", GOOD);
    folder.write("b.ladder", &GOOD.replace("good", "other"));
    let draw = ["draw", "--format", "svg", "a.ladder"];
    let shown = folder.run(&draw).out;
    assert!(shown.starts_with("<svg ") && shown.ends_with("</svg>\n"), "{shown}");
    let into = |more: &[&str]| folder.run(&[&draw[..], &["b.ladder"], more].concat());
    assert_eq!(into(&[]).code, 1);
    assert_eq!(into(&["-o", "out"]).code, 0);
    assert_eq!(folder.read("out/good.svg"), shown);
    // What `build` writes is the same, and what is ours is replaced.
    let build = ["build", "a.ladder", "-o", "out", "--emit", "svg"];
    assert_eq!(folder.run(&build).code, 0);
    assert_eq!(folder.read("out/good.svg"), shown);
    folder.write("out/other.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\">mine</svg>");
    let refused = into(&["-o", "out"]);
    assert_eq!(refused.code, 1);
    assert!(refused.err.contains("was not made by hotrail"), "{}", refused.err);
    assert_eq!(into(&["-o", "out", "--force"]).code, 0);
    assert_eq!(folder.run(&["draw", "a.ladder", "-o", "out"]).code, 1);
    let check = folder.run(&["build", "a.ladder", "-o", "out", "--emit", "svg", "--check"]);
    assert_eq!((check.code, check.out.as_str()), (0, ""));
}
