//! Who reads and writes what: built once, looked up by every rule.

use crate::blocks::PortRole;
use crate::index::index;
use crate::model::{
    Argument, ArgumentValue, BinaryOp, Call, CoilAction, Element, Expr, ExprKind, InstanceId, Net,
    Place, Program, Relation, Series, Statement, VariableId,
};
use crate::source::Span;
use crate::types::Type;

/// What is read or written of a variable or array.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Part {
    /// The variable or element; none where an index chooses it while the program runs.
    element: Option<VariableId>,
    /// The bit; none for all of it.
    bit: Option<u32>,
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

/// Everything that rules ask for. All lists are in text order, which is execution order.
pub(super) struct Index<'p> {
    pub program: &'p Program,
    /// Frequency of the board's clock in Hz.
    pub clock_hz: u64,
    pub reads: Vec<Read>,
    pub writes: Vec<Write>,
    pub comparisons: Vec<Comparison<'p>>,
    pub divisions: Vec<Division>,
    pub nets: Vec<&'p Net>,
    /// For each rung.
    pub sizes: Vec<Size>,
    /// For each variable, the number of its reads in rungs.
    read_counts: Vec<u32>,
    /// For each rung and one more, where its reads and its writes start.
    rungs: Vec<(usize, usize)>,
    /// For each variable, whether a test looks at it.
    read_by_tests: Vec<bool>,
    /// The writes again, those of one variable next to each other.
    writes_by_variable: Vec<Write>,
    /// For each variable and one more, where its writes start in `writes_by_variable`.
    starts: Vec<u32>,
    /// For each instance, whether there is an `(R name)`.
    reset: Vec<bool>,
    /// For each instance, its call; where it has two, the first.
    call_of: Vec<Option<&'p Call>>,
}

impl<'p> Index<'p> {
    pub fn new(program: &'p Program, clock_hz: u64) -> Self {
        let mut walk = Walk::new(program);
        let mut sizes = Vec::with_capacity(program.rungs.len());
        let mut rungs = vec![(0, 0)];
        for (number, rung) in program.rungs.iter().enumerate() {
            walk.rung = number as u32;
            walk.size = Size::default();
            walk.series(&rung.network, 0);
            sizes.push(walk.size);
            rungs.push((walk.reads.len(), walk.writes.len()));
        }
        let mut tests = Walk::new(program);
        program.tests.iter().for_each(|test| tests.statements(&test.statements));
        let mut read_by_tests = vec![false; program.variables.len()];
        tests.reads.iter().for_each(|read| read_by_tests[index(read.variable)] = true);
        let mut read_counts = vec![0; program.variables.len()];
        walk.reads.iter().for_each(|read| read_counts[index(read.variable)] += 1);
        let Walk { reads, writes, calls, comparisons, divisions, nets, reset, .. } = walk;
        let mut call_of = vec![None; program.instances.len()];
        for &call in &calls {
            call_of[index(call.instance)].get_or_insert(call);
        }
        let mut writes_by_variable = writes.clone();
        // The sort is stable, so the writes of a variable stay in text order.
        writes_by_variable.sort_by_key(|write| index(write.variable));
        let mut starts = vec![0; program.variables.len() + 1];
        writes.iter().for_each(|write| starts[index(write.variable) + 1] += 1);
        for variable in 1..starts.len() {
            starts[variable] += starts[variable - 1];
        }
        Index {
            program,
            clock_hz,
            reads,
            writes,
            divisions,
            comparisons,
            nets,
            sizes,
            read_counts,
            rungs,
            read_by_tests,
            writes_by_variable,
            starts,
            reset,
            call_of,
        }
    }

