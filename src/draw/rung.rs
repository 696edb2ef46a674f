//! One rung between its rails.

use std::collections::HashMap;

use super::cells::{Align, ElementId, Form, Part, Point, Power, Shape, Style, Symbol};
use super::fit::{Fitter, From};
use super::node::{END, START, Series};
use super::place::Placer;
use super::words::width;
use crate::eval::Seen;

/// One rung.
#[derive(Clone, Debug, Default)]
pub struct Rung {
    /// Its number, from 1.
    pub number: usize,
    /// Its title.
    pub title: Option<String>,
    /// The line, from 1, on which it starts.
    pub line: u32,
    /// The comment above it, line by line.
    pub comment: Vec<String>,
    /// The rung as it is written, on one line.
    pub written: String,
    /// How many elements it has.
    pub elements: ElementId,
    /// How many rows it takes.
    pub height: i32,
    /// What is drawn.
    pub parts: Vec<Part>,
    /// What its elements did in the scan that is shown, if one is.
    pub seen: Option<Vec<Seen>>,
    /// That scan, where it is not the same for the whole drawing.
    pub scan: Option<usize>,
}

impl Rung {
    /// Where it stands, and in which scan it is seen.
    pub(super) fn place(&self) -> String {
        let scan = self.scan.map(|scan| format!("scan {scan}, ")).unwrap_or_default();
        format!("{scan}line {}", self.line)
    }

    /// True if there is power in the scan that is shown; false if none is.
    pub fn has_power(&self, power: Power) -> bool {
        let Some(seen) = &self.seen else { return false };
        match power {
            Power::Into(element) => seen[element as usize].power,
            Power::OutOf(element) => seen[element as usize].out,
            Power::Node { net, connection, end } => seen[net as usize].ends[connection][end],
            Power::Rail => true,
            Power::Value => false,
        }
    }

    /// What an element did in the scan that is shown.
    pub fn seen(&self, element: Option<ElementId>) -> Option<&Seen> {
        Some(&self.seen.as_ref()?[element? as usize])
    }

    /// The first cell and the text of a value in the scan that is shown.
    pub fn reading(&self, element: Option<ElementId>, shape: &Shape) -> Option<(Point, String)> {
        let Shape::Reading { at, width: room, reading, form, align } = shape else { return None };
        let text = form.written(&self.seen(element)?.readings[*reading]);
        let spare = match align {
            Align::Start => 0,
            Align::Middle => (room - width(&text)) / 2,
            Align::End => room - width(&text),
        };
        Some((Point { x: at.x + spare, ..*at }, text))
    }

    /// What the elements did in the scan that is shown, for somebody who hears it.
    pub(super) fn told(&self) -> String {
        let Some(seen) = &self.seen else { return String::new() };
        let mut told = Vec::new();
        for part in &self.parts {
            let (Some(element), Some(state)) = (part.element, self.seen(part.element)) else {
                continue;
            };
            let say = |on: &'static str, off: &'static str| if state.is_on { on } else { off };
            let what = match &part.shape {
                Shape::Symbol { symbol: Symbol::Contact(_), .. } => say("conducts", "is open"),
                Shape::Symbol { symbol: Symbol::Coil(_), .. } => say("is on", "is off"),
                Shape::Frame { .. } => {
                    let name = self.label(element);
                    let of = if name.is_empty() { name } else { format!("{name}.") };
                    let readings = state.readings.iter();
                    told.extend(readings.map(|reading| of.clone() + &Form::Named.written(reading)));
                    continue;
                }
                _ => continue,
            };
            told.push(format!("{} {what}", self.label(element)));
        }
        let power = seen.last().is_some_and(|last| last.out);
        let power = if power { "power to the right end" } else { "no power at the right end" };
        format!(
            ". In this scan: {}{power}",
            told.iter().map(|text| format!("{text}, ")).collect::<String>()
        )
    }

    /// The name over a contact, a coil or a block.
    fn label(&self, element: ElementId) -> String {
        let names = self.parts.iter().filter_map(|part| match &part.shape {
            Shape::Text(text) if part.element == Some(element) => {
                matches!(text.style, Style::Name | Style::Instance).then_some(text.text.as_str())
            }
            _ => None,
        });
        let mut names: Vec<&str> = names.collect();
        // Their last line is placed first.
        names.reverse();
        names.concat()
    }

    /// A series between rails that are `columns` columns apart, itself included.
    pub(super) fn laid_out(series: Series, columns: i32) -> Self {
        let right = columns - 1;
        let mut fitter = Fitter::default();
        let mut placer = Placer::default();
        let series = fitter.series(series, right);
        let entry = series.size.above;
        let bottom = entry + series.size.below;
        let to_rail = series.ends_with_output();
        placer.series(&series, Point { x: 0, y: entry }, right, to_rail);
        reach_the_rail(&mut placer);
        for x in [0, right] {
            placer.part(None, Shape::Rail { x, top: 0, bottom });
        }
        let mut free = bottom + 2;
        while let Some(detail) = fitter.details.pop_front() {
            let series = fitter.detail(detail.series, right - START - END);
            let at = Point { x: START, y: free + series.size.above };
            let end = right - END;
            free = at.y + series.size.below + 2;
            match detail.from {
                From::Rail => placer.stub(at),
                From::Mark => {
                    let arrow = Point { x: START - 1, ..at };
                    placer.mark(&detail.mark, Point { x: START - 2, ..at }, Align::End);
                    placer.arrow(arrow, false, detail.ends.entry);
                    placer.wire(arrow, at, detail.ends.entry);
                }
            }
            placer.series(&series, at, end - at.x, false);
            let exit = at.y + series.exit;
            let arrow = Point { x: end + 1, y: exit };
            placer.wire(Point { x: end, y: exit }, arrow, detail.ends.exit);
            placer.arrow(arrow, false, detail.ends.exit);
            placer.mark(&detail.mark, Point { x: end + 2, y: exit }, Align::Start);
        }
        for at in std::mem::take(&mut placer.stubs) {
            placer.part(None, Shape::Rail { x: at.x, top: at.y, bottom: at.y });
        }
        Rung { height: free - 1, parts: placer.parts, ..Rung::default() }
    }
}

/// Leads circuits that start at a rail of their own to the left rail, where nothing is in the way.
fn reach_the_rail(placer: &mut Placer) {
    if placer.stubs.is_empty() {
        return;
    }
    let mut leftmost: HashMap<i32, i32> = HashMap::new();
    let mut seen = |y: i32, x: i32| {
        let least = leftmost.entry(y).or_insert(x);
        *least = x.min(*least);
    };
    for part in &placer.parts {
        match &part.shape {
            Shape::Wire { from, to, .. } | Shape::Frame { from, to } => {
                (from.y..=to.y).for_each(|y| seen(y, from.x));
            }
            Shape::Symbol { at, .. }
            | Shape::References { at, .. }
            | Shape::Arrow { at, .. }
            | Shape::Reading { at, .. }
            | Shape::Dot { at, .. } => seen(at.y, at.x),
            Shape::Text(text) => seen(text.at.y, text.at.x),
            Shape::Rail { .. } => {}
        }
    }
    let stubs = std::mem::take(&mut placer.stubs);
    for at in stubs {
        if leftmost.get(&at.y).is_none_or(|&x| x >= at.x) {
            placer.wire(Point { x: 0, ..at }, at, Power::Rail);
        } else {
            placer.stub(at);
        }
    }
}
