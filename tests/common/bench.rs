//! Runs printed text in a simulator: a row of inputs for each clock, after resets if there are any.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use hotrail::backend::hdl::{self, Language, Options, PortName, PortNames, ResetStyle};
use hotrail::circuit::Design;

use super::{require_tool, run};

/// What is run and how it is connected.
pub struct Bench {
    /// The module.
    module: String,
    /// The reset port.
    reset: &'static str,
    /// A reset needs no clock.
    is_async: bool,
    /// The rows before which it is reset.
    resets: Vec<usize>,
    inputs: Vec<PortName>,
    outputs: Vec<PortName>,
}

impl Bench {
    /// For the program itself.
    pub fn of_core(design: &Design, options: &Options) -> Bench {
        let ports = hdl::port_names(design, options);
        Bench::new(ports.module.clone(), ports, 0, options)
    }

    /// The same, reset before these rows only. Without one before the first row it starts as it is
    /// when powered up.
    pub fn reset_before(self, resets: &[usize]) -> Bench {
        Bench { resets: resets.to_vec(), ..self }
    }

    /// For the wrapper, which has no input for the tick.
    pub fn of_wrapper(design: &Design, options: &Options) -> Bench {
        let ports = hdl::port_names(design, options);
        Bench::new(ports.wrapper.clone(), ports, 1, options)
    }

    fn new(module: String, ports: PortNames, skip: usize, options: &Options) -> Bench {
        Bench {
            module,
            reset: ports.reset,
            // The wrapper brings the reset into the clock's time.
            is_async: options.reset == ResetStyle::AsyncLow && skip == 0,
            resets: vec![0],
            inputs: ports.inputs.into_iter().skip(skip).collect(),
            outputs: ports.outputs,
        }
    }

    /// The outputs before each clock, in binary, a line for each, elements of arrays by themselves;
    /// nothing if the tool is missing.
    pub fn run(
        &self,
        language: Language,
        folder: &Path,
        files: &[&str],
        rows: &[Vec<u64>],
    ) -> Option<String> {
        run_all(language, folder, files, &[(self, rows)]).map(|mut shown| shown.remove(0))
    }

    /// The inputs with the bits that a row has for them, in binary. A row has a value for each
    /// element.
    fn driven(&self, row: &[u64]) -> Vec<(&PortName, String)> {
        let mut values = row.iter();
        let bits = |port: &PortName| {
            let mut bits = String::new();
            for (high, low) in elements(port) {
                let (value, width) = (values.next().expect("a row is full"), high - low + 1);
                // The first element is lowest.
                bits.insert_str(0, &format!("{value:0width$b}", width = width as usize));
            }
            bits
        };
        let all: Vec<String> = self.inputs.iter().map(bits).collect();
        self.inputs.iter().zip(all).collect()
    }

    fn verilog(&self, number: usize, rows: &[Vec<u64>]) -> String {
        let reset = self.reset;
        let on = u32::from(reset == "rst");
        let mut text =
            format!("module bench_{number};\n  reg clk = 0;\n  reg {reset} = {};\n", 1 - on);
        let mut connections = format!(".clk(clk), .{reset}({reset})");
        for PortName { name, width, .. } in &self.inputs {
            writeln!(text, "  reg [{}:0] {name} = 0;", width - 1).expect("fits");
            write!(connections, ", .{name}({name})").expect("fits");
        }
        let mut shown = String::new();
        let mut format = String::new();
        for port in &self.outputs {
            let PortName { name, width, .. } = port;
            writeln!(text, "  wire [{}:0] {name};", width - 1).expect("fits");
            write!(connections, ", .{name}({name})").expect("fits");
            for (high, low) in elements(port) {
                format.push_str("%b ");
                write!(shown, ", {name}[{high}:{low}]").expect("fits");
            }
        }
        writeln!(text, "  {} dut ({connections});\n  initial begin", self.module).expect("fits");
        let clock = if self.is_async { "" } else { " clk = 1; #1 clk = 0;" };
        for (at, row) in rows.iter().enumerate() {
            if self.resets.contains(&at) {
                writeln!(text, "    #1 {reset} = {on}; #1{clock} {reset} = {};", 1 - on)
                    .expect("fits");
            }
            for (PortName { name, width, .. }, bits) in self.driven(row) {
                writeln!(text, "    {name} = {width}'b{bits};").expect("fits");
            }
            writeln!(text, "    #1 $display(\"{number} {format}\"{shown}); clk = 1; #1 clk = 0;")
                .expect("fits");
        }
        text + "  end\nendmodule\n"
    }

