//! The scans of a run as a table.

use std::fmt::Write;

use hotrail::model::{Program, VariableId};

use super::sim::Format;

/// The columns in front of the variables.
const OWN: [&str; 2] = ["scan", "tick"];

/// Rows of values, in decimal.
pub struct Table {
    /// The rows that have not been taken yet.
    pub text: String,
    variables: Vec<VariableId>,
    format: Format,
    /// What stands before each value of a row.
    before: Vec<String>,
    scan: u64,
}

impl Table {
    /// A table of these variables; its header is made.
    pub fn new(program: &Program, variables: Vec<VariableId>, format: Format) -> Table {
        let own = OWN.iter().map(|&name| name.to_owned());
        let names = own.chain(variables.iter().map(|&variable| {
            let name = &program.variables[variable].name;
            // A variable of that name is written in back-ticks in a ladder, and so is it here.
            if OWN.contains(&&**name) { format!("`{name}`") } else { name.to_string() }
        }));
        let names: Vec<String> = names.collect();
        let (text, before) = match format {
            Format::Csv => {
                let mut header = csv::Writer::from_writer(Vec::new());
                header.write_record(&names).expect("memory can be written");
                let header = header.into_inner().expect("memory can be written");
                let text = String::from_utf8(header).expect("names are text");
                let comma = |index| if index == 0 { "" } else { "," };
                (text, (0..names.len()).map(|index| comma(index).to_owned()).collect())
            }
            Format::Jsonl => {
                let key = |(index, name): (usize, &String)| {
                    let start = if index == 0 { "{" } else { "," };
                    format!("{start}{}:", serde_json::Value::from(name.as_str()))
                };
                (String::new(), names.iter().enumerate().map(key).collect())
            }
        };
        Table { text, variables, format, before, scan: 0 }
    }

    /// Adds the row of one more scan.
    pub fn row(&mut self, tick: bool, value: impl Fn(VariableId) -> i64) {
        let own = [self.scan as i64, tick.into()];
        let values = own.into_iter().chain(self.variables.iter().map(|&v| value(v)));
        for (before, value) in self.before.iter().zip(values) {
            write!(self.text, "{before}{value}").expect("memory can be written");
        }
        self.text.push_str(match self.format {
            Format::Csv => "\n",
            Format::Jsonl => "}\n",
        });
        self.scan += 1;
    }
}
