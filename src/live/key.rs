//! What a person can press.

/// A key, as far as the program cares for it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Key {
    /// A character.
    Char(char),
    /// Return.
    Enter,
    /// Escape.
    Escape,
    /// Backspace.
    Backspace,
    /// To the next list.
    Tab,
    /// Arrow up.
    Up,
    /// Arrow down.
    Down,
    /// A page up.
    PageUp,
    /// A page down.
    PageDown,
    /// The first rung.
    Home,
    /// The last rung.
    End,
    /// Control and C: leave at once.
    Interrupt,
}

/// Each key of the ladder with what it does: the help, and the footer where a short word is there.
pub(super) const HELP: &[(&str, &str)] = &[
    ("space", "run in real time, or pause"),
    ("s", "one scan, with the tick"),
    ("S", "one scan without the tick: no time goes by"),
    ("b", "back by one scan"),
    ("R", "reset: all inputs 0, the stimulus starts again"),
    ("< >", "slower, faster"),
    ("", ""),
    ("up down", "choose an input, or move in another list"),
    ("tab", "the next list: inputs, outputs, timers and variables"),
    ("enter", "change the input: switch a BOOL over, type a number or a time"),
    ("1 .. 9", "switch that input over, if it is a BOOL"),
    ("p", "pulse: on for the next scan alone"),
    ("+ -", "a number one up, one down"),
    ("", ""),
    ("pgup pgdn", "move over the ladder"),
    ("home end", "the first rung, the last rung"),
    ("g", "go to a rung: its number, or a part of its title"),
    ("f", "follow: always show a rung in which something changed"),
    ("q", "quit; with --record what you did is written down"),
];
