//! `hotrail sim`: tables, dumps, and what is said of wrong stimuli.

mod common;

use std::fs;
use std::path::Path;

use common::folder::Folder;
use common::generate;
use fastrand::Rng;
use hotrail::backend::CircuitRunner;
use hotrail::diagnostic;
use hotrail::eval::{Evaluator, Machine, Stimulus};
use hotrail::model::{Program, Role, VariableId};
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
            snapshot_path => "stimulus",
            prepend_module_to_snapshot => false,
            omit_expression => true,
        }, {
            insta::assert_snapshot!(name.replace('.', "_"), texts.join("\n"));
        });
    }
}

#[test]
fn a_dump_shows_what_the_table_shows() {
    let folder = folder();
    folder.write("s.csv", "up,load,patience,tick\n0,,-2,1\n1,-5,3,0\n,,,\n0,7,,1\n1,9,1,\n,,,\n");
    let run = |output: &str| {
        let run = folder.run(&["sim", "lift.ladder", "s.csv", "--scans", "9", "--vcd", output]);
        assert_eq!((run.code, run.err.as_str()), (0, ""));
        run.out
    };
    let (table, dump) = (run("waves/lift.vcd"), run("-"));
    assert_eq!(folder.read("waves/lift.vcd"), dump, "same input, same bytes");
    let mut rows = table.lines();
    let names: Vec<&str> = rows.next().unwrap().split(',').skip(1).collect();
    let rows: Vec<Vec<i64>> = rows
        .map(|row| row.split(',').skip(1).map(|cell| cell.parse().unwrap()).collect())
        .collect();
    for (name, column) in names.iter().zip(0..) {
        let shown = values(&dump, &["lift", name], rows.len());
        let meant: Vec<i64> = rows.iter().map(|row| row[column]).collect();
        assert_eq!(shown, meant, "{name}");
    }
    assert_eq!(values(&dump, &["lift", "delay", "PT"], 2), [-2, 3]);
}

/// The values of a variable in a dump, read by the parser of another maker.
fn values(dump: &str, path: &[&str], scans: usize) -> Vec<i64> {
    let mut parser = vcd::Parser::new(dump.as_bytes());
    let header = parser.parse_header().unwrap();
    let var = header.find_var(path).unwrap_or_else(|| panic!("{path:?} is not in {dump}"));
    let (mut values, mut value) = (Vec::new(), 0);
    for command in parser {
        match command.unwrap() {
            vcd::Command::Timestamp(time) => values.resize(time as usize, value),
            vcd::Command::ChangeScalar(id, bit) if id == var.code => {
                value = (bit == vcd::Value::V1).into();
            }
            vcd::Command::ChangeVector(id, bits) if id == var.code => {
                let bits =
                    bits.iter().fold(0, |all, bit| all << 1 | i64::from(bit == vcd::Value::V1));
                let spare = 64 - var.size;
                value = bits << spare >> spare;
            }
            _ => {}
        }
    }
    values.truncate(scans);
    values
}

/// The examples, and some random programs.
fn programs() -> Vec<(String, String)> {
    let text = |example: &common::Example| fs::read_to_string(&example.ladder).unwrap();
    let examples = common::examples();
    let examples = examples.iter().map(|example| (example.name(), text(example)));
    examples
        .chain((0..30).map(|seed| (format!("random {seed}"), generate::program(seed))))
        .collect()
}

/// A stimulus for every input of a program.
fn random_stimulus(program: &Program, random: &mut Rng) -> String {
    let inputs: Vec<_> = program.with_role(Role::Input).map(|(_, input)| input).collect();
    let names = inputs.iter().map(|input| format!(",\"`{}`\"", input.name));
    let mut text = format!("tick{}\n", names.collect::<String>());
    for _ in 0..60 {
        text += if random.u8(..4) == 0 { "0" } else { "1" };
        for input in &inputs {
            text.push(',');
            if random.bool() {
                let value = if random.bool() { random.i64(0..3) } else { random.i64(..) };
                text += &input.ty.wrap(value).to_string();
            }
        }
        text.push('\n');
    }
    text
}

