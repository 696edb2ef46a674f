//! All findings of a run as one document in SARIF 2.1.0, as code scanning services take it.

use std::path::Path;

use serde::Serialize;

use super::{Code, Diagnostic, Label, Severity, code};
use crate::source::{Source, Span};

/// The findings of a run.
#[derive(Default)]
pub struct Sarif {
    found: Vec<(Code, Finding)>,
}

impl Sarif {
    /// Adds a finding.
    pub fn add(&mut self, diagnostic: &Diagnostic, source: &Source) {
        let related = diagnostic.related.iter().enumerate().map(|(number, label)| Location {
            id: Some(number + 1),
            message: Some(Text::new(&label.text)),
            ..Location::of(source, label)
        });
        self.found.push((
            diagnostic.code,
            Finding {
                message: Text { text: diagnostic.plain_text() },
                locations: vec![Location::of(source, &diagnostic.primary)],
                related_locations: related.collect(),
            },
        ));
    }

    /// Adds a finding about a file as a whole.
    pub fn add_file(&mut self, code: Code, file: &str, message: &str) {
        let finding = Finding {
            message: Text::new(message),
            locations: vec![Location::of_file(file)],
            related_locations: Vec::new(),
        };
        self.found.push((code, finding));
    }

    /// The document, ending in a line feed.
    pub fn render(self) -> String {
        let used = |code: &&Code| self.found.iter().any(|(found, _)| found == *code);
        let rules: Vec<&Code> = code::ALL.iter().filter(used).collect();
        let index = |code: &Code| rules.iter().position(|rule| *rule == code);
        let results = self.found.into_iter().map(|(code, finding)| Outcome {
            rule_id: code.id,
            rule_index: index(&code),
            level: level(code.severity),
            finding,
        });
        let log = Log {
            schema: "https://json.schemastore.org/sarif-2.1.0.json",
            version: "2.1.0",
            runs: [Run {
                results: results.collect(),
                column_kind: "unicodeCodePoints",
                tool: Tool {
                    driver: Driver {
                        name: "hotrail",
                        version: env!("CARGO_PKG_VERSION"),
                        rules: rules.into_iter().map(Rule::new).collect(),
                    },
                },
            }],
        };
        let text = serde_json::to_string_pretty(&log);
        text.expect("strings and numbers can be written as JSON") + "\n"
    }
}

fn level(severity: Severity) -> &'static str {
    match severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
        Severity::Note => "note",
    }
}

