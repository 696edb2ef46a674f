//! Walks the rungs from top to bottom, left to right, power in hand. Slow, short, plainly right:
//! it shares nothing with the circuits that are judged by it.

use super::recorder::Recorder;
use crate::blocks::Step;
use crate::index::index;
use crate::model::{
    ArgumentValue, Call, CoilAction, Edge, Element, Expr, Net, Place, Program, Role, VariableId,
};

/// A program that runs.
#[derive(Clone, Debug)]
pub struct Evaluator<'p> {
    program: &'p Program,
    values: Vec<i64>,
    first_scan: Option<VariableId>,
    tick: bool,
    recorder: Option<Recorder>,
}

impl<'p> Evaluator<'p> {
    /// The program at reset, inputs 0.
    pub fn new(program: &'p Program) -> Self {
        let first_scan = program.with_role(Role::FirstScan).next().map(|(id, _)| id);
        let mut evaluator =
            Evaluator { program, values: Vec::new(), first_scan, tick: false, recorder: None };
        evaluator.reset();
        evaluator
    }

    /// Back to reset, inputs to 0.
    pub fn reset(&mut self) {
        self.values = self.program.variables.values().map(|variable| variable.initial).collect();
    }

    /// The value of a variable after the last scan, or of an input as it is driven.
    pub fn value(&self, variable: VariableId) -> i64 {
        self.values[index(variable)]
    }

    /// Drives an input.
    pub fn drive(&mut self, input: VariableId, value: i64) {
        debug_assert_eq!(self.program.variables[input].role, Role::Input);
        self.set(input, value);
    }

    /// One scan, with the tick or without.
    pub fn scan(&mut self, tick: bool) {
        self.tick = tick;
        let program = self.program;
        for unit in &program.units {
            self.call(unit, false);
        }
        for rung in &program.rungs {
            self.series(&rung.network, true);
        }
        if let Some(first_scan) = self.first_scan {
            self.set(first_scan, 0);
        }
    }

    /// What it runs.
    pub(super) fn program(&self) -> &Program {
        self.program
    }

    /// Goes on with what every variable holds.
    pub(super) fn resume(&mut self, values: Vec<i64>) {
        debug_assert_eq!(values.len(), self.program.variables.len());
        self.values = values;
    }

    /// What every variable holds.
    pub(super) fn values(&self) -> &[i64] {
        &self.values
    }

    /// One scan, written down by this recorder, which is given back.
    pub(super) fn scan_recorded(&mut self, tick: bool, recorder: Recorder) -> Recorder {
        self.recorder = Some(recorder);
        self.scan(tick);
        self.recorder.take().expect("it was put in before the scan")
    }

    fn set(&mut self, variable: VariableId, value: i64) {
        if let Some(recorder) = &mut self.recorder {
            recorder.write(variable, value);
        }
        self.values[index(variable)] = value;
    }

    fn is_on(&self, variable: VariableId) -> bool {
        self.value(variable) != 0
    }

    fn read(&self, place: &Place) -> i64 {
        place.value(&|variable| self.value(variable))
    }

    /// Writes what the place means now; an index out of range means nothing.
    fn write(&mut self, place: &Place, value: i64) {
        let Some(variable) = place.variable(&|variable| self.value(variable)) else { return };
        let value = match place.bit {
            None => value,
            Some(bit) => {
                let others = self.value(variable) & !(1 << bit);
                self.program.variables[variable].ty.wrap(others | value << bit)
            }
        };
        self.set(variable, value);
        if let Some(fraction) = self.program.fraction_of(variable)
            && value == 0
        {
            self.set(fraction, 0);
        }
    }

    fn series(&mut self, series: &[Element], power: bool) -> bool {
        series.iter().fold(power, |power, element| self.element(element, power))
    }

    fn element(&mut self, element: &Element, power: bool) -> bool {
        if self.recorder.is_none() {
            return self.execute(element, power);
        }
        let entry = self.recorder.as_mut().map(|recorder| recorder.enter(element, power));
        let out = self.execute(element, power);
        if let (Some(recorder), Some(entry)) = (&mut self.recorder, entry) {
            recorder.leave(entry, out);
        }
        out
    }

