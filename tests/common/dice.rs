//! How random programs, and what drives them, are chosen.

use fastrand::Rng;
use hotrail::types::Type;

/// Choices.
pub trait Dice {
    /// True once in so many times.
    fn chance(&mut self, one_in: u32) -> bool;

    /// One of some things, each as likely as the others.
    fn pick<T: Clone>(&mut self, list: &[T]) -> T;

    /// A value of a type: as often a small one as any.
    fn value(&mut self, ty: Type) -> i64;
}

impl Dice for Rng {
    fn chance(&mut self, one_in: u32) -> bool {
        self.u32(..one_in) == 0
    }

    fn pick<T: Clone>(&mut self, list: &[T]) -> T {
        list[self.usize(..list.len())].clone()
    }

    fn value(&mut self, ty: Type) -> i64 {
        ty.wrap(if self.bool() { self.i64(-3..4) } else { self.i64(..) })
    }
}
