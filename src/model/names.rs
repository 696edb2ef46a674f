//! The variables of a program by what a user calls them.

use std::collections::HashMap;

use super::{Program, Role, VariableId};

/// Finds variables by name, however many there are.
#[derive(Clone, Debug)]
pub struct Names<'p> {
    declared: HashMap<&'p str, VariableId>,
    members: HashMap<&'p str, VariableId>,
}

impl<'p> Names<'p> {
    /// The names of a program.
    pub fn of(program: &'p Program) -> Self {
        let mut names = Names { declared: HashMap::new(), members: HashMap::new() };
        for (id, variable) in program.named_variables() {
            let kind = match variable.role {
                Role::Member(..) => &mut names.members,
                _ => &mut names.declared,
            };
            kind.entry(&*variable.name).or_insert(id);
        }
        names
    }

    /// The variable that a user names so: a declared name, in back-ticks or not, or
    /// `instance.MEMBER`.
    pub fn variable(&self, name: &str) -> Option<VariableId> {
        let plain = name.replace('`', "");
        // A dot between names tells a member from a name that has a dot in it.
        let is_member = name.ends_with(|c: char| c != '`') && name.contains('.');
        let member = self.members.get(&*plain).filter(|_| is_member);
        member.or_else(|| self.declared.get(&*plain)).copied()
    }
}
