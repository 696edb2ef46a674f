//! Prints Verilog-2005.

use std::fmt::{self, Write};

use askama::Template;

use super::comment::Harmless;
use super::expression::{Dialect, Level, Place, Printer};
use super::module::Module;
use super::plan::{Form, Relation};
use super::view::{Declared, Part, Port, Statement, Stored, View};
use super::{Header, Options, header};
use crate::circuit::{Net, as_signed};

/// The words of Verilog.
struct Verilog;

#[derive(Template)]
#[template(path = "module.v", escape = "none")]
struct File<'a> {
    modules: &'a [Module<'a>],
    header: Header<'a>,
}

/// One file with all modules.
pub fn print(modules: &[Module<'_>], options: &Options) -> String {
    super::render(&File { modules, header: header(options) }, modules)
}

impl File<'_> {
    /// The warnings that Verilator gives for what is meant so, and the reason.
    fn waivers(&self) -> Vec<(&'static str, &'static str)> {
        let open = self.modules.iter().any(|module| module.has_open_outputs(self.modules));
        let cpp = self.modules.iter().any(Module::has_cpp_words);
        [
            (self.modules.len() > 1, "DECLFILENAME", "The blocks stand in the program's file."),
            (open, "PINCONNECTEMPTY", "Outputs of blocks that nobody reads are left open."),
            (cpp, "SYMRSVDWORD", "Names are the program's own, words of C++ among them."),
        ]
        .into_iter()
        .filter_map(|(given, warning, reason)| given.then_some((warning, reason)))
        .collect()
    }

    fn views(&self) -> impl Iterator<Item = View<'_, Verilog>> {
        View::all(self.modules)
    }
}

impl<'a> View<'a, Verilog> {
    fn edges(&self) -> String {
        let reset = self.module.reset;
        let more = if reset.is_async() { " or negedge rst_n" } else { "" };
        format!("posedge clk{more}")
    }

    fn is_reset(&self) -> &'static str {
        if self.module.reset.is_low() { "!rst_n" } else { "rst" }
    }

    fn range_width(&self) -> usize {
        self.ports().iter().map(|port| Range(port.width).to_string().len()).max().unwrap_or(0)
    }

    fn unread(&self) -> Option<Unread<'a>> {
        let names = self.module.unread(self.modules);
        (!names.is_empty()).then(|| Unread { wire: self.module.unused(), names })
    }
}

/// A wire that reads what nothing else does.
struct Unread<'a> {
    wire: &'a str,
    names: Vec<&'a str>,
}

impl fmt::Display for Unread<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "wire {} = &{{1'b0", self.wire)?;
        let mut column = "  wire  = &{1'b0".len() + self.wire.len();
        for name in &self.names {
            f.write_char(',')?;
            column += name.len() + 2;
            if column > 96 {
                f.write_str("\n     ")?;
                column = 6 + name.len();
            }
            write!(f, " {name}")?;
        }
        f.write_str("};")
    }
}

impl Port<'_> {
    fn direction(&self) -> &'static str {
        if self.is_input { "input " } else { "output" }
    }

    fn padded_range(&self, columns: &usize) -> String {
        format!("{:<columns$}", Range(self.width).to_string())
    }
}

impl Declared<'_> {
    fn range(&self) -> Range {
        Range(self.width)
    }
}

impl Stored<'_, Verilog> {
    fn range(&self) -> Range {
        Range(self.width)
    }

    fn start(&self) -> Number {
        Number::new(self.reset, self.width)
    }
}

impl Part<'_> {
    fn verilog(&self) -> String {
        match (self.low, self.width) {
            (None, _) => self.name.to_owned(),
            (Some(low), 1) => format!("{}[{low}]", self.name),
            (Some(low), width) => format!("{}[{}:{low}]", self.name, low + width - 1),
        }
    }
}

/// The range of a declaration with the space behind it; nothing for a single bit.
pub struct Range(pub u32);

