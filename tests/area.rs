//! The size of circuits beside those that an engineer writes by hand: `tests/area/README.md`.

mod common;

use std::fs;
use std::path::{Path, PathBuf};

use common::bench::Bench;
use common::{designs, require_tool, run};
use hotrail::backend::hdl::{self, Language, Options};
use hotrail::circuit::{self, Design, Simulator, Valid};
use hotrail::expand;
use hotrail::source::Source;

fn ladders() -> Vec<PathBuf> {
    let entries = fs::read_dir("tests/area").unwrap().map(|entry| entry.unwrap().path());
    let mut ladders: Vec<PathBuf> =
        entries.filter(|path| path.extension().is_some_and(|ending| ending == "ladder")).collect();
    ladders.sort();
    assert_eq!(ladders.len(), 11);
    ladders
}

fn name(ladder: &Path) -> String {
    ladder.file_stem().unwrap().to_string_lossy().into_owned()
}

fn compile(ladder: &Path) -> Valid<Design> {
    let source = Source::new(name(ladder), fs::read_to_string(ladder).unwrap());
    let (program, findings) = hotrail::analyze(&source);
    assert!(findings.is_empty(), "{findings:?}");
    hotrail::compile(&program.unwrap(), &expand::Options::default())
}

/// LUTs and flip-flops of a file in the folder.
fn size(folder: &Path, file: &str, top: &str) -> (u64, u64) {
    let script = format!("read_verilog {file}; synth_ice40 -top {top}; tee -o size.txt stat");
    run(folder, "yosys", &["-q", "-p", &script]);
    let report = fs::read_to_string(folder.join("size.txt")).unwrap();
    let count = |kind: &str| {
        let lines = report.lines().filter(|line| line.trim_start().starts_with(kind));
        lines.map(|line| line.split_whitespace().last().unwrap().parse::<u64>().unwrap()).sum()
    };
    (count("SB_LUT4"), count("SB_DFF"))
}

#[test]
fn no_circuit_is_larger_than_by_hand() {
    if !require_tool("yosys") {
        return;
    }
    for ladder in ladders() {
        let (name, folder) = (name(&ladder), tempfile::tempdir().unwrap());
        let folder = folder.path();
        let text = hdl::print(&compile(&ladder), Language::Verilog, &Options::default());
        fs::write(folder.join("ladder.v"), text).unwrap();
        fs::copy(ladder.with_extension("v"), folder.join("hand.v")).unwrap();
        let ours = size(folder, "ladder.v", &name);
        let hand = size(folder, "hand.v", &name);
        assert!(hand.0 > 0 && hand.1 > 0, "{name}: {hand:?}");
        assert!(
            ours.0 <= hand.0 && ours.1 <= hand.1,
            "{name}: {ours:?} LUTs and flip-flops, by hand {hand:?}"
        );
    }
}

/// Rows of inputs that hold for a while, so that timers run out and counters fill.
fn stimulus(inputs: usize) -> Vec<Vec<u64>> {
    let mut random = fastrand::Rng::with_seed(7);
    let mut row = vec![0; inputs];
    let mut slowness = 2;
    let mut next = |scan: usize| {
        if scan.is_multiple_of(1000) {
            slowness = [2, 8, 40, 200][scan / 1000 % 4];
        }
        for (place, input) in row.iter_mut().enumerate() {
            match place {
                0 => *input = u64::from(random.u32(..8) > 0),
                // In every other phase the first input alone changes often.
                2.. if scan / 4000 == 1 => *input = u64::from(random.u32(..500) == 0),
                _ if random.u32(..slowness) == 0 => *input = u64::from(random.bool()),
                _ => {}
            }
        }
        row.clone()
    };
    (0..8000).map(&mut next).collect()
}

#[test]
fn what_is_written_by_hand_does_the_same() {
    if !require_tool("iverilog") {
        return;
    }
    for ladder in ladders() {
        let (name, folder) = (name(&ladder), tempfile::tempdir().unwrap());
        let design = compile(&ladder);
        let text = hdl::print(&design, Language::Verilog, &Options::default());
        fs::write(folder.path().join("ladder.v"), text).unwrap();
        fs::copy(ladder.with_extension("v"), folder.path().join("hand.v")).unwrap();
        let bench = Bench::of_core(&design, &Options::default());
        let rows = stimulus(design.top().inputs.len());
        let run = |file: &str| bench.run(Language::Verilog, folder.path(), &[file], &rows).unwrap();
        let (ours, hand) = (run("ladder.v"), run("hand.v"));
        let differs = ours.lines().zip(hand.lines()).position(|(ours, hand)| ours != hand);
        assert_eq!(differs, None, "{name}: first scan that differs");
        assert_eq!(ours.lines().count(), hand.lines().count());
        // Every output is on and off at some time, or the comparison says little.
        for port in 0..design.top().outputs.len() {
            for value in ["0", "1"] {
                let is_seen = hand.lines().any(|line| line.split(' ').nth(port) == Some(value));
                assert!(is_seen, "{name}: output {port} is never {value}");
            }
        }
    }
}

