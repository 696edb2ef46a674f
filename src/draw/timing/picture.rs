//! A timing diagram as SVG. The scans between two events are a stretch; stretches stand beside each
//! other in strips, as many as fit.

use std::ops::Range;

use askama::Template;

use super::ruler::{InStrip, MOST_SCANS, Ruler, SCAN, Stretch, parts, write};
use super::{Lane, Segment, Timing};
use crate::draw::svg::MADE_BY;
use crate::draw::words::{lines, width};
use crate::quantity;
use crate::types::Type;

/// Around the whole picture, in pixels as everything here.
const MARGIN: f32 = 24.0;
/// From lane to lane.
const LANE: f32 = 32.0;
/// Middle of a lane.
const MIDDLE: f32 = 16.0;
/// From the middle of a lane to a signal that is on or off.
const SWING: f32 = 9.0;
/// How far the ends of a value lean.
const LEAN: f32 = 4.0;
/// Widths of a character of a name, a value and a number of the axis.
const NAME: f32 = 7.9;
const VALUE: f32 = 7.3;
const NUMBER: f32 = 6.7;
/// Rows of the axis below the lanes, and the room below them.
const AXIS: f32 = 62.0;
/// Changes of a signal that a screen reader is told.
const MOST_TOLD: usize = 24;

#[derive(Template)]
#[template(path = "timing.svg")]
struct Page<'t> {
    made_by: &'static str,
    version: &'static str,
    name: &'t str,
    title: Option<&'t str>,
    about: &'t str,
    width: f32,
    height: f32,
    heading: Vec<(&'static str, f32, String)>,
    strips: Vec<Strip<'t>>,
}

/// A part of the run, its places relative to its own corner: the start of its waves.
struct Strip<'t> {
    x: f32,
    y: f32,
    width: f32,
    /// Vertical lines where something happens.
    grid: String,
    lanes: Vec<Wave<'t>>,
    axis_y: f32,
    axis: String,
    numbers: Vec<Number>,
}

/// A signal in a strip.
struct Wave<'t> {
    name: &'t str,
    label: String,
    y: f32,
    is_word: bool,
    /// Where it is on, or has a value.
    fill: String,
    line: String,
    /// Where scans are left out.
    gaps: String,
    values: Vec<(f32, String)>,
}

/// A number at the axis.
struct Number {
    x: f32,
    y: f32,
    class: &'static str,
    text: String,
}

impl Timing {
    /// The diagram as one SVG picture: no scripts, no fonts or files of elsewhere.
    pub fn svg(&self) -> String {
        let lanes: Vec<&Lane> = self.shown();
        let stretches = self.stretches(&lanes);
        let names = lanes.iter().map(|lane| width(&lane.name)).max().unwrap_or(0);
        let x = MARGIN + (names.max(4) as f32 * NAME).round() + 10.0;
        let about = self.about();
        let mut y = MARGIN + 16.0;
        let mut heading = vec![("head", y, self.name.clone())];
        let title = self.title.iter().map(|title| ("note", title));
        let note = self.note.iter().map(|note| ("title", note));
        let notes = title.chain(note).chain([("note", &about)]);
        for (class, note) in notes {
            for line in lines(note, 100) {
                y += 20.0;
                heading.push((class, y, line));
            }
        }
        let widest = heading.iter().map(|(_, _, line)| width(line)).max().unwrap_or(0);
        y += 26.0;
        let mut strips = Vec::new();
        for part in parts(&stretches) {
            let strip = self.strip(&lanes, &stretches, part, (x, y));
            y += strip.axis_y + AXIS;
            strips.push(strip);
        }
        let drawn = strips.iter().map(|strip| strip.x + strip.width).fold(0.0, f32::max);
        let page = Page {
            made_by: MADE_BY,
            version: env!("CARGO_PKG_VERSION"),
            name: &self.name,
            title: self.title.as_deref(),
            about: &about,
            width: (drawn + 2.0 * MARGIN).max(widest as f32 * 10.0 + 2.0 * MARGIN).ceil(),
            height: (y + MARGIN / 2.0).ceil(),
            heading,
            strips,
        };
        let mut text = page.render().expect("writing to a string does not fail");
        // A template loses the end of its last line.
        text.push('\n');
        text
    }

