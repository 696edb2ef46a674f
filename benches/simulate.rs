//! Scans a second: our simulations of a circuit beside Verilator, on the Verilog that we print.
//!
//! `cargo bench --bench simulate` prints a row for each size and simulation: rungs with ten
//! contacts in nested lists each. Verilator's row is there where it is installed. The rows of
//! `hotrail sim` are whole runs of the program, reading the stimulus and printing one output of
//! each scan included.

use std::fmt::Write;
use std::fs;
use std::hint::black_box;
use std::path::Path;
use std::process::Command;
use std::time::{Duration, Instant};

use fastrand::Rng;
use hotrail::backend::hdl;
use hotrail::circuit::{Design, FastSimulator, LANES, LaneSimulator, Simulator, Valid};
use hotrail::eval::{Evaluator, Machine};
use hotrail::expand;
use hotrail::model::{Program, Role, VariableId};
use hotrail::source::Source;

const SIZES: [usize; 2] = [100, 1_000];
const INPUTS: usize = 64;
/// How long each simulation runs at least.
const TIME: Duration = Duration::from_millis(1000);
/// Inputs are driven from a table that is used again and again.
const ROWS: usize = 64;

fn main() {
    println!("{:>6}  {:<22} {:>14} {:>20}", "rungs", "simulation", "scans/s", "rung evaluations/s");
    for rungs in SIZES {
        let text = program(rungs);
        let source = Source::new("bench.ladder", text.as_str());
        let program = hotrail::analyze(&source).0.expect("the program is good");
        let design = hotrail::compile(&program, &expand::Options::default());
        let mut random = Rng::with_seed(7);
        let rows: Vec<Vec<u64>> =
            (0..ROWS).map(|_| (0..=INPUTS).map(|_| random.u64(..)).collect()).collect();
        let show = |name: &str, scans: f64| {
            println!("{rungs:>6}  {name:<22} {scans:>14.0} {:>18.3} G", scans * rungs as f64 / 1e9);
        };
        show("evaluator", evaluator(&program, &rows));
        show("plain", plain(&design, &rows));
        show("fast", fast(&design, &rows));
        show("fast, 64 lanes", lanes(&design, &rows));
        for on in ["evaluator", "circuit"] {
            show(&format!("sim --on {on}"), sim(&text, on, 40_000_000 / rungs));
        }
        match verilator(&design, rungs) {
            Some(scans) => show("Verilator -O3", scans),
            None => println!("{rungs:>6}  Verilator is missing"),
        }
    }
}

/// Runs a table of inputs until the time is over; returns the scans in a second.
fn measure(scans: f64, mut run_table: impl FnMut()) -> f64 {
    let started = Instant::now();
    let mut tables = 0.0;
    while started.elapsed() < TIME {
        run_table();
        tables += 1.0;
    }
    tables * scans / started.elapsed().as_secs_f64()
}

fn evaluator(program: &Program, rows: &[Vec<u64>]) -> f64 {
    let inputs: Vec<VariableId> = program.with_role(Role::Input).map(|(id, _)| id).collect();
    let mut evaluator = Evaluator::new(program);
    measure(ROWS as f64, || {
        for row in rows {
            inputs.iter().zip(row).for_each(|(&id, bits)| evaluator.drive(id, (bits & 1) as i64));
            Machine::scan(&mut evaluator, true);
        }
    })
}

fn plain(design: &Valid<Design>, rows: &[Vec<u64>]) -> f64 {
    let mut simulator = Simulator::new(design);
    measure(ROWS as f64, || {
        for row in rows {
            simulator.settle(row);
            simulator.clock();
        }
        black_box(simulator.output(0));
    })
}

fn fast(design: &Valid<Design>, rows: &[Vec<u64>]) -> f64 {
    let mut simulator = FastSimulator::new(design);
    measure(ROWS as f64, || {
        for row in rows {
            simulator.settle(row);
            simulator.clock();
        }
        black_box(simulator.output(0));
    })
}

fn lanes(design: &Valid<Design>, rows: &[Vec<u64>]) -> f64 {
    let mut simulator = LaneSimulator::new(design);
    measure((ROWS * LANES) as f64, || {
        for row in rows {
            row.iter().enumerate().for_each(|(port, &bits)| simulator.drive(port, 0, bits));
            simulator.settle();
            simulator.clock();
        }
        black_box(simulator.output_bit(0, 0));
    })
}

