//! Expressions of bits as contacts, and assignments to bits.

use super::compile::{Compiler, Done};
use super::power::Power;
use super::tree::{Contact, Tree};
use super::word::{ONE, Operation};
use crate::model::{BinaryOp, Expr, ExprKind, Relation, VariableId};
use crate::source::Span;
use crate::types::Type;

impl Compiler<'_> {
    /// A `BOOL` expression as contacts.
    pub(super) fn condition(&mut self, expr: &Expr, span: Span) -> Done<Tree> {
        match &expr.kind {
            ExprKind::Constant(value) => Ok(Tree::constant(*value != 0)),
            ExprKind::Read(place) => Ok(Tree::on(self.bit_of(place, span)?)),
            ExprKind::Convert(_) | ExprKind::Call(..) => {
                Err(self.cannot(span, "functions and conversions", "an expression with one"))
            }
            ExprKind::Not(operand) => {
                let tree = self.condition(operand, span)?;
                Ok(tree.inverted().expect("an expression has no bridges"))
            }
            ExprKind::Binary(op, a, b) => {
                let (a, b) = (self.condition(a, span)?, self.condition(b, span)?);
                match op {
                    BinaryOp::And => Ok(Tree::series([a, b])),
                    BinaryOp::Or => Ok(Tree::parallel([a, b])),
                    BinaryOp::Xor => self.differ(a, b),
                    BinaryOp::Add
                    | BinaryOp::Subtract
                    | BinaryOp::Multiply
                    | BinaryOp::Divide
                    | BinaryOp::Modulo => unreachable!("a BOOL is no number"),
                }
            }
            ExprKind::Compare(_, a, _) if a.ty != Type::Bool => {
                let label = format!("compares values of type {}", a.ty);
                Err(self.cannot(span, "a comparison of numbers", label))
            }
            ExprKind::Compare(relation, a, b) => {
                let (a, b) = (self.condition(a, span)?, self.condition(b, span)?);
                let invert = |tree: Tree| tree.inverted().expect("an expression has no bridges");
                match relation {
                    Relation::NotEqual => self.differ(a, b),
                    Relation::Equal => self.differ(invert(a), b),
                    Relation::Less => Ok(Tree::series([invert(a), b])),
                    Relation::LessOrEqual => Ok(Tree::parallel([invert(a), b])),
                    Relation::Greater => Ok(Tree::series([a, invert(b)])),
                    Relation::GreaterOrEqual => Ok(Tree::parallel([a, invert(b)])),
                }
            }
        }
    }

    /// Conducts where one of the two conducts alone. Both stand in it twice, so they are single
    /// contacts first.
    fn differ(&mut self, a: Tree, b: Tree) -> Done<Tree> {
        let (a, b) = (self.single(Power::Drawn(a))?, self.single(Power::Drawn(b))?);
        let not =
            |contact: Contact| Tree::Contact(Contact { negated: !contact.negated, ..contact });
        Ok(Tree::parallel([
            Tree::series([Tree::Contact(a), not(b)]),
            Tree::series([not(a), Tree::Contact(b)]),
        ]))
    }

    /// Writes a bit where there is power, and passes the power on.
    pub(super) fn assign(
        &mut self,
        target: VariableId,
        value: &Expr,
        span: Span,
        power: Power,
    ) -> Done<Power> {
        if value.ty != Type::Bool {
            let label = format!("a value of type {}", value.ty);
            return Err(self.cannot(span, "an assignment of numbers", label));
        }
        let coil = self.readable(target, span)?;
        let left = self.drawn(power)?;
        let value = self.condition(value, span)?;
        if left.is_wire() {
            self.output(&value, Operation::Coil, coil)?;
            return Ok(Power::Drawn(left));
        }
        // The power is looked at after the write, and the value between set and reset.
        let mut left = self.single(Power::Drawn(left))?;
        if left.address == coil {
            left = self.flagged(&Tree::Contact(left))?;
        }
        let mut value = self.single(Power::Drawn(value))?;
        if value.address == ONE {
            let operation = if value.negated { Operation::Reset } else { Operation::Set };
            return self.write(Power::Drawn(Tree::Contact(left)), operation, coil);
        }
        if value.address == coil {
            value = self.flagged(&Tree::Contact(value))?;
        }
        let (on, off) = (value, Contact { negated: !value.negated, ..value });
        for (contact, operation) in [(on, Operation::Set), (off, Operation::Reset)] {
            let both = Tree::series([Tree::Contact(left), Tree::Contact(contact)]);
            self.output(&both, operation, coil)?;
        }
        Ok(Power::Drawn(Tree::Contact(left)))
    }
}