    /// The tick is shown where not every scan has it.
    fn shown(&self) -> Vec<&Lane> {
        let always = matches!(&self.tick.segments[..], [] | [Segment { first: 1, .. }]);
        let tick = (!always).then_some(&self.tick);
        tick.into_iter().chain(&self.lanes).collect()
    }

    fn about(&self) -> String {
        let tick = quantity::time_text(self.tick_ns.into());
        let last = self.drawn.saturating_sub(1);
        let scans = match self.scans {
            0 => return "no scan".to_owned(),
            1 => "scan 0".to_owned(),
            _ => format!("scans 0 to {last}"),
        };
        let more = match self.drawn < self.scans {
            true => format!(" of {}: too much happens to draw them all", self.scans),
            false => String::new(),
        };
        format!("{scans}{more}, a tick is {tick}")
    }

    /// The stretches, each as wide as its scans or as a value that is there only.
    fn stretches(&self, lanes: &[&Lane]) -> Vec<Stretch> {
        let ends = self.events.iter().skip(1).copied().chain([self.drawn]);
        let ranges = self.events.iter().zip(ends).map(|(&start, end)| start..end);
        let ranges = ranges.filter(|range| range.start < self.drawn);
        let mut stretches: Vec<Stretch> = ranges
            .map(|scans| {
                let width = scans.len().min(MOST_SCANS) as f32 * SCAN;
                Stretch { scans, width }
            })
            .collect();
        for lane in lanes.iter().filter(|lane| lane.ty != Type::Bool) {
            for segment in &lane.segments {
                let text = lane.text(segment, self.tick_ns);
                let needed = width(&text) as f32 * VALUE + 2.0 * LEAN + 6.0;
                let end = segment.start + segment.scans;
                let first = stretches.partition_point(|s| s.scans.start < segment.start);
                let last = stretches.partition_point(|s| s.scans.start < end);
                let has: f32 = stretches[first..last].iter().map(|stretch| stretch.width).sum();
                if let Some(stretch) = stretches.get_mut(first)
                    && has < needed
                {
                    stretch.width += (needed - has).ceil();
                }
            }
        }
        stretches
    }

