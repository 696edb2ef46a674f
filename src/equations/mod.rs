//! The program as equations: what every coil, assignment and call takes, in the order of the
//! text. Each read names the write that it sees, so the order of evaluation is in the equations
//! themselves.

mod chain;
mod dataflow;
mod expression;
mod graph;
mod lower;
mod networks;
mod write;

use std::sync::Arc;

use la_arena::{Arena, Idx};

use crate::blocks::Shape;
use crate::model::{BinaryOp, Function, InstanceId, Relation, VariableId};
use crate::types::Type;

pub use chain::Chain;
pub use dataflow::{Change, Order, by_dataflow};
pub use graph::{Dependency, Graph, Kind, Resource};
pub use lower::{lower, lower_expectation};

/// An expression of the equations.
pub type ExprId = Idx<Expr>;
/// Index of a step in [`Equations::steps`].
pub type StepId = u32;

/// All equations of a program. Operands stand before their users, and an expression stands behind
/// the steps that write what it reads.
#[derive(Debug, Default)]
pub struct Equations {
    /// The expressions.
    pub exprs: Arena<Expr>,
    /// The steps in text order.
    pub steps: Vec<Step>,
    operands: Vec<ExprId>,
}

/// A typed expression.
#[derive(Clone, Copy, Debug)]
pub struct Expr {
    /// What it computes.
    pub op: ExprOp,
    /// The type of its value.
    pub ty: Type,
}

/// A run of operands.
#[derive(Clone, Copy, Debug)]
pub struct Operands {
    start: u32,
    len: u32,
}

/// What an expression computes.
#[derive(Clone, Copy, Debug)]
pub enum ExprOp {
    /// A value in the range of the type.
    Constant(i64),
    /// The value that a step of this scan wrote, or, without one, that the last scan left.
    Read {
        /// What is read.
        variable: VariableId,
        /// Who wrote it.
        writer: Option<StepId>,
    },
    /// Every bit inverted.
    Not(ExprId),
    /// Contacts in series: 1 if all are.
    All(Operands),
    /// Branches in parallel: 1 if one is.
    Any(Operands),
    /// One value or the other.
    Select {
        /// A `BOOL`.
        power: ExprId,
        /// The value for 1.
        on: ExprId,
        /// The value for 0.
        off: ExprId,
    },
    /// An operation on two values. Their types are those that [`crate::model::ExprKind::Binary`]
    /// says.
    Binary(BinaryOp, ExprId, ExprId),
    /// A comparison of two values of one type.
    Compare(Relation, ExprId, ExprId),
    /// A function of values. Their types are those that [`crate::model::ExprKind::Call`] says.
    Call(Function, Operands),
    /// The value of another type, as [`crate::model::convert`] says.
    Convert(ExprId),
    /// A bit of a value.
    Bit(ExprId, u32),
    /// A value with one bit replaced.
    WithBit {
        /// The other bits.
        whole: ExprId,
        /// Which bit.
        bit: u32,
        /// A `BOOL`.
        value: ExprId,
    },
    /// The element of an index; 0 if there is none.
    Element {
        /// Of an integer type.
        index: ExprId,
        /// All elements.
        elements: Operands,
    },
}

/// Something that changes the program's state.
#[derive(Debug)]
pub struct Step {
    /// What it does.
    pub kind: StepKind,
    /// Index of the rung that it stands in; [`Step::NO_RUNG`] for what comes before them all.
    pub rung: u32,
    /// The number of expressions made before it: what it may use, and what was made since the
    /// last step reads what was there before it.
    pub exprs: u32,
}

impl Step {
    /// The rung of a step that no rung asks for: a unit of time.
    pub const NO_RUNG: u32 = u32::MAX;
}

/// What a step does.
#[derive(Debug)]
pub enum StepKind {
    /// Writes a variable.
    Assign {
        /// Of role output, local, edge memory, first scan, or a block's parameter.
        target: VariableId,
        /// Of its type.
        value: ExprId,
    },
    /// Calls a block instance: writes its outputs and the parameters that are given.
    Call {
        /// Which one.
        instance: InstanceId,
        /// What is called on it.
        shape: Arc<Shape>,
        /// The power that arrives.
        power: ExprId,
        /// The given parameters by the index of their port.
        arguments: Vec<(usize, ExprId)>,
    },
    /// Puts the outputs of an instance back to their start where the power is 1.
    Reset {
        /// Which one.
        instance: InstanceId,
        /// The power that arrives.
        power: ExprId,
    },
}

impl Equations {
    /// Calls `tell` with each operand of an expression.
    pub fn operands_of(&self, expr: ExprId, mut tell: impl FnMut(ExprId)) {
        match self.exprs[expr].op {
            ExprOp::Constant(_) | ExprOp::Read { .. } => {}
            ExprOp::Not(operand) | ExprOp::Convert(operand) | ExprOp::Bit(operand, _) => {
                tell(operand);
            }
            ExprOp::All(operands) | ExprOp::Any(operands) | ExprOp::Call(_, operands) => {
                self.list(operands).iter().for_each(|&operand| tell(operand));
            }
            ExprOp::WithBit { whole, value, .. } => [whole, value].into_iter().for_each(tell),
            ExprOp::Element { index, elements } => {
                tell(index);
                self.list(elements).iter().for_each(|&element| tell(element));
            }
            ExprOp::Select { power, on, off } => [power, on, off].into_iter().for_each(tell),
            ExprOp::Binary(_, a, b) | ExprOp::Compare(_, a, b) => [a, b].into_iter().for_each(tell),
        }
    }

    /// The expressions that a step takes.
    pub fn taken_by(&self, step: StepId) -> Vec<ExprId> {
        match &self.steps[step as usize].kind {
            StepKind::Assign { value, .. } => vec![*value],
            StepKind::Call { power, arguments, .. } => {
                let arguments = arguments.iter().map(|&(_, value)| value);
                [*power].into_iter().chain(arguments).collect()
            }
            StepKind::Reset { power, .. } => vec![*power],
        }
    }

    /// The operands of an `All`, an `Any` or a call, or the elements of an array.
    pub fn list(&self, operands: Operands) -> &[ExprId] {
        &self.operands[operands.start as usize..][..operands.len as usize]
    }
}
