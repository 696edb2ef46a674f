//! The compiler in a `build.rs`.

use std::fmt;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::backend::hdl::ResetStyle;
use crate::backend::{Artifact, BadOption, Emit, Options, Schedule, Unit};
use crate::diagnostic::{self, Diagnostic};
use crate::files::{self, FileError};
use crate::source::Source;

/// Compiles ladder files in a `build.rs`.
///
/// ```no_run
/// // build.rs, with hotrail = { version = "0.1", default-features = false }
/// // under [build-dependencies]
/// hotrail::Build::new()
///     .file("conveyor.ladder")
///     .emit(hotrail::Emit::Verilog)
///     .run()
///     .unwrap_or_else(|error| panic!("{error}"));
/// ```
#[derive(Clone, Debug, Default)]
pub struct Build {
    files: Vec<PathBuf>,
    kinds: Vec<Emit>,
    out_dir: Option<PathBuf>,
    options: Options,
}

impl Build {
    /// Nothing to compile yet.
    pub fn new() -> Self {
        Build::default()
    }

    /// Adds a ladder file.
    #[must_use]
    pub fn file(mut self, path: impl Into<PathBuf>) -> Self {
        self.files.push(path.into());
        self
    }

    /// Adds several ladder files.
    #[must_use]
    pub fn files<P: Into<PathBuf>>(mut self, paths: impl IntoIterator<Item = P>) -> Self {
        self.files.extend(paths.into_iter().map(Into::into));
        self
    }

    /// Adds something to make of every file; [`Emit::Verilog`] if nothing is asked for.
    #[must_use]
    pub fn emit(mut self, kind: Emit) -> Self {
        self.kinds.push(kind);
        self
    }

    /// The folder for the files; cargo's `OUT_DIR` if it is not said.
    #[must_use]
    pub fn out_dir(mut self, folder: impl Into<PathBuf>) -> Self {
        self.out_dir = Some(folder.into());
        self
    }

    /// What resets the registers.
    #[must_use]
    pub fn reset(mut self, style: ResetStyle) -> Self {
        self.options.reset = style;
        self
    }

    /// In which clocks of a scan the rungs act.
    #[must_use]
    pub fn schedule(mut self, schedule: Schedule) -> Self {
        self.options.schedule = schedule;
        self
    }

    /// Shows a variable or member at a port of its own.
    #[must_use]
    pub fn observe(mut self, name: impl Into<String>) -> Self {
        self.options.observe.push(name.into());
        self
    }

    /// The frequency of the board's clock in Hz, instead of the program's own.
    #[must_use]
    pub fn clock_hz(mut self, hz: u64) -> Self {
        self.options.clock_hz = Some(hz);
        self
    }

    /// Compiles every file and returns the paths of what was written. Tells cargo on which files
    /// the result depends, and shows warnings as cargo's.
    ///
    /// # Errors
    /// If a file cannot be read or written, or a program is at fault. Nothing is written then.
    pub fn run(&self) -> Result<Vec<PathBuf>, BuildError> {
        let mut error = BuildError::default();
        let folder =
            self.out_dir.clone().or_else(|| std::env::var_os("OUT_DIR").map(PathBuf::from));
        let Some(folder) = folder else {
            error.other.push("there is no folder: call out_dir, or run in a build.rs".to_owned());
            return Err(error);
        };
        let mut made = Vec::new();
        for path in &self.files {
            println!("cargo::rerun-if-changed={}", path.display());
            if let Some(artifacts) = self.compile(path, &mut error) {
                made.push((path.clone(), artifacts));
            }
        }
        error.other.extend(files::shared_names(&made).iter().map(FileError::to_string));
        if !error.is_empty() {
            return Err(error);
        }
        let artifacts: Vec<Artifact> = made.into_iter().flat_map(|(_, made)| made).collect();
        files::write_all(&folder, &artifacts, &self.files, false)?;
        Ok(artifacts.iter().map(|artifact| folder.join(&artifact.file_name)).collect())
    }

    fn compile(&self, path: &Path, error: &mut BuildError) -> Option<Vec<Artifact>> {
        let source = match files::read_source(path) {
            Ok(source) => Arc::new(source),
            Err(unread) => {
                error.other.push(unread.to_string());
                return None;
            }
        };
        let (program, diagnostics) = crate::analyze(&source);
        for diagnostic in diagnostics {
            if diagnostic.is_error() {
                error.findings.push(Finding { source: source.clone(), diagnostic });
            } else {
                print!("cargo::warning={}", diagnostic::render_short(&diagnostic, &source));
            }
        }
        let program = program?;
        let kinds = if self.kinds.is_empty() { &[Emit::Verilog] } else { &self.kinds[..] };
        match Unit::new(&program, &source, &self.options) {
            Ok(unit) => match unit.emit(kinds) {
                Ok(artifacts) => Some(artifacts),
                Err(findings) => {
                    let found = |diagnostic| Finding { source: source.clone(), diagnostic };
                    error.findings.extend(findings.into_iter().map(found));
                    None
                }
            },
            Err(BadOption(problem)) => {
                error.other.push(format!("{}: {problem}", path.display()));
                None
            }
        }
    }
}

/// An error in a program, with the source that it stands in.
#[derive(Clone, Debug)]
pub struct Finding {
    /// The program's text.
    pub source: Arc<Source>,
    /// What is wrong, and where.
    pub diagnostic: Diagnostic,
}

/// Why a build wrote nothing. Displayed, it is what the command line shows.
#[derive(Clone, Debug, Default)]
pub struct BuildError {
    /// Errors in programs.
    pub findings: Vec<Finding>,
    /// Everything else, such as a file that cannot be read.
    pub other: Vec<String>,
}

impl BuildError {
    fn is_empty(&self) -> bool {
        self.findings.is_empty() && self.other.is_empty()
    }
}

impl From<FileError> for BuildError {
    fn from(error: FileError) -> Self {
        BuildError { findings: Vec::new(), other: vec![error.to_string()] }
    }
}

impl fmt::Display for BuildError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for Finding { source, diagnostic } in &self.findings {
            writeln!(f, "{}", diagnostic::render(diagnostic, source, false))?;
        }
        self.other.iter().try_for_each(|problem| writeln!(f, "{}", problem.trim_end()))
    }
}

impl std::error::Error for BuildError {}
