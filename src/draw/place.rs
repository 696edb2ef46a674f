//! Gives every piece its place in the grid.

use super::cells::{Align, ElementId, Form, Part, Point, Power, Shape, Style, Symbol, Text};
use super::node::{END, JOIN, Kind, LEAD, Node, START, Series, branch_rows, formula_width};
use super::references::References;
use super::words::width;

/// Collects the parts of a rung.
#[derive(Default)]
pub(super) struct Placer {
    pub parts: Vec<Part>,
    /// Where circuits start at a rail of their own.
    pub stubs: Vec<Point>,
    /// How often a line went on in another one.
    turns: usize,
}

impl Placer {
    pub fn part(&mut self, element: Option<ElementId>, shape: Shape) {
        self.parts.push(Part { element, shape });
    }

    /// A wire, if it has a length.
    pub fn wire(&mut self, from: Point, to: Point, power: Power) {
        if from != to {
            self.part(None, Shape::Wire { from, to, power });
        }
    }

    /// A frame; that of what is drawn further down shows no element.
    pub fn frame(&mut self, element: Option<ElementId>, from: Point, to: Point) {
        self.part(element, Shape::Frame { from, to });
    }

    pub fn arrow(&mut self, at: Point, both_ways: bool, power: Power) {
        self.part(None, Shape::Arrow { at, both_ways, power });
    }

    /// Room for a value, which starts or ends in a cell.
    pub fn reading(
        &mut self,
        element: ElementId,
        (reading, width): (usize, i32),
        at: Point,
        align: Align,
        form: Form,
    ) {
        let at = Point { x: at.x - left_of(width, align), ..at };
        self.part(Some(element), Shape::Reading { at, width, reading, form, align });
    }

    /// A circuit starts here at a rail of its own.
    pub fn stub(&mut self, at: Point) {
        self.stubs.push(at);
    }

    /// A text, if it is not empty, whose left end, middle or right end is in a cell.
    pub fn text(&mut self, element: ElementId, text: &str, at: Point, align: Align, style: Style) {
        if !text.is_empty() {
            let text = self.line(text, at, align, style);
            self.part(Some(element), Shape::Text(text));
        }
    }

    fn line(&self, text: &str, at: Point, align: Align, style: Style) -> Text {
        let width = width(text);
        let x = at.x - left_of(width, align);
        Text { at: Point { x, ..at }, width, text: text.to_owned(), style, align }
    }

    /// Lines above each other around a column, the last in a row.
    pub fn label(&mut self, element: ElementId, lines: &[String], last: Point, style: Style) {
        for (line, up) in lines.iter().rev().zip(0..) {
            let at = Point { y: last.y - up, ..last };
            self.text(element, line, at, Align::Middle, style);
        }
    }

    pub fn references(
        &mut self,
        element: ElementId,
        references: &References,
        middle: Point,
        below_frame: bool,
    ) {
        if !references.is_empty() {
            let x = middle.x - left_of(width(&references.to_string()), Align::Middle);
            let (at, references) = (Point { x, ..middle }, references.clone());
            self.part(Some(element), Shape::References { at, references, below_frame });
        }
    }

    /// A mark that leads to another place of the drawing.
    pub fn mark(&mut self, mark: &str, at: Point, align: Align) {
        let text = self.line(mark, at, align, Style::Mark);
        self.part(None, Shape::Text(text));
    }

    /// A series from a cell on, stretched to a width. `to_rail`: it ends at the right rail.
    pub fn series(&mut self, series: &Series, at: Point, width: i32, to_rail: bool) {
        let rows = series.rows();
        let mut before: Option<(String, Power)> = None;
        for (index, (row, line)) in rows.iter().enumerate() {
            let is_last = index + 1 == rows.len();
            let y = at.y + row;
            let (mut start, mut end) = (at.x, at.x + width);
            if let Some((mark, power)) = before.take() {
                start += START;
                let arrow = Point { x: start - 1, y };
                self.mark(&mark, Point { x: start - 2, y }, Align::End);
                self.arrow(arrow, false, power);
                self.wire(arrow, Point { x: start, y }, power);
            }
            if !is_last {
                end -= END;
                self.turns += 1;
                let power = line.last().map_or(Power::Rail, Node::exit);
                let arrow = Point { x: end + 1, y };
                self.wire(Point { x: end, y }, arrow, power);
                self.arrow(arrow, false, power);
                // Three digits have room; in a rung that long no two equal marks are near.
                let mark = ((self.turns - 1) % 999 + 1).to_string();
                self.mark(&mark, Point { x: end + 2, y }, Align::Start);
                before = Some((mark, power));
            }
            self.line_of(line, Point { x: start, y }, end, to_rail && is_last);
        }
    }

