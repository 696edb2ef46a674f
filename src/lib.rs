//! The compiler that turns ladder logic into hardware.

pub mod blocks;
pub mod check;
pub mod circuit;
pub mod diagnostic;
pub mod equations;
pub mod eval;
pub mod expand;
mod index;
pub mod lint;
pub mod model;
pub mod quantity;
pub mod source;
pub mod syntax;
pub mod types;
