//! Blocks: latches and edges as contacts, timers and counters as functions of the processor.

use super::compile::{Compiler, Done, Power, Reported};
use super::layout::UnitClass;
use super::tree::Tree;
use super::word::{Address, Operation, Prefix, TimerType};
use crate::model::{
    ArgumentValue, Call, Edge, ExprKind, Instance, InstanceId, VariableId,
};
use crate::source::Span;

/// The largest preset of a timer.
const LARGEST_TIME: i64 = 9999;

impl Compiler<'_> {
    fn instance(&self, id: InstanceId) -> &Instance {
        &self.program.instances[id]
    }

    /// The variable of a port.
    fn member(&self, id: InstanceId, port: &str) -> VariableId {
        let instance = self.instance(id);
        instance.members[instance.block.port_named(port).expect("the block has this port")]
    }

    /// Gives the bits of a block their flags, since they may be read above its call.
    pub(super) fn prepare(&mut self, id: InstanceId) -> Done<()> {
        let ports: &[&str] = match self.instance(id).block.name {
            "R_TRIG" | "F_TRIG" => &["Q", "was"],
            "SR" | "RS" | "TON" | "TOF" | "TP" => &["Q"],
            _ => &[],
        };
        let (name, span) = (self.instance(id).name.clone(), self.instance(id).span);
        for port in ports {
            let flags = self.layout.flags(&[(self.member(id, port), format!("{name}.{port}"))], span);
            self.limit(flags)?;
        }
        Ok(())
    }

    /// The flag of an output that was prepared.
    fn output_flag(&mut self, id: InstanceId, port: &str) -> Done<Address> {
        // Where there was no flag left, that has been reported.
        self.address(self.member(id, port)).ok_or(Reported)
    }

    /// Runs a block; its main output goes on.
    pub(super) fn call(&mut self, call: &Call, power: Power) -> Done<Power> {
        let power = self.drawn(power)?;
        let q = match self.instance(call.instance).block.name {
            "R_TRIG" => self.edge_block(call, power, Edge::Rise)?,
            "F_TRIG" => self.edge_block(call, power, Edge::Fall)?,
            "SR" => self.latch(call, power, "R", true)?,
            "RS" => self.latch(call, power, "R1", false)?,
            "TON" => self.iec_timer(call, power, TimerType::OnDelay)?,
            "TOF" => self.iec_timer(call, power, TimerType::OffDelay)?,
            "TP" => self.iec_timer(call, power, TimerType::Interval)?,
            kind => {
                let span = self.instance(call.instance).span;
                let label = format!("of the kind {kind}");
                return Err(self.cannot(span, &format!("the block {kind}"), label));
            }
        };
        Ok(Power::Drawn(Tree::on(q)))
    }

    /// Puts outputs of a block back, where that is a matter of a bit.
    pub(super) fn reset_instance(&mut self, id: InstanceId, power: Power) -> Done<Power> {
        let (kind, span) = (self.instance(id).block.name, self.instance(id).span);
        match kind {
            "R_TRIG" | "F_TRIG" | "SR" | "RS" => {
                let coil = self.output_flag(id, "Q")?;
                self.write(power, Operation::Reset, coil)
            }
            _ => {
                let what = format!("a reset coil on the block {kind}");
                Err(self.cannot(span, &what, "this block is reset by a coil"))
            }
        }
    }

    /// The contacts of a `BOOL` parameter; nothing if the call leaves it out.
    fn circuit_argument(&mut self, call: &Call, port: &str) -> Done<Option<Tree>> {
        let index = self.instance(call.instance).block.port_named(port);
        let given = call.arguments.iter().find(|argument| Some(argument.port) == index);
        match given.map(|argument| &argument.value) {
            None => Ok(None),
            Some(ArgumentValue::Network(network)) => self.argument_network(network).map(Some),
            Some(ArgumentValue::Value(_)) => unreachable!("a BOOL parameter takes a network"),
        }
    }

    /// A network that is fed with power 1; it may act on the power.
    fn argument_network(&mut self, network: &[crate::model::Element]) -> Done<Tree> {
        let power = self.series(network, Power::Drawn(Tree::WIRE), true)?;
        self.drawn(power)
    }

    fn edge_block(&mut self, call: &Call, power: Tree, edge: Edge) -> Done<Address> {
        let coil = self.output_flag(call.instance, "Q")?;
        let mut now = self.single(Power::Drawn(power))?;
        if now.address == coil {
            now = self.into_flag(&Tree::Contact(now))?;
        }
        let memory = self.member(call.instance, "was");
        self.change(now, edge, memory, coil)?;
        Ok(coil)
    }

    /// The power sets, the parameter resets.
    fn latch(&mut self, call: &Call, power: Tree, reset: &str, set_wins: bool) -> Done<Address> {
        let coil = self.output_flag(call.instance, "Q")?;
        let reset = self.circuit_argument(call, reset)?;
        let stays = match reset {
            None => Tree::WIRE,
            Some(tree) => match tree.inverted() {
                Some(inverted) => inverted,
                None => Tree::off(self.into_flag(&tree)?.address),
            },
        };
        let tree = match set_wins {
            true => Tree::parallel([power, Tree::series([Tree::on(coil), stays])]),
            false => Tree::series([Tree::parallel([power, Tree::on(coil)]), stays]),
        };
        self.output(&tree, Operation::Coil, coil)?;
        Ok(coil)
    }

    /// A timer of IEC 61131-3, which counts ticks: the processor has it where a tick is one of its
    /// units.
    fn iec_timer(&mut self, call: &Call, power: Tree, timer: TimerType) -> Done<Address> {
        let span = self.instance(call.instance).span;
        let kind = self.instance(call.instance).block.name;
        let operation = match self.program.tick_ns {
            1_000_000_000 => Operation::TimerSeconds,
            100_000_000 => Operation::TimerTenths,
            _ => {
                let what = format!("the block {kind} at this tick");
                let label = "counts ticks that are neither 100ms nor 1s long";
                return Err(self.cannot(span, &what, label));
            }
        };
        let preset = self.iec_preset(call, span)?;
        if preset == 0 && timer == TimerType::OnDelay {
            let label = "its PT is 0: it passes the power on";
            return Err(self.cannot(span, "the block TON without a delay", label));
        }
        let coil = self.output_flag(call.instance, "Q")?;
        let unit = self.layout.unit(UnitClass::Timer, span);
        let unit = self.limit(unit)?;
        let name = format!("{}.PT", self.instance(call.instance).name);
        let register = self.layout.presets(&[name], span);
        let register = self.limit(register)?;
        if preset != 0 {
            self.rom.registers.insert(register, preset);
        }
        let elapsed = self.member(call.instance, "ET");
        self.count_register(elapsed, unit, call.instance, "ET");
        self.circuit(&power)?;
        if timer == TimerType::OnDelay {
            // It is back at 0 without power, as a timer with an enable circuit is without that.
            self.prefix(Prefix::Enable);
        }
        self.prefix(Prefix::Unit { unit, timer });
        self.prefix(Prefix::Register(register));
        self.word(super::word::Word::Output { operation, coil });
        Ok(coil)
    }

    fn iec_preset(&mut self, call: &Call, span: Span) -> Done<u16> {
        let kind = self.instance(call.instance).block.name;
        let index = self.instance(call.instance).block.port_named("PT");
        let given = call.arguments.iter().find(|argument| Some(argument.port) == index);
        match given.map(|argument| (&argument.value, argument.span)) {
            Some((ArgumentValue::Value(expr), span)) => match expr.kind {
                ExprKind::Constant(preset) if preset <= LARGEST_TIME => Ok(preset as u16),
                ExprKind::Constant(_) => {
                    let label = format!("the processor counts to {LARGEST_TIME}");
                    Err(self.cannot(span, &format!("such a long time of a {kind}"), label))
                }
                _ => Err(self.cannot(span, "a variable time", "changes while the program runs")),
            },
            _ => Err(self.cannot(span, "a variable time", "the call leaves PT out")),
        }
    }

    /// The count of a unit is what this member shows.
    fn count_register(&mut self, member: VariableId, unit: u16, id: InstanceId, port: &str) {
        let register = super::word::FIRST_COUNT + unit;
        let name = format!("{}.{port}", self.instance(id).name);
        self.layout.place(member, register);
        self.layout.register_names.insert(register, name);
    }
}
