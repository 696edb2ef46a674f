//! Runs the tests of a program.

use super::{Evaluator, Failure, Machine, conducts, explain};
use crate::model::{Place, Program, Statement, Test};

/// How a test ended.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// Every expectation held.
    Passed,
    /// An expectation did not hold; the test ended there.
    Failed(Failure),
}

/// Runs one test on the evaluator from reset, up to the first expectation that does not hold.
pub fn run_test(program: &Program, test: &Test) -> Outcome {
    run_test_on(&mut Evaluator::new(program), program, test)
}

/// Runs one test on a machine, in the same way.
pub fn run_test_on(machine: &mut impl Machine, program: &Program, test: &Test) -> Outcome {
    machine.reset();
    match run(machine, program, &test.statements) {
        Ok(()) => Outcome::Passed,
        Err(failure) => Outcome::Failed(failure),
    }
}

fn run(
    machine: &mut impl Machine,
    program: &Program,
    statements: &[Statement],
) -> Result<(), Failure> {
    for statement in statements {
        match statement {
            Statement::Drive(input, value) => drive(machine, program, input, *value),
            Statement::Scan(scans) => (0..*scans).for_each(|_| machine.scan(false)),
            Statement::Wait(ticks) => (0..*ticks).for_each(|_| machine.scan(true)),
            Statement::Repeat(times, statements) => {
                for _ in 0..*times {
                    run(machine, program, statements)?;
                }
            }
            Statement::Reset => machine.reset(),
            Statement::Expect(expect) => {
                let read = |variable| machine.value(variable);
                for (index, element) in expect.network.iter().enumerate() {
                    if !conducts(element, &read) {
                        return Err(explain(program, expect, index, read));
                    }
                }
            }
        }
    }
    Ok(())
}

/// Drives an input or a bit of one.
fn drive(machine: &mut impl Machine, program: &Program, input: &Place, value: i64) {
    let variable = input.declared();
    let value = match input.bit {
        None => value,
        Some(bit) => {
            let others = machine.value(variable) & !(1 << bit);
            program.variables[variable].ty.wrap(others | value << bit)
        }
    };
    machine.drive(variable, value);
}
