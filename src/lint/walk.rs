//! The walk over rungs and expectations, and what it notes on its way. All lists are in text order.

use crate::blocks::PortRole;
use crate::index::index;
use crate::model::{
    ArgumentValue, BinaryOp, Call, CoilAction, Element, Expr, ExprKind, Net, Place, Program,
    Relation, Rung, Series, Statement, VariableId,
};
use crate::source::Span;
use crate::types::Type;

/// What is read or written of a variable or array.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Part {
    /// The variable or element; none where an index chooses it while the program runs.
    pub element: Option<VariableId>,
    /// The bit; none for all of it.
    pub bit: Option<u32>,
}

impl Part {
    /// True if writing one may change the other, of the same variable or array.
    pub fn overlaps(self, other: Part) -> bool {
        fn may_meet<T: PartialEq>(a: Option<T>, b: Option<T>) -> bool {
            a.is_none() || b.is_none() || a == b
        }
        may_meet(self.element, other.element) && may_meet(self.bit, other.bit)
    }
}

/// A look at a variable.
#[derive(Clone, Copy)]
pub(super) struct Read {
    /// The variable; of an array the first element.
    pub variable: VariableId,
    pub part: Part,
    /// Number of the rung, from 0.
    pub rung: u32,
    pub span: Span,
}

/// A coil or an assignment.
#[derive(Clone, Copy)]
pub(super) struct Write {
    /// The variable; of an array the first element.
    pub variable: VariableId,
    pub part: Part,
    pub how: Writing,
    /// Number of the rung, from 0.
    pub rung: u32,
    pub span: Span,
}

/// How a variable is written.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Writing {
    /// In every scan, on or off as the power says.
    Coil,
    /// On, in scans with power.
    Set,
    /// Off, in scans with power.
    Reset,
    /// To the value of an expression, in scans with power.
    Assign,
}

/// A comparison of two expressions.
pub(super) struct Comparison<'p> {
    pub relation: Relation,
    pub sides: [&'p Expr; 2],
    pub span: Span,
}

/// A division or remainder that a shift does not do.
pub(super) struct Division {
    /// The divisor, if it is constant.
    pub divisor: Option<i64>,
    /// Of the dividend.
    pub ty: Type,
    pub span: Span,
}

/// How large a rung is.
#[derive(Clone, Copy, Default)]
pub(super) struct Size {
    /// Contacts, coils, blocks and whatever else is drawn.
    pub elements: usize,
    /// Lists inside lists.
    pub nesting: usize,
}

/// Walks over networks and notes what it meets. Nesting is bounded by the parser.
pub(super) struct Walk<'p> {
    program: &'p Program,
    /// Number of the rung that it is in, from 0.
    rung: u32,
    size: Size,
    pub reads: Vec<Read>,
    pub writes: Vec<Write>,
    pub calls: Vec<&'p Call>,
    pub divisions: Vec<Division>,
    pub comparisons: Vec<Comparison<'p>>,
    pub nets: Vec<&'p Net>,
    /// For each instance, whether there is an `(R name)`.
    pub reset: Vec<bool>,
}

impl<'p> Walk<'p> {
    pub fn new(program: &'p Program) -> Self {
        Walk {
            program,
            rung: 0,
            size: Size::default(),
            reads: Vec::new(),
            writes: Vec::new(),
            calls: Vec::new(),
            divisions: Vec::new(),
            comparisons: Vec::new(),
            nets: Vec::new(),
            reset: vec![false; program.instances.len()],
        }
    }

    /// Notes what a rung has, and tells how large it is.
    pub fn rung(&mut self, number: u32, rung: &'p Rung) -> Size {
        self.rung = number;
        self.size = Size::default();
        self.series(&rung.network, 0);
        self.size
    }

    /// Notes what the expectations of a test have.
    pub fn statements(&mut self, statements: &'p [Statement]) {
        for statement in statements {
            match statement {
                Statement::Repeat(_, statements) => self.statements(statements),
                Statement::Expect(expect) => self.series(&expect.network, 0),
                Statement::Drive(..)
                | Statement::Scan(_)
                | Statement::Wait(_)
                | Statement::Reset => {}
            }
        }
    }

    fn series(&mut self, series: &'p Series, nesting: usize) {
        self.size.nesting = self.size.nesting.max(nesting);
        series.iter().for_each(|element| self.element(element, nesting));
    }

