//! Prints VHDL-93. Words are `unsigned` inside; the program's own ports are `std_logic_vector`.

use std::fmt::{self, Write};

use askama::Template;

use super::comment::Harmless;
use super::expression::{Dialect, Level, Place, Printer};
use super::module::Module;
use super::plan::{Form, Relation};
use super::view::{Declared, Part, Port, Statement, Stored, View};
use super::{Header, Options, header};
use crate::circuit::{Net, as_signed};

/// A VHDL integer reaches to 2^31 - 1, but GHDL 2 refuses some literals right below it.
const LARGEST_DECIMAL: u64 = 1_999_999_999;

/// The words of VHDL.
struct Vhdl;

#[derive(Template)]
#[template(path = "entity.vhd", escape = "none")]
struct File<'a> {
    modules: &'a [Module<'a>],
    header: Header<'a>,
}

/// One file with all entities.
pub fn print(modules: &[Module<'_>], options: &Options) -> String {
    super::render(&File { modules, header: header(options) }, modules)
}

impl File<'_> {
    fn views(&self) -> impl Iterator<Item = View<'_, Vhdl>> {
        View::all(self.modules)
    }
}

impl View<'_, Vhdl> {
    fn port_width(&self) -> usize {
        self.ports().iter().map(|port| port.name.len()).max().unwrap_or(0)
    }

    fn port_type(&self, port: &Port<'_>) -> Type {
        if self.module.is_top { Type::Port(port.width) } else { Type::Inside(port.width) }
    }

    fn is_async(&self) -> bool {
        self.module.reset.is_async()
    }

    fn is_reset(&self) -> &'static str {
        if self.module.reset.is_low() { "rst_n = '0'" } else { "rst = '1'" }
    }
}

impl Port<'_> {
    fn mode(&self) -> &'static str {
        if self.is_input { "in " } else { "out" }
    }
}

impl Part<'_> {
    fn vhdl(&self) -> String {
        match (self.low, self.width) {
            (None, _) => self.name.to_owned(),
            (Some(low), 1) => format!("{}({low})", self.name),
            (Some(low), width) => format!("{}({} downto {low})", self.name, low + width - 1),
        }
    }

    /// As a signal inside has it.
    fn inside(&self) -> String {
        if self.width == 1 { self.vhdl() } else { format!("unsigned({})", self.vhdl()) }
    }
}

/// The type of a signal of that width.
pub enum Type {
    /// At the program's own ports.
    Port(u32),
    /// Everywhere else.
    Inside(u32),
}

impl fmt::Display for Type {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Type::Port(1) | Type::Inside(1) => f.write_str("std_logic"),
            Type::Port(width) => write!(f, "std_logic_vector({} downto 0)", width - 1),
            Type::Inside(width) => write!(f, "unsigned({} downto 0)", width - 1),
        }
    }
}

/// A constant.
pub struct Number {
    /// The bits.
    pub bits: u64,
    /// How many.
    pub width: u32,
}

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let &Number { bits, width } = self;
        let digits = width as usize;
        if width == 1 {
            write!(f, "'{bits}'")
        } else if bits <= LARGEST_DECIMAL
            && (bits >> (width - 1) == 0 || !matches!(width, 8 | 16 | 32 | 64))
        {
            write!(f, "to_unsigned({bits}, {width})")
        } else if width.is_multiple_of(4) {
            write!(f, "x\"{bits:0digits$X}\"", digits = digits / 4)
        } else {
            write!(f, "\"{bits:0digits$b}\"")
        }
    }
}

impl Declared<'_> {
    fn subtype(&self) -> Type {
        Type::Inside(self.width)
    }
}

impl Stored<'_, Vhdl> {
    fn subtype(&self) -> Type {
        Type::Inside(self.width)
    }

    fn start(&self) -> Reset {
        Reset(Number { bits: self.reset, width: self.width })
    }
}

/// What a register is reset to.
struct Reset(Number);

impl fmt::Display for Reset {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            Number { bits: 0, width: 2.. } => f.write_str("(others => '0')"),
            _ => self.0.fmt(f),
        }
    }
}

