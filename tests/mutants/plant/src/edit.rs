//! Faults in the text of a file, behind switches. Lines stay where they are.

use std::collections::HashMap;
use std::ops::Range;

use anyhow::{Context, Result};
use proc_macro2::LineColumn;
use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::{Arm, BinOp, Expr, ExprBinary, ExprStruct, ExprUnary, FieldValue};

use crate::fault::{Fault, Function, Genre, Place};

/// The text with these faults, and which of them cannot stand behind a switch.
pub fn plant(text: &str, faults: &[(usize, &Fault)]) -> Result<(String, Vec<usize>)> {
    let mut lines = vec![0];
    lines.extend(text.match_indices('\n').map(|(at, _)| at + 1));
    let mut planting = Planting { text, lines, faults: HashMap::new(), edits: Vec::new() };
    for &(number, fault) in faults {
        // What a function returns of a type that it does not name is of one type alone.
        let is_named = |function: &Function| !function.return_type.contains("impl ");
        if fault.genre == Genre::FnValue && fault.function.as_ref().is_some_and(is_named) {
            // Before all else that begins where a body does.
            let at = planting.offset(fault.span.start.line, fault.span.start.column - 1);
            let instead = fault.replacement.replace('\n', " ");
            planting.insert(at, format!("if crate::planted({number}) {{ return {instead}; }} "));
        } else {
            let key = (fault.genre, fault.span.start);
            planting.faults.entry(key).or_default().push((number, fault));
        }
    }
    planting.visit_file(&syn::parse_file(text)?);

    let Planting { mut edits, faults: left, .. } = planting;
    edits.sort_by_key(|(range, _)| range.start);
    let mut changed = String::new();
    let mut at = 0;
    for (range, new) in edits {
        changed += text.get(at..range.start).context("edits do not overlap")?;
        changed += &new;
        at = range.end;
    }
    let left = left.into_values().flatten().map(|(number, _)| number);
    Ok((changed + &text[at..], left.collect()))
}

struct Planting<'a> {
    text: &'a str,
    /// Where each line starts.
    lines: Vec<usize>,
    /// Those that are not planted yet.
    faults: HashMap<(Genre, Place), Vec<(usize, &'a Fault)>>,
    /// What is replaced by what; those at one place in the order in which they shall stand.
    edits: Vec<(Range<usize>, String)>,
}

impl<'a> Planting<'a> {
    /// The byte of a line from 1 and a column from 0.
    fn offset(&self, line: usize, column: usize) -> usize {
        let start = self.lines[line - 1];
        let rest = &self.text[start..];
        start + rest.char_indices().nth(column).map_or(rest.len(), |(at, _)| at)
    }

    fn range(&self, of: &impl Spanned) -> Range<usize> {
        let (start, end) = (of.span().start(), of.span().end());
        self.offset(start.line, start.column)..self.offset(end.line, end.column)
    }

    fn insert(&mut self, at: usize, new: String) {
        self.edits.push((at..at, new));
    }

    /// Takes the faults of a kind that start somewhere.
    fn take(&mut self, genre: Genre, start: LineColumn) -> Vec<(usize, &'a Fault)> {
        let place = Place { line: start.line, column: start.column + 1 };
        self.faults.remove(&(genre, place)).unwrap_or_default()
    }

    /// One of two operators between truth values for the other: the left operand decides the other way round.
    fn and_or(&mut self, number: usize, binary: &ExprBinary) {
        let is_and = matches!(binary.op, BinOp::And(_));
        let (left, right) = (self.range(&*binary.left), self.range(&*binary.right));
        self.insert(left.start, "(if (".to_owned());
        self.visit_expr(&binary.left);
        let (before, after) = if is_and {
            (
                format!(") != crate::planted({number}) {{ "),
                format!(" }} else {{ crate::planted({number}) }})"),
            )
        } else {
            (
                format!(") != crate::planted({number}) {{ !crate::planted({number}) }} else {{ "),
                " })".to_owned(),
            )
        };
        self.edits.push((left.end..right.start, self.only_breaks(left.end..right.start, before)));
        self.visit_expr(&binary.right);
        self.insert(right.end, after);
    }

    /// Another operator for one that has a result of its operands.
    fn operator(&mut self, found: &[(usize, &Fault)], binary: &ExprBinary) {
        let (left, right) = (self.range(&*binary.left), self.range(&*binary.right));
        let written = self.text[self.range(&binary.op)].to_owned();
        let compares = matches!(
            binary.op,
            BinOp::Eq(_) | BinOp::Ne(_) | BinOp::Lt(_) | BinOp::Le(_) | BinOp::Gt(_) | BinOp::Ge(_)
        );
        let lend = if compares { "&" } else { "" };
        self.insert(left.start, format!("(match ({lend}("));
        self.visit_expr(&binary.left);
        let between = format!("), {lend}(");
        self.edits.push((left.end..right.start, self.only_breaks(left.end..right.start, between)));
        self.visit_expr(&binary.right);
        let mut choice = String::from(")) { (l, r) => ");
        for (number, fault) in found {
            choice += &format!("if crate::planted({number}) {{ l {} r }} else ", fault.replacement);
        }
        self.insert(right.end, format!("{choice}{{ l {written} r }} }})"));
    }

