//! The checked program: names resolved, types known, nothing left that a user could get wrong.

mod expr;
mod names;
mod net;
mod place;
mod test;

use std::sync::Arc;

use la_arena::{Arena, Idx};

use crate::blocks::{Port, Shape};
use crate::index::index;
use crate::source::Span;
use crate::types::Type;

pub use crate::syntax::ast::Edge;
pub use expr::{BinaryOp, Expr, ExprKind, Function, Relation, convert};
pub use names::Names;
pub use net::{Connection, Net, Node};
pub use place::{Base, Elements, Place};
pub use test::{Expect, Statement, Test};

/// One of a program's variables.
pub type VariableId = Idx<Variable>;
/// One of a program's block instances.
pub type InstanceId = Idx<Instance>;
/// One of a program's arrays: its place in [`Program::arrays`].
pub type ArrayId = usize;

/// A checked program.
#[derive(Debug, Default)]
pub struct Program {
    /// Letters, digits and underscores: the name of the module and of its files.
    pub name: String,
    /// The title of the header.
    pub title: Option<String>,
    /// Frequency of the board's clock in Hz.
    pub clock_hz: u64,
    /// Length of a tick in nanoseconds.
    pub tick_ns: u64,
    /// Everything that holds a value from scan to scan, each element of the state once.
    pub variables: Arena<Variable>,
    /// The arrays, in the order of their elements among the variables.
    pub arrays: Vec<Array>,
    /// The block instances in text order of their calls.
    pub instances: Arena<Instance>,
    /// The dividers that make units of time of the tick. They are called in front of the rungs, and
    /// the power does not matter to them.
    pub units: Vec<Call>,
    /// The rungs in text order.
    pub rungs: Vec<Rung>,
    /// The tests in text order.
    pub tests: Vec<Test>,
    /// The named constants; wherever one is used, its value stands already.
    pub constants: Vec<Constant>,
    /// Where a divisor is the constant 0, each place once or more often.
    pub zero_divisors: Vec<Span>,
}

impl Program {
    /// The variables of one role, in the order of their declaration.
    pub fn with_role(&self, role: Role) -> impl Iterator<Item = (VariableId, &Variable)> {
        self.variables.iter().filter(move |(_, variable)| variable.role == role)
    }

    /// The array that a variable is an element of, if it is one.
    pub fn array_of(&self, variable: VariableId) -> Option<ArrayId> {
        let starts_before = |array: &Array| index(array.elements.first) <= index(variable);
        let id = self.arrays.partition_point(starts_before).checked_sub(1)?;
        let Elements { first, length } = self.arrays[id].elements;
        (index(variable) - index(first) < length as usize).then_some(id)
    }

    /// True if a program can name the variable.
    pub fn is_named(&self, variable: &Variable) -> bool {
        match variable.role {
            Role::Input | Role::Output | Role::Local => true,
            Role::Member(instance, port) => {
                let instance = &self.instances[instance];
                !instance.is_hidden && instance.shape.ports[port].role.is_member()
            }
            Role::EdgeMemory | Role::FirstScan => false,
        }
    }

    /// Every variable that a user can name, in the order of declarations and calls.
    pub fn named_variables(&self) -> impl Iterator<Item = (VariableId, &Variable)> {
        self.variables.iter().filter(|(_, variable)| self.is_named(variable))
    }

    /// For a block's accumulator, what counts the parts of one of its units: an assignment of 0 to
    /// the first clears the second.
    pub fn fraction_of(&self, variable: VariableId) -> Option<VariableId> {
        let Role::Member(instance, port) = self.variables[variable].role else { return None };
        let instance = &self.instances[instance];
        let fraction = instance.shape.ports[port].fraction?;
        Some(instance.members[instance.shape.port_named(fraction)?])
    }

    /// Puts the rungs into another order: their places now, each once.
    ///
    /// # Panics
    /// If a place is there twice or not at all.
    pub fn reorder(&mut self, places: &[u32]) {
        let mut rungs: Vec<Option<Rung>> =
            std::mem::take(&mut self.rungs).into_iter().map(Some).collect();
        let moved = places.iter().map(|&place| rungs[place as usize].take());
        self.rungs = moved.map(|rung| rung.expect("each place is there once")).collect();
        assert!(rungs.iter().all(Option::is_none), "each place is there");
    }
}

/// Something that holds a value of one scalar type.
#[derive(Debug)]
pub struct Variable {
    /// The user's name; `instance.MEMBER` for a member; a made-up name for the others.
    pub name: Arc<str>,
    /// Its type.
    pub ty: Type,
    /// Its value at reset, in the type's range.
    pub initial: i64,
    /// True if the program says that value.
    pub is_initialised: bool,
    /// What it is there for.
    pub role: Role,
    /// Its image address in the ladder processor, if the program fixes one.
    pub address: Option<u16>,
    /// Where it is declared, or the element that needs it.
    pub span: Span,
}

/// Variables under one name.
#[derive(Debug)]
pub struct Array {
    /// The user's name.
    pub name: Arc<str>,
    /// Its variables; each is named `name[index]`.
    pub elements: Elements,
}

/// A name for a value.
#[derive(Debug)]
pub struct Constant {
    /// The user's name.
    pub name: String,
    /// True if something names it.
    pub is_used: bool,
    /// Where it is declared.
    pub span: Span,
}

/// What a variable is there for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// Sampled at the start of a scan, never written.
    Input,
    /// Shown at the end of a scan.
    Output,
    /// Kept inside.
    Local,
    /// A port of a block instance, by its index in [`Shape::ports`].
    Member(InstanceId, usize),
    /// What an edge element saw when it looked last.
    EdgeMemory,
    /// 1 in the first scan after reset.
    FirstScan,
}