impl Dialect for Vhdl {
    const OPEN: &'static str = "open";
    const PORT_CONVERSION: Option<&'static str> = Some("std_logic_vector");

    fn lead(name: &str, _: u32) -> usize {
        "   <=".len() + name.len()
    }

    fn level(module: &Module<'_>, _: Net, form: Form) -> Level {
        match form {
            Form::Leaf | Form::Slice(..) => Level::Atom,
            Form::Extend(from, false) if module.circuit.width(from) == 1 => Level::Sum,
            Form::Extend(..) => Level::Atom,
            Form::Not(_) => Level::Not,
            Form::And(_) | Form::Above(..) => Level::And,
            Form::Or(_) => Level::Or,
            Form::Xor(..) => Level::Xor,
            Form::Choice(..) | Form::Quotient(..) | Form::Rest(..) => Level::Free,
            Form::Sum(..) | Form::Difference(..) | Form::Concat(_) => Level::Sum,
            Form::Product(..) => Level::Atom,
            Form::Compare(..) => Level::Free,
        }
    }

    /// The logical operators have one level and do not mix.
    fn needs_parentheses(outer: Level, inner: Level) -> bool {
        match inner {
            Level::Atom => false,
            Level::Not => outer >= Level::Compare,
            Level::Free
            | Level::Condition
            | Level::Or
            | Level::Xor
            | Level::And
            | Level::Compare
            | Level::Sum => outer != Level::Free && (outer != inner || inner == Level::Sum),
        }
    }

    fn definition<W: Write>(
        printer: &mut Printer<'_, W, Self>,
        net: Net,
        form: Form,
    ) -> fmt::Result {
        let circuit = printer.module.circuit;
        match form {
            Form::Leaf => printer.constant(net),
            Form::Not(from) => printer.item("not ", from, Place::Inside(Level::Not), ""),
            Form::And(operands) => printer.chain("and ", Level::And, circuit.list(operands)),
            Form::Or(operands) => printer.chain("or ", Level::Or, circuit.list(operands)),
            Form::Xor(a, b) => printer.chain("xor ", Level::Xor, &[a, b]),
            Form::Above(a, b) => {
                printer.item("not ", a, Place::Inside(Level::Not), "")?;
                printer.item("and ", b, Place::Inside(Level::And), "")
            }
            Form::Sum(a, b) => printer.chain_numbers("+ ", a, b),
            Form::Difference(a, b) => printer.chain_numbers("- ", a, b),
            Form::Product(a, b) => {
                printer.text("resize(")?;
                printer.item("", a, Place::Inside(Level::Sum), "")?;
                printer.item("* ", b, Place::Inside(Level::Sum), "")?;
                write!(printer, ", {})", circuit.width(net))
            }
            Form::Quotient(a, b) => printer.divided("/ ", a, b),
            Form::Rest(a, b) => printer.divided("rem ", a, b),
            Form::Choice(select, on, off) => {
                printer.item("", on, Place::Inside(Level::Free), "")?;
                printer.item("when ", select, Place::Inside(Level::Compare), " = '1'")?;
                printer.item("else ", off, Place::Inside(Level::Free), "")
            }
            Form::Compare(relation, a, b) => {
                let (operator, signed) = match relation {
                    Relation::Equal => ("= ", false),
                    Relation::Unequal => ("/= ", false),
                    Relation::Less(signed) => ("< ", signed),
                    Relation::AtLeast(signed) => (">= ", signed),
                    Relation::Greater(signed) => ("> ", signed),
                    Relation::AtMost(signed) => ("<= ", signed),
                };
                printer.item("'1' when ", a, Place::Number { signed }, "")?;
                printer.item(operator, b, Place::Number { signed }, "")?;
                printer.word("else '0'")
            }
            Form::Extend(from, signed) => printer.extend(from, circuit.width(net), signed),
            Form::Slice(from, low) => printer.slice(from, low, circuit.width(net)),
            Form::Concat(operands) => printer.chain("& ", Level::Sum, circuit.list(operands)),
        }
    }

    fn leaf<W: Write>(printer: &mut Printer<'_, W, Self>, net: Net) -> fmt::Result {
        match printer.module.name_of(net) {
            Some(name) if printer.module.is_vector_port(net) => {
                write!(printer, "unsigned({name})")
            }
            Some(name) => printer.text(name),
            None => printer.constant(net),
        }
    }

