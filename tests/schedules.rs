//! The schedules of several clocks a scan give the evaluator's values, scan by scan, whatever
//! comes between the scans and in them.

mod common;

use common::scheduled::differences;
use common::{amount, analyze, checks};
use hotrail::backend::hdl;
use hotrail::circuit::{Net, Simulator};
use hotrail::expand::{self, Schedule};
use hotrail::model::Program;

#[test]
fn random_programs() {
    checks::SCHEDULES.hold(amount("HOTRAIL_RANDOM_PROGRAMS", 1000) / 4);
}

#[test]
fn kept_programs() {
    for (name, program) in common::kept_programs() {
        for seed in 0..5 {
            assert_eq!(differences(&program, 100, seed), None, "{name}, inputs {seed}");
        }
    }
}

#[test]
fn examples() {
    for (name, program) in common::example_programs() {
        for seed in 0..5 {
            assert_eq!(differences(&program, 400, seed), None, "{name}, inputs {seed}");
        }
    }
}

/// The most gates from registers and inputs to a register.
fn depth(program: &Program, schedule: Schedule) -> u32 {
    let options = expand::Options { schedule, ..expand::Options::default() };
    let design = hotrail::compile(program, &options);
    let circuit = design.top();
    let mut depths: Vec<u32> = Vec::new();
    for (_, cell) in circuit.cells() {
        let mut before = 0;
        let mut is_gate = false;
        circuit.for_each_operand(cell, |net| {
            is_gate = true;
            before = before.max(depths[net.into_raw().into_u32() as usize]);
        });
        depths.push(before + u32::from(is_gate));
    }
    let net = |net: Net| depths[net.into_raw().into_u32() as usize];
    circuit.roots().map(net).max().expect("there are registers")
}

/// What the schedules are for.
#[test]
fn a_clock_is_as_long_as_a_rung() {
    let chain = |rungs: usize| {
        let mut text = "ladder chain input x, v0 output ".to_owned();
        let names: Vec<String> = (1..=rungs).map(|n| format!("v{n}")).collect();
        text += &names.join(", ");
        (0..rungs).for_each(|n| text += &format!("\nrung [ v{n} | v{} !x ] (v{})", n + 1, n + 1));
        analyze("chain.ladder", &text).unwrap()
    };
    for schedule in [Schedule::Levels, Schedule::Serial] {
        let (short, long) = (depth(&chain(3), schedule), depth(&chain(40), schedule));
        assert_eq!(short, long, "{schedule:?}");
    }
    assert!(depth(&chain(40), Schedule::Flat) > 40);
}

/// Names of the flip-flops that step through a scan, and the level behind the head of each rung.
#[test]
fn the_text_tells_what_acts_in_which_clock() {
    let text = "ladder belt input a output x, y, z rung a (x) (z) rung x (y) rung y (S z)";
    let program = analyze("belt.ladder", text).unwrap();
    let print = |schedule: Schedule| {
        let options = expand::Options { schedule, ..expand::Options::default() };
        let design = hotrail::compile(&program, &options);
        hdl::print(&design, hdl::Language::Verilog, &hdl::Options::default())
    };
    let levels = print(Schedule::Levels);
    for said in [
        "rung 1, :1, level 1",
        "rung 2, :1, level 2",
        "rung 3, :1, level 3",
        "level_1_or_3 = level_1 | level_3;",
    ] {
        assert!(levels.contains(said), "{said}:\n{levels}");
    }
    let serial = print(Schedule::Serial);
    assert!(serial.contains("rung_2") && !serial.contains("level"), "{serial}");
}

/// What stands in a fenced block of the page behind a line.
fn block<'t>(page: &'t str, line: &str) -> &'t str {
    let (_, behind) = page.split_once(line).unwrap_or_else(|| panic!("no {line}"));
    let (_, block) = behind.split_once('\n').expect("a line has an end");
    block.split_once("\n```").expect("a block has an end").0
}

/// The timing diagram of the page is that of the program above it.
#[test]
fn the_page_is_true() {
    let page = std::fs::read_to_string("docs/schedules.md").unwrap();
    let program = analyze("belt.ladder", block(&page, "```ladder")).unwrap();
    let diagram = block(&page, "<!-- timing of belt, levels -->\n```text");
    let options = expand::Options { schedule: Schedule::Levels, ..expand::Options::default() };
    let mut circuit = Simulator::new(&hotrail::compile(&program, &options));
    let rows: Vec<(&str, Vec<u64>)> = diagram
        .lines()
        .map(|line| {
            let (name, levels) = line.split_once(' ').expect("a row has a name");
            (name, levels.trim().chars().map(|c| u64::from(c == '#')).collect())
        })
        .collect();
    let inputs: Vec<&[u64]> = circuit
        .circuit()
        .inputs
        .iter()
        .map(|input| &*rows.iter().find(|(name, _)| *name == &*input.name).unwrap().1)
        .collect();
    let outputs: Vec<String> =
        circuit.circuit().outputs.iter().map(|output| output.name.to_string()).collect();
    let mut shown = vec![String::new(); outputs.len()];
    for clock in 0..inputs[0].len() {
        let row: Vec<u64> = inputs.iter().map(|levels| levels[clock]).collect();
        circuit.settle(&row);
        for (port, shown) in shown.iter_mut().enumerate() {
            shown.push(if circuit.output(port) == 1 { '#' } else { '_' });
        }
        circuit.clock();
    }
    for (name, shown) in outputs.iter().zip(shown) {
        let line = format!("{name:<12}{shown}");
        assert!(diagram.contains(&line), "the page does not show\n{line}");
    }
    let design = hotrail::compile(&program, &options);
    let text = hdl::print(&design, hdl::Language::Verilog, &hdl::Options::default());
    let process = block(&page, "```verilog");
    assert!(text.contains(process), "no\n{process}\nin\n{text}");
}
