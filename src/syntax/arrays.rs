//! Tells an index from a list of branches.
//!
//! `w[2]` is an element if `w` is declared as an array, and a contact with a list after it if not.
//! No grammar can know that, so the brackets of indexes are marked before it reads the text.

use std::borrow::Cow;
use std::collections::HashSet;

use super::ast::{Item, Name};
use crate::source::Span;

/// Stands for `[` and directly follows the name; blanks that came between move behind it.
const OPEN: u8 = 1;
/// Stands for `]`.
const CLOSE: u8 = 2;

/// The names that are declared as arrays.
#[derive(Debug, Default)]
pub(super) struct Arrays<'s>(HashSet<&'s str>);

impl<'s> Arrays<'s> {
    /// Takes the names of a declaration, if they are arrays.
    pub(super) fn declare(&mut self, item: &Item<'s>) {
        if let Item::Variables(variables) = item
            && variables.ty.as_ref().is_some_and(|ty| ty.length.is_some())
        {
            let names = variables.names.iter().map(|declarator| declarator.name);
            self.0.extend(names.map(|Name { text, .. }| text));
        }
    }

    /// Takes every word of a declaration that has a mistake and a bracket: were its names taken
    /// for no arrays, one mistake would draw another wherever they are read.
    pub(super) fn guess(&mut self, declaration: &'s str) {
        if declaration.contains('[') {
            let words = declaration.split(|c: char| c != '_' && !c.is_alphanumeric());
            self.0.extend(words.filter(|word| !word.is_empty()));
        }
    }

    /// The text with the brackets of indexes marked; no byte moves.
    pub(super) fn mark<'t>(&self, text: Cow<'t, str>) -> Cow<'t, str> {
        if self.0.is_empty() || !text.contains('[') {
            return text;
        }
        let marks = self.indexes(&text);
        if marks.is_empty() {
            return text;
        }
        let mut bytes = text.into_owned().into_bytes();
        for Mark { name_end, open, close } in marks {
            bytes[open] = b' ';
            bytes[name_end] = OPEN;
            bytes[close] = CLOSE;
        }
        Cow::Owned(String::from_utf8(bytes).expect("ASCII replaces ASCII"))
    }

    fn indexes(&self, text: &str) -> Vec<Mark> {
        let mut marks = Vec::new();
        let mut open_brackets = Vec::new();
        let mut array = None;
        for token in tokens(text) {
            let (start, end) = (token.start as usize, token.end as usize);
            match text.as_bytes()[start] {
                b'[' => open_brackets.push(array.take().map(|name_end| (name_end, start))),
                b']' => {
                    if let Some(Some((name_end, open))) = open_brackets.pop() {
                        marks.push(Mark { name_end, open, close: start });
                    }
                    array = None;
                }
                // A member of a block is no variable, even if it bears the name of one.
                _ if text[..start].ends_with('.') => array = None,
                b'`' => array = self.0.contains(&text[start + 1..end - 1]).then_some(end),
                _ => array = self.0.contains(&text[start..end]).then_some(end),
            }
        }
        marks
    }
}

struct Mark {
    name_end: usize,
    open: usize,
    close: usize,
}

/// Words, strings, quoted names, and every other character but white space alone. Strings and
/// quoted names are closed when this is called.
fn tokens(text: &str) -> impl Iterator<Item = Span> {
    let mut at = 0;
    std::iter::from_fn(move || {
        at += text[at..].len() - text[at..].trim_ascii_start().len();
        let rest = &text[at..];
        let first = rest.chars().next()?;
        let length = match first {
            '"' | '`' => rest[1..].find(first).map_or(rest.len(), |length| length + 2),
            _ => rest.find(|c: char| c != '_' && !c.is_alphanumeric()).unwrap_or(rest.len()),
        };
        let start = at;
        at += length.max(first.len_utf8());
        Some(Span::new(start, at))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn marked(arrays: &[&'static str], text: &str) -> String {
        let text = Arrays(arrays.iter().copied().collect()).mark(Cow::Borrowed(text)).into_owned();
        text.replace('\u{1}', "<").replace('\u{2}', ">")
    }

    #[test]
    fn only_brackets_after_an_array_are_marked() {
        assert_eq!(marked(&["w"], "w[1] x[ a | w [i] ]"), "w<1> x[ a | w< i> ]");
        assert_eq!(marked(&["w", "v"], "w[v[1]]"), "w<v<1>>");
        assert_eq!(marked(&["a b"], "`a b`[1] a[1] b[1]"), "`a b`<1> a[1] b[1]");
    }

    #[test]
    fn members_and_strings_are_no_arrays() {
        assert_eq!(marked(&["w"], "t.w[ a ]"), "t.w[ a ]");
        assert_eq!(marked(&["w"], "\"w[1] é\" ww[1] w_[1]"), "\"w[1] é\" ww[1] w_[1]");
        assert_eq!(marked(&["w"], "w ( y ) [ a ]"), "w ( y ) [ a ]");
    }
}