#[test]
fn the_circuit_prints_what_the_evaluator_prints() {
    let folder = Folder::new();
    let mut random = Rng::with_seed(11);
    for (name, text) in programs() {
        let (program, _) = hotrail::analyze(&Source::new("p.ladder", text.as_str()));
        folder.write("p.ladder", &text);
        folder.write("s.csv", &random_stimulus(&program.expect("it is right"), &mut random));
        for format in [&["--format", "jsonl"][..], &["--vcd", "-"]] {
            let on = |executor| {
                let run = ["sim", "p.ladder", "s.csv", "--scans", "70", "--on", executor];
                let run = folder.run(&[&run, format].concat());
                assert_eq!((run.code, run.err.as_str()), (0, ""), "{name}");
                run.out
            };
            assert_eq!(on("circuit"), on("evaluator"), "{name}");
        }
    }
    folder.write("lift.ladder", PROGRAM);
    let power = ["sim", "lift.ladder", "--scans", "1", "--on", "circuit", "--svg", "p.svg"];
    let run = folder.run(&power);
    assert!(run.code == 1 && run.err.contains("leave out --on circuit"), "{}", run.err);
    let watch = ["sim", "lift.ladder", "--scans", "3", "--on", "circuit", "--watch"];
    let run = folder.run(&[&watch[..], &["delay.ET,up,delay.ET,delay.Q"]].concat());
    assert_eq!(run.out, "scan,tick,delay.ET,up,delay.Q\n0,1,0,0,0\n1,1,0,0,0\n2,1,0,0,0\n");
}

#[test]
fn the_circuit_holds_what_the_evaluator_holds_at_every_reset() {
    let mut random = Rng::with_seed(12);
    for (name, text) in programs() {
        let program = hotrail::analyze(&Source::new("p.ladder", text)).0.expect("it is right");
        let named: Vec<VariableId> = program.named_variables().map(|(id, _)| id).collect();
        let mut evaluator = Evaluator::new(&program);
        let mut circuit = CircuitRunner::new(&program, &named);
        for scan in 0..40 {
            if scan % 8 == 0 {
                Machine::reset(&mut evaluator);
                circuit.reset();
            } else {
                for (input, variable) in program.with_role(Role::Input) {
                    let value = variable.ty.wrap(random.i64(..));
                    evaluator.drive(input, value);
                    circuit.drive(input, value);
                }
                evaluator.scan(true);
                circuit.scan(true);
            }
            for &variable in &named {
                let (meant, shown) = (evaluator.value(variable), circuit.value(variable));
                let variable = &program.variables[variable].name;
                assert_eq!(shown, meant, "{name}: {variable} after {scan} steps");
            }
        }
    }
}

#[test]
fn a_dump_never_replaces_what_is_not_ours() {
    let folder = folder();
    folder.write("lift.vcd", "precious");
    let arguments = ["sim", "lift.ladder", "--scans", "1", "--vcd", "lift.vcd"];
    let run = folder.run(&arguments);
    assert_eq!((run.code, run.out.as_str()), (1, ""));
    assert!(run.err.contains("E0602") && run.err.contains("remove it first"), "{}", run.err);
    assert_eq!(folder.read("lift.vcd"), "precious");
    fs::remove_file(folder.path("lift.vcd")).unwrap();
    assert_eq!(folder.run(&arguments).code, 0);
    assert_eq!(folder.run(&arguments).code, 0, "our own is replaced");
}

#[test]
fn hostile_names_are_legal_in_a_dump() {
    let folder = Folder::new();
    let program = "ladder h  input `$end`, `a b`, `a_b`, wire  output `größer #1`  \
                   rung `$end` `a b` `a_b` wire ( `größer #1` )";
    folder.write("h.ladder", program);
    let run = folder.run(&["sim", "h.ladder", "--scans", "1", "--vcd", "-"]);
    let header = vcd::Parser::new(run.out.as_bytes()).parse_header().unwrap();
    for name in ["end_u", "a_b", "a_b_2", "wire_u", "gr_er_1"] {
        assert!(header.find_var(&["h", name]).is_some(), "{name}: {}", run.out);
    }
}

/// The attribute that a screen reader reads, of each part of a picture.
fn labels(picture: &str) -> Vec<&str> {
    let labels = picture.split("aria-label=\"").skip(1);
    labels.map(|rest| rest.split('"').next().unwrap()).collect()
}

