//! A change that keeps the meaning of a program keeps everything that it shows.

mod common;

use common::shrink::shrink;
use common::{amount, analyze, examples, generate, variants};
use fastrand::Rng;

/// What differs between a program and itself after a change; nothing if it has no place for one.
/// True if there was one.
fn check(name: &str, text: &str, change: usize, seed: u64) -> Result<bool, String> {
    let mut random = Rng::with_seed(seed);
    let Some(changed) = variants::changed(name, text, change, &mut random) else {
        return Ok(false);
    };
    let program = analyze(name, text)?;
    let other = analyze(name, &changed).unwrap_or_else(|findings| panic!("{changed}{findings}"));
    match variants::difference(&program, &other, 100, random) {
        None => Ok(true),
        Some(wrong) => Err(format!("{wrong}\n{changed}")),
    }
}

#[test]
fn random_programs() {
    let mut made = vec![0; variants::CHANGES.len()];
    let programs = amount("HOTRAIL_RANDOM_PROGRAMS", 1000);
    for seed in 0..programs {
        let (name, text) = (format!("random_{seed}"), generate::program(seed));
        for (change, &(what, _)) in variants::CHANGES.iter().enumerate() {
            match check(&name, &text, change, seed) {
                Ok(was_made) => made[change] += u64::from(was_made),
                Err(wrong) => {
                    let fails = |text: &str| check(&name, text, change, seed).is_err();
                    panic!("seed {seed}, {what}: {wrong}\nfrom\n{}", shrink(&text, fails));
                }
            }
        }
    }
    for ((what, _), made) in std::iter::zip(variants::CHANGES, made) {
        assert!(made * 20 > programs, "{what}: made in {made} of {programs} programs only");
    }
}

#[test]
fn examples_too() {
    for example in examples() {
        let text = std::fs::read_to_string(&example.ladder).unwrap();
        for (change, &(what, _)) in variants::CHANGES.iter().enumerate() {
            for seed in 0..5 {
                let checked = check(&example.name(), &text, change, seed);
                assert!(checked.is_ok(), "{}, {what}: {checked:?}", example.name());
            }
        }
    }
}
