//! A program's tests as a self-checking testbench. It reports in TAP, the Test Anything Protocol,
//! and every failure with the values that the expectation looked at.
//!
//! A test that reads what the shipped module does not show runs on a variant of the module that
//! shows it; that variant stands in the testbench's own file, so what is shipped never depends on
//! the tests.

mod lines;
mod signals;
mod tap;

use std::collections::HashSet;

use askama::Template;
use la_arena::Arena;

use super::names::Namer;
use super::{Language, Options, PortNames, header};
use crate::circuit::{Design, Valid};
use crate::equations;
use crate::eval::variables_of;
use crate::expand::{self, Schedule};
use crate::model::{Expect, Program, Role, Statement, VariableId};
use crate::source::Source;
use lines::{Line, LineKind};
use signals::Signal;

pub use tap::outcomes;

/// Names that the templates use for themselves, also of what VHDL's packages bring.
const OWN_NAMES: [&str; 34] = [
    "bits",
    "boolean",
    "buf",
    "clk",
    "core",
    "count",
    "expectations",
    "failed",
    "failure",
    "failures",
    "from_left",
    "ieee",
    "image",
    "index",
    "integer",
    "line",
    "natural",
    "ns",
    "numeric_std",
    "output",
    "print",
    "quoted",
    "reset",
    "scan",
    "std",
    "string",
    "text",
    "textio",
    "tests",
    "times",
    "with_tick",
    "work",
    "write",
    "writeline",
];

/// The same, where a scan takes several clocks.
const OWN_NAMES_OF_SCANS: [&str; 4] = ["clock", "idle", "is_last", "pause"];

/// What follows the program's name in the name of its testbench.
pub const SUFFIX: &str = "_tb";

/// What a report of a failed expectation starts with; the number of the expectation follows.
const FAILED: &str = "# failed expectation ";

/// The name of a program's testbench.
pub fn name(program: &Program) -> String {
    format!("{}{SUFFIX}", program.name)
}

/// A design of a program and the variables that it shows beside its ports, in order.
pub struct Shown<'a> {
    /// The design.
    pub design: &'a Valid<Design>,
    /// The variables.
    pub observed: &'a [VariableId],
    /// In which clocks of a scan the rungs act.
    pub schedule: Schedule,
}

/// The text of a program's testbench.
pub fn print(
    program: &Program,
    source: &Source,
    shipped: &Shown<'_>,
    language: Language,
    options: &Options,
) -> String {
    let bench = Bench::new(program, source, shipped, language, options);
    match language {
        Language::Verilog => super::render(&Verilog { bench: &bench }, &[]),
        Language::Vhdl => super::render(&Vhdl { bench: &bench }, &[]),
    }
}

#[derive(Template)]
#[template(path = "testbench.v", escape = "none")]
struct Verilog<'a> {
    bench: &'a Bench,
}

#[derive(Template)]
#[template(path = "testbench.vhd", escape = "none")]
struct Vhdl<'a> {
    bench: &'a Bench,
}

/// Everything that the templates print.
struct Bench {
    header: String,
    name: String,
    /// The modules that only the tests need: a variant of the program, the expectations.
    modules: String,
    core: Instance,
    /// The module that computes what is expected, if a test expects anything.
    expect: Option<Instance>,
    reset_port: &'static str,
    /// The level of the reset port that resets.
    reset_on: char,
    reset_off: char,
    /// A scan takes several clocks: it is started, and tells when it is over.
    has_scans: bool,
    signals: Vec<Signal>,
    expectations: Vec<Expectation>,
    lines: Vec<Line>,
    tests: usize,
}

/// An instance in the testbench.
struct Instance {
    module: String,
    /// Port and what it is connected to.
    ports: Vec<(String, String)>,
}

/// The nets of an expectation, one for each element of its series.
struct Expectation {
    name: String,
    elements: Vec<String>,
}

/// Every expectation of the tests, in order of their numbers.
fn expectations(program: &Program) -> Vec<&Expect> {
    fn collect<'p>(statements: &'p [Statement], all: &mut Vec<&'p Expect>) {
        for statement in statements {
            match statement {
                Statement::Expect(expect) => all.push(expect),
                Statement::Repeat(_, statements) => collect(statements, all),
                Statement::Drive(..) | Statement::Scan(_) | Statement::Wait(_) => {}
                Statement::Reset => {}
            }
        }
    }
    let mut all = Vec::new();
    program.tests.iter().for_each(|test| collect(&test.statements, &mut all));
    all
}

fn is_port(program: &Program, variable: VariableId) -> bool {
    matches!(program.variables[variable].role, Role::Input | Role::Output)
}

/// A variant of the program that shows these variables beside its ports.
fn variant(
    program: &Program,
    observe: Vec<VariableId>,
    schedule: Schedule,
    options: &Options,
) -> Valid<Design> {
    let name = format!("{}_test", program.name);
    let source = options.source.clone();
    expand::compile_as(&name, program, &expand::Options { source, observe, schedule })
}

