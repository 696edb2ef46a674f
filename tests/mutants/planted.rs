//! What judges a planted fault first (`tests/mutants/run`): the first check that fails ends it. A check comes
//! twice: with few programs, for most faults show in those, then with more.

#[path = "../common/mod.rs"]
mod common;

use common::checks::{CIRCUIT, Check, GHDL, ICARUS, ORDER, PROCESSOR, SCHEDULES, TREES};
use common::lockstep::difference;
use common::{bulk, scheduled};
use fastrand::Rng;
use hotrail::backend::hdl::Language;

/// A check, and the seeds from where to where.
type Part = (Check, u64, u64);

/// The checks that run what a part of the compiler makes: on few programs, then on more.
fn checks(part: &str) -> [&'static [Part]; 2] {
    match part {
        "circuit" => [
            &[(CIRCUIT, 0, 10), (SCHEDULES, 0, 10), (ORDER, 0, 20)],
            &[(CIRCUIT, 10, 200), (SCHEDULES, 10, 100)],
        ],
        "order" => [&[(ORDER, 0, 20), (SCHEDULES, 0, 20)], &[(ORDER, 20, 250)]],
        "hdl" => [&[(ICARUS, 0, 3), (GHDL, 0, 3)], &[(ICARUS, 3, 28), (GHDL, 3, 28)]],
        "processor" => {
            [&[(PROCESSOR, 0, 20), (TREES, 0, 100)], &[(PROCESSOR, 20, 500), (TREES, 100, 500)]]
        }
        _ => panic!("HOTRAIL_PLANTED is circuit, order, hdl or processor"),
    }
}

fn hold(parts: &[Part]) {
    for (check, first, end) in parts {
        assert!(check.can_run());
        let tally = check.run(*first..*end);
        if let Some(failure) = tally.failures.first() {
            panic!("{}: seed {}, {}", check.shows, failure.seed, failure.text);
        }
    }
}

/// Programs that are kept because chance seldom brings them, and examples.
fn hold_kept(part: &str) {
    match part {
        "hdl" => [Language::Verilog, Language::Vhdl].into_iter().for_each(bulk::hold_kept_programs),
        "circuit" => {
            for (name, program) in common::kept_programs().chain(common::example_programs()) {
                assert_eq!(difference(&program, 200, Rng::with_seed(1)), None, "{name}");
                assert_eq!(scheduled::differences(&program, 100, 1), None, "{name}");
            }
        }
        _ => {}
    }
}

#[test]
fn the_executors_agree() {
    let part = std::env::var("HOTRAIL_PLANTED").expect("HOTRAIL_PLANTED names a part");
    let [few, more] = checks(&part);
    hold(few);
    hold_kept(&part);
    hold(more);
}
