//! What is asked of a word, and what has to be asked instead of the words it is computed from.

use crate::circuit::ranges::Assumptions;
use crate::circuit::{Cell, Circuit, Net, Op, mask};

/// The most questions that may stand in for one behind an adder.
const QUESTIONS: usize = 2;
/// The most cells between a question and what is asked instead.
const CELLS: u32 = 32;

/// A question about a word.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Test {
    /// Is it this number?
    Is(u64),
    /// Is it this number or more?
    AtLeast(u64),
}

impl Test {
    /// The answer for a number without a sign.
    pub fn of(self, number: u64) -> bool {
        match self {
            Test::Is(other) => number == other,
            Test::AtLeast(least) => number >= least,
        }
    }
}

/// A word without a sign and what is asked of it.
pub type Place = (Net, Test);

/// A comparison of a word with a constant, as a question.
pub struct Comparison {
    /// The word.
    pub of: Net,
    /// What is asked.
    pub test: Test,
    /// The order of the words is that of numbers in two's complement.
    pub signed: bool,
    /// The comparison is 1 where the answer is yes.
    pub is_yes: bool,
}

impl Comparison {
    /// What a cell asks, if it is a comparison with a constant.
    pub fn of(circuit: &Circuit, cell: Cell) -> Option<Comparison> {
        let constant = |net: Net| circuit.constant_value(net);
        let (of, test, signed, is_yes) = match cell.op {
            Op::Eq(net, other) => (net, Test::Is(constant(other)?), false, true),
            Op::Less { a, b, signed } => match (constant(a), constant(b)) {
                (None, Some(bound)) => (a, Test::AtLeast(bound), signed, false),
                // The builder knows that nothing is above the highest number.
                (Some(bound), None) => {
                    let above = bound.wrapping_add(1) & mask(circuit.width(b));
                    (b, Test::AtLeast(above), signed, true)
                }
                _ => return None,
            },
            _ => return None,
        };
        Some(Comparison { of, test, signed, is_yes })
    }
}

/// What a comparison of words without a sign with a constant asks, and whether the answer yes is 1.
pub fn asked(circuit: &Circuit, cell: Cell) -> Option<(Place, bool)> {
    let comparison = Comparison::of(circuit, cell)?;
    (!comparison.signed).then_some(((comparison.of, comparison.test), comparison.is_yes))
}

/// How the answer follows from what a word is computed from.
pub enum Source {
    /// It does not: it has to be asked here.
    Here,
    /// The word is a constant.
    Known(bool),
    /// The word is one of two.
    Choice {
        /// Decides.
        select: Net,
        /// Asked where it is 1.
        on: Place,
        /// Asked where it is 0.
        off: Place,
    },
    /// The word is another one moved.
    Moved {
        /// Whether it is moved, if it is not always: else the same is asked of the other word.
        bit: Option<Net>,
        /// The other word.
        from: Net,
        /// What is asked of it where it is moved.
        then: Then,
    },
}

/// The answer for a word that was moved, as answers for the word before.
#[derive(Clone, Copy)]
pub enum Then {
    /// This one.
    Same(Test),
    /// One of both is yes.
    Either(Test, Test),
    /// The first is yes and the second is no.
    Without(Test, Test),
}

impl Then {
    /// The questions.
    pub fn tests(self) -> impl Iterator<Item = Test> {
        let (first, second) = match self {
            Then::Same(test) => (test, None),
            Then::Either(a, b) | Then::Without(a, b) => (a, Some(b)),
        };
        [first].into_iter().chain(second)
    }
}

impl Source {
    /// How an answer is found.
    pub fn of(circuit: &Circuit, (net, test): Place) -> Source {
        if let Some(moved) = moved(circuit, (net, test)) {
            return moved;
        }
        match circuit.cell(net).op {
            Op::Const(bits) => Source::Known(test.of(bits)),
            Op::Mux { select, on, off } => {
                Source::Choice { select, on: (on, test), off: (off, test) }
            }
            _ => Source::Here,
        }
    }
}