    /// Elements in one row. Outputs stand at its right end.
    fn line_of(&mut self, line: &[Node], at: Point, end: i32, to_rail: bool) {
        let natural: i32 = line.iter().map(|node| node.size.width).sum();
        let extra = end - at.x - natural;
        let stretches = line.last().is_some_and(Node::is_list_of_outputs);
        let outputs = line.iter().rev().take_while(|node| node.is_output()).count();
        let mut x = at.x;
        let mut power = line.first().map_or(Power::Rail, Node::entry);
        for (index, node) in line.iter().enumerate() {
            let cell = |x| Point { x, ..at };
            if index + outputs == line.len() && !stretches {
                self.wire(cell(x), cell(x + extra), power);
                x += extra;
            }
            let is_last = index + 1 == line.len();
            let stretch = if is_last && stretches { extra } else { 0 };
            let next = x + node.size.width + stretch;
            self.node(node, cell(x), next, to_rail && is_last);
            power = node.exit();
            x = next;
        }
        self.wire(Point { x, ..at }, Point { x: end, ..at }, power);
    }

    /// One element from a cell up to a column.
    fn node(&mut self, node: &Node, at: Point, end: i32, to_rail: bool) {
        let element = node.element;
        let leaves = Point { x: end, ..at };
        match &node.kind {
            Kind::Wire => self.wire(at, leaves, Power::Into(element)),
            Kind::Symbol { symbol, label, references } => {
                self.symbol(element, *symbol, at, leaves);
                let middle = (at.x + end) / 2;
                self.label(element, label, Point { x: middle, y: at.y - 1 }, Style::Name);
                self.references(element, references, Point { x: middle, y: at.y + 1 }, false);
            }
            Kind::Formula { lines, values, references, .. } => {
                let bottom = at.y + (lines.len() + values.len()) as i32;
                let middle = self.boxed(Some(element), (at, leaves), bottom);
                self.leads(node, at, leaves);
                let x = middle - (formula_width(lines, values) - 1) / 2;
                for (line, y) in lines.iter().zip(at.y..) {
                    self.text(element, line, Point { x, y }, Align::Start, Style::Value);
                }
                for (value, y) in values.iter().enumerate().zip(at.y + lines.len() as i32..) {
                    let (reading, &width) = value;
                    let at = Point { x, y };
                    self.reading(element, (reading, width), at, Align::Start, Form::Named);
                }
                self.references(element, references, Point { x: middle, y: bottom + 1 }, true);
            }
            Kind::Elsewhere { mark, .. } => {
                let middle = self.boxed(None, (at, leaves), at.y + 1);
                self.leads(node, at, leaves);
                self.mark(mark, Point { x: middle, ..at }, Align::Middle);
            }
            Kind::List(branches) => self.list(element, branches, at, end, to_rail),
            Kind::Call(call) => call.place(element, at, end, self),
            Kind::Net(net) => net.place(element, at, end, self),
        }
    }

    /// The signs of a contact or coil around the middle of its wire.
    fn symbol(&mut self, element: ElementId, symbol: Symbol, at: Point, leaves: Point) {
        let middle = Point { x: (at.x + leaves.x) / 2, ..at };
        let left = middle.x - symbol.span() / 2;
        self.wire(at, Point { x: left, ..at }, Power::Into(element));
        self.wire(Point { x: left + symbol.span(), ..at }, leaves, Power::OutOf(element));
        self.part(Some(element), Shape::Symbol { at: middle, symbol });
    }

    /// A frame around a wire, from the row above it down to `bottom`; returns the column of its
    /// middle.
    fn boxed(&mut self, element: Option<ElementId>, wire: (Point, Point), bottom: i32) -> i32 {
        let (left, right) = (wire.0.x + LEAD, wire.1.x - LEAD);
        let upper = Point { x: left, y: wire.0.y - 1 };
        self.frame(element, upper, Point { x: right, y: bottom });
        (left + right) / 2
    }

    /// The wires that lead to a frame and away from it.
    fn leads(&mut self, node: &Node, at: Point, leaves: Point) {
        self.wire(at, Point { x: at.x + LEAD, ..at }, node.entry());
        self.wire(Point { x: leaves.x - LEAD, ..at }, leaves, node.exit());
    }

    fn list(
        &mut self,
        element: ElementId,
        branches: &[Series],
        at: Point,
        end: i32,
        to_rail: bool,
    ) {
        let left = at.x + JOIN;
        let right = if to_rail { end } else { end - JOIN };
        let rows = branch_rows(branches);
        for (branch, row) in branches.iter().zip(&rows) {
            self.series(branch, Point { x: left, y: at.y + row }, right - left, to_rail);
        }
        let last = at.y + rows.last().copied().unwrap_or(0);
        self.wire(at, Point { x: left, ..at }, Power::Into(element));
        self.wire(Point { x: left, ..at }, Point { x: left, y: last }, Power::Into(element));
        if !to_rail {
            let exits = branches.iter().zip(&rows).map(|(branch, row)| at.y + row + branch.exit);
            let lowest = exits.max().unwrap_or(at.y);
            let upper = Point { x: right, ..at };
            self.wire(upper, Point { x: right, y: lowest }, Power::OutOf(element));
            self.wire(upper, Point { x: end, ..at }, Power::OutOf(element));
        }
    }
}

/// How many cells of a text are left of the cell that it is aligned with.
fn left_of(width: i32, align: Align) -> i32 {
    match align {
        Align::Start => 0,
        Align::Middle => width / 2,
        Align::End => width - 1,
    }
}
