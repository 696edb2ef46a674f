//! The command line in a folder of its own.

use std::fs;
use std::io::Write;
use std::iter::once;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// The command line; a campaign of random programs does without.
const HOTRAIL: Option<&str> = option_env!("CARGO_BIN_EXE_hotrail");

/// A folder that is removed in the end.
pub struct Folder(tempfile::TempDir);

impl Folder {
    /// An empty one.
    pub fn new() -> Self {
        Folder(tempfile::tempdir().unwrap())
    }

    /// Writes a file in it.
    pub fn write(&self, name: &str, text: &str) {
        fs::write(self.path(name), text).unwrap();
    }

    /// The text of a file in it.
    pub fn read(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).unwrap()
    }

    /// The path of a file in it.
    pub fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    /// Runs `hotrail` in it with a text as standard input.
    pub fn run_with(&self, arguments: &[&str], input: &str) -> Run {
        let mut command = Command::new(HOTRAIL.expect("a test has it"));
        command.args(arguments).current_dir(self.0.path());
        let pipes = command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = pipes.spawn().unwrap();
        child.stdin.take().unwrap().write_all(input.as_bytes()).unwrap();
        Run::new(child.wait_with_output().unwrap())
    }

    /// Runs a line of a shell in it, to which `hotrail` is a command.
    pub fn shell(&self, line: &str) -> Run {
        let tool = Path::new(HOTRAIL.expect("a test has it")).parent().unwrap();
        let usual = std::env::var_os("PATH").unwrap_or_default();
        let places = once(tool.to_owned()).chain(std::env::split_paths(&usual));
        let mut command = Command::new("sh");
        command.args(["-c", line]).env("PATH", std::env::join_paths(places).unwrap());
        Run::new(command.current_dir(self.0.path()).output().unwrap())
    }

    /// Runs `hotrail` in it.
    pub fn run(&self, arguments: &[&str]) -> Run {
        let mut command = Command::new(HOTRAIL.expect("a test has it"));
        Run::new(command.args(arguments).current_dir(self.0.path()).output().unwrap())
    }
}

/// What a run of `hotrail` did.
pub struct Run {
    /// Exit code.
    pub code: i32,
    /// Standard output.
    pub out: String,
    /// Standard error.
    pub err: String,
}

impl Run {
    /// Reads what a process left.
    fn new(output: Output) -> Self {
        let text = |bytes| String::from_utf8(bytes).unwrap();
        Run {
            code: output.status.code().unwrap(),
            out: text(output.stdout),
            err: text(output.stderr),
        }
    }
}
