//! What analysis says about wrong programs: one file for each case in `tests/errors`, with the
//! text that a user reads beside it. A case is named after the one code that it shows; a case
//! whose name starts with `several` shows how findings stand together.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use hotrail::backend::processor;
use hotrail::diagnostic::{self, Diagnostic, code};
use hotrail::source::Source;

/// Codes that no text can have, because they are about files and runs of tests.
const COMMAND_LINE_ONLY: &[&str] =
    &["E0005", "E0502", "E0601", "E0602", "E0603", "E0701", "E0702", "E0703", "E0803"];

/// Longer than any of these texts takes, shorter than anything that grows without bound.
const PATIENCE: Duration = Duration::from_secs(20);

struct Case {
    name: String,
    source: Source,
    findings: Vec<Diagnostic>,
}

fn cases() -> Vec<Case> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/errors");
    let entries = fs::read_dir(&folder).expect("the folder of cases is there");
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    paths.retain(|path| path.extension().is_some_and(|ending| ending == "ladder"));
    paths.sort();
    let case = |path: PathBuf| {
        let name = path.file_stem().unwrap().to_str().unwrap().to_owned();
        let text = fs::read_to_string(&path).unwrap();
        let source = Source::new(format!("{name}.ladder"), text);
        let (program, mut findings) = hotrail::analyze(&source);
        let failed = findings.iter().any(Diagnostic::is_error);
        assert_eq!(program.is_none(), failed, "{name}: a program is there if and only if no error");
        // These are sound programs that one target cannot do.
        if name.starts_with("E08") {
            let program = program.expect("the program is sound");
            findings.extend(processor::compile(&program).err().into_iter().flatten());
        }
        Case { name, source, findings }
    };
    paths.into_iter().map(case).collect()
}

#[test]
fn findings_read_as_kept() {
    for Case { name, source, findings } in cases() {
        let texts: Vec<String> =
            findings.iter().map(|finding| diagnostic::render(finding, &source, false)).collect();
        insta::with_settings!({
            snapshot_path => "errors",
            prepend_module_to_snapshot => false,
            omit_expression => true,
        }, {
            insta::assert_snapshot!(name, texts.join("\n"));
        });
    }
}

#[test]
fn a_case_has_the_one_finding_of_its_name() {
    for Case { name, findings, .. } in cases() {
        let found: Vec<_> = findings.iter().map(|finding| finding.code.id).collect();
        if name.starts_with("several") {
            assert!(found.len() > 1, "{name}: {found:?}");
        } else {
            assert_eq!(found, [&name[..5]], "{name}");
        }
    }
}

#[test]
fn every_code_has_a_case() {
    let hit: BTreeSet<_> = cases()
        .iter()
        .flat_map(|case| case.findings.iter().map(|finding| finding.code.id))
        .collect();
    let all: BTreeSet<_> = code::ALL.iter().map(|code| code.id).collect();
    let outside: BTreeSet<_> = COMMAND_LINE_ONLY.iter().copied().collect();
    assert_eq!(all.difference(&hit).copied().collect::<BTreeSet<_>>(), outside);
}

#[test]
fn a_finding_says_what_stands_there_and_how_to_mend_it() {
    for Case { name, findings, .. } in cases() {
        for finding in findings {
            assert!(!finding.primary.text.is_empty(), "{name}: no label");
            assert!(!finding.help.is_empty(), "{name}: no help");
            assert!(!finding.message.ends_with('.'), "{name}: {}", finding.message);
        }
    }
}

#[test]
fn several_findings_are_in_the_order_of_the_text() {
    for Case { name, findings, .. } in cases() {
        let places: Vec<_> = findings.iter().map(|finding| finding.primary.span).collect();
        assert!(places.is_sorted(), "{name}: {places:?}");
    }
}

