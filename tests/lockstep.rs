//! The reference evaluator and the simulated circuit agree, scan by scan, on random programs.

mod common;

use common::lockstep::difference;
use common::{amount, checks};
use fastrand::Rng;

#[test]
fn random_programs() {
    checks::CIRCUIT.hold(amount("HOTRAIL_RANDOM_PROGRAMS", 1000));
}

#[test]
fn kept_programs() {
    for (name, program) in common::kept_programs() {
        for seed in 0..20 {
            let wrong = difference(&program, 200, Rng::with_seed(seed));
            assert_eq!(wrong, None, "{name}, inputs {seed}");
        }
    }
}

#[test]
fn examples() {
    for (name, program) in common::example_programs() {
        for seed in 0..20 {
            let wrong = difference(&program, 2000, Rng::with_seed(seed));
            assert_eq!(wrong, None, "{name}, inputs {seed}");
        }
    }
}