#[derive(Serialize)]
struct Log {
    #[serde(rename = "$schema")]
    schema: &'static str,
    version: &'static str,
    runs: [Run; 1],
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Run {
    tool: Tool,
    column_kind: &'static str,
    results: Vec<Outcome>,
}

#[derive(Serialize)]
struct Tool {
    driver: Driver,
}

#[derive(Serialize)]
struct Driver {
    name: &'static str,
    version: &'static str,
    rules: Vec<Rule>,
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Rule {
    id: &'static str,
    name: String,
    short_description: Text,
    full_description: Text,
    help: Help,
    default_configuration: Configuration,
}

impl Rule {
    fn new(code: &Code) -> Rule {
        Rule {
            id: code.id,
            name: code.name(),
            short_description: Text::new(code.title),
            full_description: Text { text: code.summary() },
            help: Help { text: code.page(), markdown: code.page() },
            default_configuration: Configuration { level: level(code.severity) },
        }
    }
}

#[derive(Serialize)]
struct Help {
    text: &'static str,
    markdown: &'static str,
}

#[derive(Serialize)]
struct Configuration {
    level: &'static str,
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Outcome {
    rule_id: &'static str,
    rule_index: Option<usize>,
    level: &'static str,
    #[serde(flatten)]
    finding: Finding,
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Finding {
    message: Text,
    locations: Vec<Location>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    related_locations: Vec<Location>,
}

#[derive(Serialize)]
struct Text {
    text: String,
}

impl Text {
    fn new(text: &str) -> Text {
        Text { text: text.to_owned() }
    }
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Location {
    #[serde(skip_serializing_if = "Option::is_none")]
    id: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    message: Option<Text>,
    physical_location: Place,
}

impl Location {
    fn of(source: &Source, label: &Label) -> Location {
        let mut location = Location::of_file(source.name());
        location.physical_location.region = Some(Region::new(source, label.span));
        location
    }

    fn of_file(name: &str) -> Location {
        let artifact_location = File { uri: uri(name) };
        let physical_location = Place { artifact_location, region: None };
        Location { id: None, message: None, physical_location }
    }
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Place {
    artifact_location: File,
    #[serde(skip_serializing_if = "Option::is_none")]
    region: Option<Region>,
}

#[derive(Serialize)]
struct File {
    uri: String,
}

/// Lines and columns count from 1; the end is exclusive.
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Region {
    start_line: u32,
    start_column: u32,
    end_line: u32,
    end_column: u32,
}

impl Region {
    fn new(source: &Source, span: Span) -> Region {
        let (start, end) = (source.position(span.start), source.position(span.end));
        Region {
            start_line: start.line,
            start_column: start.column,
            end_line: end.line,
            end_column: end.column,
        }
    }
}

/// A path as a URI, relative to the folder of the run where the path is relative.
fn uri(path: &str) -> String {
    let slashes = path.replace('\\', "/");
    let root = match (slashes.starts_with('/'), Path::new(path).is_absolute()) {
        (true, _) => "file://",
        (false, true) => "file:///",
        (false, false) => "",
    };
    let mut uri = root.to_owned();
    for byte in slashes.strip_prefix("./").unwrap_or(&slashes).bytes() {
        match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'-' | b'.' | b'_' | b'~' | b'/' => {
                uri.push(char::from(byte));
            }
            // The colon of a Windows drive stands as it is.
            b':' if !root.is_empty() => uri.push(':'),
            _ => uri += &format!("%{byte:02X}"),
        }
    }
    uri
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_becomes_a_uri() {
        assert_eq!(uri("./folder\\a b%.ladder"), "folder/a%20b%25.ladder");
        assert_eq!(uri("/srv/é.ladder"), "file:///srv/%C3%A9.ladder");
        assert_eq!(uri("<stdin>"), "%3Cstdin%3E");
    }

    #[test]
    fn one_rule_serves_all_its_findings() {
        let source = Source::new("a.ladder", "rung é (y)");
        let mut sarif = Sarif::default();
        let message = "nothing is named `y`";
        for _ in 0..2 {
            let finding = Diagnostic::new(code::UNKNOWN_NAME, Span::new(9, 10), message);
            sarif.add(&finding.also(Span::new(0, 4), "in this rung").help("declare it"), &source);
        }
        sarif.add_file(code::CANNOT_READ, "b.ladder", "no such file");
        let log: serde_json::Value = serde_json::from_str(&sarif.render()).unwrap();
        let run = &log["runs"][0];
        let rules = run["tool"]["driver"]["rules"].as_array().unwrap();
        let ids: Vec<_> = rules.iter().map(|rule| rule["id"].as_str().unwrap()).collect();
        assert_eq!(ids, ["E0101", "E0601"]);
        let result = &run["results"][1];
        assert_eq!(result["ruleIndex"], 0);
        assert_eq!(result["message"]["text"], "nothing is named `y`\nhelp: declare it");
        let region = &result["locations"][0]["physicalLocation"]["region"];
        assert_eq!((&region["startColumn"], &region["endColumn"]), (&9.into(), &10.into()));
        assert_eq!(result["relatedLocations"][0]["message"]["text"], "in this rung");
        let file = &run["results"][2]["locations"][0]["physicalLocation"];
        assert_eq!(file["artifactLocation"]["uri"], "b.ladder");
        assert!(file.get("region").is_none());
    }
}
