//! Elements of a rung with the room that they take.
//!
//! A piece is entered by the wire at its left end and left at its right end, `width` columns
//! further on. Rows count from the row of the entering wire.

use super::cells::{ElementId, Power, Symbol};
use super::references::References;
use super::words::width;

/// Columns between a neighbour and the frame of a box.
pub(super) const LEAD: i32 = 2;
/// Columns between a neighbour and the wire that joins the branches of a list.
pub(super) const JOIN: i32 = 2;
/// Least width of a contact, so that those with short names stand in columns.
const LEAST: i32 = 10;
/// Least width of a coil, so that most stand in one column at the right rail.
const LEAST_COIL: i32 = 14;
/// Columns that a line takes at its start to go on from the line before: mark and arrow.
pub(super) const START: i32 = 6;
/// Columns that a line takes at its end to say where it goes on.
pub(super) const END: i32 = 6;

/// The room that a piece takes.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Size {
    /// Columns from where the wire enters to where it leaves.
    pub width: i32,
    /// Rows above the entering wire.
    pub above: i32,
    /// Rows below it.
    pub below: i32,
}

/// One element.
pub(super) struct Node {
    pub element: ElementId,
    pub kind: Kind,
    pub size: Size,
}

pub(super) enum Kind {
    /// A wire.
    Wire,
    /// A contact, a coil, or what acts on the power, with its name above it.
    Symbol { symbol: Symbol, label: Vec<String>, references: References },
    /// A comparison or an assignment, with the room of each of its values.
    Formula { lines: Vec<String>, values: Vec<i32>, references: References, writes: bool },
    /// Branches.
    List(Vec<Series>),
    /// A block.
    Call(Box<super::call::Call>),
    /// A general network.
    Net(Box<super::net::Net>),
    /// What is drawn further down, under this mark.
    Elsewhere { mark: String, ends: Ends },
}

/// The powers at both ends of what is drawn further down.
#[derive(Clone, Copy)]
pub(super) struct Ends {
    pub entry: Power,
    pub exit: Power,
}

/// Elements from left to right, on one line or several.
pub(super) struct Series {
    pub lines: Vec<Vec<Node>>,
    pub size: Size,
    /// The row in which the last line leaves.
    pub exit: i32,
}

impl Node {
    pub fn wire(element: ElementId) -> Self {
        Node { element, kind: Kind::Wire, size: Size { width: 4, above: 0, below: 0 } }
    }

    pub fn symbol(
        element: ElementId,
        symbol: Symbol,
        label: Vec<String>,
        references: References,
    ) -> Self {
        let named = widest(&label).max(width(&references.to_string()));
        let least = if matches!(symbol, Symbol::Coil(_)) { LEAST_COIL } else { LEAST };
        let needed = (named + 3).max(symbol.span() + 2 * LEAD).max(least);
        let size = Size {
            width: needed + needed % 2,
            above: label.len() as i32,
            below: i32::from(!references.is_empty()),
        };
        Node { element, kind: Kind::Symbol { symbol, label, references }, size }
    }

    pub fn formula(
        element: ElementId,
        lines: Vec<String>,
        values: Vec<i32>,
        references: References,
        writes: bool,
    ) -> Self {
        let inner = formula_width(&lines, &values).max(width(&references.to_string())) + 2;
        let rows = lines.len() + values.len();
        let size = Size {
            width: inner + 1 + 2 * LEAD,
            above: 1,
            below: rows as i32 + i32::from(!references.is_empty()),
        };
        Node { element, kind: Kind::Formula { lines, values, references, writes }, size }
    }

    pub fn list(element: ElementId, branches: Vec<Series>) -> Self {
        let rows = branch_rows(&branches);
        let last = rows.last().copied().unwrap_or(0);
        let size = Size {
            width: branches.iter().map(|branch| branch.size.width).max().unwrap_or(0) + 2 * JOIN,
            above: branches.first().map_or(0, |branch| branch.size.above),
            below: last + branches.last().map_or(0, |branch| branch.size.below),
        };
        Node { element, kind: Kind::List(branches), size }
    }

