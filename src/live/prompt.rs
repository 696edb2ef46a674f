//! A line in which a person types something.

use super::Key;
use crate::model::VariableId;

/// The most characters that somebody may type.
const LONGEST: usize = 40;

/// What is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Question {
    /// A value for this input.
    Value(VariableId),
    /// A rung.
    Rung,
}

/// A question and what has been typed so far.
pub(super) struct Prompt {
    pub question: Question,
    pub text: String,
    /// Why the answer that was given does not do.
    pub problem: Option<String>,
}

/// What became of a prompt.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Typed {
    /// Nothing yet.
    More,
    /// The text is the answer.
    Answer,
    /// There is to be no answer.
    Never,
}

impl Prompt {
    pub fn new(question: Question) -> Prompt {
        Prompt { question, text: String::new(), problem: None }
    }

    pub fn key(&mut self, key: Key) -> Typed {
        match key {
            Key::Enter => return Typed::Answer,
            Key::Escape => return Typed::Never,
            Key::Backspace => drop(self.text.pop()),
            Key::Char(c) if self.text.chars().count() < LONGEST => self.text.push(c),
            _ => return Typed::More,
        }
        self.problem = None;
        Typed::More
    }
}
