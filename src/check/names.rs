//! The one scope of a program: every name is declared once, also when case is ignored.

use std::collections::HashMap;
use std::collections::hash_map::Entry;

use crate::diagnostic::{Diagnostic, code, shortened, similar_name};
use crate::model::{ArrayId, InstanceId, VariableId};
use crate::source::Span;
use crate::syntax::ast::Name;
use crate::syntax::written_name;
use crate::types::Type;

/// Characters of the longest name.
const LONGEST: usize = 128;
/// For so many unknown names a similar one is looked for, which takes a look at every name.
const MOST_SUGGESTIONS: usize = 20;

/// What a name stands for.
#[derive(Clone, Copy, Debug)]
pub(super) enum Entity {
    Variable(VariableId),
    Array(ArrayId),
    Constant(Constant),
    Instance(InstanceId),
    /// Declared, but wrongly: uses are not reported again.
    Broken,
}

/// A named constant.
#[derive(Clone, Copy, Debug)]
pub(super) struct Constant {
    /// Left out, it is a name for a number that takes the type it needs.
    pub ty: Option<Type>,
    pub value: i64,
    /// Its declaration says the type. Else it is worked out exactly with others, a `TIME` too.
    pub is_typed: bool,
    /// Its number among the constants of the program.
    pub index: usize,
}

pub(super) struct Names<'s> {
    exact: HashMap<&'s str, (Entity, Span)>,
    /// By name in lower case, because VHDL does not see the difference.
    folded: HashMap<String, Span>,
    /// Number of unknown names so far.
    unknown: usize,
    /// Variables and constants whose declarations are still to come, while there are such.
    coming: HashMap<&'s str, Coming>,
}

/// A declaration that is still to come.
#[derive(Clone, Copy, Debug)]
pub(super) struct Coming {
    pub span: Span,
    pub is_constant: bool,
}

impl<'s> Names<'s> {
    /// Room for about so many names.
    pub fn with_capacity(names: usize) -> Self {
        Names {
            exact: HashMap::with_capacity(names),
            folded: HashMap::with_capacity(names),
            coming: HashMap::new(),
            unknown: 0,
        }
    }

    /// Notes that a name will be declared, for what is said about a use before.
    pub fn announce(&mut self, name: Name<'s>, is_constant: bool) {
        self.coming.entry(name.text).or_insert(Coming { span: name.span, is_constant });
    }

    /// Declares a name.
    pub fn declare(&mut self, name: Name<'s>, entity: Entity) -> Result<(), Box<Diagnostic>> {
        if name.text.chars().count() > LONGEST {
            self.exact.entry(name.text).or_insert((Entity::Broken, name.span));
            let message = format!("a name may have {LONGEST} characters at most");
            let diagnostic = Diagnostic::new(code::NAME_TOO_LONG, name.span, message)
                .label("longer than that")
                .help("shorten it");
            return Err(diagnostic.into());
        }
        let before = match self.folded.entry(name.text.to_lowercase()) {
            Entry::Occupied(before) => *before.get(),
            Entry::Vacant(free) => {
                free.insert(name.span);
                self.exact.insert(name.text, (entity, name.span));
                return Ok(());
            }
        };
        let exact = self.exact.contains_key(name.text);
        let message = if exact {
            format!("`{}` is declared twice", name.text)
        } else {
            format!("`{}` differs from another name only in case", name.text)
        };
        let help = if exact {
            "give one of them another name"
        } else {
            "give one of them another name: VHDL cannot tell them apart"
        };
        // Which of the two a use means is not known, so uses are not judged.
        self.exact.insert(name.text, (Entity::Broken, before));
        let diagnostic = Diagnostic::new(code::DUPLICATE_NAME, name.span, message)
            .label("declared again")
            .also(before, "declared here first")
            .help(help);
        Err(diagnostic.into())
    }

    /// Where a name is declared.
    pub fn place(&self, name: &str) -> Option<Span> {
        self.exact.get(name).map(|&(_, span)| span)
    }

    /// What a name stands for, if it is declared.
    pub fn get(&self, name: &str) -> Option<Entity> {
        self.exact.get(name).map(|&(entity, _)| entity)
    }

    /// What a name stands for. An unknown name is an error where it is used first.
    pub fn find(&mut self, name: Name<'s>) -> Result<Entity, Box<Diagnostic>> {
        if let Some(entity) = self.get(name.text) {
            return Ok(entity);
        }
        if let Some(coming) = self.coming.get(name.text) {
            return Err(used_too_early(name, *coming).into());
        }
        let help = self.help(name, "");
        Err(self.unknown(name, help).into())
    }

    /// How to mend the use of an unknown name, which may be an array's.
    pub fn help(&mut self, name: Name<'s>, length: &str) -> String {
        match (self.similar(name.text), name.text) {
            (Some(similar), _) => format!("is `{similar}` meant?"),
            (None, "rise" | "fall") => format!(
                "an edge contact has brackets: {0}(x); a variable of this name is declared in \
                 back-ticks: var `{0}`",
                name.text
            ),
            (None, text) if text.eq_ignore_ascii_case("and") || text.eq_ignore_ascii_case("or") => {
                "contacts in series are written `a b`, in parallel `[ a | b ]`".to_owned()
            }
            (None, text) => {
                format!("declare it, for instance: var {}{length}", shortened(&written_name(text)))
            }
        }
    }

    /// Says that nothing has this name, and is silent about it from now on.
    pub fn unknown(&mut self, name: Name<'s>, help: String) -> Diagnostic {
        self.exact.insert(name.text, (Entity::Broken, name.span));
        let message = format!("nothing is named `{}`", shortened(name.text));
        Diagnostic::new(code::UNKNOWN_NAME, name.span, message).label("not declared").help(help)
    }

    /// The declared name that is most like an unknown one.
    fn similar(&mut self, name: &str) -> Option<&'s str> {
        self.unknown += 1;
        if self.unknown > MOST_SUGGESTIONS {
            return None;
        }
        let known = self.exact.iter().filter(|(_, (entity, _))| !matches!(entity, Entity::Broken));
        similar_name(name, known.map(|(&known, _)| known))
    }
}

/// Only constant values are looked up before all names are declared.
fn used_too_early(name: Name<'_>, Coming { span, is_constant }: Coming) -> Diagnostic {
    if is_constant {
        let message = format!("`{}` is declared further down", shortened(name.text));
        return Diagnostic::new(code::UNKNOWN_NAME, name.span, message)
            .label("not known yet")
            .also(span, "declared here")
            .help("move the constant's declaration above its use");
    }
    not_a_constant(name.span)
}

/// What stands where a constant has to stand changes while the program runs.
pub(super) fn not_a_constant(span: Span) -> Diagnostic {
    Diagnostic::new(code::NOT_A_CONSTANT, span, "a constant is needed here")
        .label("known only while the program runs")
        .help("use a literal or a name declared with `const`")
}
