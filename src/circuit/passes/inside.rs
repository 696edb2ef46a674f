//! Moves comparisons of what a module shows into the module.
//!
//! Before: any design. After: the same outputs in every scan; a word of an instance that is read
//! for nothing but to compare it with constants does not leave the instance: its module has an
//! output for each comparison instead. There the other passes see what is compared, and what by:
//! the running time of a timer.

use std::collections::{BTreeMap, BTreeSet, HashMap};

use super::place::{Comparison, Test};
use super::rebuild::rebuild;
use crate::circuit::{Cell, Circuit, Design, InstanceId, ModuleId, Net, Op, as_signed};

/// The most output ports of a module.
const PORTS: usize = 64;

/// An output of a module, what is asked of it, and whether it is read with a sign.
type Question = (u32, Test, bool);
/// Questions of the outputs of a module, in order.
type Questions = BTreeSet<Question>;

/// The design with comparisons inside of modules, if there is one to move.
pub fn compare_inside(design: &Design) -> Option<Design> {
    let top = design.top();
    let mut asked = asked(top);
    asked.retain(|&id, questions| {
        let module = &design.modules[top.instances[id].module];
        module.outputs.len() + questions.len() <= PORTS
    });
    if asked.is_empty() {
        return None;
    }
    let mut modules: Vec<Circuit> = design.modules.values().cloned().collect();
    modules.pop();
    let mut answering: HashMap<(ModuleId, &Questions), ModuleId> = HashMap::new();
    let mut moved = rebuild(top, |rebuild, _, cell| match question(top, cell) {
        Some((id, question, is_yes)) if asked.contains_key(&id) => {
            let module = &design.modules[top.instances[id].module];
            let place = asked[&id].iter().position(|&other| other == question);
            let Some(place) = place else { return rebuild.copy(cell) };
            let answer = rebuild.to.port(id, module.outputs.len() + place, 1);
            if is_yes { answer } else { rebuild.to.not(answer) }
        }
        _ => rebuild.copy(cell),
    });
    for (&id, questions) in &asked {
        let module = &mut moved.instances[id].module;
        let origin = *module;
        *module = *answering.entry((origin, questions)).or_insert_with(|| {
            modules.push(answer(&design.modules[origin], questions));
            ModuleId::from_raw((modules.len() as u32 - 1).into())
        });
    }
    modules.push(moved);
    Some(Design { modules: modules.into_iter().collect() })
}

/// The comparisons of each instance's words that nobody reads otherwise.
fn asked(top: &Circuit) -> BTreeMap<InstanceId, Questions> {
    let mut asked: BTreeMap<InstanceId, Questions> = BTreeMap::new();
    let mut read: BTreeSet<(InstanceId, u32)> = BTreeSet::new();
    let mut see = |net: Net| {
        if let Op::Port(id, output) = top.cell(net).op {
            read.insert((id, output));
        }
    };
    for (_, cell) in top.cells() {
        match question(top, cell) {
            Some((id, question, _)) => {
                asked.entry(id).or_default().insert(question);
            }
            None => top.for_each_operand(cell, &mut see),
        }
    }
    top.roots().for_each(see);
    for (id, questions) in &mut asked {
        questions.retain(|(output, ..)| !read.contains(&(*id, *output)));
    }
    asked.retain(|_, questions| !questions.is_empty());
    asked
}

/// The instance and the question of a comparison with a constant, and whether it is 1 for yes.
fn question(top: &Circuit, cell: Cell) -> Option<(InstanceId, Question, bool)> {
    let Comparison { of, test, signed, is_yes } = Comparison::of(top, cell)?;
    match top.cell(of).op {
        Op::Port(id, output) => Some((id, (output, test, signed), is_yes)),
        _ => None,
    }
}

/// The module with an output for each question.
fn answer(module: &Circuit, questions: &Questions) -> Circuit {
    let mut module = module.clone();
    for &(output, test, signed) in questions {
        let output = &module.outputs[output as usize];
        let (name, net) = (output.name.clone(), output.net);
        let width = module.width(net);
        let text = |bits: u64, signed: bool| match as_signed(bits, width) {
            number if signed && number < 0 => format!("minus_{}", number.unsigned_abs()),
            _ => bits.to_string(),
        };
        let (name, net) = match test {
            Test::Is(bits) => {
                let number = module.constant(bits, width);
                (format!("{name}_is_{}", text(bits, false)), Circuit::eq(&mut module, net, number))
            }
            Test::AtLeast(bits) => {
                let number = module.constant(bits, width);
                let below = module.less(net, number, signed);
                (format!("{name}_at_least_{}", text(bits, signed)), module.not(below))
            }
        };
        module.output(name, net);
    }
    module
}
