//! Trees of contacts on the ladder processor: where they conduct.

use fastrand::Rng;
use hotrail::backend::processor::{self, Bridge, Contact, Machine, Operation, Tree, Word};

/// Scans of a tree.
pub const SCANS: u64 = 40;

/// A random tree of contacts, bridges among them if they are wanted.
pub fn random_tree(random: &mut Rng, depth: u32, bridges: bool) -> Tree {
    let contact = |random: &mut Rng| Contact { address: random.u16(..12), negated: random.bool() };
    match random.u32(..if depth == 0 { 1 } else { 10 }) {
        0..=2 => Tree::Contact(contact(random)),
        3..=5 => {
            let parts = 2 + random.usize(..3);
            Tree::series((0..parts).map(|_| random_tree(random, depth - 1, bridges)))
        }
        6 if bridges => {
            let mut arm = || random_tree(random, depth - 1, bridges);
            let (upper_left, lower_left, upper_right, lower_right) = (arm(), arm(), arm(), arm());
            let middle = contact(random);
            Tree::Bridge(Box::new(Bridge {
                upper_left,
                lower_left,
                middle,
                upper_right,
                lower_right,
            }))
        }
        _ => {
            let branches = 2 + random.usize(..3);
            Tree::parallel((0..branches).map(|_| random_tree(random, depth - 1, bridges)))
        }
    }
}

/// Runs a tree as the processor does, with what it needs in flags, and says where it
/// differs from the tree.
pub fn difference(tree: &Tree, random: &mut Rng) -> Option<String> {
    let mut rom = processor::Rom::default();
    rom.sizes.stack_depth = [2, 3, 4, 4, 5, 8][random.usize(..6)];
    let mut flag = 512;
    let fitted = processor::fit(tree, rom.sizes.stack_depth, || {
        flag += 1;
        flag - 1
    });
    let mut circuits = fitted.before.clone();
    circuits.push((fitted.words.clone(), 256));
    for (words, coil) in circuits {
        rom.code.extend(words.into_iter().map(Word::encode));
        rom.code.push(Word::Output { operation: Operation::Coil, coil }.encode());
    }
    rom.code.push(Word::END.encode());
    rom.pins.inputs = 12;
    if rom.code.len() > 1024 {
        return None;
    }
    let mut machine = Machine::new(&rom).unwrap_or_else(|faults| panic!("{tree:?}: {faults:?}"));
    for _ in 0..SCANS {
        let inputs: u16 = random.u16(..);
        (0..12).for_each(|input| machine.drive(input, inputs >> input & 1 == 1));
        machine.scan(false);
        let meant = tree.conducts(&|address| inputs >> address & 1 == 1);
        if machine.bit(256) != meant {
            return Some(format!("it conducts where it should not, or not, with {inputs:b}"));
        }
    }
    None
}
