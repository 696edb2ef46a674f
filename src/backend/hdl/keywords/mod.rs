//! Words that a printed name must not be. All tables are sorted and in lower case.

mod cpp;
mod relied_on;
mod verilog;
mod vhdl;

pub use cpp::CPP;
pub use relied_on::RELIED_ON;
pub use verilog::VERILOG;
pub use vhdl::VHDL;
