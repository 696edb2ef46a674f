//! Which formulas get names of their own, so that a listing stays as short as what it lists.

use la_arena::ArenaMap;

use super::formula::{FormulaId, Formulas};
use super::listing::{Equation, Listing};

/// A formula with more names than this is not written out where parts of it are shared.
const LONG: u32 = 100;
/// A part with fewer names is written out wherever it stands.
const SHORT: u32 = 3;
/// A formula with more names is cut, and so is one with more levels of brackets.
const LONGEST: u32 = 1000;
const DEEPEST: u32 = 40;

/// The names of parts.
pub(super) struct Parts {
    is_part: ArenaMap<FormulaId, ()>,
    /// The numbers of parts that have one so far.
    numbers: ArenaMap<FormulaId, u32>,
    next: u32,
}

/// How large a formula is when it is written out, its parts as names.
#[derive(Clone, Copy, Default)]
struct Size {
    names: u32,
    depth: u32,
}

impl Parts {
    pub fn new(listing: &Listing) -> Self {
        let formulas = &listing.formulas;
        let is_shared = shared(formulas, listing.shown().flat_map(Equation::roots));
        let mut is_part = ArenaMap::default();
        let mut sizes: ArenaMap<FormulaId, Size> = ArenaMap::default();
        for (id, formula) in formulas.arena.iter() {
            let mut size = Size { names: 0, depth: 1 };
            for &operand in formula.operands() {
                let inner = sizes[operand];
                size.names = size.names.saturating_add(inner.names);
                size.depth = size.depth.max(inner.depth + 1);
            }
            let is_leaf = formula.operands().is_empty();
            let shared = is_shared.contains_idx(id) && size.names >= SHORT;
            if !is_leaf && (shared || size.names > LONGEST || size.depth > DEEPEST) {
                is_part.insert(id, ());
            }
            if is_leaf || is_part.contains_idx(id) {
                size = Size { names: 1, depth: 1 };
            }
            sizes.insert(id, size);
        }
        Parts { is_part, numbers: ArenaMap::default(), next: 1 }
    }

    /// The number of a part, if the formula is one and has been given one.
    pub fn number(&self, formula: FormulaId) -> Option<u32> {
        self.numbers.get(formula).copied()
    }

    /// Numbers the parts that an equation needs and none before it did; operands first.
    pub fn introduce(&mut self, formulas: &Formulas, equation: &Equation) -> Vec<FormulaId> {
        let mut new = Vec::new();
        let mut met = ArenaMap::default();
        let mut waiting: Vec<FormulaId> = equation.roots().collect();
        while let Some(formula) = waiting.pop() {
            if self.numbers.contains_idx(formula) || met.insert(formula, ()).is_some() {
                continue;
            }
            if self.is_part.contains_idx(formula) {
                new.push(formula);
            }
            waiting.extend(formulas.arena[formula].operands());
        }
        new.sort_unstable();
        for &part in &new {
            self.numbers.insert(part, self.next);
            self.next += 1;
        }
        new
    }
}

/// The formulas with several users within long equations.
fn shared(formulas: &Formulas, roots: impl Iterator<Item = FormulaId>) -> ArenaMap<FormulaId, ()> {
    let mut names: ArenaMap<FormulaId, u32> = ArenaMap::default();
    for (id, formula) in formulas.arena.iter() {
        let inner =
            formula.operands().iter().fold(0, |sum: u32, &one| sum.saturating_add(names[one]));
        names.insert(id, inner.max(1));
    }
    let mut shared = ArenaMap::default();
    let mut met = ArenaMap::default();
    let mut waiting: Vec<FormulaId> = roots.filter(|&root| names[root] > LONG).collect();
    while let Some(formula) = waiting.pop() {
        if met.insert(formula, ()).is_some() {
            shared.insert(formula, ());
            continue;
        }
        waiting.extend(formulas.arena[formula].operands());
    }
    shared
}
