//! From the checked program to words: rungs are cut at outputs into circuits of contacts.
//!
//! Power is carried along as a drawing of contacts that is not worked out yet, as long as nothing
//! between here and its use writes what it looks at. Where something does, or where it is needed
//! more than once, it goes into a flag.

use std::collections::HashSet;

use super::encode::fit;
use super::layout::{Layout, full};
use super::listing::{Symbols, listing};
use super::rom::Rom;
use super::tree::{Contact, Tree};
use super::usage;
use super::word::{Address, CODE_WORDS, Operation, Prefix, Word};
use crate::backend::hdl::Harmless;
use crate::diagnostic::{Diagnostic, code};
use crate::model::{CoilAction, Edge, Element, InstanceId, Place, Program, Role, VariableId};
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
    let layout = Layout::new(program).map_err(|diagnostic| vec![*diagnostic])?;
    let mut named = usage::named(program);
    named.extend(observed);
    let mut compiler = Compiler {
        program,
        named,
        layout,
        rom: Rom { tick_ns: program.tick_ns, ..Rom::default() },
        rungs: Vec::new(),
        rung: None,
        flags: Vec::new(),
        flags_used: 0,
        findings: Vec::new(),
        failed: false,
        span: Span::default(),
    };
    for (id, _) in program.instances.iter() {
        // A flag that is missing has been reported.
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

/// The power at a place of a rung.
pub(super) enum Power {
    /// These contacts, worked out when it is used.
    Drawn(Tree),
    /// In hand: the last word left it. A contact with the same value, if there is one.
    InHand(Option<Contact>),
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
            self.word(Word::Output { operation: Operation::Coil, coil });
        }
        self.word(Word::END);
        if self.rom.code.len() > CODE_WORDS && self.findings.is_empty() {
            let rung = self.rungs[CODE_WORDS].or_else(|| self.program.rungs.len().checked_sub(1));
            let span = rung.map_or(Span::default(), |rung| self.program.rungs[rung].span);
            let need = self.rom.code.len();
            let message =
                format!("the program needs {need} words, the ladder processor has {CODE_WORDS}");
            let found = full(span, message)
                .label("from here on there is no room")
                .help("build it with --emit verilog or vhdl, or make two programs of it");
            self.findings.push(found);
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

    /// Reports a limit that is reached.
    pub(super) fn limit<T>(&mut self, result: Result<T, Box<Diagnostic>>) -> Done<T> {
        result.map_err(|finding| self.report(*finding))
    }

    /// Reports something that the processor cannot do.
    pub(super) fn cannot(&mut self, span: Span, what: &str, label: impl Into<String>) -> Reported {
        let finding = Diagnostic::new(
            code::NOT_ON_PROCESSOR,
            span,
            format!("the ladder processor cannot do {what}"),
        )
        .label(label)
        .help("build it with --emit verilog or vhdl, which can");
        self.report(finding)
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

    /// Works a power out, so that it is in hand.
    pub(super) fn circuit(&mut self, tree: &Tree) -> Done<()> {
        let mut full = None;
        let fitted = fit(tree, || {
            self.flag().unwrap_or_else(|reported| {
                full = Some(reported);
                0
            })
        });
        if let Some(reported) = full {
            return Err(reported);
        }
        for (words, flag) in fitted.before {
            words.into_iter().for_each(|word| self.word(word));
            self.word(Word::Output { operation: Operation::Coil, coil: flag });
        }
        fitted.words.into_iter().for_each(|word| self.word(word));
        Ok(())
    }

    /// Works a power out and writes an output with it.
    pub(super) fn output(&mut self, tree: &Tree, operation: Operation, coil: Address) -> Done<()> {
        self.circuit(tree)?;
        self.word(Word::Output { operation, coil });
        Ok(())
    }

    /// Puts a power into a flag.
    pub(super) fn flagged(&mut self, tree: &Tree) -> Done<Contact> {
        let coil = self.flag()?;
        self.output(tree, Operation::Coil, coil)?;
        Ok(Contact { address: coil, negated: false })
    }

    /// What conducts where a tree does not.
    pub(super) fn inverted(&mut self, tree: &Tree) -> Done<Tree> {
        match tree.inverted() {
            Some(inverted) => Ok(inverted),
            None => Ok(Tree::off(self.flagged(tree)?.address)),
        }
    }

    /// The power as a drawing.
    pub(super) fn drawn(&mut self, power: Power) -> Done<Tree> {
        match power {
            Power::Drawn(tree) => Ok(tree),
            Power::InHand(Some(contact)) => Ok(Tree::Contact(contact)),
            Power::InHand(None) => {
                let coil = self.flag()?;
                self.word(Word::Output { operation: Operation::Coil, coil });
                Ok(Tree::on(coil))
            }
        }
    }

    /// The power as one contact.
    pub(super) fn single(&mut self, power: Power) -> Done<Contact> {
        let tree = self.drawn(power)?;
        match tree.single() {
            Some(contact) => Ok(contact),
            None if tree.is_wire() => Ok(Contact { address: super::word::ONE, negated: false }),
            None => self.flagged(&tree),
        }
    }

    /// Elements from left to right; the power behind them counts only if it is wanted.
    pub(super) fn series(
        &mut self,
        elements: &[Element],
        power: Power,
        wanted: bool,
    ) -> Done<Power> {
        let mut power = power;
        for (index, element) in elements.iter().enumerate() {
            let wanted = wanted || index + 1 < elements.len();
            power = self.element(element, power, wanted)?;
        }
        Ok(power)
    }

    fn element(&mut self, element: &Element, power: Power, wanted: bool) -> Done<Power> {
        if is_contacts(element) {
            // What an edge contact writes is its own, so the drawn power stays what it is.
            let left = self.drawn(power)?;
            let part = self.contacts(element)?;
            return Ok(Power::Drawn(Tree::series([left, part])));
        }
        match element {
            Element::Parallel(branches) => self.list(branches, power, wanted),
            Element::OneShot { edge, memory } => {
                let now = self.single(power)?;
                let coil = self.flag()?;
                self.change(now, *edge, *memory, coil)?;
                Ok(Power::Drawn(Tree::on(coil)))
            }
            Element::Invert => match power {
                Power::InHand(None) => {
                    let coil = self.flag()?;
                    self.word(Word::Output { operation: Operation::Inverted, coil });
                    Ok(Power::Drawn(Tree::on(coil)))
                }
                power => {
                    let tree = self.drawn(power)?;
                    self.inverted(&tree).map(Power::Drawn)
                }
            },
            Element::Coil { target, action, span } => match target.as_variable() {
                Some(target) => self.coil(target, *action, power),
                None => self.register_coil(target, *action, *span, power),
            },
            Element::ResetInstance(instance) => self.reset_instance(*instance, power),
            Element::Assign { target, value, span } => {
                let target = self.whole(target, *span)?;
                self.assign(target, value, *span, power)
            }
            Element::Call(call) => self.call(call, power),
            Element::Constant(_)
            | Element::Contact { .. }
            | Element::Edge { .. }
            | Element::Net(_)
            | Element::Compare(..) => unreachable!("they are contacts"),
        }
    }

    /// Something that only looks, as a drawing.
    pub(super) fn contacts(&mut self, element: &Element) -> Done<Tree> {
        match element {
            Element::Constant(value) => Ok(Tree::constant(*value)),
            Element::Contact { place, negated, span } => {
                let address = self.bit_of(place, *span)?;
                Ok(Tree::Contact(Contact { address, negated: *negated }))
            }
            Element::Edge { place, edge, memory } => {
                let span = self.program.variables[*memory].span;
                let address = self.bit_of(place, span)?;
                let coil = self.flag()?;
                self.change(Contact { address, negated: false }, *edge, *memory, coil)?;
                Ok(Tree::on(coil))
            }
            Element::Parallel(branches) => {
                let mut list = Vec::with_capacity(branches.len());
                for branch in branches {
                    list.push(self.all_contacts(branch)?);
                }
                Ok(Tree::parallel(list))
            }
            Element::Compare(expr, span) => self.condition(expr, *span),
            Element::Net(net) => self.net(net),
            _ => unreachable!("it only looks"),
        }
    }

    pub(super) fn all_contacts(&mut self, elements: &[Element]) -> Done<Tree> {
        let mut parts = Vec::with_capacity(elements.len());
        for element in elements {
            parts.push(self.contacts(element)?);
        }
        Ok(Tree::series(parts))
    }

    /// A place that is a whole variable, and always the same one.
    pub(super) fn whole(&mut self, place: &Place, span: Span) -> Done<VariableId> {
        place.as_variable().ok_or_else(|| {
            let label = format!("`{}` has no address of its own", place.name(self.program));
            self.cannot(span, "bits of words and elements chosen while it runs", label)
        })
    }

    /// The address of a bit that a contact looks at.
    pub(super) fn readable(&mut self, variable: VariableId, span: Span) -> Done<Address> {
        if let Some(address) = self.address(variable) {
            return Ok(address);
        }
        let name = &self.program.variables[variable].name;
        Err(match self.program.variables[variable].role {
            // The call is reported; a member of what the processor does not have is no other mistake.
            Role::Member(..) => Reported,
            _ => self.cannot(span, "this contact", format!("`{name}` has no image address")),
        })
    }

    /// Branches with outputs in them: each is worked out in its turn.
    fn list(&mut self, branches: &[Vec<Element>], power: Power, wanted: bool) -> Done<Power> {
        let writes = |compiler: &Self, branches: &[Vec<Element>]| {
            let mut written = Vec::new();
            branches.iter().flatten().for_each(|element| compiler.written(element, &mut written));
            written
        };
        let written = writes(self, branches);
        let mut left = self.drawn(power)?;
        let is_shared = left.single().is_none() && !left.is_wire();
        if is_shared || left.reads(&|address| written.contains(&address)) {
            left = Tree::Contact(self.flagged(&left)?);
        }
        let mut results: Vec<Tree> = Vec::new();
        for (index, branch) in branches.iter().enumerate() {
            let power = self.series(branch, Power::Drawn(left.clone()), wanted)?;
            if wanted {
                let mut result = self.drawn(power)?;
                let later = writes(self, &branches[index + 1..]);
                if result.reads(&|address| later.contains(&address)) {
                    result = Tree::Contact(self.flagged(&result)?);
                }
                results.push(result);
            }
        }
        Ok(if wanted { Power::Drawn(Tree::parallel(results)) } else { Power::InHand(None) })
    }

    /// The bits that an element writes and that others can see.
    fn written(&self, element: &Element, written: &mut Vec<Address>) {
        let members = |instance: InstanceId| {
            let members = &self.program.instances[instance].members;
            members.iter().filter_map(|&member| self.address(member)).collect::<Vec<_>>()
        };
        match element {
            Element::Coil { target, .. } | Element::Assign { target, .. } => {
                written.extend(target.as_variable().and_then(|target| self.address(target)));
            }
            Element::ResetInstance(instance) => written.extend(members(*instance)),
            Element::Call(call) => written.extend(members(call.instance)),
            Element::Parallel(branches) => {
                branches.iter().flatten().for_each(|element| self.written(element, written));
            }
            Element::Constant(_)
            | Element::Contact { .. }
            | Element::Edge { .. }
            | Element::OneShot { .. }
            | Element::Invert
            | Element::Net(_)
            | Element::Compare(..) => {}
        }
    }

    /// `coil` is 1 in the scan of a change; the memory then holds what was seen.
    pub(super) fn change(
        &mut self,
        now: Contact,
        edge: Edge,
        memory: VariableId,
        coil: Address,
    ) -> Done<()> {
        let memory = self.address(memory).ok_or(Reported)?;
        let fell = Contact { negated: !now.negated, ..now };
        let changed = match edge {
            Edge::Rise => [Tree::Contact(now), Tree::off(memory)],
            Edge::Fall => [Tree::Contact(fell), Tree::on(memory)],
        };
        self.output(&Tree::series(changed), Operation::Coil, coil)?;
        self.output(&Tree::Contact(now), Operation::Coil, memory)
    }

    fn coil(&mut self, target: VariableId, action: CoilAction, power: Power) -> Done<Power> {
        let coil = self.address(target).expect("a coil is a BOOL that is declared");
        let operation = match action {
            CoilAction::Plain => Operation::Coil,
            CoilAction::Negated => Operation::Inverted,
            CoilAction::Set => Operation::Set,
            CoilAction::Reset => Operation::Reset,
            CoilAction::Edge(edge, memory) => {
                let mut now = self.single(power)?;
                if now.address == coil {
                    now = self.flagged(&Tree::Contact(now))?;
                }
                self.change(now, edge, memory, coil)?;
                return Ok(Power::Drawn(Tree::Contact(now)));
            }
        };
        self.write(power, operation, coil)
    }

    /// An output that leaves the power in hand.
    pub(super) fn write(
        &mut self,
        power: Power,
        operation: Operation,
        coil: Address,
    ) -> Done<Power> {
        let same = match power {
            Power::Drawn(tree) => {
                self.circuit(&tree)?;
                tree.single()
            }
            Power::InHand(same) => same,
        };
        self.word(Word::Output { operation, coil });
        let same = same.filter(|contact| contact.address != coil);
        let written = |negated| Some(Contact { address: coil, negated });
        Ok(Power::InHand(match operation {
            Operation::Coil => same.or(written(false)),
            Operation::Inverted => same.or(written(true)),
            _ => same,
        }))
    }
}

/// True for what only looks and whose conduction does not depend on the power.
pub(super) fn is_contacts(element: &Element) -> bool {
    match element {
        Element::Constant(_)
        | Element::Contact { .. }
        | Element::Edge { .. }
        | Element::Net(_)
        | Element::Compare(..) => true,
        Element::Parallel(branches) => branches.iter().flatten().all(is_contacts),
        Element::OneShot { .. }
        | Element::Invert
        | Element::Coil { .. }
        | Element::ResetInstance(_)
        | Element::Assign { .. }
        | Element::Call(_) => false,
    }
}