/// Analyses and renders a text in bounded time.
fn findings(text: String) -> Vec<&'static str> {
    let started = Instant::now();
    let source = Source::new("any.ladder", text);
    let (_, findings) = hotrail::analyze(&source);
    // Rendering has to bear every text too; the first findings will do.
    for finding in findings.iter().take(3) {
        diagnostic::render(finding, &source, false);
        diagnostic::render_json(finding, &source);
    }
    let took = started.elapsed();
    assert!(took < PATIENCE, "{took:?} for {:.60?}", source.text());
    // Warnings have been looked for in bounded time too; here they do not matter.
    let errors = findings.iter().filter(|finding| finding.is_error());
    errors.map(|finding| finding.code.id).collect()
}

const START: &str = "ladder demo input a output y var n : DINT ";

fn nested(depth: usize, open: &str, inside: &str, close: &str) -> String {
    format!("{}{inside}{}", open.repeat(depth), close.repeat(depth))
}

#[test]
fn deep_nesting_is_refused_and_nesting_within_the_limit_is_not() {
    let rung = |network: String| format!("{START} rung {network} (y)");
    for depth in [300, 100_000] {
        let lists = rung(nested(depth, "[", " a ", "]"));
        let groups = rung(format!("{{ {} = 1 }}", nested(depth, "(", "n", ")")));
        let comments = rung(format!("a {}", nested(depth, "/*", "", "*/")));
        let nots = rung(format!("{{ {} a }}", "NOT ".repeat(depth)));
        let sum = rung(format!("{{ n := {} n }}", "n - ".repeat(depth)));
        let repeats = format!(
            "{START} rung a (y) test \"deep\" {}",
            nested(depth, "repeat 1 {", "scan", "}")
        );
        for text in [lists, groups, comments, nots, sum, repeats] {
            assert_eq!(findings(text), ["E0003"], "depth {depth}");
        }
    }
    for text in [
        rung(nested(250, "[", " a ", "]")),
        rung(format!("{{ {} = 1 }}", nested(250, "(", "n", ")"))),
        rung(format!("a {}", nested(250, "/*", "", "*/"))),
        rung(format!("{{ {} a }}", "NOT ".repeat(250))),
        rung(format!("{{ n := {} n }}", "n - ".repeat(250))),
    ] {
        assert!(findings(text).is_empty());
    }
}

#[test]
fn chains_of_one_operator_have_any_length() {
    for (operator, start, end) in [
        ("a OR", "{", "a }"),
        ("NOT a AND", "{", "a }"),
        ("a XOR", "{", "a }"),
        ("n +", "{ n :=", "n }"),
    ] {
        for length in [300, 50_000] {
            let chain = format!("{operator} ").repeat(length);
            let text = format!("{START} rung {start} {chain} {end} (y)");
            assert_eq!(findings(text), [""; 0], "{length} {operator}");
        }
    }
}

#[test]
fn line_ends_of_cr_alone_are_one_mistake() {
    for text in [
        "ladder p // title\rinput a output y\rrung a (y)\r",
        "ladder p /* title\r*/ input a output y\nrung a (y)\n",
        "ladder p \"title\r\" input a output y\nrung a (y)\n",
        "ladder p input `a\r` output y\nrung `a\r` (y)\n",
        "ladder p\r\r\ninput a output y\r\nrung a (y)\r\n",
    ] {
        let found = findings(text.to_owned());
        assert!(found.contains(&"E0001"), "{text:?}: {found:?}");
    }
    let old = "ladder p // title\rinput a // one\routput y\rrung a (y)\r";
    assert_eq!(findings(old.to_owned()), ["E0001"]);
    assert_eq!(findings(old.replace('\r', "\r\n")), [""; 0]);
}

