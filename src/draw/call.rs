//! A block as a box with its pins.

use super::cells::{Align, ElementId, Form, Point, Power, Style};
use super::node::{LEAD, Node, Series, Size, widest};
use super::place::Placer;
use super::references::References;
use super::words::width;

/// Columns at the left of a box where nothing is drawn but its wire.
const LEAST_LEFT: i32 = 3;

/// A block as it is drawn.
pub(super) struct Call {
    /// The instance's name, over the box.
    pub name: Vec<String>,
    /// The kind, inside at the top.
    pub kind: String,
    /// The pins at the left, below the one for the power.
    pub inputs: Vec<Input>,
    /// The pin that the power leaves by, if it has a name.
    pub main: String,
    /// The other pins at the right.
    pub outputs: Vec<Output>,
    /// Who reads its members.
    pub references: References,
}

/// A pin at the left.
pub(super) struct Input {
    pub name: String,
    pub fed: Fed,
    /// Its value, in a row below what it is given.
    pub value: Option<Room>,
}

/// A pin at the right.
pub(super) struct Output {
    pub name: String,
    pub value: Option<Room>,
}

/// The room of a value: its place among those of the element, and its columns.
pub(super) type Room = (usize, i32);

/// What a pin is given.
pub(super) enum Fed {
    /// Nothing.
    Open,
    /// An expression.
    Value(Vec<String>),
    /// A circuit that starts at a rail of its own.
    Circuit(Series),
    /// A circuit that is drawn further down, under this mark, and the power that it lets out.
    Elsewhere(String, Power),
}

impl Input {
    /// The room that it takes at the left of the box.
    fn size(&self) -> Size {
        let value = self.value.map_or(0, |(_, width)| width + 3);
        match &self.fed {
            Fed::Open => Size { width: value, above: 0, below: 0 },
            Fed::Value(lines) => {
                let width = (widest(lines) + 3).max(value);
                Size { width, above: 0, below: lines.len() as i32 - 1 + self.value_row() }
            }
            Fed::Circuit(series) => Size { width: series.size.width + 1, ..series.size },
            Fed::Elsewhere(mark, _) => Size { width: width(mark) + 4, above: 0, below: 0 },
        }
    }

    /// Rows that its value takes below what it is given.
    fn value_row(&self) -> i32 {
        i32::from(self.value.is_some() && matches!(self.fed, Fed::Value(_)))
    }
}

/// The name of the pin that the power enters by.
const POWER: &str = "IN";

impl Call {
    /// Column of the left side of the box, and of its right side.
    fn sides(&self) -> (i32, i32) {
        let fed = self.inputs.iter().map(|input| input.size().width).max().unwrap_or(0);
        let inputs = self.inputs.iter().map(|input| width(&input.name)).max().unwrap_or(0);
        let outputs = self.outputs.iter().map(|output| width(&output.name)).max().unwrap_or(0);
        let outputs = outputs.max(width(&self.main));
        let pins = inputs.max(width(POWER)) + 3 + outputs;
        let is_fed_beside = |input: &Input| matches!(input.fed, Fed::Circuit(_));
        // A circuit may reach further down than the box: nothing under it stands out to the left.
        let under = match self.inputs.iter().any(is_fed_beside) {
            true => width(&self.references.to_string()) - 1,
            false => 0,
        };
        let inner = pins.max(width(&self.kind) + 4).max(under);
        let inner = inner + (inner + 1) % 2;
        let half = self.above_and_below_the_box() / 2 + 1;
        let left = fed.max(LEAST_LEFT).max(half - inner / 2);
        (left, left + inner + 1)
    }

    fn above_and_below_the_box(&self) -> i32 {
        widest(&self.name).max(width(&self.references.to_string()))
    }

    /// The row of each pin at the left, below that of the power.
    fn input_rows(&self) -> Vec<i32> {
        let mut free = 1;
        let row = |input: &Input| {
            let size = input.size();
            let row = free + size.above;
            free = row + size.below + 1;
            row
        };
        self.inputs.iter().map(row).collect()
    }

