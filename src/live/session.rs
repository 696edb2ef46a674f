//! A run of a program under somebody's hands: what drives it, how far it is, what was done.

use crate::eval::{Evaluator, Flow, Machine, Stimulus};
use crate::model::{Program, Role, VariableId};

/// A program that runs on the reference evaluator, and everything that came from outside since
/// reset.
pub struct Session<'p> {
    program: &'p Program,
    evaluator: Evaluator<'p>,
    inputs: Vec<VariableId>,
    /// What the last scan saw of each input.
    seen: Vec<i64>,
    /// Inputs that go back to 0 behind the next scan.
    pulsed: Vec<VariableId>,
    /// What drives the first scans; an input keeps what it says until a person changes it.
    given: Stimulus,
    /// What drove every scan so far.
    past: Stimulus,
    ticks: u64,
    flow: Flow,
}

impl<'p> Session<'p> {
    /// The program at reset, driven by a stimulus as long as that has rows.
    pub fn new(program: &'p Program, given: Stimulus) -> Self {
        let inputs: Vec<VariableId> = program.with_role(Role::Input).map(|(id, _)| id).collect();
        Session {
            program,
            evaluator: Evaluator::new(program),
            seen: vec![0; inputs.len()],
            inputs,
            pulsed: Vec::new(),
            given,
            past: Stimulus::default(),
            ticks: 0,
            flow: Flow::at_reset(program),
        }
    }

    /// What runs.
    pub fn program(&self) -> &'p Program {
        self.program
    }

    /// The inputs in the order of their declaration.
    pub fn inputs(&self) -> &[VariableId] {
        &self.inputs
    }

    /// The value of a variable after the last scan; of an input, that of the next scan.
    pub fn value(&self, variable: VariableId) -> i64 {
        self.evaluator.value(variable)
    }

    /// What the last scan saw of the input of that number.
    pub fn seen(&self, input: usize) -> i64 {
        self.seen[input]
    }

    /// The scans since reset.
    pub fn scans(&self) -> usize {
        self.past.len()
    }

    /// The ticks since reset.
    pub fn ticks(&self) -> u64 {
        self.ticks
    }

    /// How many rows of the stimulus are still to come.
    pub fn rows_left(&self) -> usize {
        self.given.len().saturating_sub(self.scans())
    }

    /// The power in the last scan.
    pub fn flow(&self) -> &Flow {
        &self.flow
    }

    /// What drove every scan since reset.
    pub fn past(&self) -> &Stimulus {
        &self.past
    }

    /// Gives an input a value of its type, from the next scan on.
    pub fn drive(&mut self, input: VariableId, value: i64) {
        self.evaluator.drive(input, value);
        self.pulsed.retain(|&pulsed| pulsed != input);
    }

    /// Switches a `BOOL` input on for the next scan alone.
    pub fn pulse(&mut self, input: VariableId) {
        self.drive(input, 1);
        self.pulsed.push(input);
    }

    /// Runs a number of scans, of which the last one's power can be seen. Where the stimulus does
    /// not say it, `tick` tells whether they have the tick.
    pub fn scan(&mut self, scans: usize, tick: bool) {
        for left in (0..scans).rev() {
            let tick = match self.rows_left() {
                0 => tick,
                _ => {
                    let row = self.given.row(self.scans());
                    self.evaluator.drive_row(row);
                    row.tick
                }
            };
            self.take_down(tick);
            self.execute(tick, left == 0);
            for input in std::mem::take(&mut self.pulsed) {
                self.evaluator.drive(input, 0);
            }
        }
    }

    /// Goes back by one scan: runs all but the last one again, from reset. What drove that one is
    /// about to drive the next.
    pub fn back(&mut self) {
        let Some(scans) = self.scans().checked_sub(1) else { return };
        let undone = self.past.row(scans).drives.to_vec();
        self.past.truncate(scans);
        self.restart();
        for scan in 0..scans {
            let row = self.past.row(scan);
            self.evaluator.drive_row(row);
            self.execute(row.tick, scan + 1 == scans);
        }
        self.seen = self.inputs.iter().map(|&input| self.evaluator.value(input)).collect();
        undone.into_iter().for_each(|(input, value)| self.evaluator.drive(input, value));
    }

    /// Back to reset, inputs to 0; the stimulus starts again.
    pub fn reset(&mut self) {
        self.past.truncate(0);
        self.restart();
    }

    fn restart(&mut self) {
        self.evaluator.reset();
        self.pulsed.clear();
        self.seen.fill(0);
        self.ticks = 0;
        self.flow = Flow::at_reset(self.program);
    }

    fn execute(&mut self, tick: bool, is_seen: bool) {
        match is_seen {
            true => self.flow = self.evaluator.scan_seen(tick),
            false => self.evaluator.scan(tick),
        }
        self.ticks += u64::from(tick);
    }

    /// Writes down what the next scan sees of the inputs.
    fn take_down(&mut self, tick: bool) {
        let evaluator = &self.evaluator;
        let changed = self.inputs.iter().zip(&mut self.seen).filter_map(|(&input, seen)| {
            let value = evaluator.value(input);
            (std::mem::replace(seen, value) != value).then_some((input, value))
        });
        self.past.push(tick, changed);
    }
}
