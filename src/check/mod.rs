//! From the tree of what was written to a program in which nothing is wrong any more.

mod amount;
mod base;
mod call;
mod declare;
mod exact;
mod expression;
mod function;
mod literal;
mod lookalike;
mod mismatch;
mod names;
mod net;
mod network;
mod number;
mod reference;
mod settings;
mod test;
mod variables;
mod write;

use std::collections::{HashMap, HashSet};

use crate::diagnostic::{Diagnostic, code};
use crate::model::{InstanceId, Program, Rung, VariableId};
use crate::source::Source;
use crate::syntax::ast::{File, Item, Name, Reserved};
pub use declare::program_name;
use names::Names;

/// Where a finding has been reported already.
struct Reported;

/// The value, or the word that something was reported.
type Checked<T> = Result<T, Reported>;

struct Checker<'s> {
    source: &'s Source,
    names: Names<'s>,
    program: Program,
    diagnostics: Vec<Diagnostic>,
    /// The variable behind `first_scan`, once somebody uses it.
    first_scan: Option<VariableId>,
    /// Number of expectations so far, over all tests.
    expectations: usize,
    /// The pulse of each unit of time that some block needs, by its length in nanoseconds.
    units: HashMap<u64, VariableId>,
    /// Instances whose settings are wrong: which members they have is not known.
    unsettled: HashSet<InstanceId>,
    /// Elements of arrays, and those that indexes choose among while the program runs.
    elements: u64,
    /// The words of the register of the call that is being declared.
    register: Vec<VariableId>,
    /// Who has which image address.
    addresses: HashMap<u16, Name<'s>>,
}

/// Checks a parsed file. The program is there if no error was found; findings are sorted by
/// place.
pub fn check(source: &Source, file: &File<'_>) -> (Option<Program>, Vec<Diagnostic>) {
    let mut checker = Checker {
        source,
        names: Names::with_capacity(file.items.len()),
        program: Program::default(),
        diagnostics: Vec::new(),
        first_scan: None,
        expectations: 0,
        units: HashMap::new(),
        unsettled: HashSet::new(),
        elements: 0,
        register: Vec::new(),
        addresses: HashMap::new(),
    };
    checker.check(file);
    let Checker { program, mut diagnostics, .. } = checker;
    diagnostics.sort_by_key(|diagnostic| diagnostic.primary.span);
    let failed = diagnostics.iter().any(Diagnostic::is_error);
    ((!failed).then_some(program), diagnostics)
}

impl Item<'_> {
    /// True for a declaration with a value.
    fn has_value(&self) -> bool {
        match self {
            Item::Constant(_) => true,
            Item::Variables(variables) => variables.names.iter().any(|one| one.initial.is_some()),
            _ => false,
        }
    }
}

impl<'s> Checker<'s> {
    fn report(&mut self, diagnostic: Diagnostic) -> Reported {
        self.diagnostics.push(diagnostic);
        Reported
    }

    /// Notes what will be declared: a value may name what stands below it.
    fn announce(&mut self, file: &File<'s>) {
        for item in &file.items {
            match item {
                Item::Variables(variables) => {
                    variables.names.iter().for_each(|one| self.names.announce(one.name, false));
                }
                Item::Constant(constant) => self.names.announce(constant.name, true),
                _ => {}
            }
        }
    }

    /// Names may be used before their declaration, so all are declared before any is looked up;
    /// the tick is known before any time is counted in it.
    fn check(&mut self, file: &File<'s>) {
        self.declare_header(file);
        self.declare_clock(file);
        if file.items.iter().any(Item::has_value) {
            self.announce(file);
        }
        for item in &file.items {
            match item {
                Item::Variables(variables) => self.declare_variables(variables),
                Item::Constant(constant) => self.declare_constant(constant),
                Item::Reserved(Reserved { word, .. }) => {
                    let message = format!("`{}` is not supported yet", word.text);
                    let diagnostic = Diagnostic::new(code::NOT_YET, word.span, message)
                        .label("reserved for a later version")
                        .help("remove it; a variable of this name would need back-ticks");
                    self.report(diagnostic);
                }
                Item::Header(_) | Item::Clock(_) | Item::Tick(_) => {}
                Item::Rung(_) | Item::Test(_) => {}
            }
        }
        for item in &file.items {
            if let Item::Rung(rung) = item {
                self.declare_instances(&rung.network);
            }
        }
        for item in &file.items {
            match item {
                Item::Rung(rung) => {
                    let network = self.rung_network(rung);
                    self.program.rungs.push(Rung {
                        title: rung.title.map(|title| title.text.to_owned()),
                        network,
                        span: rung.span,
                        line: self.source.line(rung.span.start),
                        number: self.program.rungs.len() as u32 + 1,
                    });
                }
                Item::Test(test) => self.test(test),
                _ => {}
            }
        }
    }
}