impl fmt::Display for Range {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.0 == 1 { Ok(()) } else { write!(f, "[{}:0] ", self.0 - 1) }
    }
}

/// A sized number: decimal, or hexadecimal where it uses the top bit of a word of 8, 16, 32 or 64
/// bits. Such a word is a pattern or a number below 0; words of other widths were cut to fit.
pub struct Number {
    bits: u64,
    width: u32,
    signed: bool,
}

impl Number {
    /// An unsigned number.
    pub fn new(bits: u64, width: u32) -> Self {
        Number { bits, width, signed: false }
    }
}

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let &Number { bits, width, signed } = self;
        let sign = if signed { "s" } else { "" };
        if width == 1 {
            write!(f, "1'{sign}b{bits}")
        } else if bits >> (width - 1) == 0 || !signed && !matches!(width, 8 | 16 | 32 | 64) {
            write!(f, "{width}'{sign}d{bits}")
        } else if signed && bits.trailing_zeros() < width - 1 {
            // The lowest number has no opposite to put a minus before.
            write!(f, "-{width}'sd{}", as_signed(bits, width).unsigned_abs())
        } else {
            write!(f, "{width}'{sign}h{bits:x}")
        }
    }
}

impl Dialect for Verilog {
    const OPEN: &'static str = "";
    const PORT_CONVERSION: Option<&'static str> = None;

    fn lead(name: &str, width: u32) -> usize {
        let range = if width == 1 { 0 } else { "[:0] ".len() + (width - 1).ilog10() as usize + 1 };
        "  wire  =".len() + range + name.len()
    }

    fn level(_: &Module<'_>, _: Net, form: Form) -> Level {
        match form {
            Form::Leaf | Form::Extend(..) | Form::Slice(..) | Form::Concat(_) => Level::Atom,
            Form::Not(_) => Level::Not,
            Form::And(_) | Form::Above(..) => Level::And,
            Form::Or(_) => Level::Or,
            Form::Xor(..) => Level::Xor,
            Form::Choice(..) | Form::Quotient(..) | Form::Rest(..) => Level::Free,
            Form::Sum(..) | Form::Difference(..) | Form::Product(..) => Level::Sum,
            Form::Compare(..) => Level::Compare,
        }
    }

    fn needs_parentheses(outer: Level, inner: Level) -> bool {
        match outer {
            // Not needed, but nobody knows by heart.
            Level::Condition => inner < Level::Not,
            // The language has no operator directly behind another.
            Level::Not => inner <= Level::Not,
            _ => inner < outer,
        }
    }

