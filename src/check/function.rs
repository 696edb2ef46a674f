//! Calls of functions: how many arguments, of which types, and what is known before it runs.

use super::expression::{arithmetic, bitwise};
use super::{Checked, Checker, Reported};
use crate::diagnostic::{Diagnostic, code, shortened, similar_name};
use crate::model::{Expr, ExprKind, Function, convert};
use crate::source::Span;
use crate::syntax::ast::{self, Name};
use crate::types::Type;

/// Arguments of the longest `MIN` and `MAX`.
const MOST_ARGUMENTS: usize = 256;

/// A function and what it takes.
struct Entry {
    function: Function,
    /// The arguments as the reference shows them.
    arguments: &'static str,
    /// The least and the greatest number of them.
    count: [usize; 2],
}

const fn entry(function: Function, arguments: &'static str, count: [usize; 2]) -> Entry {
    Entry { function, arguments, count }
}

const FUNCTIONS: [Entry; 9] = [
    entry(Function::Abs, "x", [1, 1]),
    entry(Function::Min, "a, b", [2, MOST_ARGUMENTS]),
    entry(Function::Max, "a, b", [2, MOST_ARGUMENTS]),
    entry(Function::Limit, "low, x, high", [3, 3]),
    entry(Function::Select, "g, a, b", [3, 3]),
    entry(Function::ShiftLeft, "x, amount", [2, 2]),
    entry(Function::ShiftRight, "x, amount", [2, 2]),
    entry(Function::RotateLeft, "x, amount", [2, 2]),
    entry(Function::RotateRight, "x, amount", [2, 2]),
];

/// The type of a conversion's result: `INT` of `TO_INT`.
fn conversion(name: &str) -> Option<Type> {
    name.strip_prefix("TO_").and_then(Type::named)
}

/// True for the name of a function or conversion.
pub(super) fn is_function(name: &str) -> bool {
    conversion(name).is_some() || FUNCTIONS.iter().any(|entry| entry.function.name() == name)
}

