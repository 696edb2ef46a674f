//! The printed text itself, without any tool: names, comments, lines.

mod common;

use std::collections::BTreeSet;

use common::designs;
use hotrail::backend::hdl::{self, Language, Options};
use hotrail::circuit::{Circuit, Design, Valid};
use hotrail::expand::{self, Schedule};

fn print(design: &Valid<Design>, language: Language) -> String {
    let options = Options { source: "test.ladder".to_owned(), ..Options::default() };
    hdl::print(design, language, &options)
}

/// The names that a text declares, but for the wire that takes what is unused.
fn declared(text: &str, language: Language) -> BTreeSet<&str> {
    let words: &[&str] = match language {
        Language::Verilog => &["module ", "input ", "output ", "reg ", "wire "],
        Language::Vhdl => &["entity ", "signal "],
    };
    let mut names = BTreeSet::new();
    for line in text.lines().map(str::trim) {
        let is_port =
            language == Language::Vhdl && (line.contains(" : in ") || line.contains(" : out "));
        if !is_port && !words.iter().any(|word| line.starts_with(word)) {
            continue;
        }
        let line = line.split(&['=', ';', '('][..]).next().expect("there is a first part");
        let end = match language {
            Language::Verilog => line,
            Language::Vhdl => line.split(':').next().expect("there is a first part"),
        };
        let end = end.trim_end_matches(" is").trim().trim_end_matches(',');
        names.insert(end.rsplit(' ').next().expect("there is a last word"));
    }
    names.into_iter().filter(|name| !name.starts_with("unused")).collect()
}

#[test]
fn both_languages_declare_the_same_names() {
    let designs = (1..=30).map(designs::random).chain([
        designs::start_stop(),
        designs::hostile(),
        designs::blinker(),
    ]);
    for design in designs {
        let (verilog, vhdl) = (print(&design, Language::Verilog), print(&design, Language::Vhdl));
        let names = declared(&verilog, Language::Verilog);
        assert!(names.len() > 10, "{names:?}");
        assert_eq!(names, declared(&vhdl, Language::Vhdl));
    }
}

#[test]
fn the_same_design_gives_the_same_text() {
    for language in [Language::Verilog, Language::Vhdl] {
        assert_eq!(print(&designs::random(4), language), print(&designs::random(4), language));
    }
}

#[test]
fn files_are_known_by_their_first_line() {
    for language in [Language::Verilog, Language::Vhdl] {
        assert!(hdl::bears_header(&print(&designs::start_stop(), language)));
    }
    assert!(!hdl::bears_header("// Written by hand\nmodule start_stop;"));
    assert!(!hdl::bears_header("module x; // Made by hotrail 0.1.0"));
}

#[test]
fn nothing_that_a_user_writes_leaves_its_place() {
    insta::assert_snapshot!("hostile.v", print(&designs::hostile(), Language::Verilog));
    insta::assert_snapshot!("hostile.vhd", print(&designs::hostile(), Language::Vhdl));
}

#[test]
fn ports_are_found_by_their_users_names() {
    let ports = hdl::port_names(&designs::hostile(), &Options::default());
    assert_eq!((&*ports.module, &*ports.wrapper), ("module_u", "module_top"));
    let names = |ports: &[hdl::PortName]| -> Vec<String> {
        ports.iter().map(|port| port.name.clone()).collect()
    };
    assert_eq!(names(&ports.inputs)[..4], ["tick", "clk_u", "CLK_u_2", "rst_u"]);
    assert_eq!(names(&ports.outputs), ["std_logic_u", "a_b_2_2"]);
}

#[test]
fn long_expressions_are_broken_at_operators() {
    let mut circuit = Circuit::new("long");
    let inputs: Vec<_> = (0..60).map(|i| circuit.input(format!("some_input_{i}"), 1)).collect();
    circuit.section("rung 1", 1);
    let groups: Vec<_> = inputs
        .chunks(10)
        .enumerate()
        .map(|(i, chunk)| {
            if i % 2 == 0 {
                circuit.and(chunk.iter().copied())
            } else {
                circuit.or(chunk[..3].iter().copied())
            }
        })
        .collect();
    let any = circuit.or(groups[..3].iter().copied());
    let not = circuit.not(any);
    let all = circuit.and([not, groups[3], groups[4], inputs[59]]);
    circuit.output("q", all);
    let design = designs::single(circuit);
    let verilog = print(&design, Language::Verilog);
    let vhdl = print(&design, Language::Vhdl);
    for line in verilog.lines().chain(vhdl.lines()).filter(|line| !line.contains("unused")) {
        assert!(line.len() <= 100, "{} columns: {line}", line.len());
    }
    let body = |text: &str| text.split("rung 1").nth(1).expect("there is a rung").to_owned();
    insta::assert_snapshot!("long.v", body(&verilog));
    insta::assert_snapshot!("long.vhd", body(&vhdl));
}

