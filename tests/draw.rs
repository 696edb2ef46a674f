//! Drawings: they show the whole program, they are what the program means, and they fit.

#[path = "draw/circuit.rs"]
mod circuit;
mod common;

use std::collections::HashMap;

use circuit::{Circuit, Effect};
use common::{amount, examples, generate};
use fastrand::Rng;
use hotrail::draw::{
    Drawing, ElementId, Glyphs, NARROWEST, Options, Point, Power, Rung, Shape, Symbol,
};
use hotrail::eval::{Evaluator, Flow, Seen};
use hotrail::model::{Element, Program, Role, Series};
use hotrail::source::Source;
use unicode_width::UnicodeWidthStr;

const EVERY_SHAPE: &str = include_str!("draw/every_shape.ladder");
const HOSTILE: &str = include_str!("draw/hostile.ladder");

fn drawing(name: &str, text: &str, width: usize) -> (Program, Drawing) {
    let source = Source::new(name, text);
    let (program, diagnostics) = hotrail::analyze(&source);
    let program = program.unwrap_or_else(|| panic!("{diagnostics:?}\n{text}"));
    (program, Drawing::new(&source, &Options { width }))
}

/// Every example, what is in this test's folder, and random programs, each at several widths.
fn for_all(mut check: impl FnMut(&str, &Program, &Drawing)) {
    for_all_texts(|name, text, width| {
        let (program, drawing) = drawing(name, text, width);
        check(name, &program, &drawing);
    });
}

fn for_all_texts(mut check: impl FnMut(&str, &str, usize)) {
    let mut programs: Vec<(String, String)> = examples()
        .iter()
        .map(|example| (example.name(), std::fs::read_to_string(&example.ladder).unwrap()))
        .collect();
    programs.push(("every_shape".to_owned(), EVERY_SHAPE.to_owned()));
    let seeds = amount("HOTRAIL_RANDOM_PROGRAMS", 1000) / 10;
    programs.extend((0..seeds).map(|seed| (format!("seed {seed}"), generate::program(seed))));
    for (index, (name, text)) in programs.iter().enumerate() {
        let widths = [NARROWEST, 81 + index % 40, 250];
        for width in widths {
            check(name, text, width);
        }
    }
}

#[test]
fn every_example_as_text() {
    for example in examples() {
        let text = std::fs::read_to_string(&example.ladder).unwrap();
        let (_, drawing) = drawing(&format!("{}.ladder", example.name()), &text, 100);
        insta::with_settings!({ omit_expression => true }, {
            insta::assert_snapshot!(example.name(), drawing.text(Glyphs::Unicode));
        });
    }
}

#[test]
fn every_shape() {
    let (_, drawing) = drawing("every_shape.ladder", EVERY_SHAPE, NARROWEST);
    insta::with_settings!({ omit_expression => true }, {
        insta::assert_snapshot!("every_shape", drawing.text(Glyphs::Unicode));
        insta::assert_snapshot!("every_shape_in_ascii", drawing.text(Glyphs::Ascii));
        insta::assert_snapshot!("every_shape.svg", drawing.svg());
    });
}

#[test]
fn no_line_is_wider_than_the_drawing() {
    for_all(|name, _, drawing| {
        let unicode = drawing.text(Glyphs::Unicode);
        let ascii = drawing.text(Glyphs::Ascii);
        assert!(ascii.is_ascii(), "{name}");
        assert_eq!(unicode.lines().count(), ascii.lines().count(), "{name}");
        for line in unicode.lines().chain(ascii.lines()) {
            assert!(line.width() <= drawing.width as usize, "{name}\n{line}");
            assert_eq!(line, line.trim_end(), "{name}");
        }
    });
}