#[test]
fn messages_stay_short() {
    let (long, digits) = ("x".repeat(100_000), "1".repeat(100_000));
    for text in [
        format!("ladder p {long} {long}"),
        format!("ladder p \"t\" \"{long}\""),
        format!("ladder p `{long}` `{long}`"),
        format!("{START} rung a {{ n := {digits}x }}"),
        format!("{START} rung a {{ n := n {long} }}"),
        format!("{START} rung a {{ n := é{long} }}"),
        format!("{START} rung a t:{long}(PT := 1s) (y)"),
        format!("{START} rung a t:TON({long} := 1s) (y)"),
        format!("{START} rung a t:TON(PT := 1s) (y) rung t.{long} (y)"),
        format!("{START} var m : {long} rung a (y)"),
        format!("{START} test \"t\" wait {digits}"),
        format!("{START} var m : DINT := {digits} - {digits}"),
        format!("{START} var m : UINT := 1 - {}2", "0".repeat(100_000)),
        format!("{START} var m : DINT := {long} const {long} := 1 rung a (y)"),
    ] {
        let (_, findings) = hotrail::analyze(&Source::new("any.ladder", text));
        assert!(!findings.is_empty());
        for finding in findings {
            let longest = finding.help.iter().map(String::len).max().unwrap_or(0);
            let longest = longest.max(finding.message.len()).max(finding.primary.text.len());
            assert!(longest < 250, "{:.200}", finding.message);
        }
    }
}

#[test]
fn many_image_addresses_take_no_time() {
    let names: Vec<_> = (0..50_000).map(|number| format!("v{number}")).collect();
    let mut text = format!("{START} var {} var last at 600 ", names.join(", "));
    for number in 0..50_000 {
        text += &format!("var w{number} at 600 ");
    }
    assert_eq!(findings(text).len(), 50_000);
}

#[test]
fn the_smallest_time_is_one() {
    let with = |time: &str| findings(format!("{START} var t : TIME := {time} rung a (y)"));
    assert_eq!(with("-2147483648ms"), [""; 0]);
    assert_eq!(with("-2147483649ms"), ["E0202"]);
    assert_eq!(with("2147483647ms"), [""; 0]);
    assert_eq!(with("2147483648ms"), ["E0202"]);
}

#[test]
fn numbers_without_a_type_are_exact() {
    let found = |text: &str| findings(format!("{START} {text} rung a (y)"));
    for sound in [
        "const TOP := 4294967295  var u : UDINT := TOP",
        "const TOP := 2147483647 + 1  var u : UDINT := TOP",
        "const TOP := 2147483647 + 1  var u : DINT := TOP - 1",
        "const TOP := 5 - 6  var u : INT := TOP",
        "var u : UDINT := 4294967296 - 1",
        "const TOP := -2147483648  var u : DINT := TOP",
        "var u : UDINT rung { u = 4294967290 + 5 } (y)",
        "const TOP : UINT := 65535  var u : UINT := TOP + 1",
    ] {
        assert_eq!(found(sound), [""; 0], "{sound}");
    }
    for wrong in [
        "const TOP := 4294967295  var u : DINT := TOP",
        "const TOP := 2147483647 + 1  var u : DINT := TOP",
        "var v : UINT := 5 - 6",
        "const TOP := 5  var v : UINT := -TOP",
        "const TOP := 4294967296",
        "const TOP := 99999999999999999999 - 1",
        "rung a { n := 2147483647 + 1 }",
        "rung { 2147483647 + 1 = 0 } (y)",
    ] {
        assert_eq!(found(wrong), ["E0202"], "{wrong}");
    }
    for wrong in ["var b : BOOL := 1 + 0", "var w : WORD := 1 + 1", "var t : TIME := 1 + 1"] {
        assert_eq!(found(wrong), ["E0201"], "{wrong}");
    }
    assert_eq!(found("const TOP := 5 var t : TIME := TOP"), ["E0201"]);
}

#[test]
fn repeated_statements_count_even_if_they_run_no_scan() {
    let drives = "a := 1 ".repeat(1_000);
    let test = format!("{START} rung a (y) test \"t\" repeat 100000000 {{ {drives} }}");
    assert_eq!(findings(test), ["E0501"]);
}

#[test]
fn one_look_alike_letter_is_one_mistake() {
    for text in [
        "ladder p input \u{455}tart output y rung start (y)",
        "ladder p input \u{455}tart output y\nrung \u{455}tart (y)\nrung \u{455}tart (y)",
        "ladder p input start output y rung \u{455}tart (y)",
    ] {
        assert_eq!(findings(text.to_owned()), ["E0001"], "{text}");
    }
}