/// For the sum or the difference of a word and a constant or a bit.
fn moved(circuit: &Circuit, (net, test): Place) -> Option<Source> {
    let is_word = |net: Net| circuit.constant_value(net).is_none();
    let by = |net: Net| match circuit.cell(net).op {
        Op::Const(bits) => Some((None, bits)),
        Op::Extend { from, signed: false } if circuit.width(from) == 1 => Some((Some(from), 1)),
        _ => None,
    };
    let (from, (bit, by), up) = match circuit.cell(net).op {
        Op::Add(a, b) => match (by(b), by(a)) {
            (Some(by), _) if is_word(a) => (a, by, true),
            (_, Some(by)) if is_word(b) => (b, by, true),
            _ => return None,
        },
        Op::Sub(a, b) => (a, by(b)?, false),
        _ => return None,
    };
    let then = match (test, up) {
        (Test::Is(number), true) => {
            Then::Same(Test::Is(number.wrapping_sub(by) & mask(circuit.width(net))))
        }
        (Test::Is(number), false) => {
            Then::Same(Test::Is(number.wrapping_add(by) & mask(circuit.width(net))))
        }
        (Test::AtLeast(1..), true) if by == 1 => {
            let Test::AtLeast(least) = test else { return None };
            Then::Either(Test::Is(least - 1), test)
        }
        (Test::AtLeast(least), false) if by == 1 => Then::Without(test, Test::Is(least)),
        (Test::AtLeast(_), _) => return None,
    };
    Some(Source::Moved { bit, from, then })
}

/// A search for what has to be asked.
pub struct Search<'c> {
    circuit: &'c Circuit,
    places: Vec<Place>,
    /// How many cells may still be looked at.
    cells: u32,
}

impl<'c> Search<'c> {
    /// What has to be asked instead of something that stands behind an adder: of a few words in
    /// front of it. Nothing if it stands behind none, or too much would have to be asked.
    pub fn places(
        circuit: &'c Circuit,
        assumptions: &mut Assumptions<'_>,
        place: Place,
    ) -> Option<Vec<Place>> {
        let mut search = Search { circuit, places: Vec::new(), cells: CELLS };
        let is_behind = search.find(assumptions, place);
        let is_small = search.cells > 0 && (1..=QUESTIONS).contains(&search.places.len());
        (is_behind && is_small && search.places != [place]).then_some(search.places)
    }

    /// Collects the places. True if some of them stand before an adder.
    fn find(&mut self, under: &mut Assumptions<'_>, place: Place) -> bool {
        self.cells = self.cells.saturating_sub(1);
        if self.cells == 0 || self.places.len() > QUESTIONS {
            return false;
        }
        match Source::of(self.circuit, place) {
            Source::Known(_) => false,
            Source::Choice { select, on, off } => {
                let mut chosen = |value: bool, place: Place| {
                    let found = under.under(select, value, |under| self.find(under, place));
                    // What is never chosen stays as it is, and has to be there.
                    found.unwrap_or_else(|| self.find(under, place))
                };
                let on = chosen(true, on);
                chosen(false, off) || on
            }
            Source::Moved { bit, from, then } if self.keeps_order(under, bit, from, then) => {
                for test in then.tests() {
                    self.find(under, (from, test));
                }
                if bit.is_some() {
                    self.find(under, (from, place.1));
                }
                true
            }
            Source::Moved { .. } | Source::Here => {
                if !self.places.contains(&place) {
                    self.places.push(place);
                }
                false
            }
        }
    }

    /// True if the word does not wrap where it is moved, or nothing is asked of its size.
    fn keeps_order(
        &self,
        under: &mut Assumptions<'_>,
        bit: Option<Net>,
        from: Net,
        then: Then,
    ) -> bool {
        let highest = mask(self.circuit.width(from));
        let does = |under: &mut Assumptions<'_>| {
            let (low, high) = under.interval(from).unsigned();
            match then {
                Then::Same(_) => true,
                Then::Either(..) => high < highest,
                Then::Without(..) => low > 0,
            }
        };
        match bit {
            None => does(under),
            Some(bit) => under.under(bit, true, does).unwrap_or(true),
        }
    }
}
