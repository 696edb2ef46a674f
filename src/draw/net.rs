//! A general network as a frame with one row for each of its connections.

use super::cells::{Align, ElementId, Point, Power, Shape, Style};
use super::node::{Kind, LEAD, Node, Series, Size, widest};
use super::place::Placer;
use super::words::width;

/// What stands in the frame: the nodes that the power enters and leaves by.
const ENDS: [&str; 2] = ["left", "right"];

/// A general network as it is drawn.
pub(super) struct Net {
    pub connections: Vec<Connection>,
}

/// A wire between two named nodes.
pub(super) struct Connection {
    pub from: Vec<String>,
    pub to: Vec<String>,
    pub both_ways: bool,
    pub network: Series,
}

impl Connection {
    fn above(&self) -> i32 {
        self.network.size.above
    }

    fn below(&self) -> i32 {
        let names = self.from.len().max(self.to.len()) as i32 - 1;
        self.network.size.below.max(names).max(self.network.exit + self.to.len() as i32 - 1)
    }
}

impl Net {
    /// Columns from the frame to the nodes at the left, and to those at the right.
    fn margins(&self) -> (i32, i32) {
        let names = |end: fn(&Connection) -> &[String]| {
            let widths = self.connections.iter().map(|connection| widest(end(connection)));
            widths.max().unwrap_or(0)
        };
        (names(|c| &c.from) + 3, names(|c| &c.to) + 3)
    }

    /// Columns beside the connections.
    pub fn beside(&self) -> i32 {
        let (left, right) = self.margins();
        2 * LEAD + left + 2 + right
    }

    /// Columns from node to node without the arrow.
    fn length(&self) -> i32 {
        let widths = self.connections.iter().map(|connection| connection.network.size.width);
        let pins: i32 = ENDS.iter().map(|end| width(end)).sum::<i32>() + 4;
        let (left, right) = self.margins();
        widths.max().unwrap_or(0).max(pins - left - right)
    }

    fn rows(&self) -> Vec<i32> {
        let mut free = 1;
        let row = |connection: &Connection| {
            let row = free + connection.above();
            free = row + connection.below() + 1;
            row
        };
        self.connections.iter().map(row).collect()
    }

    pub fn size(&self) -> Size {
        let last = self.connections.last().map_or(0, Connection::below);
        let bottom = self.rows().last().map_or(0, |row| row + last) + 1;
        Size { width: self.beside() + self.length(), above: 1, below: bottom }
    }

    pub fn into_node(self, element: ElementId) -> Node {
        let size = self.size();
        Node { element, kind: Kind::Net(Box::new(self)), size }
    }

    pub fn place(&self, element: ElementId, at: Point, end: i32, placer: &mut Placer) {
        let size = self.size();
        let (margin, _) = self.margins();
        let (left, right) = (at.x + LEAD, at.x + size.width - LEAD);
        let (from, to) = (left + margin, left + margin + self.length() + 2);
        let cell = |x, y| Point { x, y: at.y + y };
        placer.wire(at, cell(left, 0), Power::Into(element));
        placer.wire(cell(right, 0), cell(end, 0), Power::OutOf(element));
        placer.frame(Some(element), cell(left, -1), cell(right, size.below));
        placer.text(element, ENDS[0], cell(left + 1, 0), Align::Start, Style::Pin);
        placer.text(element, ENDS[1], cell(right - 1, 0), Align::End, Style::Pin);
        for ((number, connection), row) in self.connections.iter().enumerate().zip(self.rows()) {
            let exit = row + connection.network.exit;
            let power = connection.network.ends().exit;
            placer.series(&connection.network, cell(from, row), to - 2 - from, false);
            placer.wire(cell(to - 2, exit), cell(to, exit), power);
            placer.arrow(cell(to - 1, exit), connection.both_ways, power);
            for (end, at) in [cell(from, row), cell(to, exit)].into_iter().enumerate() {
                let power = Power::Node { net: element, connection: number, end };
                placer.part(Some(element), Shape::Dot { at, power });
            }
            for (line, below) in connection.from.iter().zip(0..) {
                placer.text(element, line, cell(from - 2, row + below), Align::End, Style::Name);
            }
            for (line, below) in connection.to.iter().zip(0..) {
                placer.text(element, line, cell(to + 2, exit + below), Align::Start, Style::Name);
            }
        }
    }
}
