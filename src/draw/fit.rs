//! Makes a rung as narrow as the drawing: series go on in the next line, and a list that leaves
//! no room for what is in it is drawn further down, under a mark.

use super::call::Fed;
use super::node::{END, Ends, JOIN, Kind, LEAD, Node, START, Series};

/// The narrowest line on which every single contact, box and block fits, between marks at both
/// ends.
const LEAST_LINE: i32 = 52 + START + END;

/// What is drawn further down.
pub(super) struct Detail {
    pub mark: String,
    pub from: From,
    pub ends: Ends,
    pub series: Series,
}

/// Where the power of a detail comes from.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum From {
    /// The place that the mark names.
    Mark,
    /// The left rail: a circuit for a pin of a block.
    Rail,
}

/// Fits the pieces of one rung.
#[derive(Default)]
pub(super) struct Fitter {
    pub details: std::collections::VecDeque<Detail>,
    marks: usize,
}

impl Fitter {
    /// A series on lines of a width.
    pub fn series(&mut self, mut series: Series, width: i32) -> Series {
        if series.size.width <= width {
            return series;
        }
        let line_width = width - START - END;
        let mut lines: Vec<Vec<Node>> = Vec::new();
        let mut used = 0;
        for node in series.lines.drain(..).flatten() {
            let node = self.node(node, line_width);
            // The first line has no mark at its start, the last none at its end.
            match lines.last_mut() {
                Some(line) if used + node.size.width <= width - END => {
                    used += node.size.width;
                    line.push(node);
                }
                _ => {
                    used = node.size.width + if lines.is_empty() { 0 } else { START };
                    lines.push(vec![node]);
                }
            }
        }
        Series::of_lines(lines, width)
    }

    /// What a detail shows, in all the room of the drawing: it is not put off once more.
    pub fn detail(&mut self, series: Series, width: i32) -> Series {
        let sole = series.lines.into_iter().flatten().map(|node| self.opened(node, width));
        let series = Series::new(sole.collect());
        self.series(series, width)
    }

    fn node(&mut self, node: Node, width: i32) -> Node {
        if node.size.width <= width {
            return node;
        }
        match node.kind {
            Kind::List(_) if width - 2 * JOIN >= LEAST_LINE => self.opened(node, width),
            Kind::List(_) | Kind::Net(_) => {
                let element = node.element;
                let (mark, ends) = self.put_off(From::Mark, Series::new(vec![node]));
                Node::elsewhere(element, ends, mark)
            }
            Kind::Call(_) => self.opened(node, width),
            Kind::Wire | Kind::Symbol { .. } | Kind::Formula { .. } | Kind::Elsewhere { .. } => {
                node
            }
        }
    }

    /// An element whose own parts are fitted.
    fn opened(&mut self, node: Node, width: i32) -> Node {
        let element = node.element;
        match node.kind {
            Kind::List(branches) => {
                let branches =
                    branches.into_iter().map(|branch| self.series(branch, width - 2 * JOIN));
                Node::list(element, branches.collect())
            }
            Kind::Net(mut net) => {
                let inner = width - net.beside();
                for connection in &mut net.connections {
                    if connection.network.size.width <= inner {
                        continue;
                    }
                    let network = connection.network.take();
                    connection.network = if inner >= LEAST_LINE {
                        self.series(network, inner)
                    } else {
                        let (mark, ends) = self.put_off(From::Mark, network);
                        Series::new(vec![Node::elsewhere(element, ends, mark)])
                    };
                }
                net.into_node(element)
            }
            Kind::Call(mut call) => {
                let others = call.size().width - call.circuits_width();
                for input in &mut call.inputs {
                    let Fed::Circuit(circuit) = &mut input.fed else { continue };
                    if others + circuit.size.width > width - 2 * LEAD {
                        let circuit = circuit.take();
                        let (mark, ends) = self.put_off(From::Rail, circuit);
                        input.fed = Fed::Elsewhere(mark, ends.exit);
                    }
                }
                call.into_node(element)
            }
            kind => Node { kind, ..node },
        }
    }

    /// Draws a series further down; returns its mark and the powers at its ends.
    fn put_off(&mut self, from: From, series: Series) -> (String, Ends) {
        let mark = letters(self.marks);
        self.marks += 1;
        let ends = series.ends();
        self.details.push_back(Detail { mark: mark.clone(), from, ends, series });
        (mark, ends)
    }
}

/// `A` to `Z`, then `AA`.
fn letters(number: usize) -> String {
    let letter = char::from(b'A' + (number % 26) as u8);
    match number / 26 {
        0 => letter.to_string(),
        more => letters(more - 1) + &letter.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::letters;

    #[test]
    fn marks_go_on_after_z() {
        assert_eq!([0, 25, 26, 701, 702].map(letters), ["A", "Z", "AA", "ZZ", "AAA"]);
    }
}
