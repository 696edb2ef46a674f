//! `hotrail completions`

use clap::CommandFactory;
use clap_complete::Shell;

use super::report::out;
use super::{Cli, Verdict};

/// Print what lets a shell complete the commands and options of hotrail
#[derive(clap::Args)]
#[command(after_help = "Example:
  hotrail completions bash > ~/.local/share/bash-completion/completions/hotrail")]
pub struct Options {
    /// The shell
    #[arg(value_enum)]
    shell: Shell,
}

pub fn run(options: &Options) -> anyhow::Result<Verdict> {
    let mut script = Vec::new();
    clap_complete::generate(options.shell, &mut Cli::command(), "hotrail", &mut script);
    out(&String::from_utf8_lossy(&script));
    Ok(Verdict::Good)
}
