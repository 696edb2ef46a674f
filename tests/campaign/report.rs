//! What logs add up to.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;

use anyhow::{Context, bail};

use crate::common::checks::Check;
use crate::log::{self, Record};

/// Prints a table, what is missing and what failed. True if everything held and nothing is missing.
pub fn print(logs: &[PathBuf]) -> anyhow::Result<bool> {
    let mut records = Vec::new();
    for path in logs {
        let text = fs::read_to_string(path).with_context(|| format!("{}", path.display()))?;
        records.extend(log::read(&text, path)?);
    }
    let Some(first) = records.first() else { bail!("the logs are empty") };
    let revision = first.revision.clone();
    if let Some(other) = records.iter().find(|record| record.revision != revision) {
        bail!("some are of {revision}, others of {}: seeds may not be the same", other.revision);
    }
    let mut by_check: BTreeMap<String, Vec<Record>> = BTreeMap::new();
    for record in records {
        by_check.entry(record.check.clone()).or_default().push(record);
    }
    println!("| what holds | programs | scans | failed | minutes on a core |");
    println!("|---|---|---|---|---|");
    let mut below = Vec::new();
    for (name, mut records) in by_check {
        let shows = Check::named(&name).map_or(&*name, |check| check.shows);
        records.sort_by_key(|record| record.first);
        // Two machines may have done the same.
        records.dedup_by_key(|record| (record.first, record.end));
        let sum = |count: fn(&Record) -> u64| records.iter().map(count).sum::<u64>();
        let (programs, scans) = (sum(|record| record.programs), sum(|record| record.scans));
        let failed = sum(|record| record.failures.len() as u64);
        let minutes = records.iter().map(|record| record.seconds).sum::<f64>() / 60.0;
        println!("| {shows} | {programs} | {scans} | {failed} | {minutes:.1} |");
        let mut next = 0;
        for record in &records {
            if record.first > next {
                below.push(format!("{name}: seeds {next} to {} are missing", record.first - 1));
            }
            next = next.max(record.end);
            let failures = record.failures.iter();
            below.extend(
                failures.map(|found| format!("{name}: seed {}, {}", found.seed, found.text)),
            );
        }
    }
    println!("\nrevision {revision}");
    below.iter().for_each(|line| println!("{line}"));
    Ok(below.is_empty())
}
