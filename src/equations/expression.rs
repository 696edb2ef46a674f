//! Expressions and what they read.

use super::lower::Lowering;
use super::{ExprId, ExprOp};
use crate::model::{self, Base, ExprKind, Place, VariableId};
use crate::types::Type;

impl Lowering<'_> {
    pub(super) fn expr(&mut self, expr: &model::Expr) -> ExprId {
        let op = match &expr.kind {
            ExprKind::Constant(value) => ExprOp::Constant(*value),
            ExprKind::Read(place) => return self.read_place(place),
            ExprKind::Not(operand) => {
                let operand = self.expr(operand);
                return self.not(operand);
            }
            ExprKind::Convert(operand) => ExprOp::Convert(self.expr(operand)),
            ExprKind::Binary(op, a, b) => {
                let (a, b) = (self.expr(a), self.expr(b));
                ExprOp::Binary(*op, a, b)
            }
            ExprKind::Compare(relation, a, b) => {
                let (a, b) = (self.expr(a), self.expr(b));
                ExprOp::Compare(*relation, a, b)
            }
            ExprKind::Call(function, arguments) => {
                let arguments: Vec<ExprId> =
                    arguments.iter().map(|argument| self.expr(argument)).collect();
                ExprOp::Call(*function, self.operands(&arguments))
            }
        };
        self.add(op, expr.ty)
    }

    /// The newest value of a place.
    pub(super) fn read_place(&mut self, place: &Place) -> ExprId {
        match &place.base {
            Base::Variable(variable) => self.read_part(*variable, place.bit),
            Base::Element { elements, index } => {
                let index = self.expr(index);
                let list: Vec<ExprId> =
                    elements.iter().map(|element| self.read_part(element, place.bit)).collect();
                let elements = self.operands(&list);
                self.add(ExprOp::Element { index, elements }, place.ty(self.program))
            }
        }
    }

    /// The newest value of a variable or of one of its bits.
    pub(super) fn read_part(&mut self, variable: VariableId, bit: Option<u32>) -> ExprId {
        let whole = self.read(variable);
        match bit {
            Some(bit) => self.add(ExprOp::Bit(whole, bit), Type::Bool),
            None => whole,
        }
    }
}
