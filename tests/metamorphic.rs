//! A change that keeps the meaning of a program keeps everything that it shows.

mod common;

use common::{amount, checks, examples, generate, variants};
use fastrand::Rng;

#[test]
fn random_programs() {
    let programs = amount("HOTRAIL_RANDOM_PROGRAMS", 1000);
    let tally = checks::METAMORPHIC.hold(programs);
    assert!(tally.skipped * 3 < programs, "{} of {programs} not changed", tally.skipped);
}

#[test]
fn every_change_finds_its_place() {
    let mut made = vec![0; variants::CHANGES.len()];
    for seed in 0..300 {
        let (name, text) = (format!("random_{seed}"), generate::program(seed));
        for (change, made) in made.iter_mut().enumerate() {
            let changed = variants::changed(&name, &text, change, &mut Rng::with_seed(seed));
            *made += u32::from(changed.is_some_and(|changed| changed != text));
        }
    }
    for ((what, _), made) in std::iter::zip(variants::CHANGES, made) {
        assert!(made > 30, "{what}: made in {made} of 300 programs only");
    }
}

#[test]
fn examples_too() {
    for example in examples() {
        let text = std::fs::read_to_string(&example.ladder).unwrap();
        for (change, &(what, _)) in variants::CHANGES.iter().enumerate() {
            for seed in 0..5 {
                let checked = variants::check(&example.name(), &text, change, seed);
                assert!(checked.is_ok(), "{}, {what}: {checked:?}", example.name());
            }
        }
    }
}
