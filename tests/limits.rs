//! Limits of numbers, nesting and length, on both sides; texts that nobody means.

use hotrail::diagnostic;
use hotrail::eval::Stimulus;
use hotrail::source::Source;

/// The errors of a text. What grows with more than its length would keep the test from ending.
fn findings(text: String) -> Vec<&'static str> {
    let source = Source::new("any.ladder", text);
    let (_, findings) = hotrail::analyze(&source);
    // Rendering has to bear every text too; the first findings will do.
    for finding in findings.iter().take(3) {
        diagnostic::render(finding, &source, false);
        diagnostic::render_json(finding, &source);
    }
    // Warnings have been looked for too; here they do not matter.
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
fn an_image_address_is_taken_once() {
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

/// As many columns as a program can have inputs, in both forms: each is found at once.
#[test]
fn a_stimulus_is_as_wide_as_can_be() {
    let arrays: Vec<String> = (0..60).map(|array| format!("w{array}")).collect();
    let text =
        format!("ladder wide input {} : WORD[1024] output y rung w0.0 (y)", arrays.join(","));
    let (program, _) = hotrail::analyze(&Source::new("wide.ladder", text));
    let program = program.expect("a program");
    let columns: Vec<String> =
        (0..60 * 1024).map(|at| format!("{}[{}]", arrays[at / 1024], at % 1024)).collect();
    let csv = format!("{}\n{}\n", columns.join(","), vec!["7"; columns.len()].join(","));
    let json: Vec<String> = columns.iter().map(|column| format!("\"{column}\": 7")).collect();
    for stimulus in [csv, format!("{{{}}}", json.join(","))] {
        let read = Stimulus::parse(&program, &Source::new("wide", stimulus)).expect("a stimulus");
        assert_eq!((read.len(), read.row(0).drives.len()), (1, columns.len()));
    }
}

#[test]
fn a_time_may_say_that_it_is_one_wherever_times_stand() {
    for prefix in ["T#", "t#", "TIME#", "time#", "Time#"] {
        let text = format!(
            "ladder demo tick {prefix}10ms input a output y const LONG := {prefix}1h \
             var t : TIME := {prefix}1m30s \
             rung a d:TON(PT := {prefix}5s) b:AB_TON(PRE := 5, BASE := {prefix}100ms) (y) \
             rung {{ t > {prefix}2s + LONG }} {{ t := t - {prefix}1s }} \
             test \"times\" wait {prefix}50ms expect !y"
        );
        assert_eq!(findings(text), [""; 0], "{prefix}");
    }
}

#[test]
fn times_of_literals_are_worked_out_exactly() {
    let time = |constants: &str, time: &str| {
        findings(format!("{START} {constants} var t : TIME rung a {{ t := {time} }} (y)"))
    };
    let day = "const DAY := 1d const MANY : TIME := 24d";
    for fits in [
        "24d + 24d - 24d",
        "30d - 29d",
        "-24d * 3 / 3",
        "30 * DAY / 2",
        "3s * (7 MOD 4)",
        "-(24d20h31m23.648s)",
        "5s / 0",
        // Only what has a type wraps.
        "MANY + MANY",
        "MANY + 24d",
        "t + 24d + 24d",
    ] {
        assert_eq!(time(day, fits), [""; 0], "{fits}");
    }
    for too_long in ["24d + 24d", "-24d - 24d", "30 * DAY", "3s * 3000000", "t + (20d + 20d)"] {
        assert_eq!(time(day, too_long), ["E0202"], "{too_long}");
    }
    assert_eq!(time("const LONG := 24d + 24d", "LONG"), ["E0202"]);
    let huge = format!("1d{}", " * 4294967295".repeat(8));
    assert_eq!(time("", &huge), ["E0202"]);
    for mixed in ["5s + 3", "3 + 5s", "5s * 5s", "3 / 5s", "5s MOD 2", "(1 + 2) + 5s"] {
        assert_eq!(time("", mixed), ["E0201"], "{mixed}");
    }
}
