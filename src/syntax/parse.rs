//! Source text to syntax tree.

mod expression;
mod grammar;
mod items;
mod literal;
mod meant;
mod network;
#[cfg(test)]
mod shape;
mod statements;
mod wanted;

use std::borrow::Cow;
use std::collections::HashSet;
use std::thread;

use super::arrays::Arrays;
use super::ast::{File, Item, Name, Reserved};
use super::fault::{Fault, first_token, found, is_reserved_name, reserved_name};
use super::split::{Chunk, Keyword, Split, split, starts_mid_line};
use crate::diagnostic::{Diagnostic, code};
use crate::source::{Source, Span};
use grammar::{Pair, Rule};

/// Less text than this is parsed on one core.
const WORTH_A_THREAD: usize = 128 << 10;

/// Parses a whole source. The tree holds every item without a mistake; each item with one has a
/// diagnostic instead. Diagnostics are in the order of their places.
pub fn parse(source: &Source) -> (File<'_>, Vec<Diagnostic>) {
    let text = source.text();
    let Split { mut chunks, comments, mut diagnostics } = split(text);
    let mut outcomes: Vec<Outcome<'_>> = chunks
        .iter_mut()
        .map(|chunk| chunk.fault.take().map_or(Outcome::Pending, Outcome::Fault))
        .collect();

    let arrays = Arrays::default();
    let context = Context { text, comments: &comments, chunks: &chunks, arrays };
    context.parse_all(&mut outcomes, Keyword::declares);
    let arrays = declared_arrays(text, &chunks, &outcomes);
    let context = Context { arrays, ..context };
    context.parse_all(&mut outcomes, |_| true);

    let (items, broken) = settle(text, &chunks, outcomes, &mut diagnostics);
    diagnostics.sort_by_key(|diagnostic| diagnostic.primary.span);
    // Of a name that needs back-ticks one finding is enough.
    let mut names = HashSet::new();
    diagnostics.retain(|found| {
        let is_name = found.primary.text == expression::NOT_ASCII || is_reserved_name(found);
        !is_name || found.help.first().is_none_or(|name| names.insert(name.clone()))
    });
    (File { items, comments, broken }, diagnostics)
}

/// What became of an item.
enum Outcome<'s> {
    Pending,
    Item(Item<'s>),
    Fault(Box<Fault>),
}

