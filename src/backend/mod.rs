//! From a checked program and its circuit to files.

mod circuit;
pub mod hdl;
pub mod processor;
#[cfg(feature = "cli")]
mod vcd;

use std::borrow::Cow;
use std::fmt;

use crate::circuit::{Design, Valid};
use crate::diagnostic::Diagnostic;
use crate::draw::{self, Drawing};
use crate::equations;
use crate::expand;
use crate::model::{Names, Program, Role, VariableId};
use crate::quantity;
use crate::source::Source;
use hdl::testbench::{self, Shown};
use hdl::{Board, Language, ResetStyle};
use processor::{Form, Image, Parameters, Part, Sizes};

pub use crate::expand::Schedule;
pub use circuit::CircuitRunner;
#[cfg(feature = "cli")]
pub use vcd::Vcd;

/// How every value change dump of ours starts.
const VCD_HEADER: &str = "$version\n    hotrail ";

/// True if a text starts like a file that hotrail made, whatever the version and the language: it
/// may be overwritten.
pub fn bears_header(text: &str) -> bool {
    hdl::bears_header(text) || draw::bears_header(text) || text.starts_with(VCD_HEADER)
}

/// One file, not yet written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Artifact {
    /// Its name, without folders.
    pub file_name: String,
    /// What stands in it: UTF-8 text in every kind but a binary image.
    pub contents: Vec<u8>,
}

impl Artifact {
    /// A file of text.
    pub fn of_text(file_name: String, text: String) -> Artifact {
        Artifact { file_name, contents: text.into_bytes() }
    }

    /// What stands in it, as text for people.
    pub fn text(&self) -> Cow<'_, str> {
        String::from_utf8_lossy(&self.contents)
    }
}

/// What can be made of a program. A testbench and a wrapper are made in each language that is
/// asked for beside them, or in Verilog.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Emit {
    /// The program as a Verilog-2005 module: `NAME.v`.
    Verilog,
    /// The program as a VHDL-93 entity: `NAME.vhd`.
    Vhdl,
    /// Its tests, self-checking: `NAME_tb.v`, `NAME_tb.vhd`.
    Testbench,
    /// A top around it for a board: `NAME_top.v`, `NAME_top.vhd`.
    Wrapper,
    /// The ladder as a picture: `NAME.svg`.
    Svg,
    /// The image of the ladder processor: code, registers and bits at reset, such as `NAME.hex`,
    /// `NAME_regs.hex` and `NAME_image.hex`.
    Rom(Form),
    /// The words of that image for people: `NAME.lst`.
    Listing,
}

/// How a program is built.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// What resets the registers.
    pub reset: ResetStyle,
    /// Names of variables and members to show at ports of their own.
    pub observe: Vec<String>,
    /// Frequency of the board's clock in Hz, instead of the program's own.
    pub clock_hz: Option<u64>,
    /// How many nanoseconds an input must keep its value before the wrapper lets it pass.
    pub debounce_ns: Option<u64>,
    /// In which clocks of a scan the rungs act.
    pub schedule: Schedule,
    /// What the ladder processor holds for which the image is made.
    pub processor: Sizes,
}

/// An option that does not fit the program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BadOption(pub String);

impl fmt::Display for BadOption {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for BadOption {}

/// A program with all that its back ends need.
pub struct Unit<'a> {
    program: &'a Program,
    source: &'a Source,
    design: Valid<Design>,
    observed: Vec<VariableId>,
    schedule: Schedule,
    processor: Sizes,
    print: hdl::Options,
    board: Board,
}

impl<'a> Unit<'a> {
    /// Compiles a program that was checked.
    ///
    /// # Errors
    /// If an option names what the program does not have, or does not fit its tick.
    pub fn new(
        program: &'a Program,
        source: &'a Source,
        options: &Options,
    ) -> Result<Self, BadOption> {
        let observed = observed(program, &options.observe)?;
        let board = board(program, options)?;
        scan_fits_tick(program, options.schedule, &board)?;
        let schedule = options.schedule;
        let (source_name, observe) = (source.file_name().to_owned(), observed.clone());
        let expand = expand::Options { source: source_name.clone(), observe, schedule };
        Ok(Unit {
            program,
            source,
            design: expand::compile(program, &expand),
            observed,
            schedule,
            processor: options.processor,
            print: hdl::Options { reset: options.reset, source: source_name, ..Default::default() },
            board,
        })
    }

    /// How a wrapper makes the tick, where the clock is no whole number of ticks.
    pub fn inexact_tick(&self) -> Option<String> {
        (self.board.prescaler().error_ppb != 0).then(|| self.board.tick_made())
    }

