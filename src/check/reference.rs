//! What a name with what follows it stands for.

use super::names::{Constant, Entity};
use super::{Checked, Checker, Reported, literal};
use crate::blocks::Port;
use crate::diagnostic::{Diagnostic, code, shortened, similar_name};
use crate::model::{Array, ArrayId, Base, ExprKind, InstanceId, Place, VariableId};
use crate::source::Span;
use crate::syntax::ast::{self, Accessor, Literal, Reference};
use crate::types::Type;

/// What a reference stands for.
pub(super) enum Resolved {
    Place(Place),
    Constant(Constant),
    Instance(InstanceId),
    /// All of it.
    Array(ArrayId),
}

impl<'s> Checker<'s> {
    /// What a reference stands for.
    pub(super) fn resolve(&mut self, reference: &Reference<'s>) -> Checked<Resolved> {
        let entity = match self.names.find(reference.name) {
            Ok(entity) => entity,
            Err(diagnostic) => return Err(self.unknown_reference(reference, *diagnostic)),
        };
        let name = reference.name.text;
        match (entity, reference.path.as_slice()) {
            (Entity::Broken, _) => Err(Reported),
            (Entity::Constant(constant), []) => {
                self.program.constants[constant.index].is_used = true;
                Ok(Resolved::Constant(constant))
            }
            (Entity::Instance(instance), []) => Ok(Resolved::Instance(instance)),
            (Entity::Array(array), []) => Ok(Resolved::Array(array)),
            (Entity::Variable(variable), path) => {
                self.place(Base::Variable(variable), name, path).map(Resolved::Place)
            }
            (Entity::Instance(instance), [Accessor::Member(member), path @ ..]) => {
                let member = self.member(instance, *member)?;
                let name = self.program.variables[member].name.to_string();
                self.place(Base::Variable(member), &name, path).map(Resolved::Place)
            }
            (Entity::Array(array), [Accessor::Index(index, _), path @ ..]) => {
                let base = self.element_of(array, index)?;
                self.place(base, &format!("{name}[...]"), path).map(Resolved::Place)
            }
            (Entity::Array(array), [Accessor::Bit(bit)]) => {
                self.bit_of_array(array, *bit).map(Resolved::Place)
            }
            (Entity::Constant(_) | Entity::Instance(_) | Entity::Array(_), [part, ..]) => {
                Err(self.no_such_part(name, part))
            }
        }
    }

    /// `I0.3` reads as a bit, and is an address where nothing is named `I0`.
    fn unknown_reference(&mut self, reference: &Reference<'s>, found: Diagnostic) -> Reported {
        let text = self.source.slice(reference.span());
        let is_letter = |c: char| c.is_ascii_uppercase();
        let letters = text.len() - text.trim_start_matches(is_letter).len();
        let name = reference.name.text;
        let is_area = (1..=2).contains(&letters)
            && name.len() > letters
            && name[letters..].chars().all(|c| c.is_ascii_digit());
        if !is_area || !matches!(reference.path.as_slice(), [Accessor::Bit(_)]) {
            return self.report(found);
        }
        let help = format!("an address is declared and used in back-ticks: `` `{text}` ``");
        self.report(Diagnostic { help: vec![help], ..found })
    }

    fn no_such_part(&mut self, name: &str, part: &Accessor<'s>) -> Reported {
        let message = format!("`{name}` has no such part");
        let help = match part {
            Accessor::Member(_) => "only block instances have members",
            Accessor::Bit(_) => "bits are those of a variable: give the value to one first",
            Accessor::Index(..) => "only arrays have elements, and those have none themselves",
        };
        let diagnostic = Diagnostic::new(code::NO_MEMBER, part.span(), message)
            .label("nothing to be found here")
            .help(help);
        self.report(diagnostic)
    }