    pub fn elsewhere(element: ElementId, ends: Ends, mark: String) -> Self {
        let size = Size { width: width(&mark) + 3 + 2 * LEAD, above: 1, below: 1 };
        Node { element, kind: Kind::Elsewhere { mark, ends }, size }
    }

    /// The power that it lets out.
    pub fn exit(&self) -> Power {
        match &self.kind {
            Kind::Elsewhere { ends, .. } => ends.exit,
            _ => Power::OutOf(self.element),
        }
    }

    /// The power that comes to it.
    pub fn entry(&self) -> Power {
        match &self.kind {
            Kind::Elsewhere { ends, .. } => ends.entry,
            _ => Power::Into(self.element),
        }
    }

    /// True for what is drawn at the right rail if nothing follows.
    pub fn is_output(&self) -> bool {
        match &self.kind {
            Kind::Symbol { symbol, .. } => matches!(symbol, Symbol::Coil(_)),
            Kind::Formula { writes, .. } => *writes,
            _ => false,
        }
    }

    /// True for a list of branches that all end with outputs.
    pub fn is_list_of_outputs(&self) -> bool {
        match &self.kind {
            Kind::List(branches) => branches.iter().all(Series::ends_with_output),
            _ => false,
        }
    }
}

impl Series {
    /// On one line.
    pub fn new(elements: Vec<Node>) -> Self {
        let width = elements.iter().map(|node| node.size.width).sum();
        Series::of_lines(vec![elements], width)
    }

    /// On several lines of a width.
    pub fn of_lines(lines: Vec<Vec<Node>>, width: i32) -> Self {
        let mut series = Series { lines, size: Size::default(), exit: 0 };
        let exit = series.rows().last().map_or(0, |&(row, _)| row);
        let last = series.lines.last().map_or(Size::default(), |line| line_size(line));
        let above = series.lines.first().map_or(0, |line| line_size(line).above);
        series.size = Size { width, above, below: exit + last.below };
        series.exit = exit;
        series
    }

    /// The series itself, which leaves an empty one behind.
    pub fn take(&mut self) -> Series {
        std::mem::replace(self, Series::new(Vec::new()))
    }

    /// The powers that come to it and leave it.
    pub fn ends(&self) -> Ends {
        let (first, last) =
            (self.lines.iter().flatten().next(), self.lines.iter().flatten().last());
        Ends {
            entry: first.map_or(Power::Rail, Node::entry),
            exit: last.map_or(Power::Rail, Node::exit),
        }
    }

    /// The row of each line and the line.
    pub fn rows(&self) -> Vec<(i32, &[Node])> {
        let mut rows: Vec<(i32, &[Node])> = Vec::with_capacity(self.lines.len());
        let mut free = 0;
        for line in &self.lines {
            let size = line_size(line);
            let row = if rows.is_empty() { 0 } else { free + size.above };
            rows.push((row, line));
            free = row + size.below + 2;
        }
        rows
    }

    /// True if nothing but outputs stands at its right end.
    pub fn ends_with_output(&self) -> bool {
        let last = self.lines.last().and_then(|line| line.last());
        last.is_some_and(|node| node.is_output() || node.is_list_of_outputs())
    }
}

/// The row in which each branch starts.
pub(super) fn branch_rows(branches: &[Series]) -> Vec<i32> {
    let mut rows = Vec::with_capacity(branches.len());
    let mut free = 0;
    for (index, branch) in branches.iter().enumerate() {
        let row = if index == 0 { 0 } else { free + branch.size.above };
        rows.push(row);
        free = row + branch.size.below + 1;
    }
    rows
}

/// The width of the widest line of a box with an expression.
pub(super) fn formula_width(lines: &[String], values: &[i32]) -> i32 {
    widest(lines).max(values.iter().copied().max().unwrap_or(0))
}

/// The width of the widest of some lines.
pub(super) fn widest(lines: &[String]) -> i32 {
    lines.iter().map(|line| width(line)).max().unwrap_or(0)
}

fn line_size(line: &[Node]) -> Size {
    let most = |part: fn(&Size) -> i32| line.iter().map(|node| part(&node.size)).max().unwrap_or(0);
    Size {
        width: line.iter().map(|node| node.size.width).sum(),
        above: most(|size| size.above),
        below: most(|size| size.below),
    }
}
