//! The ladder processor: a machine that reads a ladder contact by contact from its memory, and the
//! compiler that writes what stands there. `docs/processor.md` describes the machine.

mod call;
mod compile;
mod condition;
mod decode;
mod emulator;
mod encode;
mod files;
mod function;
mod ladder;
mod layout;
mod listing;
mod memory;
mod net;
mod parameters;
mod power;
mod reading;
mod record;
mod register;
mod reset;
mod rom;
mod rung;
mod runner;
mod shortage;
mod sizes;
mod tree;
mod usage;
mod word;

pub use compile::{Image, compile, compile_for, compile_observing};
pub use decode::decode;
pub use emulator::{CLOCKS_AROUND, Machine, PowerCircuit, clocks_of_scan};
pub use encode::{Fitted, encode, fit};
pub use files::Part;
pub use ladder::{NotDrawn, ladder};
pub use layout::Layout;
pub use listing::{Symbols, listing};
pub use memory::{Form, Memory, Unreadable};
pub use parameters::Parameters;
pub use record::{record, record_name, records_of, vouches};
pub use rom::{Fault, FaultKind, Pins, Rom, region};
pub use runner::Runner;
pub use sizes::Sizes;
pub use tree::{Bridge, Contact, Tree};
pub use word::{
    Address, Attribute, FIRST_FLAG, FIRST_OUTPUT, Illegal, ONE, Operation, Prefix, TimerType, Word,
};
