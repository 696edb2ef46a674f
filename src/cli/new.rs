//! `hotrail new`

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, bail};

use hotrail::check;

use super::Verdict;
use super::report::out;

/// Start a small project that works: a ladder with tests, a README, a CI recipe
#[derive(clap::Args)]
#[command(
    after_help = "Example:\n  hotrail new conveyor && cd conveyor && hotrail test conveyor.ladder"
)]
pub struct Options {
    /// Folder of the project; its last part is the program's name
    #[arg(value_name = "NAME")]
    folder: PathBuf,
}

/// The files of a new project; `{{NAME}}` in text and path stands for the program's name.
const FILES: [(&str, &str); 3] = [
    ("{{NAME}}.ladder", include_str!("../../templates/new/program.ladder")),
    ("README.md", include_str!("../../templates/new/README.md")),
    (".github/workflows/ladder.yml", include_str!("../../templates/new/ladder.yml")),
];

pub fn run(options: &Options) -> anyhow::Result<Verdict> {
    let folder = &options.folder;
    let Some(name) = folder.file_name().and_then(|name| name.to_str()) else {
        bail!("{} is no name for a new folder", folder.display());
    };
    if let Err(problem) = check::program_name(name) {
        bail!("`{name}` cannot name a program: {problem}");
    }
    if folder.symlink_metadata().is_ok() {
        bail!("{} is there already", folder.display());
    }
    create(folder, name).with_context(|| folder.display().to_string())?;
    out(&format!("{} is ready: its README.md has three commands to try\n", folder.display()));
    Ok(Verdict::Good)
}

/// Makes the project under a name of its own first, so that it is there as a whole or not at all.
fn create(folder: &Path, name: &str) -> anyhow::Result<()> {
    let parent = match folder.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
    fs::create_dir_all(parent)?;
    let unfinished = tempfile::Builder::new().prefix(".hotrail-").tempdir_in(parent)?;
    let project = unfinished.path().join(name);
    for (path, text) in FILES {
        let path = project.join(path.replace("{{NAME}}", name));
        fs::create_dir_all(path.parent().expect("it is in the project"))?;
        fs::write(path, text.replace("{{NAME}}", name))?;
    }
    fs::rename(project, folder)?;
    Ok(())
}
