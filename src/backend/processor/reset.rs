//! `(R name)`: what a block keeps in bits of the image, and its count, bit by bit.

use super::compile::{Compiler, Done, Reported};
use super::power::Power;
use super::word::{Operation, Prefix};
use crate::model::InstanceId;
use crate::types::Type;

/// Bits of the largest count, 9999.
const BITS_OF_COUNT: u16 = 14;

impl Compiler<'_> {
    /// Puts a block back to its start when powered, and passes the power on.
    pub(super) fn reset_instance(&mut self, id: InstanceId, power: Power) -> Done<Power> {
        let program = self.program;
        let instance = &program.instances[id];
        let kind = instance.shape.block.name;
        let delays = match kind {
            "TOF" | "TP" => true,
            "TS" | "TT" => instance.shape.word("MODE") != "ON",
            _ => false,
        };
        if delays {
            let what = format!("a reset coil on a running {kind}");
            let label = "no word reaches whether its delay or pulse runs";
            return Err(self.cannot(instance.span, &what, label));
        }
        let mut power = power;
        for (port, member, value) in instance.cleared(program) {
            if port.ty == Type::Bool {
                // A flag that nothing reads is none; one that is missing for good was reported.
                let Some(coil) = self.address(member) else { continue };
                let operation = if value == 1 { Operation::Set } else { Operation::Reset };
                power = self.write(power, operation, coil)?;
            } else {
                let register = self.layout.register(member).ok_or(Reported)?;
                power = self.load(register, value as u16, power)?;
            }
        }
        Ok(power)
    }

    /// Gives a count this value when powered.
    fn load(&mut self, register: u16, value: u16, power: Power) -> Done<Power> {
        let spare = self.flag()?;
        let power = self.in_hand(power)?;
        for bit in 0..BITS_OF_COUNT {
            let set = value >> bit & 1 == 1;
            self.prefix(Prefix::Register(register));
            self.prefix(Prefix::Number(bit));
            self.operation(if set { Operation::BitSet } else { Operation::BitClear }, spare);
        }
        Ok(power)
    }
}
