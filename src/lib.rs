//! The compiler that turns ladder logic into hardware.

pub mod diagnostic;
pub mod quantity;
pub mod source;
pub mod syntax;
pub mod types;
