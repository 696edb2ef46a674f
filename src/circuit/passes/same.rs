//! Holds that a pass changes no output.

use fastrand::Rng;

use crate::circuit::{Circuit, Design, Simulator};

/// Holds that two circuits, whose inputs are bits, show the same in so many random scans.
pub fn assert_same(seed: u64, before: &Circuit, after: Design, scans: usize) {
    let before = Design { modules: [before.clone()].into_iter().collect() };
    let [before, after] = [before, after].map(|design| design.validate().expect("it is valid"));
    let (inputs, ports) = (before.top().inputs.len(), before.top().outputs.len());
    let (mut first, mut second) = (Simulator::new(&before), Simulator::new(&after));
    let mut rng = Rng::with_seed(seed);
    for scan in 0..scans {
        let row: Vec<u64> = (0..inputs).map(|_| rng.u64(..2)).collect();
        first.settle(&row);
        second.settle(&row);
        for port in 0..ports {
            assert_eq!(second.output(port), first.output(port), "circuit {seed}, scan {scan}");
        }
        first.clock();
        second.clock();
    }
}
