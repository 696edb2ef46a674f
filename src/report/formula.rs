//! Formulas: expressions of the equations as people read them, simplified, each made once.

use std::collections::{HashMap, HashSet};

use la_arena::{Arena, Idx};

use crate::equations::StepId;
use crate::model::{Edge, VariableId};
use crate::types::Type;

/// A formula of an arena. Operands stand before their users.
pub(super) type FormulaId = Idx<Formula>;

/// What a formula says.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) enum Formula {
    /// A value of a type.
    Number(i64, Type),
    /// The value that a step of this scan left in a variable, or, without one, the scan before.
    Value(VariableId, Option<StepId>),
    /// 1 in the scan of a change of a `BOOL`.
    Edge(Edge, FormulaId),
    /// Of a `BOOL`.
    Not(FormulaId),
    /// Of `BOOL`s, two or more, no two the same.
    All(Vec<FormulaId>),
    /// Of `BOOL`s, two or more, no two the same.
    Any(Vec<FormulaId>),
    /// An operator of the language between two values, and the type of its result.
    Infix(&'static str, [FormulaId; 2], Type),
    /// A bit of a number.
    Bit(FormulaId, u32),
    /// A function of the language, or one that the page of the command describes, and the type of
    /// its result.
    Apply(&'static str, Vec<FormulaId>, Type),
}

impl Formula {
    /// The formulas that it is made of.
    pub fn operands(&self) -> &[FormulaId] {
        match self {
            Formula::Number(..) | Formula::Value(..) => &[],
            Formula::Edge(_, one) | Formula::Not(one) | Formula::Bit(one, _) => {
                std::slice::from_ref(one)
            }
            Formula::All(list) | Formula::Any(list) | Formula::Apply(_, list, _) => list,
            Formula::Infix(_, pair, _) => pair,
        }
    }
}

/// Longer lists are not merged into others, so that the lists of a long chain stay short.
const LONGEST_MERGED: usize = 32;

/// The formulas of a listing.
#[derive(Default)]
pub(super) struct Formulas {
    pub arena: Arena<Formula>,
    known: HashMap<Formula, FormulaId>,
}

impl Formulas {
    /// A formula as it is.
    pub fn add(&mut self, formula: Formula) -> FormulaId {
        let arena = &mut self.arena;
        *self.known.entry(formula).or_insert_with_key(|formula| arena.alloc(formula.clone()))
    }

    /// `TRUE` or `FALSE`.
    pub fn bit(&mut self, value: bool) -> FormulaId {
        self.add(Formula::Number(value.into(), Type::Bool))
    }

    fn is_bit(&self, formula: FormulaId, value: bool) -> bool {
        self.arena[formula] == Formula::Number(value.into(), Type::Bool)
    }

    /// The opposite of a `BOOL`.
    pub fn not(&mut self, formula: FormulaId) -> FormulaId {
        match self.arena[formula] {
            Formula::Not(inner) => inner,
            Formula::Number(value, _) => self.bit(value == 0),
            _ => self.add(Formula::Not(formula)),
        }
    }

    /// 1 if all are.
    pub fn all(&mut self, list: &[FormulaId]) -> FormulaId {
        self.merge(list, true)
    }

    /// 1 if one is.
    pub fn any(&mut self, list: &[FormulaId]) -> FormulaId {
        self.merge(list, false)
    }

    /// One value or the other.
    pub fn select(
        &mut self,
        power: FormulaId,
        on: FormulaId,
        off: FormulaId,
        ty: Type,
    ) -> FormulaId {
        if on == off || self.is_bit(power, true) {
            return on;
        }
        if self.is_bit(power, false) {
            return off;
        }
        if self.is_bit(on, true) {
            return self.any(&[power, off]);
        }
        if self.is_bit(off, false) {
            return self.all(&[power, on]);
        }
        let unpowered = self.not(power);
        if self.is_bit(on, false) {
            return self.all(&[unpowered, off]);
        }
        if self.is_bit(off, true) {
            return self.any(&[unpowered, on]);
        }
        self.add(Formula::Apply("SEL", vec![power, off, on], ty))
    }

    /// The elements of a formula that is a list of the same kind.
    fn elements(&self, formula: FormulaId, all: bool) -> Option<&[FormulaId]> {
        match (&self.arena[formula], all) {
            (Formula::All(list), true) | (Formula::Any(list), false) => Some(list),
            _ => None,
        }
    }

    fn merge(&mut self, list: &[FormulaId], all: bool) -> FormulaId {
        let mut merged = Vec::with_capacity(list.len());
        let mut seen = HashSet::new();
        for &one in list {
            let inner = self.elements(one, all).filter(|inner| inner.len() <= LONGEST_MERGED);
            for &element in inner.unwrap_or(&[one]) {
                if self.is_bit(element, !all) {
                    return element;
                }
                if !self.is_bit(element, all) && seen.insert(element) {
                    merged.push(element);
                }
            }
        }
        let is_inverse =
            |&one: &FormulaId| matches!(&self.arena[one], Formula::Not(not) if seen.contains(not));
        if merged.iter().any(is_inverse) {
            return self.bit(!all);
        }
        // x & (x | y) is x, and x | x & y too.
        merged.retain(|&one| {
            let inner = self.elements(one, !all).unwrap_or(&[]);
            !inner.iter().any(|element| seen.contains(element))
        });
        match merged.as_slice() {
            [] => self.bit(all),
            [only] => *only,
            _ => self.add(if all { Formula::All(merged) } else { Formula::Any(merged) }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Three different formulas that nothing is known of.
    fn three(formulas: &mut Formulas) -> [FormulaId; 3] {
        [1, 2, 3].map(|number| formulas.add(Formula::Number(number, Type::Int)))
    }

    #[test]
    fn what_says_nothing_goes() {
        let mut formulas = Formulas::default();
        let [a, b, c] = three(&mut formulas);
        let (on, off) = (formulas.bit(true), formulas.bit(false));
        let a = formulas.add(Formula::Edge(Edge::Rise, a));
        let not_a = formulas.not(a);
        assert_eq!(formulas.not(not_a), a);
        assert_eq!(formulas.all(&[a, on, a]), a);
        assert_eq!(formulas.all(&[a, b, off]), off);
        assert_eq!(formulas.any(&[a, b, not_a]), on);
        assert_eq!(formulas.all(&[]), on);
        let either = formulas.any(&[a, b]);
        assert_eq!(formulas.all(&[a, either]), a);
        let (ab, abc) = (formulas.all(&[a, b]), formulas.all(&[a, b, c]));
        assert_eq!(formulas.all(&[ab, c]), abc);
        assert_eq!(formulas.any(&[ab, b]), b);
    }

    #[test]
    fn a_choice_of_bits_is_a_list() {
        let mut formulas = Formulas::default();
        let [power, x, _] = three(&mut formulas);
        let (on, off) = (formulas.bit(true), formulas.bit(false));
        let unpowered = formulas.not(power);
        let lists = [
            (on, x, formulas.any(&[power, x])),
            (off, x, formulas.all(&[unpowered, x])),
            (x, off, formulas.all(&[power, x])),
            (x, on, formulas.any(&[unpowered, x])),
            (x, x, x),
        ];
        for (if_on, if_off, list) in lists {
            assert_eq!(formulas.select(power, if_on, if_off, Type::Bool), list);
        }
        assert_eq!(formulas.select(on, x, power, Type::Int), x);
        assert_eq!(formulas.select(off, x, power, Type::Int), power);
    }
}
