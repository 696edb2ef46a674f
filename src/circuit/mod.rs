//! The word-level circuit that every hardware back end prints and that the simulator runs.
//!
//! A circuit is a list of cells. An operand stands before its user, so index order is evaluation
//! order and a combinational loop cannot be written; only registers carry values backwards, from
//! scan to scan. Every circuit has the implied inputs clock and reset.

mod arithmetic;
mod builder;
mod fast;
mod flatten;
mod passes;
mod ranges;
mod simulate;
mod validate;

use std::sync::Arc;

use la_arena::{Arena, Idx};

pub use fast::{FastSimulator, LANES, LaneSimulator};
pub use passes::simplify;
pub use simulate::Simulator;
pub use validate::{Invalid, Valid};

/// The value of a cell: a vector of 1 to 64 bits.
pub type Net = Idx<Cell>;
/// A register of a circuit.
pub type RegisterId = Idx<Register>;
/// An instance of another circuit.
pub type InstanceId = Idx<Instance>;
/// A circuit of a design.
pub type ModuleId = Idx<Circuit>;

/// Circuits that instantiate each other. A circuit stands behind those that it instantiates; the
/// last one is the top.
#[derive(Clone, Debug, Default)]
pub struct Design {
    /// The circuits.
    pub modules: Arena<Circuit>,
}

impl Design {
    /// The circuit that nobody instantiates.
    ///
    /// # Panics
    /// If the design has no circuit.
    pub fn top(&self) -> &Circuit {
        self.modules.values().next_back().expect("a design has a top")
    }
}

/// One circuit: a module in Verilog, an entity in VHDL.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Circuit {
    /// A name for people; back ends make it legal and unique.
    pub name: String,
    /// Lines for the head of the printed module.
    pub comment: Vec<String>,
    /// Input ports, without clock and reset.
    pub inputs: Vec<Input>,
    /// Output ports.
    pub outputs: Vec<Output>,
    /// A scan takes as many clocks as its schedule says: the second input starts a scan, the last
    /// output is 1 in its last clock. Only a top has such.
    pub has_scan_ports: bool,
    /// Ports that are the elements of arrays. Only the top has such.
    pub vectors: Vec<Vector>,
    /// Registers.
    pub registers: Arena<Register>,
    /// Instances of other circuits.
    pub instances: Arena<Instance>,
    /// Names of nets, in text order of what they stand for.
    pub signals: Vec<Signal>,
    /// The parts of the program from which runs of cells come, in text order.
    pub sections: Vec<Section>,
    cells: Arena<Cell>,
    operands: Vec<Net>,
}

/// An input port.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Input {
    /// Name as the user knows it.
    pub name: Arc<str>,
    /// Width in bits.
    pub width: u32,
    /// What the word says.
    pub reading: Reading,
}

/// How people read a word.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Reading {
    /// As a number without a sign, or as bits.
    #[default]
    Unsigned,
    /// As a number in two's complement.
    Signed,
    /// As a time in ticks.
    Ticks,
}

/// An output port.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Output {
    /// Name as the user knows it.
    pub name: Arc<str>,
    /// What it shows.
    pub net: Net,
}

/// Ports of one width next to each other that a back end shows as one, the first lowest.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Vector {
    /// Name as the user knows it.
    pub name: Arc<str>,
    /// Input ports, else output ports.
    pub is_input: bool,
    /// Index of the first of them.
    pub first: usize,
    /// How many they are, 1 or more.
    pub length: usize,
}

/// A register: takes `next` at every clock edge at which it is enabled, `reset` at reset and when
/// powered up.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Register {
    /// Name as the user knows it.
    pub name: Arc<str>,
    /// Width in bits.
    pub width: u32,
    /// The bits at reset.
    pub reset: u64,
    /// The value at the next scan; may stand behind its users.
    pub next: Net,
    /// One bit: it keeps its value where this is 0. Without it, it never does.
    pub enable: Option<Net>,
}

/// An instance of another circuit.
///
/// Its inputs may stand behind the cells that read its outputs, as long as those outputs do not
/// depend on them within the scan.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Instance {
    /// Name as the user knows it.
    pub name: String,
    /// The circuit.
    pub module: ModuleId,
    /// One net for each of its inputs.
    pub inputs: Vec<Net>,
    /// One bit: its registers keep their values where this is 0. Without it, they never do.
    pub enable: Option<Net>,
}

/// A name for a net.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Signal {
    /// The net.
    pub net: Net,
    /// The variable whose value it is.
    pub name: Arc<str>,
    /// Which of the variable's values.
    pub version: Version,
    /// Index of the section in which it is assigned.
    pub section: usize,
}

/// Which value of a variable that is written several times in a scan.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Version {
    /// The one that stays.
    Last,
    /// The one written in that rung, from 1; a later write replaces it.
    Rung(u32),
}

/// A part of the program: a rung, usually.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Section {
    /// What a reader should see above it.
    pub comment: Arc<str>,
    /// Number of the rung, from 1, or 0 where there is none.
    pub rung: u32,
    /// Its first cell's index; it ends where the next one starts.
    pub start: u32,
}

/// An operation and the width of its result in bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Cell {
    /// What it computes.
    pub op: Op,
    /// 1 to 64.
    pub width: u32,
}

