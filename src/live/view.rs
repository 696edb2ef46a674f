//! The picture of a state, cell by cell.

use ratatui_core::buffer::Buffer;
use ratatui_core::layout::Rect;
use ratatui_core::style::{Color, Modifier, Style};

use super::key::HELP;
use super::layout::{LEAST_COLUMNS, LEAST_ROWS, LISTS};
use super::prompt::{Prompt, Question};
use super::state::{INPUTS, Mode};
use super::values::{self, Entry};
use super::{Live, Session};
use crate::draw::{Glyphs, Look, harmless};
use crate::quantity;

const TITLES: [&str; LISTS] = ["inputs", "outputs", "timers and variables"];
const KEYS: &str = "space run/pause  s scan  enter switch  p pulse  f follow  ? keys  q quit";

impl Live<'_> {
    /// Draws everything into the buffer of a screen.
    pub fn draw(&self, screen: &mut Buffer) {
        let Some(layout) = &self.layout else { return too_small(screen) };
        self.header(screen, layout.header);
        self.rungs(screen, layout.ladder);
        for (list, &area) in layout.lists.iter().enumerate() {
            self.list(screen, list, area);
        }
        self.footer(screen, layout.footer);
        if let Mode::Help = self.mode {
            self.help(screen, layout.middle());
        }
    }

    fn color(&self, color: Color) -> Style {
        if self.options.has_color { Style::new().fg(color) } else { Style::new() }
    }

    /// How something looks that has power or is on.
    fn on(&self) -> Style {
        self.color(Color::Green).add_modifier(Modifier::BOLD)
    }

    fn look(&self, look: Look) -> Style {
        match look {
            Look::Plain => Style::new(),
            Look::Live => self.on(),
            Look::Value => self.color(Color::Cyan),
            Look::Decides => self.color(Color::Yellow).add_modifier(Modifier::BOLD),
        }
    }

    fn header(&self, screen: &mut Buffer, area: Rect) {
        let session = &self.session;
        let program = session.program();
        let state = match (self.clock.is_running(), self.clock.is_late()) {
            (false, _) => "paused".to_owned(),
            (true, false) => format!("running, {}", self.clock.speed()),
            (true, true) => format!("running, behind {}", self.clock.speed()),
        };
        let time = i128::from(session.ticks()) * i128::from(program.tick_ns);
        let scan = match session.scans().checked_sub(1) {
            Some(scan) => format!("scan {scan}  {}", quantity::time_text(time)),
            None => "at reset".to_owned(),
        };
        let rows = match session.rows_left() {
            0 => String::new(),
            rows => format!("  stimulus {rows} to come"),
        };
        let follow = if self.follows { "  follow" } else { "" };
        let rung = self.ladder.rung_at(self.top) + 1;
        let right = format!("{state}  {scan}{rows}{follow}  rung {rung}/{} ", self.ladder.rungs());
        let bar = Style::new().add_modifier(Modifier::REVERSED);
        screen.set_style(area, bar);
        let room = area.width.saturating_sub(right.chars().count() as u16);
        put(screen, area, &format!(" {}", program.name), bar.add_modifier(Modifier::BOLD));
        put(screen, Rect { x: room, width: area.width - room, ..area }, &right, bar);
    }

    fn rungs(&self, screen: &mut Buffer, area: Rect) {
        for (row, line) in self.ladder.lines(self.top, area.height.into()) {
            let mut left = Rect { y: area.y + row as u16, height: 1, ..area };
            for piece in line {
                left = put(screen, left, &piece.text, self.look(piece.look));
            }
        }
    }

    fn list(&self, screen: &mut Buffer, list: usize, area: Rect) {
        let is_chosen = list == self.focus;
        let bar = Style::new().add_modifier(Modifier::UNDERLINED);
        let bar = if is_chosen { bar.add_modifier(Modifier::BOLD) } else { bar };
        let title = Rect { height: 1, width: area.width - 1, ..area };
        screen.set_style(title, bar);
        let rows = usize::from(area.height) - 1;
        let entries = &self.lists[list];
        let top = (self.chosen[list] + 1).saturating_sub(rows);
        let hidden =
            if entries.len() > rows { format!(" ({})", entries.len()) } else { String::new() };
        put(screen, title, &format!("{}{hidden}", TITLES[list]), bar);
        let shown = entries.iter().enumerate().skip(top).take(rows);
        for ((number, &entry), y) in shown.zip(title.y + 1..) {
            self.entry(screen, (list, number), entry, Rect { y, ..title });
        }
    }

    fn entry(&self, screen: &mut Buffer, at: (usize, usize), entry: Entry, area: Rect) {
        let (list, number) = at;
        let is_input = list == INPUTS;
        let is_chosen = self.chosen[list] == number && (is_input || list == self.focus);
        let cursor = if is_chosen { ">" } else { " " };
        let digit = match number {
            0..9 if is_input => format!("{} ", number + 1),
            _ if is_input => "  ".to_owned(),
            _ => String::new(),
        };
        let (name, is_on) = values::name(&self.session, entry);
        let value = match is_input {
            true => self.input_value(number, entry),
            false => values::value(&self.session, entry),
        };
        let style = if is_on { self.on() } else { Style::new() };
        let name_style = if is_chosen { style.add_modifier(Modifier::REVERSED) } else { style };
        let rest = put(screen, area, &format!("{cursor}{digit}"), Style::new());
        // A name gets what the value leaves, but half of the room at least.
        let wide = value.chars().count() as u16;
        let room = rest.width.saturating_sub(wide + 1).max(rest.width / 2);
        let behind = put(screen, Rect { width: room, ..rest }, &name, name_style).x;
        let x = match entry {
            Entry::Instance(_) => behind + 2,
            Entry::Variable(_) => area.right().saturating_sub(wide).max(behind + 1),
        };
        let width = area.right().saturating_sub(x);
        put(screen, Rect { x, width, ..area }, &value, style);
    }

    /// What the last scan saw of an input, and what the next will see.
    fn input_value(&self, number: usize, entry: Entry) -> String {
        let Entry::Variable(input) = entry else { unreachable!("inputs are variables") };
        let text = |value| values::text(self.session.program(), input, value);
        let (seen, next) = (self.session.seen(number), self.session.value(input));
        let arrow = if self.options.glyphs == Glyphs::Ascii { ">" } else { "→" };
        if seen == next { text(next) } else { format!("{}{arrow}{}", text(seen), text(next)) }
    }

    fn footer(&self, screen: &mut Buffer, area: Rect) {
        if let Mode::Asked(prompt) = &self.mode {
            return self.prompt(screen, area, prompt);
        }
        match &self.message {
            Some(message) => put(screen, area, &format!(" {message}"), self.look(Look::Decides)),
            None => put(screen, area, &format!(" {KEYS}"), Style::new()),
        };
    }

    fn prompt(&self, screen: &mut Buffer, area: Rect, prompt: &Prompt) {
        let question = question(&self.session, prompt.question);
        let rest = put(screen, area, &format!(" {question}: "), Style::new());
        let rest = put(screen, rest, &prompt.text, Style::new().add_modifier(Modifier::BOLD));
        let rest = put(screen, rest, "_", Style::new().add_modifier(Modifier::SLOW_BLINK));
        let hint = prompt.problem.as_deref().unwrap_or("enter takes it, esc leaves it");
        put(screen, rest, &format!("  {hint}"), self.look(Look::Decides));
    }

    fn help(&self, screen: &mut Buffer, within: Rect) {
        let has_room = HELP.len() < within.height.into();
        let lines = HELP.iter().filter(|(keys, _)| has_room || !keys.is_empty());
        let plain = Style::reset();
        for y in within.y..within.bottom() {
            let blank = " ".repeat(within.width.into());
            put(screen, Rect { y, height: 1, ..within }, &blank, plain);
        }
        let title = Style::new().add_modifier(Modifier::BOLD | Modifier::UNDERLINED);
        put(screen, within, " keys; any key leads back", title);
        for ((keys, does), y) in lines.zip(within.y + 1..within.bottom()) {
            let row = Rect { y, height: 1, ..within };
            let keys = put(screen, row, &format!("  {keys:<11}"), self.on());
            put(screen, keys, does, Style::new());
        }
    }
}

fn question(session: &Session<'_>, question: Question) -> String {
    match question {
        Question::Value(input) => {
            let variable = &session.program().variables[input];
            format!("{} : {} :=", harmless(&variable.name), variable.ty)
        }
        Question::Rung => "go to rung".to_owned(),
    }
}

fn too_small(screen: &mut Buffer) {
    let text = format!("{LEAST_COLUMNS} columns and {LEAST_ROWS} rows are needed; q leaves");
    put(screen, screen.area, &text, Style::new());
}

/// Writes as much of a text as fits into the first row of an area; returns what is left of it.
fn put(screen: &mut Buffer, area: Rect, text: &str, style: Style) -> Rect {
    if area.is_empty() {
        return area;
    }
    let (x, _) = screen.set_stringn(area.x, area.y, text, area.width.into(), style);
    Rect { x, width: area.right() - x, ..area }
}
