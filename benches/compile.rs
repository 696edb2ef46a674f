//! From text to Verilog, stage by stage: time, memory, and how both grow with the program.
//!
//! `cargo bench` prints a row for each size: rungs with ten contacts in nested lists each.

use std::fmt::Write;
use std::time::{Duration, Instant};

use fastrand::Rng;
use hotrail::backend::hdl;
use hotrail::diagnostic::code;
use hotrail::source::Source;
use hotrail::{check, expand, lint, syntax};

const SIZES: [usize; 3] = [25_000, 50_000, 100_000];

fn main() {
    println!(
        "{:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>12} {:>9}",
        "rungs", "parse", "check", "lint", "circuit", "Verilog", "total", "us per rung", "growth"
    );
    let mut first = None;
    for rungs in SIZES {
        let times = compile(rungs);
        let total = times.iter().sum::<Duration>();
        let per_rung = total.as_secs_f64() * 1e6 / rungs as f64;
        // 1.00 where time is linear in the number of rungs.
        let growth = per_rung / *first.get_or_insert(per_rung);
        let [parse, check, lint, circuit, verilog] = times.map(|time| time.as_millis());
        let total = total.as_millis();
        println!(
            "{rungs:>8} {parse:>5} ms {check:>5} ms {lint:>5} ms {circuit:>5} ms {verilog:>5} ms \
             {total:>5} ms {per_rung:>12.2} {growth:>9.2}"
        );
    }
    if let Some(peak) = peak_memory() {
        println!("peak memory: {peak}");
    }
}

/// Compiles a program of that many rungs and returns the time of each stage.
fn compile(rungs: usize) -> [Duration; 5] {
    let source = Source::new("bench.ladder", program(rungs));
    let mut last = Instant::now();
    let mut lap = || std::mem::replace(&mut last, Instant::now()).elapsed();
    let (file, findings) = syntax::parse(&source);
    assert!(findings.is_empty(), "{:?}", findings.first());
    let parse = lap();
    let (program, findings) = check::check(&source, &file);
    assert!(findings.is_empty(), "{:?}", findings.first());
    let program = program.expect("nothing was found");
    let check = lap();
    let notes = lint::check(&source, &file, &program, &lint::Options::default());
    let expected = [code::READ_ABOVE, code::LONG_CHAIN];
    assert!(notes.iter().all(|note| expected.contains(&note.code)), "rungs in a row, in no order");
    drop(notes);
    let lint = lap();
    drop(file);
    let check = check + lap();
    let design = hotrail::compile(&program, &expand::Options::default());
    let circuit = lap();
    let options = hdl::Options { source: "bench.ladder".to_owned(), ..Default::default() };
    let text = hdl::print(&design, hdl::Language::Verilog, &options);
    let verilog = lap();
    assert_eq!(text.matches("// rung ").count(), rungs);
    [parse, check, lint, circuit, verilog]
}

/// The largest resident size of this process so far, where the system tells.
fn peak_memory() -> Option<String> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with("VmHWM:"))?;
    let kib: f64 = line.split_whitespace().nth(1)?.parse().ok()?;
    Some(format!("{:.0} MiB", kib / 1024.0))
}

/// Rungs of ten contacts in nested lists, as an engineer's program has them: a coil is read by
/// later rungs, inputs are shared.
fn program(rungs: usize) -> String {
    let mut random = Rng::with_seed(1);
    let inputs = 256;
    let mut text = String::from("ladder bench\ninput x0");
    (1..inputs).for_each(|input| write!(text, ", x{input}").unwrap());
    writeln!(text, "\noutput y{}", rungs - 1).unwrap();
    (0..rungs - 1).for_each(|rung| writeln!(text, "var y{rung}").unwrap());
    for rung in 0..rungs {
        let mut contact = || {
            let name = match random.usize(..3) {
                0 => format!("y{}", (rung + random.usize(..40)).saturating_sub(20).min(rungs - 1)),
                _ => format!("x{}", random.usize(..inputs)),
            };
            if random.u8(..4) == 0 { format!("!{name}") } else { name }
        };
        let mut c: Vec<String> = (0..10).map(|_| contact()).collect();
        // Every rung reads the one above it, so that none is dropped.
        if rung > 0 {
            c[0] = format!("y{}", rung - 1);
        }
        writeln!(
            text,
            "rung \"station {rung}\"\n    {} [ {} {} | [ {} | {} {} ] {} ] [ {} | {} ] {} ( y{rung} )",
            c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], c[8], c[9]
        )
        .unwrap();
    }
    text
}