    /// The row of the lower side of the box.
    fn bottom(&self) -> i32 {
        let value_lines = |input: &Input| match &input.fed {
            Fed::Value(_) => input.size().below,
            _ => 0,
        };
        let rows = self.input_rows();
        let inputs = rows.iter().zip(&self.inputs).map(|(row, input)| row + value_lines(input));
        inputs.max().unwrap_or(0).max(self.outputs.len() as i32) + 1
    }

    pub fn size(&self) -> Size {
        let (left, right) = self.sides();
        let outside = self.above_and_below_the_box() / 2 - (right - left) / 2;
        let rows = self.input_rows();
        let fed = rows.iter().zip(&self.inputs).map(|(row, input)| row + input.size().below);
        let box_and_references = self.bottom() + i32::from(!self.references.is_empty());
        Size {
            width: right + LEAD.max(outside + 1).max(self.values_width()),
            above: 2 + self.name.len() as i32,
            below: fed.max().unwrap_or(0).max(box_and_references),
        }
    }

    /// Columns at the right of the box that the values of its pins take.
    fn values_width(&self) -> i32 {
        let widths = self.outputs.iter().filter_map(|output| output.value).map(|(_, width)| width);
        widths.max().map_or(0, |width| width + 3)
    }

    /// How much wider its circuits make it.
    pub fn circuits_width(&self) -> i32 {
        let widths = self.inputs.iter().filter_map(|input| match &input.fed {
            Fed::Circuit(series) => Some(series.size.width + 1),
            _ => None,
        });
        widths.max().unwrap_or(0)
    }

    pub fn into_node(self, element: ElementId) -> Node {
        let size = self.size();
        Node { element, kind: super::node::Kind::Call(Box::new(self)), size }
    }

    pub fn place(&self, element: ElementId, at: Point, end: i32, placer: &mut Placer) {
        let (left, right) = self.sides();
        let (left, right) = (at.x + left, at.x + right);
        let middle = (left + right) / 2;
        let cell = |x, y| Point { x, y: at.y + y };
        placer.wire(at, cell(left, 0), Power::Into(element));
        placer.wire(cell(right, 0), cell(end, 0), Power::OutOf(element));
        placer.frame(Some(element), cell(left, -2), cell(right, self.bottom()));
        placer.label(element, &self.name, cell(middle, -3), Style::Instance);
        placer.text(element, &self.kind, cell(middle, -1), Align::Middle, Style::Kind);
        placer.text(element, POWER, cell(left + 1, 0), Align::Start, Style::Pin);
        placer.text(element, &self.main, cell(right - 1, 0), Align::End, Style::Pin);
        for (output, row) in self.outputs.iter().zip(1..) {
            placer.text(element, &output.name, cell(right - 1, row), Align::End, Style::Pin);
            if let Some(value) = output.value {
                placer.reading(element, value, cell(right + 2, row), Align::Start, Form::Alone);
            }
        }
        for (input, row) in self.inputs.iter().zip(self.input_rows()) {
            placer.text(element, &input.name, cell(left + 1, row), Align::Start, Style::Pin);
            feed(input, element, cell(left, row), placer);
        }
        placer.references(element, &self.references, cell(middle, self.bottom() + 1), true);
    }
}

/// Draws what a pin is given, up to the side of the box.
fn feed(input: &Input, element: ElementId, pin: Point, placer: &mut Placer) {
    let left_by = |columns| Point { x: pin.x - columns, ..pin };
    let mut below = pin.y;
    match &input.fed {
        Fed::Open => {}
        Fed::Value(lines) => {
            placer.wire(left_by(1), pin, Power::Value);
            for (line, row) in lines.iter().zip(0..) {
                let end = Point { x: pin.x - 2, y: pin.y + row };
                placer.text(element, line, end, Align::End, Style::Value);
            }
            below += lines.len() as i32;
        }
        Fed::Circuit(series) => {
            let start = left_by(series.size.width);
            placer.stub(start);
            placer.series(series, start, series.size.width, false);
        }
        Fed::Elsewhere(mark, power) => {
            placer.wire(left_by(2), pin, *power);
            placer.arrow(left_by(2), false, *power);
            placer.text(element, mark, left_by(3), Align::End, Style::Mark);
        }
    }
    if let Some(value) = input.value {
        let end = Point { x: pin.x - 2, y: below };
        placer.reading(element, value, end, Align::End, Form::Equal);
    }
}