/// A run of operands in the circuit that holds the cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Operands {
    start: u32,
    len: u32,
}

/// What a cell computes. "Same width" means that operands and result have one width.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Op {
    /// The input port of that index.
    Input(u32),
    /// The value that a register holds.
    Register(RegisterId),
    /// The output port of that index of an instance.
    Port(InstanceId, u32),
    /// These bits.
    Const(u64),
    /// Every bit inverted. Same width.
    Not(Net),
    /// Bit by bit, two operands or more. Same width.
    And(Operands),
    /// Bit by bit, two operands or more. Same width.
    Or(Operands),
    /// Bit by bit. Same width.
    Xor(Net, Net),
    /// `on` where the one-bit `select` is 1, else `off`. `on`, `off` and result: same width.
    Mux {
        /// One bit.
        select: Net,
        /// Result for 1.
        on: Net,
        /// Result for 0.
        off: Net,
    },
    /// The sum, wrapped. Same width.
    Add(Net, Net),
    /// The difference, wrapped. Same width.
    Sub(Net, Net),
    /// The product, wrapped. Same width.
    Mul(Net, Net),
    /// The quotient of unsigned numbers; 0 where the second is 0. Same width.
    Div(Net, Net),
    /// What that division leaves; 0 where the second is 0. Same width.
    Rem(Net, Net),
    /// One bit: 1 if both operands, of one width, are equal.
    Eq(Net, Net),
    /// One bit: 1 if `a` is less than `b`, both of one width.
    Less {
        /// Left side.
        a: Net,
        /// Right side.
        b: Net,
        /// Two's complement, else unsigned.
        signed: bool,
    },
    /// The operand with zeros, or, signed, copies of its top bit, put before it. The result is
    /// wider than the operand.
    Extend {
        /// What is extended.
        from: Net,
        /// Repeats the top bit.
        signed: bool,
    },
    /// Bits `low` and up, as many as the result is wide.
    Slice {
        /// What is cut.
        from: Net,
        /// Index of the lowest bit.
        low: u32,
    },
    /// Two operands or more side by side, the highest bits first. The result is as wide as they
    /// are together.
    Concat(Operands),
}

/// The lowest `width` bits set.
pub(crate) fn mask(width: u32) -> u64 {
    u64::MAX >> (64 - width)
}

/// Bits read as a number in two's complement.
pub(crate) fn as_signed(bits: u64, width: u32) -> i64 {
    ((bits << (64 - width)) as i64) >> (64 - width)
}

impl Circuit {
    /// The cell that makes a net.
    pub fn cell(&self, net: Net) -> Cell {
        self.cells[net]
    }

    /// The width of a net in bits.
    pub fn width(&self, net: Net) -> u32 {
        self.cells[net].width
    }

    /// All cells in evaluation order.
    pub fn cells(&self) -> impl DoubleEndedIterator<Item = (Net, Cell)> + ExactSizeIterator {
        self.cells.iter().map(|(net, &cell)| (net, cell))
    }

    /// The number of cells.
    pub fn len(&self) -> usize {
        self.cells.len()
    }

    /// True if there is no cell.
    pub fn is_empty(&self) -> bool {
        self.cells.is_empty()
    }

    /// The operands of an `And`, `Or` or `Concat`.
    pub fn list(&self, operands: Operands) -> &[Net] {
        &self.operands[operands.start as usize..][..operands.len as usize]
    }

    /// Calls `see` with every operand of a cell, in order. Registers and instances have none:
    /// what they take may stand behind them.
    pub fn for_each_operand(&self, cell: Cell, mut see: impl FnMut(Net)) {
        match cell.op {
            Op::Input(_) | Op::Register(_) | Op::Port(..) | Op::Const(_) => {}
            Op::Not(from) | Op::Extend { from, .. } | Op::Slice { from, .. } => see(from),
            Op::And(operands) | Op::Or(operands) | Op::Concat(operands) => {
                self.list(operands).iter().copied().for_each(see)
            }
            Op::Xor(a, b)
            | Op::Add(a, b)
            | Op::Sub(a, b)
            | Op::Mul(a, b)
            | Op::Div(a, b)
            | Op::Rem(a, b)
            | Op::Eq(a, b)
            | Op::Less { a, b, .. } => {
                see(a);
                see(b);
            }
            Op::Mux { select, on, off } => {
                see(select);
                see(on);
                see(off);
            }
        }
    }

    /// The nets that outputs show, instances take, and that enable registers and instances.
    pub fn shown(&self) -> impl Iterator<Item = Net> {
        let outputs = self.outputs.iter().map(|output| output.net);
        let enables = self.registers.values().filter_map(|register| register.enable);
        let instances = self.instances.values();
        let given = instances.flat_map(|instance| instance.inputs.iter().chain(&instance.enable));
        outputs.chain(enables).chain(given.copied())
    }

    /// Every net that something else than a cell reads: those shown, and the next values of
    /// registers.
    pub fn roots(&self) -> impl Iterator<Item = Net> {
        self.shown().chain(self.registers.values().map(|register| register.next))
    }

    /// The index of the output port of that name.
    pub fn output_named(&self, name: &str) -> Option<usize> {
        self.outputs.iter().position(|output| &*output.name == name)
    }
}
