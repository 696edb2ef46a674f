//! The elements of a rung, from left to right: what only looks becomes part of the drawn power,
//! what writes cuts the rung into circuits.

use super::compile::{Compiler, Done, Reported};
use super::power::Power;
use super::tree::{Contact, Tree};
use super::word::{Address, Operation};
use crate::model::{CoilAction, Edge, Element, InstanceId, Place, Role, VariableId};
use crate::source::Span;

impl Compiler<'_> {
    /// Elements from left to right; the power behind them counts only if it is wanted.
    pub(super) fn series(
        &mut self,
        elements: &[Element],
        power: Power,
        wanted: bool,
    ) -> Done<Power> {
        let mut power = power;
        for (index, element) in elements.iter().enumerate() {
            let wanted = wanted || index + 1 < elements.len();
            power = self.element(element, power, wanted)?;
        }
        Ok(power)
    }

    fn element(&mut self, element: &Element, power: Power, wanted: bool) -> Done<Power> {
        if element.only_looks() {
            // What an edge contact writes is its own, so the drawn power stays what it is.
            let left = self.drawn(power)?;
            let part = self.contacts(element)?;
            return Ok(Power::Drawn(Tree::series([left, part])));
        }
        match element {
            Element::Parallel(branches) => self.list(branches, power, wanted),
            Element::OneShot { edge, memory } => {
                let now = self.single(power)?;
                let coil = self.flag()?;
                self.change(now, *edge, *memory, coil)?;
                Ok(Power::Drawn(Tree::on(coil)))
            }
            Element::Invert => match power {
                Power::InHand(None) => {
                    let coil = self.flag()?;
                    self.operation(Operation::Inverted, coil);
                    Ok(Power::Drawn(Tree::on(coil)))
                }
                power => {
                    let tree = self.drawn(power)?;
                    self.inverted(&tree).map(Power::Drawn)
                }
            },
            Element::Coil { target, action, span } => match target.as_variable() {
                Some(target) => self.coil(target, *action, power),
                None => self.register_coil(target, *action, *span, power),
            },
            Element::ResetInstance(instance) => self.reset_instance(*instance, power),
            Element::Assign { target, value, span } if target.bit.is_some() => {
                self.assign_bit(target, value, *span, power)
            }
            Element::Assign { target, value, span } => {
                let target = self.whole(target, *span)?;
                self.assign(target, value, *span, power)
            }
            Element::Call(call) => self.call(call, power),
            Element::Constant(_)
            | Element::Contact { .. }
            | Element::Edge { .. }
            | Element::Net(_)
            | Element::Compare(..) => unreachable!("they are contacts"),
        }
    }

    /// Something that only looks, as a drawing.
    pub(super) fn contacts(&mut self, element: &Element) -> Done<Tree> {
        match element {
            Element::Constant(value) => Ok(Tree::constant(*value)),
            Element::Contact { place, negated, span } => {
                let address = self.bit_of(place, *span)?;
                Ok(Tree::Contact(Contact { address, negated: *negated }))
            }
            Element::Edge { place, edge, memory } => {
                let span = self.program.variables[*memory].span;
                let address = self.bit_of(place, span)?;
                let coil = self.flag()?;
                self.change(Contact { address, negated: false }, *edge, *memory, coil)?;
                Ok(Tree::on(coil))
            }
            Element::Parallel(branches) => {
                let mut list = Vec::with_capacity(branches.len());
                for branch in branches {
                    list.push(self.all_contacts(branch)?);
                }
                Ok(Tree::parallel(list))
            }
            Element::Compare(expr, span) => self.condition(expr, *span),
            Element::Net(net) => self.net(net),
            _ => unreachable!("it only looks"),
        }
    }

    pub(super) fn all_contacts(&mut self, elements: &[Element]) -> Done<Tree> {
        let mut parts = Vec::with_capacity(elements.len());
        for element in elements {
            parts.push(self.contacts(element)?);
        }
        Ok(Tree::series(parts))
    }

    /// A place that is a whole variable, and always the same one.
    pub(super) fn whole(&mut self, place: &Place, span: Span) -> Done<VariableId> {
        place.as_variable().ok_or_else(|| {
            let label = format!("`{}` has no address of its own", place.name(self.program));
            let help = "choose it with a constant, or build it with --emit verilog or vhdl";
            self.refuse(span, "elements chosen while it runs", label, help)
        })
    }

    /// The address of a bit that a contact looks at.
    pub(super) fn readable(&mut self, variable: VariableId, span: Span) -> Done<Address> {
        if let Some(address) = self.address(variable) {
            return Ok(address);
        }
        let name = &self.program.variables[variable].name;
        Err(match self.program.variables[variable].role {
            // The call is reported; a member of what the processor does not have is no other
            // mistake.
            Role::Member(..) => Reported,
            _ => self.cannot(span, "this contact", format!("`{name}` has no image address")),
        })
    }

    /// Branches with outputs in them: each is worked out in its turn.
    fn list(&mut self, branches: &[Vec<Element>], power: Power, wanted: bool) -> Done<Power> {
        let writes = |compiler: &Self, branches: &[Vec<Element>]| {
            let mut written = Vec::new();
            branches.iter().flatten().for_each(|element| compiler.written(element, &mut written));
            written
        };
        let written = writes(self, branches);
        let mut left = self.drawn(power)?;
        let is_shared = left.single().is_none() && !left.is_wire();
        if is_shared || left.reads(&|address| written.contains(&address)) {
            left = Tree::Contact(self.flagged(&left)?);
        }
        let mut results: Vec<Tree> = Vec::new();
        for (index, branch) in branches.iter().enumerate() {
            let power = self.series(branch, Power::Drawn(left.clone()), wanted)?;
            if wanted {
                let mut result = self.drawn(power)?;
                let later = writes(self, &branches[index + 1..]);
                if result.reads(&|address| later.contains(&address)) {
                    result = Tree::Contact(self.flagged(&result)?);
                }
                results.push(result);
            }
        }
        Ok(if wanted { Power::Drawn(Tree::parallel(results)) } else { Power::InHand(None) })
    }

    /// The bits that an element writes and that others can see.
    fn written(&self, element: &Element, written: &mut Vec<Address>) {
        let members = |instance: InstanceId| {
            let members = &self.program.instances[instance].members;
            members.iter().filter_map(|&member| self.address(member)).collect::<Vec<_>>()
        };
        match element {
            Element::Coil { target, .. } | Element::Assign { target, .. } => {
                written.extend(target.as_variable().and_then(|target| self.address(target)));
            }
            Element::ResetInstance(instance) => written.extend(members(*instance)),
            Element::Call(call) => written.extend(members(call.instance)),
            Element::Parallel(branches) => {
                branches.iter().flatten().for_each(|element| self.written(element, written));
            }
            Element::Constant(_)
            | Element::Contact { .. }
            | Element::Edge { .. }
            | Element::OneShot { .. }
            | Element::Invert
            | Element::Net(_)
            | Element::Compare(..) => {}
        }
    }

    /// `coil` is 1 in the scan of a change; the memory then holds what was seen.
    pub(super) fn change(
        &mut self,
        now: Contact,
        edge: Edge,
        memory: VariableId,
        coil: Address,
    ) -> Done<()> {
        let memory = self.address(memory).ok_or(Reported)?;
        let fell = Contact { negated: !now.negated, ..now };
        let changed = match edge {
            Edge::Rise => [Tree::Contact(now), Tree::off(memory)],
            Edge::Fall => [Tree::Contact(fell), Tree::on(memory)],
        };
        self.output(&Tree::series(changed), Operation::Coil, coil)?;
        self.output(&Tree::Contact(now), Operation::Coil, memory)
    }

    fn coil(&mut self, target: VariableId, action: CoilAction, power: Power) -> Done<Power> {
        let coil = self.address(target).expect("a coil is a BOOL that is declared");
        let operation = match action {
            CoilAction::Plain => Operation::Coil,
            CoilAction::Negated => Operation::Inverted,
            CoilAction::Set => Operation::Set,
            CoilAction::Reset => Operation::Reset,
            CoilAction::Edge(edge, memory) => {
                let mut now = self.single(power)?;
                if now.address == coil {
                    now = self.flagged(&Tree::Contact(now))?;
                }
                self.change(now, edge, memory, coil)?;
                return Ok(Power::Drawn(Tree::Contact(now)));
            }
        };
        self.write(power, operation, coil)
    }
}
