//! Which words a net can be, in every scan after reset: an abstract interpretation on intervals.
//!
//! The registers start with the interval of their reset value. It grows by what their next values
//! can be, until nothing grows any more. So every interval holds at reset and after each scan,
//! whatever the inputs are.

mod assumptions;
mod interval;

use std::collections::{HashMap, HashSet};

pub use assumptions::Assumptions;
pub use interval::Interval;

use super::{Circuit, Net, Op, RegisterId, mask};
use crate::index::index;

/// How often the interval of one register may grow before it is given up.
const GROWTHS: u32 = 16;
/// How many rounds over all registers there are; what still grows then is given up.
const ROUNDS: u32 = 64;
/// How far a register's next value is searched for the constants that may bound it.
const SEARCH: usize = 300;

/// What each net of a circuit can be.
#[derive(Debug)]
pub struct Ranges {
    /// Words and comparisons; a net that is missing can be anything.
    nets: HashMap<Net, Interval>,
}

/// The bits from the highest that is set in `number` down.
fn filled(number: u64) -> u64 {
    if number == 0 { 0 } else { mask(64 - number.leading_zeros()) }
}

impl Ranges {
    /// Finds the intervals.
    pub fn of(circuit: &Circuit) -> Self {
        let analysis = Analysis::new(circuit);
        Ranges { nets: analysis.run() }
    }

    /// True if the circuit has no words: a bit can be 0 and 1.
    pub fn is_empty(&self) -> bool {
        self.nets.is_empty()
    }

    /// What a net can be.
    pub fn interval(&self, circuit: &Circuit, net: Net) -> Interval {
        self.assumptions(circuit).interval(net)
    }

    /// What the value of a register, whose net `word` is, can be in the scans in which the one of
    /// a flag is 1, if both take their next values at the same clocks. Nothing if they do not, if
    /// the flag is never 1, or if too much is possible.
    pub fn interval_while(&self, circuit: &Circuit, word: Net, flag: Net) -> Option<Interval> {
        let (Op::Register(id), Op::Register(flag_id)) =
            (circuit.cell(word).op, circuit.cell(flag).op)
        else {
            return None;
        };
        let (register, flag_register) = (&circuit.registers[id], &circuit.registers[flag_id]);
        if register.enable != flag_register.enable {
            return None;
        }
        let comes_on = flag_register.next;
        // What it takes where the flag is now that bit, and will be on.
        let next = |now: bool, interval: Interval| {
            let next = self.assumptions(circuit).where_in(word, interval, |under| {
                under.under(flag, now, |under| {
                    under.under(comes_on, true, |under| under.interval(register.next))
                })
            });
            next.flatten().flatten()
        };
        // The flag may come on and go off at numbers that do not move the word.
        let marks = marks(circuit, &[id, flag_id]);
        let is_on = flag_register.reset == 1;
        let reset = is_on.then(|| Interval::bits(register.reset, register.width));
        let start = next(false, self.interval(circuit, word));
        let mut interval = join(reset, start)?;
        for _ in 0..GROWTHS {
            match next(true, interval) {
                Some(next) if !interval.contains(next) => interval = interval.widen(next, &marks),
                _ => return Some(interval),
            }
        }
        None
    }

    /// To ask what a net can be under conditions.
    pub fn assumptions<'a>(&'a self, circuit: &'a Circuit) -> Assumptions<'a> {
        Assumptions::new(circuit, &self.nets)
    }
}

fn join(a: Option<Interval>, b: Option<Interval>) -> Option<Interval> {
    match (a, b) {
        (Some(a), Some(b)) => Some(a.join(b)),
        (a, b) => a.or(b),
    }
}

/// A word register on its way to its interval.
struct Growing {
    id: RegisterId,
    net: Net,
    interval: Interval,
    marks: Vec<i128>,
    growths: u32,
}

struct Analysis<'c> {
    circuit: &'c Circuit,
    /// Words that are computed, and comparisons of words, in order.
    cells: Vec<Net>,
    registers: Vec<Growing>,
    nets: HashMap<Net, Interval>,
}

