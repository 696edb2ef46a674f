//! What a name with what follows it stands for.

use super::names::{Constant, Entity};
use super::{Checked, Checker};
use crate::diagnostic::{Diagnostic, code, shortened, similar_name};
use crate::model::{InstanceId, VariableId};
use crate::syntax::ast::{self, Accessor, Reference};

/// What a reference stands for.
pub(super) enum Resolved {
    Variable(VariableId),
    Constant(Constant),
    Instance(InstanceId),
}

impl<'s> Checker<'s> {
    /// What a reference stands for.
    pub(super) fn resolve(&mut self, reference: &Reference<'s>) -> Checked<Resolved> {
        let entity = match self.names.find(reference.name) {
            Ok(entity) => entity,
            Err(diagnostic) => return Err(self.report(*diagnostic)),
        };
        match (entity, reference.path.as_slice()) {
            (Entity::Broken, _) => Err(super::Reported),
            (Entity::Variable(variable), []) => Ok(Resolved::Variable(variable)),
            (Entity::Constant(constant), []) => {
                self.program.constants[constant.index].is_used = true;
                Ok(Resolved::Constant(constant))
            }
            (Entity::Instance(instance), []) => Ok(Resolved::Instance(instance)),
            (Entity::Instance(instance), [Accessor::Member(member)]) => {
                self.member(instance, *member)
            }
            (Entity::Variable(_), [Accessor::Bit(bit), ..]) => {
                let diagnostic = Diagnostic::new(
                    code::NOT_YET,
                    bit.span,
                    "bits of a word are not supported yet",
                )
                .label("a bit")
                .help("declare a BOOL variable for it");
                Err(self.report(diagnostic))
            }
            (_, [part, ..]) => {
                let message = format!("`{}` has no such part", reference.name.text);
                let diagnostic = Diagnostic::new(code::NO_MEMBER, part.span(), message)
                    .label("nothing to be found here")
                    .help("only block instances have members");
                Err(self.report(diagnostic))
            }
        }
    }

    fn member(&mut self, instance: InstanceId, member: ast::Name<'s>) -> Checked<Resolved> {
        let instance = &self.program.instances[instance];
        let shape = &instance.shape;
        let port = shape.port_named(member.text).filter(|&port| shape.ports[port].role.is_member());
        if let Some(port) = port {
            return Ok(Resolved::Variable(instance.members[port]));
        }
        let members = || {
            let ports = shape.ports.iter().filter(|port| port.role.is_member());
            ports.map(|port| port.name)
        };
        let message = format!("{} has no member `{}`", shape.block.name, shortened(member.text));
        let help = match similar_name(member.text, members()) {
            Some(similar) => format!("is `{similar}` meant?"),
            None => format!("its members are {}", members().collect::<Vec<_>>().join(", ")),
        };
        let diagnostic =
            Diagnostic::new(code::NO_MEMBER, member.span, message).label("not a member").help(help);
        Err(self.report(diagnostic))
    }

    pub(super) fn instance_is_no_value(
        &mut self,
        instance: InstanceId,
        reference: &Reference<'s>,
    ) -> super::Reported {
        let block = self.program.instances[instance].shape.block;
        let name = reference.name.text;
        let message = format!("`{name}` is a block ({}), not a value", block.name);
        let diagnostic = Diagnostic::new(code::TYPE_MISMATCH, reference.span(), message)
            .label("a block instance")
            .help(format!("read a member, for instance: {name}.{}", block.main.unwrap_or("DN")));
        self.report(diagnostic)
    }
}
