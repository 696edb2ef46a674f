//! Says nothing twice in conditions that go over several rungs.
//!
//! Before: any circuit. After: the same value of every net; an "and" of bits names none that
//! follows from the others, and in place of one that says more than is left to say it names what
//! is left. `!clamp_rung3 !drill_rung3`, where the third rung moves the part on from `clamp` to
//! `drill`, is `!clamp !drill`: whichever of both it is in after the rung, it was in one before. An
//! "or" is an "and" of what its operands are not.

use std::collections::HashMap;

use super::rebuild::rebuild;
use crate::circuit::{Cell, Circuit, Net, Op, Operands};

/// How many bits an "and" may have, with those that its operands consist of.
const LITERALS: usize = 16;
/// How deep operands are looked into, to see what they consist of or what they are.
const DEPTH: u32 = 2;

/// The circuit with shorter conditions, if there are any.
pub fn absorb(circuit: &Circuit) -> Option<Circuit> {
    let shorter: HashMap<Net, Vec<Literal>> =
        circuit.cells().filter_map(|(net, cell)| Some((net, shorter(circuit, cell)?))).collect();
    if shorter.is_empty() {
        return None;
    }
    Some(rebuild(circuit, |rebuild, net, cell| {
        let Some(literals) = shorter.get(&net) else { return rebuild.copy(cell) };
        let is_and = matches!(cell.op, Op::And(_));
        let mut operands = Vec::new();
        for literal in literals {
            let operand = rebuild.net(literal.net);
            let is_inverted = literal.bit != is_and;
            operands.push(if is_inverted { rebuild.to.not(operand) } else { operand });
        }
        if is_and { rebuild.to.and(operands) } else { rebuild.to.or(operands) }
    }))
}

/// A net that is that bit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Literal {
    net: Net,
    bit: bool,
}

/// What a cell can say instead with no more operands.
fn shorter(circuit: &Circuit, cell: Cell) -> Option<Vec<Literal>> {
    let (list, bit) = match cell {
        Cell { op: Op::And(list), width: 1 } => (circuit.list(list), true),
        Cell { op: Op::Or(list), width: 1 } => (circuit.list(list), false),
        _ => return None,
    };
    let is_gate = |&net: &Net| match circuit.cell(net).op {
        Op::Not(from) => is_list(circuit, from),
        _ => is_list(circuit, net),
    };
    if list.len() > LITERALS || !list.iter().any(is_gate) {
        return None;
    }
    let mut said = Conjunction { circuit, parts: Vec::new(), is_whole: vec![true; list.len()] };
    for (operand, &net) in list.iter().enumerate() {
        said.add(operand, Literal { net, bit }, DEPTH);
    }
    if !said.reduce() {
        return None;
    }
    let mut literals = Vec::new();
    for (operand, &net) in list.iter().enumerate() {
        if said.is_whole[operand] {
            literals.push(Literal { net, bit });
        } else {
            let parts = said.parts.iter().filter(|part| part.operand == operand);
            literals.extend(parts.map(|part| part.literal));
        }
    }
    (1..=list.len()).contains(&literals.len()).then_some(literals)
}

fn is_list(circuit: &Circuit, net: Net) -> bool {
    matches!(circuit.cell(net).op, Op::And(_) | Op::Or(_))
}

/// Bits that are all as they are said to be: what an "and" says where it is 1, and an "or" where
/// it is 0.
struct Conjunction<'c> {
    circuit: &'c Circuit,
    parts: Vec<Part>,
    /// For each operand, whether its parts are all there as they were.
    is_whole: Vec<bool>,
}

/// Something that an operand says.
#[derive(Clone, Copy)]
struct Part {
    operand: usize,
    literal: Literal,
}

