//! Programs that mean the same as another, made from its text by one change. The evaluator has no
//! witness but these: it must not see the difference.

use std::collections::HashSet;

use fastrand::Rng;
use hotrail::circuit::Simulator;
use hotrail::eval::Evaluator;
use hotrail::expand;
use hotrail::model::{Names, Program, Role, Variable, VariableId};
use hotrail::source::Source;
use hotrail::syntax::ast::{Element, ElementKind, File, Item, Rung, Series};

use super::analyze;
use super::dice::Dice;

/// What a new name begins with. No other program has such names.
const NEW: &str = "changed_";

/// Cuts into a text: what stands there gives way to something else.
type Cuts = Vec<(std::ops::Range<usize>, String)>;

/// A change that keeps the meaning, or nothing where the program has no place for it.
pub type Change = fn(&Source, &Parts<'_>, &mut Rng) -> Option<Cuts>;

/// Every kind of change, with its name.
pub const CHANGES: &[(&str, Change)] = &[
    ("two branches of contacts swapped", swap),
    ("the power inverted twice", invert_twice),
    ("a rung split through a variable", split),
    ("the variables renamed", rename),
    ("a rung inserted that nobody reads", insert),
    ("two branches made a list of their own", nest),
    ("a list merged into the list around it", merge),
];

/// The text of a program after a change of that number, if it has a place for one.
pub fn changed(name: &str, text: &str, change: usize, random: &mut Rng) -> Option<String> {
    let source = Source::new(name, text);
    let (file, _) = hotrail::syntax::parse(&source);
    let mut cuts = CHANGES[change].1(&source, &Parts::of(&file), random)?;
    cuts.sort_by_key(|(range, _)| std::cmp::Reverse((range.start, range.end)));
    let mut text = text.to_owned();
    for (range, new) in cuts {
        text.replace_range(range, &new);
    }
    Some(text)
}

/// Makes a change in a program and runs both: how many scans they agreed, or nothing if the program
/// has no place for the change.
///
/// # Errors
/// What differs, and the changed program.
///
/// # Panics
/// If the changed program is wrong.
pub fn check(name: &str, text: &str, change: usize, seed: u64) -> Result<Option<u64>, String> {
    const SCANS: usize = 100;
    let mut random = Rng::with_seed(seed);
    let Some(changed) = changed(name, text, change, &mut random) else { return Ok(None) };
    let program = analyze(name, text)?;
    let other = analyze(name, &changed).unwrap_or_else(|findings| panic!("{changed}{findings}"));
    match difference(&program, &other, SCANS, random) {
        None => Ok(Some(SCANS as u64)),
        Some(wrong) => Err(format!("{wrong}\n{changed}")),
    }
}

/// Runs a program and one that shall mean the same, whose variables may bear new names, for that
/// many scans on random inputs and ticks; says what differs.
fn difference(program: &Program, other: &Program, scans: usize, mut random: Rng) -> Option<String> {
    let names = Names::of(other);
    let pairs: Vec<(VariableId, VariableId)> = program
        .variables
        .iter()
        .filter(|(_, variable)| program.is_named(variable))
        .map(|(id, variable)| (id, same(&names, &variable.name)))
        .collect();
    let is_input =
        |&&(id, _): &&(VariableId, VariableId)| program.variables[id].role == Role::Input;
    let is_port = |id: VariableId| matches!(other.variables[id].role, Role::Input | Role::Output);
    let observe = pairs.iter().map(|&(_, id)| id).filter(|&id| !is_port(id)).collect();
    let options = expand::Options { observe, ..expand::Options::default() };
    let mut circuit = Simulator::new(&hotrail::compile(other, &options));
    let outputs = circuit.circuit().outputs.iter();
    let shown =
        outputs.map(|output| names.variable(&output.name).expect("ports bear user's names"));
    let shown: Vec<VariableId> = shown.collect();
    let (mut before, mut after) = (Evaluator::new(program), Evaluator::new(other));
    for scan in 0..scans {
        let tick = random.bool();
        let mut bits = vec![u64::from(tick)];
        for &(input, twin) in pairs.iter().filter(is_input) {
            let ty = program.variables[input].ty;
            if random.u8(..3) == 0 {
                let value = random.value(ty);
                before.drive(input, value);
                after.drive(twin, value);
            }
            bits.push(ty.bits(before.value(input)));
        }
        before.scan(tick);
        after.scan(tick);
        circuit.settle(&bits);
        circuit.clock();
        let wrong = pairs.iter().find(|&&(id, twin)| before.value(id) != after.value(twin));
        if let Some(&(id, twin)) = wrong {
            let name = &program.variables[id].name;
            let (meant, shown) = (before.value(id), after.value(twin));
            return Some(format!("scan {scan}: {name} was {meant}, after the change {shown}"));
        }
        for (port, &id) in shown.iter().enumerate() {
            let Variable { name, ty, .. } = &other.variables[id];
            if circuit.output(port) != ty.bits(after.value(id)) {
                return Some(format!("scan {scan}: {name} of the changed circuit"));
            }
        }
    }
    None
}

/// The variable that has the name, or has it behind the mark of new names.
fn same(other: &Names<'_>, name: &str) -> VariableId {
    let renamed = || other.variable(&format!("{NEW}{name}"));
    other.variable(name).or_else(renamed).expect("no variable goes")
}

/// The parts of a program that a change may touch.
pub struct Parts<'f> {
    file: &'f File<'f>,
    rungs: Vec<&'f Rung<'f>>,
    /// Every series but those in general networks, where the power cannot be inverted.
    series: Vec<&'f Series<'f>>,
    /// The branches of every list.
    lists: Vec<(&'f Element<'f>, &'f [Series<'f>])>,
}