#[test]
fn a_simplified_circuit_does_the_same() {
    for seed in 0..300 {
        let design = designs::random(seed);
        let small = circuit::simplify((*design).clone()).validate().unwrap();
        let (mut first, mut second) = (Simulator::new(&design), Simulator::new(&small));
        let mut random = fastrand::Rng::with_seed(seed);
        let (inputs, outputs) = (&design.top().inputs, design.top().outputs.len());
        for scan in 0..60 {
            let row: Vec<u64> = inputs.iter().map(|_| random.u64(..)).collect();
            first.settle(&row);
            second.settle(&row);
            for port in 0..outputs {
                let (meant, shown) = (first.output(port), second.output(port));
                assert_eq!(shown, meant, "random design {seed}, scan {scan}, output {port}");
            }
            first.clock();
            second.clock();
        }
    }
}

fn design(text: &str) -> Valid<Design> {
    let (program, findings) = hotrail::analyze(&Source::new("small.ladder", text));
    let program = program.unwrap_or_else(|| panic!("{findings:?}"));
    hotrail::compile(&program, &expand::Options::default())
}

fn verilog(text: &str) -> String {
    hdl::print(&design(text), Language::Verilog, &Options::default())
}

/// Names and widths of the registers of a program, blocks' among them.
fn registers(text: &str) -> Vec<(String, u32)> {
    let flat = design(text).flatten();
    let mut registers: Vec<(String, u32)> =
        flat.registers.values().map(|r| (r.name.to_string(), r.width)).collect();
    registers.sort();
    registers
}

fn width(text: &str, name: &str) -> Option<u32> {
    registers(text).into_iter().find(|(other, _)| other == name).map(|(_, width)| width)
}

#[test]
fn a_count_is_as_wide_as_its_largest_number() {
    let timer = "ladder t input a output y rung a t1:TON(PT := 50ms) (y)";
    assert_eq!(width(timer, "t1.ET"), Some(6));
    // What is shown keeps its own width at the port only.
    let shown = "ladder t input a output n : TIME rung a t1:TON(PT := 50ms) { n := t1.ET }";
    assert_eq!(width(shown, "t1.ET"), Some(6));
    assert_eq!(width(shown, "n"), Some(6));
    let variable = "ladder t input a output y var n : INT
        rung rise(a) { n < 9 } { n := n + 1 } rung { n >= 9 } (y)";
    assert_eq!(width(variable, "n"), Some(4));
    let wraps = "ladder t input a output y var n : INT
        rung rise(a) { n := n + 1 } rung { n >= 9 } (y)";
    assert_eq!(width(wraps, "n"), Some(16));
}

#[test]
fn a_count_stops_where_nobody_follows_it() {
    let up = "ladder t input a output y rung a c1:CTU(PV := 5) (y)";
    assert_eq!(width(up, "c1.CV"), Some(3));
    let down = "ladder t input a, l output y rung a c1:CTD(LD := [ l ], PV := 5) (y)";
    assert_eq!(width(down, "c1.CV"), Some(3));
    let read = "ladder t input a output n : INT rung a c1:CTU(PV := 5) { n := c1.CV }";
    assert_eq!(width(read, "c1.CV"), Some(15));
    let both = "ladder t input a, b output y rung a c1:CTUD(CD := [ b ], PV := 5) (y)";
    assert_eq!(width(both, "c1.CV"), Some(16));
}

#[test]
fn a_running_time_that_is_only_compared_does_not_leave_its_timer() {
    let compared = "ladder t input a output y, z
        rung a t1:TON(PT := 50ms) (y) rung { t1.ET >= 20ms } (z)";
    let passed = Some(1);
    assert_eq!(width(compared, "t1.ET_at_least_20"), passed);
    assert_eq!(width(compared, "t1.ET_is_50"), passed);
    // Whoever reads the time itself compares it where it is read.
    let shown = "ladder t input a output y, z output n : TIME
        rung a t1:TON(PT := 50ms) (y) { n := t1.ET } rung { t1.ET >= 20ms } (z)";
    assert_eq!(width(shown, "t1.ET_at_least_20"), None);
    // Three bits are compared as cheaply as remembered.
    let small = "ladder t input a output y, z
        rung a t1:TON(PT := 7ms) (y) rung { t1.ET >= 5ms } (z)";
    assert_eq!(width(small, "t1.ET_at_least_5"), None);
    // What the scan before has left is compared as it is.
    let before = "ladder t input a output y, z
        rung { t1.ET >= 20ms } (z) rung a t1:TON(PT := 50ms) (y)";
    assert_eq!(width(before, "t1.ET_at_least_20"), None);
}