    fn definition<W: Write>(
        printer: &mut Printer<'_, W, Self>,
        net: Net,
        form: Form,
    ) -> fmt::Result {
        let circuit = printer.module.circuit;
        match form {
            Form::Leaf => printer.constant(net, false),
            Form::Not(from) => printer.item("~", from, Place::Inside(Level::Not), ""),
            Form::And(operands) => printer.chain("& ", Level::And, circuit.list(operands)),
            Form::Or(operands) => printer.chain("| ", Level::Or, circuit.list(operands)),
            Form::Xor(a, b) => printer.chain("^ ", Level::Xor, &[a, b]),
            Form::Above(a, b) => {
                printer.item("~", a, Place::Inside(Level::Not), "")?;
                printer.item("& ", b, Place::Inside(Level::And), "")
            }
            Form::Sum(a, b) => printer.chain("+ ", Level::Sum, &[a, b]),
            Form::Difference(a, b) => printer.chain("- ", Level::Sum, &[a, b]),
            Form::Product(a, b) => printer.chain("* ", Level::Sum, &[a, b]),
            Form::Quotient(a, b) => printer.divided("/ ", a, b),
            Form::Rest(a, b) => printer.divided("% ", a, b),
            Form::Choice(select, on, off) => {
                printer.item("", select, Place::Inside(Level::Condition), "")?;
                printer.item("? ", on, Place::Inside(Level::Or), "")?;
                printer.item(": ", off, Place::Inside(Level::Or), "")
            }
            Form::Compare(relation, a, b) => {
                let (operator, signed) = match relation {
                    Relation::Equal => ("== ", false),
                    Relation::Unequal => ("!= ", false),
                    Relation::Less(signed) => ("< ", signed),
                    Relation::AtLeast(signed) => (">= ", signed),
                    Relation::Greater(signed) => ("> ", signed),
                    Relation::AtMost(signed) => ("<= ", signed),
                };
                printer.item("", a, Place::Number { signed }, "")?;
                printer.item(operator, b, Place::Number { signed }, "")
            }
            Form::Extend(from, signed) => extend(printer, from, circuit.width(net), signed),
            Form::Concat(operands) => {
                printer.text("{")?;
                let (last, others) = circuit.list(operands).split_last().expect("it has parts");
                for &part in others {
                    printer.item("", part, Place::Inside(Level::Free), ",")?;
                }
                printer.item("", *last, Place::Inside(Level::Free), "}")
            }
            Form::Slice(from, low) => {
                Self::leaf(printer, from)?;
                match (circuit.width(from), circuit.width(net)) {
                    (1, _) => Ok(()),
                    (_, 1) => write!(printer, "[{low}]"),
                    (_, width) => write!(printer, "[{}:{low}]", low + width - 1),
                }
            }
        }
    }

    fn leaf<W: Write>(printer: &mut Printer<'_, W, Self>, net: Net) -> fmt::Result {
        match printer.module.name_of(net) {
            Some(name) => printer.text(name),
            None => printer.constant(net, false),
        }
    }

    fn number<W: Write>(printer: &mut Printer<'_, W, Self>, net: Net, signed: bool) -> fmt::Result {
        let module = printer.module;
        if !signed {
            return printer.operand(net, Place::Inside(Level::Sum));
        }
        if module.name_of(net).is_none() && module.circuit.constant_value(net).is_some() {
            return printer.constant(net, true);
        }
        printer.text("$signed(")?;
        printer.operand(net, Place::Inside(Level::Free))?;
        printer.text(")")
    }
}

impl<W: Write> Printer<'_, W, Verilog> {
    /// A division; by 0 it gives 0.
    fn divided(&mut self, operator: &str, a: Net, b: Net) -> fmt::Result {
        let (width, sum) = (self.module.circuit.width(a), Place::Inside(Level::Sum));
        let mut before = "";
        if self.module.circuit.constant_value(b).is_none() {
            let zero = Number::new(0, width);
            self.item("", b, sum, "")?;
            self.word(&format!("== {zero}"))?;
            self.word(&format!("? {zero}"))?;
            before = ": ";
        }
        self.item(before, a, sum, "")?;
        self.item(operator, b, sum, "")
    }

    fn constant(&mut self, net: Net, signed: bool) -> fmt::Result {
        let circuit = self.module.circuit;
        let bits = circuit.constant_value(net).expect("a net without a name is a constant");
        write!(self, "{}", Number { bits, width: circuit.width(net), signed })
    }
}

fn extend<W: Write>(
    printer: &mut Printer<'_, W, Verilog>,
    from: Net,
    width: u32,
    signed: bool,
) -> fmt::Result {
    let old = printer.module.circuit.width(from);
    match (signed, old) {
        (false, _) => write!(printer, "{{{}'b0, ", width - old)?,
        (true, 1) => {
            write!(printer, "{{{width}{{")?;
            printer.operand(from, Place::Inside(Level::Free))?;
            return printer.text("}}");
        }
        (true, _) => {
            write!(printer, "{{{{{}{{", width - old)?;
            Verilog::leaf(printer, from)?;
            write!(printer, "[{}]}}}}, ", old - 1)?;
        }
    }
    printer.operand(from, Place::Inside(Level::Free))?;
    printer.text("}")
}