/// The drawing with room for values and the power of a scan after some others.
fn with_flow(program: &Program, text: &str, width: usize, seed: u64) -> Drawing {
    let mut random = Rng::with_seed(seed);
    let mut evaluator = Evaluator::new(program);
    let mut flow = Flow::at_reset(program);
    for _ in 0..random.usize(1..8) {
        for (input, variable) in program.with_role(Role::Input) {
            let (low, high) = variable.ty.range();
            evaluator.drive(input, random.i64(low..=high));
        }
        flow = evaluator.scan_seen(random.u8(0..4) > 0);
    }
    Drawing::with_flow(&Source::new("with_flow", text), &Options { width }, &flow)
}

/// Every program that is looked at, in some scan.
fn for_all_scans(mut check: impl FnMut(&str, &Program, &Drawing)) {
    let mut seed = 0;
    for_all_texts(|name, text, width| {
        let (program, _) = drawing(name, text, width);
        seed += 1;
        check(name, &program, &with_flow(&program, text, width, seed));
    });
}

/// What takes cells of its own keeps off everything else that does.
#[test]
fn nothing_is_drawn_over_something_else() {
    for_all(|name, _, drawing| keeps_off(name, drawing));
    for_all_scans(|name, _, drawing| keeps_off(name, drawing));
}

fn keeps_off(name: &str, drawing: &Drawing) {
    for rung in &drawing.rungs {
        let mut taken: HashMap<(i32, i32), &Shape> = HashMap::new();
        for part in &rung.parts {
            let (at, width) = match &part.shape {
                Shape::Text(text) => (text.at, text.width),
                Shape::References { at, references, .. } => {
                    (*at, references.to_string().width() as i32)
                }
                Shape::Arrow { at, .. } => (*at, 1),
                Shape::Reading { at, width, .. } => {
                    let text =
                        rung.reading(part.element, &part.shape).map_or(0, |(_, text)| text.width());
                    assert!(text <= *width as usize, "{name}: {:?}", part.shape);
                    (*at, *width)
                }
                _ => continue,
            };
            for x in at.x..at.x + width {
                assert!((1..drawing.width - 1).contains(&x), "{name}: {:?}", part.shape);
                let before = taken.insert((x, at.y), &part.shape);
                assert!(before.is_none(), "{name}: {:?} over {before:?}", part.shape);
            }
        }
        for part in &rung.parts {
            let cells = line_cells(&part.shape);
            for cell in cells {
                let hit = taken.get(&cell);
                // A wire ends at the arrow that goes on.
                let hit = hit.filter(|shape| !matches!(shape, Shape::Arrow { .. }));
                assert!(hit.is_none(), "{name}: {hit:?} on {:?}\n{}", part.shape, rung.written);
            }
        }
    }
}

/// The cells that a line goes through.
fn line_cells(shape: &Shape) -> Vec<(i32, i32)> {
    let area = |x: std::ops::RangeInclusive<i32>, y: std::ops::RangeInclusive<i32>| {
        x.flat_map(|x| y.clone().map(move |y| (x, y))).collect::<Vec<_>>()
    };
    match shape {
        Shape::Wire { from, to, .. } => area(from.x..=to.x, from.y..=to.y),
        Shape::Rail { x, top, bottom } => area(*x..=*x, *top..=*bottom),
        Shape::Frame { from, to } => [
            area(from.x..=to.x, from.y..=from.y),
            area(from.x..=to.x, to.y..=to.y),
            area(from.x..=from.x, from.y..=to.y),
            area(to.x..=to.x, from.y..=to.y),
        ]
        .concat(),
        Shape::Symbol { at, symbol } => {
            let left = at.x - symbol.span() / 2;
            area(left..=left + symbol.span(), at.y..=at.y)
        }
        _ => Vec::new(),
    }
}

/// What the model says of the elements of a rung, numbered as the drawing numbers them.
struct Meant<'p> {
    program: &'p Program,
    random: Rng,
    effects: Vec<Effect>,
    /// Power that arrives, and how many of the pins with circuits have power.
    powers: Vec<(bool, usize)>,
}

