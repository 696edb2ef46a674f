//! Why an expectation does not hold: the contact that does not conduct, with its value.

use crate::model::{
    Element, Expect, Expr, ExprKind, Place, Program, Series, Statement, Test, Variable, VariableId,
};
use crate::quantity;
use crate::source::Span;
use crate::types::Type;

/// An expectation that does not hold.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Failure {
    /// The element of the outermost series that does not conduct.
    pub span: Span,
    /// What its contacts see, such as `motor is 0`.
    pub text: String,
    /// The variables that its contacts look at, in text order.
    pub variables: Vec<VariableId>,
    /// When it failed, where what ran the test can tell.
    pub moment: Option<Moment>,
}

/// Where a test stands.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Moment {
    /// Scans that the test has run.
    pub scans: u64,
    /// For each `repeat` around the place, the turn from 1 and the number of turns; the outermost
    /// first.
    pub turns: Vec<(u64, u64)>,
}

/// True if an element of an expectation conducts, given the values that it looks at.
pub fn conducts(element: &Element, read: &impl Fn(VariableId) -> i64) -> bool {
    match element {
        Element::Constant(value) => *value,
        Element::Contact { place, negated, .. } => (place.value(read) != 0) != *negated,
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

/// The variables that a test drives or looks at, each once, in text order.
pub fn variables_of_test(test: &Test) -> Vec<VariableId> {
    let mut all = Vec::new();
    mentioned(&test.statements, &mut all);
    let mut seen = std::collections::HashSet::new();
    all.retain(|&variable| seen.insert(variable));
    all
}

fn mentioned(statements: &[Statement], all: &mut Vec<VariableId>) {
    for statement in statements {
        match statement {
            Statement::Drive(place, _) => {
                place.for_each_variable(&mut |variable| all.push(variable))
            }
            Statement::Expect(expect) => all.extend(variables_of(&expect.network)),
            Statement::Repeat(_, statements) => mentioned(statements, all),
            Statement::Scan(_) | Statement::Wait(_) | Statement::Reset => {}
        }
    }
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
    for_each_look(element, &mut |look| match look {
        Look::Contact(place) => place.for_each_variable(&mut |variable| all.push(variable)),
        Look::Compare(expr) => expr.for_each_variable(&mut |variable| all.push(variable)),
    });
}

/// What an element looks at.
enum Look<'e> {
    Contact(&'e Place),
    Compare(&'e Expr),
}

fn for_each_look<'e>(element: &'e Element, see: &mut dyn FnMut(Look<'e>)) {
    match element {
        Element::Contact { place, .. } => see(Look::Contact(place)),
        Element::Compare(expr, _) => see(Look::Compare(expr)),
        Element::Parallel(branches) => {
            branches.iter().flatten().for_each(|element| for_each_look(element, see));
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

/// Describes the failure of an expectation's element, given every value that it looked at.
pub fn explain(
    program: &Program,
    expect: &Expect,
    element: usize,
    value: impl Fn(VariableId) -> i64,
) -> Failure {
    let mut values: Vec<String> = Vec::new();
    let mut note = |place: &Place| {
        let text = shown(program, expect, place, &value);
        if !values.contains(&text) {
            values.push(text);
        }
    };
    for_each_look(&expect.network[element], &mut |look| match look {
        Look::Contact(place) => {
            note(place);
            place.index().into_iter().for_each(|index| for_each_place(index, &mut note));
        }
        Look::Compare(expr) => for_each_place(expr, &mut note),
    });
    let text = match values.as_slice() {
        [] => "this never conducts".to_owned(),
        values => values.join(", "),
    };
    let mut variables = Vec::new();
    element_variables(&expect.network[element], &mut variables);
    Failure { span: expect.spans[element], text, variables, moment: None }
}

/// Calls `see` with every place that an expression reads, in text order.
fn for_each_place(expr: &Expr, see: &mut dyn FnMut(&Place)) {
    if let ExprKind::Read(place) = &expr.kind {
        see(place);
    }
    expr.parts().into_iter().for_each(|part| for_each_place(part, see));
}

/// A place and its value: `motor is 0`, `w[2].5 is 1`, `mask is 16#FF`, `delay.ET is 999ms`.
fn shown(
    program: &Program,
    expect: &Expect,
    place: &Place,
    value: &impl Fn(VariableId) -> i64,
) -> String {
    let Some(variable) = place.variable(value) else {
        return format!("{} is 0, its index is out of range", place.name(program));
    };
    let Variable { name, ty, .. } = &program.variables[variable];
    let number = place.value(value);
    match place.bit {
        Some(bit) => format!("{name}.{bit} is {number}"),
        None if *ty == Type::Time => {
            format!("{name} is {}", quantity::ticks_text(number, program.tick_ns))
        }
        None => {
            // Of an element the array is what has been noted.
            let array = program.array_of(variable);
            let declared = array.map_or(variable, |array| program.arrays[array].elements.first);
            let base = expect.bases.iter().find(|(variable, _)| *variable == declared);
            format!("{name} is {}", on_base(number, base.map_or(10, |&(_, base)| base)))
        }
    }
}

/// A number as a program writes it on a base.
fn on_base(number: i64, base: u32) -> String {
    match base {
        _ if number < 0 => number.to_string(),
        16 => format!("16#{number:X}"),
        8 => format!("8#{number:o}"),
        2 => format!("2#{number:b}"),
        _ => number.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_written_as_in_a_program() {
        for (number, base, text) in [
            (43981, 16, "16#ABCD"),
            (43981, 10, "43981"),
            (15, 8, "8#17"),
            (5, 2, "2#101"),
            (0, 16, "16#0"),
            (-1, 16, "-1"),
        ] {
            assert_eq!(on_base(number, base), text);
        }
    }
}
