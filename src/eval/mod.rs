//! The reference: what a program means, worked out as a PLC does it, and its tests run on that.

mod evaluator;
mod expectation;
mod machine;
mod runner;
#[cfg(feature = "cli")]
mod stimulus;

pub use evaluator::Evaluator;
pub use expectation::{Failure, conducts, explain, variables_of, variables_of_tests};
pub use machine::Machine;
pub use runner::{Outcome, run_test, run_test_on};
#[cfg(feature = "cli")]
pub use stimulus::{Row, Stimulus, TICK};
