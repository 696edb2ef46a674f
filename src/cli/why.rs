//! `hotrail why`

use std::fmt::Write;
use std::path::PathBuf;

use anyhow::bail;
use clap::ValueEnum;
use serde_json::{Value, json};

use hotrail::backend::hdl::Harmless;
use hotrail::draw::{self, Drawing, Glyphs};
use hotrail::eval::{Cause, Flow, Place, Power, Reason, Subject, Why};
use hotrail::lint;
use hotrail::model::Names;
use hotrail::quantity;
use hotrail::types::Type;

use super::Verdict;
use super::pictures;
use super::report::Report;
use super::sim::{read_stimulus, variable};

/// Tell why a variable is on or off in a scan
#[derive(clap::Args)]
#[command(after_help = EXAMPLES, override_usage = "hotrail why [OPTIONS] <FILE> <STIMULUS> <NAME>
       hotrail why [OPTIONS] <FILE> --test <TITLE> <NAME>")]
pub struct Options {
    /// Ladder file
    file: PathBuf,
    /// Values for the inputs, one row a scan, as for `hotrail sim`; - is standard input. Not there
    /// with --test
    #[arg(value_name = "STIMULUS")]
    first: String,
    /// The variable, or the member of a block
    #[arg(value_name = "NAME", required_unless_present = "test", conflicts_with = "test")]
    second: Option<String>,
    /// Run this test in place of a stimulus: its title, or a part that no other one has
    #[arg(long, value_name = "TITLE")]
    test: Option<String>,
    /// The scan, from 0; the last one if it is not said. Of a test scans count from its last reset
    #[arg(long, value_name = "SCAN")]
    at: Option<usize>,
    /// How many steps back to go
    #[arg(long, value_name = "STEPS", default_value_t = 12,
          value_parser = clap::value_parser!(u16).range(1..=256))]
    depth: u16,
    /// How the answer is printed
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

const EXAMPLES: &str = "\
The answer names the contacts that let the power pass or stop it, and goes back through coils,
blocks and scans to the inputs that decided.

Examples:
  hotrail why conveyor.ladder stimulus.csv motor
  hotrail why conveyor.ladder --test 'the belt stops' motor
  hotrail why conveyor.ladder stimulus.csv motor --at 120 --format json
  hotrail why conveyor.ladder stimulus.csv motor --format svg > why.svg";

#[derive(ValueEnum, Clone, Copy, PartialEq, Eq)]
enum Format {
    /// Lines, indented
    Text,
    /// One JSON object
    Json,
    /// The rungs that decided, drawn with characters
    Drawing,
    /// The rungs that decided, as an SVG picture
    Svg,
}

pub fn run(options: &Options, report: &mut Report) -> anyhow::Result<Verdict> {
    let lints = lint::Options { off: true, ..lint::Options::default() };
    // With a test there is no stimulus in front of the name.
    let (stimulus, name) = match &options.second {
        Some(name) => (Some(PathBuf::from(&options.first)), name),
        None => (None, &options.first),
    };
    if stimulus.as_ref() == Some(&options.file) && options.file.as_os_str() == "-" {
        bail!("standard input cannot be both the program and its stimulus");
    }
    let Some((source, program)) = report.analyze(&options.file, &lints) else {
        return Ok(Verdict::Bad);
    };
    let stimulus = match &options.test {
        Some(title) => Some(pictures::test_stimulus(&program, title)?),
        None => read_stimulus(&program, stimulus.as_ref(), report)?,
    };
    let Some(stimulus) = stimulus else { return Ok(Verdict::Bad) };
    let variable = variable(&program, &Names::of(&program), name)?;
    let Some(scan) = options.at.or(stimulus.len().checked_sub(1)) else {
        bail!("nothing is run, so there is no scan; --at SCAN holds all inputs at 0");
    };
    // Behind the last row its values are held, as by `sim --scans`.
    let rows = (0..=scan).map(|scan| stimulus.row(scan));
    let why = Why::new(&program, &source, rows);
    let cause = why.explain(variable, scan, options.depth.into());
    let printer = Printer { tick_ns: program.tick_ns };
    let mut text = String::new();
    let drawing = || {
        let flow = Flow::at_reset(&program);
        let drawing = Drawing::with_flow(&source, &draw::Options::default(), &flow);
        let mut drawing = drawing.of_explanation(&why.shown(&cause));
        drawing.say(&format!("why {}{}", printer.statement(&cause), printer.reason(&cause)));
        drawing
    };
    match options.format {
        Format::Drawing => {
            text = pictures::terminal_text(&drawing(), Glyphs::Unicode, report);
        }
        Format::Svg => text = drawing().svg(),
        Format::Text => printer.text(&cause, 0, &mut text),
        Format::Json => {
            text = serde_json::to_string_pretty(&printer.json(&cause))?;
            text.push('\n');
        }
    }
    report.result(&text);
    Ok(Verdict::Good)
}

