//! Networks: what stands between the rails.

use super::grammar::{Pair, Rule};
use super::items::next;
use super::{Lower, Parsed};
use crate::diagnostic::{Diagnostic, code, shortened};
use crate::source::Span;
use crate::syntax::ast::{
    Argument, ArgumentValue, Call, CoilAction, Connection, Edge, Element, ElementKind, ExprKind,
    Net, Reference, Series,
};

impl<'s> Lower<'s> {
    /// Elements from left to right. The pair takes in the white space before and after them.
    pub(super) fn series(&self, pair: Pair<'_>) -> Parsed<Series<'s>> {
        let start = self.span(&pair).start;
        let parts = pair.into_inner();
        let mut elements: Vec<Element<'s>> = Vec::with_capacity(parts.len());
        for part in parts {
            if part.as_rule() == Rule::call {
                let call = self.call(elements.pop(), part)?;
                elements.push(call);
            } else {
                elements.push(self.element(part)?);
            }
        }
        let span = match elements.as_slice() {
            [] => Span { start, end: start },
            [first, .., last] => first.span.to(last.span),
            [only] => only.span,
        };
        Ok(Series { elements, span })
    }

    fn element(&self, pair: Pair<'_>) -> Parsed<Element<'s>> {
        let span = self.span(&pair);
        let kind = match pair.as_rule() {
            Rule::contact => self.contact(span, pair)?,
            Rule::list => {
                let parts = pair.into_inner();
                let mut branches = Vec::with_capacity(parts.len());
                for part in parts {
                    branches.push(self.series(part)?);
                }
                ElementKind::Parallel(branches)
            }
            Rule::coil => self.coil(pair)?,
            Rule::edge => {
                let text = pair.as_str();
                if text.starts_with(['!', '/']) {
                    return self.negated_edge(span);
                }
                let edge = if text.starts_with('r') { Edge::Rise } else { Edge::Fall };
                let operand = next(&mut pair.into_inner());
                self.may_have_an_edge(&operand)?;
                ElementKind::Edge { edge, operand: self.reference(operand)?.0 }
            }
            Rule::braces => self.braces(pair)?,
            Rule::constant => ElementKind::Constant(pair.as_str() == "1"),
            _ => ElementKind::Net(Box::new(self.net(pair)?)),
        };
        Ok(Element { kind, span })
    }

    /// A contact, or one of the words that are elements.
    fn contact(&self, span: Span, pair: Pair<'_>) -> Parsed<ElementKind<'s>> {
        // In what the grammar has read, comments are blank.
        let text = pair.as_str();
        let word = text.trim_start_matches(['!', '/', ' ', '\n', '\t', '\r']);
        let negated = word.len() < text.len();
        let start = span.end - word.len() as u32;
        let kind = match word {
            "TRUE" => ElementKind::Constant(true),
            "FALSE" => ElementKind::Constant(false),
            "first_scan" => return Ok(ElementKind::FirstScan { negated }),
            "rising" => ElementKind::OneShot(Edge::Rise),
            "falling" => ElementKind::OneShot(Edge::Fall),
            "not" => ElementKind::Invert,
            _ => {
                let span = Span { start, ..span };
                let (operand, _) = self.reference_in(span, pair.into_inner())?;
                return Ok(ElementKind::Contact { operand, negated });
            }
        };
        if !negated {
            return Ok(kind);
        }
        let message = format!("`{word}` cannot be negated");
        let diagnostic = Diagnostic::new(code::SYNTAX, span, message)
            .label("`!` stands before a contact or `first_scan` only")
            .help("the element `not` inverts the power that reaches it");
        self.fault(diagnostic)
    }

    /// Words that are elements look like variables, and are none.
    fn may_have_an_edge(&self, operand: &Pair<'_>) -> Parsed<()> {
        let span = self.span(operand);
        let (what, help) = match &self.text[span.range()] {
            word @ ("TRUE" | "FALSE") => (word, "use a variable, or first_scan for the first scan"),
            word @ "first_scan" => (word, "it is on in one scan only: write it without an edge"),
            word @ ("rising" | "falling" | "not") => {
                (word, "for an edge of the power write `rising` or `falling` alone")
            }
            _ => return Ok(()),
        };
        let message = format!("an edge looks at a variable, `{what}` is none");
        let diagnostic = Diagnostic::new(code::SYNTAX, span, message).label("not a variable");
        self.fault(diagnostic.help(help))
    }

    fn negated_edge<T>(&self, span: Span) -> Parsed<T> {
        let text = self.text[span.range()].trim_start_matches(['!', '/']).trim_ascii();
        let diagnostic = Diagnostic::new(code::SYNTAX, span, "an edge contact cannot be negated")
            .label("`!` stands before a contact or `first_scan` only")
            .help(format!(
                "write `{} not`, which inverts the power that the edge lets pass",
                shortened(text)
            ));
        self.fault(diagnostic)
    }

    fn coil(&self, pair: Pair<'_>) -> Parsed<ElementKind<'s>> {
        let mut parts = pair.into_inner();
        let mut target = next(&mut parts);
        let mut action = CoilAction::Plain;
        if target.as_rule() == Rule::coil_action {
            action = match target.as_str().trim_ascii_end() {
                "S" => CoilAction::Set,
                "R" => CoilAction::Reset,
                "rise" => CoilAction::Rise,
                "fall" => CoilAction::Fall,
                _ => CoilAction::Negated,
            };
            target = next(&mut parts);
        }
        let (target, _) = self.reference(target)?;
        Ok(ElementKind::Coil { action, target })
    }

    /// A comparison or an assignment.
    fn braces(&self, pair: Pair<'_>) -> Parsed<ElementKind<'s>> {
        let mut parts = pair.into_inner();
        let left = self.expression(next(&mut parts))?;
        let Some(value) = parts.next() else {
            return Ok(ElementKind::Compare(Box::new(left)));
        };
        let value = Box::new(self.expression(value)?);
        let ExprKind::Reference(target) = left.kind else {
            let diagnostic =
                Diagnostic::new(code::SYNTAX, left.span, "only a variable is assigned")
                    .label("this is no variable")
                    .help("`:=` assigns, `=` compares");
            return self.fault(diagnostic);
        };
        Ok(ElementKind::Assign { target: Box::new(target), value })
    }

    /// A call, with the element before it as the name of the instance.
    fn call(&self, before: Option<Element<'s>>, pair: Pair<'_>) -> Parsed<Element<'s>> {
        let place = self.span(&pair);
        let (name, span) = match before {
            Some(Element {
                kind: ElementKind::Contact { operand: Reference { name, path }, negated: false },
                span,
            }) if path.is_empty() => (name, span.to(place)),
            _ => {
                let place = Span { end: place.start + 1, ..place };
                let message = "a block needs a plain name before `:`";
                let diagnostic = Diagnostic::new(code::SYNTAX, place, message)
                    .label("no name before this")
                    .help("name each block where it is used: `delay:TON(PT := 5s)`");
                return self.fault(diagnostic);
            }
        };
        let mut parts = pair.into_inner();
        let kind = self.name(&next(&mut parts))?;
        let arguments = parts.map(|part| self.argument(part)).collect::<Parsed<_>>()?;
        Ok(Element { kind: ElementKind::Call(Box::new(Call { name, kind, arguments })), span })
    }

    fn argument(&self, pair: Pair<'_>) -> Parsed<Argument<'s>> {
        let mut parts = pair.into_inner();
        let name = self.name(&next(&mut parts))?;
        let value = next(&mut parts);
        let value = match value.as_rule() {
            Rule::constants => {
                let span = self.span(&value);
                ArgumentValue::List(self.expressions(value)?, span)
            }
            Rule::expression => ArgumentValue::Expr(self.expression(value)?),
            _ => ArgumentValue::Network(self.series(value)?),
        };
        Ok(Argument { name, value })
    }

    fn net(&self, pair: Pair<'_>) -> Parsed<Net<'s>> {
        let connections = pair.into_inner().map(|part| {
            let mut parts = part.into_inner();
            let from = self.name(&next(&mut parts))?;
            let both_ways = next(&mut parts).as_str() == "<->";
            let to = self.name(&next(&mut parts))?;
            let network = self.series(next(&mut parts))?;
            Ok(Connection { from, to, both_ways, network })
        });
        Ok(Net { connections: connections.collect::<Parsed<_>>()? })
    }
}
