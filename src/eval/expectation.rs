//! Why an expectation does not hold: the contact that does not conduct, with its value.

use crate::model::{Element, Expect, Expr, ExprKind, Program, Series, Statement, VariableId};
use crate::source::Span;
use crate::types::Type;

/// An expectation that does not hold.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Failure {
    /// The element of the outermost series that does not conduct.
    pub span: Span,
    /// What its contacts see, such as `motor is 0`.
    pub text: String,
}

/// True if an element of an expectation conducts, given the values that it looks at.
pub fn conducts(element: &Element, read: &impl Fn(VariableId) -> i64) -> bool {
    match element {
        Element::Constant(value) => *value,
        Element::Contact { variable, negated, .. } => (read(*variable) != 0) != *negated,
        Element::Compare(expr, _) => expr.value(read) != 0,
        Element::Parallel(branches) => {
            branches.iter().any(|branch| branch.iter().all(|element| conducts(element, read)))
        }
        Element::Edge { .. }
        | Element::OneShot { .. }
        | Element::Invert
        | Element::Coil { .. }
        | Element::ResetInstance(_)
        | Element::Assign { .. }
        | Element::Call(_)
        | Element::Net(_) => unreachable!("an expectation only looks"),
    }
}

/// The variables that a network reads, each once, in text order.
pub fn variables_of(network: &Series) -> Vec<VariableId> {
    let mut all = Vec::new();
    network.iter().for_each(|element| element_variables(element, &mut all));
    let mut seen = std::collections::HashSet::new();
    all.retain(|&variable| seen.insert(variable));
    all
}

/// The variables that the expectations of a program read, in text order.
pub fn variables_of_tests(program: &Program) -> Vec<VariableId> {
    fn walk(statements: &[Statement], all: &mut Vec<VariableId>) {
        for statement in statements {
            match statement {
                Statement::Expect(expect) => all.extend(variables_of(&expect.network)),
                Statement::Repeat(_, statements) => walk(statements, all),
                Statement::Drive(..)
                | Statement::Scan(_)
                | Statement::Wait(_)
                | Statement::Reset => {}
            }
        }
    }
    let mut all = Vec::new();
    program.tests.iter().for_each(|test| walk(&test.statements, &mut all));
    all
}

fn element_variables(element: &Element, all: &mut Vec<VariableId>) {
    match element {
        Element::Contact { variable, .. } => all.push(*variable),
        Element::Compare(expr, _) => expr_variables(expr, all),
        Element::Parallel(branches) => {
            branches.iter().flatten().for_each(|element| element_variables(element, all));
        }
        Element::Constant(_) => {}
        Element::Edge { .. }
        | Element::OneShot { .. }
        | Element::Invert
        | Element::Coil { .. }
        | Element::ResetInstance(_)
        | Element::Assign { .. }
        | Element::Call(_)
        | Element::Net(_) => unreachable!("an expectation only looks"),
    }
}

fn expr_variables(expr: &Expr, all: &mut Vec<VariableId>) {
    match &expr.kind {
        ExprKind::Constant(_) => {}
        ExprKind::Read(variable) => all.push(*variable),
        ExprKind::Not(operand) => expr_variables(operand, all),
        ExprKind::Binary(_, a, b) | ExprKind::Compare(_, a, b) => {
            expr_variables(a, all);
            expr_variables(b, all);
        }
    }
}

/// Describes the failure of an expectation's element, given every value that it looked at.
pub fn explain(
    program: &Program,
    expect: &Expect,
    element: usize,
    value: impl Fn(VariableId) -> i64,
) -> Failure {
    let mut variables = Vec::new();
    element_variables(&expect.network[element], &mut variables);
    let mut seen = std::collections::HashSet::new();
    variables.retain(|&variable| seen.insert(variable));
    let values: Vec<String> = variables
        .into_iter()
        .map(|variable| {
            let declared = &program.variables[variable];
            let unit = if declared.ty == Type::Time { " ticks" } else { "" };
            format!("{} is {}{unit}", declared.name, value(variable))
        })
        .collect();
    let text = match values.as_slice() {
        [] => "this never conducts".to_owned(),
        values => values.join(", "),
    };
    Failure { span: expect.spans[element], text }
}