/// Wherever the end of a line falls, and a line that is broken had no room for what follows.
#[test]
fn words_without_an_operand_are_broken_too() {
    for length in 4..=40 {
        let [a, b] = ["a", "b"].map(|start| format!("{start:x<length$}"));
        let ladder = format!(
            "ladder words input {a}, {b} : UINT output q : UINT output y
             rung {{ q := {a} / {b} }} rung {{ {a} = {b} }} ( y )"
        );
        let program = common::analyze("words.ladder", &ladder).unwrap();
        let design = hotrail::compile(&program, &expand::Options::default());
        for language in [Language::Verilog, Language::Vhdl] {
            let text = print(&design, language);
            let code = text.lines().filter(|line| !line.trim_start().starts_with(['/', '-']));
            let lines: Vec<&str> = code.collect();
            for (line, next) in lines.iter().zip(&lines[1..]) {
                assert!(line.len() <= 100, "{} columns: {line}", line.len());
                let next = next.trim_start();
                let is_word = ["== ", "? ", "else '0'"];
                if is_word.iter().any(|word| next.starts_with(word)) {
                    let word = next.split(' ').next().unwrap_or_default();
                    assert!(line.len() + 1 + word.len() > 90, "{line}\n{next}");
                }
            }
        }
    }
}

#[test]
fn deep_and_wide_expressions_print_in_bounded_depth_and_time() {
    let mut circuit = Circuit::new("deep");
    let inputs: Vec<_> = (0..50_000).map(|i| circuit.input(format!("i{i}"), 1)).collect();
    let wide = circuit.or(inputs.iter().copied());
    let mut deep = wide;
    for &input in &inputs {
        let and = circuit.and([deep, input]);
        deep = circuit.not(and);
    }
    circuit.output("q", deep);
    let design = designs::single(circuit);
    for language in [Language::Verilog, Language::Vhdl] {
        let text = print(&design, language);
        let longest = text.lines().map(str::len).max();
        assert!(longest <= Some(140), "{longest:?}");
        assert!(text.lines().count() < 400_000);
    }
}

/// Whatever the variables are called.
#[test]
fn ports_that_the_hardware_has_besides_keep_their_names() {
    let ladder = include_str!("lockstep/ports_with_names_of_ours.ladder");
    let program = common::analyze("ports.ladder", ladder).unwrap();
    let named = |schedule| {
        let options = expand::Options { schedule, ..expand::Options::default() };
        let text = print(&hotrail::compile(&program, &options), Language::Verilog);
        let ports = text.lines().filter(|line| line.contains("put "));
        let name = |line: &str| line.rsplit(' ').next().unwrap().trim_end_matches(',').to_owned();
        ports.map(name).collect::<Vec<String>>().join(" ")
    };
    assert_eq!(
        named(Schedule::Flat),
        "clk rst tick tick_u scan_start_u clk_u rst_u scan_done_u scan_1 enable"
    );
    assert_eq!(
        named(Schedule::Levels),
        "clk rst tick scan_start tick_u scan_start_u clk_u rst_u scan_done_u scan_1 enable scan_done"
    );
}

/// In the clocks of its rung, if a scan takes several.
#[test]
fn a_block_has_an_enable_where_its_rung_has_a_clock() {
    let ladder = "ladder clocks input a output x, y rung a t:TON(PT := 5ms) (x) rung x (y)";
    let program = common::analyze("clocks.ladder", ladder).unwrap();
    for (schedule, enables) in [(Schedule::Flat, 0), (Schedule::Serial, 1)] {
        let options = expand::Options { schedule, ..expand::Options::default() };
        let design = hotrail::compile(&program, &options);
        for (language, port, connection) in [
            (Language::Verilog, "input  wire enable,", ".enable(rung_1)"),
            (Language::Vhdl, "enable : in  std_logic;", "enable => rung_1"),
        ] {
            let text = print(&design, language);
            assert_eq!(text.matches(port).count(), enables, "{text}");
            assert_eq!(text.matches(connection).count(), enables, "{text}");
        }
    }
}
