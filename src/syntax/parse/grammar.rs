//! The grammar, made into a parser by `pest`, which no other file names.

use pest::{Parser, Token};

#[derive(pest_derive::Parser)]
#[grammar = "../grammar/ladder.pest"]
struct Grammar;

/// A piece of text that a rule has read.
pub(super) type Pair<'p> = pest::iterators::Pair<'p, Rule>;
/// Pieces in text order.
pub(super) type Pairs<'p> = pest::iterators::Pairs<'p, Rule>;

/// How a text reads by a rule.
pub(super) enum Reading<'p> {
    /// As the rule says.
    Whole(Pair<'p>),
    /// Something was wanted at this place and is not there.
    Wanted(Rule, usize),
    /// The parser stopped before it ran out of stack.
    OutOfStack,
}

/// Reads a text by the rule of its item.
pub(super) fn read(rule: Rule, text: &str) -> Reading<'_> {
    let Ok(mut pairs) = Grammar::parse(rule, text) else {
        // The rules of items match every text, so nothing else can go wrong.
        return Reading::OutOfStack;
    };
    let wanted = pairs.clone().tokens().find_map(|token| match token {
        Token::Start { rule, pos } if is_wanted(rule) => Some((rule, pos.pos())),
        _ => None,
    });
    match (wanted, pairs.next()) {
        (Some((rule, at)), _) => Reading::Wanted(rule, at),
        (None, Some(pair)) => Reading::Whole(pair),
        (None, None) => Reading::OutOfStack,
    }
}

/// True for the empty rules that stand where something is missing: they come last in the grammar.
fn is_wanted(rule: Rule) -> bool {
    rule as usize >= Rule::want_address as usize
}

/// Start and end of a pair in the text that was read.
pub(super) fn range(pair: &Pair<'_>) -> (usize, usize) {
    let span = pair.as_span();
    (span.start(), span.end())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wanted_rules_are_those_with_the_prefix() {
        for &rule in Rule::all_rules() {
            assert_eq!(format!("{rule:?}").starts_with("want_"), is_wanted(rule), "{rule:?}");
        }
    }
}
