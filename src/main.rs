//! The command line; `cli` holds a file for each sub-command.

mod cli;

fn main() -> std::process::ExitCode {
    cli::run()
}