    fn vhdl(&self, number: usize, rows: &[Vec<u64>]) -> String {
        let reset = self.reset;
        let on = u32::from(reset == "rst");
        let mut text = IMAGES.replace("bench", &format!("bench_{number}"));
        let mut connections = format!("clk => clk, {reset} => {reset}");
        writeln!(text, "signal {reset} : std_logic := '{}';", 1 - on).expect("fits");
        for PortName { name, width, .. } in &self.inputs {
            let zero = literal(&"0".repeat(*width as usize));
            writeln!(text, "signal {name} : {} := {zero};", subtype(*width)).expect("fits");
            write!(connections, ", {name} => {name}").expect("fits");
        }
        let mut shown = String::new();
        for port in &self.outputs {
            let PortName { name, width, .. } = port;
            writeln!(text, "signal {name} : {};", subtype(*width)).expect("fits");
            write!(connections, ", {name} => {name}").expect("fits");
            for (high, low) in elements(port) {
                let slice =
                    if *width == 1 { String::new() } else { format!("({high} downto {low})") };
                writeln!(shown, "write(l, image({name}{slice})); write(l, ' ');").expect("fits");
            }
        }
        writeln!(text, "begin\ndut: entity work.{} port map ({connections});", self.module)
            .expect("fits");
        writeln!(text, "process\nprocedure show is variable l : line; begin\nwrite(l, string'(\"{number} \"));\n{shown}")
            .expect("fits");
        text.push_str("writeline(output, l); end procedure;\nbegin\n");
        let clock = if self.is_async { "" } else { " clk <= '1'; wait for 1 ns; clk <= '0';" };
        for (at, row) in rows.iter().enumerate() {
            if self.resets.contains(&at) {
                writeln!(text, "wait for 1 ns; {reset} <= '{on}'; wait for 1 ns;{clock}")
                    .expect("fits");
                writeln!(text, "{reset} <= '{}';", 1 - on).expect("fits");
            }
            for (PortName { name, .. }, bits) in self.driven(row) {
                writeln!(text, "{name} <= {};", literal(&bits)).expect("fits");
            }
            text.push_str("wait for 1 ns; show; clk <= '1'; wait for 1 ns; clk <= '0';\n");
        }
        text + "wait;\nend process;\nend architecture;\n"
    }
}

/// Runs several modules side by side in one run of a simulator, each with its rows of inputs: for
/// each its outputs before each clock, in binary, a line for each. Nothing if the tool is missing.
pub fn run_all(
    language: Language,
    folder: &Path,
    files: &[&str],
    benches: &[(&Bench, &[Vec<u64>])],
) -> Option<Vec<String>> {
    let numbered = benches.iter().enumerate();
    let (tool, file, text) = match language {
        Language::Verilog => {
            let texts = numbered.map(|(number, (bench, rows))| bench.verilog(number, rows));
            ("iverilog", "bench.v", texts.collect::<String>())
        }
        Language::Vhdl => {
            let texts = numbered.map(|(number, (bench, rows))| bench.vhdl(number, rows));
            let mut text: String = texts.collect();
            text.push_str(
                "entity bench is end entity;\narchitecture all_of_them of bench is begin\n",
            );
            (0..benches.len()).for_each(|number| {
                writeln!(text, "b{number}: entity work.bench_{number};").expect("fits");
            });
            ("ghdl", "bench.vhd", text + "end architecture;\n")
        }
    };
    if !require_tool(tool) {
        return None;
    }
    fs::write(folder.join(file), text).expect("can write");
    let files = [files, &[file]].concat();
    let said = match language {
        Language::Verilog => {
            let tops: Vec<String> =
                (0..benches.len()).flat_map(|n| ["-s".to_owned(), format!("bench_{n}")]).collect();
            let tops: Vec<&str> = tops.iter().map(String::as_str).collect();
            run(folder, tool, &[&["-g2005", "-o", "bench"], &tops[..], &files[..]].concat());
            run(folder, "vvp", &["bench"])
        }
        Language::Vhdl => {
            run(folder, tool, &[&["-a", "--std=93"], &files[..]].concat());
            let quiet = "--ieee-asserts=disable-at-0";
            run(folder, tool, &["-r", "--std=93", "bench", quiet])
        }
    };
    let mut shown = vec![String::new(); benches.len()];
    for line in said.lines() {
        let (number, bits) = line.split_once(' ').unwrap_or_else(|| panic!("{said}"));
        let number: usize = number.parse().unwrap_or_else(|_| panic!("{said}"));
        writeln!(shown[number], "{bits}").expect("fits");
    }
    Some(shown)
}

/// The highest and the lowest bit of each element of a port, one for a port that is no array.
fn elements(port: &PortName) -> impl Iterator<Item = (u32, u32)> + use<> {
    let count = port.elements.unwrap_or(1);
    let width = port.width / count;
    (0..count).map(move |element| (element * width + width - 1, element * width))
}

fn subtype(width: u32) -> String {
    match width {
        1 => "std_logic".to_owned(),
        _ => format!("std_logic_vector({} downto 0)", width - 1),
    }
}

fn literal(bits: &str) -> String {
    let quote = if bits.len() == 1 { '\'' } else { '"' };
    format!("{quote}{bits}{quote}")
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
