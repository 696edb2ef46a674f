//! Numbers and words in registers, and coils and contacts on their bits.

use super::compile::{Compiler, Done};
use super::power::Power;
use super::tree::{Contact, Tree};
use super::word::{Address, Operation, Prefix};
use crate::model::{Base, CoilAction, Place, VariableId};
use crate::source::Span;

impl Compiler<'_> {
    /// The register of a number: it has its initial value, or an input's, which the host writes.
    pub(super) fn number(&mut self, variable: VariableId, span: Span) -> Done<u16> {
        if let Some(register) = self.layout.register(variable) {
            return Ok(register);
        }
        let declared = &self.program.variables[variable];
        let (name, ty) = (declared.name.to_string(), declared.ty);
        let initial = ty.bits(declared.initial);
        if ty.width() != 16 {
            let label = format!("`{name}` is {ty}");
            return Err(self.cannot(span, "registers that are not 16 bits wide", label));
        }
        let register = self.layout.words(&[name], span);
        let register = self.limit(register)?;
        self.layout.place(variable, register);
        if initial != 0 {
            self.rom.registers.insert(register, initial as u16);
        }
        Ok(register)
    }

    /// The address of a bit that a contact looks at. That of a register is shown in a flag: no
    /// power sets the bit, and the coil tells what it is.
    pub(super) fn bit_of(&mut self, place: &Place, span: Span) -> Done<Address> {
        if let Some(variable) = place.as_variable() {
            return self.readable(variable, span);
        }
        let coil = self.flag()?;
        self.register_bit(&Tree::constant(false), Operation::BitSet, place, coil, span)?;
        Ok(coil)
    }

    /// Sets or clears a bit of a register.
    fn register_bit(
        &mut self,
        power: &Tree,
        operation: Operation,
        place: &Place,
        coil: Address,
        span: Span,
    ) -> Done<()> {
        let (Base::Variable(variable), Some(bit)) = (&place.base, place.bit) else {
            let label = "the index is known only while the program runs";
            return Err(self.cannot(span, "an element with such an index", label));
        };
        let register = self.number(*variable, span)?;
        self.circuit(power)?;
        self.prefix(Prefix::Register(register));
        self.prefix(Prefix::Number(bit as u16));
        self.operation(operation, coil);
        Ok(())
    }

    /// A coil on a bit of a register.
    pub(super) fn register_coil(
        &mut self,
        place: &Place,
        action: CoilAction,
        span: Span,
        power: Power,
    ) -> Done<Power> {
        let power = self.single(power)?;
        let spare = self.flag()?;
        let (on, off) = match action {
            CoilAction::Set => (Some(power), None),
            CoilAction::Reset => (None, Some(power)),
            CoilAction::Plain => (Some(power), Some(opposite(power))),
            CoilAction::Negated => (Some(opposite(power)), Some(power)),
            CoilAction::Edge(edge, memory) => {
                let coil = self.flag()?;
                self.change(power, edge, memory, coil)?;
                let changed = Contact { address: coil, negated: false };
                (Some(changed), Some(opposite(changed)))
            }
        };
        for (contact, operation) in [(on, Operation::BitSet), (off, Operation::BitClear)] {
            let Some(contact) = contact else { continue };
            self.register_bit(&Tree::Contact(contact), operation, place, spare, span)?;
        }
        Ok(Power::Drawn(Tree::Contact(power)))
    }
}

fn opposite(contact: Contact) -> Contact {
    Contact { negated: !contact.negated, ..contact }
}
