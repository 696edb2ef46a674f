//! Reads the circuit back from a drawing: what is joined with what, and where power arrives.

use std::collections::HashMap;

use hotrail::draw::{Align, Drawing, ElementId, Point, Rung, Shape, Style};

/// What an element does to the power, as the model tells it.
pub enum Effect {
    /// Power comes out where power goes in, if this holds.
    Passes(bool),
    /// Power comes out where none goes in.
    Inverts,
    /// Power comes out if this holds, whatever goes in.
    Gives(bool),
}

/// Elements with a drawing of their own.
struct Drawn {
    left: Point,
    right: Point,
    /// The side at the left, if it is a box: its column, its first and its last row.
    side: Option<(i32, i32, i32)>,
}

/// The wires of a rung.
pub struct Circuit {
    /// For each cell of a wire along a column, the one that stands for all that it is joined with.
    joined: HashMap<(i32, i32), (i32, i32)>,
    drawn: HashMap<ElementId, Drawn>,
    /// Boxes that stand for what is drawn further down.
    put_off: Vec<Drawn>,
    /// Where power comes from.
    sources: Vec<Point>,
    /// Where power comes from and where it goes to: along rows, and from mark to mark.
    jumps: Vec<(Point, Point)>,
}

fn key(at: Point) -> (i32, i32) {
    (at.x, at.y)
}

impl Circuit {
    pub fn of(drawing: &Drawing, rung: &Rung) -> Self {
        let mut circuit = Circuit {
            joined: HashMap::new(),
            drawn: HashMap::new(),
            put_off: Vec::new(),
            sources: Vec::new(),
            jumps: Vec::new(),
        };
        for part in &rung.parts {
            match &part.shape {
                Shape::Wire { from, to, .. } => circuit.wire(*from, *to),
                Shape::Rail { x, top, bottom } if *x != drawing.width - 1 => {
                    circuit.sources.extend((*top..=*bottom).map(|y| Point { x: *x, y }));
                }
                Shape::Symbol { at, symbol } => {
                    let left = at.x - symbol.span() / 2;
                    let right = Point { x: left + symbol.span(), ..*at };
                    let drawn = Drawn { left: Point { x: left, ..*at }, right, side: None };
                    circuit.drawn.insert(part.element.unwrap(), drawn);
                }
                Shape::Frame { from, to } => {
                    // A block has the row of its kind above the row of its power.
                    let is_block = rung.parts.iter().any(|other| {
                        matches!(&other.shape, Shape::Text(text) if text.style == Style::Kind)
                            && other.element == part.element
                    });
                    let y = from.y + if is_block { 2 } else { 1 };
                    let drawn = Drawn {
                        left: Point { x: from.x, y },
                        right: Point { x: to.x, y },
                        side: Some((from.x, y + 1, to.y)),
                    };
                    match part.element {
                        Some(element) => {
                            let twice = circuit.drawn.insert(element, drawn);
                            assert!(twice.is_none(), "element {element} is drawn twice");
                        }
                        None => circuit.put_off.push(drawn),
                    }
                }
                // The connections of a network are looked at one by one, each fed with power.
                // In a scan only some of their nodes have power.
                Shape::Dot { at, power } if rung.seen.is_none() || rung.has_power(*power) => {
                    circuit.sources.push(*at);
                }
                _ => {}
            }
        }
        circuit.follow_marks(rung);
        circuit
    }

    /// Power runs from left to right, as in every ladder, and both ways along a column.
    fn wire(&mut self, from: Point, to: Point) {
        if from.y == to.y {
            return self.jumps.push((from, to));
        }
        for y in from.y..=to.y {
            let (a, b) = (self.node(from), self.node(Point { y, ..from }));
            self.joined.insert(b, a);
        }
    }

    fn node(&self, at: Point) -> (i32, i32) {
        let mut cell = key(at);
        while let Some(&next) = self.joined.get(&cell).filter(|&&next| next != cell) {
            cell = next;
        }
        cell
    }

