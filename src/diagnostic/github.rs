//! Findings as workflow commands, which GitHub shows beside the lines of a change.

use super::{Code, Diagnostic, Severity};
use crate::source::Source;

/// One command on one line: `::error file=a.ladder,line=3,col=6,endColumn=9,title=E0101::message`,
/// ending in a line feed.
pub fn render_github(diagnostic: &Diagnostic, source: &Source) -> String {
    let span = diagnostic.primary.span;
    let (start, end) = (source.position(span.start), source.position(span.end));
    // GitHub takes columns only where the place lies on one line.
    let place = if start.line == end.line {
        format!(",line={},col={},endColumn={}", start.line, start.column, end.column)
    } else {
        format!(",line={},endLine={}", start.line, end.line)
    };
    command(diagnostic.code, source.name(), &place, &diagnostic.plain_text())
}

/// A command about a file as a whole, ending in a line feed.
pub fn render_github_file(code: Code, file: &str, message: &str) -> String {
    command(code, file, "", message)
}

fn command(code: Code, file: &str, place: &str, message: &str) -> String {
    let level = match code.severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
        Severity::Note => "notice",
    };
    let (file, message) = (property(file), data(message));
    format!("::{level} file={file}{place},title={}::{message}\n", code.id)
}

/// Text after the second `::`.
fn data(text: &str) -> String {
    text.replace('%', "%25").replace('\r', "%0D").replace('\n', "%0A")
}

/// Text behind `name=`.
fn property(text: &str) -> String {
    data(text).replace(':', "%3A").replace(',', "%2C")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostic::code;
    use crate::source::Span;

    #[test]
    fn what_the_runner_would_take_for_its_own_is_escaped() {
        let source = Source::new("a,b:100%.ladder", "rung é (y)\n(z)");
        let finding = |start, end| {
            Diagnostic::new(code::UNKNOWN_NAME, Span::new(start, end), "50%: a, b\r\nc")
                .help("mend it")
        };
        assert_eq!(
            render_github(&finding(8, 11), &source),
            "::error file=a%2Cb%3A100%25.ladder,line=1,col=8,endColumn=11,title=E0101\
             ::50%25: a, b%0D%0Ac%0Ahelp: mend it\n"
        );
        let over_lines = render_github(&finding(8, 13), &source);
        assert!(over_lines.contains(",line=1,endLine=2,title="), "{over_lines}");
    }
}
