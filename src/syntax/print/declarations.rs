//! The header and the declarations: what follows the word starts in a fixed column.

use super::script::Style;
use super::{Printer, Separator};
use crate::syntax::ast::{
    Amount, Constant, Declarator, Header, Initial, Literal, Quantity, TypeName, VariableKind,
    Variables,
};

/// Where names start, after the longest word.
const NAMES: usize = "output ".len();

impl<'s> Printer<'s> {
    pub(super) fn header(&mut self, header: &Header<'s>) {
        self.declare("ladder");
        self.name(&header.name);
        if let Some(title) = header.title {
            self.separate(Separator::BLANK);
            self.written(title.span);
        }
        self.script.close();
    }

    pub(super) fn quantity(&mut self, word: &str, quantity: &Quantity<'s>) {
        self.declare(word);
        self.written(quantity.span);
        self.script.close();
    }

    pub(super) fn variables(&mut self, variables: &Variables<'s>) {
        let word = match variables.kind {
            VariableKind::Input => "input",
            VariableKind::Output => "output",
            VariableKind::Var => "var",
        };
        self.declare(word);
        for (index, declarator) in variables.names.iter().enumerate() {
            if index > 0 {
                self.comma();
                self.separate(Separator::BLANK);
            }
            self.name(&declarator.name);
            self.address_and_initial(declarator);
        }
        if let Some(ty) = &variables.ty {
            self.type_name(ty);
        }
        // After the type they are those of every name.
        if let Some(declarator) = variables.names.first() {
            self.address_and_initial(declarator);
        }
        self.script.close();
    }

    pub(super) fn constant(&mut self, constant: &Constant<'s>) {
        self.declare("const");
        self.name(&constant.name);
        if let Some(ty) = &constant.ty {
            self.type_name(ty);
        }
        self.script.blank();
        self.token(":=");
        self.script.blank();
        self.expression(&constant.value);
        self.script.close();
    }

    /// The word of a declaration. Lines that go on with it stand below the names.
    fn declare(&mut self, word: &str) {
        self.script.open(Style::Fill, NAMES, NAMES);
        self.token(word);
        self.script.blanks(NAMES - word.len());
    }

    /// What stands here of `at 316` and `:= 5`: both may follow the name or the type.
    fn address_and_initial(&mut self, declarator: &Declarator<'s>) {
        if let Some(address) = &declarator.address
            && self.reader.position() < address.span.start as usize
            && self.reader.rest().starts_with("at")
        {
            self.script.blank();
            self.token("at");
            self.script.blank();
            self.literal(address);
        }
        if let Some(initial) = &declarator.initial
            && self.reader.rest().starts_with(":=")
        {
            self.script.blank();
            self.token(":=");
            self.script.blank();
            match initial {
                Initial::Value(value) => self.expression(value),
                Initial::List(values, _) => self.constants(values),
            }
        }
    }

    fn type_name(&mut self, ty: &TypeName<'s>) {
        self.script.blank();
        self.token(":");
        self.script.blank();
        self.name(&ty.name);
        if let Some(length) = &ty.length {
            self.token("[");
            self.amount(length);
            self.token("]");
        }
    }

    pub(super) fn amount(&mut self, amount: &Amount<'s>) {
        match amount {
            Amount::Literal(literal) => self.literal(literal),
            Amount::Constant(name) => self.name(name),
        }
    }

    pub(super) fn literal(&mut self, literal: &Literal<'s>) {
        self.written(literal.span);
    }
}
