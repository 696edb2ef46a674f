//! The longest way of a signal in one scan, which the clock must be slow enough for.

use super::{Equations, ExprId, ExprOp, StepKind};
use crate::index::index;
use crate::model::{BinaryOp, Function, Program};

/// The longest chain of gates from a register or an input to a register, in the circuit that
/// runs a scan in one clock. It is an estimate: synthesis merges some gates and splits others.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Chain {
    /// Its length, each gate of up to four inputs as 1, an adder or a comparison by its width.
    pub gates: u32,
    /// Indexes of the rungs that it passes, each once, in text order.
    pub rungs: Vec<u32>,
}

impl Chain {
    /// About what it takes in a fast small FPGA and in a slow one, in nanoseconds. By nextpnr six
    /// timers in a row, 215 gates, take 85 ns in an iCE40 HX8K and 219 ns in an iCE40 UP5K.
    pub fn ns(&self) -> [u64; 2] {
        [u64::from(self.gates).div_ceil(2), self.gates.into()]
    }
}

/// What a block may have between its inputs and its outputs: a choice and a comparison with its
/// preset.
const THROUGH_BLOCK: u32 = 32;
/// The same from its registers, where the adder of a counter comes before that.
const IN_BLOCK: u32 = 50;

/// How far a value is from the registers, and where the longest way comes from.
#[derive(Clone, Copy, Default)]
struct Reach {
    gates: u32,
    /// The rung in which the value is made.
    rung: u32,
    /// Number of the value from which the longest way comes.
    from: Option<u32>,
}

impl Chain {
    /// The longest chain of a program; the first one of several.
    pub fn new(program: &Program, equations: &Equations) -> Self {
        let exprs = equations.exprs.len();
        // Expressions by their number, then what steps make.
        let mut reaches = vec![Reach::default(); exprs + equations.steps.len()];
        let mut ids = equations.exprs.iter().map(|(id, _)| id);
        let mut made = 0;
        for (number, step) in equations.steps.iter().enumerate() {
            for id in ids.by_ref().take((step.exprs - made) as usize) {
                reaches[index(id)] = equations.reach(&reaches, id, step.rung);
            }
            made = step.exprs;
            let taken = equations.taken_by(number as u32);
            let (cost, own) = match step.kind {
                StepKind::Assign { .. } => (0, 0),
                StepKind::Call { .. } => (THROUGH_BLOCK, IN_BLOCK),
                StepKind::Reset { .. } => (1, 0),
            };
            let behind = behind(&reaches, taken, cost, step.rung);
            let own = Reach { gates: own, rung: step.rung, from: None };
            reaches[exprs + number] = if own.gates > behind.gates { own } else { behind };
        }
        let ends = exprs..reaches.len();
        let longest = ends.rev().max_by_key(|&end| reaches[end].gates);
        let Some(longest) = longest else { return Chain::default() };
        let mut rungs = Vec::new();
        let mut at = Some(longest as u32);
        while let Some(number) = at {
            rungs.push(reaches[number as usize].rung);
            at = reaches[number as usize].from;
        }
        rungs.retain(|&rung| (rung as usize) < program.rungs.len());
        rungs.sort_unstable();
        rungs.dedup();
        Chain { gates: reaches[longest].gates, rungs }
    }
}

/// The way behind the furthest of some values.
fn behind(reaches: &[Reach], taken: Vec<ExprId>, cost: u32, rung: u32) -> Reach {
    let from = taken.into_iter().map(index).rev().max_by_key(|&one| reaches[one].gates);
    let gates = from.map_or(0, |from| reaches[from].gates);
    let from = from.filter(|_| gates > 0).map(|from| from as u32);
    Reach { gates: gates + cost, rung, from }
}

impl Equations {
    fn reach(&self, reaches: &[Reach], id: ExprId, rung: u32) -> Reach {
        if let ExprOp::Read { writer, .. } = self.exprs[id].op {
            let Some(step) = writer else { return Reach { rung, ..Reach::default() } };
            let from = self.exprs.len() + step as usize;
            let gates = reaches[from].gates;
            return Reach { gates, rung: reaches[from].rung, from: Some(from as u32) };
        }
        let mut taken = Vec::new();
        self.operands_of(id, |operand| taken.push(operand));
        behind(reaches, taken, self.gates(id), rung)
    }

    /// About how many gates in a row an operation is.
    fn gates(&self, id: ExprId) -> u32 {
        let width = |expr: ExprId| self.exprs[expr].ty.width();
        match self.exprs[id].op {
            ExprOp::Constant(_)
            | ExprOp::Read { .. }
            | ExprOp::Not(_)
            | ExprOp::Convert(_)
            | ExprOp::Bit(..)
            | ExprOp::WithBit { .. } => 0,
            ExprOp::All(list) | ExprOp::Any(list) => fan_in(self.list(list).len()),
            ExprOp::Select { .. } => 1,
            ExprOp::Binary(op, a, _) => match op {
                BinaryOp::And | BinaryOp::Or | BinaryOp::Xor => 1,
                BinaryOp::Add | BinaryOp::Subtract => carry(width(a)),
                // A tree of adders; a row of subtractions, each with a choice.
                BinaryOp::Multiply => 4 * carry(width(a)),
                BinaryOp::Divide | BinaryOp::Modulo => width(a) * (carry(width(a)) + 1),
            },
            ExprOp::Compare(_, a, _) => carry(width(a)),
            ExprOp::Call(function, list) => {
                let list = self.list(list);
                match function {
                    Function::Select => 1,
                    Function::Abs => carry(width(id)) + 1,
                    Function::Min | Function::Max | Function::Limit => {
                        (list.len() as u32 - 1) * (carry(width(id)) + 1)
                    }
                    // A choice for each bit of the amount.
                    Function::ShiftLeft
                    | Function::ShiftRight
                    | Function::RotateLeft
                    | Function::RotateRight => match self.exprs[list[1]].op {
                        ExprOp::Constant(_) => 0,
                        _ => width(id).ilog2() + 2,
                    },
                }
            }
            ExprOp::Element { elements, .. } => 2 + fan_in(self.list(elements).len()),
        }
    }
}

/// Gates of four inputs in a row for so many inputs.
fn fan_in(inputs: usize) -> u32 {
    let mut levels = 1;
    let mut reached = 4;
    while reached < inputs {
        reached *= 4;
        levels += 1;
    }
    levels
}

/// A carry runs through some three bits in the time of a gate.
fn carry(width: u32) -> u32 {
    2 + width / 3
}
