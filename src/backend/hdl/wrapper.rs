//! The wrapper between a program and the pins of a board.
//!
//! The reset comes in at any time and is released in step with the clock. Every input bit goes
//! through two flip-flops; a `BOOL` may be debounced. A prescaler makes the tick from the clock.

use std::collections::HashSet;
use std::fmt;

use askama::Template;

use super::names::{CLOCK, NameId, Namer, Names, TICK};
use super::prescaler::{Prescaler, Quantity};
use super::{Header, Language, Options, PortName, PortNames, header, verilog, vhdl};
use crate::circuit::Design;

/// What the wrapper has to know of the board.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Board {
    /// The clock's frequency.
    pub clock_hz: u64,
    /// The time from tick to tick.
    pub tick_ns: u64,
    /// The number of ticks that a `BOOL` input must keep a new value before the program sees it.
    pub debounce_ticks: Option<u32>,
}

impl Board {
    /// How the tick is made, for people.
    pub fn tick_made(&self) -> String {
        let Prescaler { clocks, .. } = self.prescaler();
        let clock = Quantity { value: self.clock_hz, units: ["Hz", "kHz", "MHz", "GHz"] };
        let period = Quantity { value: self.tick_ns, units: ["ns", "us", "ms", "s"] };
        let error = self.prescaler().error_ppm();
        format!("every {clocks} clocks of {clock}, wanted every {period}, error {error}")
    }

    /// What makes the tick.
    pub fn prescaler(&self) -> Prescaler {
        Prescaler::new(self.clock_hz, self.tick_ns)
    }
}

/// An input pin and the way to the program.
struct Pin<'a> {
    port: &'a str,
    width: u32,
    meta: &'a str,
    sync: &'a str,
    /// What is left of a `BOOL`, or of the elements of an array of them, without bounces.
    stable: Option<&'a str>,
    /// How each `BOOL` gets there.
    debounced: Vec<Debounce<'a>>,
}

/// A bit that must keep its value for some time.
struct Debounce<'a> {
    /// Its place in a pin of several bits.
    bit: Option<usize>,
    /// Counts the ticks but the last.
    count: &'a str,
}

impl Pin<'_> {
    /// What the program sees.
    fn seen(&self) -> &str {
        self.stable.unwrap_or(self.sync)
    }

    fn verilog(&self, name: &str, bit: &Option<usize>) -> String {
        bit.map_or(name.to_owned(), |bit| format!("{name}[{bit}]"))
    }

    fn vhdl(&self, name: &str, bit: &Option<usize>) -> String {
        bit.map_or(name.to_owned(), |bit| format!("{name}({bit})"))
    }

    fn verilog_range(&self) -> verilog::Range {
        verilog::Range(self.width)
    }

    fn verilog_zero(&self) -> String {
        if self.width == 1 { "1'b0".to_owned() } else { format!("{}'d0", self.width) }
    }

    fn vhdl_type(&self) -> vhdl::Type {
        vhdl::Type::Port(self.width)
    }

    fn vhdl_zero(&self) -> &'static str {
        if self.width == 1 { "'0'" } else { "(others => '0')" }
    }
}

/// An output pin.
struct Lamp<'a> {
    port: &'a str,
    width: u32,
}

impl Lamp<'_> {
    fn verilog_range(&self) -> verilog::Range {
        verilog::Range(self.width)
    }

    fn vhdl_type(&self) -> vhdl::Type {
        vhdl::Type::Port(self.width)
    }
}

/// A counter from 0 to `last`.
#[derive(Clone, Copy)]
struct Counter {
    last: u64,
    width: u32,
}

impl Counter {
    /// Counts that many steps, 2 or more.
    fn of(steps: u64) -> Self {
        let last = steps - 1;
        Counter { last, width: 64 - last.leading_zeros() }
    }

    fn verilog_range(&self) -> verilog::Range {
        verilog::Range(self.width)
    }

    fn verilog(&self, value: u64) -> String {
        format!("{}'d{value}", self.width)
    }

