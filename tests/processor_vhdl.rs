//! The processor's VHDL in `hdl/vhdl` is the same circuit as its Verilog, as Yosys proves, and runs
//! in GHDL in lock step with the emulator.

mod common;

use std::fmt::Write;
use std::fs;
use std::path::Path;

use common::lp::{self, Row};
use common::{amount, proof, relay, require_tool, run};
use fastrand::Rng;
use hotrail::backend::processor::Image;
use hotrail::model::Program;

fn hdl() -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("hdl")
}

/// The files in the order in which a tool wants to read them, with their texts.
fn files() -> Vec<(String, String)> {
    let folder = hdl().join("vhdl");
    let order = fs::read_to_string(folder.join("order.txt")).unwrap();
    let text = |name: &str| (name.to_owned(), fs::read_to_string(folder.join(name)).unwrap());
    order.lines().map(text).collect()
}

#[test]
fn the_order_names_every_file_of_the_edition() {
    let mut ordered: Vec<String> = files().into_iter().map(|(name, _)| name).collect();
    ordered.push("order.txt".to_owned());
    ordered.sort();
    let entries = fs::read_dir(hdl().join("vhdl")).unwrap();
    let mut present: Vec<String> =
        entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    present.sort();
    assert_eq!(ordered, present);
    let verilog: Vec<_> = fs::read_dir(hdl()).unwrap().map(|entry| entry.unwrap()).collect();
    for file in verilog.iter().map(|entry| entry.file_name().into_string().unwrap()) {
        let Some(name) = file.strip_suffix(".v") else { continue };
        assert!(ordered.contains(&format!("{name}.vhd")), "{file} has no edition in VHDL");
    }
}

/// Whether Yosys proves the editions equal, memories left open. `alter` gives each VHDL file its
/// text; parameters have their Verilog name, their VHDL name and a value.
fn equal(parameters: &[(&str, &str, u32)], alter: impl Fn(&str, String) -> String) -> bool {
    let folder = tempfile::tempdir().unwrap();
    let mut vhdl = String::new();
    for (name, text) in files() {
        let text = match name.as_str() {
            "lp_memory.vhd" => include_str!("fixture/any_memory.vhd").to_owned(),
            _ => alter(&name, text),
        };
        vhdl += &text;
    }
    fs::write(folder.path().join("edition.vhd"), vhdl).unwrap();
    let mut verilog = include_str!("fixture/any_memory.v").to_owned();
    for entry in fs::read_dir(hdl()).unwrap() {
        let path = entry.unwrap().path();
        let is_module = path.extension().is_some_and(|ending| ending == "v");
        if is_module && !path.ends_with("lp_memory.v") {
            verilog += &fs::read_to_string(path).unwrap();
        }
    }
    fs::write(folder.path().join("edition.v"), verilog).unwrap();
    proof::processors_are_equal(folder.path(), "edition.v", "edition.vhd", parameters)
}

#[test]
fn both_editions_are_proved_equal() {
    if !require_tool("yosys") || !require_tool("ghdl") {
        return;
    }
    let without = ["TIMERS", "COUNTERS", "DRUMS", "SHIFTS", "BITS"].map(|name| (name, name, 0));
    let pins =
        |inputs, outputs| [("INPUTS", "INPUT_PINS", inputs), ("OUTPUTS", "OUTPUT_PINS", outputs)];
    let sizes = |words, bits, registers| {
        let sizes = [("CODE_WORDS", words), ("IMAGE_BITS", bits), ("REGISTERS", registers)];
        sizes.map(|(name, size)| (name, name, size))
    };
    for parameters in [
        [&pins(3, 5)[..], &[("STACK_DEPTH", "STACK_DEPTH", 2)]].concat(),
        [&pins(0, 0)[..], &without].concat(),
        [&pins(2, 4)[..], &sizes(33, 16, 8), &[("STACK_DEPTH", "STACK_DEPTH", 7)]].concat(),
        [&pins(64, 1)[..], &sizes(1000, 256, 600)].concat(),
    ] {
        assert!(equal(&parameters, |_, text| text), "{parameters:?}");
    }
}

