//! What depends on what: as text, and as a graph that Graphviz draws.

use std::fmt::{self, Write};

use super::Report;
use crate::equations::{Dependency, Kind, Resource};

impl Report<'_> {
    /// The rungs of each level: as soon as all that they depend on is done.
    pub(super) fn levels(&self) -> Vec<Vec<u32>> {
        let mut levels: Vec<Vec<u32>> = Vec::new();
        for (rung, &level) in self.graph.levels.iter().enumerate() {
            if levels.len() < level as usize {
                levels.resize(level as usize, Vec::new());
            }
            levels[level as usize - 1].push(rung as u32);
        }
        levels
    }

    /// The rungs in the order in which the FPGA paper excites them: first those that have to do
    /// with no other one, then those of each group in the order of its dependencies.
    pub(super) fn excite_order(&self) -> Vec<Vec<u32>> {
        let mut is_bound = vec![false; self.program.rungs.len()];
        for one in &self.graph.dependencies {
            is_bound[one.from as usize] = true;
            is_bound[one.to as usize] = true;
        }
        let mut orders = vec![Vec::new()];
        for (level, rungs) in self.levels().into_iter().enumerate() {
            let (bound, free): (Vec<u32>, Vec<u32>) =
                rungs.into_iter().partition(|&rung| is_bound[rung as usize]);
            if level == 0 {
                orders[0] = free;
            }
            orders.push(bound);
        }
        orders.retain(|rungs| !rungs.is_empty());
        orders
    }

    pub(super) fn through(&self, dependency: &Dependency) -> String {
        match dependency.through {
            Resource::Variable(variable) => self.names.variable(variable),
            Resource::Instance(instance) => self.names.instance(instance),
        }
    }

    pub(super) fn graph_text(&self, text: &mut String) -> fmt::Result {
        let written = self.written();
        let join = |rungs: &[u32]| {
            let names = |&rung: &u32| match written[rung as usize].as_slice() {
                [] => format!("{}", self.number(rung)),
                names => format!("{} ({})", self.number(rung), names.join(", ")),
            };
            rungs.iter().map(names).collect::<Vec<_>>().join(", ")
        };
        writeln!(text, "\ndependencies")?;
        if self.graph.dependencies.is_empty() {
            writeln!(text, "  none")?;
        }
        for one in &self.graph.dependencies {
            let (from, name) = (self.number(one.from), self.through(one));
            let why = match one.kind {
                Kind::ReadAfterWrite => format!("reads {name}, which rung {from} writes"),
                Kind::WriteAfterRead => format!("writes {name}, which rung {from} reads before"),
                Kind::WriteAfterWrite => format!("writes {name} after rung {from}"),
            };
            writeln!(text, "  rung {} {why}", self.number(one.to))?;
        }
        writeln!(text, "\nlevels: the rungs that can fire together")?;
        for (number, rungs) in self.levels().iter().enumerate() {
            writeln!(text, "  {:4}  {}", number + 1, join(rungs))?;
        }
        writeln!(text, "\nexcite order: the free rungs, then the others in their order")?;
        for (number, rungs) in self.excite_order().iter().enumerate() {
            writeln!(text, "  {:4}  {}", number + 1, join(rungs))?;
        }
        writeln!(
            text,
            "\nlongest chain in one clock: about {} gates, through {}",
            self.chain.gates,
            match self.chain.rungs.as_slice() {
                [] => "no rung".to_owned(),
                [only] => format!("rung {}", join(&[*only])),
                rungs => format!("rungs {}", join(rungs)),
            }
        )
    }

    /// The graph in the language of Graphviz.
    pub fn dot(&self) -> String {
        let mut text = String::new();
        self.write_dot(&mut text).expect("a text takes all");
        text
    }

    fn write_dot(&self, text: &mut String) -> fmt::Result {
        let written = self.written();
        writeln!(text, "digraph \"{}\" {{", self.program.name)?;
        writeln!(text, "  rankdir=LR;\n  node [shape=box];")?;
        for (number, rung) in self.program.rungs.iter().enumerate() {
            let mut label = format!("rung {}", rung.number);
            if let Some(title) = &rung.title {
                write!(label, "\n{title}")?;
            }
            write!(label, "\n{}", written[number].join(", "))?;
            writeln!(text, "  r{} [label=\"{}\"];", rung.number, escaped(&label))?;
        }
        for rungs in self.levels() {
            let rungs = rungs.iter().map(|&rung| format!("r{};", self.number(rung)));
            let rungs: Vec<String> = rungs.collect();
            writeln!(text, "  {{ rank=same; {} }}", rungs.join(" "))?;
        }
        for one in &self.graph.dependencies {
            let style = match one.kind {
                Kind::ReadAfterWrite => "solid",
                Kind::WriteAfterRead => "dashed",
                Kind::WriteAfterWrite => "dotted",
            };
            let label = escaped(&self.through(one));
            let (from, to) = (self.number(one.from), self.number(one.to));
            writeln!(text, "  r{from} -> r{to} [label=\"{label}\", style={style}];")?;
        }
        writeln!(text, "}}")
    }
}

/// A text inside double quotes.
fn escaped(text: &str) -> String {
    text.replace('\\', "\\\\").replace('"', "\\\"").replace('\n', "\\n")
}
