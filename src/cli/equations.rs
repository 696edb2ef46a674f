//! `hotrail equations`

use std::path::PathBuf;

use clap::ValueEnum;

use hotrail::lint;

use super::Verdict;
use super::order::Order;
use super::report::Report;

/// Show a ladder as Boolean equations, and which rung depends on which
#[derive(clap::Args)]
#[command(after_help = "Examples:
  hotrail equations conveyor.ladder
  hotrail equations conveyor.ladder --flat
  hotrail equations conveyor.ladder --order dataflow
  hotrail equations conveyor.ladder --format dot | dot -Tsvg > conveyor.svg")]
pub struct Options {
    /// A ladder file; - is standard input
    #[arg(value_name = "FILE")]
    file: PathBuf,
    /// Equations, dependencies, levels and excite order as text or JSON, or the graph for Graphviz
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    /// Show each value as a function of inputs, of what blocks show, and of what the last scan left
    #[arg(long)]
    flat: bool,
    /// In which order the rungs act
    #[arg(long, value_enum, default_value_t = Order::Text)]
    order: Order,
}

#[derive(ValueEnum, Clone, Copy, PartialEq, Eq)]
enum Format {
    /// For people
    Text,
    /// One object; docs/equations.md describes it
    Json,
    /// The graph of the rungs, for Graphviz
    Dot,
}

pub fn run(options: &Options, report: &mut Report) -> anyhow::Result<Verdict> {
    let lints = lint::Options { off: true, ..lint::Options::default() };
    let Some((_, mut program)) = report.analyze(&options.file, &lints) else {
        return Ok(Verdict::Bad);
    };
    let order = options.order.apply(&mut program);
    let mut equations = hotrail::report::Report::new(&program, options.flat);
    order.into_iter().for_each(|order| equations.set_order(order));
    report.result(&match options.format {
        Format::Text => equations.text(),
        Format::Json => equations.json(),
        Format::Dot => equations.dot(),
    });
    Ok(Verdict::Good)
}