#[test]
fn a_picture_shows_the_power_of_a_scan() {
    let folder = folder();
    folder.write("s.csv", "up,load,patience\n0,,2\n1,-5,\n,,\n,,\n0,,\n");
    let power = |at: &[&str]| {
        let run =
            folder.run(&[&["sim", "lift.ladder", "s.csv", "--svg", "power.svg"], at].concat());
        assert_eq!((run.code, run.err.as_str()), (0, ""));
        assert_eq!(run.out.lines().count(), 6, "the table is printed too");
        folder.read("power.svg")
    };
    let third = power(&["--at", "2"]);
    assert!(third.contains(">power in scan 2</text>"), "{third}");
    let timer = "rung 1: up delay:TON(PT := patience) ( motor ). In this scan: up conducts, \
                 delay.PT = 0s, delay.Q = 0, delay.ET = 0s, motor is off, no power at the right end";
    assert_eq!(
        labels(&third)[0],
        timer.replace("PT = 0s", "PT = 2ms").replace("ET = 0s", "ET = 1ms")
    );
    assert!(labels(&third)[1].ends_with("weight = -5, load = -5, power to the right end"));
    let last = power(&[]);
    assert!(last.contains(">power in scan 4</text>"), "{last}");
    assert_eq!(
        labels(&last)[0],
        timer.replace("conducts", "is open").replace("PT = 0s", "PT = 2ms")
    );
}

#[test]
fn a_picture_of_a_scan_that_is_not_run_is_refused() {
    let folder = folder();
    let run = folder.run(&["sim", "lift.ladder", "--scans", "3", "--svg", "p.svg", "--at", "3"]);
    assert_eq!(run.code, 1);
    assert!(run.err.contains("the run has 3 scans, from 0"), "{}", run.err);
    let run = folder.run(&["sim", "lift.ladder", "--scans", "3", "--at", "1"]);
    assert_eq!(run.code, 2, "--at is for --svg");
    assert!(!folder.path("p.svg").exists());
}

#[test]
fn a_timing_diagram_tells_when_what_changed() {
    let folder = folder();
    folder.write("s.csv", "up,tick,patience\n0,,3\n1,,\n,,\n,0,\n,,\n,,\n,,\n0,,\n");
    let watch = ["--watch", "up,delay.ET,motor", "--waves", "waves.svg"];
    let run = folder.run(&[&["sim", "lift.ladder", "s.csv"][..], &watch].concat());
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    let picture = folder.read("waves.svg");
    assert_eq!(
        labels(&picture),
        [
            "tick: 1 from scan 0, 0 from scan 3, 1 from scan 4",
            "up: 0 from scan 0, 1 from scan 1, 0 from scan 7",
            "delay.ET: 0s from scan 0, 1ms from scan 2, 2ms from scan 4, 3ms from scan 5, \
             0s from scan 7",
            "motor: 0 from scan 0, 1 from scan 5, 0 from scan 7",
        ]
    );
    // Scan 5 is the fifth after the first one, and one of them had no tick.
    assert!(picture.contains(">5</text>") && picture.contains(">4ms</text>"), "{picture}");
}

