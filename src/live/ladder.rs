//! The ladder as one long page of lines, of which a part is seen.

use std::ops::Range;

use crate::draw::{self, Drawing, Glyphs, Line};
use crate::eval::{Flow, Seen};
use crate::source::Source;

/// The rungs below each other, each with its caption and a blank line behind it.
pub(super) struct Ladder {
    drawing: Drawing,
    glyphs: Glyphs,
    /// The first line of each rung, and at the end the number of lines.
    tops: Vec<usize>,
}

impl Ladder {
    /// The ladder of a source without errors, laid out in that many columns.
    pub fn new(source: &Source, columns: usize, glyphs: Glyphs, flow: &Flow) -> Ladder {
        let drawing = Drawing::with_flow(source, &draw::Options { width: columns }, flow);
        let mut tops = vec![0];
        for rung in &drawing.rungs {
            let height = rung.caption(glyphs, drawing.width).len() + rung.height as usize + 1;
            tops.push(tops[tops.len() - 1] + height);
        }
        Ladder { drawing, glyphs, tops }
    }

    /// Shows another scan.
    pub fn show(&mut self, flow: &Flow) {
        self.drawing.show(flow);
    }

    /// The number of rungs.
    pub fn rungs(&self) -> usize {
        self.drawing.rungs.len()
    }

    /// The number of lines.
    pub fn height(&self) -> usize {
        // Nothing needs the blank line behind the last rung.
        self.tops[self.rungs()].saturating_sub(1)
    }

    /// The lines of a rung, from 0.
    pub fn place(&self, rung: usize) -> Range<usize> {
        self.tops[rung]..self.tops[rung + 1] - 1
    }

    /// The rung, from 0, to which a line belongs.
    pub fn rung_at(&self, line: usize) -> usize {
        self.tops.partition_point(|&top| top <= line).clamp(1, self.rungs().max(1)) - 1
    }

    /// The rung, from 0, that a person names by its number or a part of its title.
    pub fn named(&self, name: &str) -> Option<usize> {
        if let Ok(number) = name.parse::<usize>() {
            return number.checked_sub(1).filter(|&rung| rung < self.rungs());
        }
        let name = name.to_lowercase();
        let is_meant = |title: &String| title.to_lowercase().contains(&name);
        self.drawing.rungs.iter().position(|rung| rung.title.as_ref().is_some_and(is_meant))
    }

    /// The lines that are seen, from `top`, each with its number from there.
    pub fn lines(&self, top: usize, rows: usize) -> Vec<(usize, Line)> {
        let mut seen = Vec::new();
        for rung in self.drawing.rungs.iter().skip(self.rung_at(top)) {
            let first = self.tops[rung.number - 1];
            if first >= top + rows {
                break;
            }
            let width = self.drawing.width;
            let lines = rung.caption(self.glyphs, width).into_iter();
            let lines = lines.chain(rung.lines(self.glyphs, width)).zip(first..);
            let is_seen = |line: &usize| (top..top + rows).contains(line);
            seen.extend(lines.filter(|(_, at)| is_seen(at)).map(|(line, at)| (at - top, line)));
        }
        seen
    }
}

/// The first rung, from 0, in which the power is not as it was.
pub(super) fn first_change(before: &Flow, now: &Flow) -> Option<usize> {
    let differ = |(a, b): (&Seen, &Seen)| (a.power, a.out, a.is_on) != (b.power, b.out, b.is_on);
    let mut rungs = before.rungs.iter().zip(&now.rungs);
    rungs.position(|(before, now)| before.iter().zip(now).any(differ))
}
