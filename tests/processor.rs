//! The ladder processor: its compiler's image, run by its emulator, does what the evaluator does.

mod common;

use common::emulated::{self, compile};
use common::{amount, checks, lp, node_name, relay, trees};
use fastrand::Rng;
use hotrail::backend::processor::{
    self, Bridge, Contact, Image, Machine, Operation, Tree, Word, decode, encode,
};
use hotrail::eval::Evaluator;
use hotrail::model::{Names, Program, Role, VariableId};

/// The paper's own order of contacts and its coil 316.
#[test]
fn the_bridge_of_nine_contacts_has_the_words_of_the_paper() {
    let on = Tree::on;
    let bridge = Tree::Bridge(Box::new(Bridge {
        upper_left: Tree::parallel([on(9), Tree::series([on(2), on(3), on(4)])]),
        lower_left: on(5),
        middle: Contact { address: 6, negated: false },
        upper_right: on(1),
        lower_right: Tree::series([on(7), on(8)]),
    }));
    let mut words: Vec<u16> = encode(&bridge).into_iter().map(Word::encode).collect();
    words.push(Word::Output { operation: Operation::Coil, coil: 316 }.encode());
    let paper = [0x1809, 0x0802, 0x0403, 0x1C04, 0x0405, 0x1406, 0x0C01, 0x0407, 0x1008, 0xA53C];
    assert_eq!(words, paper, "{words:04X?}");
}

/// Every nesting of series and parallel with that many contacts; `is_list` says which it is.
fn shapes(contacts: usize, is_list: bool) -> Vec<Vec<Shape>> {
    // The parts of a series or a list, behind a first one or from the first of several on.
    fn parts(contacts: usize, is_list: bool, is_first: bool) -> Vec<Vec<Shape>> {
        if contacts == 0 {
            return vec![Vec::new()];
        }
        let mut all = Vec::new();
        for first in 1..=contacts - usize::from(is_first) {
            for head in inner(first, !is_list) {
                for tail in parts(contacts - first, is_list, false) {
                    all.push([vec![head.clone()], tail].concat());
                }
            }
        }
        all
    }
    fn inner(contacts: usize, is_list: bool) -> Vec<Shape> {
        if contacts == 1 {
            return vec![Shape::Contact];
        }
        let shape = |parts| if is_list { Shape::List(parts) } else { Shape::Series(parts) };
        parts(contacts, is_list, true).into_iter().map(shape).collect()
    }
    parts(contacts, is_list, true)
}

#[derive(Clone)]
enum Shape {
    Contact,
    Series(Vec<Shape>),
    List(Vec<Shape>),
}

fn text_of(shape: &Shape, next: &mut usize) -> String {
    let mut texts =
        |parts: &[Shape]| -> Vec<String> { parts.iter().map(|part| text_of(part, next)).collect() };
    match shape {
        Shape::Series(parts) => texts(parts).join(" "),
        Shape::List(parts) => format!("[ {} ]", texts(parts).join(" | ")),
        Shape::Contact => {
            *next += 1;
            let mark = if next.is_multiple_of(3) { "!" } else { "" };
            format!("{mark}x{next}")
        }
    }
}

/// Runs a program of so many contacts and one output in all their states; in how many it is on.
fn in_all_states(program: &Program, image: &Image, contacts: usize, text: &str) -> u32 {
    let mut evaluator = Evaluator::new(program);
    let mut machine = Machine::new(&image.rom).unwrap();
    let inputs: Vec<VariableId> = program.with_role(Role::Input).map(|(id, _)| id).collect();
    let y = Names::of(program).variable("y").unwrap();
    let mut on = 0;
    for row in 0..1_u32 << contacts {
        for (bit, &input) in inputs.iter().enumerate() {
            evaluator.drive(input, (row >> bit & 1).into());
            machine.drive(bit as u16, row >> bit & 1 == 1);
        }
        evaluator.scan(false);
        machine.scan(false);
        assert_eq!(machine.bit(256), evaluator.value(y) == 1, "{text}, inputs {row:b}");
        on += u32::from(machine.bit(256));
    }
    on
}

