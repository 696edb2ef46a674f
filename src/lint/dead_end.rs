//! Nodes and connections of general networks that no path from left to right needs.

use super::index::Index;
use crate::diagnostic::{Diagnostic, code, shortened, similar_name};
use crate::model::Net;

pub(super) fn check(index: &Index, found: &mut Vec<Diagnostic>) {
    for net in &index.nets {
        let reached = net.reached();
        let useful = useful(net, &reached);
        nodes(net, &reached, &useful, found);
        for connection in net.connections.iter().filter(|connection| !connection.both_ways) {
            let (end, label) = match (connection.from, connection.to) {
                (_, Net::LEFT) => ("left", "leads back to where all power comes from"),
                (Net::RIGHT, _) => ("right", "leaves where the power has arrived"),
                _ => continue,
            };
            let message = format!("this connection of `{end}` has no effect");
            found.push(
                Diagnostic::new(code::DEAD_END, connection.span, message)
                    .label(label)
                    .help("turn it round, or remove it"),
            );
        }
    }
}

/// One finding for the nodes that no power reaches and one for those that lead nowhere: where one
/// name is wrong, others follow from it.
fn nodes(net: &Net, reached: &[bool], useful: &[bool], found: &mut Vec<Diagnostic>) {
    for is_reached in [false, true] {
        let useless: Vec<usize> = (0..net.nodes.len())
            .filter(|&node| !useful[node] && reached[node] == is_reached)
            .collect();
        let Some(&first) = useless.first() else { continue };
        let node = &net.nodes[first];
        let name = shortened(&node.name);
        let (message, label) = match is_reached {
            false => (format!("no power comes to the node `{name}`"), "not connected with `left`"),
            true => (format!("the node `{name}` leads nowhere"), "no way on to `right`"),
        };
        let others = match useless.len() {
            1 => String::new(),
            2 => "; so it is with 1 more node".to_owned(),
            count => format!("; so it is with {} more nodes", count - 1),
        };
        let known = net.nodes.iter().zip(useful).filter(|&(_, &useful)| useful);
        let help = match similar_name(&node.name, known.map(|(node, _)| node.name.as_str())) {
            Some(similar) => format!("is `{similar}` meant?"),
            None => "connect it, or remove its connections".to_owned(),
        };
        found.push(
            Diagnostic::new(code::DEAD_END, node.span, message)
                .label(format!("{label}{others}"))
                .help(help),
        );
    }
}

/// For each node, whether it may lie on a path from left to right: power can come to it from one
/// node and go on to another one.
fn useful(net: &Net, reached: &[bool]) -> Vec<bool> {
    let ways: Vec<(usize, usize)> = net.ways().collect();
    let mut useful: Vec<bool> = reached.iter().zip(net.leading()).map(|(a, b)| *a && b).collect();
    loop {
        let before = useful.clone();
        for node in 2..net.nodes.len() {
            let from = || ways.iter().filter(|way| way.1 == node && useful[way.0]).map(|way| way.0);
            let to = || ways.iter().filter(|way| way.0 == node && useful[way.1]).map(|way| way.1);
            useful[node] &= from().any(|one| to().any(|other| one != other));
        }
        if useful == before {
            return useful;
        }
    }
}
