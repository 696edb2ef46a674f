//! Which part of the screen shows what.

use ratatui_core::layout::Rect;

use crate::draw::NARROWEST;

/// The narrowest screen that shows a ladder, in columns.
pub const LEAST_COLUMNS: u16 = NARROWEST as u16;
/// The lowest screen that shows a ladder, in rows.
pub const LEAST_ROWS: u16 = 20;

/// Columns of the lists where they stand beside the ladder.
const SIDE: u16 = 44;
/// Of lists below the ladder, the columns of the first two out of 80.
const BELOW: [u16; 2] = [23, 19];

/// The number of lists: inputs, outputs, timers and variables.
pub(super) const LISTS: usize = 3;

/// The parts of a screen.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Layout {
    pub header: Rect,
    pub ladder: Rect,
    /// Each with its title in the first row.
    pub lists: [Rect; LISTS],
    pub footer: Rect,
}

impl Layout {
    /// All between header and footer.
    pub fn middle(&self) -> Rect {
        self.lists.iter().fold(self.ladder, |all, list| all.union(*list))
    }

    /// The parts of a screen for lists of these lengths, or nothing where it is too small.
    pub fn of(columns: u16, rows: u16, lengths: [usize; LISTS]) -> Option<Layout> {
        if columns < LEAST_COLUMNS || rows < LEAST_ROWS {
            return None;
        }
        let row = |y| Rect::new(0, y, columns, 1);
        let middle = Rect::new(0, 1, columns, rows - 2);
        let needs = lengths.map(|length| u16::try_from(length + 1).unwrap_or(u16::MAX));
        let is_beside = columns > LEAST_COLUMNS + SIDE;
        let (ladder, lists) = if is_beside { beside(middle, needs) } else { below(middle, needs) };
        Some(Layout { header: row(0), ladder, lists, footer: row(rows - 1) })
    }
}

/// Lists in a column at the right.
fn beside(area: Rect, needs: [u16; LISTS]) -> (Rect, [Rect; LISTS]) {
    let ladder = Rect { width: area.width - SIDE - 1, ..area };
    let mut y = area.y;
    let mut left = area.height;
    let mut lists = [Rect::default(); LISTS];
    for list in 0..LISTS {
        // Those below get a fair share, or what they need where that is less.
        let share = left / (LISTS - list) as u16;
        let below: u16 = needs[list + 1..].iter().map(|&need| need.min(share)).sum();
        let height = if list + 1 == LISTS { left } else { needs[list].min(left - below) };
        lists[list] = Rect::new(area.right() - SIDE, y, SIDE, height);
        (y, left) = (y + height, left - height);
    }
    (ladder, lists)
}

/// Lists beside each other below the ladder.
fn below(area: Rect, needs: [u16; LISTS]) -> (Rect, [Rect; LISTS]) {
    let longest = needs.into_iter().max().unwrap_or(1);
    let height = longest.clamp(3, area.height / 3);
    let ladder = Rect { height: area.height - height, ..area };
    let [first, second] = BELOW.map(|share| area.width * share / LEAST_COLUMNS);
    let list = |x, width| Rect::new(x, ladder.bottom(), width, height);
    let rest = area.width - first - second;
    (ladder, [list(0, first), list(first, second), list(first + second, rest)])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every cell below the header belongs to one part at most, and none lies outside.
    #[test]
    fn parts_do_not_meet() {
        for (columns, rows) in [(80, 20), (80, 24), (124, 30), (125, 20), (200, 60), (999, 20)] {
            for lengths in [[0, 0, 0], [3, 2, 1], [1000, 1, 1], [1, 1000, 1000], [70_000; 3]] {
                let layout = Layout::of(columns, rows, lengths).unwrap();
                let screen = Rect::new(0, 0, columns, rows);
                let mut parts = vec![layout.header, layout.ladder, layout.footer];
                parts.extend(layout.lists);
                for (index, part) in parts.iter().enumerate() {
                    assert_eq!(part.intersection(screen), *part, "{layout:?}");
                    let meets = |other: &Rect| other.intersects(*part) && part.area() > 0;
                    assert!(!parts[..index].iter().any(meets), "{layout:?}");
                }
                assert!(layout.ladder.width >= LEAST_COLUMNS && layout.ladder.height >= 8);
                assert!(layout.lists.iter().all(|list| list.height > 0), "{layout:?}");
            }
        }
        assert_eq!(Layout::of(79, 24, [1, 1, 1]), None);
        assert_eq!(Layout::of(80, 19, [1, 1, 1]), None);
    }
}