impl Meant<'_> {
    fn series(&mut self, series: &Series, mut power: bool) -> bool {
        for element in series {
            power = self.element(element, power);
        }
        power
    }

    fn element(&mut self, element: &Element, power: bool) -> bool {
        let number = self.effects.len();
        let random = self.random.bool();
        self.effects.push(match element {
            Element::Constant(conducts) => Effect::Passes(*conducts),
            Element::Contact { .. }
            | Element::Edge { .. }
            | Element::OneShot { .. }
            | Element::Compare(..) => Effect::Passes(random),
            Element::Invert => Effect::Inverts,
            Element::Call(call) => match self.program.instances[call.instance].shape.block.main {
                Some(_) => Effect::Gives(random),
                None => Effect::Passes(true),
            },
            Element::Net(_) => Effect::Gives(random),
            _ => Effect::Passes(true),
        });
        self.powers.push((power, 0));
        match element {
            Element::Parallel(branches) => branches
                .iter()
                .map(|branch| self.series(branch, power))
                .fold(false, |any, power| any | power),
            Element::Net(net) => {
                for connection in &net.connections {
                    self.series(&connection.network, true);
                }
                self.leaves(number, power)
            }
            Element::Call(call) => {
                for network in call.networks() {
                    let fed = self.series(network, true);
                    self.powers[number].1 += usize::from(fed);
                }
                self.leaves(number, power)
            }
            _ => self.leaves(number, power),
        }
    }

    fn leaves(&self, number: usize, power: bool) -> bool {
        match self.effects[number] {
            Effect::Passes(conducts) => power && conducts,
            Effect::Inverts => !power,
            Effect::Gives(power) => power,
        }
    }
}

/// The wires, symbols, boxes and marks of a drawing, read as a circuit, let the power through as
/// the model does, for contacts that are on and off at random.
#[test]
fn a_drawing_means_what_the_program_means() {
    let mut compared = 0;
    for_all(|name, program, drawing| {
        assert_eq!(program.rungs.len(), drawing.rungs.len());
        for (rung, drawn) in program.rungs.iter().zip(&drawing.rungs) {
            let circuit = Circuit::of(drawing, drawn);
            for seed in 0..4 {
                let random = Rng::with_seed(seed);
                let mut meant = Meant { program, random, effects: Vec::new(), powers: Vec::new() };
                meant.series(&rung.network, true);
                assert_eq!(drawn.elements as usize, meant.effects.len(), "{name}");
                let effect = |element: ElementId| match meant.effects[element as usize] {
                    Effect::Passes(conducts) => Effect::Passes(conducts),
                    Effect::Inverts => Effect::Inverts,
                    Effect::Gives(power) => Effect::Gives(power),
                };
                for (element, powers) in circuit.powers(&effect) {
                    let wanted = meant.powers[element as usize];
                    assert_eq!(powers, wanted, "{name}, element {element}: {}", drawn.written);
                    compared += 1;
                }
            }
        }
    });
    assert!(compared > 10_000, "{compared}");
}

/// Every wire of a drawing that shows a scan is live where its circuit has power in that scan, for
/// what each of its elements did then.
#[test]
fn wires_are_live_where_the_evaluator_has_power() {
    let mut live = [0; 2];
    for_all_scans(|name, _, drawing| {
        for rung in &drawing.rungs {
            let circuit = Circuit::of(drawing, rung);
            let seen = rung.seen.as_ref().unwrap();
            let effect = |element: ElementId| match &seen[element as usize] {
                Seen { power: false, out: true, .. } => Effect::Gives(true),
                Seen { out, .. } => Effect::Passes(*out),
            };
            let wires: Vec<(Point, Power)> = rung
                .parts
                .iter()
                .filter_map(|part| match part.shape {
                    Shape::Wire { from, power, .. } if power != Power::Value => Some((from, power)),
                    _ => None,
                })
                .collect();
            let found = circuit.powers_at(&effect, wires.iter().map(|(at, _)| *at));
            for ((at, power), found) in wires.iter().zip(found) {
                assert_eq!(rung.has_power(*power), found, "{name}, {at:?}: {}", rung.written);
                live[usize::from(found)] += 1;
            }
        }
    });
    assert!(live.iter().all(|&wires| wires > 10_000), "{live:?}");
}

