//! Files at the edge: sources in, artifacts out, all of them or none.

use std::collections::HashMap;
use std::fs;
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};

use crate::backend::{self, Artifact, processor};
use crate::diagnostic::{Code, code};
use crate::source::Source;

/// Largest source that is read unless asked otherwise, in bytes.
pub const LARGEST_SOURCE: u64 = 64 << 20;

/// What went wrong with a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FileError {
    /// The kind of finding.
    pub code: Code,
    /// The file, as named by the user.
    pub path: PathBuf,
    /// What is wrong with it.
    pub problem: String,
    /// How to mend it, if that can be said.
    pub help: Option<String>,
}

impl FileError {
    fn new(code: Code, path: &Path, problem: impl ToString) -> Self {
        FileError { code, path: path.to_owned(), problem: problem.to_string(), help: None }
    }

    fn help(self, help: &str) -> Self {
        FileError { help: Some(help.to_owned()), ..self }
    }
}

impl std::fmt::Display for FileError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        writeln!(f, "error[{}]: {}: {}", self.code.id, self.path.display(), self.problem)?;
        match &self.help {
            Some(help) => writeln!(f, "  = help: {help}"),
            None => Ok(()),
        }
    }
}

impl std::error::Error for FileError {}

/// Reads a source of at most [`LARGEST_SOURCE`]; `-` is standard input.
///
/// # Errors
/// If it cannot be read, is too large or is no UTF-8 text.
pub fn read_source(path: &Path) -> Result<Source, FileError> {
    read_source_up_to(path, LARGEST_SOURCE)
}

/// Reads a source of at most so many bytes; `-` is standard input.
///
/// # Errors
/// If it cannot be read, is too large or is no UTF-8 text.
pub fn read_source_up_to(path: &Path, largest: u64) -> Result<Source, FileError> {
    let fail = |problem: String| FileError::new(code::CANNOT_READ, path, problem);
    let from_stdin = path.as_os_str() == "-";
    let open = || -> io::Result<Box<dyn io::Read>> {
        Ok(if from_stdin { Box::new(io::stdin()) } else { Box::new(fs::File::open(path)?) })
    };
    let mut bytes = Vec::new();
    open()
        .and_then(|file| file.take(largest + 1).read_to_end(&mut bytes))
        .map_err(|error| fail(error.to_string()))?;
    if bytes.len() as u64 > largest {
        return Err(fail(format!("larger than {} MiB", largest >> 20))
            .help("split the program into several, or allow more with --max-size"));
    }
    let name = if from_stdin { "<stdin>".to_owned() } else { path.display().to_string() };
    match String::from_utf8(bytes) {
        Ok(text) => Ok(Source::new(name, text)),
        Err(error) => {
            let valid = &error.as_bytes()[..error.utf8_error().valid_up_to()];
            let before = Source::new(name, String::from_utf8_lossy(valid));
            let place = before.position(valid.len() as u32);
            Err(FileError::new(code::NOT_TEXT, path, format!("not UTF-8 at {place}"))
                .help("save it as UTF-8"))
        }
    }
}

/// Writes every artifact into a folder, or none: each goes to a new file first, which then takes
/// the artifact's name.
///
/// # Errors
/// If a file cannot be written, is a symbolic link, is one of the sources, or is there and was
/// not made by hotrail (unless `force`).
pub fn write_all(
    folder: &Path,
    artifacts: &[Artifact],
    sources: &[PathBuf],
    force: bool,
) -> Result<(), FileError> {
    if folder.is_file() {
        let error = FileError::new(code::CANNOT_WRITE, folder, "is a file, not a folder");
        return Err(error.help("name a folder; the files in it are named after the program"));
    }
    fs::create_dir_all(folder).map_err(|error| cannot_write(folder, error))?;
    let force = if force { Force::Yes } else { Force::No };
    let mut staged = Vec::new();
    for artifact in artifacts {
        let path = folder.join(&artifact.file_name);
        check_target(&path, sources, force)?;
        staged.push(stage(path, &artifact.contents, set_usual_permissions)?);
    }
    persist(staged)
}