fn declared_arrays<'s>(text: &'s str, chunks: &[Chunk], outcomes: &[Outcome<'s>]) -> Arrays<'s> {
    let mut arrays = Arrays::default();
    for (chunk, outcome) in chunks.iter().zip(outcomes) {
        match outcome {
            Outcome::Item(item) => arrays.declare(item),
            Outcome::Fault(_) if chunk.keyword.declares() => {
                arrays.guess(&text[chunk.body.range()])
            }
            _ => {}
        }
    }
    arrays
}

/// What is known while items are parsed.
struct Context<'c, 's> {
    text: &'s str,
    comments: &'c [Span],
    chunks: &'c [Chunk],
    arrays: Arrays<'s>,
}

impl<'s> Context<'_, 's> {
    /// Parses all pending items that are `wanted`, on all cores if there is much to do.
    fn parse_all(&self, outcomes: &mut [Outcome<'s>], wanted: fn(Keyword) -> bool) {
        let cores = thread::available_parallelism().map_or(1, usize::from);
        let workers = cores.min(self.text.len() / WORTH_A_THREAD).max(1);
        let share = self.text.len().div_ceil(workers).max(1);
        thread::scope(|scope| {
            let (mut chunks, mut outcomes) = (self.chunks, outcomes);
            for worker in 1..=workers {
                let end =
                    chunks.partition_point(|chunk| (chunk.word.end as usize) < worker * share);
                let end = if worker == workers { chunks.len() } else { end };
                let (mine, rest) = chunks.split_at(end);
                let (results, other_results) = outcomes.split_at_mut(end);
                (chunks, outcomes) = (rest, other_results);
                let mut work = move || self.parse_some(mine, results, wanted);
                if worker == workers {
                    work();
                } else {
                    scope.spawn(work);
                }
            }
        });
    }

    fn parse_some(
        &self,
        chunks: &[Chunk],
        outcomes: &mut [Outcome<'s>],
        wanted: fn(Keyword) -> bool,
    ) {
        for (chunk, outcome) in chunks.iter().zip(outcomes) {
            if wanted(chunk.keyword) && matches!(outcome, Outcome::Pending) {
                *outcome = self.parse_one(chunk);
            }
        }
    }

    fn parse_one(&self, chunk: &Chunk) -> Outcome<'s> {
        let body = self.without_comments(chunk);
        let body = if chunk.keyword.declares() { body } else { self.arrays.mark(body) };
        let lower = Lower { text: self.text, base: chunk.body.start as usize, word: chunk.word };
        let parsed = match chunk.keyword {
            Keyword::Nothing => match body.trim_ascii() {
                "" => return Outcome::Pending,
                _ => Err(Box::new(lower.outside_item(&body).into())),
            },
            Keyword::Later => {
                let word = Name { text: &self.text[chunk.word.range()], span: chunk.word };
                let end = chunk.body.start as usize + body.trim_ascii_end().len();
                let span = chunk.word.to(Span::new(end, end));
                Ok(Item::Reserved(Reserved { word, span }))
            }
            _ => lower.item(chunk.keyword, &body),
        };
        match parsed {
            Ok(item) => Outcome::Item(item),
            Err(mut fault) => {
                let at = fault.diagnostic.primary.span.start as usize - lower.base;
                let is_blank = |text: &str| text.trim_ascii().is_empty();
                // The place of an address is where it begins, not where it goes wrong.
                let is_address = fault.diagnostic.primary.text == meant::AN_ADDRESS;
                fault.at_start = is_blank(&body[..at]) && !is_address;
                fault.at_end = is_blank(&body[at..]);
                if fault.at_end {
                    self.name_what_follows(chunk, &mut fault.diagnostic);
                }
                Outcome::Fault(fault)
            }
        }
    }

    /// The text of an item with every comment blanked, so that the places stay.
    fn without_comments(&self, chunk: &Chunk) -> Cow<'s, str> {
        let body = &self.text[chunk.body.range()];
        if chunk.comments.is_empty() {
            return Cow::Borrowed(body);
        }
        let mut blanked = String::with_capacity(body.len());
        for comment in &self.comments[chunk.comments.clone()] {
            let start = comment.start as usize;
            blanked.push_str(&self.text[chunk.body.start as usize + blanked.len()..start]);
            blanked.extend(std::iter::repeat_n(' ', comment.range().len()));
        }
        blanked.push_str(&body[blanked.len()..]);
        Cow::Owned(blanked)
    }

    /// An item that ends too early: what was found is the next item, or nothing.
    fn name_what_follows(&self, chunk: &Chunk, diagnostic: &mut Diagnostic) {
        let next = chunk.body.end as usize;
        let end = if next < self.text.len() {
            Span::new(next, next + first_token(&self.text[next..]).len())
        } else {
            let end = self.text.trim_ascii_end().len();
            Span::new(end, end)
        };
        diagnostic.primary.span = end;
        let what = found(&self.text[end.range()]);
        if let Some(at) = diagnostic.message.rfind(wanted::FOUND) {
            diagnostic.message.truncate(at + wanted::FOUND.len());
            diagnostic.message.push_str(&what);
        }
    }
}

