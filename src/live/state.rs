//! What a person sees and how keys change it.

use super::clock::Clock;
use super::ladder::{Ladder, first_change};
use super::layout::{LISTS, Layout};
use super::prompt::{Prompt, Question, Typed};
use super::values::{self, Entry};
use super::{Key, Session};
use crate::draw::{Glyphs, NARROWEST};
use crate::eval::Stimulus;
use crate::model::VariableId;
use crate::source::Source;
use crate::types::Type;

/// The list of inputs.
pub(super) const INPUTS: usize = 0;

/// How it looks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Options {
    /// What the ladder is drawn with.
    pub glyphs: Glyphs,
    /// Show power in colour; it is bold in any case.
    pub has_color: bool,
}

/// What a key may be meant for.
pub(super) enum Mode {
    /// The ladder and its lists.
    Ladder,
    /// The list of keys.
    Help,
    /// A question.
    Asked(Prompt),
}

/// A program that runs while somebody watches.
pub struct Live<'p> {
    pub(super) session: Session<'p>,
    pub(super) options: Options,
    pub(super) clock: Clock,
    pub(super) ladder: Ladder,
    pub(super) layout: Option<Layout>,
    pub(super) lists: [Vec<Entry>; LISTS],
    /// In each list, the row that is chosen.
    pub(super) chosen: [usize; LISTS],
    /// The list that arrows move in.
    pub(super) focus: usize,
    /// The first line of the ladder that is seen.
    pub(super) top: usize,
    pub(super) follows: bool,
    pub(super) mode: Mode,
    /// What there is to say, until the next key.
    pub(super) message: Option<String>,
    source: &'p Source,
    columns: usize,
    is_over: bool,
}

impl<'p> Live<'p> {
    /// A session on a screen of so many columns and rows. `source` is the text of its program.
    pub fn new(
        session: Session<'p>,
        source: &'p Source,
        options: Options,
        size: (u16, u16),
    ) -> Self {
        let program = session.program();
        let mut live = Live {
            clock: Clock::new(program.tick_ns),
            ladder: Ladder::new(source, NARROWEST, options.glyphs, session.flow()),
            layout: None,
            lists: values::lists(program),
            chosen: [0; LISTS],
            focus: INPUTS,
            top: 0,
            follows: false,
            mode: Mode::Ladder,
            message: None,
            columns: NARROWEST,
            is_over: false,
            session,
            options,
            source,
        };
        live.resize(size);
        live
    }

    /// True once somebody wants to leave.
    pub fn is_over(&self) -> bool {
        self.is_over
    }

    /// True while scans become due as time goes by.
    pub fn is_running(&self) -> bool {
        self.clock.is_running()
    }

    /// The value of a variable after the last scan; of an input, that of the next scan.
    pub fn value(&self, variable: VariableId) -> i64 {
        self.session.value(variable)
    }

    /// What was done since reset.
    pub fn past(&self) -> &Stimulus {
        self.session.past()
    }

    /// The screen has so many columns and rows now.
    pub fn resize(&mut self, (columns, rows): (u16, u16)) {
        let lengths = [0, 1, 2].map(|list| self.lists[list].len());
        self.layout = Layout::of(columns, rows, lengths);
        let Some(layout) = &self.layout else { return };
        let columns = usize::from(layout.ladder.width);
        if columns != self.columns {
            let rung = self.ladder.rung_at(self.top);
            self.columns = columns;
            let (source, glyphs) = (self.source, self.options.glyphs);
            self.ladder = Ladder::new(source, columns, glyphs, self.session.flow());
            self.top = if self.top == 0 { 0 } else { self.ladder.place(rung).start };
        }
        self.scroll_to(self.top);
    }

    /// So much time goes by, in nanoseconds.
    pub fn elapse(&mut self, ns: u64) {
        self.clock.elapse(ns);
    }

    /// True if scans are due.
    pub fn is_due(&self) -> bool {
        self.clock.due() > 0
    }

    /// Runs the scans that are due, but no more than so many.
    pub fn run_due(&mut self, most: usize) {
        let scans = self.clock.take(most);
        if scans > 0 {
            self.scan(scans, true);
        }
    }

    /// A key was pressed.
    pub fn key(&mut self, key: Key) {
        self.message = None;
        if key == Key::Interrupt {
            self.is_over = true;
            return;
        }
        match &mut self.mode {
            Mode::Ladder => self.command(key),
            Mode::Help => self.mode = Mode::Ladder,
            Mode::Asked(prompt) => match prompt.key(key) {
                Typed::More => {}
                Typed::Never => self.mode = Mode::Ladder,
                Typed::Answer => self.answer(),
            },
        }
    }