    /// Another operator for one that changes its left operand.
    fn assignment(&mut self, found: &[(usize, &Fault)], binary: &ExprBinary) {
        let (left, right) = (self.range(&*binary.left), self.range(&*binary.right));
        let place = self.text[left.clone()].replace('\n', " ");
        let written = &self.text[self.range(&binary.op)];
        let mut choice = String::from("; ");
        for (number, fault) in found {
            let instead = &fault.replacement;
            choice +=
                &format!("if crate::planted({number}) {{ {place} {instead} planted_value }} else ");
        }
        choice += &format!("{{ {place} {written} planted_value }} }}");
        let before = self.only_breaks(left.start..right.start, "{ let planted_value = ".to_owned());
        self.edits.push((left.start..right.start, before));
        self.visit_expr(&binary.right);
        self.insert(right.end, choice);
    }

    /// The new text for a range, with the breaks of lines of the old.
    fn only_breaks(&self, range: Range<usize>, new: String) -> String {
        new + &"\n".repeat(self.text[range].matches('\n').count())
    }
}

impl<'ast> Visit<'ast> for Planting<'_> {
    fn visit_expr_binary(&mut self, binary: &'ast ExprBinary) {
        // A condition that binds names has no other operator.
        if binds(&binary.left) || binds(&binary.right) {
            return visit::visit_expr_binary(self, binary);
        }
        let found = self.take(Genre::BinaryOperator, binary.op.span().start());
        match (&found[..], binary.op) {
            ([], _) => visit::visit_expr_binary(self, binary),
            ([(number, _)], BinOp::And(_) | BinOp::Or(_)) => self.and_or(*number, binary),
            _ if self.text[self.range(&binary.op)].ends_with('=')
                && !matches!(
                    binary.op,
                    BinOp::Eq(_) | BinOp::Ne(_) | BinOp::Le(_) | BinOp::Ge(_)
                ) =>
            {
                self.assignment(&found, binary);
            }
            _ => self.operator(&found, binary),
        }
    }

    fn visit_expr_unary(&mut self, unary: &'ast ExprUnary) {
        let found = self.take(Genre::UnaryOperator, unary.op.span().start());
        let [(number, _)] = found[..] else {
            return visit::visit_expr_unary(self, unary);
        };
        let (sign, operand) = (self.range(&unary.op), self.range(&*unary.expr));
        let written = self.text[sign.clone()].to_owned();
        self.edits.push((sign, "(match (".to_owned()));
        self.visit_expr(&unary.expr);
        let choice =
            format!(") {{ e => if crate::planted({number}) {{ e }} else {{ {written}e }} }})");
        self.insert(operand.end, choice);
    }

    fn visit_arm(&mut self, arm: &'ast Arm) {
        if arm.guard.as_ref().is_some_and(|(_, guard)| binds(guard)) {
            return visit::visit_arm(self, arm);
        }
        let left_out = self.take(Genre::MatchArm, arm.span().start());
        let mut before: String =
            left_out.iter().map(|(number, _)| format!("!crate::planted({number})")).collect();
        let Some((_, guard)) = &arm.guard else {
            if !before.is_empty() {
                self.insert(self.range(&arm.pat).end, format!(" if {before}"));
            }
            return visit::visit_arm(self, arm);
        };
        if !before.is_empty() {
            before += " && ";
        }
        let mut after = String::new();
        for (number, fault) in self.take(Genre::MatchArmGuard, guard.span().start()) {
            let is_true = fault.replacement == "true";
            let (not, operator) = if is_true { ("", "||") } else { ("!", "&&") };
            before += &format!("({not}crate::planted({number}) {operator} ");
            after += ")";
        }
        let range = self.range(&**guard);
        self.insert(range.start, before + "(");
        self.visit_expr(guard);
        self.insert(range.end, after + ")");
        self.visit_expr(&arm.body);
    }

    fn visit_expr_struct(&mut self, structure: &'ast ExprStruct) {
        let Some(rest) = &structure.rest else {
            return visit::visit_expr_struct(self, structure);
        };
        let base = self.text[self.range(&**rest)].replace('\n', " ");
        for field in &structure.fields {
            self.field(field, &base);
        }
        self.visit_expr(rest);
    }
}

impl Planting<'_> {
    /// A field of a structure that has the others from a base.
    fn field(&mut self, field: &FieldValue, base: &str) {
        let found = self.take(Genre::StructField, field.span().start());
        let [(number, _)] = found[..] else { return self.visit_expr(&field.expr) };
        let value = self.range(&field.expr);
        let name = self.text[self.range(&field.member)].to_owned();
        let colon = if field.colon_token.is_some() { String::new() } else { format!("{name}: ") };
        let choice = format!("{colon}if crate::planted({number}) {{ ({base}).{name} }} else {{ ");
        self.insert(value.start, choice);
        self.visit_expr(&field.expr);
        self.insert(value.end, " }".to_owned());
    }
}

/// True if a condition binds names with `let`.
fn binds(condition: &Expr) -> bool {
    match condition {
        Expr::Let(_) => true,
        Expr::Binary(binary) => binds(&binary.left) || binds(&binary.right),
        _ => false,
    }
}