impl<'c> Analysis<'c> {
    fn new(circuit: &'c Circuit) -> Self {
        let (mut cells, mut registers) = (Vec::new(), Vec::new());
        for (net, cell) in circuit.cells() {
            match cell.op {
                Op::Register(id) if cell.width > 1 => {
                    let reset = Interval::bits(circuit.registers[id].reset, cell.width);
                    let marks = marks(circuit, &[id]);
                    registers.push(Growing { id, net, interval: reset, marks, growths: 0 });
                }
                Op::Input(_) | Op::Register(_) | Op::Port(..) | Op::Const(_) => {}
                Op::Eq(..) | Op::Less { .. } => cells.push(net),
                Op::Not(_)
                | Op::And(_)
                | Op::Or(_)
                | Op::Xor(..)
                | Op::Mux { .. }
                | Op::Add(..)
                | Op::Sub(..)
                | Op::Mul(..)
                | Op::Div(..)
                | Op::Rem(..)
                | Op::Extend { .. }
                | Op::Slice { .. }
                | Op::Concat(_) => {
                    if cell.width > 1 {
                        cells.push(net);
                    }
                }
            }
        }
        Analysis { circuit, cells, registers, nets: HashMap::new() }
    }

    fn run(mut self) -> HashMap<Net, Interval> {
        let mut round = 0;
        while self.grow() {
            round += 1;
            if round == ROUNDS {
                for register in &mut self.registers {
                    register.interval = Interval::full(self.circuit.width(register.net));
                }
            }
        }
        self.shrink();
        self.nets
    }

    /// Lets every register grow by what its next value can be. False if none did: every interval
    /// then holds the reset value and, as long as all of them hold, the next value.
    fn grow(&mut self) -> bool {
        self.evaluate();
        let mut grew = false;
        for at in 0..self.registers.len() {
            let next = self.next_of(at);
            let register = &mut self.registers[at];
            if register.interval.contains(next) {
                continue;
            }
            register.growths += 1;
            register.interval = match register.growths > GROWTHS {
                true => Interval::full(self.circuit.width(register.net)),
                false => register.interval.widen(next, &register.marks),
            };
            grew = true;
        }
        grew
    }

    /// Takes back what the steps were too long, if what is left holds by itself.
    fn shrink(&mut self) {
        let grown: Vec<Interval> =
            self.registers.iter().map(|register| register.interval).collect();
        for at in 0..self.registers.len() {
            let next = self.next_of(at);
            let Growing { id, interval, .. } = &mut self.registers[at];
            let register = &self.circuit.registers[*id];
            let smaller = Interval::bits(register.reset, register.width).join(next);
            if interval.contains(smaller) {
                *interval = smaller;
            }
        }
        self.evaluate();
        let holds = (0..self.registers.len())
            .all(|at| self.registers[at].interval.contains(self.next_of(at)));
        if !holds {
            for (register, grown) in self.registers.iter_mut().zip(grown) {
                register.interval = grown;
            }
            self.evaluate();
        }
    }

    /// Computes every cell from what the registers can be.
    fn evaluate(&mut self) {
        self.nets.clear();
        for register in &self.registers {
            self.nets.insert(register.net, register.interval);
        }
        for &net in &self.cells {
            let interval = Assumptions::new(self.circuit, &self.nets).interval(net);
            self.nets.insert(net, interval);
        }
    }

    fn next_of(&self, at: usize) -> Interval {
        let next = self.circuit.registers[self.registers[at].id].next;
        Assumptions::new(self.circuit, &self.nets).interval(next)
    }
}

/// Numbers at which a register may stop: the constants that next values are computed with, and
/// their neighbours.
fn marks(circuit: &Circuit, registers: &[RegisterId]) -> Vec<i128> {
    let mut marks = Vec::new();
    let mut seen = HashSet::new();
    let mut open: Vec<Net> = registers.iter().map(|&id| circuit.registers[id].next).collect();
    while let Some(net) = open.pop() {
        if seen.len() == SEARCH || !seen.insert(index(net)) {
            continue;
        }
        let cell = circuit.cell(net);
        if let Op::Const(bits) = cell.op {
            let constant = Interval::bits(bits, cell.width);
            let numbers = [constant.bounds(false).0, constant.bounds(true).0];
            marks.extend(numbers.iter().flat_map(|number| [number - 1, *number, number + 1]));
        }
        if let Op::Extend { from, .. } = cell.op {
            let narrow = Interval::full(circuit.width(from));
            let ((lowest, highest), (_, most)) = (narrow.bounds(true), narrow.bounds(false));
            marks.extend([lowest, highest, 0, most]);
        }
        circuit.for_each_operand(cell, |operand| open.push(operand));
    }
    marks.sort_unstable();
    marks.dedup();
    marks
}