/// Puts the items in order and the mistakes in words; also tells the places of what is no item.
/// Where an item breaks off and the word that
/// starts the next one makes no sense there, that word was meant as a name: one mistake, not two.
fn settle<'s>(
    text: &'s str,
    chunks: &[Chunk],
    outcomes: Vec<Outcome<'s>>,
    diagnostics: &mut Vec<Diagnostic>,
) -> (Vec<Item<'s>>, Vec<Span>) {
    let (mut items, mut broken) = (Vec::with_capacity(outcomes.len()), Vec::new());
    let mut before = Before::Sound;
    for (chunk, outcome) in chunks.iter().zip(outcomes) {
        let word = &text[chunk.word.range()];
        let is_misused = |fault: Option<&Fault>| {
            let at_start = fault.is_some_and(|fault| fault.at_start);
            let is_wrong = fault.is_some() || chunk.keyword == Keyword::Later;
            match before {
                Before::Sound => false,
                Before::Faulty => at_start && starts_mid_line(text, chunk.word),
                Before::LeftOpen => at_start,
                Before::WantsMore => at_start || is_wrong && starts_mid_line(text, chunk.word),
            }
        };
        let (misused, fault) = match outcome {
            Outcome::Pending => continue,
            Outcome::Item(item) => {
                let misused = is_misused(None);
                if !misused {
                    items.push(item);
                }
                (misused, None)
            }
            Outcome::Fault(fault) => (is_misused(Some(&fault)), Some(*fault)),
        };
        if misused || fault.is_some() {
            broken.push(chunk.word.to(chunk.body));
        }
        let after = fault.as_ref().map_or(Before::Sound, Before::after);
        if misused {
            if matches!(before, Before::LeftOpen | Before::WantsMore) {
                diagnostics.pop();
            }
            diagnostics.push(reserved_name(word, chunk.word));
        } else if let Some(Fault { diagnostic, at_start, .. }) = fault {
            let help = format!("`{word}` starts an item; as a name it stands in back-ticks");
            let mid_line = at_start && starts_mid_line(text, chunk.word);
            diagnostics.push(if mid_line { diagnostic.help(help) } else { diagnostic });
        }
        before = after;
    }
    (items, broken)
}

/// How the item before ended.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Before {
    Sound,
    /// It has a mistake inside.
    Faulty,
    /// It ends with a bracket open.
    LeftOpen,
    /// It ends where a name or something else should follow.
    WantsMore,
}

impl Before {
    fn after(fault: &Fault) -> Before {
        match fault.at_end {
            false => Before::Faulty,
            true if fault.diagnostic.code == code::UNCLOSED => Before::LeftOpen,
            true => Before::WantsMore,
        }
    }
}

/// A mistake ends the parsing of its item. The box keeps the common case small.
type Parsed<T> = Result<T, Box<Fault>>;

/// Turns the pairs of one item into its tree.
#[derive(Clone, Copy)]
struct Lower<'s> {
    text: &'s str,
    /// Where the item's body starts in the text.
    base: usize,
    /// The word that starts the item.
    word: Span,
}

impl<'s> Lower<'s> {
    fn item(&self, keyword: Keyword, body: &str) -> Parsed<Item<'s>> {
        let rule = match keyword {
            Keyword::Rung => Rule::rung_item,
            Keyword::Test => Rule::test_item,
            Keyword::Const => Rule::constant_item,
            Keyword::Ladder => Rule::header_item,
            Keyword::Clock => Rule::clock_item,
            Keyword::Tick => Rule::tick_item,
            _ => Rule::variables_item,
        };
        let pair = match grammar::read(rule, body) {
            grammar::Reading::Whole(pair) => pair,
            grammar::Reading::Wanted(rule, at) => {
                return Err(Box::new(self.wanted(rule, at, body).into()));
            }
            grammar::Reading::OutOfStack => {
                let message = "this item is too deep for the stack of the compiler";
                let diagnostic = Diagnostic::new(code::TOO_DEEP, self.word, message);
                return Err(Box::new(diagnostic.into()));
            }
        };
        match keyword {
            Keyword::Rung => self.rung(pair),
            Keyword::Test => self.test(pair),
            Keyword::Const => self.constant(pair),
            Keyword::Ladder => self.header(pair),
            Keyword::Clock => Ok(Item::Clock(self.quantity(pair))),
            Keyword::Tick => Ok(Item::Tick(self.quantity(pair))),
            _ => self.variables(keyword, pair),
        }
    }

    /// The place of a pair in the source.
    fn span(&self, pair: &Pair<'_>) -> Span {
        let (start, end) = grammar::range(pair);
        Span::new(self.base + start, self.base + end)
    }

    fn fault<T>(&self, diagnostic: Diagnostic) -> Parsed<T> {
        Err(Box::new(diagnostic.into()))
    }
}

#[cfg(test)]
#[path = "parse_tests.rs"]
mod tests;

#[cfg(test)]
#[path = "parse_strain_tests.rs"]
mod strain_tests;
