//! The table of codes: every kind of finding, with its level and title, in one place.

use std::fmt;

/// How grave a finding is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// Nothing is written.
    Error,
    /// Written all the same; `--deny warnings` makes it an error.
    Warning,
    /// Worth knowing, and often meant.
    Note,
}

impl fmt::Display for Severity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Severity::Error => "error",
            Severity::Warning => "warning",
            Severity::Note => "note",
        })
    }
}

/// A kind of finding. Two are equal if their ids are.
#[derive(Clone, Copy)]
pub struct Code {
    /// `E0001`, `W0001`: stable, never used again for something else.
    pub id: &'static str,
    /// Its level, unless the user asked for another one.
    pub severity: Severity,
    /// What all findings of this code have in common.
    pub title: &'static str,
    /// Apart, so that a finding and a code stay small.
    entry: &'static Entry,
}

/// What is looked up of a code now and then.
struct Entry {
    /// The page `docs/errors/ID.md`.
    page: &'static str,
    /// The name of the code's constant.
    constant: &'static str,
}

impl Code {
    /// `unknown-name`, `double-coil`: the code for people.
    pub fn name(&self) -> String {
        self.entry.constant.to_lowercase().replace('_', "-")
    }

    /// What it means, with examples: the page `docs/errors/ID.md`.
    pub fn page(&self) -> &'static str {
        self.entry.page
    }

    /// The first paragraph of the page, on one line.
    pub fn summary(&self) -> String {
        let paragraph = self.entry.page.split("\n\n").nth(1).unwrap_or(self.title);
        paragraph.trim().replace('\n', " ")
    }

    /// True for what can be allowed and denied.
    pub fn is_lint(&self) -> bool {
        self.id.starts_with('W')
    }
}

impl PartialEq for Code {
    fn eq(&self, other: &Code) -> bool {
        self.id == other.id
    }
}

impl Eq for Code {}

impl fmt::Debug for Code {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.id)
    }
}

/// The code of that id or name, in upper or lower case.
pub fn named(text: &str) -> Option<Code> {
    let is_named =
        |code: &Code| code.id.eq_ignore_ascii_case(text) || code.name().eq_ignore_ascii_case(text);
    ALL.iter().copied().find(is_named)
}

macro_rules! codes {
    ($($severity:ident $id:ident $name:ident $title:literal)*) => {
        $(
            #[doc = concat!("`", stringify!($id), "`: ", $title, ".")]
            pub const $name: Code = Code {
                id: stringify!($id),
                severity: Severity::$severity,
                title: $title,
                entry: &Entry {
                    page: include_str!(concat!("../../docs/errors/", stringify!($id), ".md")),
                    constant: stringify!($name),
                },
            };
        )*
        /// Every code, in the order of the table.
        pub const ALL: &[Code] = &[$($name),*];
    };
}