#[test]
fn a_proof_fails_where_the_editions_differ() {
    if !require_tool("yosys") || !require_tool("ghdl") {
        return;
    }
    let (file, old, new) = ("lp_power.vhd", "back <= up and conducts", "back <= up");
    let alter = |name: &str, text: String| match name == file {
        true => {
            assert!(text.contains(old), "{old}");
            text.replace(old, new)
        }
        false => text,
    };
    assert!(!equal(&[], alter), "{file}: {new}");
}

/// Drives the processor and prints what [`lp::meant`] describes; image and registers are read by
/// the host.
fn bench(image: &Image, rows: &[Row]) -> String {
    let pins = image.rom.pins;
    let [tenth, second] = lp::ticks(image);
    let [inputs, outputs] = [pins.inputs, pins.outputs].map(|count| count.max(1) - 1);
    let sizes: String =
        image.rom.sizes.named().iter().map(|(name, size)| format!("{name} => {size}, ")).collect();
    let addresses = |held: Vec<u16>| held.iter().map(u16::to_string).collect::<Vec<_>>().join(", ");
    let (bits, registers) = lp::held(image.rom.sizes);
    let mut text = BENCH
        .replace("SIZES", &sizes)
        .replace("BITS_HELD", &addresses(bits))
        .replace("REGISTERS_HELD", &addresses(registers))
        .replace("INPUT_LEFT", &inputs.to_string())
        .replace("OUTPUT_LEFT", &outputs.to_string())
        .replace("INPUT_COUNT", &pins.inputs.to_string())
        .replace("OUTPUT_COUNT", &pins.outputs.to_string())
        .replace("EACH_TENTH", &tenth.to_string())
        .replace("EACH_SECOND", &second.to_string());
    for row in rows {
        for (register, word) in &row.written {
            writeln!(text, "    host({register}, {word});").unwrap();
        }
        writeln!(text, "    scan(\"{}\", '{}');", row.digits(), u8::from(row.tick)).unwrap();
    }
    text + "    ends <= true;\n    wait;\n  end process;\nend architecture;\n"
}

const BENCH: &str = r#"library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity bench is end entity;

architecture test of bench is
  signal clk, tick, RM_rw, idle, scan_done, io_out : std_logic := '0';
  signal rst, halt : std_logic := '1';
  signal inputs    : std_logic_vector(INPUT_LEFT downto 0) := (others => '0');
  signal outputs   : std_logic_vector(OUTPUT_LEFT downto 0);
  signal io_addr   : std_logic_vector(9 downto 0) := (others => '0');
  signal RM_addr   : std_logic_vector(10 downto 0) := (others => '0');
  signal RM_in     : std_logic_vector(15 downto 0) := (others => '0');
  signal RM_out    : std_logic_vector(15 downto 0);
  signal edges     : natural := 0;
  signal ends      : boolean := false;
  type addresses is array (natural range <>) of natural;
  constant BITS      : addresses := (BITS_HELD);
  constant REGISTERS : addresses := (REGISTERS_HELD);
