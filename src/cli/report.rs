//! Findings in the form that the user asked for.

use std::io::{self, Write};
use std::path::Path;

use hotrail::diagnostic::{self, Diagnostic, Sarif};
use hotrail::files::{self, FileError};
use hotrail::lint;
use hotrail::model::Program;
use hotrail::report;
use hotrail::source::Source;

use super::order::Order;
use super::{MessageFormat, Style};

/// Nobody reads more findings about one file with their snippets.
const MOST_SHOWN: usize = 100;

/// Takes the findings of a command. What people and editors read goes to standard error as it is
/// found; what GitHub reads goes to standard output, SARIF as one document at the end.
pub struct Report {
    style: Style,
    sarif: Sarif,
}

impl Report {
    /// Nothing found yet.
    pub fn new(style: Style) -> Self {
        Report { style, sarif: Sarif::default() }
    }

    /// Reads, parses and checks a file and reports what was found. The program is there if
    /// nothing stands against building it.
    pub fn analyze(&mut self, path: &Path, lints: &lint::Options) -> Option<(Source, Program)> {
        let source = match self.read(path) {
            Ok(source) => source,
            Err(error) => {
                self.file_error(&error);
                return None;
            }
        };
        let (program, diagnostics) = hotrail::analyze_with(&source, lints);
        self.findings(&diagnostics, &source);
        program.map(|program| (source, program))
    }

    /// Puts the rungs of a program into an order and remarks what that changes.
    pub fn reorder(&self, path: &Path, program: &mut Program, order: Order) {
        if let Some(changes) = order.apply(program) {
            let summary = report::order_summary(program, &changes);
            self.remark(&format!("{}: {summary}", path.display()));
        }
    }

    /// Reports findings in a source.
    pub fn findings(&mut self, diagnostics: &[Diagnostic], source: &Source) {
        let human = self.style.message_format == MessageFormat::Human;
        let shown = if human { MOST_SHOWN } else { usize::MAX };
        for found in diagnostics.iter().take(shown) {
            match self.style.message_format {
                MessageFormat::Human => {
                    err(&(diagnostic::render(found, source, self.style.use_color()) + "\n"));
                }
                MessageFormat::Short => err(&diagnostic::render_short(found, source)),
                MessageFormat::Json => err(&diagnostic::render_json(found, source)),
                MessageFormat::Github => out(&diagnostic::render_github(found, source)),
                MessageFormat::Sarif => self.sarif.add(found, source),
            }
        }
        if diagnostics.len() > shown {
            let more = diagnostics.len() - shown;
            err(&format!("{more} more findings; --message-format short shows all\n"));
        }
    }

    /// Reads a source of the size that the user allows.
    ///
    /// # Errors
    /// If it cannot be read, is too large or is no text.
    pub fn read(&self, path: &Path) -> Result<Source, FileError> {
        files::read_source_up_to(path, self.style.max_size << 20)
    }

    /// Reports what is wrong with a file as a whole.
    pub fn file_error(&mut self, error: &FileError) {
        let FileError { code, path, problem, help } = error;
        let file = path.display().to_string();
        let with_help = match help {
            Some(help) => format!("{problem}\nhelp: {help}"),
            None => problem.clone(),
        };
        match self.style.message_format {
            MessageFormat::Human => err(&error.to_string()),
            MessageFormat::Short => {
                err(&format!("{file}: {}[{}]: {problem}\n", code.severity, code.id));
            }
            MessageFormat::Json => {
                err(&diagnostic::render_json_file(*code, &file, problem, help.as_slice()));
            }
            MessageFormat::Github => {
                out(&diagnostic::render_github_file(*code, &file, &with_help));
            }
            MessageFormat::Sarif => self.sarif.add_file(*code, &file, &with_help),
        }
    }

    /// Tells people something that is no finding.
    pub fn remark(&self, text: &str) {
        match self.style.message_format {
            MessageFormat::Human | MessageFormat::Short => err(&format!("note: {text}\n")),
            MessageFormat::Json | MessageFormat::Sarif | MessageFormat::Github => {}
        }
    }

    /// Prints the result of a command, which must not stand inside a document.
    pub fn result(&self, text: &str) {
        match self.style.message_format {
            MessageFormat::Sarif => err(text),
            _ => out(text),
        }
    }

    /// True if a result may have colours in it.
    pub fn colors_results(&self) -> bool {
        self.style.use_color_on(&io::stdout())
    }

    /// Ends the report.
    pub fn finish(self) {
        if self.style.message_format == MessageFormat::Sarif {
            out(&self.sarif.render());
        }
    }
}

/// Writes to standard output.
pub fn out(text: &str) {
    write(io::stdout().lock(), text);
}

/// Writes to standard error.
pub fn err(text: &str) {
    write(io::stderr().lock(), text);
}

/// Writes at once. Where the reader has gone away, as `head` does, the program ends without a
/// word: nobody is there to read it.
fn write(mut to: impl Write, text: &str) {
    if to.write_all(text.as_bytes()).and_then(|()| to.flush()).is_err() {
        std::process::exit(1);
    }
}
