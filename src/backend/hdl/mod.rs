//! Verilog and VHDL: one file of each from one design, with the same names in both.

mod comment;
mod expression;
mod keywords;
mod module;
pub(super) mod names;
mod naming;
mod order;
mod plan;
mod ports;
mod prescaler;
pub mod testbench;
mod unread;
mod verilog;
mod vhdl;
mod view;
mod wrapper;

use std::fmt;

use crate::circuit::{Design, Valid};

pub use comment::Harmless;
pub use module::{PortName, PortNames};
pub use prescaler::Prescaler;
pub use wrapper::Board;

/// A hardware description language.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Language {
    /// Verilog-2005.
    Verilog,
    /// VHDL-93.
    Vhdl,
}

/// What resets the registers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ResetStyle {
    /// A 1 on `rst` at a clock edge.
    #[default]
    SyncHigh,
    /// A 0 on `rst_n` at a clock edge.
    SyncLow,
    /// A 0 on `rst_n` at any time.
    AsyncLow,
}

impl Language {
    /// The ending of its files, without a dot.
    pub fn extension(self) -> &'static str {
        match self {
            Language::Verilog => "v",
            Language::Vhdl => "vhd",
        }
    }
}

impl ResetStyle {
    /// The name of the reset port.
    pub fn port(self) -> &'static str {
        if self.is_low() { "rst_n" } else { "rst" }
    }

    fn is_low(self) -> bool {
        self != ResetStyle::SyncHigh
    }

    fn is_async(self) -> bool {
        self == ResetStyle::AsyncLow
    }
}

/// How a design is printed.
#[derive(Clone, Debug)]
pub struct Options {
    /// What resets the registers.
    pub reset: ResetStyle,
    /// The name of the program's file, without its folder.
    pub source: String,
    /// The version of this compiler.
    pub version: String,
}

impl Default for Options {
    fn default() -> Self {
        Options {
            reset: ResetStyle::default(),
            source: String::new(),
            version: env!("CARGO_PKG_VERSION").to_owned(),
        }
    }
}

/// The text of a design. The last module in it is the program itself.
pub fn print(design: &Valid<Design>, language: Language, options: &Options) -> String {
    let modules = module::modules(design, options.reset);
    match language {
        Language::Verilog => verilog::print(&modules, options),
        Language::Vhdl => vhdl::print(&modules, options),
    }
}

/// The text of the wrapper that connects a design to the pins of a board: it brings inputs and
/// reset into the clock's time and makes the tick.
pub fn print_wrapper(
    design: &Valid<Design>,
    language: Language,
    options: &Options,
    board: &Board,
) -> String {
    let mut text = wrapper::print(design, language, options, board);
    text.push('\n');
    text
}

/// The names under which a test bench or a wrapper finds the printed program.
pub fn port_names(design: &Design, options: &Options) -> PortNames {
    PortNames::new(design, options.reset)
}

/// The first words of every printed file, behind the comment sign.
const MADE_BY: &str = "Made by hotrail ";

/// The first line of a printed file, without its comment sign.
pub fn header(options: &Options) -> Header<'_> {
    Header(options)
}

/// Displays the first line of a printed file.
pub struct Header<'a>(&'a Options);

impl fmt::Display for Header<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Options { version, source, .. } = self.0;
        let source = comment::Harmless::ascii(source);
        write!(f, "{MADE_BY}{version} from {source}. ")?;
        f.write_str("Do not edit: change the ladder and build again.")
    }
}

/// True if a file begins with [`header`], whatever the version and the language: it is ours and
/// may be overwritten.
pub fn bears_header(text: &str) -> bool {
    ["// ", "-- ", "; "]
        .iter()
        .any(|sign| text.strip_prefix(sign).is_some_and(|line| line.starts_with(MADE_BY)))
}

/// Fills a template; `modules` tell about how long the text becomes.
fn render(template: &impl askama::Template, modules: &[module::Module<'_>]) -> String {
    let statements: usize = modules.iter().map(|module| module.items.len() + 20).sum();
    let mut text = String::with_capacity(statements * 64);
    template.render_into(&mut text).expect("writing to a string does not fail");
    // A template loses the end of its last line.
    text.push('\n');
    text
}