    fn element(&mut self, element: &'p Element, nesting: usize) {
        self.size.elements += 1;
        match element {
            Element::Constant(_) | Element::OneShot { .. } | Element::Invert => {}
            Element::Contact { place, span, .. } => self.read(place, *span),
            Element::Edge { place, memory, .. } => {
                self.read(place, self.program.variables[*memory].span);
            }
            Element::Parallel(branches) => {
                // The list itself is no element: its branches are.
                self.size.elements -= 1;
                branches.iter().for_each(|branch| self.series(branch, nesting + 1));
            }
            Element::Compare(expr, span) => self.expr(expr, *span),
            Element::Coil { target, action, span } => {
                let how = match action {
                    CoilAction::Plain | CoilAction::Negated | CoilAction::Edge(..) => Writing::Coil,
                    CoilAction::Set => Writing::Set,
                    CoilAction::Reset => Writing::Reset,
                };
                self.write(target, how, *span);
            }
            Element::ResetInstance(instance) => {
                self.reset[index(*instance)] = true;
            }
            Element::Assign { target, value, span } => {
                self.expr(value, *span);
                self.write(target, Writing::Assign, *span);
            }
            Element::Call(call) => self.call(call),
            Element::Net(net) => {
                self.size.elements -= 1;
                self.nets.push(net);
                let connections = &net.connections;
                connections.iter().for_each(|one| self.series(&one.network, nesting + 1));
            }
        }
    }

    fn call(&mut self, call: &'p Call) {
        self.calls.push(call);
        for argument in call.arguments.iter().chain(&call.starts) {
            match &argument.value {
                // A network in an argument is drawn beside the rung: it starts anew.
                ArgumentValue::Network(network) => self.series(network, 0),
                ArgumentValue::Value(expr) => self.expr(expr, argument.span),
            }
        }
        // A register is changed in place.
        let instance = &self.program.instances[call.instance];
        for (port, &word) in instance.shape.ports.iter().zip(&instance.members) {
            if port.role == PortRole::Register {
                let array = self.program.array_of(word);
                let variable =
                    array.map_or(word, |array| self.program.arrays[array].elements.first);
                let part = Part { element: Some(word), bit: None };
                let (rung, span) = (self.rung, instance.span);
                self.reads.push(Read { variable, part, rung, span });
                self.writes.push(Write { variable, part, how: Writing::Assign, rung, span });
            }
        }
    }

    fn expr(&mut self, expr: &'p Expr, span: Span) {
        match &expr.kind {
            ExprKind::Read(place) => {
                self.read(place, span);
                return;
            }
            ExprKind::Compare(relation, a, b) => {
                self.comparisons.push(Comparison { relation: *relation, sides: [a, b], span });
            }
            ExprKind::Binary(BinaryOp::Divide | BinaryOp::Modulo, a, b) => {
                let divisor = b.constant();
                let is_cheap =
                    |divisor: i64| divisor == 0 || divisor.unsigned_abs().is_power_of_two();
                if !divisor.is_some_and(is_cheap) {
                    self.divisions.push(Division { divisor, ty: a.ty, span });
                }
            }
            ExprKind::Constant(_)
            | ExprKind::Not(_)
            | ExprKind::Convert(_)
            | ExprKind::Binary(..)
            | ExprKind::Call(..) => {}
        }
        expr.parts().into_iter().for_each(|part| self.expr(part, span));
    }

    fn read(&mut self, place: &'p Place, span: Span) {
        let (variable, part) = self.part(place, span);
        self.reads.push(Read { variable, part, rung: self.rung, span });
    }

    fn write(&mut self, place: &'p Place, how: Writing, span: Span) {
        let (variable, part) = self.part(place, span);
        self.writes.push(Write { variable, part, how, rung: self.rung, span });
    }

    /// The variable or array of a place, and the part of it that is meant. What an index reads is
    /// noted.
    fn part(&mut self, place: &'p Place, span: Span) -> (VariableId, Part) {
        place.index().into_iter().for_each(|index| self.expr(index, span));
        let variable = place.declared();
        let element = place.index().is_none().then_some(variable);
        let array = self.program.array_of(variable);
        let declared = array.map_or(variable, |array| self.program.arrays[array].elements.first);
        (declared, Part { element, bit: place.bit })
    }
}
