//! Numbers and words in registers: coils and contacts on their bits, and shifts.

use super::call::Function;
use super::compile::{Compiler, Done};
use super::layout::UnitClass;
use super::power::Power;
use super::tree::{Contact, Tree};
use super::word::{Address, ONE, Operation, Prefix, TimerType};
use crate::model::{Base, Call, CoilAction, Expr, Place, Variable, VariableId};
use crate::source::Span;

impl Compiler<'_> {
    /// The register of a number: it has its initial value, or an input's, which the host writes.
    pub(super) fn number(&mut self, variable: VariableId, span: Span) -> Done<u16> {
        if let Some(register) = self.layout.register(variable) {
            return Ok(register);
        }
        let program = self.program;
        let Variable { name, ty, .. } = &program.variables[variable];
        if ty.width() != 16 {
            let label = format!("`{name}` is {ty}");
            let help = "declare it as WORD, INT or UINT, or build it with --emit verilog or vhdl";
            return Err(self.refuse(span, "registers that are not 16 bits wide", label, help));
        }
        // A shift may want the elements of an array one behind the other.
        let words: Vec<VariableId> = match program.array_of(variable) {
            Some(array) => program.arrays[array].elements.iter().collect(),
            None => vec![variable],
        };
        let names: Vec<String> =
            words.iter().map(|&word| program.variables[word].name.to_string()).collect();
        let first = self.layout.words(&names, span);
        let first = self.limit(first)?;
        for (register, &word) in (first..).zip(&words) {
            self.layout.place(word, register);
            let initial = ty.bits(program.variables[word].initial);
            if initial != 0 {
                self.rom.registers.insert(register, initial as u16);
            }
        }
        Ok(self.layout.register(variable).expect("it was placed"))
    }

    /// Shifts a word or the words of an array.
    pub(super) fn shift(
        &mut self,
        call: &Call,
        power: Tree,
        operation: Operation,
    ) -> Done<Address> {
        let span = self.instance(call.instance).span;
        let first = self.number(self.member(call.instance, "REG0"), span)?;
        let words = call.shape.list("REG").len() as u16;
        let register = match operation {
            Operation::ShiftLeft => first,
            _ => first + words - 1,
        };
        let unit = self.layout.unit(UnitClass::Shift, span);
        let unit = self.limit(unit)?;
        let coil = self.output_flag(call.instance, "Q")?;
        // Looking at a bit of a register is a function too, which would use up what is latched.
        let enable = self.circuit_argument(call, "EN")?;
        let serial = self.circuit_argument(call, "DATA")?;
        for (latched, prefix) in [(enable, Prefix::Enable), (serial, Prefix::Serial)] {
            let Some(tree) = latched else { continue };
            self.circuit(&tree)?;
            self.prefix(prefix);
        }
        self.circuit(&power)?;
        let timer = TimerType::OffDelay;
        self.run(&Function { operation, unit, timer, register, number: Some(words), coil });
        Ok(coil)
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
            let help =
                "choose the element with a constant, or build it with --emit verilog or vhdl";
            return Err(self.refuse(span, "an element with such an index", label, help));
        };
        let register = self.number(*variable, span)?;
        self.circuit(power)?;
        self.prefix(Prefix::Register(register));
        self.prefix(Prefix::Number(bit as u16));
        self.operation(operation, coil);
        Ok(())
    }

    /// Writes a bit of a register where there is power, and passes the power on. What is looked at
    /// here stands in the image, so neither write changes it.
    pub(super) fn assign_bit(
        &mut self,
        place: &Place,
        value: &Expr,
        span: Span,
        power: Power,
    ) -> Done<Power> {
        let mut left = self.drawn(power)?;
        let value = self.condition(value, span)?;
        if !left.is_wire() {
            left = Tree::Contact(self.single(Power::Drawn(left))?);
        }
        let value = self.single(Power::Drawn(value))?;
        let spare = self.flag()?;
        for (contact, operation) in
            [(value, Operation::BitSet), (opposite(value), Operation::BitClear)]
        {
            let tree = match contact {
                Contact { address: ONE, negated: true } => continue,
                Contact { address: ONE, negated: false } => left.clone(),
                contact => Tree::series([left.clone(), Tree::Contact(contact)]),
            };
            self.register_bit(&tree, operation, place, spare, span)?;
        }
        Ok(Power::Drawn(left))
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