/// A design that computes every element of every expectation from the values of what they read.
fn expectation_design(program: &Program, all: &[&Expect], read: &[VariableId]) -> Valid<Design> {
    let lowered: Vec<_> =
        all.iter().map(|expect| equations::lower_expectation(program, &expect.network)).collect();
    let mut modules = Arena::new();
    modules.alloc(expand::expand_expectations(program, read, &lowered));
    let design = Design { modules };
    design.validate().unwrap_or_else(|invalid| panic!("the compiler is at fault: {invalid}"))
}

impl Bench {
    fn new(
        program: &Program,
        source: &Source,
        shipped: &Shown<'_>,
        language: Language,
        options: &Options,
    ) -> Bench {
        let all = expectations(program);
        let mut seen = HashSet::new();
        let read: Vec<VariableId> = all
            .iter()
            .flat_map(|expect| variables_of(&expect.network))
            .filter(|&variable| seen.insert(variable))
            .collect();
        let inner: Vec<VariableId> =
            read.iter().copied().filter(|&variable| !is_port(program, variable)).collect();
        let is_shown = inner.iter().all(|variable| shipped.observed.contains(variable));
        let variant =
            (!is_shown).then(|| variant(program, inner.clone(), shipped.schedule, options));
        let (core, observed) = match &variant {
            Some(variant) => (variant, inner.as_slice()),
            None => (shipped.design, shipped.observed),
        };
        let core_ports = super::port_names(core, options);

        let outer = HashSet::from([core_ports.module.to_ascii_lowercase()]);
        let has_scans = core_ports.has_scan_ports;
        let mut namer = own_names(program, &outer, has_scans, options);
        let expectations = expectation_nets(&all, &mut namer);
        let (signals, wires) = signals::signals(program, observed, &core_ports, namer, language);

        let checks = expectation_design(program, &all, &read);
        let mut modules = String::new();
        if let Some(variant) = &variant {
            modules += &without_header(super::print(variant, language, options));
        }
        if !all.is_empty() {
            modules += &without_header(super::print(&checks, language, options));
        }
        let expect = (!all.is_empty()).then(|| {
            let inputs = read.iter().map(|&variable| wires.text(variable, None));
            let nets = expectations.iter().flat_map(|expectation| &expectation.elements);
            instance(super::port_names(&checks, options), inputs.chain(nets.cloned()))
        });
        Bench {
            header: header(options).to_string(),
            name: name(program),
            modules,
            core: instance(core_ports, signals.iter().map(|signal| signal.name.clone())),
            expect,
            reset_port: options.reset.port(),
            reset_on: if options.reset.is_low() { '0' } else { '1' },
            reset_off: if options.reset.is_low() { '1' } else { '0' },
            has_scans,
            lines: lines::lines(program, source, &wires),
            signals,
            expectations,
            tests: program.tests.len(),
        }
    }
}

/// The names that a testbench has in any case; with those for scans of several clocks, if it
/// `has_scans`.
fn own_names<'n>(
    program: &Program,
    outer: &'n HashSet<String>,
    has_scans: bool,
    options: &Options,
) -> Namer<'n> {
    let mut namer = Namer::new(outer);
    let more = OWN_NAMES_OF_SCANS.iter().filter(|_| has_scans);
    for own in OWN_NAMES.iter().chain(more) {
        namer.fix(own);
    }
    namer.fix(options.reset.port());
    for counter in lines::counters(program) {
        namer.take(counter, "");
    }
    namer
}

/// An instance with clock and reset and these nets at its other ports.
fn instance(ports: PortNames, nets: impl Iterator<Item = String>) -> Instance {
    let fixed = [ports.clock, ports.reset].map(|port| (port.to_owned(), port.to_owned()));
    let named = ports.inputs.into_iter().chain(ports.outputs).map(|port| port.name);
    let named = named.zip(nets);
    Instance { module: ports.module, ports: fixed.into_iter().chain(named).collect() }
}

/// A printed design as a part of a file.
fn without_header(text: String) -> String {
    text.split_once('\n').map_or_else(String::new, |(_, rest)| rest.trim_start().to_owned() + "\n")
}

/// The nets of the expectations. They are named first, under names that are legal as they are, so
/// that a signal of the program yields.
fn expectation_nets(all: &[&Expect], namer: &mut Namer<'_>) -> Vec<Expectation> {
    let mut take = |name: String| {
        namer.take(&name, "");
        name
    };
    all.iter()
        .map(|expect| Expectation {
            name: take(format!("expect_{}", expect.index)),
            elements: (0..expect.network.len())
                .map(|element| take(format!("expect_{}_{element}", expect.index)))
                .collect(),
        })
        .collect()
}