    fn command(&mut self, key: Key) {
        match key {
            Key::Char(' ') => self.clock.run(!self.clock.is_running()),
            Key::Char('s') => self.step(true),
            Key::Char('S') => self.step(false),
            Key::Char('b') => self.go_back(),
            Key::Char('R') => self.reset(),
            Key::Char('<') => self.clock.slower(),
            Key::Char('>') => self.clock.faster(),
            Key::Up => self.choose(self.chosen[self.focus].saturating_sub(1)),
            Key::Down => self.choose(self.chosen[self.focus] + 1),
            Key::Tab => self.focus = (self.focus + 1) % LISTS,
            Key::Enter => self.change(),
            Key::Char(digit @ '1'..='9') => self.switch_number(digit as usize - '1' as usize),
            Key::Char('p') => self.pulse(),
            Key::Char('+') => self.add(1),
            Key::Char('-') => self.add(-1),
            Key::PageUp => self.scroll_to(self.top.saturating_sub(self.page())),
            Key::PageDown => self.scroll_to(self.top + self.page()),
            Key::Home => self.scroll_to(0),
            Key::End => self.scroll_to(usize::MAX),
            Key::Char('g') => self.mode = Mode::Asked(Prompt::new(Question::Rung)),
            Key::Char('f') => self.follows = !self.follows,
            Key::Char('?' | 'h') => self.mode = Mode::Help,
            Key::Char('q') => self.is_over = true,
            Key::Char(_) | Key::Escape | Key::Backspace | Key::Interrupt => {
                self.message = Some("? shows what each key does".to_owned());
            }
        }
    }

    /// A scan by hand.
    fn step(&mut self, tick: bool) {
        self.clock.run(false);
        self.scan(1, tick);
    }

    fn scan(&mut self, scans: usize, tick: bool) {
        let before = self.follows.then(|| self.session.flow().clone());
        self.session.scan(scans, tick);
        self.ladder.show(self.session.flow());
        if let Some(rung) = before.and_then(|flow| first_change(&flow, self.session.flow())) {
            self.show_rung(rung);
        }
    }

    fn go_back(&mut self) {
        self.clock.run(false);
        if self.session.scans() == 0 {
            self.message = Some("nothing has happened since reset".to_owned());
        }
        self.session.back();
        self.ladder.show(self.session.flow());
    }

    fn reset(&mut self) {
        self.clock.run(false);
        self.session.reset();
        self.ladder.show(self.session.flow());
    }

    fn choose(&mut self, row: usize) {
        self.chosen[self.focus] = row.min(self.lists[self.focus].len().saturating_sub(1));
    }

    /// The input that is chosen, whichever list the arrows move in.
    fn input(&mut self) -> Option<VariableId> {
        let input = self.session.inputs().get(self.chosen[INPUTS]).copied();
        if input.is_none() {
            self.message = Some("the program has no input".to_owned());
        }
        input
    }

    fn is_bool(&self, input: VariableId) -> bool {
        self.session.program().variables[input].ty == Type::Bool
    }

    fn change(&mut self) {
        let Some(input) = self.input() else { return };
        match self.is_bool(input) {
            true => self.session.drive(input, 1 - self.session.value(input)),
            false => self.mode = Mode::Asked(Prompt::new(Question::Value(input))),
        }
    }

    fn switch_number(&mut self, number: usize) {
        match self.session.inputs().get(number) {
            Some(&input) if self.is_bool(input) => {
                self.session.drive(input, 1 - self.session.value(input));
            }
            Some(_) => self.message = Some("that input is a number: choose it, enter".to_owned()),
            None => self.message = Some(format!("there is no input {}", number + 1)),
        }
    }

    fn pulse(&mut self) {
        let Some(input) = self.input() else { return };
        match self.is_bool(input) {
            true => self.session.pulse(input),
            false => self.message = Some("only a BOOL can be pulsed".to_owned()),
        }
    }

    fn add(&mut self, more: i64) {
        let Some(input) = self.input() else { return };
        let value = self.session.value(input) + more;
        match self.session.program().variables[input].ty.holds(value.into()) {
            true => self.session.drive(input, value),
            false => self.message = Some("it goes no further".to_owned()),
        }
    }

    fn answer(&mut self) {
        let Mode::Asked(prompt) = &mut self.mode else { return };
        let text = prompt.text.trim();
        let taken = match prompt.question {
            Question::Value(input) => Stimulus::value(self.session.program(), input, text)
                .map(|value| self.session.drive(input, value)),
            Question::Rung => match self.ladder.named(text) {
                Some(rung) => {
                    self.top = self.ladder.place(rung).start;
                    Ok(())
                }
                None => Err(format!(
                    "write a number, 1 to {}, or a part of a title",
                    self.ladder.rungs()
                )),
            },
        };
        match taken {
            Err(problem) => prompt.problem = Some(problem),
            Ok(()) => {
                self.mode = Mode::Ladder;
                self.scroll_to(self.top);
            }
        }
    }

    /// The rows of the ladder that are seen.
    fn rows(&self) -> usize {
        self.layout.as_ref().map_or(0, |layout| layout.ladder.height.into())
    }

    /// How far a page goes: some lines stay in sight.
    fn page(&self) -> usize {
        self.rows().saturating_sub(2).max(1)
    }

    fn scroll_to(&mut self, line: usize) {
        self.top = line.min(self.ladder.height().saturating_sub(self.rows()));
    }

    /// Scrolls no further than it takes to see a rung.
    fn show_rung(&mut self, rung: usize) {
        let place = self.ladder.place(rung);
        if place.start < self.top {
            self.scroll_to(place.start);
        } else if place.end > self.top + self.rows() {
            self.scroll_to(place.start.min(place.end - self.rows().min(place.len())));
        }
    }
}
