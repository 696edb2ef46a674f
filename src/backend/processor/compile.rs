//! From the checked program to words: what the compiler keeps, and what it hands back. The rungs
//! are in `rung`, the blocks in `call`.

use std::collections::HashSet;

use super::layout::Layout;
use super::listing::{Symbols, listing};
use super::power::Power;
use super::rom::Rom;
use super::shortage::{NoRoom, full};
use super::sizes::Sizes;
use super::tree::Tree;
use super::usage;
use super::word::{Address, Operation, Prefix, Word};
use crate::backend::hdl::Harmless;
use crate::diagnostic::{Diagnostic, code};
use crate::model::{Program, Role, VariableId};
use crate::source::Span;

/// A program on the processor.
#[derive(Clone, Debug)]
pub struct Image {
    /// What its memories hold.
    pub rom: Rom,
    /// Where its variables live.
    pub layout: Layout,
    /// For each word the index of the rung that it comes from; nothing for what the compiler adds.
    pub rungs: Vec<Option<usize>>,
}

impl Image {
    /// The smallest processor that holds what the words name and what the program declares: a
    /// variable that no rung names is there for the host.
    pub fn needs(&self) -> Sizes {
        let mut needs = self.rom.needs();
        self.layout.bit_names.keys().for_each(|&bit| needs.need_bit(bit));
        self.layout.register_names.keys().for_each(|&register| needs.need_register(register));
        needs
    }

    /// The listing with the names of the program and its rungs.
    pub fn listing(&self, program: &Program, source: &str) -> String {
        let heading = |at: usize| {
            let rung = self.rungs[at];
            let first = at == 0 || self.rungs[at - 1] != rung;
            let rung = rung.filter(|_| first)?;
            let meant = &program.rungs[rung];
            let title =
                meant.title.as_ref().map(|title| format!(" \"{}\"", Harmless::unicode(title)));
            let number = meant.number;
            Some(format!("rung {number}{}, {source}:{}", title.unwrap_or_default(), meant.line))
        };
        let symbols = Symbols {
            bit: &|address| self.layout.bit_names.get(&address).cloned(),
            register: &|register| self.layout.register_names.get(&register).cloned(),
            needs: self.needs(),
            heading: &heading,
        };
        listing(&self.rom, &symbols)
    }
}

/// Compiles a checked program for the processor.
///
/// # Errors
/// Everything in it that the processor cannot do, in the order of the text.
pub fn compile(program: &Program) -> Result<Image, Vec<Diagnostic>> {
    compile_observing(program, &[])
}

/// The same with members in the image that no rung reads.
///
/// # Errors
/// Everything in it that the processor cannot do, in the order of the text.
pub fn compile_observing(
    program: &Program,
    observed: &[VariableId],
) -> Result<Image, Vec<Diagnostic>> {
    compile_for(program, observed, Sizes::default())
}

/// The same for a processor of these sizes.
///
/// # Errors
/// Everything in it that the processor cannot do, in the order of the text.
pub fn compile_for(
    program: &Program,
    observed: &[VariableId],
    sizes: Sizes,
) -> Result<Image, Vec<Diagnostic>> {
    let layout = Layout::new(program, sizes)?;
    let mut named = usage::named(program);
    named.extend(observed);
    let mut compiler = Compiler {
        program,
        named,
        layout,
        rom: Rom { tick_ns: program.tick_ns, sizes, ..Rom::default() },
        rungs: Vec::new(),
        rung: None,
        flags: Vec::new(),
        flags_used: 0,
        findings: Vec::new(),
        failed: false,
        span: Span::default(),
    };
    // The processor has dividers of its own.
    let called = program.instances.iter().filter(|(_, instance)| !instance.is_hidden);
    for (id, _) in called {
        // What stands against it has been reported.
        let _ = compiler.prepare(id);
    }
    for (index, rung) in program.rungs.iter().enumerate() {
        compiler.rung = Some(index);
        compiler.span = rung.span;
        compiler.flags_used = 0;
        let done = compiler.series(&rung.network, Power::Drawn(Tree::WIRE), false);
        // The next rung may have more that cannot be done.
        compiler.failed |= done.is_err();
    }
    compiler.end()
}

/// It has been reported, and the rung is given up.
pub(super) struct Reported;

