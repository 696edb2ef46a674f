//! The reference evaluator and circuits that take several clocks for a scan, on random inputs and
//! ticks, with random gaps between the scans.

use fastrand::Rng;
use hotrail::circuit::Simulator;
use hotrail::equations;
use hotrail::eval::Evaluator;
use hotrail::expand::{self, Schedule};
use hotrail::model::{Names, Program, Role, Variable, VariableId};

use super::dice::Dice;
use super::lockstep::inner_variables;

const SCHEDULES: [Schedule; 2] = [Schedule::Levels, Schedule::Serial];

/// A circuit that takes several clocks for a scan, and what it is told and has told.
struct Run<'p> {
    program: &'p Program,
    circuit: Simulator,
    clocks: u32,
    /// The names of the outputs but the last one, which tells the end of a scan.
    shown: Vec<VariableId>,
    /// What they showed after the last scan.
    held: Vec<u64>,
}

impl<'p> Run<'p> {
    fn new(program: &'p Program, schedule: Schedule, observe: Vec<VariableId>) -> Self {
        let options = expand::Options { observe, schedule, ..expand::Options::default() };
        let circuit = Simulator::new(&hotrail::compile(program, &options));
        let clocks = schedule.clocks(program, &equations::lower(program));
        let (done, shown) = circuit.circuit().outputs.split_last().expect("there is the last one");
        assert_eq!(&*done.name, expand::SCAN_DONE);
        assert_eq!(&*circuit.circuit().inputs[1].name, expand::SCAN_START);
        let names = Names::of(program);
        let variable = |name: &str| names.variable(name).expect("ports bear user's names");
        let shown: Vec<VariableId> = shown.iter().map(|output| variable(&output.name)).collect();
        let held = (0..shown.len()).map(|port| circuit.output(port)).collect();
        Run { program, circuit, clocks, shown, held }
    }

    /// One clock. Outputs must stay what they were, up to the clock edge too.
    fn clock(&mut self, inputs: &[u64], is_last: bool) -> Option<String> {
        self.circuit.settle(inputs);
        if self.circuit.output(self.shown.len()) != u64::from(is_last) {
            return Some(format!("{} is {}", expand::SCAN_DONE, !is_last));
        }
        let early = self.changed();
        self.circuit.clock();
        early.or_else(|| if is_last { None } else { self.changed() })
    }

    fn changed(&self) -> Option<String> {
        let port = (0..self.held.len()).find(|&port| self.circuit.output(port) != self.held[port]);
        let name = |port: usize| &self.program.variables[self.shown[port]].name;
        port.map(|port| format!("{} changes before the scan is over", name(port)))
    }

    /// Runs a scan with these inputs, and the idle clocks before it that there are; other clocks
    /// have other inputs.
    fn scan(&mut self, inputs: &[u64], clocks: &[Vec<u64>]) -> Option<String> {
        let (idle, busy) = clocks.split_at(clocks.len() + 1 - self.clocks as usize);
        let mut wrong = None;
        for clock in idle {
            let mut clock = clock.clone();
            clock[1] = 0;
            wrong = wrong.or_else(|| self.clock(&clock, false));
        }
        wrong = wrong.or_else(|| self.clock(inputs, busy.is_empty()));
        for (place, clock) in busy.iter().enumerate() {
            wrong = wrong.or_else(|| self.clock(clock, place + 1 == busy.len()));
        }
        self.held = (0..self.shown.len()).map(|port| self.circuit.output(port)).collect();
        wrong
    }

    fn differs(&self, evaluator: &Evaluator<'_>) -> Option<String> {
        self.shown.iter().zip(&self.held).find_map(|(&id, &shown)| {
            let Variable { name, ty, .. } = &self.program.variables[id];
            let meant = ty.bits(evaluator.value(id));
            (shown != meant).then(|| format!("{name} is {meant}, shown is {shown}"))
        })
    }
}

/// Runs a schedule and the evaluator on random inputs and ticks, with random gaps between scans.
fn difference(
    program: &Program,
    schedule: Schedule,
    scans: usize,
    mut random: Rng,
) -> Option<String> {
    let mut runs =
        [Vec::new(), inner_variables(program)].map(|observe| Run::new(program, schedule, observe));
    let mut evaluator = Evaluator::new(program);
    let inputs: Vec<VariableId> = program.with_role(Role::Input).map(|(id, _)| id).collect();
    let tick_one_in = random.u8(1..20);
    let most_idle = random.usize(0..4);
    let mut tick_waits = false;
    for scan in 0..scans {
        let row = |random: &mut Rng| -> Vec<u64> {
            let mut row = vec![u64::from(random.u8(..tick_one_in) == 0), random.u64(..2)];
            let widths = inputs.iter().map(|&input| program.variables[input].ty.width());
            row.extend(widths.map(|width| random.u64(..) >> (64 - width)));
            row
        };
        let others = runs[0].clocks as usize - 1;
        let idle = random.usize(..=most_idle);
        let clocks: Vec<Vec<u64>> = (0..idle + others).map(|_| row(&mut random)).collect();
        let mut start = row(&mut random);
        start[1] = 1;
        for (&input, bits) in inputs.iter().zip(&mut start[2..]) {
            let ty = program.variables[input].ty;
            if random.u8(..3) == 0 {
                evaluator.drive(input, random.value(ty));
            }
            *bits = ty.bits(evaluator.value(input));
        }
        let ticks = |clocks: &[Vec<u64>]| clocks.iter().any(|clock| clock[0] == 1);
        let (before, within) = clocks.split_at(idle);
        evaluator.scan(tick_waits || ticks(before) || start[0] == 1);
        tick_waits = ticks(within);
        for run in &mut runs {
            let wrong = run.scan(&start, &clocks).or_else(|| run.differs(&evaluator));
            if let Some(wrong) = wrong {
                return Some(format!("{schedule:?}, scan {scan}: {wrong}"));
            }
        }
    }
    None
}

/// Runs every schedule of several clocks; says what differs.
pub fn differences(program: &Program, scans: usize, seed: u64) -> Option<String> {
    let mut all = SCHEDULES.iter();
    all.find_map(|&schedule| difference(program, schedule, scans, Rng::with_seed(seed)))
}
