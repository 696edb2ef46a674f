//! Displays what a net computes in either language: parentheses where needed, and lines of
//! bearable length.

use std::fmt::{self, Write};
use std::marker::PhantomData;

use super::module::Module;
use super::plan::Form;
use crate::circuit::Net;

/// The columns that a line should not exceed.
const LINE: usize = 100;
/// The indent of the lines that go on with an expression.
const INDENT: usize = 6;
/// The indent that no nesting exceeds.
const DEEPEST_INDENT: usize = 60;

/// How tightly an operator binds, from loose to tight.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Level {
    /// What cannot be misread: the outside, or between brackets.
    Free,
    /// The condition of a choice.
    Condition,
    /// Or.
    Or,
    /// Exclusive or.
    Xor,
    /// And.
    And,
    /// Comparison.
    Compare,
    /// Sum and difference, and putting vectors side by side.
    Sum,
    /// Inversion.
    Not,
    /// A name, a number, a call.
    Atom,
}

/// How an operand stands in an expression.
#[derive(Clone, Copy, Debug)]
pub enum Place {
    /// As the operand of an operator of that level.
    Inside(Level),
    /// As a number next to another one, in two's complement or unsigned.
    Number {
        /// In two's complement.
        signed: bool,
    },
}

/// What the languages differ in, as far as expressions go.
pub trait Dialect: Sized {
    /// What stands at an instance's output that nobody reads.
    const OPEN: &'static str;
    /// What converts a word to the type of the program's own ports, if they have another.
    const PORT_CONVERSION: Option<&'static str>;
    /// The columns in front of the expression that is assigned to a wire.
    fn lead(name: &str, width: u32) -> usize;
    /// How tightly the outermost operator of a form binds.
    fn level(module: &Module<'_>, net: Net, form: Form) -> Level;
    /// True if an expression needs parentheses where it is an operand.
    fn needs_parentheses(outer: Level, inner: Level) -> bool;
    /// Prints what the cell of a net computes.
    fn definition<W: Write>(
        printer: &mut Printer<'_, W, Self>,
        net: Net,
        form: Form,
    ) -> fmt::Result;
    /// Prints a net that has a name, or a constant.
    fn leaf<W: Write>(printer: &mut Printer<'_, W, Self>, net: Net) -> fmt::Result;
    /// Prints an operand of arithmetic or of a comparison.
    fn number<W: Write>(printer: &mut Printer<'_, W, Self>, net: Net, signed: bool) -> fmt::Result;
}

/// The value of a net; as the right side of an assignment with the space or the line break in
/// front of it.
pub struct Value<'a, D> {
    module: &'a Module<'a>,
    net: Net,
    /// Where the text in front of it ends, if it is the right side of an assignment.
    column: Option<usize>,
    defines: bool,
    converts: bool,
    dialect: PhantomData<D>,
}

impl<'a, D: Dialect> Value<'a, D> {
    /// An assignment of what the cell of a net computes; the text in front ends at that column.
    pub fn definition(module: &'a Module<'a>, net: Net, column: usize) -> Self {
        let column = Some(column);
        Value { module, net, column, defines: true, converts: false, dialect: PhantomData }
    }

    /// An assignment of a net by its name, or of what it computes where it has none.
    pub fn assigned(module: &'a Module<'a>, net: Net, column: usize) -> Self {
        Value { defines: module.is_inline(net), ..Self::definition(module, net, column) }
    }

    /// An assignment to an output port.
    pub fn shown(module: &'a Module<'a>, net: Net, column: usize) -> Self {
        let converts = module.is_top && module.circuit.width(net) > 1;
        Value { converts, ..Self::assigned(module, net, column) }
    }

    /// A net that has a name, or a constant.
    pub fn leaf(module: &'a Module<'a>, net: Net) -> Self {
        Value { column: None, defines: false, ..Self::definition(module, net, 0) }
    }
}

impl<D: Dialect> fmt::Display for Value<'_, D> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut printer = Printer::flat(self.module, f);
        let Some(column) = self.column else { return D::leaf(&mut printer, self.net) };
        if !self.defines {
            printer.text(" ")?;
            let Some(conversion) = D::PORT_CONVERSION.filter(|_| self.converts) else {
                return D::leaf(&mut printer, self.net);
            };
            write!(printer, "{conversion}(")?;
            D::leaf(&mut printer, self.net)?;
            return printer.text(")");
        }
        // One column each for the space in front and the semicolon.
        let room = LINE.saturating_sub(column + 2);
        let form = self.module.form(self.net);
        let mut line = Printer::flat(self.module, Line { text: String::with_capacity(LINE), room });
        if D::definition(&mut line, self.net, form).is_ok() {
            printer.text(" ")?;
            return printer.text(&line.out.text);
        }
        printer.indent = Some(INDENT);
        printer.new_line(INDENT)?;
        D::definition(&mut printer, self.net, form)
    }
}