    fn verilog_zero(&self) -> String {
        self.verilog(0)
    }

    fn verilog_one(&self) -> String {
        self.verilog(1)
    }

    fn verilog_last(&self) -> String {
        self.verilog(self.last)
    }

    fn vhdl_high(&self) -> u32 {
        self.width - 1
    }

    fn vhdl_last(&self) -> String {
        match i32::try_from(self.last) {
            Ok(last) => last.to_string(),
            Err(_) => vhdl::Number { bits: self.last, width: self.width }.to_string(),
        }
    }
}

/// What both templates show.
struct View<'a> {
    header: Header<'a>,
    ports: &'a PortNames,
    names: &'a Names,
    fixed: Fixed,
    pins: Vec<Pin<'a>>,
    lamps: Vec<Lamp<'a>>,
    has_tick: bool,
    options: &'a Options,
    board: &'a Board,
    counter: Option<Counter>,
    debounce: Option<Counter>,
}

/// The names that every wrapper has inside.
#[derive(Clone, Copy)]
struct Fixed {
    tick: NameId,
    reset_pipe: NameId,
    core_reset: NameId,
    prescaler: NameId,
    core: NameId,
}

#[derive(Template)]
#[template(path = "wrapper.v", escape = "none")]
struct Verilog<'a> {
    view: View<'a>,
}

#[derive(Template)]
#[template(path = "wrapper.vhd", escape = "none")]
struct Vhdl<'a> {
    view: View<'a>,
}

/// The wrapper's text.
pub fn print(design: &Design, language: Language, options: &Options, board: &Board) -> String {
    let ports = PortNames::new(design, options.reset);
    let circuit = design.top();
    let has_tick = circuit.inputs.first().is_some_and(|input| &*input.name == TICK);
    let inputs = &ports.inputs[usize::from(has_tick) + usize::from(ports.has_scan_ports)..];
    let outer = HashSet::from([ports.module.to_ascii_lowercase()]);
    let debounce_ticks = board.debounce_ticks.filter(|&ticks| ticks > 0);
    let (names, fixed, ids) = choose_names(&ports, inputs, &outer);
    let pins = inputs.iter().zip(&ids).map(|(port, ids)| {
        let is_debounced = debounce_ticks.is_some() && is_bool(port);
        let bits = if is_debounced { ids.counts.as_slice() } else { &[] };
        let debounced = bits.iter().enumerate().map(|(bit, &count)| Debounce {
            bit: (port.width > 1).then_some(bit),
            count: names.get(count),
        });
        Pin {
            port: &port.name,
            width: port.width,
            meta: names.get(ids.meta),
            sync: names.get(ids.sync),
            stable: is_debounced.then(|| names.get(ids.stable)),
            debounced: debounced.collect(),
        }
    });
    let pins = pins.collect();
    let lamps = ports.outputs.iter().map(|port| Lamp { port: &port.name, width: port.width });
    let lamps = lamps.collect();
    let prescaler = board.prescaler();
    let view = View {
        header: header(options),
        ports: &ports,
        names: &names,
        fixed,
        pins,
        lamps,
        has_tick,
        options,
        board,
        counter: (prescaler.clocks > 1).then(|| Counter::of(prescaler.clocks)),
        // The first tick may come right after the change: one more makes the time full.
        debounce: debounce_ticks.map(|ticks| Counter::of(u64::from(ticks) + 1)),
    };
    let text = match language {
        Language::Verilog => Verilog { view }.render(),
        Language::Vhdl => Vhdl { view }.render(),
    };
    text.expect("writing to a string does not fail")
}

/// The names of what stands behind a pin.
struct PinNames {
    meta: NameId,
    sync: NameId,
    stable: NameId,
    /// For each `BOOL` in it.
    counts: Vec<NameId>,
}

/// True for a `BOOL` and an array of them.
fn is_bool(port: &PortName) -> bool {
    port.width == port.elements.unwrap_or(1)
}

