//! Where the scans of a run stand: stretches between two events, strips of stretches.

use std::fmt::Write;
use std::ops::Range;

use super::Segment;

/// Width of a scan.
pub(super) const SCAN: f32 = 26.0;
/// Scans of a stretch that are drawn; a longer one has a gap.
pub(super) const MOST_SCANS: usize = 6;
/// Widest strip without its names.
const STRIP: f32 = 940.0;

/// The scans between two events.
pub(super) struct Stretch {
    pub(super) scans: Range<usize>,
    pub(super) width: f32,
}

impl Stretch {
    pub(super) fn has_gap(&self) -> bool {
        self.scans.len() > MOST_SCANS
    }

    /// Where its gap is, from its start.
    pub(super) fn gap(&self) -> Range<f32> {
        let end = self.width - SCAN / 2.0;
        if self.has_gap() { end - 1.5 * SCAN..end } else { end..end }
    }
}

/// Which stretches stand in each strip.
pub(super) fn parts(stretches: &[Stretch]) -> Vec<Range<usize>> {
    let mut parts: Vec<Range<usize>> = Vec::new();
    let mut used = 0.0;
    for (index, stretch) in stretches.iter().enumerate() {
        match parts.last_mut() {
            Some(part) if used + stretch.width <= STRIP => part.end = index + 1,
            _ => {
                parts.push(index..index + 1);
                used = 0.0;
            }
        }
        used += stretch.width;
    }
    parts
}

/// Where the stretches of a strip are.
pub(super) struct Ruler<'s> {
    pub(super) stretches: &'s [Stretch],
    pub(super) starts: &'s [f32],
    pub(super) width: f32,
}

/// The part of a segment that stands in a strip.
pub(super) struct InStrip {
    pub(super) x: Range<f32>,
    /// It begins here, not in a strip before.
    pub(super) begins: bool,
    /// Another one follows here.
    pub(super) ends: bool,
}

impl Ruler<'_> {
    pub(super) fn piece(&self, segment: &Segment, drawn: usize) -> Option<InStrip> {
        let (first, last) = (self.stretches.first()?, self.stretches.last()?);
        let end = (segment.start + segment.scans).min(drawn);
        if end <= first.scans.start || segment.start >= last.scans.end {
            return None;
        }
        let at = |scan: usize| {
            let index = self.stretches.partition_point(|stretch| stretch.scans.start < scan);
            self.starts.get(index).copied().unwrap_or(self.width)
        };
        let x = at(segment.start.max(first.scans.start))..at(end);
        let begins = segment.start >= first.scans.start && segment.start > 0;
        Some(InStrip { x, begins, ends: end < last.scans.end })
    }

    /// A line along a row, where no scans are left out and where some are.
    pub(super) fn line(&self, x: Range<f32>, y: f32, line: &mut String, gaps: &mut String) {
        let mut from = x.start;
        for (stretch, start) in self.stretches.iter().zip(self.starts) {
            let gap = start + stretch.gap().start..start + stretch.gap().end;
            if !stretch.has_gap() || gap.start < from || gap.end > x.end {
                continue;
            }
            write(line, format_args!("M{from} {y}H{}", gap.start));
            write(gaps, format_args!("M{} {y}H{}", gap.start, gap.end));
            from = gap.end;
        }
        write(line, format_args!("M{from} {y}H{}", x.end));
    }
}

/// Adds to the data of a path.
pub(super) fn write(text: &mut String, arguments: std::fmt::Arguments) {
    text.write_fmt(arguments).expect("writing to a string does not fail");
}