#[test]
fn a_variable_that_counts_remembers_what_it_has_passed() {
    let compares = |text: &str| verilog(text).contains(">=");
    let counts = "ladder t input a output y var n : INT
        rung rise(a) { n < 90 } { n := n + 1 } rung { n >= 30 } (y)";
    assert!(!compares(counts));
    // One that wraps would have to be compared with the highest number too.
    let wraps = "ladder t input a output y var n : UINT
        rung rise(a) { n := n + 1 } rung { n >= 30 } (y)";
    assert!(compares(wraps));
}

#[test]
fn a_word_is_free_while_nobody_looks_at_it() {
    let pulse = verilog("ladder t input a output y rung a t1:TP(PT := 50ms) (y)");
    assert!(pulse.contains("ET_next = run ? sum : 6'd0;"), "{pulse}");
    // While the pulse runs, it has not arrived.
    assert!(!pulse.contains("6'd50"), "{pulse}");
    let delay = verilog("ladder t input a output y rung a t1:TOF(PT := 50ms) (y)");
    assert!(!delay.contains("6'd50"), "{delay}");
    let shown = "ladder t input a output y output n : TIME
        rung a t1:TP(PT := 50ms) (y) { n := t1.ET }";
    assert!(verilog(shown).contains("6'd50"), "{}", verilog(shown));
    // A count that goes on where it stopped is kept.
    let resumed = "ladder t input go, a output y var run var n : UINT
        rung run [ a { n < 90 } { n := n + 1 } | { n >= 50 } (S y) ] rung go (run)";
    assert!(verilog(resumed).contains("n_next = run ? rung1_choice : n;"), "{}", verilog(resumed));
}

#[test]
fn what_several_registers_have_in_common_is_a_choice() {
    let has = |text: &str, line: &str| verilog(text).contains(line);
    // Cleared or set by one condition: a reset of flip-flops.
    let cleared = "ladder t input a, b, c, stop output x, y, z
        rung a (S x) rung b (S y) rung c (S z) rung stop (R x) (R y) (S z)";
    assert!(has(cleared, "x_next = stop ? 1'b0 : x_rung1;"));
    assert!(has(cleared, "y_next = stop ? 1'b0 : y_rung2;"));
    assert!(has(cleared, "z_next = stop ? 1'b1 : z_rung3;"));
    // Two are cheaper as gates.
    let two = "ladder t input a, b, stop output x, y
        rung a (S x) rung b (S y) rung stop (R x) (R y)";
    assert!(has(two, "x_next = x_rung1 & ~stop;"));
    // Kept by one condition: an enable, also of a word.
    let kept = "ladder t input go, a, b output x var n : UINT output m : UINT
        rung go [ a (S x) | b (R x) | { n := n + 3 } { m := n } ]";
    assert!(has(kept, "x_next = go ? (a | x_reg) & ~b : x_reg;"), "{}", verilog(kept));
    // Alone, a bit needs no enable.
    let alone = "ladder t input go, a, b output x rung go [ a (S x) | b (R x) ]";
    assert!(!has(alone, "?"));
}

#[test]
fn equal_edge_memories_are_one_register() {
    let text = "ladder t input a output y, z rung rise(a) (y) rung fall(a) (z)";
    assert_eq!(registers(text).len(), 3);
}

#[test]
fn an_array_stays_one_port_beside_a_block() {
    let text = "ladder t input a input w : WORD[4] output y : WORD[2] output z
        rung a t1:TON(PT := 50ms) (z) rung { y[0] := w[3] } rung { y[1] := w[2] }";
    let (program, findings) = hotrail::analyze(&Source::new("small.ladder", text));
    let program = program.unwrap_or_else(|| panic!("{findings:?}"));
    let design = hotrail::compile(&program, &expand::Options::default());
    let vectors: Vec<&str> = design.top().vectors.iter().map(|one| &*one.name).collect();
    assert_eq!(vectors, ["w", "y"]);
}
