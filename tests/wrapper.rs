//! The printed wrapper: tick, synchronisers and debounce do in simulators what a plain model says.

mod common;

use std::fmt::Write;
use std::fs;
use std::path::Path;

use common::bench::Bench;
use common::{designs, require_tool, run};
use hotrail::backend::hdl::{self, Board, Language, Options, Prescaler, ResetStyle};
use hotrail::circuit::{Design, Valid};

const RESETS: [ResetStyle; 3] = [ResetStyle::SyncHigh, ResetStyle::SyncLow, ResetStyle::AsyncLow];

fn options(reset: ResetStyle) -> Options {
    Options { source: "echo.ladder".to_owned(), reset, version: "0.1.0".to_owned() }
}

fn board(clocks: u64, debounce_ticks: Option<u32>) -> Board {
    Board { clock_hz: clocks * 1000, tick_ns: 1_000_000, debounce_ticks }
}

/// Prints core and wrapper in both languages into a folder.
fn print_into(folder: &Path, design: &Valid<Design>, options: &Options, board: &Board) {
    for (language, end) in [(Language::Verilog, "v"), (Language::Vhdl, "vhd")] {
        let core = hdl::print(design, language, options);
        let wrapper = hdl::print_wrapper(design, language, options, board);
        for (text, name) in [(core, "echo"), (wrapper, "echo_top")] {
            fs::write(folder.join(format!("{name}.{end}")), text).expect("can write");
        }
    }
}

#[test]
fn it_reads_well() {
    let design = designs::echo();
    let board = Board { clock_hz: 12_000_000, tick_ns: 1_000_000, debounce_ticks: Some(10) };
    for (language, name) in [(Language::Verilog, "echo_top.v"), (Language::Vhdl, "echo_top.vhd")] {
        let text = hdl::print_wrapper(&design, language, &options(ResetStyle::SyncHigh), &board);
        assert!(hdl::bears_header(&text));
        insta::assert_snapshot!(name, text);
    }
}

#[test]
fn lint_tools_are_content() {
    let boards = [board(1, None), board(2, Some(1)), board(1000, Some(20))];
    for (reset, board) in RESETS.into_iter().zip(boards) {
        let folder = tempfile::tempdir().expect("can make a folder");
        let folder = folder.path();
        print_into(folder, &designs::echo(), &options(reset), &board);
        let files = ["echo.v", "echo_top.v"];
        if require_tool("iverilog") {
            let arguments = [&["-g2005", "-Wall", "-o", "echo"], &files[..]].concat();
            assert_eq!(run(folder, "iverilog", &arguments), "", "iverilog warns");
        }
        if require_tool("verilator") {
            let lint = ["--lint-only", "-Wall", "--top-module", "echo_top"];
            let said = run(folder, "verilator", &[&lint, &files[..]].concat());
            assert_eq!(said, "", "verilator warns");
        }
        if require_tool("ghdl") {
            let said = run(folder, "ghdl", &["-a", "--std=93", "echo.vhd", "echo_top.vhd"]);
            assert_eq!(said, "", "ghdl warns");
        }
        if require_tool("yosys") {
            let script = "read_verilog echo.v echo_top.v; synth_ice40 -top echo_top; check -assert";
            let said = run(folder, "yosys", &["-q", "-p", script]);
            assert!(!said.contains("Warning"), "{said}");
        }
    }
}

/// Wrapper and `echo` as a model that is stepped by the clock.
#[derive(Default)]
struct Model {
    reset_pipe: [bool; 2],
    prescaler: u64,
    button: [u64; 2],
    word: [u64; 2],
    stable: u64,
    held: u32,
    ticks: u64,
    light: u64,
    shown: u64,
}

impl Model {
    fn clock(&mut self, button: u64, word: u64, clocks: u64, debounce: Option<u32>) {
        let (reset, tick) = (self.reset_pipe[1], self.prescaler == clocks - 1);
        let [was_button, was_word] = [self.button[1], self.word[1]];
        let seen = if debounce.is_some() { self.stable } else { was_button };
        self.ticks = if reset { 0 } else { (self.ticks + u64::from(tick)) % 256 };
        self.light = if reset { 0 } else { seen };
        self.shown = if reset { 0 } else { was_word };
        if reset || was_button == self.stable {
            self.held = 0;
        } else if tick {
            self.held += 1;
            if debounce.is_some_and(|ticks| self.held == ticks + 1) {
                (self.stable, self.held) = (was_button, 0);
            }
        }
        self.prescaler = if reset || tick { 0 } else { self.prescaler + 1 };
        self.button = [button, self.button[0]];
        self.word = [word, self.word[0]];
        self.reset_pipe = [false, self.reset_pipe[0]];
    }
}

#[test]
fn tick_synchronisers_and_debounce_follow_the_model() {
    let cases = [(1, None), (5, None), (2, Some(1)), (4, Some(3)), (1, Some(4))];
    for (case, (clocks, debounce)) in cases.into_iter().enumerate() {
        let reset = RESETS[case % 3];
        let (design, options) = (designs::echo(), options(reset));
        let folder = tempfile::tempdir().expect("can make a folder");
        print_into(folder.path(), &design, &options, &board(clocks, debounce));
        let mut random = fastrand::Rng::with_seed(3);
        let mut button = 0;
        let mut model = Model { reset_pipe: [true, true], ..Model::default() };
        let (mut rows, mut expected) = (Vec::new(), String::new());
        for _ in 0..200 {
            button ^= u64::from(random.u32(..7) == 0);
            let word = random.u64(..16);
            rows.push(vec![button, word]);
            writeln!(expected, "{:08b} {:b} {:04b} ", model.ticks, model.light, model.shown)
                .expect("a string takes it");
            model.clock(button, word, clocks, debounce);
        }
        assert!(model.ticks > 0 && expected.contains(" 1 "), "the case shows nothing");
        let bench = Bench::of_wrapper(&design, &options);
        for (language, end) in [(Language::Verilog, "v"), (Language::Vhdl, "vhd")] {
            let files = [format!("echo.{end}"), format!("echo_top.{end}")];
            let files = files.each_ref().map(String::as_str);
            if let Some(said) = bench.run(language, folder.path(), &files, &rows) {
                assert_eq!(said, expected, "{language:?} {reset:?} {clocks} {debounce:?}");
            }
        }
    }
}

#[test]
fn the_prescaler_is_what_the_text_says() {
    let text = |clock_hz| {
        let board = Board { clock_hz, tick_ns: 1_000_000, debounce_ticks: None };
        let options = options(ResetStyle::SyncHigh);
        hdl::print_wrapper(&designs::echo(), Language::Verilog, &options, &board)
    };
    assert_eq!(Prescaler::new(32_768, 1_000_000).clocks, 33);
    let said = "// Tick: every 33 clocks of 32768 Hz, wanted every 1 ms, error +7080.078 ppm.";
    assert!(text(32_768).contains(said));
    assert!(text(1000).contains("wire tick = 1'b1;"));
}
