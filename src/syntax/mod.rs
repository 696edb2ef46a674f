//! From text to the tree of what was written, and back to text.

mod arrays;
pub mod ast;
mod fault;
mod parse;
mod print;
mod split;

pub use fault::written_name;
pub use parse::parse;
pub use print::format;

/// How deep brackets and comments may nest, and how many operators of an expression may stand
/// inside each other. It bounds every recursive walk over a program.
pub const MAX_NESTING: usize = 256;
