//! Rungs and what stands between the rails.

use super::script::Style;
use super::{INDENT, Printer, Separator};
use crate::syntax::ast::{
    Argument, ArgumentValue, Call, CoilAction, Connection, Edge, Element, ElementKind, Net,
    Reference, Rung, Series,
};

/// What is inside a list stands two columns to the right of its bracket.
const BRANCH: usize = "[ ".len();

impl<'s> Printer<'s> {
    /// With a title the network starts on the next line, without one only if it has to.
    pub(super) fn rung(&mut self, rung: &Rung<'s>) {
        self.script.open(Style::All, 0, INDENT);
        self.token("rung");
        let mut first = Separator::Line { blanks: 1, offset: INDENT };
        if let Some(title) = &rung.title {
            self.script.blank();
            self.written(title.span);
            first = Separator::Break { offset: INDENT };
        }
        if !rung.network.elements.is_empty() {
            self.separate(first);
            self.framed_series(&rung.network, INDENT, 2 * INDENT);
        }
        self.script.close();
    }

    /// A series in a frame of its own.
    fn framed_series(&mut self, series: &Series<'s>, base: usize, hang: usize) {
        self.script.open(Style::Fill, base, hang);
        self.series(series, Separator::Start);
        self.script.close();
    }

    /// Elements from left to right.
    pub(super) fn series(&mut self, series: &Series<'s>, first: Separator) {
        for (index, element) in series.elements.iter().enumerate() {
            self.separate(if index == 0 { first } else { Separator::BLANK });
            self.element(element);
        }
    }

    fn element(&mut self, element: &Element<'s>) {
        match &element.kind {
            ElementKind::Constant(_) | ElementKind::OneShot(_) | ElementKind::Invert => {
                self.written(element.span);
            }
            ElementKind::FirstScan { negated } => {
                self.negation(*negated);
                self.token("first_scan");
            }
            ElementKind::Contact { operand, negated } => {
                self.negation(*negated);
                self.reference(operand);
            }
            ElementKind::Edge { edge, operand } => self.edge(*edge, operand),
            ElementKind::Parallel(branches) => self.parallel(branches),
            ElementKind::Compare(value) => {
                self.open_braces();
                self.expression(value);
                self.close_braces();
            }
            ElementKind::Assign { target, value } => {
                self.open_braces();
                self.target(target);
                self.script.blank();
                self.token(":=");
                self.script.blank();
                self.expression(value);
                self.close_braces();
            }
            ElementKind::Coil { action, target } => self.coil(*action, target),
            ElementKind::Call(call) => self.call(call),
            ElementKind::Net(net) => self.net(net),
        }
    }

    /// `!`, also where `/` is written.
    fn negation(&mut self, negated: bool) {
        if negated {
            let written = if self.reader.rest().starts_with('/') { "/" } else { "!" };
            self.token_as(written, "!");
        }
    }

    fn edge(&mut self, edge: Edge, operand: &Reference<'s>) {
        self.token(edge_word(edge));
        self.token("(");
        self.reference(operand);
        self.token(")");
    }

    /// A list that does not fit on a line has one line for each branch.
    fn parallel(&mut self, branches: &[Series<'s>]) {
        self.script.open(Style::All, 0, BRANCH);
        self.token("[");
        self.script.blank();
        for (index, branch) in branches.iter().enumerate() {
            if index > 0 {
                self.separate(Separator::Mark { blanks: 1, offset: 0 });
                self.token("|");
                self.script.blank();
            }
            self.script.open(Style::Fill, BRANCH, BRANCH + INDENT);
            self.series(branch, Separator::Start);
            if index + 1 == branches.len() {
                self.comments_before_end(0);
            }
            self.script.close();
        }
        self.separate(Separator::Mark { blanks: 1, offset: 0 });
        self.token("]");
        self.script.close();
    }

    fn open_braces(&mut self) {
        self.script.open(Style::Fill, INDENT, INDENT);
        self.token("{");
        self.script.blank();
    }

    fn close_braces(&mut self) {
        self.script.glue();
        self.token("}");
        self.script.close();
    }

    /// What is assigned: brackets around it mean nothing.
    fn target(&mut self, target: &Reference<'s>) {
        let mut groups = 0;
        while self.reader.rest().starts_with('(') {
            self.drop_token("(");
            groups += 1;
        }
        self.reference(target);
        for _ in 0..groups {
            self.drop_token(")");
        }
    }

    /// `( y )`, but `(S y)`.
    fn coil(&mut self, action: CoilAction, target: &Reference<'s>) {
        self.token("(");
        match action {
            CoilAction::Plain => self.script.blank(),
            CoilAction::Negated => self.negation(true),
            CoilAction::Set => self.token("S"),
            CoilAction::Reset => self.token("R"),
            CoilAction::Rise => self.token(edge_word(Edge::Rise)),
            CoilAction::Fall => self.token(edge_word(Edge::Fall)),
        }
        if action != CoilAction::Negated {
            self.script.blank();
        }
        self.reference(target);
        if action == CoilAction::Plain {
            self.script.blank();
        }
        self.token(")");
    }

    /// A block that does not fit on a line has one line for each argument.
    fn call(&mut self, call: &Call<'s>) {
        self.script.open(Style::All, 0, INDENT);
        self.name(&call.name);
        self.token(":");
        self.name(&call.kind);
        self.token("(");
        for (index, argument) in call.arguments.iter().enumerate() {
            self.separate(Separator::Line { blanks: usize::from(index > 0), offset: INDENT });
            self.argument(argument, index + 1 == call.arguments.len());
        }
        if !call.arguments.is_empty() {
            self.comments_before_end(INDENT);
            self.separate(Separator::Mark { blanks: 0, offset: 0 });
        }
        self.token(")");
        self.script.close();
    }

    fn argument(&mut self, argument: &Argument<'s>, is_last: bool) {
        self.script.open(Style::Fill, 2 * INDENT, 2 * INDENT);
        self.name(&argument.name);
        self.script.blank();
        self.token(":=");
        match &argument.value {
            ArgumentValue::Network(network) => self.series(network, Separator::BLANK),
            ArgumentValue::Expr(value) => {
                self.separate(Separator::BLANK);
                self.expression(value);
            }
            ArgumentValue::List(values, _) => {
                self.separate(Separator::BLANK);
                self.constants(values);
            }
        }
        if !is_last {
            self.comma();
        }
        self.script.close();
    }

    /// One line for each connection, in any case.
    fn net(&mut self, net: &Net<'s>) {
        self.script.open(Style::All, 0, INDENT);
        self.token("net");
        self.script.blank();
        self.token("{");
        if net.connections.is_empty() {
            self.script.blank();
        }
        for connection in &net.connections {
            self.separate(Separator::Break { offset: INDENT });
            self.connection(connection);
        }
        if !net.connections.is_empty() {
            self.comments_before_end(INDENT);
            self.separate(Separator::Break { offset: 0 });
        }
        self.token("}");
        self.script.close();
    }

    fn connection(&mut self, connection: &Connection<'s>) {
        self.script.open(Style::Fill, INDENT, 2 * INDENT);
        self.name(&connection.from);
        self.script.blank();
        self.token(if connection.both_ways { "<->" } else { "->" });
        self.script.blank();
        self.name(&connection.to);
        self.script.blank();
        self.token(":");
        self.script.open(Style::Fill, INDENT, INDENT);
        self.series(&connection.network, Separator::BLANK);
        self.script.close();
        self.script.close();
    }
}

fn edge_word(edge: Edge) -> &'static str {
    match edge {
        Edge::Rise => "rise",
        Edge::Fall => "fall",
    }
}
