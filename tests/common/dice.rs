//! How random programs choose.

use fastrand::Rng;

/// Choices of a generator.
pub trait Dice {
    /// True once in so many times.
    fn chance(&mut self, one_in: u32) -> bool;

    /// One of some things, each as likely as the others.
    fn pick<T: Clone>(&mut self, list: &[T]) -> T;
}

impl Dice for Rng {
    fn chance(&mut self, one_in: u32) -> bool {
        self.u32(..one_in) == 0
    }

    fn pick<T: Clone>(&mut self, list: &[T]) -> T {
        list[self.usize(..list.len())].clone()
    }
}
