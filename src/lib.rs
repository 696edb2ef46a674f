//! The compiler that turns ladder logic into hardware.
//!
//! ```
//! use hotrail::source::Source;
//!
//! let source = Source::new(
//!     "start_stop.ladder",
//!     "ladder start_stop  input start, stop  output motor
//!      rung \"seal-in\"  [ start | motor ] !stop ( motor )",
//! );
//! let (program, diagnostics) = hotrail::analyze(&source);
//! assert!(diagnostics.is_empty());
//! let design = hotrail::compile(&program.unwrap(), &hotrail::expand::Options::default());
//! assert_eq!(&*design.top().outputs[0].name, "motor");
//! ```

pub mod backend;
pub mod blocks;
mod build_script;
pub mod check;
pub mod circuit;
pub mod diagnostic;
pub mod draw;
pub mod equations;
pub mod eval;
pub mod expand;
pub mod files;
mod index;
pub mod lint;
#[cfg(feature = "cli")]
pub mod live;
pub mod model;
pub mod quantity;
pub mod report;
pub mod source;
pub mod syntax;
pub mod types;

pub use backend::Emit;
pub use build_script::{Build, BuildError, Finding};
pub use expand::compile;

use std::collections::HashSet;

use diagnostic::{Diagnostic, code};
use model::Program;
use source::Source;

/// Parses and checks a source. The program is there if nothing but warnings and notes was found;
/// findings are sorted by place.
pub fn analyze(source: &Source) -> (Option<Program>, Vec<Diagnostic>) {
    analyze_with(source, &lint::Options::default())
}

/// Parses and checks a source and looks for the warnings and notes that are wanted. They are
/// looked for where there is no error; one that the options deny is an error.
pub fn analyze_with(
    source: &Source,
    options: &lint::Options,
) -> (Option<Program>, Vec<Diagnostic>) {
    let (file, mut diagnostics) = syntax::parse(source);
    let (program, mut found) = check::check(source, &file);
    if diagnostics.is_empty() {
        let Some(program) = program else { return (None, found) };
        found.extend(lint::check(source, &file, &program, options));
        let denied = found.iter().any(Diagnostic::is_error);
        return ((!denied).then_some(program), found);
    }
    let is_word = |c: char| c == '_' || c.is_alphanumeric();
    let texts = file.broken.iter().map(|&span| source.slice(span));
    let words: HashSet<&str> = texts.flat_map(|text| text.split(|c| !is_word(c))).collect();
    let beyond_ascii: Vec<&str> = words.iter().copied().filter(|word| !word.is_ascii()).collect();
    // What could not be parsed may have declared what seems unknown, or have been the header.
    let may_follow = |found: &Diagnostic| {
        let name = source.slice(found.primary.span).trim_matches('`');
        found.code == code::NO_LADDER
            || (found.code == code::UNKNOWN_NAME
                && (words.contains(name)
                    || name.contains(|c| !is_word(c))
                    || beyond_ascii.iter().any(|word| may_look_like(word, name))))
    };
    diagnostics.extend(found.into_iter().filter(|found| !may_follow(found)));
    diagnostics.sort_by_key(|diagnostic| diagnostic.primary.span);
    (None, diagnostics)
}

/// True if the two differ in letters beyond ASCII only, which may look like other letters.
fn may_look_like(word: &str, name: &str) -> bool {
    word.chars().count() == name.chars().count()
        && word.chars().zip(name.chars()).all(|(a, b)| a == b || !a.is_ascii())
}
