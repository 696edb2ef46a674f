//! Runs the tests of a program on the evaluator.

use super::{Evaluator, Failure, explain};
use crate::model::{Program, Statement, Test};

/// How a test ended.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// Every expectation held.
    Passed,
    /// An expectation did not hold; the test ended there.
    Failed(Failure),
}

/// Runs one test from reset, up to the first expectation that does not hold.
pub fn run_test(program: &Program, test: &Test) -> Outcome {
    match run(program, &mut Evaluator::new(program), &test.statements) {
        Ok(()) => Outcome::Passed,
        Err(failure) => Outcome::Failed(failure),
    }
}

fn run(
    program: &Program,
    evaluator: &mut Evaluator<'_>,
    statements: &[Statement],
) -> Result<(), Failure> {
    for statement in statements {
        match statement {
            Statement::Drive(input, value) => evaluator.drive_place(input, *value),
            Statement::Scan(scans) => (0..*scans).for_each(|_| evaluator.scan(false)),
            Statement::Wait(ticks) => (0..*ticks).for_each(|_| evaluator.scan(true)),
            Statement::Repeat(times, statements) => {
                for _ in 0..*times {
                    run(program, evaluator, statements)?;
                }
            }
            Statement::Reset => evaluator.reset(),
            Statement::Expect(expect) => {
                for (index, element) in expect.network.iter().enumerate() {
                    if !evaluator.conducts(std::slice::from_ref(element)) {
                        return Err(explain(program, expect, index, |v| evaluator.value(v)));
                    }
                }
            }
        }
    }
    Ok(())
}
