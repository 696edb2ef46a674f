//! Yosys proves two descriptions of hardware to be equal, state by state.

use std::fmt::Write;
use std::fs;
use std::path::Path;
use std::process::Command;

use super::run;

/// Panics unless a module in Verilog and the entity of that name in VHDL are proved equal.
pub fn both_editions_are_equal(folder: &Path, name: &str, verilog: &str, vhdl: &str) {
    read_back(folder, name, verilog, vhdl);
    let script = script(name);
    run(folder, "yosys", &["-q", "-p", &script]);
}

/// True if the same proof fails.
pub fn both_editions_differ(folder: &Path, name: &str, verilog: &str, vhdl: &str) -> bool {
    read_back(folder, name, verilog, vhdl);
    let mut yosys = Command::new("yosys");
    let output = yosys.args(["-q", "-p", &script(name)]).current_dir(folder).output().unwrap();
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    !output.status.success() && text.contains("unproven $equiv")
}

/// Writes GHDL's reading of the VHDL as Verilog, and both in lower case: GHDL does so with some
/// names, and Yosys pairs registers by name.
fn read_back(folder: &Path, name: &str, verilog: &str, vhdl: &str) {
    run(folder, "ghdl", &["-a", "--std=93", vhdl]);
    let read = run(folder, "ghdl", &["--synth", "--std=93", "--out=verilog", name]);
    fs::write(folder.join("gate.v"), repair_vectors(&read).to_lowercase()).unwrap();
    let verilog = fs::read_to_string(folder.join(verilog)).unwrap();
    fs::write(folder.join("gold.v"), verilog.to_lowercase()).unwrap();
}

/// GHDL 2 writes vectors as strings when it writes Verilog, and those mean letters there.
fn repair_vectors(text: &str) -> String {
    let mut repaired = String::new();
    for (place, part) in text.split('"').enumerate() {
        match place % 2 {
            0 => repaired.push_str(part),
            _ => write!(repaired, "{}'b{part}", part.len()).unwrap(),
        }
    }
    repaired
}

fn script(name: &str) -> String {
    let top = name.to_lowercase();
    format!(
        "read_verilog gold.v; prep -flatten -top {top}; design -stash gold;
         read_verilog gate.v; prep -flatten -top {top}; design -stash gate;
         design -copy-from gold -as gold {top}; design -copy-from gate -as gate {top};
         equiv_make gold gate both; prep -top both;
         equiv_simple; equiv_induct; equiv_status -assert"
    )
}

/// True if Yosys proves both editions of the ladder processor equal. Parameters have a Verilog
/// name, a VHDL name and a value.
///
/// # Panics
/// If one of them cannot be read.
pub fn processors_are_equal(
    folder: &Path,
    verilog: &str,
    vhdl: &str,
    parameters: &[(&str, &str, u32)],
) -> bool {
    run(folder, "ghdl", &["-a", "--std=93", vhdl]);
    let generics: Vec<String> =
        parameters.iter().map(|(_, name, value)| format!("-g{name}={value}")).collect();
    let mut synth = vec!["--synth", "--std=93", "--out=verilog"];
    synth.extend(generics.iter().map(String::as_str));
    synth.push("ladder_processor");
    let read = run(folder, "ghdl", &synth);
    let read = read.split_once("module ").expect("notes come first").1;
    let mut gate = format!("module {}", repair_vectors(read).to_lowercase());
    // The editions name what stands in a generate block in their own ways.
    for name in [
        "functions.function_unit",
        "functions.register_array",
        "functions.waiting",
        "timing.pulses",
    ] {
        for end in [" ", ";", ")", ","] {
            let flat = format!(" {}{end}", name.replace('.', "_"));
            gate = gate.replace(&flat, &format!(" \\{name} {end}"));
        }
    }
    fs::write(folder.join("gate.v"), gate).unwrap();
    let verilog = fs::read_to_string(folder.join(verilog)).unwrap();
    fs::write(folder.join("gold.v"), verilog.replace("RM_", "rm_")).unwrap();
    let set: String =
        parameters.iter().map(|(name, _, value)| format!(" -set {name} {value}")).collect();
    let script = script("ladder_processor").replace(
        "read_verilog gold.v;",
        &match set.as_str() {
            "" => "read_verilog gold.v;".to_owned(),
            set => format!("read_verilog gold.v; chparam{set} ladder_processor;"),
        },
    );
    let mut yosys = Command::new("yosys");
    let output = yosys.args(["-q", "-p", &script]).current_dir(folder).output().unwrap();
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    let unproven = text.contains("unproven $equiv");
    assert!(output.status.success() || unproven, "{text}");
    !unproven
}
