//! Runs a program's tests in an HDL simulator that the user has installed.

use std::fs;
use std::path::Path;
use std::process::Command;

use anyhow::{Context, bail};

use hotrail::backend::hdl::testbench;
use hotrail::backend::{self, Emit, Schedule, Unit};
use hotrail::eval::Outcome;
use hotrail::model::Program;
use hotrail::source::Source;

/// An HDL simulator.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Simulator {
    /// Icarus Verilog.
    Icarus,
    /// GHDL.
    Ghdl,
}

/// Emits core and testbench into a folder of their own, runs them and reads the verdicts.
pub fn run_tests(
    simulator: Simulator,
    schedule: Schedule,
    program: &Program,
    source: &Source,
) -> anyhow::Result<Vec<Outcome>> {
    if program.tests.is_empty() {
        return Ok(Vec::new());
    }
    let folder = tempfile::tempdir().context("cannot make a temporary folder")?;
    let options = backend::Options { schedule, ..backend::Options::default() };
    let unit = Unit::new(program, source, &options)?;
    let core = match simulator {
        Simulator::Icarus => Emit::Verilog,
        Simulator::Ghdl => Emit::Vhdl,
    };
    let mut files = Vec::new();
    let made = unit.emit(&[core, Emit::Testbench]).expect("the languages can do every program");
    for artifact in made {
        fs::write(folder.path().join(&artifact.file_name), &artifact.contents)?;
        files.push(artifact.file_name);
    }
    let bench = testbench::name(program);
    let output = match simulator {
        Simulator::Icarus => icarus(folder.path(), &files, &bench)?,
        Simulator::Ghdl => ghdl(folder.path(), &files, &bench)?,
    };
    testbench::outcomes(program, &output)
        .with_context(|| format!("the simulator did not finish the tests:\n{output}"))
}

fn icarus(folder: &Path, files: &[String], bench: &str) -> anyhow::Result<String> {
    let compile = ["-g2005", "-Wall", "-s", bench, "-o", "tests.vvp"];
    call(folder, "iverilog", compile.iter().copied().chain(files.iter().map(String::as_str)))?;
    call(folder, "vvp", ["-n", "tests.vvp"].into_iter())
}

fn ghdl(folder: &Path, files: &[String], bench: &str) -> anyhow::Result<String> {
    let analyze = ["-a", "--std=93"].into_iter().chain(files.iter().map(String::as_str));
    call(folder, "ghdl", analyze)?;
    call(folder, "ghdl", ["-e", "--std=93", bench].into_iter())?;
    // The testbench ends with a failure if a test failed: its verdicts tell which.
    let run = Command::new("ghdl").args(["-r", "--std=93", bench]).current_dir(folder).output();
    let run = run.context("cannot run ghdl")?;
    Ok(String::from_utf8_lossy(&run.stdout).into_owned() + &String::from_utf8_lossy(&run.stderr))
}

/// Runs a tool to its end; what it prints counts only if it succeeds.
fn call<'a>(
    folder: &Path,
    tool: &str,
    arguments: impl Iterator<Item = &'a str>,
) -> anyhow::Result<String> {
    let output = Command::new(tool)
        .args(arguments)
        .current_dir(folder)
        .output()
        .with_context(|| format!("cannot run {tool}: is it installed?"))?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned()
        + &String::from_utf8_lossy(&output.stderr);
    if !output.status.success() {
        bail!("{tool} failed:\n{text}");
    }
    Ok(text)
}
