//! Runs printed text in a simulator: one reset, then a row of inputs for each clock.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use hotrail::backend::hdl::{self, Language, Options, PortName, PortNames};
use hotrail::circuit::Design;

use super::{require_tool, run};

/// What is run and how it is connected.
pub struct Bench {
    /// The module.
    module: String,
    /// The reset port.
    reset: &'static str,
    /// Names and widths.
    inputs: Vec<(String, u32)>,
    /// Names and widths.
    outputs: Vec<(String, u32)>,
}

impl Bench {
    /// For the program itself.
    pub fn of_core(design: &Design, options: &Options) -> Bench {
        let ports = hdl::port_names(design, options);
        Bench::new(ports.module.clone(), ports, 0)
    }

    /// For the wrapper, which has no input for the tick.
    pub fn of_wrapper(design: &Design, options: &Options) -> Bench {
        let ports = hdl::port_names(design, options);
        Bench::new(ports.wrapper.clone(), ports, 1)
    }

    fn new(module: String, ports: PortNames, skip: usize) -> Bench {
        let named = |ports: Vec<PortName>| ports.into_iter().map(|port| (port.name, port.width));
        Bench {
            module,
            reset: ports.reset,
            inputs: named(ports.inputs).skip(skip).collect(),
            outputs: named(ports.outputs).collect(),
        }
    }

    /// The outputs before each clock, in binary, a line for each; nothing if the tool is missing.
    pub fn run(
        &self,
        language: Language,
        folder: &Path,
        files: &[&str],
        rows: &[Vec<u64>],
    ) -> Option<String> {
        let (tool, file, text) = match language {
            Language::Verilog => ("iverilog", "bench.v", self.verilog(rows)),
            Language::Vhdl => ("ghdl", "bench.vhd", self.vhdl(rows)),
        };
        if !require_tool(tool) {
            return None;
        }
        fs::write(folder.join(file), text).expect("can write");
        let files = [files, &[file]].concat();
        Some(match language {
            Language::Verilog => {
                run(folder, tool, &[&["-g2005", "-o", "bench"], &files[..]].concat());
                run(folder, "vvp", &["bench"])
            }
            Language::Vhdl => {
                run(folder, tool, &[&["-a", "--std=93"], &files[..]].concat());
                let quiet = "--ieee-asserts=disable-at-0";
                run(folder, tool, &["-r", "--std=93", "bench", quiet])
            }
        })
    }

    fn verilog(&self, rows: &[Vec<u64>]) -> String {
        let reset = self.reset;
        let on = u32::from(reset == "rst");
        let mut text = format!("module bench;\n  reg clk = 0;\n  reg {reset} = {on};\n");
        let mut connections = format!(".clk(clk), .{reset}({reset})");
        for (name, width) in &self.inputs {
            writeln!(text, "  reg [{}:0] {name} = 0;", width - 1).expect("fits");
            write!(connections, ", .{name}({name})").expect("fits");
        }
        let mut shown = String::new();
        for (name, width) in &self.outputs {
            writeln!(text, "  wire [{}:0] {name};", width - 1).expect("fits");
            write!(connections, ", .{name}({name})").expect("fits");
            write!(shown, ", {name}").expect("fits");
        }
        writeln!(text, "  {} dut ({connections});\n  initial begin", self.module).expect("fits");
        writeln!(text, "    #1 clk = 1; #1 clk = 0; {reset} = {};", 1 - on).expect("fits");
        let format = "%b ".repeat(self.outputs.len());
        for row in rows {
            for (value, (name, width)) in row.iter().zip(&self.inputs) {
                writeln!(text, "    {name} = {width}'h{value:x};").expect("fits");
            }
            writeln!(text, "    #1 $display(\"{format}\"{shown}); clk = 1; #1 clk = 0;")
                .expect("fits");
        }
        text + "  end\nendmodule\n"
    }

    fn vhdl(&self, rows: &[Vec<u64>]) -> String {
        let reset = self.reset;
        let on = u32::from(reset == "rst");
        let mut text = String::from(IMAGES);
        let mut connections = format!("clk => clk, {reset} => {reset}");
        writeln!(text, "signal {reset} : std_logic := '{on}';").expect("fits");
        for (name, width) in &self.inputs {
            let zero = literal(0, *width);
            writeln!(text, "signal {name} : {} := {zero};", subtype(*width)).expect("fits");
            write!(connections, ", {name} => {name}").expect("fits");
        }
        let mut shown = String::new();
        for (name, width) in &self.outputs {
            writeln!(text, "signal {name} : {};", subtype(*width)).expect("fits");
            write!(connections, ", {name} => {name}").expect("fits");
            writeln!(shown, "write(l, image({name})); write(l, ' ');").expect("fits");
        }
        writeln!(text, "begin\ndut: entity work.{} port map ({connections});", self.module)
            .expect("fits");
        writeln!(text, "process\nprocedure show is variable l : line; begin\n{shown}")
            .expect("fits");
        text.push_str("writeline(output, l); end procedure;\nbegin\n");
        text.push_str("wait for 1 ns; clk <= '1'; wait for 1 ns; clk <= '0';\n");
        writeln!(text, "{reset} <= '{}';", 1 - on).expect("fits");
        for row in rows {
            for (&value, (name, width)) in row.iter().zip(&self.inputs) {
                writeln!(text, "{name} <= {};", literal(value, *width)).expect("fits");
            }
            text.push_str("wait for 1 ns; show; clk <= '1'; wait for 1 ns; clk <= '0';\n");
        }
        text + "wait;\nend process;\nend architecture;\n"
    }
}

fn subtype(width: u32) -> String {
    match width {
        1 => "std_logic".to_owned(),
        _ => format!("std_logic_vector({} downto 0)", width - 1),
    }
}

fn literal(value: u64, width: u32) -> String {
    let digits = width as usize;
    if width == 1 { format!("'{value}'") } else { format!("\"{value:0digits$b}\"") }
}

const IMAGES: &str = "\
library ieee;
use ieee.std_logic_1164.all;
use std.textio.all;
entity bench is end entity;
architecture test of bench is
function image(v : std_logic_vector) return string is
  variable t : string(1 to v'length);
  variable k : integer := 1;
begin
  for i in v'range loop t(k) := std_logic'image(v(i))(2); k := k + 1; end loop;
  return t;
end function;
function image(v : std_logic) return string is
begin
  return std_logic'image(v)(2 to 2);
end function;
signal clk : std_logic := '0';
";
