//! Random gates, to hold that a pass over them changes no output.

use fastrand::Rng;

use super::Pass;
use super::same::assert_same;
use crate::circuit::{Circuit, Design, Net, Op};

/// Gates over four inputs; some nets are outputs.
fn random(seed: u64) -> Circuit {
    let mut circuit = Circuit::new("random");
    let mut rng = Rng::with_seed(seed);
    let mut nets: Vec<Net> = ["a", "b", "c", "d"].map(|name| circuit.input(name, 1)).into();
    for _ in 0..10 {
        let mut pick = || {
            let net = nets[rng.usize(..nets.len())];
            if rng.bool() { circuit.not(net) } else { net }
        };
        let [x, y, z] = [pick(), pick(), pick()];
        let few = rng.bool();
        let operands = [x, y, if few { y } else { z }];
        nets.push(match rng.u32(..4) {
            0 => either_or(&mut circuit, x, y, z),
            1 => circuit.or(operands),
            _ => circuit.and(operands),
        });
    }
    let last = nets.len() - 1;
    for (at, &net) in nets.iter().enumerate() {
        if at == last || rng.u32(..4) == 0 {
            circuit.output(format!("net_{at}"), net);
        }
    }
    circuit
}

fn either_or(circuit: &mut Circuit, select: Net, on: Net, off: Net) -> Net {
    let unselected = circuit.not(select);
    let sides = [circuit.and([select, on]), circuit.and([unselected, off])];
    circuit.or(sides)
}

/// The operands of all its lists.
fn operands(circuit: &Circuit) -> usize {
    let list = |op| match op {
        Op::And(list) | Op::Or(list) => circuit.list(list).len(),
        _ => 0,
    };
    circuit.cells().map(|(_, cell)| list(cell.op)).sum()
}

/// Holds that a pass changes many of 3,000 circuits, but no output, and that it leaves less to
/// compute.
pub fn assert_held(pass: Pass) {
    let (mut changed, mut before, mut after) = (0, 0, 0);
    for seed in 0..3000 {
        let circuit = random(seed);
        let Some(better) = pass(&circuit) else { continue };
        changed += 1;
        before += operands(&circuit);
        after += operands(&better);
        assert_same(seed, &circuit, Design { modules: [better].into_iter().collect() }, 64);
    }
    assert!(changed > 100, "only {changed} circuits were changed");
    assert!(after < before, "{before} operands became {after}");
}