#[derive(Debug, Default, PartialEq, Eq)]
struct Count {
    contacts: usize,
    coils: usize,
    operators: usize,
}

fn count_model(series: &Series, count: &mut Count) {
    for element in series {
        match element {
            Element::Contact { .. } | Element::Edge { .. } => count.contacts += 1,
            Element::Coil { .. } | Element::ResetInstance(_) => count.coils += 1,
            Element::OneShot { .. } | Element::Invert => count.operators += 1,
            Element::Parallel(branches) => {
                branches.iter().for_each(|branch| count_model(branch, count));
            }
            Element::Net(net) => {
                net.connections.iter().for_each(|c| count_model(&c.network, count));
            }
            Element::Call(call) => {
                call.networks().for_each(|network| count_model(network, count));
            }
            _ => {}
        }
    }
}

fn count_drawn(rung: &Rung, count: &mut Count) {
    for part in &rung.parts {
        match part.shape {
            Shape::Symbol { symbol: Symbol::Contact(_), .. } => count.contacts += 1,
            Shape::Symbol { symbol: Symbol::Coil(_), .. } => count.coils += 1,
            Shape::Symbol { symbol: Symbol::Operator(_), .. } => count.operators += 1,
            _ => {}
        }
    }
}

#[test]
fn every_contact_and_every_coil_is_drawn_once() {
    for example in examples() {
        let text = std::fs::read_to_string(&example.ladder).unwrap();
        let (program, drawing) = drawing(&example.name(), &text, 100);
        let (mut meant, mut drawn) = (Count::default(), Count::default());
        program.rungs.iter().for_each(|rung| count_model(&rung.network, &mut meant));
        drawing.rungs.iter().for_each(|rung| count_drawn(rung, &mut drawn));
        assert_eq!(meant, drawn, "{}", example.name());
    }
}

#[test]
fn a_hostile_text_stays_text() {
    let (_, drawing) = drawing("hostile.ladder", HOSTILE, NARROWEST);
    let (text, svg) = (drawing.text(Glyphs::Unicode), drawing.svg());
    for turning in ['\u{202e}', '\u{202c}', '\u{1b}', '\0'] {
        assert!(!text.contains(turning) && !svg.contains(turning), "{turning:?}");
    }
    assert!(!svg.contains("<script") && !svg.contains("<b>"), "{svg}");
    assert_eq!(svg.matches("-->").count(), 1, "{svg}");
    assert_eq!(svg.matches("</title>").count(), 1);
}

/// Twice the program takes about twice the text: nothing is drawn again for each rung.
#[test]
fn a_drawing_grows_with_the_program() {
    let program = |rungs: usize| {
        let rung = "rung go [ a | c.Q ] (S m) { n := n + 1 } u:R_TRIG() (R u)\n";
        let rungs: String = (0..rungs)
            .map(|number| rung.replace("u:", &format!("u{number}:")).replace("(R u)", ""))
            .collect();
        format!(
            "ladder large input go, a output m var n : INT\nrung go c:TON(PT := 5s) (m)\n{rungs}"
        )
    };
    let length = |rungs: usize| {
        let (_, drawing) = drawing("large.ladder", &program(rungs), 100);
        (drawing.text(Glyphs::Unicode).len(), drawing.svg().len())
    };
    let (small, large) = (length(1_000), length(10_000));
    assert!(large.0 < small.0 * 11 && large.1 < small.1 * 11, "{small:?} {large:?}");
}