/// Writes one expression.
pub struct Printer<'a, W, D> {
    /// The module that the nets belong to.
    pub module: &'a Module<'a>,
    out: W,
    column: usize,
    /// Where lines go on, if the expression may be broken.
    indent: Option<usize>,
    /// Nothing of the expression is written yet.
    pub begins: bool,
    dialect: PhantomData<D>,
}

impl<'a, W: Write, D: Dialect> Printer<'a, W, D> {
    fn flat(module: &'a Module<'a>, out: W) -> Self {
        Printer { module, out, column: 0, indent: None, begins: true, dialect: PhantomData }
    }

    /// Writes text as it is.
    pub fn text(&mut self, text: &str) -> fmt::Result {
        self.column += text.len();
        self.out.write_str(text)
    }

    fn new_line(&mut self, indent: usize) -> fmt::Result {
        self.column = indent;
        write!(self.out, "\n{:indent$}", "")
    }

    /// Writes a part that the line may be broken in front of: an operator and its right operand.
    pub fn item(&mut self, before: &str, net: Net, place: Place, after: &str) -> fmt::Result {
        let begins = std::mem::replace(&mut self.begins, false);
        let mut broken = None;
        match self.indent {
            None if begins => {}
            None => self.text(" ")?,
            Some(indent) => {
                if !begins && self.fits(self.column + 1, before, net, place, after) {
                    self.text(" ")?;
                } else if !begins {
                    self.new_line(indent)?;
                }
                if !self.fits(self.column, before, net, place, after) {
                    broken = Some((self.column + before.len() + 1).min(DEEPEST_INDENT));
                }
            }
        }
        self.text(before)?;
        let indent = std::mem::replace(&mut self.indent, broken);
        self.operand(net, place)?;
        self.indent = indent;
        self.text(after)?;
        if broken.is_some() {
            // What follows an operand of several lines begins a line.
            self.column = LINE;
        }
        Ok(())
    }

    /// Writes a part without an operand.
    pub fn word(&mut self, word: &str) -> fmt::Result {
        let begins = std::mem::replace(&mut self.begins, false);
        match self.indent {
            _ if begins => {}
            Some(indent) if self.column + 1 + word.len() > LINE - 2 => self.new_line(indent)?,
            _ => self.text(" ")?,
        }
        self.text(word)
    }

    fn fits(&self, column: usize, before: &str, net: Net, place: Place, after: &str) -> bool {
        // Two columns for what may close the expression.
        let Some(room) = (LINE - 2).checked_sub(column + before.len() + after.len()) else {
            return false;
        };
        let mut ruler: Printer<'_, Ruler, D> = Printer::flat(self.module, Ruler { room });
        ruler.operand(net, place).is_ok()
    }

    /// Writes a net as an operand.
    pub fn operand(&mut self, net: Net, place: Place) -> fmt::Result {
        let outer = match place {
            Place::Inside(outer) => outer,
            Place::Number { signed } => return D::number(self, net, signed),
        };
        if !self.module.is_inline(net) {
            return D::leaf(self, net);
        }
        let form = self.module.form(net);
        let parentheses = D::needs_parentheses(outer, D::level(self.module, net, form));
        let begins = std::mem::replace(&mut self.begins, true);
        if parentheses {
            self.text("(")?;
        }
        D::definition(self, net, form)?;
        if parentheses {
            self.text(")")?;
        }
        self.begins = begins;
        Ok(())
    }

    /// Writes operands with one operator between them, and what has the same operator inside
    /// them in the same row.
    pub fn chain(&mut self, operator: &str, level: Level, operands: &[Net]) -> fmt::Result {
        for &operand in operands {
            let form = self.module.is_inline(operand).then(|| self.module.form(operand));
            match (form, level) {
                (Some(Form::And(inner)), Level::And) | (Some(Form::Or(inner)), Level::Or) => {
                    self.chain(operator, level, self.module.circuit.list(inner))?;
                }
                (Some(Form::Xor(a, b)), Level::Xor) => self.chain(operator, level, &[a, b])?,
                _ => {
                    let before = if self.begins { "" } else { operator };
                    self.item(before, operand, Place::Inside(level), "")?;
                }
            }
        }
        Ok(())
    }
}

impl<W: Write, D> Write for Printer<'_, W, D> {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.column += text.len();
        self.out.write_str(text)
    }
}

/// Keeps text as long as there is room.
struct Line {
    text: String,
    room: usize,
}

impl Write for Line {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.room = self.room.checked_sub(text.len()).ok_or(fmt::Error)?;
        self.text.push_str(text);
        Ok(())
    }
}

/// Measures text as long as there is room.
struct Ruler {
    room: usize,
}

impl Write for Ruler {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.room = self.room.checked_sub(text.len()).ok_or(fmt::Error)?;
        Ok(())
    }
}
