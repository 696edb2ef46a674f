//! How many and how long, where the language wants to know it before the program runs: literals and
//! constants.

use super::names::{Constant, not_a_constant};
use super::reference::Resolved;
use super::{Checked, Checker, literal};
use crate::diagnostic::{Diagnostic, code};
use crate::syntax::ast::{Amount, Name, Reference};
use crate::types::Type;

impl<'s> Checker<'s> {
    /// A whole number.
    pub(super) fn number_of(&mut self, amount: Amount<'s>) -> Checked<i128> {
        match amount {
            // What is beyond every type is beyond every count.
            Amount::Literal(literal) => Ok(literal::integer(literal).unwrap_or(i128::MAX)),
            Amount::Constant(name) => {
                let Constant { ty, value, .. } = self.constant_named(name)?;
                match ty {
                    Some(ty) if !ty.is_integer() => {
                        let message = format!("a whole number is needed here, this is {ty}");
                        let diagnostic = Diagnostic::new(code::TYPE_MISMATCH, name.span, message)
                            .label(format!("a constant of type {ty}"))
                            .help("give a number, or a constant of type INT, UINT, DINT or UDINT");
                        Err(self.report(diagnostic))
                    }
                    _ => Ok(value.into()),
                }
            }
        }
    }

    /// A time that can be waited for, in ticks.
    pub(super) fn ticks_of(&mut self, amount: Amount<'s>) -> Checked<u64> {
        let name = match amount {
            Amount::Literal(literal) => return Ok(self.ticks(literal)? as u64),
            Amount::Constant(name) => name,
        };
        let Constant { ty, value, .. } = self.constant_named(name)?;
        if ty != Some(Type::Time) {
            let message = format!("TIME is needed here, this is {}", ty.unwrap_or(Type::Dint));
            let diagnostic = Diagnostic::new(code::TYPE_MISMATCH, name.span, message)
                .label("a constant without a unit of time")
                .help("declare it with its unit, for instance: const PATIENCE := 500ms");
            return Err(self.report(diagnostic));
        }
        u64::try_from(value).map_err(|_| {
            let message = "a test cannot wait for a negative time";
            let diagnostic = Diagnostic::new(code::OUT_OF_RANGE, name.span, message)
                .label(format!("this is {value} ticks"))
                .help("give a time of 0s or more");
            self.report(diagnostic)
        })
    }

    fn constant_named(&mut self, name: Name<'s>) -> Checked<Constant> {
        match self.resolve(&Reference { name, path: Vec::new() })? {
            Resolved::Constant(constant) => Ok(constant),
            Resolved::Place(_) | Resolved::Instance(_) | Resolved::Array(_) => {
                Err(self.report(not_a_constant(name.span)))
            }
        }
    }
}