begin
  dut : entity work.ladder_processor
    generic map (
      INPUT_PINS => INPUT_COUNT, OUTPUT_PINS => OUTPUT_COUNT, SIZES
      TICKS_PER_TENTH => EACH_TENTH, TICKS_PER_SECOND => EACH_SECOND,
      CODE_FILE => "test.hex", REGISTER_FILE => "test_regs.hex", IMAGE_FILE => "test_image.hex"
    )
    port map (
      clk => clk, rst => rst, tick => tick, inputs => inputs, outputs => outputs, halt => halt,
      idle => idle, scan_done => scan_done, code_write => '0', waddr => "0000000000",
      code_in => x"0000", at_reset => '0', io_addr => io_addr, io_write => '0', io_in => '0',
      io_out => io_out, RM_addr => RM_addr, RM_rw => RM_rw, RM_in => RM_in, RM_out => RM_out
    );

  process
  begin
    if ends then
      wait;
    end if;
    wait for 1 ns;
    clk   <= '1';
    edges <= edges + 1;
    wait for 1 ns;
    clk <= '0';
  end process;

  process
    variable row : line;

    procedure digit(bit : std_logic) is
    begin
      if bit = '1' then
        write(row, character'('1'));
      elsif bit = '0' then
        write(row, character'('0'));
      else
        write(row, character'('x'));
      end if;
    end procedure;

    procedure pins is
    begin
      if OUTPUT_COUNT > 0 then
        for bit in outputs'range loop
          digit(outputs(bit));
        end loop;
      end if;
    end procedure;

    procedure hexadecimal(word : std_logic_vector(15 downto 0)) is
      constant DIGITS : string(1 to 16) := "0123456789abcdef";
      variable shown  : boolean := false;
      variable value  : natural;
    begin
      write(row, character'(' '));
      for place in 3 downto 0 loop
        value := to_integer(unsigned(word(4 * place + 3 downto 4 * place)));
        shown := shown or value /= 0 or place = 0;
        if shown then
          write(row, DIGITS(value + 1));
        end if;
      end loop;
    end procedure;

    procedure host(place : natural; word : natural) is
    begin
      RM_addr <= std_logic_vector(to_unsigned(place, 11));
      RM_in   <= std_logic_vector(to_unsigned(word, 16));
      RM_rw   <= '1';
      wait until falling_edge(clk);
      RM_rw <= '0';
    end procedure;

    procedure scan(now : std_logic_vector; ticks : std_logic) is
      variable start : natural;
    begin
      inputs <= now;
      tick   <= ticks;
      halt   <= '0';
      start  := edges;
      wait until falling_edge(clk);
      tick   <= '0';
      halt   <= '1';
      inputs <= not now;
      while scan_done /= '1' loop
        wait until falling_edge(clk);
      end loop;
      wait until falling_edge(clk);
      write(row, edges - start);
      write(row, character'(' '));
      pins;
      write(row, character'(' '));
      for place in BITS'range loop
        io_addr <= std_logic_vector(to_unsigned(BITS(place), 10));
        wait until falling_edge(clk);
        digit(io_out);
      end loop;
      for place in REGISTERS'range loop
        RM_addr <= std_logic_vector(to_unsigned(REGISTERS(place), 11));
        wait until falling_edge(clk);
        hexadecimal(RM_out);
      end loop;
      writeline(output, row);
    end procedure;
  begin
    wait until falling_edge(clk);
    wait until falling_edge(clk);
    rst <= '0';
    wait until falling_edge(clk);
    while idle /= '1' loop
      wait until falling_edge(clk);
    end loop;
    write(row, string'("reset "));
    pins;
    writeline(output, row);
"#;

fn compare(name: &str, program: &Program, image: &Image, scans: usize, random: Rng) {
    let rows = lp::rows(program, image, scans, random);
    let folder = tempfile::tempdir().unwrap();
    lp::write_image(folder.path(), image);
    let mut text: String = files().into_iter().map(|(_, text)| text).collect();
    text += &bench(image, &rows);
    fs::write(folder.path().join("bench.vhd"), text).unwrap();
    run(folder.path(), "ghdl", &["-a", "--std=93", "bench.vhd"]);
    // Registers hold nothing before the reset: numeric_std says so.
    let run_bench = ["-r", "--std=93", "bench", "--ieee-asserts=disable"];
    let printed = run(folder.path(), "ghdl", &run_bench);
    lp::compare(name, &printed, &lp::meant(image, &rows));
}

#[test]
fn random_programs_run_in_lock_step() {
    if !require_tool("ghdl") {
        return;
    }
    for (name, program, image, random) in
        lp::random_programs(amount("HOTRAIL_RANDOM_IMAGES", 8) / 4)
    {
        compare(&name, &program, &image, 40, random);
    }
}

#[test]
fn machines_of_other_sizes_run_in_lock_step() {
    if !require_tool("ghdl") {
        return;
    }
    for (seed, depth) in [(0, 2), (1, 6), (2, 3), (3, 5)] {
        let Some((program, image)) = lp::smallest(&relay::program(seed), depth) else { continue };
        compare(&format!("seed {seed}"), &program, &image, 40, Rng::with_seed(seed));
    }
}

#[test]
fn examples_that_the_processor_can_do_run_in_lock_step() {
    if !require_tool("ghdl") {
        return;
    }
    for (name, program, image, random) in lp::examples() {
        compare(&name, &program, &image, 30, random);
    }
}
