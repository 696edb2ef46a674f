//! On which base a number is thought of: what stands beside `16#FF` is better shown so too.

use super::Checker;
use super::expression::relation;
use super::names::Entity;
use crate::model::VariableId;
use crate::syntax::ast::{Accessor, ElementKind, Expr, ExprKind, LiteralKind, Reference, Series};

impl<'s> Checker<'s> {
    /// The variables of an expectation that are compared with a number on another base than 10.
    pub(super) fn bases_in(&self, network: &Series<'s>) -> Vec<(VariableId, u32)> {
        let mut bases = Vec::new();
        for element in &network.elements {
            match &element.kind {
                ElementKind::Compare(expr) => self.note_bases(expr, &mut bases),
                ElementKind::Parallel(branches) => {
                    branches.iter().for_each(|branch| bases.extend(self.bases_in(branch)));
                }
                _ => {}
            }
        }
        bases
    }

    fn note_bases(&self, expr: &Expr<'s>, bases: &mut Vec<(VariableId, u32)>) {
        match &expr.kind {
            ExprKind::Binary(operator, a, b) if relation(*operator).is_some() => {
                let Some(base) = written_base(a).or_else(|| written_base(b)) else { return };
                for_each_reference(expr, &mut |reference| {
                    bases.extend(self.declared(reference).map(|variable| (variable, base)));
                });
            }
            _ => parts(expr).into_iter().for_each(|part| self.note_bases(part, bases)),
        }
    }

    /// The variable of a reference, the first element of an array.
    fn declared(&self, reference: &Reference<'s>) -> Option<VariableId> {
        match (self.names.get(reference.name.text)?, reference.path.first()) {
            (Entity::Variable(variable), _) => Some(variable),
            (Entity::Array(array), _) => Some(self.program.arrays[array].elements.first),
            (Entity::Instance(instance), Some(Accessor::Member(member))) => {
                let instance = &self.program.instances[instance];
                Some(instance.members[instance.shape.port_named(member.text)?])
            }
            _ => None,
        }
    }
}

/// The base of the first number in an expression that is not 10.
fn written_base(expr: &Expr<'_>) -> Option<u32> {
    match &expr.kind {
        ExprKind::Literal(literal) if literal.kind == LiteralKind::Integer => {
            literal.text.split_once('#')?.0.parse().ok()
        }
        _ => parts(expr).into_iter().find_map(written_base),
    }
}

fn for_each_reference<'e, 's>(expr: &'e Expr<'s>, see: &mut dyn FnMut(&'e Reference<'s>)) {
    if let ExprKind::Reference(reference) = &expr.kind {
        see(reference);
    }
    parts(expr).into_iter().for_each(|part| for_each_reference(part, see));
}

fn parts<'e, 's>(expr: &'e Expr<'s>) -> Vec<&'e Expr<'s>> {
    match &expr.kind {
        ExprKind::Literal(_) | ExprKind::Reference(_) => Vec::new(),
        ExprKind::Unary(_, operand) => vec![operand],
        ExprKind::Binary(_, a, b) => vec![a, b],
        ExprKind::Function(_, arguments) => arguments.iter().collect(),
    }
}
