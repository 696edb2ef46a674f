//! The circuit of a program as a machine that a stimulus or a program's tests run on.

use crate::circuit::FastSimulator;
use crate::eval::Machine;
use crate::expand;
use crate::index::index;
use crate::model::{Program, Role, VariableId};

/// A program as its hardware, simulated, driven by the names of its variables.
///
/// # Panics
/// If a variable is read that is no port and was not to be observed.
pub struct CircuitRunner<'p> {
    program: &'p Program,
    simulator: FastSimulator,
    /// The bits of each input port; the tick is the first.
    driven: Vec<u64>,
    /// The input port of each variable that has one.
    inputs: Vec<Option<usize>>,
    /// The output port of each variable that has one.
    outputs: Vec<Option<usize>>,
}

impl<'p> CircuitRunner<'p> {
    /// The program at reset, inputs 0. Beside inputs and outputs these variables and members can
    /// be read, and no others: the rest may not be in the circuit.
    pub fn new(program: &'p Program, observe: &[VariableId]) -> Self {
        let is_port = |variable: VariableId| {
            matches!(program.variables[variable].role, Role::Input | Role::Output)
        };
        let mut inner: Vec<VariableId> =
            observe.iter().copied().filter(|&variable| !is_port(variable)).collect();
        inner.sort_unstable_by_key(|&variable| index(variable));
        inner.dedup();
        let options = expand::Options { observe: inner, ..expand::Options::default() };
        let design = expand::compile(program, &options);
        let mut inputs = vec![None; program.variables.len()];
        for (port, (input, _)) in program.with_role(Role::Input).enumerate() {
            inputs[index(input)] = Some(port + 1);
        }
        let mut outputs = vec![None; program.variables.len()];
        let shown = program.with_role(Role::Output).map(|(id, _)| id).chain(options.observe);
        for (port, variable) in shown.enumerate() {
            outputs[index(variable)] = Some(port);
        }
        let driven = vec![0; design.top().inputs.len()];
        let simulator = FastSimulator::new(&design);
        CircuitRunner { program, simulator, driven, inputs, outputs }
    }
}

impl Machine for CircuitRunner<'_> {
    fn reset(&mut self) {
        self.simulator.reset();
        self.driven.fill(0);
    }

    fn drive(&mut self, input: VariableId, value: i64) {
        let port = self.inputs[index(input)].expect("inputs are driven, nothing else");
        self.driven[port] = self.program.variables[input].ty.bits(value);
    }

    fn scan(&mut self, tick: bool) {
        self.driven[0] = tick.into();
        self.simulator.settle(&self.driven);
        self.simulator.clock();
    }

    fn value(&self, variable: VariableId) -> i64 {
        let bits = match (self.inputs[index(variable)], self.outputs[index(variable)]) {
            (Some(port), _) => self.driven[port],
            (None, Some(port)) => self.simulator.output(port),
            (None, None) => {
                panic!("{} is not observed", self.program.variables[variable].name)
            }
        };
        self.program.variables[variable].ty.wrap(bits as i64)
    }
}