    fn strip<'t>(
        &self,
        lanes: &[&'t Lane],
        stretches: &[Stretch],
        part: Range<usize>,
        (x, y): (f32, f32),
    ) -> Strip<'t> {
        let mut starts = Vec::new();
        let mut end = 0.0;
        for stretch in &stretches[part.clone()] {
            starts.push(end);
            end += stretch.width;
        }
        let of_strip = &stretches[part.clone()];
        let ruler = Ruler { stretches: of_strip, starts: &starts, width: end };
        let axis_y = lanes.len() as f32 * LANE + 6.0;
        let mut grid = String::new();
        for start in &starts {
            write(&mut grid, format_args!("M{start} 0V{axis_y}"));
        }
        let wave = |(lane, row): (&&'t Lane, i32)| {
            let mut wave = Wave {
                name: &lane.name,
                label: self.told(lane),
                y: row as f32 * LANE,
                is_word: lane.ty != Type::Bool,
                fill: String::new(),
                line: String::new(),
                gaps: String::new(),
                values: Vec::new(),
            };
            for (index, segment) in lane.segments.iter().enumerate() {
                if let Some(piece) = ruler.piece(segment, self.drawn) {
                    match lane.ty {
                        Type::Bool => wave.level(&ruler, &piece, segment.first != 0, index > 0),
                        _ => wave.value(&ruler, &piece, lane.text(segment, self.tick_ns)),
                    }
                }
            }
            wave
        };
        let waves = lanes.iter().zip(0..).map(wave).collect();
        let (axis, numbers) = self.axis(&ruler, part.start, axis_y);
        Strip { x, y, width: end, grid, lanes: waves, axis_y, axis, numbers }
    }

    /// The axis with a mark for each scan, and numbers where something happens.
    fn axis(&self, ruler: &Ruler, first: usize, y: f32) -> (String, Vec<Number>) {
        let mut axis = String::new();
        ruler.line(0.0..ruler.width, y, &mut axis, &mut String::new());
        let mut numbers = vec![
            Number { x: -10.0, y: y + 20.0, class: "axis e", text: "scan".to_owned() },
            Number { x: -10.0, y: y + 36.0, class: "axis e", text: "time".to_owned() },
        ];
        let mut free = [0.0_f32; 2];
        let mut before = String::new();
        for (index, (stretch, &start)) in ruler.stretches.iter().zip(ruler.starts).enumerate() {
            let marks = if stretch.has_gap() { 1 } else { stretch.scans.len() };
            for mark in 0..marks {
                let x = start + mark as f32 * (stretch.width / marks as f32);
                write(&mut axis, format_args!("M{x} {y}v{}", if mark == 0 { 6 } else { 3 }));
            }
            if stretch.has_gap() {
                let x = start + (stretch.gap().start + stretch.gap().end) / 2.0;
                let (up, down) = (y - 5.0, y + 5.0);
                for x in [x - 4.0, x + 3.0] {
                    write(&mut axis, format_args!("M{} {down}L{} {up}", x - 3.0, x + 3.0));
                }
            }
            let ticks = i128::from(self.ticks_at_events[first + index]);
            let time = quantity::time_text(ticks * i128::from(self.tick_ns));
            for (row, text) in [stretch.scans.start.to_string(), time].into_iter().enumerate() {
                let half = width(&text) as f32 * NUMBER / 2.0;
                // Without the tick time stands still.
                if row == 1 && std::mem::replace(&mut before, text.clone()) == text {
                    continue;
                }
                if index == 0 || start - half > free[row] {
                    free[row] = start + half + 6.0;
                    let y = y + 20.0 + 16.0 * row as f32;
                    let (x, class) = if index == 0 { (0.0, "axis") } else { (start, "axis m") };
                    free[row] += if index == 0 { half } else { 0.0 };
                    numbers.push(Number { x, y, class, text });
                }
            }
        }
        (axis, numbers)
    }

    /// A signal for somebody who hears it.
    fn told(&self, lane: &Lane) -> String {
        let mut told = lane.name.clone();
        for segment in lane.segments.iter().take(MOST_TOLD) {
            let sign = if segment.start == 0 { ":" } else { "," };
            let text = lane.text(segment, self.tick_ns);
            told += &format!("{sign} {text} from scan {}", segment.start);
        }
        if lane.segments.len() > MOST_TOLD {
            told += ", and so on";
        }
        told
    }
}

impl Wave<'_> {
    /// A bit that is on or off.
    fn level(&mut self, ruler: &Ruler, piece: &InStrip, is_on: bool, changes: bool) {
        let (high, low) = (MIDDLE - SWING, MIDDLE + SWING);
        let Range { start, end } = piece.x;
        if piece.begins && changes {
            write(&mut self.line, format_args!("M{start} {low}V{high}"));
        }
        let y = if is_on { high } else { low };
        ruler.line(start..end, y, &mut self.line, &mut self.gaps);
        if is_on {
            write(&mut self.fill, format_args!("M{start} {low}V{high}H{end}V{low}Z"));
        }
    }

    /// A number or a time between two lines.
    fn value(&mut self, ruler: &Ruler, piece: &InStrip, text: String) {
        let (high, low) = (MIDDLE - SWING, MIDDLE + SWING);
        let Range { start, end } = piece.x;
        let from = if piece.begins { start + LEAN } else { start };
        let to = if piece.ends { end - LEAN } else { end };
        ruler.line(from..to, high, &mut self.line, &mut self.gaps);
        ruler.line(from..to, low, &mut self.line, &mut self.gaps);
        if piece.begins {
            write(&mut self.line, format_args!("M{from} {high}L{start} {MIDDLE}L{from} {low}"));
        }
        if piece.ends {
            write(&mut self.line, format_args!("M{to} {high}L{end} {MIDDLE}L{to} {low}"));
        }
        write(
            &mut self.fill,
            format_args!("M{start} {MIDDLE}L{from} {high}H{to}L{end} {MIDDLE}L{to} {low}H{from}Z"),
        );
        if width(&text) as f32 * VALUE + 2.0 * LEAN <= end - start {
            self.values.push(((start + end) / 2.0, text));
        }
    }
}