    /// The files of these kinds, each once.
    ///
    /// # Errors
    /// What the target of one of them cannot do.
    pub fn emit(&self, kinds: &[Emit]) -> Result<Vec<Artifact>, Vec<Diagnostic>> {
        let asked = |(emit, _): &(Emit, Language)| kinds.contains(emit);
        let mut languages: Vec<Language> =
            [(Emit::Verilog, Language::Verilog), (Emit::Vhdl, Language::Vhdl)]
                .into_iter()
                .filter(asked)
                .map(|(_, language)| language)
                .collect();
        let mut artifacts: Vec<Artifact> =
            languages.iter().map(|&language| self.core(language)).collect();
        if languages.is_empty() {
            languages.push(Language::Verilog);
        }
        for language in languages {
            if kinds.contains(&Emit::Testbench) {
                artifacts.push(self.testbench(language));
            }
            if kinds.contains(&Emit::Wrapper) {
                artifacts.push(self.wrapper(language));
            }
        }
        if kinds.contains(&Emit::Svg) {
            artifacts.push(drawing(&Drawing::new(self.source, &draw::Options::default())));
        }
        if kinds.iter().any(|kind| matches!(kind, Emit::Rom(_) | Emit::Listing)) {
            let image = processor::compile_for(self.program, &self.observed, self.processor)?;
            artifacts.extend(self.memories(&image, kinds));
            if kinds.contains(&Emit::Listing) {
                artifacts.push(self.listing(&image));
            }
        }
        Ok(artifacts)
    }

    /// What the memories of the ladder processor hold, in each form that is asked for.
    fn memories(&self, image: &Image, kinds: &[Emit]) -> Vec<Artifact> {
        let parameters = Parameters::of(&image.rom).to_string();
        let comments = [hdl::header(&self.print).to_string(), parameters];
        let name = &self.program.name;
        let mut artifacts = Vec::new();
        for form in Form::ALL.into_iter().filter(|form| kinds.contains(&Emit::Rom(*form))) {
            let files = Part::ALL.map(|part| Artifact {
                file_name: format!("{name}{}.{}", part.suffix(), form.extension()),
                contents: image.rom.memory(part).write(form, &comments),
            });
            if !form.has_comments() {
                artifacts.push(processor::record(name, form, &comments, &files));
            }
            artifacts.extend(files);
        }
        artifacts
    }

    fn listing(&self, image: &Image) -> Artifact {
        let text = format!(
            "// {}\n// {}\n\n{}",
            hdl::header(&self.print),
            Parameters::of(&image.rom),
            image.listing(self.program, self.source.file_name()),
        );
        Artifact::of_text(format!("{}.lst", self.program.name), text)
    }

    fn core(&self, language: Language) -> Artifact {
        let text = hdl::print(&self.design, language, &self.print);
        self.artifact("", language, text)
    }

    fn testbench(&self, language: Language) -> Artifact {
        let shipped =
            Shown { design: &self.design, observed: &self.observed, schedule: self.schedule };
        let text = testbench::print(self.program, self.source, &shipped, language, &self.print);
        self.artifact(testbench::SUFFIX, language, text)
    }

    fn wrapper(&self, language: Language) -> Artifact {
        let text = hdl::print_wrapper(&self.design, language, &self.print, &self.board);
        self.artifact("_top", language, text)
    }

    fn artifact(&self, suffix: &str, language: Language, text: String) -> Artifact {
        let file_name = format!("{}{suffix}.{}", self.program.name, language.extension());
        Artifact::of_text(file_name, text)
    }
}

/// A ladder as an SVG picture: `NAME.svg`.
pub fn drawing(drawing: &Drawing) -> Artifact {
    Artifact::of_text(format!("{}.svg", drawing.name), drawing.svg())
}

fn observed(program: &Program, names: &[String]) -> Result<Vec<VariableId>, BadOption> {
    let (known, mut observe) = (Names::of(program), Vec::new());
    for name in names {
        let variable = known.variable(name).ok_or_else(|| {
            BadOption(format!("the program has no variable or member `{name}` to observe"))
        })?;
        let is_port = matches!(program.variables[variable].role, Role::Input | Role::Output);
        if !is_port && !observe.contains(&variable) {
            observe.push(variable);
        }
    }
    Ok(observe)
}

/// Refuses a schedule in which two ticks could come within one scan: one of them would be lost.
fn scan_fits_tick(program: &Program, schedule: Schedule, board: &Board) -> Result<(), BadOption> {
    if schedule == Schedule::Flat {
        return Ok(());
    }
    let clocks = u64::from(schedule.clocks(program, &equations::lower(program)));
    let tick = board.prescaler().clocks;
    if clocks <= tick {
        return Ok(());
    }
    let plural = if tick == 1 { "" } else { "s" };
    Err(BadOption(format!(
        "a scan takes {clocks} clocks in this schedule, and from tick to tick there {} {tick} \
         clock{plural}: take a faster clock, a longer tick or another schedule",
        if tick == 1 { "is" } else { "are" }
    )))
}

fn board(program: &Program, options: &Options) -> Result<Board, BadOption> {
    let tick_ns = program.tick_ns;
    let clock_hz = options.clock_hz.unwrap_or(program.clock_hz);
    let tick = quantity::time_text(tick_ns.into());
    if u128::from(clock_hz) * u128::from(tick_ns) < 1_000_000_000 {
        return Err(BadOption(format!(
            "a clock of {clock_hz} Hz is slower than the tick of {tick}"
        )));
    }
    let debounce_ticks = match options.debounce_ns {
        None => None,
        Some(ns) => {
            let ticks = u32::try_from(ns / tick_ns).ok().filter(|&ticks| ticks > 0);
            let ticks = ticks.filter(|_| ns % tick_ns == 0).ok_or_else(|| {
                BadOption(format!("the debounce time is no whole number of ticks of {tick}"))
            })?;
            Some(ticks)
        }
    };
    Ok(Board { clock_hz, tick_ns, debounce_ticks })
}
