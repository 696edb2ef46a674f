//! From equations to a circuit: reads of the last scan become registers, calls become instances
//! of block modules.

mod expansion;
mod instances;
mod schedule;
mod shapes;
mod words;

use std::collections::HashMap;
use std::sync::Arc;

use la_arena::Arena;

use crate::blocks::{self, Shape};
use crate::circuit::{self, Circuit, Design, ModuleId, Net, RegisterId, Valid};
use crate::equations::{self, Equations, ExprId};
use crate::index::index;
use crate::model::{InstanceId, Program, VariableId};
use instances::{Called, Pending};
use schedule::{Sequence, Written};

pub use schedule::{SCAN_DONE, SCAN_START, Schedule};

/// What goes into the circuit beside the program.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Name of the source, for comments.
    pub source: String,
    /// Variables, members among them, to show at ports of their own.
    pub observe: Vec<VariableId>,
    /// In which clocks of a scan the rungs act.
    pub schedule: Schedule,
}

/// The circuit of a program, ready for every hardware back end.
pub fn compile(program: &Program, options: &Options) -> Valid<Design> {
    compile_as(&program.name, program, options)
}

/// The circuit of a program under another name.
///
/// # Panics
/// If the compiler has made a circuit that breaks its own rules.
pub fn compile_as(name: &str, program: &Program, options: &Options) -> Valid<Design> {
    let equations = equations::lower(program);
    let design = circuit::simplify(expand(name, program, &equations, options));
    design.validate().unwrap_or_else(|invalid| panic!("the compiler is at fault: {invalid}"))
}

/// The design of a program: its core, in a schedule, and the modules of the blocks that it calls,
/// under a name. Behaviour is that of the equations; nothing is simplified yet.
pub fn expand(name: &str, program: &Program, equations: &Equations, options: &Options) -> Design {
    let mut expansion = Expansion::new(program, equations);
    expansion.circuit.name = name.to_owned();
    expansion.ports(options.schedule);
    let mut exprs = equations.exprs.iter().map(|(id, _)| id);
    let mut made = 0;
    let mut rung = None;
    for (number, step) in equations.steps.iter().enumerate() {
        if rung.replace(step.rung) != Some(step.rung) {
            expansion.section(step.rung, options);
        }
        expansion.enter(step);
        for expr in exprs.by_ref().take((step.exprs - made) as usize) {
            expansion.expr(expr);
        }
        made = step.exprs;
        expansion.step(number as u32, step);
    }
    expansion.finish(&options.observe)
}

/// A circuit that computes expectations from the values that the last scan left: an input port
/// for each of the variables, an output port `expect_I_J` for each element J of expectation I.
pub fn expand_expectations(
    program: &Program,
    variables: &[VariableId],
    expectations: &[(Equations, Vec<ExprId>)],
) -> Circuit {
    let mut circuit = Circuit::new(format!("{}_expect", program.name));
    let inputs: Vec<(VariableId, Net)> = variables
        .iter()
        .map(|&variable| {
            let declared = &program.variables[variable];
            (variable, circuit.input(declared.name.clone(), declared.ty.width()))
        })
        .collect();
    for (number, (equations, elements)) in expectations.iter().enumerate() {
        let mut expansion = Expansion::new(program, equations);
        expansion.circuit = circuit;
        for &(variable, net) in &inputs {
            expansion.before[index(variable)] = Some(net);
        }
        equations.exprs.iter().for_each(|(id, _)| expansion.expr(id));
        circuit = expansion.circuit;
        for (element, expr) in elements.iter().enumerate() {
            let net = expansion.nets[index(*expr)];
            circuit.output(format!("expect_{number}_{element}"), net);
        }
    }
    circuit
}

/// A circuit under construction.
struct Expansion<'p> {
    program: &'p Program,
    equations: &'p Equations,
    circuit: Circuit,
    modules: Arena<Circuit>,
    by_block: HashMap<blocks::Key, ModuleId>,
    /// The net of each expression made so far.
    nets: Vec<Net>,
    /// The clocks of a scan, if it takes several.
    sequence: Option<Sequence>,
    /// The clock of the scan in which the rung acts that is made now.
    stage: u32,
    /// The stage for which each expression was made, if there are several.
    made_in: Vec<u32>,
    /// What this scan has written into each variable.
    written: Vec<Written>,
    /// Inputs as they were when the scan started.
    held: HashMap<VariableId, Net>,
    /// By instance, whether a reset coil has put it back since its last call.
    pending: Vec<Option<Pending>>,
    /// The value that the last scan left in each variable, once somebody asks.
    before: Vec<Option<Net>>,
    registers: Vec<(VariableId, RegisterId)>,
    instances: Vec<Option<Called>>,
    /// The instances whose block holds more than its kind says.
    shapes: HashMap<InstanceId, Arc<Shape>>,
    /// Second calls of instances that two kinds share.
    partners: Vec<Called>,
    /// The last step that writes each variable, if one does.
    last_write: Vec<Option<u32>>,
}
