//! What `hotrail test` leaves, and what a failing test leads to.

use std::fs;

use crate::common::folder::Folder;
use crate::dumps::values;
use crate::pictures::labels;
use crate::{PROGRAM, folder};

/// A program with a test that fails, under a title that a shell would take apart.
const FAILING: &str = "ladder press  input start, guard  output motor, lamp
    rung [ start | motor ] guard ( motor )
    rung motor delay:TON(PT := 5s) ( lamp )
    test \"it's $on\"  guard := 1  start := 1  scan  start := 0  wait 6s  guard := 0  scan
        expect !start lamp
    test \"good\"  scan  reset  start := 1  guard := 1  scan  expect motor
";

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
    let why = folder.shell(&format!("hotrail {arguments}"));
    assert_eq!((why.code, why.err.as_str()), (0, ""), "{arguments}");
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