#[test]
fn brackets_that_are_never_closed_are_one_mistake() {
    for open in ["[", "(", "{", "/*", "`", "\"", "a:TON(R := [", "net {"] {
        let text = format!("{START} rung {} a (y)", open.repeat(100_000));
        assert_eq!(findings(text).len(), 1, "{open}");
    }
}

#[test]
fn very_long_names_are_refused() {
    let long = "x".repeat(1_000_000);
    assert_eq!(findings(format!("ladder {long} input a output y rung a (y)")), ["E0105"]);
    assert_eq!(findings(format!("ladder demo input {long} output y rung {long} (y)")), ["E0106"]);
    assert_eq!(findings(format!("ladder demo input a output y rung a {long} (y)")), ["E0101"]);
    assert_eq!(findings(format!("{START} rung a t:{long}(PT := 1s) (y)")), ["E0401"]);
    assert_eq!(findings(format!("{START} rung a t:TON({long} := 1s) (y)")), ["E0402"]);
    assert_eq!(
        findings(format!("{START} rung a t:TON(PT := 1s) (y) rung t.{long} (y)")),
        ["E0104"]
    );
    assert_eq!(findings(format!("{START} var m : {long} rung a (y)")), ["E0101"]);
    let digits = "1".repeat(1_000_000);
    assert_eq!(findings(format!("{START} rung a {{ n := {digits} }}")), ["E0202"]);
}

#[test]
fn no_text_makes_analysis_panic() {
    let words = [
        "ladder",
        "demo",
        "input",
        "output",
        "var",
        "const",
        "tick",
        "clock",
        "1ms",
        "a",
        "b",
        "y",
        "n",
        ": INT",
        ": TIME",
        ":= 5",
        ":= 1s",
        ":= a",
        "rung",
        "test",
        "\"t\"",
        "[",
        "]",
        "|",
        "(",
        ")",
        "(y)",
        "(S y)",
        "{",
        "}",
        "{ n := n + 1 }",
        "{ n > 3 }",
        "t:TON(PT := 1s)",
        "c:CTU(R := a, PV := 3)",
        "t.Q",
        "c.CV",
        "(R t)",
        "rise(a)",
        "rising",
        "not",
        "first_scan",
        "TRUE",
        "!",
        "/",
        "expect",
        "scan",
        "scan 3",
        "wait 1s",
        "pulse a",
        "repeat 2 {",
        "reset",
        "a := 1",
        "net",
        "->",
        "<->",
        ":",
        "\u{1}",
        "\u{2}",
        "é",
        "`",
        "``",
        "/*",
        "*/",
        "//",
        "\n",
        "-",
        "AND",
        "NOT",
        "=",
        "n.5",
        "n[1]",
        ",",
    ];
    let mut random = fastrand::Rng::with_seed(1);
    for _ in 0..3_000 {
        let mut text = if random.bool() { START.to_owned() } else { String::new() };
        for _ in 0..random.usize(..60) {
            text.push_str(words[random.usize(..words.len())]);
            text.push_str(if random.u8(..10) == 0 { "" } else { " " });
        }
        findings(text);
    }
    for _ in 0..3_000 {
        let bytes: Vec<u8> = (0..random.usize(..200)).map(|_| random.u8(..)).collect();
        findings(String::from_utf8_lossy(&bytes).into_owned());
    }
}

#[test]
fn a_damaged_program_does_not_make_analysis_panic() {
    let sound = include_str!("../examples/step_sequence/step_sequence.ladder");
    let mut random = fastrand::Rng::with_seed(2);
    for _ in 0..1_000 {
        let mut bytes = sound.as_bytes().to_vec();
        for _ in 0..1 + random.usize(..4) {
            let at = random.usize(..bytes.len());
            match random.u8(..3) {
                0 => bytes[at] = random.u8(..),
                1 => drop(bytes.remove(at)),
                _ => bytes.insert(at, bytes[random.usize(..bytes.len())]),
            }
        }
        findings(String::from_utf8_lossy(&bytes).into_owned());
    }
}
