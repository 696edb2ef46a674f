//! In which clock of a scan each rung acts, and what steps through the clocks.
//!
//! A rung acts in the clock of its stage: the registers that it writes are enabled in that clock
//! only. What it reads of its own stage is a wire, anything else a register, which holds the newest
//! value by then. One flip-flop for each stage passes on which one acts.

use std::collections::HashMap;

use super::Expansion;
use crate::circuit::{Circuit, Net, RegisterId, Signal, Version};
use crate::equations::{Equations, Graph, Step, StepKind};
use crate::index::index;
use crate::model::{Program, Role, VariableId};

/// The port that starts a scan in a schedule of several clocks.
pub const SCAN_START: &str = "scan_start";
/// The port that is 1 in a scan's last clock.
pub const SCAN_DONE: &str = "scan_done";

/// In which clocks the rungs act. All of them give the same values scan by scan.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Schedule {
    /// All in one clock.
    #[default]
    Flat,
    /// One level of the graph of dependencies in a clock.
    Levels,
    /// One rung in a clock.
    Serial,
}

impl Schedule {
    /// The number of clocks that a scan of the program takes.
    pub fn clocks(self, program: &Program, equations: &Equations) -> u32 {
        let stages = self.stages(program, equations);
        stages.and_then(|stages| stages.into_iter().max()).map_or(1, |last| last + 1)
    }

    /// For each rung the clock of the scan in which it acts, from 0.
    fn stages(self, program: &Program, equations: &Equations) -> Option<Vec<u32>> {
        match self {
            Schedule::Flat => None,
            Schedule::Levels => {
                let levels = Graph::new(program, equations).levels;
                Some(levels.into_iter().map(|level| level - 1).collect())
            }
            Schedule::Serial => Some((0..program.rungs.len() as u32).collect()),
        }
    }

    /// What a stage is called.
    fn word(self) -> &'static str {
        match self {
            Schedule::Serial => "rung",
            Schedule::Flat | Schedule::Levels => "level",
        }
    }
}

/// The stages of a scan that takes several clocks.
pub(super) struct Sequence {
    /// For each rung its stage.
    rungs: Vec<u32>,
    /// For each stage the bit that is 1 in its clock.
    pub(super) enables: Vec<Net>,
    /// The tick as the first stage sees it, and as the others do.
    ticks: [Net; 2],
    /// What each set of stages is enabled by.
    any_of: HashMap<Vec<u32>, Net>,
    schedule: Schedule,
}

impl Sequence {
    /// Makes what steps through the stages, from the tick on.
    pub(super) fn new(
        schedule: Schedule,
        program: &Program,
        equations: &Equations,
        circuit: &mut Circuit,
        tick: Net,
    ) -> Option<Sequence> {
        let rungs = schedule.stages(program, equations)?;
        let stages = rungs.iter().max().map_or(1, |last| last + 1);
        circuit.has_scan_ports = true;
        let plural = if stages == 1 { "" } else { "s" };
        circuit.comment.push(format!(
            "A scan takes {stages} clock{plural}, one for each {}. It starts where scan_start is 1, and \
             shows its outputs",
            schedule.word()
        ));
        circuit.comment.push("after the clock in which scan_done is 1.".to_owned());
        let start = circuit.input(SCAN_START, 1);
        circuit.section(format!("the {}s of a scan, one after the other", schedule.word()), 0);
        let mut enables = vec![start];
        if stages > 1 {
            let (waits, is_waiting) = circuit.register("scan_waits", 1, 1);
            enables = vec![circuit.and([is_waiting, start])];
            for stage in 1..stages {
                let name = format!("{}_{}", schedule.word(), stage + 1);
                let (register, is_on) = circuit.register(name, 1, 0);
                circuit.drive(register, enables[stage as usize - 1]);
                enables.push(is_on);
            }
            let idle = circuit.not(start);
            let stays = circuit.and([is_waiting, idle]);
            let next = circuit.or([enables[stages as usize - 1], stays]);
            circuit.drive(waits, next);
            let name = format!("{}_1", schedule.word()).into();
            let first = Signal { net: enables[0], name, version: Version::Last, section: 0 };
            circuit.signals.push(first);
        }
        // A tick that comes in a scan or between two is for the next one.
        let (waits, waiting) = circuit.register("tick_waits", 1, 0);
        let seen = circuit.or([tick, waiting]);
        let not_taken = circuit.not(enables[0]);
        let kept = circuit.and([seen, not_taken]);
        circuit.drive(waits, kept);
        let (held, in_scan) = circuit.register("tick_held", 1, 0);
        circuit.drive_where(enables[0], held, seen);
        let ticks = [seen, in_scan];
        Some(Sequence { rungs, enables, ticks, any_of: HashMap::new(), schedule })
    }

    /// The last stage.
    pub(super) fn last(&self) -> u32 {
        self.enables.len() as u32 - 1
    }

    /// The stage of a step of the equations: units of time stand before all rungs, and that a
    /// scan was the first one is over at its end.
    pub(super) fn stage_of(&self, program: &Program, step: &Step) -> u32 {
        match step.kind {
            StepKind::Assign { target, .. }
                if program.variables[target].role == Role::FirstScan =>
            {
                self.last()
            }
            _ => self.rungs.get(step.rung as usize).copied().unwrap_or(0),
        }
    }

