//! The rungs as values flow between them: what is not named in the report has the same values.

use fastrand::Rng;
use hotrail::circuit::Simulator;
use hotrail::equations::{Order, Resource, by_dataflow};
use hotrail::eval::Evaluator;
use hotrail::expand;
use hotrail::model::{Program, Role, VariableId};

use super::dice::Dice;

/// Scans of a program.
pub const SCANS: usize = 100;

/// Everything that an order does not name has the same values in both orders.
///
/// Takes a program twice, puts the second into the order, and says what is wrong.
pub fn wrong_claim(before: &Program, after: &mut Program, seed: u64) -> Option<String> {
    let order = by_dataflow(after);
    if !by_dataflow(after).changes.is_empty() {
        return Some("it does not stand in that order then".to_owned());
    }
    let after = &*after;
    let circuit = hotrail::compile(after, &expand::Options::default());
    let mut circuit = Simulator::new(&circuit);
    let mut random = Rng::with_seed(seed);
    let mut runs = [Evaluator::new(before), Evaluator::new(after)];
    let inputs: Vec<VariableId> = before.with_role(Role::Input).map(|(id, _)| id).collect();
    for scan in 0..SCANS {
        let tick = random.bool();
        let mut bits = vec![u64::from(tick)];
        for &input in &inputs {
            let ty = before.variables[input].ty;
            if random.u8(..3) == 0 {
                let value = random.value(ty);
                runs.iter_mut().for_each(|run| run.drive(input, value));
            }
            bits.push(ty.bits(runs[0].value(input)));
        }
        runs.iter_mut().for_each(|run| run.scan(tick));
        circuit.settle(&bits);
        circuit.clock();
        let differs = |id: &VariableId| runs[0].value(*id) != runs[1].value(*id);
        let named = before.named_variables().map(|(id, _)| id);
        if let Some(id) = named.filter(differs).find(|&id| !may_differ(before, &order, id)) {
            return Some(format!("scan {scan}: {} differs", before.variables[id].name));
        }
        let outputs = after.with_role(Role::Output).enumerate();
        for (port, (id, variable)) in outputs {
            if circuit.output(port) != variable.ty.bits(runs[1].value(id)) {
                return Some(format!("scan {scan}: the circuit's {} differs", variable.name));
            }
        }
    }
    None
}

fn may_differ(program: &Program, order: &Order, id: VariableId) -> bool {
    let resource = match program.variables[id].role {
        Role::Member(instance, _) => Resource::Instance(instance),
        _ => Resource::Variable(id),
    };
    order.may_differ.contains(&resource)
}