/// Whether a file that hotrail did not make may be replaced.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Force {
    /// The user asked for it.
    Yes,
    /// The user could ask for it.
    No,
    /// The command has no option for it.
    Never,
}

/// A file that is written piece by piece and takes its name when it is complete.
pub struct NewFile {
    staged: Staged,
    out: io::BufWriter<fs::File>,
}

impl NewFile {
    /// A new file that is to have this path; the folder is made if it is not there.
    ///
    /// # Errors
    /// As for [`write_all`].
    pub fn create(path: &Path, sources: &[PathBuf]) -> Result<NewFile, FileError> {
        check_target(path, sources, Force::Never)?;
        if let Some(folder) = path.parent().filter(|folder| !folder.as_os_str().is_empty()) {
            fs::create_dir_all(folder).map_err(|error| cannot_write(folder, error))?;
        }
        let staged = stage(path.to_owned(), b"", set_usual_permissions)?;
        let again = staged.file.as_file().try_clone();
        let out = io::BufWriter::new(again.map_err(|error| cannot_write(path, error))?);
        Ok(NewFile { staged, out })
    }

    /// Adds a piece.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn write(&mut self, piece: &[u8]) -> Result<(), FileError> {
        self.out.write_all(piece).map_err(|error| cannot_write(&self.staged.path, error))
    }

    /// Gives the file its name.
    ///
    /// # Errors
    /// If that cannot be done; there is no file then.
    pub fn finish(mut self) -> Result<(), FileError> {
        self.out.flush().map_err(|error| cannot_write(&self.staged.path, error))?;
        persist(vec![self.staged])
    }
}

/// Gives ordinary files a new text, all of them or none; they keep their permissions.
///
/// # Errors
/// If one of them cannot be written, is read-only or is a symbolic link.
pub fn replace_all(files: &[(&Path, String)]) -> Result<(), FileError> {
    let mut staged = Vec::new();
    for (path, text) in files {
        let permissions = check_ordinary(path)?.permissions();
        if permissions.readonly() {
            let error = FileError::new(code::CANNOT_WRITE, path, "is read-only");
            return Err(error.help("make it writable first"));
        }
        staged.push(stage(path.to_path_buf(), text.as_bytes(), |file| {
            file.set_permissions(permissions)
        })?);
    }
    persist(staged)
}

fn cannot_write(path: &Path, error: io::Error) -> FileError {
    FileError::new(code::CANNOT_WRITE, path, error)
}

/// A complete file that has yet to take its name.
struct Staged {
    file: tempfile::NamedTempFile,
    path: PathBuf,
}

/// Writes a new file beside the one that it is to replace.
fn stage(
    path: PathBuf,
    contents: &[u8],
    set_permissions: impl FnOnce(&fs::File) -> io::Result<()>,
) -> Result<Staged, FileError> {
    let folder = match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    let write = || -> io::Result<tempfile::NamedTempFile> {
        let mut file = tempfile::Builder::new().prefix(".hotrail-").tempfile_in(folder)?;
        file.write_all(contents)?;
        set_permissions(file.as_file())?;
        Ok(file)
    };
    let file = write().map_err(|error| cannot_write(&path, error))?;
    Ok(Staged { file, path })
}

fn persist(staged: Vec<Staged>) -> Result<(), FileError> {
    for Staged { file, path } in staged {
        file.persist(&path).map_err(|error| cannot_write(&path, error.error))?;
    }
    Ok(())
}

