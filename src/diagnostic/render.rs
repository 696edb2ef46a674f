//! Diagnostics as text for people, one line each for editors, and JSON for tools.

use annotate_snippets::{Annotation, AnnotationKind, Level, Renderer, Snippet};
use serde::Serialize;

use super::{Code, Diagnostic, Label, Severity};
use crate::source::{Source, Span};

/// The finding with a snippet of the source, in the manner of rustc, ending in a line feed.
pub fn render(diagnostic: &Diagnostic, source: &Source, color: bool) -> String {
    let level = match diagnostic.code.severity {
        Severity::Error => Level::ERROR,
        Severity::Warning => Level::WARNING,
        Severity::Note => Level::NOTE,
    };
    let primary = &diagnostic.primary;
    let is_near = |label: &&Label| {
        let distance = source.line(label.span.start).abs_diff(source.line(primary.span.start));
        distance < NEAR
    };
    let (near, far): (Vec<&Label>, Vec<&Label>) = diagnostic.related.iter().partition(is_near);
    let mut group = level
        .primary_title(&diagnostic.message)
        .id(diagnostic.code.id)
        .element(snippet(source, Some(primary), &near));
    for label in far {
        group = group.element(snippet(source, None, &[label]));
    }
    for help in &diagnostic.help {
        group = group.element(Level::HELP.message(help));
    }
    let renderer = if color { Renderer::styled() } else { Renderer::plain() };
    let mut text = renderer.render(&[group]).to_string();
    text.push('\n');
    text
}

/// Labels that are more lines apart get snippets of their own.
const NEAR: u32 = 100;

/// The lines that hold the labels, and one before and after. Given the whole text, the renderer
/// would go through all of it for each finding.
fn snippet<'a>(
    source: &'a Source,
    primary: Option<&'a Label>,
    related: &[&'a Label],
) -> Snippet<'a, Annotation<'a>> {
    let all = || primary.into_iter().chain(related.iter().copied());
    let whole = all().map(|label| label.span).reduce(Span::to).unwrap_or_default();
    let first = source.line(whole.start).saturating_sub(1).max(1);
    let lines = source.lines(first, source.line(whole.end) + 1);
    let place = |label: &Label| {
        let offset = |at: u32| (at - lines.start) as usize;
        offset(label.span.start)..offset(label.span.end)
    };
    let primary =
        primary.map(|label| AnnotationKind::Primary.span(place(label)).label(&label.text));
    let related =
        related.iter().map(|label| AnnotationKind::Context.span(place(label)).label(&label.text));
    Snippet::source(source.slice(lines))
        .path(source.name())
        .line_start(first as usize)
        .annotations(primary.into_iter().chain(related))
}

/// One line: `file:line:column: error[E0001]: message`, ending in a line feed.
pub fn render_short(diagnostic: &Diagnostic, source: &Source) -> String {
    let Diagnostic { code, message, primary, .. } = diagnostic;
    let position = source.position(primary.span.start);
    format!("{}:{position}: {}[{}]: {message}\n", source.name(), code.severity, code.id)
}

#[derive(Serialize)]
struct JsonLabel<'a> {
    line: u32,
    column: u32,
    end_line: u32,
    end_column: u32,
    text: &'a str,
}

impl<'a> JsonLabel<'a> {
    fn new(source: &Source, Label { span, text }: &'a Label) -> Self {
        let (start, end) = (source.position(span.start), source.position(span.end));
        JsonLabel {
            line: start.line,
            column: start.column,
            end_line: end.line,
            end_column: end.column,
            text,
        }
    }
}

#[derive(Serialize)]
struct JsonDiagnostic<'a> {
    file: &'a str,
    severity: String,
    code: &'a str,
    message: &'a str,
    primary: Option<JsonLabel<'a>>,
    related: Vec<JsonLabel<'a>>,
    help: &'a [String],
}

impl JsonDiagnostic<'_> {
    fn line(&self) -> String {
        serde_json::to_string(self).expect("strings and numbers can be written as JSON") + "\n"
    }
}

/// One JSON object on one line; lines and columns count from 1, ends are exclusive.
pub fn render_json(diagnostic: &Diagnostic, source: &Source) -> String {
    let finding = JsonDiagnostic {
        file: source.name(),
        severity: diagnostic.code.severity.to_string(),
        code: diagnostic.code.id,
        message: &diagnostic.message,
        primary: Some(JsonLabel::new(source, &diagnostic.primary)),
        related: diagnostic.related.iter().map(|label| JsonLabel::new(source, label)).collect(),
        help: &diagnostic.help,
    };
    finding.line()
}

/// The same about a file as a whole: it has no primary place.
pub fn render_json_file(code: Code, file: &str, message: &str, help: &[String]) -> String {
    let finding = JsonDiagnostic {
        file,
        severity: code.severity.to_string(),
        code: code.id,
        message,
        primary: None,
        related: Vec::new(),
        help,
    };
    finding.line()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostic::code;

    #[test]
    fn a_place_far_away_is_shown_as_well_as_one_nearby() {
        let text = format!("rung a\n{}rung b\n", "// nothing\n".repeat(5000));
        let source = Source::new("far.ladder", text);
        let end = source.text().len();
        let finding = Diagnostic::new(code::DOUBLE_COIL, Span::new(5, 6), "twice")
            .label("here")
            .also(Span::new(0, 4), "near")
            .also(Span::new(end - 2, end - 1), "far");
        let rendered = render(&finding, &source, false);
        assert!(rendered.contains("--> far.ladder:1:6\n"), "{rendered}");
        assert!(rendered.contains("::: far.ladder:5002:6\n"), "{rendered}");
        assert!(rendered.contains("5002 | rung b\n     |      - far"), "{rendered}");
        assert!(rendered.lines().count() < 15, "{rendered}");
    }

    #[test]
    fn the_end_of_a_text_is_a_place() {
        for text in ["", "rung a", "rung a\n"] {
            let source = Source::new("end.ladder", text);
            let end = Span::new(text.len(), text.len());
            let finding = Diagnostic::new(code::SYNTAX, end, "something is missing");
            assert!(render(&finding, &source, false).contains("--> end.ladder:1:"), "{text:?}");
        }
    }
}