    fn follow_marks(&mut self, rung: &Rung) {
        let mut from: HashMap<&str, Point> = HashMap::new();
        let mut to: HashMap<&str, Point> = HashMap::new();
        let mut boxes = Vec::new();
        for part in &rung.parts {
            let Shape::Text(text) = &part.shape else { continue };
            if text.style != Style::Mark {
                continue;
            }
            let beside = |x| Point { x, ..text.at };
            let previous = match text.align {
                Align::Start => from.insert(&text.text, beside(text.at.x - 1)),
                Align::End => to.insert(&text.text, beside(text.at.x + text.width)),
                Align::Middle => {
                    boxes.push((text.text.as_str(), text.at));
                    None
                }
            };
            assert_eq!(previous, None, "two marks {}", text.text);
        }
        for (mark, at) in boxes {
            let holds = |drawn: &&Drawn| {
                drawn.left.y == at.y && drawn.left.x < at.x && at.x < drawn.right.x
            };
            let drawn = self.put_off.iter().find(holds).unwrap();
            self.jumps.push((drawn.left, to.remove(mark).unwrap()));
            self.jumps.push((from.remove(mark).unwrap(), drawn.right));
        }
        for (mark, at) in to {
            self.jumps.push((from.remove(mark).unwrap_or_else(|| panic!("no mark {mark}")), at));
        }
        assert!(from.is_empty(), "{from:?} lead nowhere");
    }

    /// For each element that is drawn, whether power arrives, and at how many of its pins.
    pub fn powers(
        &self,
        effect: &dyn Fn(ElementId) -> Effect,
    ) -> HashMap<ElementId, (bool, usize)> {
        self.walk(effect, |walk| {
            let power = |(&element, drawn): (&ElementId, &Drawn)| {
                let pins = drawn.side.map_or(0, |(x, first, last)| {
                    (first..last).filter(|&y| walk.has_power(Point { x, y })).count()
                });
                (element, (walk.has_power(drawn.left), pins))
            };
            self.drawn.iter().map(power).collect()
        })
    }

    /// Whether power comes to each of these places.
    pub fn powers_at(
        &self,
        effect: &dyn Fn(ElementId) -> Effect,
        places: impl Iterator<Item = Point>,
    ) -> Vec<bool> {
        self.walk(effect, |walk| places.map(|at| walk.has_power(at)).collect())
    }

    fn walk<T>(&self, effect: &dyn Fn(ElementId) -> Effect, ask: impl FnOnce(&mut Walk) -> T) -> T {
        let mut drivers: HashMap<(i32, i32), Vec<Driver>> = HashMap::new();
        let mut drive = |at: Point, driver| {
            drivers.entry(self.node(at)).or_default().push(driver);
        };
        self.sources.iter().for_each(|&at| drive(at, Driver::Rail));
        self.jumps.iter().for_each(|&(from, to)| drive(to, Driver::Jump(from)));
        for (&element, drawn) in &self.drawn {
            drive(drawn.right, Driver::Element(element));
        }
        let mut known = HashMap::new();
        ask(&mut Walk { circuit: self, drivers: &drivers, effect, known: &mut known })
    }
}

enum Driver {
    Rail,
    Jump(Point),
    Element(ElementId),
}

struct Walk<'a> {
    circuit: &'a Circuit,
    drivers: &'a HashMap<(i32, i32), Vec<Driver>>,
    effect: &'a dyn Fn(ElementId) -> Effect,
    known: &'a mut HashMap<(i32, i32), bool>,
}

impl Walk<'_> {
    fn has_power(&mut self, at: Point) -> bool {
        let node = self.circuit.node(at);
        if let Some(&power) = self.known.get(&node) {
            return power;
        }
        let drivers = self.drivers.get(&node).map_or(&[][..], Vec::as_slice);
        let power = drivers.iter().any(|driver| match driver {
            Driver::Rail => true,
            Driver::Jump(from) => self.has_power(*from),
            Driver::Element(element) => match (self.effect)(*element) {
                Effect::Passes(conducts) => {
                    conducts && self.has_power(self.circuit.drawn[element].left)
                }
                Effect::Inverts => !self.has_power(self.circuit.drawn[element].left),
                Effect::Gives(power) => power,
            },
        });
        self.known.insert(node, power);
        power
    }
}
