//! Power between the elements of a rung: drawn, or worked out and in hand.
//!
//! It is carried along as a drawing of contacts that is not worked out yet, as long as nothing
//! between here and its use writes what it looks at. Where something does, or where it is needed
//! more than once, it goes into a flag.

use super::compile::{Compiler, Done};
use super::encode::fit;
use super::tree::{Contact, Tree};
use super::word::{Address, ONE, Operation};

/// The power at a place of a rung.
pub(super) enum Power {
    /// These contacts, worked out when it is used.
    Drawn(Tree),
    /// In hand: the last word left it. A contact with the same value, if there is one.
    InHand(Option<Contact>),
}

impl Compiler<'_> {
    /// Works a power out, so that it is in hand.
    pub(super) fn circuit(&mut self, tree: &Tree) -> Done<()> {
        let mut full = None;
        let fitted = fit(tree, self.rom.sizes.stack_depth, || {
            self.flag().unwrap_or_else(|reported| {
                full = Some(reported);
                0
            })
        });
        if let Some(reported) = full {
            return Err(reported);
        }
        for (words, flag) in fitted.before {
            words.into_iter().for_each(|word| self.word(word));
            self.operation(Operation::Coil, flag);
        }
        fitted.words.into_iter().for_each(|word| self.word(word));
        Ok(())
    }

    /// Works a power out and writes an output with it.
    pub(super) fn output(&mut self, tree: &Tree, operation: Operation, coil: Address) -> Done<()> {
        self.circuit(tree)?;
        self.operation(operation, coil);
        Ok(())
    }

    /// Puts a power into a flag.
    pub(super) fn flagged(&mut self, tree: &Tree) -> Done<Contact> {
        let coil = self.flag()?;
        self.output(tree, Operation::Coil, coil)?;
        Ok(Contact { address: coil, negated: false })
    }

    /// What conducts where a tree does not.
    pub(super) fn inverted(&mut self, tree: &Tree) -> Done<Tree> {
        match tree.inverted() {
            Some(inverted) => Ok(inverted),
            None => Ok(Tree::off(self.flagged(tree)?.address)),
        }
    }

    /// The power as a drawing.
    pub(super) fn drawn(&mut self, power: Power) -> Done<Tree> {
        match power {
            Power::Drawn(tree) => Ok(tree),
            Power::InHand(Some(contact)) => Ok(Tree::Contact(contact)),
            Power::InHand(None) => {
                let coil = self.flag()?;
                self.operation(Operation::Coil, coil);
                Ok(Tree::on(coil))
            }
        }
    }

    /// The power as one contact.
    pub(super) fn single(&mut self, power: Power) -> Done<Contact> {
        let tree = self.drawn(power)?;
        match tree.single() {
            Some(contact) => Ok(contact),
            None if tree.is_wire() => Ok(Contact { address: ONE, negated: false }),
            None => self.flagged(&tree),
        }
    }

    /// An output that leaves the power in hand.
    pub(super) fn write(
        &mut self,
        power: Power,
        operation: Operation,
        coil: Address,
    ) -> Done<Power> {
        let same = self.worked_out(power)?;
        self.operation(operation, coil);
        let same = same.filter(|contact| contact.address != coil);
        let written = |negated| Some(Contact { address: coil, negated });
        Ok(Power::InHand(match operation {
            Operation::Coil => same.or(written(false)),
            Operation::Inverted => same.or(written(true)),
            _ => same,
        }))
    }

    /// Works the power out where it is only drawn.
    pub(super) fn in_hand(&mut self, power: Power) -> Done<Power> {
        self.worked_out(power).map(Power::InHand)
    }

    /// The same, as a contact of that value if there is one.
    fn worked_out(&mut self, power: Power) -> Done<Option<Contact>> {
        match power {
            Power::Drawn(tree) => {
                self.circuit(&tree)?;
                Ok(tree.single())
            }
            Power::InHand(same) => Ok(same),
        }
    }
}
