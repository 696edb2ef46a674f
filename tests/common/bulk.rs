//! Many programs in one run of a simulator.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use fastrand::Rng;
use hotrail::backend::hdl::{self, Language, Options, ResetStyle};
use hotrail::circuit::{Design, Valid};
use hotrail::eval::Evaluator;
use hotrail::expand;
use hotrail::model::{Names, Program, Role, VariableId};

use super::bench::{self, Bench};
use super::dice::Dice;
use super::lockstep::inner_variables;
use super::{analyze, kept_paths};

const RESETS: [ResetStyle; 3] = [ResetStyle::SyncHigh, ResetStyle::SyncLow, ResetStyle::AsyncLow];

/// A program as hardware, what drives it and what it has to show.
struct Subject {
    design: Valid<Design>,
    options: Options,
    rows: Vec<Vec<u64>>,
    /// The rows before which it is reset.
    resets: Vec<usize>,
    meant: String,
}

/// Runs programs, each on the inputs and ticks of a seed, for that many scans in the simulator of a
/// language, all that has a name shown: for each what is wrong. In the middle there is a reset, at the
/// start only if the seed is even. Nothing if the tool is missing.
///
/// # Panics
/// If the tool refuses one of them.
pub fn simulate(
    language: Language,
    programs: &[(u64, String)],
    scans: usize,
) -> Option<Vec<Option<String>>> {
    let subjects: Vec<Subject> =
        programs.iter().map(|(seed, text)| subject(*seed, text, scans)).collect();
    let folder = tempfile::tempdir().expect("can make a folder");
    let ending = if language == Language::Verilog { "v" } else { "vhd" };
    let files: Vec<String> =
        (0..programs.len()).map(|number| format!("program_{number}.{ending}")).collect();
    for (subject, file) in subjects.iter().zip(&files) {
        write(&folder.path().join(file), subject, language);
    }
    let files: Vec<&str> = files.iter().map(String::as_str).collect();
    let bench = |subject: &Subject| {
        Bench::of_core(&subject.design, &subject.options).reset_before(&subject.resets)
    };
    let benches: Vec<Bench> = subjects.iter().map(bench).collect();
    let driven: Vec<(&Bench, &[Vec<u64>])> =
        benches.iter().zip(&subjects).map(|(bench, subject)| (bench, &subject.rows[..])).collect();
    let shown = bench::run_all(language, folder.path(), &files, &driven)?;
    let compare = |(subject, shown): (&Subject, &String)| first_difference(&subject.meant, shown);
    Some(subjects.iter().zip(&shown).map(compare).collect())
}

/// Runs the kept programs in the simulator of a language, if it is there.
///
/// # Panics
/// If one of them is wrong.
pub fn hold_kept_programs(language: Language) {
    let paths = kept_paths();
    let programs: Vec<(u64, String)> =
        (0..).zip(&paths).map(|(seed, path)| (seed, fs::read_to_string(path).unwrap())).collect();
    let Some(found) = simulate(language, &programs, 200) else { return };
    for (path, wrong) in paths.iter().zip(found) {
        assert_eq!(wrong, None, "{}", path.display());
    }
}

fn write(path: &Path, subject: &Subject, language: Language) {
    fs::write(path, hdl::print(&subject.design, language, &subject.options)).expect("can write");
}

fn first_difference(meant: &str, shown: &str) -> Option<String> {
    let lines = meant.lines().zip(shown.lines()).enumerate();
    let wrong = lines.into_iter().find(|(_, (meant, shown))| meant != shown);
    match wrong {
        Some((scan, (meant, shown))) => Some(format!("after {scan} scans {shown}, meant {meant}")),
        None if meant.lines().count() != shown.lines().count() => Some("lines are missing".into()),
        None => None,
    }
}

fn subject(seed: u64, text: &str, scans: usize) -> Subject {
    let program = analyze("random.ladder", text).unwrap_or_else(|findings| panic!("{findings}"));
    let options =
        expand::Options { observe: inner_variables(&program), ..expand::Options::default() };
    let design = hotrail::compile(&program, &options);
    let names = Names::of(&program);
    let outputs: Vec<VariableId> = design
        .top()
        .outputs
        .iter()
        .map(|output| names.variable(&output.name).expect("ports bear user's names"))
        .collect();
    let mut random = Rng::with_seed(seed);
    let mut evaluator = Evaluator::new(&program);
    let (mut rows, mut meant) = (Vec::new(), String::new());
    let resets = [&[0][(seed % 2) as usize..], &[scans / 2]].concat();
    for scan in 0..=scans {
        if resets.contains(&scan) {
            evaluator = Evaluator::new(&program);
        }
        // Outputs are registers: before the clock they show the scan before.
        for &output in &outputs {
            let ty = program.variables[output].ty;
            let width = ty.width() as usize;
            write!(meant, "{:0width$b} ", ty.bits(evaluator.value(output))).expect("fits");
        }
        meant.push('\n');
        rows.push(drive(&program, &mut evaluator, &mut random));
    }
    let reset = RESETS[(seed % 3) as usize];
    Subject { design, options: Options { reset, ..Options::default() }, rows, resets, meant }
}

/// Drives some inputs at random and runs a scan; the values of the hardware's ports.
fn drive(program: &Program, evaluator: &mut Evaluator<'_>, random: &mut Rng) -> Vec<u64> {
    let tick = random.bool();
    let mut row = vec![u64::from(tick)];
    for (input, variable) in program.with_role(Role::Input) {
        if random.u8(..3) == 0 {
            evaluator.drive(input, random.value(variable.ty));
        }
        row.push(variable.ty.bits(evaluator.value(input)));
    }
    evaluator.scan(tick);
    row
}
