//! Typed ids as indexes of plain vectors that run beside an arena.

use la_arena::Idx;

/// The place of something in its arena.
pub(crate) fn index<T>(id: Idx<T>) -> usize {
    u32::from(id.into_raw()) as usize
}