impl Conjunction<'_> {
    /// Adds what a literal consists of, as far as it is new.
    fn add(&mut self, operand: usize, literal: Literal, depth: u32) {
        let Literal { net, bit } = literal;
        match self.circuit.cell(net).op {
            Op::Not(from) => self.add(operand, Literal { net: from, bit: !bit }, depth),
            Op::And(list) | Op::Or(list)
                if depth > 0 && !self.is_choice(literal) && self.is_short(list) =>
            {
                for &net in self.circuit.list(list) {
                    self.add(operand, Literal { net, bit }, depth - 1);
                }
            }
            _ if self.parts.iter().any(|part| part.literal == literal) => {
                self.is_whole[operand] = false;
            }
            // One too many, and it is given up.
            _ if self.parts.len() <= LITERALS => self.parts.push(Part { operand, literal }),
            _ => {}
        }
    }

    fn is_short(&self, list: Operands) -> bool {
        self.circuit.list(list).len() <= LITERALS
    }

    /// True if one of its operands is enough for what a literal says.
    fn is_choice(&self, Literal { net, bit }: Literal) -> bool {
        match self.circuit.cell(net).op {
            Op::And(_) => !bit,
            Op::Or(_) => bit,
            _ => false,
        }
    }

    /// Drops literals that follow from the others, and says the rest of those that follow but for
    /// one operand. True if something is said twice.
    fn reduce(&mut self) -> bool {
        let mut at = 0;
        while at < self.parts.len() {
            if self.parts.len() > LITERALS {
                return false;
            }
            let Part { operand, literal } = self.parts[at];
            match self.left(at, literal) {
                Left::All => at += 1,
                left => {
                    self.is_whole[operand] = false;
                    self.parts.remove(at);
                    if let Left::One(net) = left {
                        self.add(operand, Literal { net, bit: literal.bit }, DEPTH);
                    }
                    // What was looked at before may follow now.
                    at = 0;
                }
            }
        }
        self.is_whole.contains(&false)
    }

    /// What a literal still says next to the others.
    fn left(&self, at: usize, literal: Literal) -> Left {
        let (Op::And(list) | Op::Or(list)) = self.circuit.cell(literal.net).op else {
            return Left::All;
        };
        if !self.is_choice(literal) || !self.is_short(list) {
            return Left::All;
        }
        let mut open = None;
        let mut is_one = true;
        for &net in self.circuit.list(list) {
            match self.known(at, net, DEPTH) {
                Some(bit) if bit == literal.bit => return Left::Nothing,
                Some(_) => {}
                None => {
                    is_one &= open.is_none();
                    open = Some(net);
                }
            }
        }
        match open {
            Some(net) if is_one => Left::One(net),
            _ => Left::All,
        }
    }

    /// The bit that a net is where all literals but one hold.
    fn known(&self, but: usize, net: Net, depth: u32) -> Option<bool> {
        let mut others = self.parts.iter().enumerate().filter(|(at, _)| *at != but);
        if let Some((_, other)) = others.find(|(_, part)| part.literal.net == net) {
            return Some(other.literal.bit);
        }
        let (list, decides) = match self.circuit.cell(net).op {
            Op::Not(from) => return self.known(but, from, depth).map(|bit| !bit),
            Op::And(list) => (list, false),
            Op::Or(list) => (list, true),
            _ => return None,
        };
        if depth == 0 || !self.is_short(list) {
            return None;
        }
        let mut all = Some(!decides);
        for &net in self.circuit.list(list) {
            match self.known(but, net, depth - 1) {
                Some(bit) if bit == decides => return Some(decides),
                Some(_) => {}
                None => all = None,
            }
        }
        all
    }
}

/// What is left of a literal next to others.
enum Left {
    /// All that it says.
    All,
    /// What it says of that net.
    One(Net),
    /// Nothing new.
    Nothing,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::circuit::passes::gates::assert_held;

    #[test]
    fn every_output_is_what_it_was() {
        assert_held(absorb);
    }

    /// Two steps, the first of which may go over to the second in this scan.
    #[test]
    fn a_part_that_moved_on_is_still_there() {
        let mut circuit = Circuit::new("steps");
        let [first, second, done] = ["first", "second", "done"].map(|name| circuit.input(name, 1));
        let power = circuit.and([first, done]);
        let stays = circuit.not(power);
        let first_after = circuit.and([first, stays]);
        let second_after = circuit.or([power, second]);
        let [no_first, no_second] = [first_after, second_after].map(|net| circuit.not(net));
        let idle = circuit.and([no_first, no_second]);
        circuit.output("idle", idle);
        let literal = |net| Literal { net, bit: false };
        assert_eq!(
            shorter(&circuit, circuit.cell(idle)),
            Some([first, second].map(literal).into())
        );
    }
}
