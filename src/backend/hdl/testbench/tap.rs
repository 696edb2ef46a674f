//! Reads back what a testbench has printed in a simulator.

use crate::eval::{Failure, Outcome, explain, variables_of};
use crate::model::{Expect, Program, VariableId};

/// How the tests ended, in their order; `None` if the output does not tell it of every test.
pub fn outcomes(program: &Program, output: &str) -> Option<Vec<Outcome>> {
    let expectations = super::expectations(program);
    let mut outcomes = Vec::new();
    let mut failure = None;
    for line in output.lines() {
        if let Some(report) = line.strip_prefix(super::FAILED) {
            failure = Some(read_failure(program, &expectations, report)?);
        } else if line.starts_with("ok ") {
            outcomes.push(Outcome::Passed);
        } else if line.starts_with("not ok ") {
            outcomes.push(Outcome::Failed(failure.take()?));
        }
    }
    (outcomes.len() == program.tests.len()).then_some(outcomes)
}

/// Reads `3 conducts 01 motor=0 lamp=1 at start_stop.ladder:15`.
fn read_failure(program: &Program, expectations: &[&Expect], report: &str) -> Option<Failure> {
    let mut words = report.split_whitespace();
    let expect = expectations.get(words.next()?.parse::<usize>().ok()?)?;
    let element = words.nth(1)?.find(|conducts| conducts != '1')?;
    let values: Vec<u64> = words
        .take_while(|&word| word != "at")
        .map(|word| u64::from_str_radix(word.rsplit_once('=')?.1, 2).ok())
        .collect::<Option<_>>()?;
    let variables = variables_of(&expect.network);
    if variables.len() != values.len() {
        return None;
    }
    let value = |variable: VariableId| {
        let at = variables.iter().position(|&other| other == variable);
        at.map_or(0, |at| program.variables[variable].ty.wrap(values[at] as i64))
    };
    Some(explain(program, expect, element, value))
}
