//! Which warnings a command reports, and which of them are errors.

use hotrail::diagnostic::{Code, code, similar_name};
use hotrail::lint;

/// The warnings that are wanted.
#[derive(clap::Args)]
pub struct Lints {
    /// Do not report these warnings and notes: codes or names, such as W0301 or double-coil
    #[arg(long, value_name = "CODES", value_delimiter = ',', value_parser = lint_code)]
    allow: Vec<Code>,
    /// Take these for errors: codes or names, or `warnings` for all warnings
    #[arg(long, value_name = "CODES", value_delimiter = ',', value_parser = denied)]
    deny: Vec<Denied>,
}

#[derive(Clone, Copy)]
enum Denied {
    Warnings,
    One(Code),
}

impl Lints {
    /// The same for the library.
    pub fn options(&self) -> lint::Options {
        let one = |denied: &Denied| match denied {
            Denied::Warnings => None,
            Denied::One(code) => Some(*code),
        };
        lint::Options {
            off: false,
            allow: self.allow.clone(),
            deny: self.deny.iter().filter_map(one).collect(),
            clock_hz: None,
            deny_warnings: self.deny.iter().any(|denied| matches!(denied, Denied::Warnings)),
        }
    }
}

/// The code of that id or name.
pub fn any_code(text: &str) -> Result<Code, String> {
    code::named(text).ok_or_else(|| {
        let names: Vec<String> = code::ALL.iter().map(Code::name).collect();
        let known = code::ALL.iter().map(|code| code.id);
        match similar_name(text, known.chain(names.iter().map(String::as_str))) {
            Some(similar) => format!("there is no such code; is {similar} meant?"),
            None => "there is no such code; `hotrail explain` lists them".to_owned(),
        }
    })
}

fn lint_code(text: &str) -> Result<Code, String> {
    match any_code(text)? {
        code if code.is_lint() => Ok(code),
        code => Err(format!("{} is an error in any case", code.id)),
    }
}

fn denied(text: &str) -> Result<Denied, String> {
    if text == "warnings" { Ok(Denied::Warnings) } else { lint_code(text).map(Denied::One) }
}