    fn execute(&mut self, element: &Element, power: bool) -> bool {
        match element {
            Element::Constant(value) => power && *value,
            Element::Contact { place, negated, .. } => power && (self.read(place) != 0) != *negated,
            Element::Edge { place, edge, memory } => {
                let now = self.read(place) != 0;
                self.edge(now, *edge, *memory) && power
            }
            Element::Parallel(branches) => {
                let mut any = false;
                for branch in branches {
                    any |= self.series(branch, power);
                }
                any
            }
            Element::OneShot { edge, memory } => self.edge(power, *edge, *memory),
            Element::Invert => !power,
            Element::Compare(expr, _) => self.expr(expr) != 0 && power,
            Element::Coil { target, action, .. } => {
                self.coil(target, *action, power);
                power
            }
            Element::ResetInstance(instance) => {
                if power {
                    let program = self.program;
                    for (_, member, value) in program.instances[*instance].cleared(program) {
                        self.set(member, value);
                    }
                }
                power
            }
            Element::Assign { target, value, .. } => {
                let value = self.expr(value);
                if power {
                    self.write(target, value);
                }
                power
            }
            Element::Call(call) => {
                if let Some(recorder) = &mut self.recorder {
                    recorder.call(power);
                }
                self.call(call, power)
            }
            Element::Net(net) => self.net(net) && power,
        }
    }

    /// True if some path of connections conducts from the left end to the right one.
    fn net(&mut self, net: &Net) -> bool {
        let mut conducting = Vec::new();
        for connection in &net.connections {
            if self.series(&connection.network, true) {
                conducting.push(connection);
            }
        }
        let mut powered = vec![false; net.nodes.len()];
        powered[Net::LEFT] = true;
        loop {
            let before = powered.clone();
            for connection in &conducting {
                let (from, to) = (connection.from, connection.to);
                powered[to] |= powered[from];
                powered[from] |= connection.both_ways && powered[to];
            }
            if powered == before {
                return powered[Net::RIGHT];
            }
        }
    }

    /// True if `now` has changed since this element saw it last.
    fn edge(&mut self, now: bool, edge: Edge, memory: VariableId) -> bool {
        let before = self.is_on(memory);
        self.set(memory, now.into());
        match edge {
            Edge::Rise => now && !before,
            Edge::Fall => before && !now,
        }
    }

    fn coil(&mut self, target: &Place, action: CoilAction, power: bool) {
        match action {
            CoilAction::Plain => self.write(target, power.into()),
            CoilAction::Negated => self.write(target, (!power).into()),
            CoilAction::Set if power => self.write(target, 1),
            CoilAction::Reset if power => self.write(target, 0),
            CoilAction::Set | CoilAction::Reset => {}
            CoilAction::Edge(edge, memory) => {
                let changed = self.edge(power, edge, memory);
                self.write(target, changed.into());
            }
        }
    }

    fn call(&mut self, call: &Call, power: bool) -> bool {
        let instance = &self.program.instances[call.instance];
        // An argument that reads a member of the block sees what the call before left, also where
        // another argument of this call is about to change it.
        let mut given = Vec::with_capacity(call.arguments.len());
        for argument in &call.arguments {
            given.push(match &argument.value {
                ArgumentValue::Network(network) => self.series(network, true).into(),
                ArgumentValue::Value(expr) => self.expr(expr),
            });
        }
        for (argument, value) in call.arguments.iter().zip(given) {
            self.set(instance.members[argument.port], value);
        }
        let mut values: Vec<i64> =
            instance.members.iter().map(|&member| self.value(member)).collect();
        let shape = &*call.shape;
        (shape.block.step)(&mut Step { shape, power, tick: self.tick, values: &mut values });
        for (&member, value) in instance.members.iter().zip(values) {
            self.set(member, value);
        }
        match shape.main_port() {
            Some(port) => self.is_on(instance.members[port]),
            None => power,
        }
    }

    /// The value of an expression.
    pub fn expr(&self, expr: &Expr) -> i64 {
        expr.value(&|variable| self.value(variable))
    }
}
