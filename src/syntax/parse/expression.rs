//! Names, references and expressions.

use super::grammar::{Pair, Pairs, Rule};
use super::items::next;
use super::{Lower, Parsed};
use crate::diagnostic::{Diagnostic, code, shortened};
use crate::source::Span;
use crate::syntax::MAX_NESTING;
use crate::syntax::ast::{
    Accessor, BinaryOperator, Expr, ExprKind, Literal, LiteralKind, Name, Reference, UnaryOperator,
};
use crate::syntax::fault::{found, is_reserved, reserved_name};

/// The label of a name with a letter that only a quoted name can have.
pub(super) const NOT_ASCII: &str = "not one of a-z, A-Z, 0-9, _";

/// A chain of more equal operators than this becomes a balanced tree, which no chain makes deep.
const LONG_CHAIN: usize = 16;

/// How many expressions stand inside each other. It is counted while the tree grows, because
/// `a + b + c + ...` is deep without a single bracket.
type Depth = usize;

impl<'s> Lower<'s> {
    /// A name, checked.
    pub(super) fn name(&self, pair: &Pair<'_>) -> Parsed<Name<'s>> {
        self.name_at(self.span(pair))
    }

    /// The name at a place: in back-ticks anything, else ASCII and not reserved.
    pub(super) fn name_at(&self, span: Span) -> Parsed<Name<'s>> {
        let text = &self.text[span.range()];
        if let Some(quoted) = text.strip_prefix('`') {
            let text = quoted.strip_suffix('`').unwrap_or(quoted);
            if !text.is_empty() {
                return Ok(Name { text, span });
            }
            let diagnostic = Diagnostic::new(code::SYNTAX, span, "a quoted name is empty")
                .label("nothing stands between the back-ticks")
                .help("write the name between them: `` `I:0/3` ``");
            return self.fault(diagnostic);
        }
        if is_reserved(text) {
            return self.fault(reserved_name(text, span));
        }
        if let Some((at, character)) = text.char_indices().find(|(_, c)| !c.is_ascii()) {
            let start = span.start as usize + at;
            let span = Span::new(start, start + character.len_utf8());
            let character = found(&character.to_string());
            let message = format!("{character} can stand in a name in back-ticks only");
            let diagnostic = Diagnostic::new(code::SYNTAX, span, message)
                .label(NOT_ASCII)
                .help(format!("write `` `{}` ``", shortened(text)));
            return self.fault(diagnostic);
        }
        Ok(Name { text, span })
    }

    /// A name with members, bits and indexes, and how deep it is.
    pub(super) fn reference(&self, pair: Pair<'_>) -> Parsed<(Reference<'s>, Depth)> {
        let span = self.span(&pair);
        self.reference_in(span, pair.into_inner())
    }

    /// A reference that covers a span and has these parts after its bare name.
    pub(super) fn reference_in(
        &self,
        span: Span,
        mut parts: Pairs<'_>,
    ) -> Parsed<(Reference<'s>, Depth)> {
        let mut name = span;
        let mut first = parts.next();
        if let Some(part) = &first {
            let part_span = self.span(part);
            match part.as_rule() {
                Rule::quoted => {
                    name = part_span;
                    first = parts.next();
                }
                // Before an index stands its bracket, which is its own; before others the point.
                Rule::index => name.end = part_span.start,
                _ => name.end = part_span.start - 1,
            }
        }
        let name = match &self.text[name.range()] {
            // Reserved so that nothing is declared so, but harmless where no bracket follows.
            text @ ("rise" | "fall") => Name { text, span: name },
            _ => self.name_at(name)?,
        };
        let mut path = Vec::new();
        let mut depth = 0;
        for part in first.into_iter().chain(parts) {
            let (accessor, inner) = self.accessor(part)?;
            path.push(accessor);
            depth = depth.max(inner);
        }
        Ok((Reference { name, path }, depth))
    }

    fn accessor(&self, pair: Pair<'_>) -> Parsed<(Accessor<'s>, Depth)> {
        Ok(match pair.as_rule() {
            Rule::bit => (Accessor::Bit(self.integer(&pair, "a bit's number")?), 0),
            Rule::index => {
                let span = self.span(&pair);
                let (index, depth) = self.expression_depth(next(&mut pair.into_inner()))?;
                let depth = self.deeper(depth, index.span)?;
                (Accessor::Index(Box::new(index), span), depth)
            }
            _ => (Accessor::Member(self.name(&pair)?), 0),
        })
    }