#[test]
fn every_series_parallel_rung_of_up_to_six_contacts_conducts_where_it_is_drawn_to() {
    let mut rungs = 0;
    for contacts in 1..=6 {
        let names: Vec<String> = (1..=contacts).map(|contact| format!("x{contact}")).collect();
        let mut all: Vec<Shape> = match contacts {
            1 => vec![Shape::Contact],
            _ => shapes(contacts, false).into_iter().map(Shape::Series).collect(),
        };
        all.extend(shapes(contacts, true).into_iter().map(Shape::List));
        for shape in all {
            let network = text_of(&shape, &mut 0);
            let text = format!("ladder all input {} output y rung {network} (y)", names.join(", "));
            let (program, image) = compile(&text).unwrap_or_else(|findings| panic!("{findings}"));
            assert_eq!(image.rom.code.len(), contacts + 2, "{network}: one word a contact");
            in_all_states(&program, &image, contacts, &text);
            rungs += 1;
        }
    }
    // Twice the little Schroeder numbers 1, 3, 11, 45, 197, and the single contact.
    assert_eq!(rungs, 1 + 2 * (1 + 3 + 11 + 45 + 197));
}

#[test]
fn random_trees_with_and_without_bridges_conduct_where_they_are_drawn_to() {
    checks::TREES.hold(amount("HOTRAIL_RANDOM_TREES", 3000));
}

/// Lists in lists, each with a contact beside it, so that the stacks are needed as deep as can be.
#[test]
fn deep_nesting_is_ordered_or_cut() {
    let mut random = Rng::with_seed(2);
    for (height, flags) in [(3, 0), (4, 0), (8, 0), (9, 1), (12, 1), (13, 1), (60, 13)] {
        for position in 0..3 {
            let mut tree = Tree::on(0);
            for level in 1..=height {
                let inner = Tree::series([tree, Tree::on(level % 12)]);
                let mut branches = vec![Tree::off(level % 7), Tree::on(level % 5)];
                branches.insert(position, inner);
                tree = Tree::parallel(branches);
            }
            assert_eq!(trees::difference(&tree, &mut random), None, "{tree:?}");
            let fitted = processor::fit(&tree, 4, || 600);
            assert!(fitted.before.len() <= flags, "{height}: {}", fitted.before.len());
        }
    }
}

#[test]
fn the_words_of_a_tree_tell_the_tree() {
    let mut random = Rng::with_seed(3);
    let mut came_back = 0;
    for _ in 0..5000 {
        let depth = random.u32(1..6);
        let tree = trees::random_tree(&mut random, depth, false);
        let fitted = processor::fit(&tree, 4, || 600);
        if !fitted.before.is_empty() {
            continue;
        }
        let back = decode(&fitted.words).unwrap_or_else(|| panic!("{tree:?}"));
        assert_eq!(encode(&back), fitted.words, "{tree:?}");
        if encode(&tree) == fitted.words {
            assert_eq!(back, tree);
            came_back += 1;
        }
    }
    assert!(came_back > 3000, "{came_back}");
}

#[test]
fn random_programs() {
    let tally = checks::PROCESSOR.hold(amount("HOTRAIL_RANDOM_PROGRAMS", 1000));
    assert!(tally.skipped * 4 < tally.programs, "{} do not fit", tally.skipped);
}