struct Printer {
    tick_ns: u64,
}

impl Printer {
    /// A line for the cause, then its own causes, further in.
    fn text(&self, cause: &Cause, depth: usize, text: &mut String) {
        let indent = "  ".repeat(depth);
        let line = format!("{}{}", self.statement(cause), self.reason(cause));
        writeln!(text, "{indent}{}", Harmless::unicode(&line)).expect("memory can be written");
        cause.causes.iter().for_each(|cause| self.text(cause, depth + 1, text));
    }

    fn statement(&self, cause: &Cause) -> String {
        let Cause { subject, value, scan, since, .. } = cause;
        let holds = *value != 0;
        match subject {
            Subject::Condition(text) => {
                let verb = if holds { "conducts" } else { "does not conduct" };
                format!("{text} {verb} in scan {scan}")
            }
            Subject::IdleCoil(text) => format!("{text} has no power in scan {scan}"),
            Subject::Variable(name) => {
                let shown = self.value(cause.ty, *value);
                match since {
                    Some(since) if since == scan && cause.ty == Type::Bool => {
                        format!("{name} went {shown} in scan {scan}")
                    }
                    Some(since) if since == scan => format!("{name} became {shown} in scan {scan}"),
                    Some(since) => format!("{name} is {shown} in scan {scan}, since scan {since}"),
                    None => format!("{name} is {shown} in scan {scan}, since reset"),
                }
            }
        }
    }

    fn reason(&self, cause: &Cause) -> String {
        let is_variable = matches!(cause.subject, Subject::Variable(_));
        match &cause.reason {
            Reason::Input => ": an input".to_owned(),
            Reason::Reset | Reason::FirstScan => String::new(),
            Reason::Element(place) if is_variable => format!(": {}, {}", place.text, rung(place)),
            Reason::Element(place) => format!(": {}", rung(place)),
            Reason::Call(place, power) => {
                format!(": {} {}, {}", place.text, self.power(power), rung(place))
            }
            Reason::Kept => ": kept, nothing wrote it".to_owned(),
            Reason::Above => ": see above".to_owned(),
            Reason::Deeper => ": ...".to_owned(),
        }
    }

    fn power(&self, power: &Power) -> String {
        let word = if power.is_on { "has power" } else { "has no power" };
        let since = power.since.map_or("reset".to_owned(), |since| format!("scan {since}"));
        let members: String = power
            .members
            .iter()
            .map(|(name, ty, value)| format!(", {name} = {}", self.value(*ty, *value)))
            .collect();
        format!("{word} since {since}{members}")
    }

    fn value(&self, ty: Type, value: i64) -> String {
        match ty {
            Type::Bool => if value != 0 { "on" } else { "off" }.to_owned(),
            Type::Time if value >= 0 => quantity::ticks_text(value, self.tick_ns),
            Type::Time => format!("{value} ticks"),
            Type::Int | Type::Uint | Type::Dint | Type::Udint | Type::Word | Type::Dword => {
                value.to_string()
            }
        }
    }

    /// Times are in ticks, as everywhere in tables.
    fn json(&self, cause: &Cause) -> Value {
        let (kind, name) = match &cause.subject {
            Subject::Variable(name) => ("variable", name),
            Subject::Condition(text) => ("condition", text),
            Subject::IdleCoil(text) => ("idle_coil", text),
        };
        let place = |place: &Place| {
            json!({
                "rung": place.rung, "title": place.title, "line": place.line, "text": place.text,
            })
        };
        let (reason, at, power) = match &cause.reason {
            Reason::Input => ("input", Value::Null, None),
            Reason::Reset => ("reset", Value::Null, None),
            Reason::FirstScan => ("first_scan", Value::Null, None),
            Reason::Element(at) => ("element", place(at), None),
            Reason::Call(at, power) => ("call", place(at), Some(power)),
            Reason::Kept => ("kept", Value::Null, None),
            Reason::Above => ("above", Value::Null, None),
            Reason::Deeper => ("deeper", Value::Null, None),
        };
        let mut object = json!({
            "kind": kind,
            "name": name,
            "value": cause.value,
            "scan": cause.scan,
            "since": cause.since,
            "reason": reason,
            "at": at,
            "causes": cause.causes.iter().map(|cause| self.json(cause)).collect::<Vec<_>>(),
        });
        if let Some(Power { is_on, since, members }) = power {
            let members: serde_json::Map<String, Value> =
                members.iter().map(|(name, _, value)| (name.clone(), json!(value))).collect();
            object["power"] = json!({ "is_on": is_on, "since": since, "members": members });
        }
        object
    }
}

/// `rung 2 "lamp", line 9`
fn rung(Place { rung, title, line, .. }: &Place) -> String {
    let title = title.as_ref().map(|title| format!(" \"{title}\"")).unwrap_or_default();
    format!("rung {rung}{title}, line {line}")
}
