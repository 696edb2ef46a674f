//! Comments that allow a finding: `// allow(W0301): why`, `/* allow(double-coil, W0302) */`.
//!
//! Above the header such a comment holds for the file. At the end of a line it holds for what
//! stands on the line, alone on a line for what stands below it; and where a rung starts there,
//! for the whole rung. At the end of a rung it holds for the whole rung too, so that it does
//! where the formatter has wrapped the rung.

use std::collections::HashMap;

use crate::diagnostic::{Code, Diagnostic, code, similar_name};
use crate::source::{Source, Span};
use crate::syntax::ast::{File, Item};

/// What the comments of a file allow.
pub(super) struct Allowed {
    /// By code, sorted by place; each end is the furthest one so far.
    spans: HashMap<&'static str, Vec<Span>>,
}

impl Allowed {
    /// Reads the comments; one that names no warning is a finding itself.
    pub fn new(source: &Source, file: &File<'_>, found: &mut Vec<Diagnostic>) -> Self {
        let directives: Vec<(usize, &str)> = file
            .comments
            .iter()
            .enumerate()
            .filter_map(|(number, &comment)| Some((number, names(source.slice(comment))?)))
            .collect();
        let mut spans: HashMap<_, Vec<Span>> = HashMap::new();
        if directives.is_empty() {
            return Allowed { spans };
        }
        let scopes = Scopes::new(source, file);
        for (number, names) in directives {
            let scope = scopes.of(number);
            let start = names.as_ptr().addr() - source.text().as_ptr().addr();
            for name in words(names, start) {
                match lint_named(source.slice(name)) {
                    Ok(code) => spans.entry(code.id).or_default().push(scope),
                    Err((message, help)) => found.push(
                        Diagnostic::new(code::BAD_ALLOW, name, message)
                            .label("allows nothing")
                            .help(help),
                    ),
                }
            }
        }
        for spans in spans.values_mut() {
            spans.sort();
            let mut furthest = 0;
            for span in spans {
                furthest = furthest.max(span.end);
                span.end = furthest;
            }
        }
        Allowed { spans }
    }

    /// True if a comment allows the finding.
    pub fn covers(&self, finding: &Diagnostic) -> bool {
        let Some(spans) = self.spans.get(finding.code.id) else { return false };
        let place = finding.primary.span.start;
        let before = spans.partition_point(|span| span.start <= place);
        before > 0 && spans[before - 1].end > place
    }
}

/// What stands between the brackets of a comment that starts with `allow(`.
fn names(comment: &str) -> Option<&str> {
    let text = comment[2..].trim_start().strip_prefix("allow(")?;
    Some(text.split(')').next().unwrap_or(text))
}

/// The places of the names in a list separated by commas.
fn words(list: &str, start: usize) -> impl Iterator<Item = Span> {
    list.split(',').scan(start, |at, part| {
        let start = *at + part.len() - part.trim_start().len();
        *at += part.len() + 1;
        Some(Span::new(start, start + part.trim().len()))
    })
}

/// The warning or note of that id or name; else what is wrong with it and how to mend it.
fn lint_named(name: &str) -> Result<Code, (String, String)> {
    match code::named(name) {
        Some(code) if code.is_lint() => Ok(code),
        Some(code) => Err((
            format!("{} is an error, which cannot be allowed", code.id),
            format!("mend it; `hotrail explain {}` says how", code.id),
        )),
        None => {
            let lints = || code::ALL.iter().filter(|code| code.is_lint());
            let names: Vec<String> = lints().map(Code::name).collect();
            let known = lints().map(|code| code.id).chain(names.iter().map(String::as_str));
            let help = match similar_name(name, known) {
                Some(similar) => format!("is `{similar}` meant?"),
                None => "`hotrail explain` lists the codes".to_owned(),
            };
            Err((format!("there is no warning `{name}`"), help))
        }
    }
}

/// Where the parts of a file lie, to tell what a comment belongs to.
struct Scopes<'f> {
    source: &'f Source,
    comments: &'f [Span],
    /// Where the header stands.
    header: u32,
    rungs: Vec<Span>,
    /// From the first name of a declaration to the last.
    declarations: Vec<Span>,
}

impl<'f> Scopes<'f> {
    fn new(source: &'f Source, file: &'f File<'_>) -> Self {
        let (mut header, mut rungs, mut declarations) = (0, Vec::new(), Vec::new());
        for item in &file.items {
            match item {
                Item::Header(found) => header = found.name.span.start,
                Item::Rung(rung) => rungs.push(rung.span),
                Item::Variables(variables) => {
                    let names = || variables.names.iter().map(|declared| declared.name.span);
                    declarations.extend(names().reduce(Span::to));
                }
                _ => {}
            }
        }
        Scopes { source, comments: &file.comments, header, rungs, declarations }
    }

    /// What a comment holds for, by its number.
    fn of(&self, number: usize) -> Span {
        let comment = self.comments[number];
        if comment.start < self.header {
            return Span { start: 0, end: u32::MAX };
        }
        let line_start = self.line_of(comment.start).start;
        let before = self.source.slice(Span { start: line_start, end: comment.start });
        if !before.trim_start().is_empty() {
            let line = self.line_of(comment.start);
            let scope = self.and_rungs(line);
            return self.ending_in(line).map_or(scope, |rung| scope.to(rung));
        }
        let line = self.line_of(self.code_after(number));
        let scope = self.and_rungs(line);
        let declaration = starting_in(&self.declarations, line).last();
        declaration.map_or(scope, |declaration| scope.to(*declaration))
    }

    /// The line that holds the byte at an offset, with its line feed.
    fn line_of(&self, offset: u32) -> Span {
        let text = self.source.text();
        let start = text[..offset as usize].rfind('\n').map_or(0, |at| at + 1);
        let end = text[offset as usize..].find('\n').map_or(text.len(), |at| offset as usize + at);
        Span::new(start, end + 1)
    }

    /// A line and the rungs that start on it.
    fn and_rungs(&self, line: Span) -> Span {
        starting_in(&self.rungs, line).last().map_or(line, |rung| line.to(*rung))
    }

    /// The rung that ends on a line and starts above it.
    fn ending_in(&self, line: Span) -> Option<Span> {
        let above = self.rungs.partition_point(|rung| rung.start < line.start);
        let last = *self.rungs[..above].last()?;
        (line.start < last.end && last.end <= line.end).then_some(last)
    }

    /// The next place after a comment that is neither blank nor a comment.
    fn code_after(&self, number: usize) -> u32 {
        let text = self.source.text();
        let mut at = self.comments[number].end as usize;
        for comment in &self.comments[number + 1..] {
            if !text[at..comment.start as usize].trim().is_empty() {
                break;
            }
            at = comment.end as usize;
        }
        let blank = text[at..].len() - text[at..].trim_start().len();
        (at + blank) as u32
    }
}

/// The part of a list in text order that starts within a span.
fn starting_in(list: &[Span], span: Span) -> &[Span] {
    let start = list.partition_point(|item| item.start < span.start);
    let end = list.partition_point(|item| item.start < span.end);
    &list[start..end]
}