/// A network of a few inner nodes, with a contact for each connection.
fn network(random: &mut Rng) -> (String, usize) {
    let nodes = 2 + random.usize(1..6);
    let mut connections = String::new();
    let contacts = random.usize(2..11);
    for contact in 0..contacts {
        let from = random.usize(..nodes);
        let to = (from + random.usize(1..nodes)) % nodes;
        let arrow = if random.bool() { "->" } else { "<->" };
        connections += &format!("{} {arrow} {} : x{contact}\n", node_name(from), node_name(to));
    }
    let inputs: Vec<String> = (0..contacts).map(|contact| format!("x{contact}")).collect();
    let text = format!(
        "ladder demo input {} output y rung net {{ {connections} }} (y)",
        inputs.join(", ")
    );
    (text, contacts)
}

#[test]
fn random_networks_conduct_as_in_the_evaluator() {
    let mut random = Rng::with_seed(3);
    let mut conducting = 0;
    for _ in 0..1500 {
        let (text, contacts) = network(&mut random);
        let (program, image) = match compile(&text) {
            Ok(both) => both,
            // No path leads from one end to the other.
            Err(findings) if findings.contains("E0305") => continue,
            Err(findings) => panic!("{findings}"),
        };
        conducting += in_all_states(&program, &image, contacts, &text);
    }
    assert!(conducting > 50_000, "{conducting}");
}

/// Without flags, if it is lists and bridges; what leads nowhere has none.
#[test]
fn a_network_has_a_word_for_each_contact() {
    for (contacts, network) in [
        (2, "left -> n1 : a  n1 -> right : b"),
        (2, "n1 -> right : b  left -> n1 : a"),
        (2, "n1 <-> left : a  right <-> n1 : b"),
        (3, "left -> n1 : a  left -> n1 : b  n1 -> right : c"),
        (3, "left <-> n1 : a  n1 <-> n2 : b  n2 <-> right : c"),
        (3, "left -> n1 : a  n1 -> n2 : b  n2 -> right : c  n2 -> n3 : d  n2 <-> n4 : e"),
        (1, "left -> right : a  left -> n1 : b  n1 -> left : c"),
        (1, "left -> right : a  left -> n1 : [ b | c ]"),
        // A bridge, and one with a way past it.
        (5, "left -> n1 : a  left -> n2 : b  n1 <-> n2 : c  n1 -> right : d  n2 -> right : e"),
        (5, "left <-> n1 : a  n2 <-> left : b  n1 <-> n2 : c  n1 <-> right : d  right <-> n2 : e"),
        (
            6,
            "left -> n1 : a  left -> n2 : b  n1 <-> n2 : c  n1 -> right : d  n2 -> right : e
             left -> right : f",
        ),
    ] {
        let text =
            format!("ladder demo input a, b, c, d, e, f output y rung net {{ {network} }} (y)");
        let (_, image) = compile(&text).unwrap_or_else(|findings| panic!("{findings}"));
        assert_eq!(image.rom.code.len(), contacts + 2, "{network}");
    }
}

#[test]
fn a_block_whose_own_output_is_its_power_sees_that_of_the_last_scan() {
    let text = "ladder own input a output y, z rung !e.Q e:R_TRIG() (y) rung a !f.Q f:F_TRIG() (z)";
    let (program, image) = compile(text).unwrap_or_else(|findings| panic!("{findings}"));
    let wrong = emulated::difference(&program, &image, 100, Rng::with_seed(1));
    assert_eq!(wrong, None);
}

/// One for each word, and what docs/processor.md says of a function besides.
#[test]
fn clocks_of_a_scan_are_counted() {
    let besides_words = |block: &str| {
        let text = format!("ladder clocks tick 100ms input a output y rung {block} (y)");
        let (_, image) = compile(&text).unwrap_or_else(|findings| panic!("{findings}"));
        let mut machine = Machine::new(&image.rom).unwrap();
        machine.scan(false);
        machine.clocks() - image.rom.code.len() as u64
    };
    let drum = besides_words("a d:DRUM(PV := 4, EN := a, TAPS := [1, 2])");
    assert_eq!(drum - besides_words("a"), 7 + 2);
}

