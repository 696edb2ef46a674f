//! What another order of the rungs changes.

use std::fmt::{self, Write};

use serde::Serialize;

use super::names::{instance_name, variable_name};
use crate::equations::{Change, Order, Resource};
use crate::model::{Program, Role};

/// What an order changes, as a part of the JSON document.
#[derive(Serialize)]
pub(super) struct OrderItem {
    rungs: Vec<u32>,
    changes: Vec<ChangeItem>,
    feedback: Vec<ChangeItem>,
    may_differ: Vec<String>,
}

#[derive(Serialize)]
struct ChangeItem {
    rung: u32,
    through: String,
    before: Option<u32>,
    after: Option<u32>,
}

/// An order of the rungs of a program.
pub(super) struct Names<'a> {
    pub program: &'a Program,
    pub order: &'a Order,
}

/// One line on what an order changes in a program.
pub fn order_summary(program: &Program, order: &Order) -> String {
    let names = Names { program, order };
    let reads = match order.changes.len() {
        0 => return "the order of the rungs changes nothing".to_owned(),
        1 => "1 rung reads another value".to_owned(),
        count => format!("{count} times a rung reads another value"),
    };
    format!(
        "in the order of what flows between the rungs, {reads} than in the order of the text; {} may \
         differ",
        names.may_differ().join(", ")
    )
}

impl Names<'_> {
    fn resource(&self, resource: Resource) -> String {
        match resource {
            Resource::Variable(variable) => variable_name(self.program, variable),
            Resource::Instance(instance) => instance_name(self.program, instance),
        }
    }

    /// Outputs first: they are what is seen.
    fn may_differ(&self) -> Vec<String> {
        let is_output = |&&one: &&Resource| match one {
            Resource::Variable(variable) => self.program.variables[variable].role == Role::Output,
            Resource::Instance(_) => false,
        };
        let all = &self.order.may_differ;
        let (seen, inner): (Vec<_>, Vec<_>) = all.iter().partition(is_output);
        seen.into_iter().chain(inner).map(|&one| self.resource(one)).collect()
    }

    pub fn item(&self) -> OrderItem {
        let item = |change: &Change| ChangeItem {
            rung: change.rung + 1,
            through: self.resource(change.through),
            before: change.before.map(|rung| rung + 1),
            after: change.after.map(|rung| rung + 1),
        };
        OrderItem {
            rungs: self.order.rungs.iter().map(|rung| rung + 1).collect(),
            changes: self.order.changes.iter().map(item).collect(),
            feedback: self.order.feedback.iter().map(item).collect(),
            may_differ: self.may_differ(),
        }
    }

    pub fn text(&self, text: &mut String) -> fmt::Result {
        let OrderItem { rungs, changes, feedback, may_differ } = self.item();
        let numbers: Vec<String> = rungs.iter().map(u32::to_string).collect();
        writeln!(text, "order: the rungs as values flow between them")?;
        writeln!(text, "  {}", numbers.join(", "))?;
        let from = |writer: Option<u32>| match writer {
            Some(rung) => format!("as rung {rung} leaves it"),
            None => "as the last scan left it".to_owned(),
        };
        for ChangeItem { rung, through, before, after } in &changes {
            let (before, after) = (from(*before), from(*after));
            writeln!(
                text,
                "  rung {rung} reads {through} {after}; in the order of the text, {before}"
            )?;
        }
        for ChangeItem { rung, through, after, .. } in &feedback {
            let after = from(*after);
            writeln!(
                text,
                "  rung {rung} reads {through} {after}: it is in a loop with what writes {through}"
            )?;
        }
        match may_differ.as_slice() {
            [] => writeln!(text, "  nothing differs from the order of the text")?,
            names => {
                writeln!(text, "  may differ from the order of the text: {}", names.join(", "))?
            }
        }
        writeln!(text)
    }
}