pub(super) type Done<T> = Result<T, Reported>;

pub(super) struct Compiler<'p> {
    pub program: &'p Program,
    /// What the rungs name, and what is to be seen besides.
    pub named: HashSet<VariableId>,
    pub layout: Layout,
    pub rom: Rom,
    rungs: Vec<Option<usize>>,
    rung: Option<usize>,
    /// Flags for powers, which every rung uses anew.
    flags: Vec<Address>,
    flags_used: usize,
    findings: Vec<Diagnostic>,
    /// A rung was given up.
    failed: bool,
    /// Of the rung or the element in work.
    span: Span,
}

impl Compiler<'_> {
    fn end(mut self) -> Result<Image, Vec<Diagnostic>> {
        self.rung = None;
        if let Some((first_scan, _)) = self.program.with_role(Role::FirstScan).next() {
            let coil = self.layout.bit(first_scan).expect("it is a BOOL");
            self.circuit(&Tree::constant(false)).ok();
            self.operation(Operation::Coil, coil);
        }
        self.word(Word::END);
        self.findings.extend(self.layout.shortages.findings(self.rom.sizes));
        let has = self.rom.sizes.code_words;
        if self.rom.code.len() > has && self.findings.is_empty() {
            let rung = self.rungs[has].or_else(|| self.program.rungs.len().checked_sub(1));
            let span = rung.map_or(Span::default(), |rung| self.program.rungs[rung].span);
            let need = self.rom.code.len();
            let message = format!("the program needs {need} words, the ladder processor has {has}");
            let found = full(span, message, self.rom.sizes);
            self.findings.push(found.label("from here on there is no room"));
        }
        assert!(!self.failed || !self.findings.is_empty(), "a rung is given up with a word on why");
        if !self.findings.is_empty() {
            self.findings.sort_by_key(|finding| finding.primary.span);
            return Err(self.findings);
        }
        for (id, variable) in self.program.variables.iter() {
            if let (Some(address), 1) = (self.layout.bit(id), variable.initial) {
                self.rom.image.insert(address);
            }
        }
        self.rom.pins = self.layout.pins();
        debug_assert_eq!(self.rom.faults(), [], "the compiler writes what the processor can run");
        Ok(Image { rom: self.rom, layout: self.layout, rungs: self.rungs })
    }

    pub(super) fn word(&mut self, word: Word) {
        self.rom.code.push(word.encode());
        self.rungs.push(self.rung);
    }

    pub(super) fn operation(&mut self, operation: Operation, coil: Address) {
        self.word(Word::Output { operation, coil });
    }

    pub(super) fn prefix(&mut self, prefix: Prefix) {
        self.word(Word::Prefix(prefix));
    }

    pub(super) fn report(&mut self, finding: Diagnostic) -> Reported {
        self.findings.push(finding);
        Reported
    }

    /// Gives up what the processor has no room for, which is reported in the end.
    pub(super) fn limit<T>(&self, result: Result<T, NoRoom>) -> Done<T> {
        result.map_err(|NoRoom| Reported)
    }

    /// Reports something that the processor cannot do.
    pub(super) fn cannot(&mut self, span: Span, what: &str, label: impl Into<String>) -> Reported {
        self.refuse(span, what, label, "build it with --emit verilog or vhdl, which can")
    }

    /// The same where something else can be written instead.
    pub(super) fn refuse(
        &mut self,
        span: Span,
        what: &str,
        label: impl Into<String>,
        help: &str,
    ) -> Reported {
        let message = format!("the ladder processor cannot do {what}");
        let finding = Diagnostic::new(code::NOT_ON_PROCESSOR, span, message);
        self.report(finding.label(label).help(help))
    }

    /// A flag of this rung.
    pub(super) fn flag(&mut self) -> Done<Address> {
        if self.flags_used == self.flags.len() {
            let name = format!("power {}", self.flags.len() + 1);
            let flag = self.layout.flag(name, self.span);
            let flag = self.limit(flag)?;
            self.flags.push(flag);
        }
        self.flags_used += 1;
        Ok(self.flags[self.flags_used - 1])
    }

    /// The bit of a variable, if it has one.
    pub(super) fn address(&self, variable: VariableId) -> Option<Address> {
        self.layout.bit(variable)
    }
}
