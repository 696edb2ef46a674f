//! The reference evaluator and the simulated circuit agree, scan by scan, on random programs.

mod common;

use std::path::Path;

use common::lockstep::difference;
use common::{amount, analyze, checks};
use fastrand::Rng;

#[test]
fn random_programs() {
    checks::CIRCUIT.hold(amount("HOTRAIL_RANDOM_PROGRAMS", 1000));
}

/// Programs that once showed a mistake. They are kept as texts, because a change to the generator
/// changes what a seed means.
#[test]
fn kept_programs() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/lockstep");
    let mut programs = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.display().to_string();
        let text = std::fs::read_to_string(&path).unwrap();
        let program = analyze(&name, &text).unwrap_or_else(|findings| panic!("{findings}"));
        for seed in 0..20 {
            let wrong = difference(&program, 200, Rng::with_seed(seed));
            assert_eq!(wrong, None, "{name}, inputs {seed}");
        }
        programs += 1;
    }
    assert!(programs > 0);
}

#[test]
fn examples() {
    for example in common::examples() {
        let name = example.ladder.display().to_string();
        let text = std::fs::read_to_string(&example.ladder).unwrap();
        let program = analyze(&name, &text).unwrap_or_else(|findings| panic!("{findings}"));
        for seed in 0..20 {
            let wrong = difference(&program, 2000, Rng::with_seed(seed));
            assert_eq!(wrong, None, "{name}, inputs {seed}");
        }
    }
}
