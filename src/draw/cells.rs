//! A drawing on a grid of character cells, before anybody knows whether it becomes text or SVG.
//!
//! A wire runs from the middle of a cell to the middle of another one in the same row or column.
//! Rows count downwards from the top of a rung, columns from its left rail.

use super::references::References;
use super::words::{harmless, shortened, width};
use crate::eval::Reading;

/// Columns of a name beside a value.
const LONGEST_NAME: i32 = 20;

/// A cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Point {
    /// Column, from 0 at the left rail.
    pub x: i32,
    /// Row, from 0 at the top of the rung.
    pub y: i32,
}

/// An element of a rung by its number in text order, from 0. A list comes before what is in it, a
/// block before the elements of its arguments.
pub type ElementId = u32;

/// Where the power of a wire is known from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Power {
    /// It is what arrives at the element.
    Into(ElementId),
    /// It is what the element lets pass.
    OutOf(ElementId),
    /// It is the power of the left rail.
    Rail,
    /// It is that of a node of a general network: of the left end of one of its connections, or
    /// of the right end.
    Node {
        /// The network.
        net: ElementId,
        /// The connection, from 0 in text order.
        connection: usize,
        /// 0 for the left end, 1 for the right end.
        end: usize,
    },
    /// It is no power: the wire brings a value.
    Value,
}

/// One thing that is drawn.
#[derive(Clone, Debug)]
pub struct Part {
    /// The element that it shows; a wire belongs to none.
    pub element: Option<ElementId>,
    /// What it looks like.
    pub shape: Shape,
}

/// What is drawn.
#[derive(Clone, Debug)]
pub enum Shape {
    /// A wire along a row or a column; `from` is left of or above `to`.
    Wire {
        /// One end.
        from: Point,
        /// The other end.
        to: Point,
        /// What flows in it.
        power: Power,
    },
    /// A power rail.
    Rail {
        /// Its column.
        x: i32,
        /// Its first row.
        top: i32,
        /// Its last row.
        bottom: i32,
    },
    /// A contact or a coil, three cells wide around its middle.
    Symbol {
        /// Its middle.
        at: Point,
        /// What it is.
        symbol: Symbol,
    },
    /// A frame through the middles of its corner cells. One that shows no element stands for what
    /// is drawn further down.
    Frame {
        /// The corner at the upper left.
        from: Point,
        /// The corner at the lower right.
        to: Point,
    },
    /// A line of text.
    Text(Text),
    /// The rungs that have to do with an element.
    References {
        /// The first cell.
        at: Point,
        /// The rungs.
        references: References,
        /// Below a frame, not below a wire.
        below_frame: bool,
    },
    /// The head of an arrow to the right, or to both sides.
    Arrow {
        /// Its cell.
        at: Point,
        /// A connection that conducts to the left too.
        both_ways: bool,
        /// What flows in it.
        power: Power,
    },
    /// A node of a general network.
    Dot {
        /// Its cell.
        at: Point,
        /// The node.
        power: Power,
    },
    /// Room for a value of the scan that is shown.
    Reading {
        /// The first cell.
        at: Point,
        /// How many cells it takes at most.
        width: i32,
        /// Its place in [`Seen::readings`](crate::eval::Seen::readings) of the element.
        reading: usize,
        /// How it is written.
        form: Form,
        /// Which end stays where it is, if it takes less.
        align: Align,
    },
}

/// How a value is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// `name = 7`
    Named,
    /// `= 7`
    Equal,
    /// `7`
    Alone,
}

impl Form {
    /// A value in this form.
    pub fn written(self, reading: &Reading) -> String {
        let Reading { name, text, .. } = reading;
        match self {
            Form::Named => format!("{} = {text}", shortened(&harmless(name), LONGEST_NAME)),
            Form::Equal => format!("= {text}"),
            Form::Alone => text.clone(),
        }
    }

    /// How many cells the widest value takes.
    pub(super) fn room(self, reading: &Reading) -> i32 {
        let before = width(&self.written(reading)) - width(&reading.text);
        before + reading.room as i32
    }
}

/// What stands between two bars or two brackets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Symbol {
    /// A contact with this sign in it: a blank, `/`, `P` or `N`.
    Contact(&'static str),
    /// A coil with this sign in it: a blank, `/`, `S`, `R`, `P` or `N`.
    Coil(&'static str),
    /// What acts on the power: a word between two bars.
    Operator(&'static str),
}

impl Symbol {
    /// How many cells lie between its left and its right end.
    pub fn span(self) -> i32 {
        match self {
            Symbol::Contact(_) | Symbol::Coil(_) => 2,
            Symbol::Operator(word) => word.len() as i32 + 1,
        }
    }
}

/// A line of text in one row.
#[derive(Clone, Debug)]
pub struct Text {
    /// The first cell.
    pub at: Point,
    /// How many cells it takes.
    pub width: i32,
    /// The text, with nothing in it that acts on a terminal or a browser.
    pub text: String,
    /// What it is.
    pub style: Style,
    /// Which end stays where it is, if a font is narrower than its cells.
    pub align: Align,
}

/// What a text is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Style {
    /// A name that the program declares.
    Name,
    /// The name of a block, above its frame.
    Instance,
    /// An expression or a constant.
    Value,
    /// A kind of block.
    Kind,
    /// A pin of a block.
    Pin,
    /// What leads to another place of the drawing.
    Mark,
}

/// Which end of a text stays where it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Align {
    /// The left end.
    Start,
    /// The middle.
    Middle,
    /// The right end.
    End,
}
