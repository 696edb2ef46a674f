//! Runs the tests of a program.

use super::{Evaluator, Failure, Machine, Moment, conducts, explain};
use crate::model::{Expect, Place, Program, Statement, Test};

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
    let mut run = Run { machine, program, moment: Moment::default() };
    match run.statements(&test.statements) {
        Ok(()) => Outcome::Passed,
        Err(failure) => Outcome::Failed(Failure { moment: Some(run.moment), ..failure }),
    }
}

/// A test on its way.
struct Run<'r, M> {
    machine: &'r mut M,
    program: &'r Program,
    /// Stays where it is when an expectation fails.
    moment: Moment,
}

impl<M: Machine> Run<'_, M> {
    fn statements(&mut self, statements: &[Statement]) -> Result<(), Failure> {
        for statement in statements {
            match statement {
                Statement::Drive(input, value) => {
                    drive(self.machine, self.program, input, *value);
                }
                Statement::Scan(scans) => self.scans(*scans, false),
                Statement::Wait(ticks) => self.scans(*ticks, true),
                Statement::Repeat(times, statements) => {
                    for turn in 1..=*times {
                        self.moment.turns.push((turn, *times));
                        self.statements(statements)?;
                        self.moment.turns.pop();
                    }
                }
                Statement::Reset => self.machine.reset(),
                Statement::Expect(expect) => self.expect(expect)?,
            }
        }
        Ok(())
    }

    fn scans(&mut self, scans: u64, tick: bool) {
        (0..scans).for_each(|_| self.machine.scan(tick));
        self.moment.scans += scans;
    }

    fn expect(&self, expect: &Expect) -> Result<(), Failure> {
        let read = |variable| self.machine.value(variable);
        for (index, element) in expect.network.iter().enumerate() {
            if !conducts(element, &read) {
                return Err(explain(self.program, expect, index, read));
            }
        }
        Ok(())
    }
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