impl Role {
    /// True if a user can name the variable in a program.
    pub fn is_named(self) -> bool {
        !matches!(self, Role::EdgeMemory | Role::FirstScan)
    }
}

/// A function block that the program calls.
#[derive(Debug)]
pub struct Instance {
    /// The user's name.
    pub name: String,
    /// Its kind, settings and ports. Where two kinds are called on it, the first one's, and a port
    /// that one of them writes is written.
    pub shape: Arc<Shape>,
    /// True for what the program does not name: a divider.
    pub is_hidden: bool,
    /// True if a second kind is called on it.
    pub has_partner: bool,
    /// One variable for each of the block's ports, in their order.
    pub members: Vec<VariableId>,
    /// For each port, whether the call gives it an argument.
    pub given: Vec<bool>,
    /// Where it is called.
    pub span: Span,
}

impl Instance {
    /// What `(R name)` makes of each port that it puts back, as the port's variable and its value.
    pub fn cleared<'p>(
        &'p self,
        program: &'p Program,
    ) -> impl Iterator<Item = (&'p Port, VariableId, i64)> {
        let ports = self.shape.ports.iter().zip(&self.members);
        ports.filter(|(port, _)| port.role.is_cleared()).map(|(port, &member)| {
            let value = port.cleared.unwrap_or(program.variables[member].initial);
            (port, member, value)
        })
    }
}

/// One rung.
#[derive(Debug)]
pub struct Rung {
    /// The title.
    pub title: Option<String>,
    /// What stands between the rails.
    pub network: Series,
    /// Its place.
    pub span: Span,
    /// The line, from 1, on which it starts.
    pub line: u32,
    /// Its number, from 1, in the order of the text.
    pub number: u32,
}

/// Elements from left to right; never empty.
pub type Series = Vec<Element>;

/// One element of a network.
#[derive(Debug)]
pub enum Element {
    /// A wire or an open contact.
    Constant(bool),
    /// Conducts while the place is 1, or, negated, while it is 0.
    Contact {
        /// A `BOOL`.
        place: Place,
        /// Normally closed.
        negated: bool,
        /// Its place.
        span: Span,
    },
    /// Conducts in the scan of a change.
    Edge {
        /// A `BOOL`.
        place: Place,
        /// Which change.
        edge: Edge,
        /// Of role [`Role::EdgeMemory`], this element's alone.
        memory: VariableId,
    },
    /// Branches, upper first; never empty.
    Parallel(Vec<Series>),
    /// Power out is 1 in the scan in which the power in changes.
    OneShot {
        /// Which change.
        edge: Edge,
        /// Of role [`Role::EdgeMemory`], this element's alone.
        memory: VariableId,
    },
    /// Inverts the power.
    Invert,
    /// Conducts while a `BOOL` expression holds; with its place.
    Compare(Expr, Span),
    /// Writes a `BOOL` from the power and passes the power on.
    Coil {
        /// A `BOOL`, not of an input.
        target: Place,
        /// What it writes.
        action: CoilAction,
        /// Its place.
        span: Span,
    },
    /// Puts a block instance back to its start when powered; passes the power on.
    ResetInstance(InstanceId),
    /// Writes when powered; passes the power on.
    Assign {
        /// Not of an input.
        target: Place,
        /// Of the target's type.
        value: Expr,
        /// Its place.
        span: Span,
    },
    /// Runs a block with the power as its main input; its main output goes on.
    Call(Call),
    /// Lets the power pass where some path of connections conducts.
    Net(Net),
}

impl Element {
    /// True for what lets power pass or not whatever power arrives, and puts nothing out.
    pub fn only_looks(&self) -> bool {
        match self {
            Element::Constant(_)
            | Element::Contact { .. }
            | Element::Edge { .. }
            | Element::Compare(..)
            | Element::Net(_) => true,
            Element::Parallel(branches) => branches.iter().flatten().all(Element::only_looks),
            Element::OneShot { .. }
            | Element::Invert
            | Element::Coil { .. }
            | Element::ResetInstance(_)
            | Element::Assign { .. }
            | Element::Call(_) => false,
        }
    }
}

/// What a coil writes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CoilAction {
    /// The power.
    Plain,
    /// The inverted power.
    Negated,
    /// 1 when powered, else nothing.
    Set,
    /// 0 when powered, else nothing.
    Reset,
    /// 1 in the scan in which the power changes, else 0.
    Edge(Edge, VariableId),
}

/// The call of a block instance.
#[derive(Debug)]
pub struct Call {
    /// Which instance.
    pub instance: InstanceId,
    /// What is called on it, with the same ports in the same order.
    pub shape: Arc<Shape>,
    /// What is handed over in every scan, in text order; a parameter that is not among them keeps
    /// its variable's value.
    pub arguments: Vec<Argument>,
    /// What the call gives at reset only: the members' initial values are these already.
    pub starts: Vec<Argument>,
}

impl Call {
    /// The circuits that it is given, in text order.
    pub fn networks(&self) -> impl Iterator<Item = &Series> {
        self.arguments.iter().filter_map(|argument| match &argument.value {
            ArgumentValue::Network(network) => Some(network),
            ArgumentValue::Value(_) => None,
        })
    }
}

/// A parameter and what it is given, by the index of the block's port.
#[derive(Debug)]
pub struct Argument {
    /// Index in [`Shape::ports`].
    pub port: usize,
    /// What it is given.
    pub value: ArgumentValue,
    /// Its place, from the parameter's name on.
    pub span: Span,
}

/// What a parameter is given.
#[derive(Debug)]
pub enum ArgumentValue {
    /// A network fed with power 1, without outputs and blocks.
    Network(Series),
    /// An expression of the parameter's type.
    Value(Expr),
}