    /// The name of a variable as a user declares it.
    pub fn name(&self, variable: VariableId) -> &'p str {
        match self.program.array_of(variable) {
            Some(array) => &self.program.arrays[array].name,
            None => &self.program.variables[variable].name,
        }
    }

    /// The name of a part of a variable as a user writes it.
    pub fn part_name(&self, variable: VariableId, part: Part) -> String {
        let name = match part.element {
            Some(element) => &self.program.variables[element].name,
            None => self.name(variable),
        };
        match part.bit {
            Some(bit) => format!("{name}.{bit}"),
            None => name.to_owned(),
        }
    }

    /// The value at reset of a part that is always the same.
    pub fn initial(&self, part: Part) -> i64 {
        let value = part.element.map_or(0, |element| self.program.variables[element].initial);
        part.bit.map_or(value, |bit| value >> bit & 1)
    }

    /// True for every element of an array but the first, which stands for all.
    pub fn is_further_element(&self, variable: VariableId) -> bool {
        let array = self.program.array_of(variable);
        array.is_some_and(|array| self.program.arrays[array].elements.first != variable)
    }

    /// True if a rung looks at the variable.
    pub fn is_read(&self, variable: VariableId) -> bool {
        self.read_counts[index(variable)] > 0
    }

    /// True if a test looks at the variable.
    pub fn is_read_by_tests(&self, variable: VariableId) -> bool {
        self.read_by_tests[index(variable)]
    }

    /// The reads in a rung.
    pub fn reads_in(&self, rung: u32) -> &[Read] {
        let rung = rung as usize;
        &self.reads[self.rungs[rung].0..self.rungs[rung + 1].0]
    }

    /// The writes in a rung.
    pub fn writes_in(&self, rung: u32) -> &[Write] {
        let rung = rung as usize;
        &self.writes[self.rungs[rung].1..self.rungs[rung + 1].1]
    }

    /// The writes of a variable in text order.
    pub fn writes_of(&self, variable: VariableId) -> &[Write] {
        let range =
            self.starts[index(variable)] as usize..self.starts[index(variable) + 1] as usize;
        &self.writes_by_variable[range]
    }

    /// Every part that is written and always the same, with all the writes that may change it.
    pub fn written(&self) -> Vec<Written> {
        let mut written = Vec::new();
        for writes in self.writes_by_variable.chunk_by(|a, b| a.variable == b.variable) {
            let mut by_element = writes.to_vec();
            by_element.sort_by_key(|write| write.part.element.map(index));
            let chosen = by_element.partition_point(|write| write.part.element.is_none());
            let (chosen, known) = by_element.split_at(chosen);
            for of_element in known.chunk_by(|a, b| a.part.element == b.part.element) {
                let mut parts: Vec<Part> = Vec::new();
                for write in of_element {
                    if !parts.contains(&write.part) {
                        parts.push(write.part);
                    }
                }
                written.extend(parts.into_iter().map(|part| {
                    let all = chosen.iter().chain(of_element).copied();
                    let writes = all.filter(|write| write.part.overlaps(part)).collect();
                    Written { variable: of_element[0].variable, part, writes }
                }));
            }
        }
        written
    }

    /// What the call of an instance gives to a parameter.
    pub fn argument(&self, instance: InstanceId, port: usize) -> Option<&'p Argument> {
        let call = self.call_of[index(instance)]?;
        call.arguments.iter().chain(&call.starts).find(|argument| argument.port == port)
    }

    /// The call of each instance, without second calls.
    pub fn calls(&self) -> impl Iterator<Item = &'p Call> {
        self.call_of.iter().flatten().copied()
    }

    /// True if a coil resets the instance.
    pub fn is_reset(&self, instance: InstanceId) -> bool {
        self.reset[index(instance)]
    }
}

/// A part of a variable and what writes it.
pub(super) struct Written {
    pub variable: VariableId,
    pub part: Part,
    pub writes: Vec<Write>,
}

/// Walks over networks and notes what it meets. Nesting is bounded by the parser.
struct Walk<'p> {
    program: &'p Program,
    rung: u32,
    size: Size,
    reads: Vec<Read>,
    writes: Vec<Write>,
    calls: Vec<&'p Call>,
    divisions: Vec<Division>,
    comparisons: Vec<Comparison<'p>>,
    nets: Vec<&'p Net>,
    reset: Vec<bool>,
}

impl<'p> Walk<'p> {
    fn new(program: &'p Program) -> Self {
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

    fn statements(&mut self, statements: &'p [Statement]) {
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