/// A bridge has to be looked at before a later branch writes one of its contacts.
#[test]
fn what_a_bridge_looks_at_is_taken_before_it_is_written() {
    for contact in ["x", "b", "c"] {
        let bridge = ["x", "a", "b", "c", "d"].map(|name| if name == contact { "m" } else { name });
        let [one, two, middle, three, four] = bridge;
        let text = format!(
            "ladder taken input x, a, b, c, d, e output y var m rung [
                net {{ left -> n1 : {one}  left -> n2 : {two}  n1 <-> n2 : {middle}
                      n1 -> right : {three}  n2 -> right : {four} }}
                | e (m) ] (y)"
        );
        let (program, image) = compile(&text).unwrap_or_else(|findings| panic!("{findings}"));
        let wrong = emulated::difference(&program, &image, 500, Rng::with_seed(1));
        assert_eq!(wrong, None, "{contact}");
    }
}

/// With fewer registers words have other places, with shallow stacks lists go into flags.
#[test]
fn random_programs_on_the_smallest_machines() {
    let mut ran = 0;
    for seed in 0..amount("HOTRAIL_RANDOM_PROGRAMS", 1000) / 10 {
        let depth = [2, 3, 4, 6][seed as usize % 4];
        let Some((program, image)) = lp::smallest(&relay::program(seed), depth) else { continue };
        assert!(image.needs().stack_depth <= depth);
        let wrong = emulated::difference(&program, &image, 40, Rng::with_seed(seed));
        assert_eq!(wrong, None, "seed {seed}, stacks of {depth}");
        ran += 1;
    }
    assert!(ran > 50, "{ran}");
}

/// The function paper's example: three registers, 0 enters at the low end.
#[test]
fn a_shift_over_three_registers_goes_as_the_paper_prints_it() {
    // The enable circuit is left out; unit 0, register 592, three registers, input 0, coil 256.
    let code = vec![0xC800, 0xD250, 0xCC03, 0x0400, 0xA100, 0xBC00];
    let registers = [(592, 0xFFFF), (593, 0x0F0F), (594, 0xF0F0)].into_iter().collect();
    let pins = processor::Pins { inputs: 1, outputs: 1 };
    let rom = processor::Rom { code, registers, pins, ..processor::Rom::default() };
    let mut machine = Machine::new(&rom).unwrap();
    for (low, middle, high, coil) in [
        (0xFFFE, 0x1E1F, 0xE1E0, true),
        (0xFFFC, 0x3C3F, 0xC3C0, true),
        (0xFFF8, 0x787F, 0x8780, true),
        (0xFFF0, 0xF0FF, 0x0F00, true),
        (0xFFE0, 0xE1FF, 0x1E01, false),
    ] {
        machine.drive(0, true);
        machine.scan(false);
        let shown = [592, 593, 594].map(|register| machine.register(register));
        assert_eq!((shown, machine.bit(256)), ([low, middle, high], coil));
        machine.drive(0, false);
        machine.scan(false);
    }
}

/// A bit of a word is written through power, on its own, with constants, and read above and below.
#[test]
fn bits_of_words_are_assigned() {
    let text = "ladder bits input a, b, c output x, y, z var w : WORD := 16#0008 var n : INT[2]
        rung { w.3 := a }
        rung b { w.15 := TRUE } ( x )
        rung c { w.15 := FALSE } w.15 ( y )
        rung w.3 { w.3 := NOT w.3 } { n[1].0 := w.15 XOR a } ( z )
        rung [ a | b w.3 ] { w.0 := a AND NOT (b OR w.0) } [ { w.1 := w.0 } | !w.1 ] { n[0].15 := c } (S z)
        rung { w.7 := TRUE } { w.3 := w.7 = a }";
    let (program, image) = compile(text).unwrap_or_else(|findings| panic!("{findings}"));
    let wrong = emulated::difference(&program, &image, 2000, Rng::with_seed(1));
    assert_eq!(wrong, None);
}
