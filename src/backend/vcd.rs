//! A run of a program as a value change dump, for GTKWave, Surfer and their kin.

use std::collections::HashSet;

use vcd::{IdCode, TimescaleUnit, Value, VarType, Writer};

use super::hdl::names::Namer;
use crate::index::index;
use crate::model::{Program, Role, Variable, VariableId};
use crate::types::Type;

/// What cannot happen.
const IN_MEMORY: &str = "a dump is made in memory";

/// A dump under construction. One scan takes one tick on its time axis, whether it has the tick or
/// not, so the time of a change is the number of its scan.
pub struct Vcd {
    writer: Writer<Vec<u8>>,
    /// Units of the time scale in a tick.
    step: u64,
    scans: u64,
    tick: Signal,
    signals: Vec<(VariableId, Signal)>,
}

/// Something shown.
struct Signal {
    id: IdCode,
    width: u32,
    /// Its bits as shown last.
    shown: Option<u64>,
}

impl Vcd {
    /// The dump of these variables; members stand in a scope of their block instance.
    pub fn new(program: &Program, variables: &[VariableId]) -> Vcd {
        let (step, timescale, unit) = time_scale(program.tick_ns);
        let mut writer = Writer::new(Vec::new());
        writer.version(concat!("hotrail ", env!("CARGO_PKG_VERSION"))).expect(IN_MEMORY);
        writer.timescale(timescale, unit).expect(IN_MEMORY);
        writer.add_module(&program.name).expect(IN_MEMORY);
        let tick = Signal::new(&mut writer, Type::Bool, "tick");
        let mut dump = Vcd { writer, step, scans: 0, tick, signals: Vec::new() };
        dump.declare(program, variables);
        dump.writer.upscope().expect(IN_MEMORY);
        dump.writer.enddefinitions().expect(IN_MEMORY);
        dump
    }

    /// Shows the values after one more scan.
    pub fn scan(&mut self, tick: bool, value: impl Fn(VariableId) -> i64) {
        self.writer.timestamp(self.scans * self.step).expect(IN_MEMORY);
        self.scans += 1;
        self.tick.show(&mut self.writer, tick.into());
        for (variable, signal) in &mut self.signals {
            signal.show(&mut self.writer, value(*variable) as u64);
        }
    }

    /// Takes what has been made since it was taken last.
    pub fn take(&mut self) -> Vec<u8> {
        std::mem::take(self.writer.writer())
    }

    /// Ends the dump: the last scan lasts as long as any other.
    pub fn finish(mut self) -> Vec<u8> {
        self.writer.timestamp(self.scans * self.step).expect(IN_MEMORY);
        self.take()
    }

    /// Declares what is shown: variables first, then a scope for each instance.
    fn declare(&mut self, program: &Program, variables: &[VariableId]) {
        let outer = HashSet::new();
        let mut top = Namer::new(&outer);
        let mut plain = Vec::new();
        let mut members: Vec<Vec<(VariableId, &str)>> = vec![Vec::new(); program.instances.len()];
        for &variable in variables {
            let Variable { name, role, .. } = &program.variables[variable];
            match *role {
                Role::Member(instance, port) => {
                    let port = &program.instances[instance].shape.ports[port];
                    members[index(instance)].push((variable, port.name));
                }
                _ => plain.push((variable, top.take(name, ""))),
            }
        }
        let shown = program.instances.values().zip(members).filter(|(_, shown)| !shown.is_empty());
        let scopes: Vec<_> =
            shown.map(|(instance, shown)| (top.take(&instance.name, ""), shown)).collect();
        let names = top.finish();
        for (variable, name) in plain {
            self.signal(program, variable, names.get(name));
        }
        for (scope, members) in scopes {
            self.writer.add_module(names.get(scope)).expect(IN_MEMORY);
            for (variable, port) in members {
                self.signal(program, variable, port);
            }
            self.writer.upscope().expect(IN_MEMORY);
        }
    }

    fn signal(&mut self, program: &Program, variable: VariableId, name: &str) {
        let signal = Signal::new(&mut self.writer, program.variables[variable].ty, name);
        self.signals.push((variable, signal));
    }
}

impl Signal {
    /// Viewers show an `integer` as a decimal number with a sign, a `reg` in hexadecimal.
    fn new(writer: &mut Writer<Vec<u8>>, ty: Type, name: &str) -> Signal {
        let kind = match ty {
            Type::Bool => VarType::Wire,
            Type::Int | Type::Dint | Type::Time => VarType::Integer,
            Type::Uint | Type::Udint | Type::Word | Type::Dword => VarType::Reg,
        };
        let id = writer.add_var(kind, ty.width(), name, None).expect(IN_MEMORY);
        Signal { id, width: ty.width(), shown: None }
    }

    fn show(&mut self, writer: &mut Writer<Vec<u8>>, bits: u64) {
        if self.shown.replace(bits) == Some(bits) {
            return;
        }
        let bits = bits & (u64::MAX >> (64 - self.width));
        let written = match self.width {
            1 => writer.change_scalar(self.id, bits == 1),
            _ => {
                // Leading zeros are left out, as the format allows.
                let digits = (64 - bits.leading_zeros()).max(1);
                let value = (0..digits).rev().map(|bit| Value::from(bits >> bit & 1 == 1));
                writer.change_vector(self.id, value)
            }
        };
        written.expect(IN_MEMORY);
    }
}

/// How many units a tick has, and the unit: 1, 10 or 100 of a power of a thousandth.
fn time_scale(tick_ns: u64) -> (u64, u32, TimescaleUnit) {
    let units = [
        (1_000_000_000, TimescaleUnit::S),
        (1_000_000, TimescaleUnit::MS),
        (1_000, TimescaleUnit::US),
        (1, TimescaleUnit::NS),
    ];
    let scales = units.iter().flat_map(|unit| [100, 10, 1].map(|count| (count, unit)));
    for (count, &(length, unit)) in scales {
        let scale = u64::from(count) * length;
        if tick_ns.is_multiple_of(scale) {
            return (tick_ns / scale, count, unit);
        }
    }
    unreachable!("a tick is a whole number of nanoseconds")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_time_scale_is_the_largest_in_which_a_tick_is_whole() {
        assert_eq!(time_scale(1_000_000), (1, 1, TimescaleUnit::MS));
        assert_eq!(time_scale(5_000_000), (5, 1, TimescaleUnit::MS));
        assert_eq!(time_scale(250_000), (25, 10, TimescaleUnit::US));
        assert_eq!(time_scale(60_000_000_000), (6, 10, TimescaleUnit::S));
        assert_eq!(time_scale(7), (7, 1, TimescaleUnit::NS));
    }
}