#[test]
fn a_long_run_has_a_diagram_of_bounded_size() {
    let folder = folder();
    let rows: String =
        (0..20_000).map(|scan| format!("{},{}\n", scan % 2, scan * 7 % 100)).collect();
    folder.write("s.csv", &format!("up,load\n{rows}"));
    let run = folder.run(&["sim", "lift.ladder", "s.csv", "--waves", "waves.svg"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    let picture = folder.read("waves.svg");
    assert!(picture.contains("scans 0 to 1999 of 20000: too much happens to draw them all"));
    assert!(picture.len() < 3_000_000, "{}", picture.len());
    // One that waits for long is cut short.
    folder.write("long.csv", "up,patience\n1,50000\n");
    let long = ["sim", "lift.ladder", "long.csv", "--scans", "60000", "--watch", "motor,delay.ET"];
    let run = folder.run(&[&long[..], &["--waves", "waves.svg"]].concat());
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    let picture = folder.read("waves.svg");
    assert!(picture.contains(">50000</text>") && picture.len() < 10_000, "{picture}");
}

#[test]
fn tests_leave_dumps() {
    let folder = folder();
    let tests = "test \"it waits, and then goes up!\"  up := 1  patience := 2ms  scan  wait 1ms
                 expect !motor  wait 1ms  expect motor
                 test \"no\"  up := 1  scan  expect !motor";
    folder.write("lift.ladder", &format!("{PROGRAM}{tests}"));
    let run = folder.run(&["test", "lift.ladder", "--vcd", "waves"]);
    assert_eq!(run.code, 1, "{}", run.out);
    let dump = folder.read("waves/lift_1_it_waits_and_then_goes_up.vcd");
    assert_eq!(values(&dump, &["lift", "motor"], 9), [0, 0, 1]);
    assert!(folder.path("waves/lift_2_no.vcd").is_file(), "that of a failing test too");
}

/// A program with a test that fails, under a title that a shell would take apart.
const FAILING: &str = "ladder press  input start, guard  output motor, lamp
    rung [ start | motor ] guard ( motor )
    rung motor delay:TON(PT := 5s) ( lamp )
    test \"it's $on\"  guard := 1  start := 1  scan  start := 0  wait 6s  guard := 0  scan
        expect !start lamp
    test \"good\"  scan  reset  start := 1  guard := 1  scan  expect motor
";

#[test]
fn tests_leave_pictures() {
    let folder = Folder::new();
    folder.write("press.ladder", FAILING);
    let run = folder.run(&["test", "press.ladder", "--svg", "pictures"]);
    assert_eq!(run.code, 1);
    let mut files: Vec<String> = fs::read_dir(folder.path("pictures"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    files.sort();
    let [first, second] = ["press_1_it_s_on", "press_2_good"];
    let wanted = [first, second].map(|stem| [format!("{stem}.svg"), format!("{stem}_waves.svg")]);
    assert_eq!(files, wanted.concat());
    let power = folder.read("pictures/press_1_it_s_on.svg");
    assert!(power.contains("$on&#34;, fails here: power in scan 6001</text>"), "{power}");
    assert!(labels(&power)[0].ends_with("motor is off, no power at the right end"));
    let waves = folder.read("pictures/press_1_it_s_on_waves.svg");
    let names = labels(&waves);
    let names: Vec<&str> = names.iter().map(|label| label.split(':').next().unwrap()).collect();
    assert_eq!(names, ["tick", "guard", "start", "lamp"]);
    // Scans count from the last reset.
    let power = folder.read("pictures/press_2_good.svg");
    assert!(power.contains("passes: power in scan 0</text>"), "{power}");
    assert_eq!(folder.run(&["test", "press.ladder", "--svg", "pictures"]).code, 1, "once more");
}

/// The command that a failing test names tells why.
#[test]
fn a_failing_test_leads_to_its_cause() {
    let folder = Folder::new();
    folder.write("press.ladder", FAILING);
    let run = folder.run(&["test", "press.ladder"]);
    let help = run.err.lines().find_map(|line| line.split_once("help: the cause: hotrail "));
    let (_, arguments) = help.unwrap_or_else(|| panic!("{}", run.err));
    let script = format!("{} {arguments}", env!("CARGO_BIN_EXE_hotrail"));
    let mut shell = std::process::Command::new("sh");
    let output = shell.args(["-c", &script]).current_dir(folder.path("")).output().unwrap();
    let why = common::folder::Run::new(output);
    assert_eq!((why.code, why.err.as_str()), (0, ""), "{script}");
    assert!(why.out.starts_with("lamp went off in scan 6001: ( lamp ), rung 2"), "{}", why.out);
    assert!(why.out.contains("guard went off in scan 6001: an input"), "{}", why.out);
}

#[test]
fn a_test_is_meant_by_its_title_or_a_part_of_it() {
    let folder = Folder::new();
    let tests = "test \"go\" scan expect a test \"go on\" a := 1 scan expect y";
    folder.write("p.ladder", &format!("ladder p input a output y rung a (y) {tests}"));
    let why = |title| folder.run(&["why", "p.ladder", "--test", title, "y"]);
    assert!(why("go").out.starts_with("y is off"), "{}", why("go").out);
    assert!(why("on").out.starts_with("y went on"), "{}", why("on").out);
    assert!(why("o").err.contains("2 tests have `o` in their titles"), "{}", why("o").err);
    assert!(why("stop").err.contains("no test has `stop` in its title"), "{}", why("stop").err);
    assert_eq!(folder.run(&["why", "p.ladder", "y"]).code, 2);
    let drawn = folder.run(&["draw", "p.ladder", "--test", "go on", "--ascii"]);
    assert!(drawn.out.contains("power in scan 0\n") && drawn.out.contains("[ ]"), "{}", drawn.out);
}
