//! The reference evaluator and the simulated circuit, scan by scan on random inputs and ticks.

use fastrand::Rng;
use hotrail::circuit::{Design, FastSimulator, LANES, LaneSimulator, Output, Simulator, Valid};
use hotrail::eval::Evaluator;
use hotrail::expand;
use hotrail::model::{Names, Program, Role, Variable, VariableId};

use super::dice::Dice;

/// Every variable that a program can name but its ports.
pub fn inner_variables(program: &Program) -> Vec<VariableId> {
    let is_inner = |variable: &Variable| {
        program.is_named(variable) && !matches!(variable.role, Role::Input | Role::Output)
    };
    program.variables.iter().filter(|(_, variable)| is_inner(variable)).map(|(id, _)| id).collect()
}

/// The plain simulation of a circuit beside the evaluator.
struct Plain<'a> {
    program: &'a Program,
    circuit: Simulator,
    /// The variable that each output shows.
    shown: Vec<VariableId>,
}

impl<'a> Plain<'a> {
    fn new(program: &'a Program, design: &Valid<Design>) -> Plain<'a> {
        let names = Names::of(program);
        let variable = |output: &Output| names.variable(&output.name);
        let outputs = design.top().outputs.iter();
        let shown = outputs.map(|output| variable(output).expect("ports bear user's names"));
        Plain { program, circuit: Simulator::new(design), shown: shown.collect() }
    }

    /// The first output that is not what the evaluator says.
    fn wrong_output(&self, evaluator: &Evaluator<'_>) -> Option<String> {
        self.shown.iter().enumerate().find_map(|(port, &variable)| {
            let Variable { name, ty, .. } = &self.program.variables[variable];
            let meant = ty.bits(evaluator.value(variable));
            let shown = self.circuit.output(port);
            (shown != meant).then(|| format!("{name} is {meant}, shown is {shown}"))
        })
    }
}

/// How many scans of a run the fast simulations go with.
const FAST_SCANS: usize = 200;

/// The fast simulations of a circuit that shows all its inside: one run, 64 runs in lanes, and
/// one of those by itself. The first lane follows the plain simulation.
struct Fast {
    single: FastSimulator,
    lanes: LaneSimulator,
    /// The lane that runs by itself too, and what its inputs hold.
    lane: usize,
    alone: FastSimulator,
    held: Vec<u64>,
    /// The same 64 runs of what is shipped.
    shipped: LaneSimulator,
    random: Rng,
}

impl Fast {
    fn new(all: &Valid<Design>, shipped: &Valid<Design>, mut random: Rng) -> Fast {
        Fast {
            single: FastSimulator::new(all),
            lanes: LaneSimulator::new(all),
            lane: random.usize(1..LANES),
            alone: FastSimulator::new(all),
            held: vec![0; all.top().inputs.len()],
            shipped: LaneSimulator::new(shipped),
            random,
        }
    }

    /// Runs a scan and says what differs among themselves.
    fn scan(&mut self, inputs: &[u64]) -> Option<String> {
        for (port, &bits) in inputs.iter().enumerate() {
            // What is driven into the other lanes differs in low bits more often than in high ones.
            for bit in 0..self.lanes.input_width(port) {
                let other = match bit < 3 || self.random.u8(..8) == 0 {
                    true => self.random.u64(..),
                    false => 0,
                };
                let lanes = other & !1 | bits >> bit & 1;
                self.lanes.drive(port, bit, lanes);
                self.shipped.drive(port, bit, lanes);
                let held = &mut self.held[port];
                *held = *held & !(1 << bit) | (lanes >> self.lane & 1) << bit;
            }
        }
        self.single.settle(inputs);
        self.alone.settle(&self.held);
        self.lanes.settle();
        self.shipped.settle();
        self.single.clock();
        self.alone.clock();
        self.lanes.clock();
        self.shipped.clock();
        for port in 0..self.shipped.outputs() {
            for bit in 0..self.shipped.output_width(port) {
                if self.shipped.output_bit(port, bit) != self.lanes.output_bit(port, bit) {
                    return Some(format!("output {port} of what is shipped differs in some lane"));
                }
            }
        }
        for port in 0..self.lanes.outputs() {
            if self.lanes.output(port, self.lane) != self.alone.output(port) {
                return Some(format!("output {port} differs between a lane and its run alone"));
            }
        }
        None
    }

    /// True if the first run shows at a port what a plain simulation of the same run shows.
    fn shows(&self, port: usize, plain: &Simulator) -> bool {
        let shown = plain.output(port);
        self.single.output(port) == shown && self.lanes.output(port, 0) == shown
    }
}

/// Runs both for that many scans on random inputs and ticks and compares every named variable;
/// says what differs.
pub fn difference(program: &Program, scans: usize, mut random: Rng) -> Option<String> {
    let design = |observe| {
        let options = expand::Options { observe, ..expand::Options::default() };
        hotrail::compile(program, &options)
    };
    // What is shipped has lost what no output needs; the other shows all that has a name.
    let (shipped, all) = (design(Vec::new()), design(inner_variables(program)));
    let mut circuits = [&shipped, &all].map(|design| Plain::new(program, design));
    let mut fast = Some(Fast::new(&all, &shipped, random.fork()));
    let mut evaluator = Evaluator::new(program);
    let inputs: Vec<VariableId> = program.with_role(Role::Input).map(|(id, _)| id).collect();
    let tick_one_in = random.u8(1..4);
    for scan in 0..scans {
        let tick = random.u8(..tick_one_in) == 0;
        let mut bits = vec![u64::from(tick)];
        for &input in &inputs {
            let ty = program.variables[input].ty;
            if random.u8(..3) == 0 {
                evaluator.drive(input, random.value(ty));
            }
            bits.push(ty.bits(evaluator.value(input)));
        }
        evaluator.scan(tick);
        // Long runs are there for the evaluator; the circuits have met by then.
        fast = fast.filter(|_| scan < FAST_SCANS);
        if let Some(wrong) = fast.as_mut().and_then(|fast| fast.scan(&bits)) {
            return Some(format!("scan {scan}: {wrong}"));
        }
        for plain in &mut circuits {
            plain.circuit.settle(&bits);
            plain.circuit.clock();
            let mut outputs = 0..plain.shown.len();
            let is_wrong = |fast: &Fast| outputs.find(|&port| !fast.shows(port, &plain.circuit));
            let differs = fast.as_ref().and_then(is_wrong);
            let wrong = plain.wrong_output(&evaluator).or_else(|| {
                differs.map(|port| format!("output {port} differs in a fast simulation"))
            });
            if wrong.is_some() {
                return wrong.map(|wrong| format!("scan {scan}: {wrong}"));
            }
        }
    }
    None
}