/// Runs `hotrail sim` on a stimulus of that many rows.
fn sim(program: &str, on: &str, scans: usize) -> f64 {
    let folder = tempfile::tempdir().expect("there is room for temporary files");
    let inputs: Vec<String> = (0..INPUTS).map(|input| format!("x{input}")).collect();
    let mut stimulus = inputs.join(",") + "\n";
    let mut random = Rng::with_seed(7);
    for _ in 0..scans {
        let cells: Vec<&str> = (0..INPUTS).map(|_| if random.bool() { "1" } else { "0" }).collect();
        stimulus += &(cells.join(",") + "\n");
    }
    fs::write(folder.path().join("bench.ladder"), program).unwrap();
    fs::write(folder.path().join("s.csv"), stimulus).unwrap();
    let arguments = ["sim", "bench.ladder", "s.csv", "--watch", "y0", "--on", on];
    let started = Instant::now();
    call(folder.path(), env!("CARGO_BIN_EXE_hotrail"), &arguments);
    scans as f64 / started.elapsed().as_secs_f64()
}

/// Builds the printed Verilog with Verilator and lets it run; nothing if it is not installed.
fn verilator(design: &Valid<Design>, rungs: usize) -> Option<f64> {
    Command::new("verilator").arg("--version").output().ok()?;
    let folder = tempfile::tempdir().expect("there is room for temporary files");
    let verilog = hdl::print(design, hdl::Language::Verilog, &hdl::Options::default());
    fs::write(folder.path().join("bench.v"), verilog).unwrap();
    fs::write(folder.path().join("main.cpp"), main_cpp()).unwrap();
    let flags = ["--cc", "--exe", "--build", "-O3", "--x-assign", "fast", "--x-initial", "fast"];
    let rest = ["-Wno-fatal", "-CFLAGS", "-O3 -march=native", "bench.v", "main.cpp"];
    call(folder.path(), "verilator", &[&flags[..], &rest[..]].concat());
    let scans = (200_000_000 / rungs).to_string();
    let seconds = call(folder.path(), "./obj_dir/Vbench", &[&scans]);
    Some(scans.parse::<f64>().unwrap() / seconds.trim().parse::<f64>().unwrap())
}

fn call(folder: &Path, tool: &str, arguments: &[&str]) -> String {
    let output = Command::new(tool).args(arguments).current_dir(folder).output().unwrap();
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{tool}: {text}{errors}");
    text
}

/// Drives every input from a table, clocks, and prints how many seconds that took.
fn main_cpp() -> String {
    let drive: String =
        (0..INPUTS).map(|input| format!("    top.x{input} = row >> {input} & 1;\n")).collect();
    format!(
        r#"#include "Vbench.h"
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
int main(int, char** arguments) {{
  long scans = atol(arguments[1]);
  static uint64_t rows[{ROWS}];
  uint64_t state = 88172645463325252ull;
  for (auto& row : rows) {{
    state ^= state << 13; state ^= state >> 7; state ^= state << 17;
    row = state;
  }}
  Vbench top;
  top.tick = 1; top.rst = 1; top.clk = 0; top.eval(); top.clk = 1; top.eval(); top.rst = 0;
  auto start = std::chrono::steady_clock::now();
  for (long scan = 0; scan < scans; scan++) {{
    uint64_t row = rows[scan % {ROWS}];
{drive}    top.clk = 0; top.eval();
    top.clk = 1; top.eval();
  }}
  std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  printf("%f\n", took.count());
}}
"#
    )
}

/// Rungs of ten contacts in nested lists that read inputs and coils of rungs nearby.
fn program(rungs: usize) -> String {
    let mut random = Rng::with_seed(1);
    let mut text = String::from("ladder bench\n");
    (0..INPUTS).for_each(|input| writeln!(text, "input x{input}").unwrap());
    (0..rungs).for_each(|rung| writeln!(text, "output y{rung}").unwrap());
    for rung in 0..rungs {
        let mut contact = || {
            let name = match random.usize(..3) {
                0 => format!("y{}", (rung + random.usize(..40)).saturating_sub(20).min(rungs - 1)),
                _ => format!("x{}", random.usize(..INPUTS)),
            };
            if random.u8(..4) == 0 { format!("!{name}") } else { name }
        };
        let c: Vec<String> = (0..10).map(|_| contact()).collect();
        writeln!(
            text,
            "rung {} [ {} {} | [ {} | {} {} ] {} ] [ {} | {} ] {} ( y{rung} )",
            c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], c[8], c[9]
        )
        .unwrap();
    }
    text
}
