//! The processor's Verilog in `hdl/` runs in Icarus in lock step with the emulator, and its lint
//! tools are content.

mod common;

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use common::emulated::compile;
use common::lp::{self, Row};
use common::{amount, relay, require_tool, run};
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
        &["-GCODE_WORDS=33", "-GIMAGE_BITS=64", "-GREGISTERS=300", "-GSTACK_DEPTH=16"],
        &["-GCODE_WORDS=2", "-GIMAGE_BITS=8", "-GREGISTERS=8", "-GINPUTS=2", "-GOUTPUTS=0"],
    ] {
        let lint = ["--lint-only", "-Wall", "--top-module", "ladder_processor"];
        run(Path::new("."), "verilator", &[&lint[..], parameters, &names(&files)].concat());
    }
}

/// How a bench gets at the memories.
#[derive(Clone, Copy, PartialEq)]
enum Access {
    /// They read files at the start, and the bench looks into them.
    Direct,
    /// All of it goes over the host bus.
    Bus,
}

/// The statements that load an image over the bus and reset the processor to it.
fn load(image: &Image) -> String {
    let mut text = String::new();
    for (at, word) in image.rom.code.iter().enumerate() {
        writeln!(text, "    load({at}, {word});").unwrap();
    }
    text.push_str("    at_reset = 1;\n");
    for (register, word) in &image.rom.registers {
        writeln!(text, "    host({register}, {word});").unwrap();
    }
    for bit in &image.rom.image {
        writeln!(text, "    io({bit}, 1);").unwrap();
    }
    text + "    at_reset = 0; rst = 1;\n    @(negedge clk) rst = 0;\n    while (!idle) @(negedge clk);\n"
}

