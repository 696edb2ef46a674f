//! The reference: what a program means, worked out as a PLC does it, and its tests run on that.

mod evaluator;
mod expectation;
mod runner;

pub use evaluator::Evaluator;
pub use expectation::{Failure, explain, variables_of};
pub use runner::{Outcome, run_test};