/// The pins have the program's names; what is inside yields.
fn choose_names(
    ports: &PortNames,
    inputs: &[PortName],
    outer: &HashSet<String>,
) -> (Names, Fixed, Vec<PinNames>) {
    let mut namer = Namer::new(outer);
    namer.fix(CLOCK);
    namer.fix(ports.reset);
    let tick = namer.fix(TICK);
    namer.fix("async_reg");
    for port in inputs.iter().chain(&ports.outputs) {
        namer.take(&port.name, "");
    }
    let fixed = Fixed {
        tick,
        reset_pipe: namer.take("reset_pipe", ""),
        core_reset: namer.take(format_args!("core_{}", ports.reset), ""),
        prescaler: namer.take("prescaler", ""),
        core: namer.take("core", ""),
    };
    let ids = inputs
        .iter()
        .map(|port| {
            let name = &port.name;
            let [meta, sync, stable] =
                ["_meta", "_sync", "_stable"].map(|end| namer.take(name, end));
            let counts = match port.elements {
                _ if !is_bool(port) => Vec::new(),
                None => vec![namer.take(name, "_count")],
                Some(elements) => (0..elements)
                    .map(|element| namer.take(format_args!("{name}_{element}"), "_count"))
                    .collect(),
            };
            PinNames { meta, sync, stable, counts }
        })
        .collect();
    (namer.finish(), fixed, ids)
}

impl View<'_> {
    fn tick(&self) -> &str {
        self.names.get(self.fixed.tick)
    }

    fn reset_pipe(&self) -> &str {
        self.names.get(self.fixed.reset_pipe)
    }

    fn core_reset(&self) -> &str {
        self.names.get(self.fixed.core_reset)
    }

    fn prescaler_name(&self) -> &str {
        self.names.get(self.fixed.prescaler)
    }

    fn core(&self) -> &str {
        self.names.get(self.fixed.core)
    }

    fn is_low(&self) -> bool {
        self.options.reset.is_low()
    }

    fn is_async(&self) -> bool {
        self.options.reset.is_async()
    }

    fn has_words(&self) -> bool {
        self.pins.iter().any(|pin| pin.width > 1)
    }

    /// What a Verilog register in reset waits for.
    fn verilog_edges(&self) -> String {
        let more = if self.is_async() {
            format!(" or negedge {}", self.core_reset())
        } else {
            String::new()
        };
        format!("posedge clk{more}")
    }

    fn verilog_is_reset(&self) -> String {
        format!("{}{}", if self.is_low() { "!" } else { "" }, self.core_reset())
    }

    fn vhdl_sensitivity(&self) -> String {
        if self.is_async() { format!("clk, {}", self.core_reset()) } else { "clk".to_owned() }
    }

    /// How long a debounced input must keep its value.
    fn hold(&self) -> String {
        match self.board.debounce_ticks {
            Some(1) | None => "one tick".to_owned(),
            Some(ticks) => format!("{ticks} ticks"),
        }
    }

    fn vhdl_is_reset(&self) -> String {
        format!("{} = '{}'", self.core_reset(), if self.is_low() { 0 } else { 1 })
    }

    /// Columns of the longest range of a port.
    fn range_columns(&self) -> usize {
        let pins = self.pins.iter().map(|pin| pin.verilog_range());
        let lamps = self.lamps.iter().map(|lamp| lamp.verilog_range());
        pins.chain(lamps).map(|range| range.to_string().len()).max().unwrap_or(0)
    }

    /// Columns of the longest name of a port.
    fn name_columns(&self) -> usize {
        let pins = self.pins.iter().map(|pin| pin.port.len());
        let lamps = self.lamps.iter().map(|lamp| lamp.port.len());
        pins.chain(lamps).max().unwrap_or(0).max(self.ports.reset.len())
    }

    /// A text followed by spaces up to a number of columns.
    fn pad(&self, text: impl fmt::Display, columns: &usize) -> String {
        format!("{:<columns$}", text.to_string())
    }
}
