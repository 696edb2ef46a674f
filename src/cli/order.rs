//! `--order`

use clap::ValueEnum;
use hotrail::equations::{self, Order as Changes};
use hotrail::model::Program;

/// In which order the rungs act.
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// As they stand in the text
    Text,
    /// Each behind those that write what it reads; this changes what the program means
    Dataflow,
}

impl Order {
    /// Puts the rungs of a program into the order and says what that changes, unless it is that of
    /// the text.
    pub fn apply(self, program: &mut Program) -> Option<Changes> {
        match self {
            Order::Text => None,
            Order::Dataflow => Some(equations::by_dataflow(program)),
        }
    }
}
