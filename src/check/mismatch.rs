//! A value of one type where another one is needed, and the conversion that mends it.

use super::{Checker, Reported};
use crate::diagnostic::{Diagnostic, code};
use crate::source::Span;
use crate::types::Type;

/// Characters of the longest value that a help repeats.
const LONGEST: usize = 24;

impl Checker<'_> {
    pub(super) fn mismatch(&mut self, span: Span, found: Type, want: Type) -> Reported {
        let message = format!("{want} is needed here, this is {found}");
        let help = self.conversion_help(span, found, want);
        let diagnostic = Diagnostic::new(code::TYPE_MISMATCH, span, message)
            .label(format!("a value of type {found}"))
            .help(help);
        self.report(diagnostic)
    }

    /// Operands of two types. The narrower one is better converted: nothing is lost.
    pub(super) fn two_types(
        &mut self,
        (left, of_left): (Span, Type),
        (right, of_right): (Span, Type),
    ) -> Reported {
        let is_plain = |ty: Type| ty.is_integer() || ty.is_pattern();
        if !is_plain(of_left) || !is_plain(of_right) || of_left.width() >= of_right.width() {
            return self.mismatch(right, of_right, of_left);
        }
        let message = format!("{of_left} is needed here, this is {of_right}");
        let help = self.conversion_help(left, of_left, of_right);
        let diagnostic = Diagnostic::new(code::TYPE_MISMATCH, right, message)
            .label(format!("a value of type {of_right}"))
            .also(left, format!("a value of type {of_left}"))
            .help(help);
        self.report(diagnostic)
    }

    fn conversion_help(&self, span: Span, found: Type, want: Type) -> String {
        let text = self.source.slice(span);
        let is_short = text.len() <= LONGEST && !text.contains('\n');
        let converted = format!("TO_{want}({})", if is_short { text } else { "..." });
        let is_literal = text.starts_with(|c: char| c.is_ascii_digit() || c == '-');
        match (want, found) {
            (Type::Bool, _) => {
                let zero = if found == Type::Time { "0s" } else { "0" };
                format!(
                    "compare it, for instance: {{ {} > {zero} }}",
                    if is_short { text } else { "x" }
                )
            }
            // A variable may hold a number of ticks, a literal is hardly meant as one.
            (Type::Time, _) if found.is_integer() && !is_literal => format!(
                "{converted} takes it as a number of ticks; a time has a unit, such as 500ms"
            ),
            (Type::Time, _) => {
                "write a time with its unit, such as 500ms, or a variable of type TIME".to_owned()
            }
            (_, Type::Bool) => "a BOOL is no number: let it be a contact before the braces".into(),
            (_, Type::Time) if is_literal => {
                "a time is no number: declare the other one as TIME".to_owned()
            }
            (_, Type::Time) => {
                format!("{converted} is its number of ticks; or declare the other one as TIME")
            }
            _ if want.width() < found.width() => format!(
                "convert one of them: {converted} keeps the low {} bits of this one; or declare \
                 both with one type",
                want.width()
            ),
            _ => format!("convert one of them: {converted}; or declare both with one type"),
        }
    }
}
