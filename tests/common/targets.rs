//! What has to hold for every input whatever, for the short fuzzing of `cargo test` and the long
//! one of `cargo fuzz`. All of it panics where it does not hold.

use fastrand::Rng;
use hotrail::backend::hdl::{self, Language};
use hotrail::backend::processor::{self, Form, Machine, Parameters, Part, Rom, Symbols};
use hotrail::diagnostic::{self, Diagnostic};
use hotrail::draw::{self, Drawing};
use hotrail::eval::Stimulus;
use hotrail::expand;
use hotrail::source::Source;
use hotrail::syntax;

use super::lockstep;

/// Reads a text and, if it is a program, makes all of it that there is.
pub fn program(text: &str) {
    let source = Source::new("fuzz.ladder", text);
    let (program, findings) = hotrail::analyze(&source);
    assert_eq!(program.is_none(), findings.iter().any(Diagnostic::is_error), "{text}");
    render(&source, &findings);
    format(&source);
    let Some(program) = program else { return };
    Drawing::new(&source, &draw::Options::default());
    let design = hotrail::compile(&program, &expand::Options::default());
    for language in [Language::Verilog, Language::Vhdl] {
        hdl::print(&design, language, &hdl::Options::default());
    }
    if let Err(findings) = processor::compile(&program) {
        render(&source, &findings);
    }
    let wrong = lockstep::difference(&program, 10, Rng::with_seed(1));
    assert_eq!(wrong, None, "{text}");
}

/// A layout is one that stays as it is, and of the same program.
fn format(source: &Source) {
    let Ok(formatted) = syntax::format(source) else { return };
    let again = Source::new("fuzz.ladder", &*formatted);
    let twice = syntax::format(&again).unwrap_or_else(|_| panic!("{}", source.text()));
    assert_eq!(formatted, twice, "{}", source.text());
}

fn render(source: &Source, findings: &[Diagnostic]) {
    for finding in findings {
        assert!(!diagnostic::render(finding, source, false).is_empty());
        assert!(!diagnostic::render_json(finding, source).is_empty());
        assert!(finding.primary.span.range().end <= source.text().len());
    }
}

/// Reads bytes as an image in every form, and runs what can be run.
pub fn image(bytes: &[u8]) {
    let text = String::from_utf8_lossy(bytes);
    let Ok(parameters) = Parameters::read(&text) else { return };
    let sizes = parameters.sizes;
    for form in Form::ALL {
        for part in Part::ALL {
            let Ok(memory) = part.read(form, bytes, sizes) else { continue };
            let none = Rom { sizes, ..Rom::default() };
            let [code, registers, bits] = Part::ALL.map(|part| none.memory(part));
            run(&match part {
                Part::Code => Rom::of_memories(&memory, &registers, &bits, &parameters),
                Part::Registers => Rom::of_memories(&code, &memory, &bits, &parameters),
                Part::Bits => Rom::of_memories(&code, &registers, &memory, &parameters),
            });
        }
    }
}

fn run(rom: &Rom) {
    let Ok(mut machine) = Machine::new(rom) else {
        assert!(!rom.faults().is_empty());
        return;
    };
    let none = |_| None;
    let needs = rom.needs();
    let symbols = Symbols { bit: &none, register: &none, needs, heading: &|_| None };
    processor::listing(rom, &symbols);
    (0..5).for_each(|scan| machine.scan(scan % 2 == 0));
    if let Ok(ladder) = processor::ladder(rom, "fuzz") {
        let (program, findings) = hotrail::analyze(&Source::new("fuzz.ladder", &*ladder));
        assert!(program.is_some(), "{ladder}{findings:?}");
    }
}

/// Reads a text as a stimulus.
pub fn stimulus(text: &str) {
    let program = Source::new(
        "fuzz.ladder",
        "ladder fuzz input a, `b c` input n : INT input d : UDINT input t : TIME
         input w : WORD[3] output y rung a (y)",
    );
    let (program, _) = hotrail::analyze(&program);
    let program = program.expect("it is sound");
    let source = Source::new("fuzz.csv", text);
    match Stimulus::parse(&program, &source) {
        Ok(stimulus) => {
            (0..stimulus.len()).for_each(|scan| assert!(stimulus.row(scan).drives.len() <= 8))
        }
        Err(findings) => render(&source, &findings),
    }
}