impl<'f> Parts<'f> {
    fn of(file: &'f File<'f>) -> Parts<'f> {
        let rungs = file.items.iter().filter_map(|item| match item {
            Item::Rung(rung) => Some(rung),
            _ => None,
        });
        let mut parts =
            Parts { file, rungs: rungs.collect(), series: Vec::new(), lists: Vec::new() };
        for rung in parts.rungs.clone() {
            parts.walk(&rung.network, false);
        }
        parts
    }

    fn walk(&mut self, series: &'f Series<'f>, in_net: bool) {
        if !in_net {
            self.series.push(series);
        }
        for element in &series.elements {
            match &element.kind {
                ElementKind::Parallel(branches) => {
                    self.lists.push((element, branches));
                    branches.iter().for_each(|branch| self.walk(branch, in_net));
                }
                ElementKind::Net(net) => {
                    net.connections.iter().for_each(|part| self.walk(&part.network, true));
                }
                ElementKind::Call(call) => {
                    call.networks().for_each(|network| self.walk(network, in_net));
                }
                _ => {}
            }
        }
    }
}

/// One of a list, if it is not empty.
fn any<'t, T>(list: &'t [T], random: &mut Rng) -> Option<&'t T> {
    (!list.is_empty()).then(|| &list[random.usize(..list.len())])
}

fn swap(source: &Source, parts: &Parts<'_>, random: &mut Rng) -> Option<Cuts> {
    fn looks(series: &Series<'_>) -> bool {
        series.elements.iter().all(|element| match &element.kind {
            ElementKind::Contact { .. }
            | ElementKind::Constant(_)
            | ElementKind::FirstScan { .. } => true,
            ElementKind::Parallel(branches) => branches.iter().all(looks),
            _ => false,
        })
    }
    let pure = parts.lists.iter().map(|&(_, branches)| branches);
    let pure: Vec<_> = pure.filter(|list| list.len() > 1 && list.iter().all(looks)).collect();
    let branches = any(&pure, random)?;
    let upper = random.usize(..branches.len() - 1);
    let (a, b) = (branches[upper].span, branches[upper + 1].span);
    Some(vec![(a.range(), source.slice(b).to_owned()), (b.range(), source.slice(a).to_owned())])
}

fn invert_twice(_: &Source, parts: &Parts<'_>, random: &mut Rng) -> Option<Cuts> {
    let place = any(&any(&parts.series, random)?.elements, random)?.span.range().start;
    Some(vec![(place..place, "not not ".to_owned())])
}

