//! The processor's Verilog in `hdl/` runs in Icarus in lock step with the emulator, and its lint
//! tools are content.

mod common;

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use common::emulated::compile;
use common::lp::{self, REGISTERS, Row};
use common::{amount, require_tool, run};
use fastrand::Rng;
use hotrail::backend::processor::Image;
use hotrail::model::Program;

fn modules() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("hdl");
    let entries = fs::read_dir(folder).expect("the processor is there");
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    files.retain(|path| path.extension().is_some_and(|ending| ending == "v"));
    files.sort();
    files
}

fn names(files: &[PathBuf]) -> Vec<&str> {
    files.iter().map(|path| path.to_str().unwrap()).collect()
}

#[test]
fn verilator_has_nothing_to_say() {
    if !require_tool("verilator") {
        return;
    }
    let files = modules();
    for parameters in [
        &[][..],
        &["-GTIMERS=0", "-GCOUNTERS=0", "-GDRUMS=0", "-GSHIFTS=0", "-GBITS=0", "-GINPUTS=8"],
        &["-GTIMERS=0", "-GSHIFTS=0", "-GTICKS_PER_TENTH=0", "-GSTACK_DEPTH=2"],
        &["-GINPUTS=0", "-GOUTPUTS=0"],
        &["-GINPUTS=256", "-GOUTPUTS=1"],
    ] {
        let lint = ["--lint-only", "-Wall", "--top-module", "ladder_processor"];
        run(Path::new("."), "verilator", &[&lint[..], parameters, &names(&files)].concat());
    }
}

/// Drives the processor and prints outputs, image and some registers after each scan, with the
/// clocks that it took.
fn bench(image: &Image, rows: &[Row]) -> String {
    let rom = &image.rom;
    let bits = |count: u16| count.max(1) - 1;
    let [tenth, second] = lp::ticks(image);
    let mut text = format!(
        "module bench;
  reg clk = 0, rst = 1, tick = 0, halt = 1, RM_rw = 0;
  reg [10:0] RM_addr = 0;
  reg [15:0] RM_in = 0;
  reg [{}:0] inputs = 0;
  wire [{}:0] outputs;
  wire idle, scan_done;
  integer clocks = 0, i;
  ladder_processor #(
    .INPUTS({}), .OUTPUTS({}), .TICKS_PER_TENTH({tenth}), .TICKS_PER_SECOND({second}),
    .CODE_FILE(\"test.hex\"), .REGISTER_FILE(\"test_regs.hex\"), .IMAGE_FILE(\"test_image.hex\")
  ) dut (
    .clk(clk), .rst(rst), .tick(tick), .inputs(inputs), .outputs(outputs), .halt(halt),
    .idle(idle), .scan_done(scan_done), .code_write(1'b0), .waddr(10'd0), .code_in(16'd0),
    .at_reset(1'b0), .io_addr(10'd0), .io_write(1'b0), .io_in(1'b0), .io_out(),
    .RM_addr(RM_addr), .RM_rw(RM_rw), .RM_in(RM_in), .RM_out()
  );
  always begin #1 clk = 1; clocks = clocks + 1; #1 clk = 0; end
  task host(input [10:0] register, input [15:0] word);
    begin RM_addr = register; RM_in = word; RM_rw = 1; @(negedge clk) RM_rw = 0; end
  endtask
  task scan(input [{}:0] now, input ticks);
    begin
      inputs = now; tick = ticks; halt = 0; clocks = 0;
      @(negedge clk) begin tick = 0; halt = 1; inputs = ~now; end
      while (!scan_done) @(negedge clk);
      @(negedge clk);
      $write(\"%0d %b \", clocks, outputs);
      for (i = 256; i < 1024; i = i + 1) $write(\"%b\", dut.image.bits.words[i]);
      for (i = 0; i < {REGISTERS}; i = i + 1) $write(\" %0h\", dut.functions.register_array.registers.words[i]);
      $write(\"\\n\");
    end
  endtask
  initial begin
    @(negedge clk); @(negedge clk) rst = 0;
    while (!idle) @(negedge clk);
    $display(\"reset %b\", outputs);
",
        bits(rom.pins.inputs),
        bits(rom.pins.outputs),
        rom.pins.inputs,
        rom.pins.outputs,
        bits(rom.pins.inputs),
    );
    for row in rows {
        for (register, word) in &row.written {
            writeln!(text, "    host({register}, {word});").unwrap();
        }
        let (inputs, width) = (row.digits(), row.inputs.len().max(1));
        writeln!(text, "    scan({width}'b{inputs}, {});", u8::from(row.tick)).unwrap();
    }
    text + "    $finish;\n  end\nendmodule\n"
}

fn compare(name: &str, program: &Program, image: &Image, scans: usize, random: Rng) {
    let rows = lp::rows(program, image, scans, random);
    let folder = tempfile::tempdir().unwrap();
    lp::write_image(folder.path(), image);
    fs::write(folder.path().join("bench.v"), bench(image, &rows)).unwrap();
    let files = modules();
    let arguments = [&["-g2005", "-o", "bench", "bench.v"][..], &names(&files)].concat();
    run(folder.path(), "iverilog", &arguments);
    let printed = run(folder.path(), "vvp", &["-n", "bench"]);
    lp::compare(name, &printed, &lp::meant(image, &rows));
}

#[test]
fn random_programs_run_in_lock_step() {
    if !require_tool("iverilog") {
        return;
    }
    for (name, program, image, random) in lp::random_programs(amount("HOTRAIL_RANDOM_IMAGES", 8)) {
        compare(&name, &program, &image, 40, random);
    }
}

#[test]
fn examples_that_the_processor_can_do_run_in_lock_step() {
    if !require_tool("iverilog") {
        return;
    }
    for (name, program, image, random) in lp::examples() {
        compare(&name, &program, &image, 60, random);
    }
}

#[test]
fn the_longest_shifts_run_in_lock_step() {
    if !require_tool("iverilog") {
        return;
    }
    let text = "ladder shifts input step, enable, data output last, first
        var up, down : WORD[32]
        rung step a:SHL(REG := up, EN := [ enable | !data ], DATA := data) ( last )
        rung step b:SHR(REG := down, EN := [ enable | !data ], DATA := data) ( first )";
    let (program, image) = compile(text).unwrap();
    compare("shifts", &program, &image, 200, Rng::with_seed(1));
}
