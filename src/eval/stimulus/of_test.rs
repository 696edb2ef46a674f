//! What a test drives, as a stimulus.

use super::Stimulus;
use crate::eval::{Evaluator, Machine, Outcome, run_test_on};
use crate::model::{Program, Test, VariableId};

impl Stimulus {
    /// What a test does from its last reset on that a scan follows, up to the expectation at which
    /// it fails, and how it ends on the evaluator.
    pub fn of_test(program: &Program, test: &Test) -> (Stimulus, Outcome) {
        let mut writer = Writer {
            evaluator: Evaluator::new(program),
            stimulus: Stimulus::default(),
            driven: Vec::new(),
            is_reset: false,
        };
        let outcome = run_test_on(&mut writer, program, test);
        (writer.stimulus, outcome)
    }
}

/// An evaluator whose rows are written down.
struct Writer<'p> {
    evaluator: Evaluator<'p>,
    stimulus: Stimulus,
    /// Since the last scan.
    driven: Vec<(VariableId, i64)>,
    /// The next scan is the first after a reset.
    is_reset: bool,
}

impl Machine for Writer<'_> {
    fn reset(&mut self) {
        self.evaluator.reset();
        self.driven.clear();
        self.is_reset = true;
    }

    fn drive(&mut self, input: VariableId, value: i64) {
        self.evaluator.drive(input, value);
        self.driven.push((input, value));
    }

    fn scan(&mut self, tick: bool) {
        if std::mem::take(&mut self.is_reset) {
            self.stimulus = Stimulus::default();
        }
        self.evaluator.scan(tick);
        self.stimulus.drives.append(&mut self.driven);
        self.stimulus.rows.push((self.stimulus.drives.len(), tick));
    }

    fn value(&self, variable: VariableId) -> i64 {
        self.evaluator.value(variable)
    }
}