fn split(_: &Source, parts: &Parts<'_>, random: &mut Rng) -> Option<Cuts> {
    let long = parts.rungs.iter().filter(|rung| rung.network.elements.len() > 1);
    let rung = *any(&long.collect::<Vec<_>>(), random)?;
    let elements = &rung.network.elements;
    let place = elements[random.usize(1..elements.len())].span.range().start;
    let start = rung.span.range().start;
    Some(vec![
        (start..start, format!("var {NEW}power\n")),
        (place..place, format!("({NEW}power)\nrung {NEW}power ")),
    ])
}

/// The names of variables that are words of letters and digits, those of bits alone if wanted.
fn plain_names<'f>(parts: &Parts<'f>, bits: bool) -> Vec<&'f str> {
    let mut names = Vec::new();
    for item in &parts.file.items {
        let Item::Variables(variables) = item else { continue };
        let is_bit = variables.ty.is_none();
        let declared = variables.names.iter().map(|declarator| declarator.name);
        let written = declared.filter(|name| name.text.len() == name.span.range().len());
        names.extend(written.map(|name| name.text).filter(|_| is_bit || !bits));
    }
    names
}

fn rename(source: &Source, parts: &Parts<'_>, _: &mut Rng) -> Option<Cuts> {
    let names = plain_names(parts, false);
    let parameters = parameters(parts);
    let text = source.text();
    let is_word = |c: char| c == '_' || c.is_alphanumeric();
    let mut cuts = Vec::new();
    let mut at = 0;
    while let Some(c) = text[at..].chars().next() {
        let rest = &text[at..];
        let length = match c {
            // What stands in quotes is no name, or one that keeps its spelling.
            '"' | '`' => rest[1..].find(c).map_or(rest.len(), |end| end + 2),
            _ if is_word(c) => rest.find(|c| !is_word(c)).unwrap_or(rest.len()),
            _ => c.len_utf8(),
        };
        let is_member = text[..at].ends_with('.') || parameters.contains(&at);
        if names.contains(&&rest[..length]) && !is_member {
            cuts.push((at..at, NEW.to_owned()));
        }
        at += length;
    }
    (!cuts.is_empty()).then_some(cuts)
}

/// Where the names of the arguments of all calls stand.
fn parameters(parts: &Parts<'_>) -> HashSet<usize> {
    let elements = parts.series.iter().flat_map(|series| &series.elements);
    let calls = elements.filter_map(|element| match &element.kind {
        ElementKind::Call(call) => Some(call),
        _ => None,
    });
    let arguments = calls.flat_map(|call| &call.arguments);
    arguments.map(|argument| argument.name.span.range().start).collect()
}

fn insert(_: &Source, parts: &Parts<'_>, random: &mut Rng) -> Option<Cuts> {
    let bits = plain_names(parts, true);
    let (a, b) = (any(&bits, random)?, any(&bits, random)?);
    let place = any(&parts.rungs, random)?.span.range().start;
    let rung = format!("var {NEW}unread\nrung rise({a}) [ !{b} | {a} falling ] ({NEW}unread)\n");
    Some(vec![(place..place, rung)])
}

fn nest(_: &Source, parts: &Parts<'_>, random: &mut Rng) -> Option<Cuts> {
    let long = parts.lists.iter().map(|&(_, branches)| branches).filter(|list| list.len() > 2);
    let branches = *any(&long.collect::<Vec<_>>(), random)?;
    let upper = random.usize(..branches.len() - 1);
    let (start, end) = (branches[upper].span.range().start, branches[upper + 1].span.range().end);
    Some(vec![(start..start, "[ ".to_owned()), (end..end, " ]".to_owned())])
}

fn merge(source: &Source, parts: &Parts<'_>, random: &mut Rng) -> Option<Cuts> {
    let branches = parts.lists.iter().flat_map(|&(_, branches)| branches);
    let alone = branches.filter_map(|branch| match &branch.elements[..] {
        [element] if matches!(element.kind, ElementKind::Parallel(_)) => Some(element.span),
        _ => None,
    });
    let span = *any(&alone.collect::<Vec<_>>(), random)?;
    let text = source.slice(span);
    let inside = text.strip_prefix('[').and_then(|text| text.strip_suffix(']'))?;
    Some(vec![(span.range(), inside.to_owned())])
}
