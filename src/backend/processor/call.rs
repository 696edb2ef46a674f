//! Blocks: latches and edges as contacts, timers, counters and drums as functions of the processor.

use super::compile::{Compiler, Done, Reported};
use super::layout::UnitClass;
use super::power::Power;
use super::tree::Tree;
use super::word::{Address, FIRST_COUNT, FIRST_DRUM, Operation, Prefix, TimerType};
use crate::model::{
    ArgumentValue, Call, Edge, Element, ExprKind, Instance, InstanceId, VariableId,
};
use crate::types::Type;

/// The largest preset of a timer of IEC 61131-3 that fits a unit.
const LARGEST_TIME: i64 = 9999;

/// A function with its operands, once they have registers.
pub(super) struct Function {
    pub operation: Operation,
    pub unit: u16,
    pub timer: TimerType,
    /// That of the preset, or the first of those that are shifted.
    pub register: u16,
    /// Of the taps of a drum, or of the registers that are shifted.
    pub number: Option<u16>,
    pub coil: Address,
}

impl Compiler<'_> {
    pub(super) fn instance(&self, id: InstanceId) -> &Instance {
        &self.program.instances[id]
    }

    /// The variable of a port, if the block has it.
    pub(super) fn port(&self, id: InstanceId, port: &str) -> Option<VariableId> {
        let instance = self.instance(id);
        instance.shape.port_named(port).map(|port| instance.members[port])
    }

    /// The variable of a port that the block has.
    pub(super) fn member(&self, id: InstanceId, port: &str) -> VariableId {
        self.port(id, port).expect("the block has this port")
    }

    /// Gives the bits of a block their flags, and its count a unit, since they may be read above
    /// the call.
    pub(super) fn prepare(&mut self, id: InstanceId) -> Done<()> {
        let (kind, span) = (self.instance(id).shape.block.name, self.instance(id).span);
        let own: &[&str] = match kind {
            "R_TRIG" | "F_TRIG" => &["Q", "was"],
            "SR" | "RS" | "TON" | "TOF" | "TP" | "TS" | "TT" | "T1_0" | "T0_1" | "UC" | "DC"
            | "DRUM" | "SHL" | "SHR" => &["Q"],
            // Here and not at the call: a rung that reads the block is given up before it calls it.
            _ => return Err(self.cannot_call(id, kind)),
        };
        let (class, count, first) = match kind {
            "DRUM" => (Some(UnitClass::Drum), "ACC", FIRST_DRUM),
            "TON" | "TOF" | "TP" => (Some(UnitClass::Timer), "ET", FIRST_COUNT),
            "R_TRIG" | "F_TRIG" | "SR" | "RS" | "SHL" | "SHR" => (None, "", 0),
            _ => (Some(UnitClass::Timer), "ACC", FIRST_COUNT),
        };
        let name = self.instance(id).name.clone();
        let named = |port: &str| format!("{name}.{port}");
        // The coils of the taps follow that of the drum.
        let taps = (0..16).map(|tap| format!("TAP{tap}"));
        let mut flags: Vec<(VariableId, String)> = own
            .iter()
            .map(|port| (*port).to_owned())
            .chain(taps)
            .filter_map(|port| self.port(id, &port).map(|member| (member, named(&port))))
            .collect();
        for port in ["QN", "EN", "R", "R1", "DATA"] {
            let member = self.port(id, port).filter(|member| self.named.contains(member));
            flags.extend(member.map(|member| (member, named(port))));
        }
        let flags = self.layout.flags(&flags, span);
        self.limit(flags)?;
        let Some(class) = class else { return Ok(()) };
        let unit = self.layout.unit(class, span);
        let unit = self.limit(unit)?;
        let count_member = self.member(id, count);
        self.layout.place(count_member, first + unit);
        self.layout.register_names.insert(first + unit, named(count));
        let start = self.program.variables[count_member].initial;
        if start != 0 {
            self.rom.registers.insert(first + unit, Type::Int.bits(start) as u16);
        }
        Ok(())
    }

    /// The flag of an output that was prepared.
    pub(super) fn output_flag(&self, id: InstanceId, port: &str) -> Done<Address> {
        // Where there was no flag left, that has been reported.
        self.address(self.member(id, port)).ok_or(Reported)
    }

    /// Runs a block; its main output goes on.
    pub(super) fn call(&mut self, call: &Call, power: Power) -> Done<Power> {
        let power = self.drawn(power)?;
        let q = match call.shape.block.name {
            "R_TRIG" => self.edge_block(call, power, Edge::Rise)?,
            "F_TRIG" => self.edge_block(call, power, Edge::Fall)?,
            "SR" => self.latch(call, power, "R", true)?,
            "RS" => self.latch(call, power, "R1", false)?,
            "TON" => self.iec_timer(call, power, TimerType::OnDelay)?,
            "TOF" => self.iec_timer(call, power, TimerType::OffDelay)?,
            "TP" => self.iec_timer(call, power, TimerType::Interval)?,
            "TS" | "T1_0" => self.function(call, power, Operation::TimerSeconds)?,
            "TT" | "T0_1" => self.function(call, power, Operation::TimerTenths)?,
            "UC" => self.function(call, power, Operation::CountUp)?,
            "DC" => self.function(call, power, Operation::CountDown)?,
            "DRUM" => self.function(call, power, Operation::Drum)?,
            "SHL" => self.shift(call, power, Operation::ShiftLeft)?,
            "SHR" => self.shift(call, power, Operation::ShiftRight)?,
            kind if kind == self.instance(call.instance).shape.block.name => return Err(Reported),
            second => return Err(self.cannot_call(call.instance, second)),
        };
        Ok(Power::Drawn(Tree::on(q)))
    }

    fn cannot_call(&mut self, id: InstanceId, kind: &str) -> Reported {
        let span = self.instance(id).span;
        self.cannot(span, &format!("the block {kind}"), format!("of the kind {kind}"))
    }

    /// The contacts of a `BOOL` parameter: those of the call, or the member that the program
    /// writes. Nothing if it keeps its start.
    pub(super) fn circuit_argument(&mut self, call: &Call, port: &str) -> Done<Option<Tree>> {
        let index = call.shape.port_named(port);
        let given = call.arguments.iter().find(|argument| Some(argument.port) == index);
        match given.map(|argument| &argument.value) {
            Some(ArgumentValue::Network(network)) => self.argument_network(network).map(Some),
            Some(ArgumentValue::Value(_)) => unreachable!("a BOOL parameter takes a network"),
            None => Ok(self.address(self.member(call.instance, port)).map(Tree::on)),
        }
    }

    /// A network that is fed with power 1; it may act on the power.
    fn argument_network(&mut self, network: &[Element]) -> Done<Tree> {
        let power = self.series(network, Power::Drawn(Tree::WIRE), true)?;
        self.drawn(power)
    }

    fn edge_block(&mut self, call: &Call, power: Tree, edge: Edge) -> Done<Address> {
        let coil = self.output_flag(call.instance, "Q")?;
        let mut now = self.single(Power::Drawn(power))?;
        if now.address == coil {
            now = self.flagged(&Tree::Contact(now))?;
        }
        let memory = self.member(call.instance, "was");
        self.change(now, edge, memory, coil)?;
        Ok(coil)
    }

    /// The power sets, the parameter resets.
    fn latch(&mut self, call: &Call, power: Tree, reset: &str, set_wins: bool) -> Done<Address> {
        let coil = self.output_flag(call.instance, "Q")?;
        let stays = match self.circuit_argument(call, reset)? {
            None => Tree::WIRE,
            Some(tree) => self.inverted(&tree)?,
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
        let kind = call.shape.block.name;
        let operation = match self.program.tick_ns {
            1_000_000_000 => Operation::TimerSeconds,
            100_000_000 => Operation::TimerTenths,
            _ => {
                let what = format!("the block {kind} at this tick");
                let label = "counts ticks that are neither 100ms nor 1s long";
                return Err(self.cannot(span, &what, label));
            }
        };
        let preset = self.iec_preset(call)?;
        if preset == 0 && timer == TimerType::OnDelay {
            // It passes the power on.
            let coil = self.output_flag(call.instance, "Q")?;
            self.output(&power, Operation::Coil, coil)?;
            return Ok(coil);
        }
        let preset = self.constant_register(call.instance, "PT", preset)?;
        let function = self.operands(call, operation, timer, preset, None)?;
        self.circuit(&power)?;
        if timer == TimerType::OnDelay {
            // It is back at 0 without power, as a timer with an enable circuit is without that.
            self.prefix(Prefix::Enable);
        }
        self.run(&function);
        Ok(function.coil)
    }

    fn iec_preset(&mut self, call: &Call) -> Done<u16> {
        let span = self.instance(call.instance).span;
        let index = call.shape.port_named("PT");
        let given = call.arguments.iter().find(|argument| Some(argument.port) == index);
        match given.map(|argument| (&argument.value, argument.span)) {
            Some((ArgumentValue::Value(expr), span)) => match expr.kind {
                ExprKind::Constant(preset) if preset <= LARGEST_TIME => Ok(preset as u16),
                ExprKind::Constant(_) => {
                    let what = format!("such a long time of the block {}", call.shape.block.name);
                    Err(self.cannot(span, &what, format!("the processor counts to {LARGEST_TIME}")))
                }
                _ => Err(self.cannot(span, "a variable time", "changes while the program runs")),
            },
            _ => Err(self.cannot(span, "a variable time", "the call leaves PT out")),
        }
    }

    /// A function with an enable circuit.
    fn function(&mut self, call: &Call, power: Tree, operation: Operation) -> Done<Address> {
        let id = call.instance;
        let timer = match call.shape.block.name {
            "TS" | "TT" => match call.shape.word("MODE") {
                "ON" => TimerType::OnDelay,
                "OFF" => TimerType::OffDelay,
                _ => TimerType::Interval,
            },
            "T1_0" | "T0_1" => TimerType::OnDelay,
            _ => TimerType::OffDelay,
        };
        let preset = self.preset(call)?;
        let taps = (operation == Operation::Drum).then(|| call.shape.list("TAPS").len() as u16);
        let function = self.operands(call, operation, timer, preset, taps)?;
        if let Some(enable) = self.circuit_argument(call, "EN")? {
            self.circuit(&enable)?;
            self.prefix(Prefix::Enable);
        }
        self.circuit(&power)?;
        self.run(&function);
        if let Some(opposite) = self.port(id, "QN").and_then(|member| self.address(member)) {
            self.output(&Tree::off(function.coil), Operation::Coil, opposite)?;
        }
        Ok(function.coil)
    }

    fn operands(
        &self,
        call: &Call,
        operation: Operation,
        timer: TimerType,
        register: u16,
        number: Option<u16>,
    ) -> Done<Function> {
        let (count, first) = match operation {
            Operation::Drum => ("ACC", FIRST_DRUM),
            _ if call.shape.port_named("ET").is_some() => ("ET", FIRST_COUNT),
            _ => ("ACC", FIRST_COUNT),
        };
        let count = self.layout.register(self.member(call.instance, count)).ok_or(Reported)?;
        let coil = self.output_flag(call.instance, "Q")?;
        Ok(Function { operation, unit: count - first, timer, register, number, coil })
    }

    /// The register of the preset; that of a drum is followed by those of its taps.
    fn preset(&mut self, call: &Call) -> Done<u16> {
        let index = call.shape.port_named("PV");
        let given = call.arguments.iter().find(|argument| Some(argument.port) == index);
        let value = match given.map(|argument| (&argument.value, argument.span)) {
            None => self.program.variables[self.member(call.instance, "PV")].initial,
            Some((ArgumentValue::Value(expr), span)) => match expr.kind {
                ExprKind::Constant(value) => value,
                ExprKind::Read(ref place) if call.shape.block.name != "DRUM" => {
                    let variable = self.whole(place, span)?;
                    return self.number(variable, span);
                }
                ExprKind::Read(_) => {
                    let label = "the registers of the taps follow that of the preset";
                    return Err(self.cannot(span, "a variable preset of a drum", label));
                }
                _ => {
                    let label = "is computed while the program runs";
                    return Err(self.cannot(span, "such a preset", label));
                }
            },
            Some((ArgumentValue::Network(_), _)) => unreachable!("PV takes a number"),
        };
        let preset = Type::Int.bits(value) as u16;
        if call.shape.block.name != "DRUM" {
            return self.constant_register(call.instance, "PV", preset);
        }
        let taps = call.shape.list("TAPS");
        let name = &self.instance(call.instance).name;
        let mut names = vec![format!("{name}.PV")];
        names.extend((0..taps.len()).map(|tap| format!("{name}, tap {tap}")));
        let first = self.layout.presets(&names, self.instance(call.instance).span);
        let first = self.limit(first)?;
        for (register, value) in
            (first..).zip([preset].into_iter().chain(taps.iter().map(|&tap| tap as u16)))
        {
            if value != 0 {
                self.rom.registers.insert(register, value);
            }
        }
        Ok(first)
    }

    /// A register with a number that does not change.
    fn constant_register(&mut self, id: InstanceId, port: &str, value: u16) -> Done<u16> {
        let name = format!("{}.{port}", self.instance(id).name);
        let register = self.layout.presets(&[name], self.instance(id).span);
        let register = self.limit(register)?;
        if value != 0 {
            self.rom.registers.insert(register, value);
        }
        Ok(register)
    }

    /// Latched circuits, then the prefixes and the operation.
    pub(super) fn run(&mut self, function: &Function) {
        let Function { operation, unit, timer, register, number, coil } = *function;
        self.prefix(Prefix::Unit { unit, timer });
        self.prefix(Prefix::Register(register));
        if let Some(number) = number {
            self.prefix(Prefix::Number(number));
        }
        self.operation(operation, coil);
    }
}
