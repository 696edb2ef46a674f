//! Fast simulation: a flat circuit made into a straight list of small instructions, for one run
//! or for 64 runs at once.
//!
//! Both keep a condition, a net of one bit, as a slot with all its 64 bits: in one run they are
//! all the same, in 64 runs each bit is a run. So the logic of conditions is one code for both.

mod arithmetic;
mod assembler;
mod code;
mod lanes;
mod single;

pub use lanes::{LANES, LaneSimulator};
pub use single::FastSimulator;