/// Refuses what is no file, or is one under another name.
fn check_ordinary(path: &Path) -> Result<fs::Metadata, FileError> {
    let refuse = |problem: &str| FileError::new(code::CANNOT_WRITE, path, problem);
    let metadata = fs::symlink_metadata(path).map_err(|error| cannot_write(path, error))?;
    if metadata.is_symlink() {
        return Err(refuse("is a symbolic link").help("name the file that it leads to"));
    }
    if !metadata.is_file() {
        return Err(refuse("is no ordinary file"));
    }
    Ok(metadata)
}

/// Sources that would write one file, also on systems that ignore case.
pub fn shared_names(artifacts: &[(PathBuf, Vec<Artifact>)]) -> Vec<FileError> {
    let mut owners: HashMap<String, &Path> = HashMap::new();
    let mut errors = Vec::new();
    for (source, made) in artifacts {
        for Artifact { file_name, .. } in made {
            if let Some(other) = owners.insert(file_name.to_lowercase(), source) {
                let same = other == source;
                let problem = match same {
                    true => "is named twice".to_owned(),
                    false => format!("would write {file_name}, and so would {}", other.display()),
                };
                let help =
                    if same { "name it once" } else { "give one of the programs another name" };
                errors.push(FileError::new(code::SAME_NAME, source, problem).help(help));
                if same {
                    break;
                }
            }
        }
    }
    errors
}

/// Refuses to write where something would be lost that hotrail did not make.
fn check_target(path: &Path, sources: &[PathBuf], force: Force) -> Result<(), FileError> {
    let Ok(metadata) = fs::symlink_metadata(path) else { return Ok(()) };
    let refuse = |problem: &str| FileError::new(code::CANNOT_WRITE, path, problem);
    if metadata.is_symlink() {
        return Err(refuse("is a symbolic link").help("remove it first"));
    }
    let target = path.canonicalize().ok();
    let is_target = |source: &PathBuf| target.is_some() && source.canonicalize().ok() == target;
    if sources.iter().any(is_target) {
        return Err(refuse("is a source").help("choose another folder"));
    }
    if !metadata.is_file() {
        return Err(refuse("is no ordinary file").help("remove it first"));
    }
    if force == Force::Yes || metadata.len() == 0 {
        return Ok(());
    }
    let mut start = Vec::new();
    let file = fs::File::open(path);
    file.and_then(|file| file.take(512).read_to_end(&mut start))
        .map_err(|error| refuse(&error.to_string()))?;
    if backend::bears_header(&String::from_utf8_lossy(&start)) {
        return Ok(());
    }
    if is_recorded(path, metadata.len()) {
        return Ok(());
    }
    Err(refuse("is there and was not made by hotrail").help(match force {
        Force::No => "use --force to replace it, or choose another folder",
        Force::Yes | Force::Never => "remove it first, or choose another name",
    }))
}

/// True if a file without a header is unchanged since a record of ours beside it named it.
fn is_recorded(path: &Path, length: u64) -> bool {
    let Some(name) = path.file_name().and_then(|name| name.to_str()) else { return false };
    // No image is longer, and no record.
    const LONGEST: u64 = 1 << 16;
    length <= LONGEST
        && processor::records_of(name).iter().any(|record| {
            let record = path.with_file_name(record);
            let is_short = fs::metadata(&record).is_ok_and(|found| found.len() <= LONGEST);
            let text = if is_short { fs::read_to_string(&record).ok() } else { None };
            text.filter(|text| backend::bears_header(text)).is_some_and(|text| {
                fs::read(path).is_ok_and(|contents| processor::vouches(&text, name, &contents))
            })
        })
}

/// A temporary file is its owner's alone; an artifact is what `File::create` would make it.
#[cfg(unix)]
fn set_usual_permissions(file: &fs::File) -> io::Result<()> {
    use std::os::unix::fs::PermissionsExt;
    // The umask cannot be read without changing it; 644 is what nearly everybody has.
    file.set_permissions(fs::Permissions::from_mode(0o644))
}

#[cfg(not(unix))]
fn set_usual_permissions(_: &fs::File) -> io::Result<()> {
    Ok(())
}
