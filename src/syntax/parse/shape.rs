//! A plain form of the tree for tests: everything in it, nothing of the layout.

use std::fmt::Write;

use crate::syntax::ast::*;

pub(super) fn series(series: &Series<'_>) -> String {
    series.elements.iter().map(element).collect::<Vec<_>>().join(" ")
}

fn list<T>(parts: &[T], show: impl Fn(&T) -> String) -> String {
    parts.iter().map(show).collect::<Vec<_>>().join(",")
}

fn element(element: &Element<'_>) -> String {
    let mark = |negated: &bool| if *negated { "!" } else { "" };
    match &element.kind {
        ElementKind::Constant(value) => format!("const:{value}"),
        ElementKind::FirstScan { negated } => format!("{}first", mark(negated)),
        ElementKind::Contact { operand, negated } => mark(negated).to_owned() + &reference(operand),
        ElementKind::Edge { edge, operand } => format!("{edge:?}<{}>", reference(operand)),
        ElementKind::Parallel(branches) => {
            format!("[{}]", branches.iter().map(series).collect::<Vec<_>>().join("|"))
        }
        ElementKind::OneShot(edge) => format!("{edge:?}"),
        ElementKind::Invert => "Invert".to_owned(),
        ElementKind::Compare(value) => format!("{{{}}}", expression(value)),
        ElementKind::Coil { action, target } => format!("({action:?} {})", reference(target)),
        ElementKind::Assign { target, value } => {
            format!("{{{}:={}}}", reference(target), expression(value))
        }
        ElementKind::Call(call) => {
            let argument = |argument: &Argument<'_>| {
                let value = match &argument.value {
                    ArgumentValue::Expr(value) => expression(value),
                    ArgumentValue::List(values, _) => format!("list {}", list(values, expression)),
                    ArgumentValue::Network(network) => format!("net {}", series(network)),
                };
                format!("{}={value}", argument.name.text)
            };
            let arguments: Vec<_> = call.arguments.iter().map(argument).collect();
            format!("{}:{}<{}>", call.name.text, call.kind.text, arguments.join("; "))
        }
        ElementKind::Net(net) => list(&net.connections, |connection| {
            let arrow = if connection.both_ways { "<->" } else { "->" };
            let (from, to) = (connection.from.text, connection.to.text);
            format!("{from}{arrow}{to}:{}", series(&connection.network))
        }),
    }
}

pub(super) fn reference(reference: &Reference<'_>) -> String {
    let mut text = reference.name.text.to_owned();
    for accessor in &reference.path {
        match accessor {
            Accessor::Member(name) => write!(text, ".{}", name.text),
            Accessor::Bit(bit) => write!(text, ".#{}", bit.text),
            Accessor::Index(index, _) => write!(text, "<{}>", expression(index)),
        }
        .unwrap();
    }
    text
}

pub(super) fn expression(value: &Expr<'_>) -> String {
    match &value.kind {
        ExprKind::Literal(literal) => literal.text.to_owned(),
        ExprKind::Reference(operand) => reference(operand),
        ExprKind::Unary(operator, value) => format!("({operator:?} {})", expression(value)),
        ExprKind::Binary(operator, left, right) => {
            format!("({} {operator:?} {})", expression(left), expression(right))
        }
        ExprKind::Function(name, values) => format!("{}({})", name.text, list(values, expression)),
    }
}

pub(super) fn statements(all: &[Statement<'_>]) -> String {
    let show = |statement: &Statement<'_>| match &statement.kind {
        StatementKind::Drive(input, value) => {
            format!("{}:={}", reference(input), expression(value))
        }
        StatementKind::Scan(None) => "scan".to_owned(),
        StatementKind::Scan(Some(count)) => format!("scan {}", count.text()),
        StatementKind::Wait(time) => format!("wait {}", time.text()),
        StatementKind::Pulse(input) => format!("pulse {}", reference(input)),
        StatementKind::Repeat(count, body) => format!("{}*{{{}}}", count.text(), statements(body)),
        StatementKind::Reset => "reset".to_owned(),
        StatementKind::Expect(network) => format!("expect {}", series(network)),
    };
    all.iter().map(show).collect::<Vec<_>>().join(";")
}