impl<'s> Checker<'s> {
    pub(super) fn function(
        &mut self,
        name: Name<'s>,
        arguments: &[ast::Expr<'s>],
        span: Span,
        want: Option<Type>,
    ) -> Checked<Expr> {
        if let Some(to) = conversion(name.text) {
            self.count_arguments(name, arguments, "x", [1, 1])?;
            return self.converted(to, &arguments[0]);
        }
        let Some(entry) = FUNCTIONS.iter().find(|entry| entry.function.name() == name.text) else {
            return Err(self.unknown_function(name));
        };
        self.count_arguments(name, arguments, entry.arguments, entry.count)?;
        let checked = match entry.function {
            Function::Abs => vec![self.expression(&arguments[0], want)?],
            Function::Min | Function::Max | Function::Limit => self.of_one_type(arguments, want)?,
            Function::Select => {
                let select = self.expression(&arguments[0], Some(Type::Bool));
                let values = self.of_one_type(&arguments[1..], want);
                [select?].into_iter().chain(values?).collect()
            }
            Function::ShiftLeft
            | Function::ShiftRight
            | Function::RotateLeft
            | Function::RotateRight => {
                let want = want.filter(|_| self.adapts(&arguments[0]));
                let value = self.expression(&arguments[0], want);
                let amount = self.amount(&arguments[1]);
                vec![value?, amount?]
            }
        };
        self.takes(entry, &checked, span)?;
        Ok(call(entry.function, checked))
    }

    fn unknown_function(&mut self, name: Name<'s>) -> Reported {
        let conversions = Type::ALL.map(|ty| format!("TO_{ty}"));
        let functions = FUNCTIONS.iter().map(|entry| entry.function.name());
        let names: Vec<&str> = functions.chain(conversions.iter().map(String::as_str)).collect();
        let message = format!("there is no function `{}`", shortened(name.text));
        let help = match similar_name(name.text, names.iter().copied()) {
            Some(similar) => format!("is `{similar}` meant?"),
            None => format!("the functions are {}", names.join(", ")),
        };
        let diagnostic = Diagnostic::new(code::UNKNOWN_NAME, name.span, message)
            .label("not a function")
            .help(help);
        self.report(diagnostic)
    }

    fn count_arguments(
        &mut self,
        name: Name<'s>,
        arguments: &[ast::Expr<'s>],
        shape: &str,
        [least, most]: [usize; 2],
    ) -> Checked<()> {
        let given = arguments.len();
        if (least..=most).contains(&given) {
            return Ok(());
        }
        let plural = |count: usize| if count == 1 { "" } else { "s" };
        let (count, bound) = match (least == most, given < least) {
            (true, _) => (least, ""),
            (false, true) => (least, " at least"),
            (false, false) => (most, " at most"),
        };
        let message = format!("{} takes {count} argument{}{bound}", name.text, plural(count));
        let span = name.span.to(arguments.last().map_or(name.span, |last| last.span));
        let diagnostic = Diagnostic::new(code::BAD_CALL, span, message)
            .label(format!("{given} argument{}", plural(given)))
            .help(format!("write it {}({shape})", name.text));
        Err(self.report(diagnostic))
    }

    /// Arguments of the type of the first one that has a type of its own.
    fn of_one_type(
        &mut self,
        arguments: &[ast::Expr<'s>],
        want: Option<Type>,
    ) -> Checked<Vec<Expr>> {
        let leading = arguments.iter().position(|argument| !self.adapts(argument)).unwrap_or(0);
        let leader = self.expression(&arguments[leading], want);
        let ty = leader.as_ref().ok().map(|leader| leader.ty).or(want);
        let mut leader = Some(leader);
        // All are checked, also where one is wrong.
        let checked: Vec<_> = arguments
            .iter()
            .enumerate()
            .map(|(place, argument)| match leader.take_if(|_| place == leading) {
                Some(leader) => leader,
                None => self.expression(argument, ty),
            })
            .collect();
        checked.into_iter().collect()
    }

    /// By how much is shifted.
    fn amount(&mut self, argument: &ast::Expr<'s>) -> Checked<Expr> {
        let amount = self.expression(argument, None)?;
        if amount.ty.is_integer() {
            return Ok(amount);
        }
        let message = format!("the amount of a shift is an integer, this is {}", amount.ty);
        let diagnostic = Diagnostic::new(code::TYPE_MISMATCH, argument.span, message)
            .label(format!("a value of type {}", amount.ty))
            .help("give INT, UINT, DINT or UDINT");
        Err(self.report(diagnostic))
    }

    fn takes(&mut self, entry: &Entry, arguments: &[Expr], span: Span) -> Checked<()> {
        let ty = result_type(entry.function, arguments);
        let (fits, help) = match entry.function {
            Function::Abs => {
                (matches!(ty, Type::Int | Type::Dint), "it takes INT and DINT, which have a sign")
            }
            Function::Min | Function::Max | Function::Limit => {
                (ty != Type::Bool, "it takes every type but BOOL; of bits AND and OR do the same")
            }
            Function::Select => (true, ""),
            Function::ShiftLeft
            | Function::ShiftRight
            | Function::RotateLeft
            | Function::RotateRight => {
                (ty.is_pattern(), "it takes WORD and DWORD; TO_WORD makes one of an INT or UINT")
            }
        };
        if fits {
            return Ok(());
        }
        let message = format!("{} takes no {ty}", entry.function.name());
        let diagnostic = Diagnostic::new(code::TYPE_MISMATCH, span, message)
            .label(format!("of type {ty}"))
            .help(help);
        Err(self.report(diagnostic))
    }

    fn converted(&mut self, to: Type, argument: &ast::Expr<'s>) -> Checked<Expr> {
        // A number alone has the first type that holds it.
        let from = match self.takes_any_type(argument) {
            true => {
                let number = self.number(argument)?;
                [Type::Dint, Type::Udint].into_iter().find(|ty| ty.holds(number))
            }
            false => None,
        };
        let operand = self.expression(argument, from)?;
        let kind = match operand.kind {
            ExprKind::Constant(value) => ExprKind::Constant(convert(to, value)),
            _ => ExprKind::Convert(Box::new(operand)),
        };
        Ok(Expr { ty: to, kind })
    }

    /// True for what takes the type of the other side: a number, and a function of such alone.
    pub(super) fn adapts(&self, expr: &ast::Expr<'s>) -> bool {
        match &expr.kind {
            ast::ExprKind::Function(name, arguments) => {
                let entry = FUNCTIONS.iter().find(|entry| entry.function.name() == name.text);
                let values = match entry.map(|entry| entry.function) {
                    None => return false,
                    Some(Function::Abs | Function::Min | Function::Max | Function::Limit) => {
                        arguments.as_slice()
                    }
                    Some(Function::Select) => arguments.get(1..).unwrap_or_default(),
                    Some(
                        Function::ShiftLeft
                        | Function::ShiftRight
                        | Function::RotateLeft
                        | Function::RotateRight,
                    ) => arguments.get(..1).unwrap_or_default(),
                };
                !values.is_empty() && values.iter().all(|value| self.adapts(value))
            }
            ast::ExprKind::Unary(_, operand) => self.adapts(operand),
            ast::ExprKind::Binary(operator, a, b) => {
                (arithmetic(*operator).is_some() || bitwise(*operator).is_some())
                    && self.adapts(a)
                    && self.adapts(b)
            }
            _ => self.takes_any_type(expr),
        }
    }
}

/// The type of a function's result.
fn result_type(function: Function, arguments: &[Expr]) -> Type {
    match function {
        Function::Select => arguments[1].ty,
        _ => arguments[0].ty,
    }
}

/// A call, worked out if every argument is a constant.
fn call(function: Function, arguments: Vec<Expr>) -> Expr {
    let ty = result_type(function, &arguments);
    let constants: Option<Vec<i64>> = arguments.iter().map(Expr::constant).collect();
    let kind = match constants {
        Some(constants) => ExprKind::Constant(function.apply(ty, &constants)),
        None => ExprKind::Call(function, arguments),
    };
    Expr { ty, kind }
}