codes! {
    // Text
    Error E0001 SYNTAX "the text does not follow the grammar"
    Error E0002 UNCLOSED "a bracket, comment, string or quoted name is not closed"
    Error E0003 TOO_DEEP "lists, brackets or comments are nested too deeply"
    Error E0004 NO_LADDER "the file has no ladder header, or more than one"
    Error E0005 NOT_TEXT "the file cannot be read as UTF-8 text"
    Error E0006 NOT_YET "this part of the language is not supported yet"
    // Names
    Error E0101 UNKNOWN_NAME "a name is not declared"
    Error E0102 DUPLICATE_NAME "a name is declared twice"
    Error E0103 RESERVED_NAME "a reserved word or name cannot be declared"
    Error E0104 NO_MEMBER "a name has no such member or bit"
    Error E0105 BAD_PROGRAM_NAME "the program's name cannot be a file name"
    Error E0106 NAME_TOO_LONG "a name is too long"
    // Types and values
    Error E0201 TYPE_MISMATCH "types do not fit together"
    Error E0202 OUT_OF_RANGE "a value does not fit its type"
    Error E0203 NOT_A_CONSTANT "a constant is needed here"
    Error E0204 BAD_TIME "a time is no whole number of ticks"
    Error E0205 BAD_CLOCK "the clock or the tick cannot be used"
    Error E0206 BAD_ADDRESS "an image address is out of its region or taken"
    Error E0207 BAD_CALL "a function has too few or too many arguments"
    Error E0208 ARRAYS_TOO_LARGE "the arrays need too much hardware"
    // Rungs
    Error E0301 EMPTY_BRANCH "a branch or network is empty"
    Error E0302 NO_OUTPUT "a rung has no coil, assignment or block"
    Error E0303 NOT_WRITABLE "this cannot be written"
    Error E0304 MISPLACED "this element cannot stand here"
    Error E0305 BAD_NETWORK "the nodes of a network are connected wrongly"
    // Blocks
    Error E0401 UNKNOWN_BLOCK "there is no block of that kind"
    Error E0402 BAD_ARGUMENT "the arguments do not fit the block"
    Error E0403 CALLED_TWICE "a block instance is called twice"
    // Tests
    Error E0501 TEST_TOO_LONG "a test would run too many scans"
    Error E0502 EXPECTATION "an expectation of a test does not hold"
    // Files
    Error E0601 CANNOT_READ "a file cannot be read"
    Error E0602 CANNOT_WRITE "a file cannot be written"
    Error E0603 SAME_NAME "two programs would write the same file"
    // Stimuli
    Error E0701 BAD_STIMULUS "a stimulus is no table of inputs and scans"
    Error E0702 BAD_COLUMN "a column of a stimulus is no input"
    Error E0703 BAD_CELL "a value of a stimulus does not fit its input"
    // The ladder processor
    Error E0801 NOT_ON_PROCESSOR "the ladder processor cannot do this"
    Error E0802 PROCESSOR_FULL "the ladder processor has no room for this"
    Error E0803 BAD_IMAGE "a file is no image that the ladder processor can run"
    Error E0804 NOT_DRAWN "no ladder draws this image of the ladder processor"

    // Allowing
    Warning W0001 BAD_ALLOW "an allow names nothing that can be allowed"
    // Names
    Warning W0101 UNUSED "a name is declared and never used"
    Warning W0102 NEVER_READ "a variable is written and never read"
    Warning W0103 INPUT_NEVER_READ "an input is never read"
    Warning W0104 OUTPUT_NEVER_WRITTEN "an output is never written"
    Warning W0105 NEVER_WRITTEN "a variable is read and never written"
    // Types and values
    Warning W0201 DIVIDER "a division needs a divider of its own"
    Warning W0202 ZERO_DIVISOR "a divisor is the constant 0"
    // Rungs
    Warning W0301 DOUBLE_COIL "a variable has two coils"
    Warning W0302 COIL_AND_LATCH "a variable has a coil and a set or reset coil"
    Warning W0303 SET_WITHOUT_RESET "a variable is set and never reset"
    Warning W0304 RESET_WITHOUT_SET "a variable is reset and never set"
    Note W0305 READ_ABOVE "a variable is read above the rung with its coil"
    Note W0306 LONG_RUNG "a rung has very many elements"
    Note W0307 DEEP_RUNG "a rung has lists nested very deep"
    Warning W0308 NO_RUNGS "the program has no rungs"
    Warning W0309 DEAD_END "a part of a network never carries power to the right"
    Warning W0310 AT_RAIL "a `not` or a one-shot stands where the power is always on"
    Note W0311 LONG_CHAIN "the longest chain of one scan may be too slow for the clock"
    // Blocks
    Warning W0401 PRESET_ZERO "the preset of a timer or counter is 0"
    Warning W0402 NEVER_RESET "nothing resets a counter or retentive timer"
    Warning W0403 RUNNING_EQUALITY "a running time is compared for equality"
    // Tests
    Warning W0501 IDLE_STATEMENT "a statement of a test does nothing"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_are_unique_and_bear_their_level() {
        let mut ids: Vec<_> = ALL.iter().map(|code| code.id).collect();
        ids.sort_unstable();
        ids.dedup();
        assert_eq!(ids.len(), ALL.len());
        for code in ALL {
            assert_eq!(code.is_lint(), code.severity != Severity::Error, "{}", code.id);
            assert_eq!(named(&code.name()), Some(*code));
        }
    }
}
