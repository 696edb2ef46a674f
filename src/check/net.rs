//! General networks: nodes get their numbers, and some path must lead from left to right.

use std::collections::HashMap;

use super::network::Site;
use super::{Checked, Checker};
use crate::diagnostic::{Diagnostic, code, shortened, similar_name};
use crate::model::{Connection, Net, Node};
use crate::source::Span;
use crate::syntax::ast::{self, Name};

/// More nodes would give equations that grow with their cube.
const MOST_NODES: usize = 64;

impl<'s> Checker<'s> {
    pub(super) fn net(&mut self, net: &ast::Net<'s>, span: Span) -> Checked<Net> {
        let word = Span { end: span.start + "net".len() as u32, ..span };
        if net.connections.is_empty() {
            let diagnostic = Diagnostic::new(code::EMPTY_BRANCH, word, "the network is empty")
                .label("nothing is connected")
                .help("connect its ends, for instance: net { left -> right : a }");
            return Err(self.report(diagnostic));
        }
        let mut nodes = Nodes::new(word);
        let mut connections = Vec::with_capacity(net.connections.len());
        let mut failed = false;
        for connection in &net.connections {
            // All of it is looked at, so that each mistake is found in one run.
            let found = self.diagnostics.len();
            let network = self.series(&connection.network, Site::Connection);
            let ends = [connection.from, connection.to]
                .map(|name| nodes.number(name).map_err(|diagnostic| self.report(*diagnostic)).ok());
            let span = connection.from.span.to(connection.to.span);
            match ends {
                [Some(from), Some(to)] if from == to => {
                    self.report(connected_to_itself(connection.from, span));
                }
                [Some(from), Some(to)] => {
                    let both_ways = connection.both_ways;
                    connections.push(Connection { from, to, both_ways, network, span });
                }
                _ => {}
            }
            failed |= self.diagnostics.len() > found;
        }
        if failed {
            return Err(super::Reported);
        }
        let net = Net { nodes: nodes.list, connections };
        if net.nodes.len() > MOST_NODES {
            let message = format!("a network has {MOST_NODES} nodes at most");
            let diagnostic = Diagnostic::new(code::BAD_NETWORK, word, message)
                .label(format!("this one has {}", net.nodes.len()))
                .help("write the power at some nodes to variables, and go on from those");
            return Err(self.report(diagnostic));
        }
        let reached = net.reached();
        if !reached[Net::RIGHT] {
            return Err(self.report(no_path(&net, &reached, word)));
        }
        Ok(net)
    }
}

/// The nodes of a network by name.
struct Nodes<'s> {
    list: Vec<Node>,
    exact: HashMap<&'s str, usize>,
    /// By name in lower case.
    folded: HashMap<String, usize>,
}

impl<'s> Nodes<'s> {
    fn new(span: Span) -> Self {
        let ends = ["left", "right"];
        let list = ends.map(|name| Node { name: name.to_owned(), span });
        Nodes {
            list: list.into(),
            exact: ends.into_iter().zip(0..).collect(),
            folded: ends.map(str::to_owned).into_iter().zip(0..).collect(),
        }
    }

    /// The number of the node of that name, which is made where it is used first.
    fn number(&mut self, name: Name<'s>) -> Result<usize, Box<Diagnostic>> {
        if let Some(&number) = self.exact.get(name.text) {
            return Ok(number);
        }
        if let Some(&other) = self.folded.get(&name.text.to_lowercase()) {
            // It is said once: the other node is meant wherever the name stands.
            self.exact.insert(name.text, other);
            let text = shortened(name.text);
            let message = format!("the node `{text}` differs from another one only in case");
            let other = &self.list[other].name;
            let diagnostic = Diagnostic::new(code::DUPLICATE_NAME, name.span, message)
                .label("a second node")
                .help(format!("write `{}`, or give one of them another name", shortened(other)));
            return Err(diagnostic.into());
        }
        let number = self.list.len();
        self.folded.insert(name.text.to_lowercase(), number);
        self.exact.insert(name.text, number);
        self.list.push(Node { name: name.text.to_owned(), span: name.span });
        Ok(number)
    }
}

fn connected_to_itself(node: Name<'_>, span: Span) -> Diagnostic {
    let message = format!("the node `{}` is connected to itself", shortened(node.text));
    Diagnostic::new(code::BAD_NETWORK, span, message)
        .label("both ends are the same node")
        .help("a connection leads from one node to another")
}

/// Says how far the power comes, and which name may be mistyped.
fn no_path(net: &Net, reached: &[bool], word: Span) -> Diagnostic {
    let message = "no path leads from `left` to `right`";
    let mut diagnostic =
        Diagnostic::new(code::BAD_NETWORK, word, message).label("never conducts, whatever is on");
    let ends = &net.connections[0];
    let first = net.connections.iter().find(|one| !reached[one.from] && one.from != Net::RIGHT);
    let start = &net.nodes[first.unwrap_or(ends).from];
    let names = net.nodes.iter().zip(reached).filter(|&(_, &reached)| reached);
    let known = names.map(|(node, _)| node.name.as_str());
    if first.is_some() {
        let text = format!("no power comes to `{}`", shortened(&start.name));
        diagnostic = diagnostic.also(start.span, text);
        if let Some(similar) = similar_name(&start.name, known) {
            return diagnostic.help(format!("is `{similar}` meant?"));
        }
    }
    diagnostic.help("`->` conducts from its left to its right only, `<->` both ways")
}
