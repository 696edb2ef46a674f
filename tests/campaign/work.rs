//! Batches of programs, on all cores.

use std::collections::HashSet;
use std::ops::Range;
use std::process::Command;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::thread;
use std::time::Instant;

use anyhow::{Context, ensure};
use indicatif::{ProgressBar, ProgressStyle};

use crate::CheckOptions;
use crate::common::checks::Check;
use crate::log::{self, Failure, Record};

/// Does what the log does not have yet. True if nothing failed, in earlier runs of it either.
pub fn check(options: &CheckOptions) -> anyhow::Result<bool> {
    let revision = revision()?;
    let (mut file, records) = log::open(&options.log, &revision)?;
    let done: HashSet<(&str, u64, u64)> =
        records.iter().map(|record| (&*record.check, record.first, record.end)).collect();
    for check in &options.checks {
        ensure!(check.can_run(), "a tool is missing");
    }
    let mut batches = batches(options);
    batches.retain(|(check, seeds)| !done.contains(&(check.name, seeds.start, seeds.end)));
    let good = records.iter().all(|record| record.failures.is_empty());
    let cores = thread::available_parallelism().map_or(1, usize::from);
    let jobs = options.jobs.unwrap_or(cores).max(1);
    let bar = progress(&batches);
    let (next, all_held) = (AtomicUsize::new(0), AtomicBool::new(good));
    let written = Mutex::new((&mut file, Ok(())));
    thread::scope(|scope| {
        for _ in 0..jobs {
            scope.spawn(|| {
                while let Some((check, seeds)) = batches.get(next.fetch_add(1, Ordering::Relaxed)) {
                    let record = batch(check, seeds.clone(), &revision);
                    bar.inc(seeds.end - seeds.start);
                    for failure in &record.failures {
                        all_held.store(false, Ordering::Relaxed);
                        let (seed, text) = (failure.seed, &failure.text);
                        bar.suspend(|| println!("{}: seed {seed}, {text}", check.shows));
                    }
                    let mut written = written.lock().expect("no thread panics here");
                    if let Err(error) = log::append(written.0, &record) {
                        written.1 = Err(error);
                        return;
                    }
                }
            });
        }
    });
    bar.finish();
    written.into_inner().expect("no thread panics").1?;
    Ok(all_held.into_inner())
}

/// The batches of a shard. Checks take turns, so that a run that is stopped has some of each.
fn batches(options: &CheckOptions) -> Vec<(&'static Check, Range<u64>)> {
    let mut batches = Vec::new();
    for &check in &options.checks {
        let starts = (0..options.programs).step_by(check.batch as usize);
        let own =
            starts.zip(0..).filter(|(_, number)| number % options.shard.of == options.shard.index);
        batches.extend(
            own.map(|(first, _)| (check, first..options.programs.min(first + check.batch))),
        );
    }
    batches.sort_by_key(|(_, seeds)| seeds.start);
    batches
}

fn batch(check: &Check, seeds: Range<u64>, revision: &str) -> Record {
    let start = Instant::now();
    let (first, end) = (seeds.start, seeds.end);
    let tally = check.run(seeds);
    let failures = tally.failures.into_iter();
    Record {
        revision: revision.to_owned(),
        check: check.name.to_owned(),
        first,
        end,
        programs: tally.programs,
        skipped: tally.skipped,
        scans: tally.scans,
        seconds: start.elapsed().as_secs_f64(),
        failures: failures.map(|found| Failure { seed: found.seed, text: found.text }).collect(),
    }
}

/// The bar shows itself on a terminal only.
fn progress(batches: &[(&Check, Range<u64>)]) -> ProgressBar {
    let programs = batches.iter().map(|(_, seeds)| seeds.end - seeds.start).sum();
    let style = "{wide_bar} {human_pos} of {human_len} programs, {per_sec}, {eta} to go";
    ProgressBar::new(programs).with_style(ProgressStyle::with_template(style).expect("it is one"))
}

/// What `git` calls the state of the work tree.
fn revision() -> anyhow::Result<String> {
    let describe = ["describe", "--always", "--dirty", "--abbrev=12", "--exclude=*"];
    let output = Command::new("git").args(describe).output().context("cannot run git")?;
    ensure!(output.status.success(), "a campaign runs in a clone of the repository");
    Ok(String::from_utf8_lossy(&output.stdout).trim().to_owned())
}