/// The statements that print the bits and the registers that are compared.
fn show(image: &Image, access: Access) -> String {
    let (bits, registers) = lp::held(image.rom.sizes);
    if access == Access::Bus {
        let bits = bits.iter().map(|bit| format!("      look({bit});\n"));
        let registers = registers.iter().map(|register| format!("      read({register});\n"));
        return bits.chain(registers).collect();
    }
    let (last, first) = (image.rom.sizes.image_bits.next_power_of_two(), bits.len());
    format!(
        "      for (i = {last} - {first}; i < {last}; i = i + 1) $write(\"%b\", dut.image.bits.words[i]);
      for (i = 0; i < {}; i = i + 1)
        $write(\" %0h\", dut.functions.register_array.registers.words[i]);
",
        registers.len()
    )
}

/// Drives the processor and prints outputs, image and some registers after each scan, with the
/// clocks that it took.
fn bench(image: &Image, rows: &[Row], access: Access) -> String {
    let rom = &image.rom;
    let bits = |count: u16| count.max(1) - 1;
    let [tenth, second] = lp::ticks(image);
    let sizes: String =
        rom.sizes.named().iter().map(|(name, size)| format!(".{name}({size}), ")).collect();
    let (files, load) = match access {
        Access::Direct => (
            ",\n    .CODE_FILE(\"test.hex\"), .REGISTER_FILE(\"test_regs.hex\"), \
             .IMAGE_FILE(\"test_image.hex\")",
            String::new(),
        ),
        Access::Bus => ("", load(image)),
    };
    let show = show(image, access);
    let mut text = format!(
        "module bench;
  reg clk = 0, rst = 1, tick = 0, halt = 1, RM_rw = 0, code_write = 0, at_reset = 0;
  reg io_write = 0, io_in = 0;
  reg [9:0] waddr = 0, io_addr = 0;
  reg [10:0] RM_addr = 0;
  reg [15:0] RM_in = 0, code_in = 0;
  wire [15:0] RM_out;
  wire io_out;
  reg [{}:0] inputs = 0;
  wire [{}:0] outputs;
  wire idle, scan_done;
  integer clocks = 0, i;
  ladder_processor #(
    .INPUTS({}), .OUTPUTS({}), {sizes}.TICKS_PER_TENTH({tenth}),
    .TICKS_PER_SECOND({second}){files}
  ) dut (
    .clk(clk), .rst(rst), .tick(tick), .inputs(inputs), .outputs(outputs), .halt(halt),
    .idle(idle), .scan_done(scan_done), .code_write(code_write), .waddr(waddr),
    .code_in(code_in), .at_reset(at_reset), .io_addr(io_addr), .io_write(io_write), .io_in(io_in),
    .io_out(io_out), .RM_addr(RM_addr), .RM_rw(RM_rw), .RM_in(RM_in), .RM_out(RM_out)
  );
  always begin #1 clk = 1; clocks = clocks + 1; #1 clk = 0; end
  task host(input [10:0] register, input [15:0] word);
    begin RM_addr = register; RM_in = word; RM_rw = 1; @(negedge clk) RM_rw = 0; end
  endtask
  task load(input [9:0] address, input [15:0] word);
    begin waddr = address; code_in = word; code_write = 1; @(negedge clk) code_write = 0; end
  endtask
  task io(input [9:0] address, input bit);
    begin io_addr = address; io_in = bit; io_write = 1; @(negedge clk) io_write = 0; end
  endtask
  task look(input [9:0] address);
    begin io_addr = address; @(negedge clk) $write(\"%b\", io_out); end
  endtask
  task read(input [10:0] register);
    begin RM_addr = register; @(negedge clk) $write(\" %0h\", RM_out); end
  endtask
  task scan(input [{}:0] now, input ticks);
    begin
      inputs = now; tick = ticks; halt = 0; clocks = 0;
      @(negedge clk) begin tick = 0; halt = 1; inputs = ~now; end
      while (!scan_done) @(negedge clk);
      @(negedge clk);
      $write(\"%0d %b \", clocks, outputs);
{show}      $write(\"\\n\");
    end
  endtask
  initial begin
    @(negedge clk); @(negedge clk) rst = 0;
    while (!idle) @(negedge clk);
{load}    $display(\"reset %b\", outputs);
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
    compare_by(Access::Direct, name, program, image, scans, random);
}

fn compare_by(
    access: Access,
    name: &str,
    program: &Program,
    image: &Image,
    scans: usize,
    random: Rng,
) {
    let rows = lp::rows(program, image, scans, random);
    let folder = tempfile::tempdir().unwrap();
    lp::write_image(folder.path(), image);
    fs::write(folder.path().join("bench.v"), bench(image, &rows, access)).unwrap();
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

/// A processor that comes up empty, with `halt` on, is loaded as docs/processor.md says. Behind a
/// scan the host sees what the emulator holds.
#[test]
fn a_host_loads_programs_and_reads_what_they_do() {
    if !require_tool("iverilog") {
        return;
    }
    let (program, image) = lp::smallest(DEEP, 4).unwrap();
    compare_by(Access::Bus, "deep", &program, &image, 60, Rng::with_seed(1));
    let loaded = lp::examples();
    let loaded = loaded.into_iter().filter(|(name, ..)| name.starts_with("paper_"));
    for (name, program, image, random) in loaded {
        compare_by(Access::Bus, &name, &program, &image, 10, random);
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

/// Deep lists with words, timers, counters and drums around them.
const DEEP: &str = "ladder deep tick 100ms input a, b, c, d output y, z at 260
    var lit := 1 var kept : WORD := 5 var words : WORD[3] := [1, 2, 3]
    rung [ a [ b [ c [ d a | !b ] | !c b ] | d ] | [ [ [ !d b | c ] !a | d ] c | b ] d ] (y)
    rung a t:TT(PV := 3, EN := b, MODE := ON) (z)
    rung b n:UC(PV := 2, EN := !c) (kept.3)
    rung c s:DRUM(PV := 4, EN := d, TAPS := [1, 2]) kept.2 (y)
    rung d l:SHL(REG := words, DATA := a) (S z)
    rung lit b c (R lit)";

#[test]
fn machines_of_other_sizes_run_in_lock_step() {
    if !require_tool("iverilog") {
        return;
    }
    for stack_depth in [2, 3, 7] {
        let (program, image) = lp::smallest(DEEP, stack_depth).unwrap();
        compare(&format!("stacks of {stack_depth}"), &program, &image, 100, Rng::with_seed(1));
    }
    for seed in 0..amount("HOTRAIL_RANDOM_IMAGES", 8) {
        let depth = [2, 3, 4, 5][seed as usize % 4];
        let Some((program, image)) = lp::smallest(&relay::program(seed), depth) else { continue };
        compare(&format!("seed {seed}"), &program, &image, 40, Rng::with_seed(seed));
    }
}

/// The names of modules that do not exist stand for what is wrong.
#[test]
fn sizes_that_cannot_be_built_stop_elaboration() {
    if !require_tool("iverilog") {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let elaborate = |sizes: &[&str]| {
        let parameters = sizes.iter().map(|size| format!("-Pladder_processor.{size}"));
        let mut icarus = Command::new("iverilog");
        icarus.args(["-g2005", "-o", "a", "-s", "ladder_processor"]).args(parameters);
        let output = icarus.args(modules()).current_dir(folder.path()).output().unwrap();
        String::from_utf8_lossy(&output.stderr).into_owned()
    };
    for (size, told) in [
        ("CODE_WORDS=1", "CODE_WORDS_is_2_to_1024"),
        ("CODE_WORDS=1025", "CODE_WORDS_is_2_to_1024"),
        ("IMAGE_BITS=7", "IMAGE_BITS_is_8_to_1024"),
        ("IMAGE_BITS=1025", "IMAGE_BITS_is_8_to_1024"),
        ("REGISTERS=7", "REGISTERS_is_8_to_2047"),
        ("REGISTERS=2048", "REGISTERS_is_8_to_2047"),
        ("STACK_DEPTH=1", "STACK_DEPTH_is_2_or_more"),
        ("IMAGE_BITS=32", "INPUTS_is_0_to_a_quarter_of_IMAGE_BITS"),
        ("OUTPUTS=257", "OUTPUTS_is_0_to_a_quarter_of_IMAGE_BITS"),
    ] {
        let errors = elaborate(&[size]);
        assert!(errors.contains(told), "{size}: {errors}");
    }
    let least = ["CODE_WORDS=2", "IMAGE_BITS=8", "REGISTERS=8", "STACK_DEPTH=2"];
    assert_eq!(elaborate(&[&least[..], &["INPUTS=2", "OUTPUTS=2"]].concat()), "");
    let most = ["CODE_WORDS=1024", "IMAGE_BITS=1024", "REGISTERS=2047", "STACK_DEPTH=16"];
    assert_eq!(elaborate(&[&most[..], &["INPUTS=256", "OUTPUTS=256"]].concat()), "");
}

/// How many blocks of RAM an iCE40 takes, all memories being that.
#[test]
fn memories_are_block_ram_of_their_size() {
    if !require_tool("yosys") {
        return;
    }
    for (sizes, blocks) in [
        (&[][..], 4 + 2 + 16 + 1),
        (&[("CODE_WORDS", 256), ("IMAGE_BITS", 256), ("REGISTERS", 256)], 1 + 2 + 2 + 1),
        (&[("CODE_WORDS", 300), ("REGISTERS", 512)], 2 + 2 + 4 + 1),
    ] {
        let set: String = sizes.iter().map(|(name, size)| format!(" -set {name} {size}")).collect();
        let set = match set.as_str() {
            "" => String::new(),
            set => format!("chparam{set} ladder_processor;"),
        };
        let script = format!(
            "read_verilog {}; {set} synth_ice40 -top ladder_processor -run begin:map_gates;
             select -assert-count {blocks} t:SB_RAM40_4K*; select -assert-none t:$mem*",
            names(&modules()).join(" ")
        );
        run(Path::new("."), "yosys", &["-q", "-p", &script]);
    }
}
