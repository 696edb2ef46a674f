//! The emulator as a machine that a program's tests run on.

use super::compile::Image;
use super::emulator::Machine;
use crate::eval;
use crate::model::{Program, Role, VariableId};
use crate::types::Type;

/// A program on the processor, driven by the names of its variables.
pub struct Runner<'a> {
    program: &'a Program,
    image: &'a Image,
    machine: Machine<'a>,
}

impl<'a> Runner<'a> {
    /// The program at reset, inputs 0.
    pub fn new(program: &'a Program, image: &'a Image) -> Self {
        let machine = Machine::new(&image.rom).expect("the compiler writes what can be run");
        Runner { program, image, machine }
    }

    /// Clocks of all scans so far.
    pub fn clocks(&self) -> u64 {
        self.machine.clocks()
    }
}

impl eval::Machine for Runner<'_> {
    fn reset(&mut self) {
        self.machine.reset();
    }

    fn drive(&mut self, input: VariableId, value: i64) {
        if let Some(address) = self.image.layout.bit(input) {
            self.machine.drive(address, value != 0);
        } else if let Some(register) = self.image.layout.register(input) {
            let bits = self.program.variables[input].ty.bits(value);
            self.machine.write_register(register, bits as u16);
        }
    }

    fn scan(&mut self, tick: bool) {
        self.machine.scan(tick);
    }

    fn value(&self, variable: VariableId) -> i64 {
        let Type::Bool = self.program.variables[variable].ty else {
            let register = self.image.layout.register(variable);
            let ty = self.program.variables[variable].ty;
            // A number without a register is one that no rung uses.
            let otherwise = self.program.variables[variable].initial;
            return register
                .map_or(otherwise, |register| ty.wrap(self.machine.register(register).into()));
        };
        let Some(address) = self.image.layout.bit(variable) else {
            return self.program.variables[variable].initial;
        };
        match self.program.variables[variable].role {
            Role::Input => self.machine.driven(address).into(),
            _ => self.machine.bit(address).into(),
        }
    }
}
