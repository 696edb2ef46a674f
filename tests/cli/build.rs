//! The options of `hotrail build`, and what it prints for them.

use crate::common::folder::Folder;
use crate::good;

#[test]
fn options_that_do_not_fit_the_program_are_refused() {
    let folder = good();
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
fn a_wrapper_with_an_inexact_tick_is_remarked() {
    let folder = good();
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
fn the_longest_chain_is_held_against_the_clock_of_the_board() {
    let folder = Folder::new();
    let rung = "rung { a + b - 1 > b + b } (y)";
    folder.write("sums.ladder", &format!("ladder sums  input a, b : DINT  output y  {rung}"));
    let notes = |more: &[&str]| {
        let build = folder.run(&[&["build", "sums.ladder", "-o", "out"], more].concat());
        build.err.contains("W0311")
    };
    assert!(!notes(&[]));
    assert!(notes(&["--clock", "100MHz"]));
    assert!(!notes(&["--clock", "100MHz", "--schedule", "levels"]));
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