    /// A variable or element with what follows it: a bit or nothing.
    fn place(&mut self, base: Base, name: &str, path: &[Accessor<'s>]) -> Checked<Place> {
        let whole = Place { base, bit: None };
        let bit = match path {
            [] => return Ok(whole),
            [Accessor::Bit(bit)] => *bit,
            [Accessor::Bit(_), part, ..] | [part, ..] => return Err(self.no_such_part(name, part)),
        };
        let ty = whole.ty(&self.program);
        self.has_bits(name, ty, bit.span)?;
        let number = self.bit_number(name, bit, ty.width())?;
        Ok(Place { bit: Some(number), ..whole })
    }

    fn has_bits(&mut self, name: &str, ty: Type, span: Span) -> Checked<()> {
        if ty.has_bits() {
            return Ok(());
        }
        let message = format!("`{name}` is {ty}, which has no bits to choose from");
        let diagnostic = Diagnostic::new(code::NO_MEMBER, span, message)
            .label("a bit")
            .help("bits are those of INT, UINT, DINT, UDINT, WORD and DWORD, and of arrays");
        Err(self.report(diagnostic))
    }

    /// The number of a bit out of that many.
    fn bit_number(&mut self, name: &str, bit: Literal<'s>, bits: u32) -> Checked<u32> {
        let number = literal::integer(bit).and_then(|bit| u32::try_from(bit).ok());
        if let Some(number) = number.filter(|&number| number < bits) {
            return Ok(number);
        }
        let message = format!("`{name}` has the bits 0 to {}", bits - 1);
        let diagnostic = Diagnostic::new(code::OUT_OF_RANGE, bit.span, message)
            .label("there is no such bit")
            .help("bit 0 is the lowest");
        Err(self.report(diagnostic))
    }

    /// `line.47`: the bits of an array are counted through all its elements, from the lowest of
    /// the first.
    fn bit_of_array(&mut self, array: ArrayId, bit: Literal<'s>) -> Checked<Place> {
        let name = self.program.arrays[array].name.clone();
        let elements = self.program.arrays[array].elements;
        let ty = self.program.variables[elements.first].ty;
        if ty == Type::Time {
            self.has_bits(&name, ty, bit.span)?;
        }
        let number = self.bit_number(&name, bit, ty.width() * elements.length)?;
        let element = elements.get(i64::from(number / ty.width())).expect("it is in range");
        let bit = (ty != Type::Bool).then_some(number % ty.width());
        Ok(Place { base: Base::Variable(element), bit })
    }

    /// The element of an index.
    fn element_of(&mut self, array: ArrayId, index: &ast::Expr<'s>) -> Checked<Base> {
        // A number need not fit a type to be out of range.
        let written = match &index.kind {
            ast::ExprKind::Literal(number) => literal::integer(*number),
            _ => None,
        };
        if let Some(value) = written.filter(|&value| i32::try_from(value).is_err()) {
            return Err(self.no_such_element(array, value, index.span));
        }
        let checked = self.expression(index, None)?;
        if !checked.ty.is_integer() {
            let message = format!("an index is an integer, this is {}", checked.ty);
            let diagnostic = Diagnostic::new(code::TYPE_MISMATCH, index.span, message)
                .label(format!("a value of type {}", checked.ty))
                .help("an index is INT, UINT, DINT or UDINT; TO_INT makes one of another value");
            return Err(self.report(diagnostic));
        }
        let elements = self.program.arrays[array].elements;
        let ExprKind::Constant(value) = checked.kind else {
            self.count_elements(elements.length, index.span)?;
            return Ok(Base::Element { elements, index: Box::new(checked) });
        };
        let element = elements.get(value).map(Base::Variable);
        element.ok_or_else(|| self.no_such_element(array, value.into(), index.span))
    }

    fn no_such_element(&mut self, array: ArrayId, value: i128, span: Span) -> Reported {
        let Array { name, elements } = &self.program.arrays[array];
        let last = elements.length - 1;
        let message = match last {
            0 => format!("`{name}` has the one element {name}[0]"),
            _ => format!("`{name}` has the elements {name}[0] to {name}[{last}]"),
        };
        let diagnostic = Diagnostic::new(code::OUT_OF_RANGE, span, message)
            .label(format!("there is no element {value}"))
            .help("elements are counted from 0");
        self.report(diagnostic)
    }

    fn member(&mut self, id: InstanceId, member: ast::Name<'s>) -> Checked<VariableId> {
        let instance = &self.program.instances[id];
        let shape = &instance.shape;
        let port = shape.port_named(member.text).filter(|&port| shape.ports[port].role.is_member());
        if let Some(port) = port {
            return Ok(instance.members[port]);
        }
        let may_be_there = |port: &Port| port.name == member.text;
        if self.unsettled.contains(&id) && shape.block.ports.iter().any(may_be_there) {
            return Err(Reported);
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
    ) -> Reported {
        let block = self.program.instances[instance].shape.block;
        let name = reference.name.text;
        let message = format!("`{name}` is a block ({}), not a value", block.name);
        let diagnostic = Diagnostic::new(code::TYPE_MISMATCH, reference.span(), message)
            .label("a block instance")
            .help(format!("read a member, for instance: {name}.{}", block.main.unwrap_or("DN")));
        self.report(diagnostic)
    }

    pub(super) fn array_is_no_value(
        &mut self,
        array: ArrayId,
        reference: &Reference<'s>,
    ) -> Reported {
        let name = reference.name.text;
        let length = self.program.arrays[array].elements.length;
        let message = format!("`{name}` is an array of {length}, one value is needed here");
        let diagnostic = Diagnostic::new(code::TYPE_MISMATCH, reference.span(), message)
            .label("all elements at once")
            .help(format!("name an element, for instance: {name}[0]"));
        self.report(diagnostic)
    }
}
