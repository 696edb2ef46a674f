//! Why a block shows what it shows: by trying what it would show if something had been different.

use super::explain::Explainer;
use super::sites::Site;
use super::{Cause, Power, Reason};
use crate::blocks::Step;
use crate::model::{Argument, ArgumentValue, Call, VariableId};
use crate::types::Type;

/// What would change what a block shows.
struct Decisive {
    /// The opposite power.
    power: bool,
    /// Networks in arguments that conduct, if one of them did not.
    arguments: Vec<usize>,
    /// Time runs: with the tick the block is another one than without.
    runs: bool,
}

impl<'p> Explainer<'_, 'p> {
    /// Why a member is what a call has made it.
    ///
    /// What would have made it different in this scan is its cause. If nothing would, the block
    /// remembers, and the cause lies in the scan in which it took its value. But where time runs,
    /// or it is off with power, the power has not been what it is for long enough. How a number
    /// came about is always in the scan that made it.
    pub(super) fn call(
        &mut self,
        cause: Cause,
        id: VariableId,
        by: Site<'p>,
        call: &'p Call,
        depth: usize,
    ) -> Cause {
        let scan = cause.scan;
        let power = self.power(by, call, id, scan);
        let mut decisive = self.decisive(by, call, id, scan);
        let is_number = cause.ty != Type::Bool;
        let waits = decisive.runs || (cause.value == 0 && power.is_on);
        let is_decided = decisive.power || !decisive.arguments.is_empty() || waits;
        let at = cause.since.filter(|_| is_number || !is_decided).unwrap_or(scan);
        if at != scan {
            decisive = self.decisive(by, call, id, at);
        }
        let mut causes = Vec::new();
        let alone = decisive.arguments.is_empty() && !decisive.power;
        if decisive.power || alone {
            let number = by.call.expect("a call is numbered");
            let was_on = self.scan(at).recording.visit(by.element).power;
            let came = self.why.trace.power_since(number, at);
            let since = if was_on { came.unwrap_or(at) } else { at };
            causes.extend(self.deciders(by, since, depth));
        }
        for argument in decisive.arguments {
            let ArgumentValue::Network(network) = &call.arguments[argument].value else {
                continue;
            };
            let detail = self.scan(at);
            let found = self.decided(&detail).deciders_of(network, true);
            causes.extend(found.into_iter().map(|site| self.decider(site, at, depth)));
        }
        Cause { reason: Reason::Call(self.place(&by), power), causes, ..cause }
    }

    fn power(&mut self, by: Site<'p>, call: &Call, id: VariableId, scan: usize) -> Power {
        let detail = self.scan(scan);
        let visit = detail.recording.visit(by.element);
        let scene = self.scene(&detail);
        let program = self.why.program;
        let instance = &program.instances[call.instance];
        let shown = instance.members.iter().zip(&instance.shape.ports);
        let shown = shown.filter(|(member, port)| port.role.is_member() && **member != id);
        let members = shown
            .map(|(&member, port)| (port.name.to_string(), port.ty, scene.value(member, visit.end)))
            .collect();
        let since = by.call.and_then(|number| self.why.trace.power_since(number, scan));
        Power { is_on: visit.power, since, members }
    }

    /// What would have changed a member in a scan: each thing is tried alone.
    fn decisive(&mut self, by: Site<'p>, call: &Call, id: VariableId, scan: usize) -> Decisive {
        let detail = self.scan(scan);
        let visit = detail.recording.visit(by.element);
        let scene = self.scene(&detail);
        let program = self.why.program;
        let instance = &program.instances[call.instance];
        // The words of a register are among its members and are variables of the program.
        let shown = instance.members.iter().position(|&member| member == id);
        let shown = shown.expect("a call writes members");
        let before: Vec<i64> = instance
            .members
            .iter()
            .zip(&instance.shape.ports)
            .map(|(&member, port)| {
                let until = if port.role.is_parameter() { visit.end } else { visit.start };
                scene.value(member, until)
            })
            .collect();
        let tick = self.why.trace.tick(scan);
        let call_with = |power: bool, tick: bool, mut values: Vec<i64>| {
            let shape = &*call.shape;
            (shape.block.step)(&mut Step { shape, power, tick, values: &mut values });
            values
        };
        let result = |power: bool, values: Vec<i64>| call_with(power, tick, values)[shown];
        let as_it_was = result(visit.power, before.clone());
        let is_decisive = |(_, argument): &(usize, &Argument)| {
            let conducts = before[argument.port] != 0;
            let mut values = before.clone();
            values[argument.port] = 0;
            matches!(argument.value, ArgumentValue::Network(_))
                && conducts
                && result(visit.power, values) != as_it_was
        };
        let arguments =
            call.arguments.iter().enumerate().filter(is_decisive).map(|(index, _)| index);
        Decisive {
            power: result(!visit.power, before.clone()) != as_it_was,
            arguments: arguments.collect(),
            runs: call_with(visit.power, true, before.clone())
                != call_with(visit.power, false, before.clone()),
        }
    }
}
