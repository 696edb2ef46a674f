//! The reference: what a program means, worked out as a PLC does it, and its tests run on that.

mod evaluator;
mod expectation;
mod flow;
mod machine;
mod recorder;
mod runner;
mod scene;
#[cfg(feature = "cli")]
mod stimulus;
mod why;

pub use evaluator::Evaluator;
pub use expectation::{
    Failure, Moment, conducts, explain, variables_of, variables_of_test, variables_of_tests,
};
pub use flow::{Flow, Reading, Seen, value_text};
pub use machine::{Machine, Row};
pub use runner::{Outcome, run_test, run_test_on};
#[cfg(feature = "cli")]
pub use stimulus::{Stimulus, TICK};
pub use why::{Cause, Looked, Place, Power, Reason, ShownRung, Subject, Why};
