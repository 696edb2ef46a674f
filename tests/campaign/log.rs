//! What came of the batches, as JSON lines.

use std::fs::{File, OpenOptions};
use std::io::{Read, Seek, SeekFrom, Write};
use std::path::Path;

use anyhow::{Context, bail};
use serde::{Deserialize, Serialize};

/// What came of a batch.
#[derive(Serialize, Deserialize)]
pub struct Record {
    /// The state of the repository, which says what a seed means.
    pub revision: String,
    pub check: String,
    /// The seeds, from the first to before the last.
    pub first: u64,
    pub end: u64,
    pub programs: u64,
    pub skipped: u64,
    pub scans: u64,
    /// Seconds on one core.
    pub seconds: f64,
    pub failures: Vec<Failure>,
}

#[derive(Serialize, Deserialize)]
pub struct Failure {
    pub seed: u64,
    pub text: String,
}

/// All records of a log. A last line without an end is what a stopped run left; it counts for
/// nothing.
pub fn read(text: &str, name: &Path) -> anyhow::Result<Vec<Record>> {
    let whole = text.rfind('\n').map_or("", |end| &text[..end]);
    let parse = |(number, line): (usize, &str)| {
        let wrong = || format!("{}:{}: no record of a campaign", name.display(), number + 1);
        serde_json::from_str(line).with_context(wrong)
    };
    whole.lines().enumerate().map(parse).collect()
}

/// Opens a log to go on with, and what stands in it.
pub fn open(path: &Path, revision: &str) -> anyhow::Result<(File, Vec<Record>)> {
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder).with_context(|| format!("{}", folder.display()))?;
    }
    let mut options = OpenOptions::new();
    let file = options.read(true).write(true).create(true).truncate(false).open(path);
    let mut file = file.with_context(|| format!("{}", path.display()))?;
    let mut text = String::new();
    file.read_to_string(&mut text)?;
    let records = read(&text, path)?;
    if let Some(other) = records.iter().find(|record| record.revision != revision) {
        bail!(
            "{} is of {}, this is {revision}: a seed may mean another program now; take a new log",
            path.display(),
            other.revision
        );
    }
    let whole = text.rfind('\n').map_or(0, |end| end + 1);
    file.set_len(whole as u64)?;
    file.seek(SeekFrom::End(0))?;
    Ok((file, records))
}

/// Adds a record, in one piece.
pub fn append(file: &mut File, record: &Record) -> anyhow::Result<()> {
    let line = serde_json::to_string(record)? + "\n";
    Ok(file.write_all(line.as_bytes())?)
}
