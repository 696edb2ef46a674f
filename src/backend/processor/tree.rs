//! What stands between the rail and an output: contacts in series, in parallel and in bridges.

use super::word::{Address, ONE};

/// A contact on a bit of the image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Contact {
    /// The bit.
    pub address: Address,
    /// Normally closed.
    pub negated: bool,
}

/// Contacts, lists and bridges. A series has no series in it, a list no list.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Tree {
    /// One contact.
    Contact(Contact),
    /// From left to right; a wire if it is empty.
    Series(Vec<Tree>),
    /// Branches, upper first; never empty.
    Parallel(Vec<Tree>),
    /// Two paths and a contact between them that conducts both ways.
    Bridge(Box<Bridge>),
}

/// Left - `upper_left` - A - `upper_right` - right, left - `lower_left` - B - `lower_right` -
/// right, and `middle` between A and B.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Bridge {
    /// Between the left end and A.
    pub upper_left: Tree,
    /// Between the left end and B.
    pub lower_left: Tree,
    /// Between A and B.
    pub middle: Contact,
    /// Between A and the right end.
    pub upper_right: Tree,
    /// Between B and the right end.
    pub lower_right: Tree,
}

impl Bridge {
    /// What stands in it besides the contact between the paths.
    pub fn arms(&self) -> [&Tree; 4] {
        [&self.upper_left, &self.lower_left, &self.upper_right, &self.lower_right]
    }
}

impl Tree {
    /// A wire.
    pub const WIRE: Tree = Tree::Series(Vec::new());

    /// A normally open contact.
    pub fn on(address: Address) -> Tree {
        Tree::Contact(Contact { address, negated: false })
    }

    /// A normally closed contact.
    pub fn off(address: Address) -> Tree {
        Tree::Contact(Contact { address, negated: true })
    }

    /// A contact on the constant 1 that conducts always or never.
    pub fn constant(value: bool) -> Tree {
        Tree::Contact(Contact { address: ONE, negated: !value })
    }

    /// One after the other.
    pub fn series(parts: impl IntoIterator<Item = Tree>) -> Tree {
        let mut list = Vec::new();
        for part in parts {
            match part {
                Tree::Series(inner) => list.extend(inner),
                other => list.push(other),
            }
        }
        if list.len() == 1 { list.remove(0) } else { Tree::Series(list) }
    }

    /// One beside the other.
    pub fn parallel(branches: impl IntoIterator<Item = Tree>) -> Tree {
        let mut list = Vec::new();
        for branch in branches {
            match branch {
                Tree::Parallel(inner) => list.extend(inner),
                Tree::Series(parts) if parts.is_empty() => list.push(Tree::constant(true)),
                other => list.push(other),
            }
        }
        if list.len() == 1 { list.remove(0) } else { Tree::Parallel(list) }
    }

    /// The only contact, if there is but one.
    pub fn single(&self) -> Option<Contact> {
        if let Tree::Contact(contact) = self { Some(*contact) } else { None }
    }

    /// True if nothing stands in it.
    pub fn is_wire(&self) -> bool {
        matches!(self, Tree::Series(parts) if parts.is_empty())
    }

    /// What conducts where this does not; nothing for a bridge, which has no such tree.
    pub fn inverted(&self) -> Option<Tree> {
        Some(match self {
            Tree::Contact(Contact { address, negated }) => {
                Tree::Contact(Contact { address: *address, negated: !negated })
            }
            Tree::Series(parts) if parts.is_empty() => Tree::constant(false),
            Tree::Series(parts) => {
                Tree::parallel(parts.iter().map(Tree::inverted).collect::<Option<Vec<_>>>()?)
            }
            Tree::Parallel(branches) => {
                Tree::series(branches.iter().map(Tree::inverted).collect::<Option<Vec<_>>>()?)
            }
            Tree::Bridge(_) => return None,
        })
    }

    /// True if a contact looks at one of these bits.
    pub fn reads(&self, is_one: &impl Fn(Address) -> bool) -> bool {
        match self {
            Tree::Contact(contact) => is_one(contact.address),
            Tree::Series(parts) | Tree::Parallel(parts) => {
                parts.iter().any(|part| part.reads(is_one))
            }
            Tree::Bridge(bridge) => {
                is_one(bridge.middle.address)
                    || bridge.arms().into_iter().any(|arm| arm.reads(is_one))
            }
        }
    }

    /// Whether it conducts.
    pub fn conducts(&self, bit: &impl Fn(Address) -> bool) -> bool {
        match self {
            Tree::Contact(contact) => bit(contact.address) != contact.negated,
            Tree::Series(parts) => parts.iter().all(|part| part.conducts(bit)),
            Tree::Parallel(branches) => branches.iter().any(|branch| branch.conducts(bit)),
            Tree::Bridge(bridge) => {
                let [a, b, c, d] = bridge.arms().map(|arm| arm.conducts(bit));
                let m = Tree::Contact(bridge.middle).conducts(bit);
                (a && c) || (b && d) || (m && ((a && d) || (b && c)))
            }
        }
    }

    /// How many lists stand in each other, a bridge counted as two.
    pub fn height(&self) -> usize {
        match self {
            Tree::Contact(_) => 0,
            Tree::Series(parts) => parts.iter().map(Tree::height).max().unwrap_or(0),
            Tree::Parallel(parts) => 1 + parts.iter().map(Tree::height).max().unwrap_or(0),
            Tree::Bridge(bridge) => {
                2 + bridge.arms().into_iter().map(Tree::height).max().unwrap_or(0)
            }
        }
    }
}
