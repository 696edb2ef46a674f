//! The header, declarations and rungs.

use super::super::split::Keyword;
use super::grammar::{Pair, Pairs, Rule};
use super::{Lower, Parsed};
use crate::diagnostic::{Diagnostic, code};
use crate::source::Span;
use crate::syntax::ast::{
    Constant, Declarator, Header, Initial, Item, Literal, Quantity, Rung, TypeName, VariableKind,
    Variables,
};

impl<'s> Lower<'s> {
    pub(super) fn header(&self, pair: Pair<'_>) -> Parsed<Item<'s>> {
        let mut parts = pair.into_inner();
        let name = self.name(&next(&mut parts))?;
        let title = parts.next().map(|title| self.title(&title));
        Ok(Item::Header(Header { name, title }))
    }

    pub(super) fn quantity(&self, pair: Pair<'_>) -> Quantity<'s> {
        let span = self.span(&next(&mut pair.into_inner()));
        Quantity { text: &self.text[span.range()], span }
    }

    pub(super) fn constant(&self, pair: Pair<'_>) -> Parsed<Item<'s>> {
        let mut parts = pair.into_inner();
        let name = self.name(&next(&mut parts))?;
        let mut value = next(&mut parts);
        let mut ty = None;
        if value.as_rule() == Rule::type_name {
            ty = Some(self.type_name(value)?);
            value = next(&mut parts);
        }
        Ok(Item::Constant(Constant { name, ty, value: self.expression(value)? }))
    }

    pub(super) fn variables(&self, keyword: Keyword, pair: Pair<'_>) -> Parsed<Item<'s>> {
        let kind = match keyword {
            Keyword::Input => VariableKind::Input,
            Keyword::Output => VariableKind::Output,
            _ => VariableKind::Var,
        };
        let mut variables = Variables { kind, names: Vec::new(), ty: None };
        for part in pair.into_inner() {
            match part.as_rule() {
                Rule::declarator => variables.names.push(self.declarator(part)?),
                Rule::type_name => variables.ty = Some(self.type_name(part)?),
                Rule::address => self.address_of_all(part, &mut variables.names)?,
                _ => self.initial_of_all(&part, &mut variables.names)?,
            }
        }
        Ok(Item::Variables(variables))
    }

    fn declarator(&self, pair: Pair<'_>) -> Parsed<Declarator<'s>> {
        let mut parts = pair.into_inner();
        let name = self.name(&next(&mut parts))?;
        let mut declarator = Declarator { name, address: None, initial: None };
        for part in parts {
            match part.as_rule() {
                Rule::address => declarator.address = Some(self.address(part)?),
                _ => declarator.initial = Some(self.initial(part)?),
            }
        }
        Ok(declarator)
    }

    /// `a : INT at 600`: an address after the type.
    fn address_of_all(&self, pair: Pair<'_>, names: &mut [Declarator<'s>]) -> Parsed<()> {
        let span = self.span(&pair);
        let address = self.address(pair)?;
        match names {
            [name] if name.address.is_none() => name.address = Some(address),
            [name] => return self.given_twice("address", span, name.name.span),
            _ => {
                let message = "one address cannot serve several names";
                let diagnostic = Diagnostic::new(code::SYNTAX, span, message)
                    .label("after more than one name")
                    .help("write each address after its name: `output a at 316, b at 317`");
                return self.fault(diagnostic);
            }
        }
        Ok(())
    }

    /// `a, b : INT := 5`: an initial value after the type is that of every name.
    fn initial_of_all(&self, pair: &Pair<'_>, names: &mut [Declarator<'s>]) -> Parsed<()> {
        for name in names {
            if name.initial.is_some() {
                return self.given_twice("initial value", self.span(pair), name.name.span);
            }
            name.initial = Some(self.initial(pair.clone())?);
        }
        Ok(())
    }

    fn given_twice<T>(&self, what: &str, span: Span, name: Span) -> Parsed<T> {
        let message = format!("`{}` is given an {what} twice", &self.text[name.range()]);
        let label = format!("this {what} comes after the type");
        let diagnostic = Diagnostic::new(code::SYNTAX, span, message)
            .label(label)
            .also(name, format!("the first {what} follows this name"))
            .help("remove one of them");
        self.fault(diagnostic)
    }

    fn address(&self, pair: Pair<'_>) -> Parsed<Literal<'s>> {
        self.integer(&next(&mut pair.into_inner()), "an image address")
    }

    fn initial(&self, pair: Pair<'_>) -> Parsed<Initial<'s>> {
        let value = next(&mut pair.into_inner());
        if value.as_rule() == Rule::constants {
            let span = self.span(&value);
            return Ok(Initial::List(self.expressions(value)?, span));
        }
        Ok(Initial::Value(self.expression(value)?))
    }

    fn type_name(&self, pair: Pair<'_>) -> Parsed<TypeName<'s>> {
        let mut parts = pair.into_inner();
        let name = self.name(&next(&mut parts))?;
        let length = parts.next().map(|length| self.count(&length, "the number of elements"));
        Ok(TypeName { name, length: length.transpose()? })
    }

    pub(super) fn rung(&self, pair: Pair<'_>) -> Parsed<Item<'s>> {
        let mut parts = pair.into_inner();
        let mut network = next(&mut parts);
        let mut title = None;
        if network.as_rule() == Rule::title {
            title = Some(self.title(&network));
            network = next(&mut parts);
        }
        let network = self.series(network)?;
        let span = self.word.to(network.span);
        Ok(Item::Rung(Rung { title, network, span }))
    }
}

/// The next part of a rule that always has it.
pub(super) fn next<'p>(parts: &mut Pairs<'p>) -> Pair<'p> {
    parts.next().expect("the grammar says that there is such a part")
}
