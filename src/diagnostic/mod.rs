//! What is wrong with a program, where, and how to mend it.

pub mod code;
mod github;
mod render;
mod sarif;

use std::borrow::Cow;

use crate::source::Span;
pub use code::{Code, Severity};
pub use github::{render_github, render_github_file};
pub use render::{render, render_json, render_json_file, render_short};
pub use sarif::Sarif;

/// A place in the source and what is to be seen there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Label {
    /// The place.
    pub span: Span,
    /// What stands there; may be empty.
    pub text: String,
}

/// One finding. The message says what is wrong, the primary label what stands at the place, the
/// help how to mend it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// Code, level and title of the kind of finding.
    pub code: Code,
    /// One sentence without a full stop.
    pub message: String,
    /// The place that has to change.
    pub primary: Label,
    /// Other places that explain it.
    pub related: Vec<Label>,
    /// How to mend it, one line each.
    pub help: Vec<String>,
}

impl Diagnostic {
    /// A finding at a place, with no label text and no help yet.
    pub fn new(code: Code, span: Span, message: impl Into<String>) -> Self {
        let primary = Label { span, text: String::new() };
        Diagnostic { code, message: message.into(), primary, related: Vec::new(), help: Vec::new() }
    }

    /// Says what stands at the primary place.
    #[must_use]
    pub fn label(mut self, text: impl Into<String>) -> Self {
        self.primary.text = text.into();
        self
    }

    /// Adds another place.
    #[must_use]
    pub fn also(mut self, span: Span, text: impl Into<String>) -> Self {
        self.related.push(Label { span, text: text.into() });
        self
    }

    /// Adds a line of help.
    #[must_use]
    pub fn help(mut self, text: impl Into<String>) -> Self {
        self.help.push(text.into());
        self
    }

    /// Message, label and help as plain text for forms that show no source; the help in lines of
    /// its own.
    fn plain_text(&self) -> String {
        let mut text = self.message.clone();
        if !self.primary.text.is_empty() {
            text += &format!(": {}", self.primary.text);
        }
        self.help.iter().for_each(|help| text += &format!("\nhelp: {help}"));
        text
    }

    /// True for an error, which stops the compiler from writing anything.
    pub fn is_error(&self) -> bool {
        self.code.severity == Severity::Error
    }
}

/// A text of the user short enough to stand in a message.
pub fn shortened(text: &str) -> Cow<'_, str> {
    const LONGEST: usize = 40;
    match text.char_indices().nth(LONGEST) {
        None => Cow::Borrowed(text),
        Some(_) => Cow::Owned(text.chars().take(LONGEST - 3).chain("...".chars()).collect()),
    }
}

/// The name among `known` that is most like `name`, if one is like enough to be meant.
pub fn similar_name<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    if name.len() > 64 {
        return None;
    }
    let likeness = |other: &str| {
        strsim::normalized_damerau_levenshtein(&name.to_lowercase(), &other.to_lowercase())
    };
    known
        .into_iter()
        .filter(|other| other.len() <= 64)
        .map(|other| (likeness(other), other))
        .filter(|&(likeness, _)| likeness > 0.6)
        .max_by(|a, b| a.0.total_cmp(&b.0).then_with(|| b.1.cmp(a.1)))
        .map(|(_, other)| other)
}