    /// An expression.
    pub(super) fn expression(&self, pair: Pair<'_>) -> Parsed<Expr<'s>> {
        Ok(self.expression_depth(pair)?.0)
    }

    /// The expressions in a pair of brackets.
    pub(super) fn expressions(&self, pair: Pair<'_>) -> Parsed<Vec<Expr<'s>>> {
        pair.into_inner().map(|part| self.expression(part)).collect()
    }

    /// Builds the tree from operators and operands in text order: operators wait until one comes
    /// that binds less tightly.
    fn expression_depth(&self, pair: Pair<'_>) -> Parsed<(Expr<'s>, Depth)> {
        let mut parts = pair.into_inner();
        let mut operands = Vec::new();
        let mut waiting: Vec<(Operator, Span)> = Vec::new();
        while let Some(part) = parts.next() {
            let span = self.span(&part);
            match part.as_rule() {
                Rule::prefix => waiting.push((Operator::prefix(part.as_str()), span)),
                Rule::operator => {
                    let operator = Operator::infix(part.as_str());
                    while let Some(&(other, _)) = waiting.last()
                        && other.binding() >= operator.binding()
                        && !other.chains_with(operator)
                    {
                        self.apply_last(&mut waiting, &mut operands)?;
                    }
                    waiting.push((operator, span));
                }
                _ => {
                    let operand = self.operand(part, &mut parts)?;
                    operands.push(operand);
                }
            }
        }
        while !waiting.is_empty() {
            self.apply_last(&mut waiting, &mut operands)?;
        }
        Ok(pop(&mut operands))
    }

    /// Applies the last operator that waits, and with it all of the chain that it ends.
    fn apply_last(
        &self,
        waiting: &mut Vec<(Operator, Span)>,
        operands: &mut Vec<(Expr<'s>, Depth)>,
    ) -> Parsed<()> {
        let Some(&(last, _)) = waiting.last() else { return Ok(()) };
        let same = waiting.iter().rev().take_while(|(other, _)| other.chains_with(last)).count();
        if same <= 1 {
            return waiting.pop().map_or(Ok(()), |(last, at)| self.apply(last, at, operands));
        }
        let chain = waiting.split_off(waiting.len() - same);
        if chain.len() > LONG_CHAIN {
            let parts = operands.split_off(operands.len() - chain.len() - 1);
            let balanced = self.balanced(&chain, &mut parts.into_iter())?;
            operands.push(balanced);
            return Ok(());
        }
        // From left to right: the first operator takes the first two operands.
        let mut later = operands.split_off(operands.len() - (chain.len() - 1));
        later.reverse();
        for (operator, at) in chain {
            self.apply(operator, at, operands)?;
            operands.extend(later.pop());
        }
        Ok(())
    }

    /// A chain of one associative operator as a tree of little depth. It takes one operand more
    /// than there are operators.
    fn balanced(
        &self,
        chain: &[(Operator, Span)],
        parts: &mut impl Iterator<Item = (Expr<'s>, Depth)>,
    ) -> Parsed<(Expr<'s>, Depth)> {
        let Some(&(operator, at)) = chain.get(chain.len() / 2) else {
            return Ok(parts.next().expect("the grammar puts operands around every operator"));
        };
        let left = self.balanced(&chain[..chain.len() / 2], parts)?;
        let right = self.balanced(&chain[chain.len() / 2 + 1..], parts)?;
        let mut operands = vec![left, right];
        self.apply(operator, at, &mut operands)?;
        Ok(pop(&mut operands))
    }

    fn operand(&self, pair: Pair<'_>, rest: &mut Pairs<'_>) -> Parsed<(Expr<'s>, Depth)> {
        let span = self.span(&pair);
        match pair.as_rule() {
            Rule::number => {
                let kind = ExprKind::Literal(self.literal(&pair)?);
                Ok((Expr { kind, span }, 0))
            }
            Rule::group => {
                let (mut inner, depth) = self.expression_depth(next(&mut pair.into_inner()))?;
                inner.span = span;
                Ok((inner, depth))
            }
            _ => match rest.peek() {
                Some(arguments) if arguments.as_rule() == Rule::arguments => {
                    rest.next();
                    self.function(&pair, arguments)
                }
                _ => self.word(pair, span),
            },
        }
    }

    /// `TRUE`, `FALSE` or a reference.
    fn word(&self, pair: Pair<'_>, span: Span) -> Parsed<(Expr<'s>, Depth)> {
        let text = &self.text[span.range()];
        if matches!(text, "TRUE" | "FALSE") {
            let literal = Literal { kind: LiteralKind::Bool, text, span };
            return Ok((Expr { kind: ExprKind::Literal(literal), span }, 0));
        }
        if matches!(text, "first_scan" | "rising" | "falling" | "not") {
            return self.element_as_value(text, span);
        }
        let (reference, depth) = self.reference(pair)?;
        Ok((Expr { kind: ExprKind::Reference(reference), span }, depth))
    }

    fn element_as_value<T>(&self, text: &str, span: Span) -> Parsed<T> {
        let message = format!("`{text}` is an element of a rung and no value");
        let diagnostic = Diagnostic::new(code::SYNTAX, span, message)
            .label("in an expression")
            .help("write it outside the braces, or give it a coil and read that");
        self.fault(diagnostic)
    }

    fn function(&self, name: &Pair<'_>, arguments: Pair<'_>) -> Parsed<(Expr<'s>, Depth)> {
        // A member or an index before the bracket makes the name one that no function has.
        let name_span = self.span(name);
        if let Some(part) = name.clone().into_inner().find(|part| part.as_rule() != Rule::quoted) {
            let message = "only a function can be called in an expression";
            let diagnostic = Diagnostic::new(code::SYNTAX, self.span(&part), message)
                .label("a function has no members")
                .help("write an operator between the two");
            return self.fault(diagnostic);
        }
        let span = name_span.to(self.span(&arguments));
        if matches!(&self.text[name_span.range()], "rise" | "fall") {
            return self.element_as_value(&self.text[span.range()], span);
        }
        if &self.text[name_span.range()] == "not" {
            let message = "expected a variable, a number or `(`, found `not`";
            let diagnostic =
                Diagnostic::new(code::SYNTAX, name_span, message).label("not expected here");
            return self.fault(diagnostic.help("operators have capital letters: `NOT a`"));
        }
        let name = self.name_at(name_span)?;
        let mut depth = 0;
        let mut values = Vec::new();
        for argument in arguments.into_inner() {
            let (value, inner) = self.expression_depth(argument)?;
            values.push(value);
            depth = depth.max(inner);
        }
        let depth = self.deeper(depth, span)?;
        Ok((Expr { kind: ExprKind::Function(name, values), span }, depth))
    }

    fn apply(
        &self,
        operator: Operator,
        at: Span,
        operands: &mut Vec<(Expr<'s>, Depth)>,
    ) -> Parsed<()> {
        let (right, right_depth) = pop(operands);
        let (kind, span, depth) = match operator {
            Operator::Unary(operator) => {
                let span = at.to(right.span);
                (ExprKind::Unary(operator, Box::new(right)), span, right_depth)
            }
            Operator::Binary(operator) => {
                let (left, left_depth) = pop(operands);
                let span = left.span.to(right.span);
                let kind = ExprKind::Binary(operator, Box::new(left), Box::new(right));
                (kind, span, left_depth.max(right_depth))
            }
        };
        let depth = self.deeper(depth, at)?;
        operands.push((Expr { kind, span }, depth));
        Ok(())
    }

    fn deeper(&self, depth: Depth, span: Span) -> Parsed<Depth> {
        if depth < MAX_NESTING {
            return Ok(depth + 1);
        }
        let message = format!(
            "an expression may have at most {MAX_NESTING} operators in a row or inside each other"
        );
        let diagnostic = Diagnostic::new(code::TOO_DEEP, span, message)
            .label("too many operators before this one")
            .help("split it: assign a part of it to a variable first");
        self.fault(diagnostic)
    }
}

fn pop<'s>(operands: &mut Vec<(Expr<'s>, Depth)>) -> (Expr<'s>, Depth) {
    operands.pop().expect("the grammar puts operands around every operator")
}

#[derive(Clone, Copy)]
enum Operator {
    Unary(UnaryOperator),
    Binary(BinaryOperator),
}

impl Operator {
    fn prefix(text: &str) -> Operator {
        Operator::Unary(match text {
            "-" => UnaryOperator::Negate,
            _ => UnaryOperator::Not,
        })
    }

    fn infix(text: &str) -> Operator {
        Operator::Binary(match text {
            "+" => BinaryOperator::Add,
            "-" => BinaryOperator::Subtract,
            "*" => BinaryOperator::Multiply,
            "/" => BinaryOperator::Divide,
            "MOD" => BinaryOperator::Modulo,
            "=" => BinaryOperator::Equal,
            "<>" => BinaryOperator::NotEqual,
            "<" => BinaryOperator::Less,
            "<=" => BinaryOperator::LessOrEqual,
            ">" => BinaryOperator::Greater,
            ">=" => BinaryOperator::GreaterOrEqual,
            "AND" => BinaryOperator::And,
            "XOR" => BinaryOperator::Xor,
            _ => BinaryOperator::Or,
        })
    }

    /// True if both are one operator for which the order of evaluation does not matter.
    fn chains_with(self, other: Operator) -> bool {
        use BinaryOperator::{Add, And, Or, Xor};
        match (self, other) {
            (Operator::Binary(one), Operator::Binary(other)) => {
                one == other && matches!(one, Add | And | Or | Xor)
            }
            _ => false,
        }
    }

    /// How tightly it binds: one operand binds tightest.
    fn binding(self) -> u8 {
        match self {
            Operator::Unary(_) => 8,
            Operator::Binary(operator) => operator.binding(),
        }
    }
}