    /// The bit that is 1 in the clocks of these stages, which stand in order.
    fn any_of(&mut self, circuit: &mut Circuit, stages: &[u32]) -> Net {
        if let &[stage] = stages {
            return self.enables[stage as usize];
        }
        if let Some(&net) = self.any_of.get(stages) {
            return net;
        }
        let net = circuit.or(stages.iter().map(|&stage| self.enables[stage as usize]));
        let numbers: Vec<String> = stages.iter().map(|stage| (stage + 1).to_string()).collect();
        let name = format!("{}_{}", self.schedule.word(), numbers.join("_or_")).into();
        let section = circuit.sections.len() - 1;
        circuit.signals.push(Signal { net, name, version: Version::Last, section });
        self.any_of.insert(stages.to_vec(), net);
        net
    }

    /// What stands behind the head of a rung.
    pub(super) fn remark(&self, rung: u32) -> String {
        match self.schedule {
            Schedule::Levels => format!(", level {}", self.rungs[rung as usize] + 1),
            Schedule::Flat | Schedule::Serial => String::new(),
        }
    }

    /// The tick of the scan.
    pub(super) fn tick(&self, stage: u32) -> Net {
        self.ticks[usize::from(stage > 0)]
    }
}

/// The values that a scan writes into a variable: one for each stage that does.
#[derive(Clone, Debug, Default)]
pub(super) struct Written {
    newest: Option<(u32, Net)>,
    earlier: Vec<(u32, Net)>,
}

impl Written {
    /// What the stage leaves in it so far.
    pub(super) fn set(&mut self, stage: u32, net: Net) {
        let before = self.newest.replace((stage, net));
        self.earlier.extend(before.filter(|&(before, _)| before != stage));
    }

    /// What the stage has written.
    pub(super) fn at(&self, stage: u32) -> Option<Net> {
        self.newest.filter(|&(newest, _)| newest == stage).map(|(_, net)| net)
    }

    /// True if the scan writes it in front of a stage.
    fn is_before(&self, stage: u32) -> bool {
        !self.earlier.is_empty() || self.newest.is_some_and(|(newest, _)| newest < stage)
    }
}

impl Expansion<'_> {
    /// An input as it was when the scan started.
    pub(super) fn input(&mut self, variable: VariableId, pin: Net) -> Net {
        let (Some(sequence), 1..) = (&self.sequence, self.stage) else { return pin };
        let enable = sequence.enables[0];
        *self.held.entry(variable).or_insert_with(|| {
            let name = format!("{}_held", self.program.variables[variable].name);
            let (register, net) = self.circuit.register(name, self.circuit.width(pin), 0);
            self.circuit.drive_where(enable, register, pin);
            net
        })
    }

    /// The tick as a call in that stage sees it.
    pub(super) fn tick(&self, stage: u32) -> Net {
        match &self.sequence {
            Some(sequence) => sequence.tick(stage),
            None => self.circuit.cells().next().expect("the tick is the first cell").0,
        }
    }

    /// What an output port shows: what the last scan left, until the next one is over.
    pub(super) fn shown(&mut self, variable: VariableId) -> Net {
        let Some(sequence) = &self.sequence else { return self.before(variable) };
        let (last, enable) = (sequence.last(), sequence.enables[sequence.last() as usize]);
        if !self.written[index(variable)].is_before(last) {
            return self.before(variable);
        }
        let left = match self.written[index(variable)].at(last) {
            Some(net) => net,
            None => self.before(variable),
        };
        let declared = &self.program.variables[variable];
        let (width, reset) = (declared.ty.width(), declared.ty.bits(declared.initial));
        let name = format!("{}_shown", declared.name);
        let (register, net) = self.circuit.register(name, width, reset);
        self.circuit.drive_where(enable, register, left);
        net
    }

    /// Gives a register what the scan writes into it, if it does.
    pub(super) fn drive(&mut self, register: RegisterId, written: &Written) {
        let Some((stage, mut next)) = written.newest else { return };
        let Some(sequence) = &mut self.sequence else {
            self.circuit.drive(register, next);
            return;
        };
        for &(earlier, net) in written.earlier.iter().rev() {
            next = self.circuit.mux(sequence.enables[earlier as usize], net, next);
        }
        let earlier = written.earlier.iter().map(|&(earlier, _)| earlier);
        let stages: Vec<u32> = earlier.chain([stage]).collect();
        let enable = sequence.any_of(&mut self.circuit, &stages);
        self.circuit.drive_where(enable, register, next);
    }

    /// The last output, where a scan takes several clocks. What is made from now on belongs to no
    /// rung.
    pub(super) fn end_of_scan(&mut self) {
        if let Some(sequence) = &self.sequence {
            let done = sequence.enables[sequence.last() as usize];
            self.circuit.output(SCAN_DONE, done);
            let pending = self.pending.iter().flatten().map(|pending| &pending.written);
            if self.written.iter().chain(pending).any(|one| !one.earlier.is_empty()) {
                let word = sequence.schedule.word();
                self.circuit.section(format!("what several {word}s write"), 0);
            }
        }
    }
}