    fn number<W: Write>(printer: &mut Printer<'_, W, Self>, net: Net, signed: bool) -> fmt::Result {
        let module = printer.module;
        let width = module.circuit.width(net);
        match (module.circuit.constant_value(net), module.name_of(net)) {
            (Some(bits), None) if width > 1 => {
                let value = if signed { as_signed(bits, width) as i128 } else { bits.into() };
                // The width is that of the other side.
                if value.unsigned_abs() <= LARGEST_DECIMAL.into() {
                    write!(printer, "{value}")
                } else {
                    printer.constant(net)
                }
            }
            (_, name) if signed && width > 1 => printer.signed(net, name),
            _ => printer.operand(net, Place::Inside(Level::Compare)),
        }
    }
}

impl<W: Write> Printer<'_, W, Vhdl> {
    fn constant(&mut self, net: Net) -> fmt::Result {
        let circuit = self.module.circuit;
        let bits = circuit.constant_value(net).expect("a net without a name is a constant");
        write!(self, "{}", Number { bits, width: circuit.width(net) })
    }

    fn signed(&mut self, net: Net, name: Option<&str>) -> fmt::Result {
        match (name, self.module.form(net)) {
            (None, Form::Extend(from, true)) if self.module.circuit.width(from) > 1 => {
                return self.sign_extension(from, self.module.circuit.width(net));
            }
            _ => self.text("signed(")?,
        }
        match name {
            Some(name) => self.text(name)?,
            None => self.operand(net, Place::Inside(Level::Free))?,
        }
        self.text(")")
    }

    fn sign_extension(&mut self, from: Net, width: u32) -> fmt::Result {
        self.text("resize(")?;
        self.operand(from, Place::Number { signed: true })?;
        write!(self, ", {width})")
    }

    /// A division; by 0 it gives 0.
    fn divided(&mut self, operator: &str, a: Net, b: Net) -> fmt::Result {
        // A constant has its width said, so that tools that read it back see the same divider.
        let (number, sum) = (Place::Number { signed: false }, Place::Inside(Level::Sum));
        if self.module.circuit.constant_value(b).is_none() {
            self.word(&format!("to_unsigned(0, {})", self.module.circuit.width(a)))?;
            self.item("when ", b, number, " = 0")?;
            self.item("else ", a, sum, "")?;
            return self.item(operator, b, sum, "");
        }
        self.item("", a, sum, "")?;
        self.item(operator, b, sum, "")
    }

    fn chain_numbers(&mut self, operator: &str, a: Net, b: Net) -> fmt::Result {
        self.item("", a, Place::Number { signed: false }, "")?;
        self.item(operator, b, Place::Number { signed: false }, "")
    }

    fn extend(&mut self, from: Net, width: u32, signed: bool) -> fmt::Result {
        let free = Place::Inside(Level::Free);
        match (signed, self.module.circuit.width(from)) {
            (false, 1) => {
                write!(self, "to_unsigned(0, {})", width - 1)?;
                self.begins = false;
                self.item("& ", from, Place::Inside(Level::Sum), "")
            }
            (true, 1) => {
                write!(self, "unsigned'({} downto 0 => ", width - 1)?;
                self.operand(from, free)?;
                self.text(")")
            }
            (false, _) => {
                self.text("resize(")?;
                self.operand(from, free)?;
                write!(self, ", {width})")
            }
            (true, _) => {
                self.text("unsigned(")?;
                self.sign_extension(from, width)?;
                self.text(")")
            }
        }
    }

    fn slice(&mut self, from: Net, low: u32, width: u32) -> fmt::Result {
        let module = self.module;
        let name = module.name_of(from).expect("what is sliced has a name");
        let high = low + width - 1;
        match (module.circuit.width(from), width) {
            (1, _) => self.text(name),
            (_, 1) => write!(self, "{name}({low})"),
            _ if module.is_vector_port(from) => {
                write!(self, "unsigned({name}({high} downto {low}))")
            }
            _ => write!(self, "{name}({high} downto {low})"),
        }
    }
}
