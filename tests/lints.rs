//! When a warning is given, when it is not, and how it is allowed and denied. The pages of the
//! codes have one example of each kind; here are the cases between them.

use hotrail::diagnostic::{Diagnostic, Severity, code};
use hotrail::lint::Options;
use hotrail::source::Source;

/// What is found: the code and the text at the place.
fn found_with(text: &str, options: &Options) -> Vec<(String, String)> {
    let source = Source::new("lints.ladder", text);
    let (_, findings) = hotrail::analyze_with(&source, options);
    let place = |found: &Diagnostic| source.slice(found.primary.span).to_owned();
    findings.iter().map(|found| (found.code.id.to_owned(), place(found))).collect()
}

/// The same as `CODE place` in one line.
fn found(text: &str) -> String {
    let all = found_with(text, &Options::default());
    let lines: Vec<_> = all.iter().map(|(code, place)| format!("{code} {place}")).collect();
    lines.join(", ")
}

/// Two inputs and an output that are used, and what is added.
fn demo(text: &str) -> String {
    found(&format!("ladder demo\ninput a, b\noutput y\nrung a b ( y )\n{text}"))
}

#[test]
fn each_kind_of_read_and_write_counts() {
    for reader in [
        "rung m ( z )",
        "rung fall(m) ( z )",
        "rung { m = (1 = 1) } ( z )",
        "rung a { z := NOT m }",
        "rung a [ b | [ !m b ] ] ( z )",
        "rung a c:CTU(R := m, PV := 3) ( z )",
        "rung a c:CTU(R := [ a | !m ], PV := 3) ( z )",
    ] {
        let text = format!("output z\nvar m\nrung a ( m )\n{reader}");
        assert_eq!(demo(&text), "", "{reader}");
    }
    for writer in ["( m )", "( !m )", "(rise m)", "{ m := b }", "b (S m) a (R m)"] {
        assert_eq!(
            demo(&format!("output z\nvar m\nrung a {writer}\nrung m ( z )")),
            "",
            "{writer}"
        );
    }
}

#[test]
fn a_test_is_no_use_of_a_variable_but_of_a_constant() {
    let test = "test \"t\"  scan  expect !m !n { k = NONE }";
    let text = format!("var m, n\nvar k : INT\nconst NONE := 0\nrung a ( m )\n{test}");
    assert_eq!(demo(&text), "W0102 m, W0101 n, W0101 k");
    assert_eq!(demo("const NONE := 0"), "W0101 NONE");
}

#[test]
fn one_cause_is_one_finding() {
    // Unread, and so neither half a latch; unwritten, and so not unread as well.
    assert_eq!(demo("var m\nrung a (S m)"), "W0102 m");
    assert_eq!(demo("output z"), "W0104 z");
    assert_eq!(demo("output z\nrung z ( y )"), "W0104 z, W0301 ( y )");
    assert_eq!(demo("rung a ( y )\nrung b ( y )\nrung a !b ( y )"), "W0301 ( y )");
    assert_eq!(demo("var m\nrung m ( y )\nrung m ( y )"), "W0105 m, W0301 ( y )");
}

#[test]
fn an_initial_value_is_a_statement() {
    assert_eq!(demo("output z := 0"), "");
    assert_eq!(demo("output z\nvar m := TRUE\nrung m ( z )"), "");
    assert_eq!(demo("output z\nvar m\nrung m ( z )"), "W0105 m");
    assert_eq!(demo("var m := TRUE"), "W0101 m");
}

#[test]
fn an_assignment_may_be_the_other_half_of_a_latch() {
    assert_eq!(demo("output z\nrung a (S z)\nrung b { z := FALSE }"), "");
    assert_eq!(demo("output z\nrung a (R z)"), "W0304 (R z)");
    // A coil beside the latch is another mistake.
    assert_eq!(demo("output z\nrung a ( z )\nrung b (S z)"), "W0302 (S z)");
}

#[test]
fn an_interlock_and_a_seal_in_are_in_the_right_order() {
    assert_eq!(demo("output f, r\nrung a !r ( f )\nrung b !f ( r )"), "");
    assert_eq!(demo("output z\nrung [ a | z ] !b ( z )"), "");
    // A latch is read for what it was; so is a number.
    assert_eq!(demo("output z\nvar m\nrung m ( z )\nrung a (S m)\nrung b (R m)"), "");
    assert_eq!(demo("output z\nvar n : INT\nrung { n > 2 } ( z )\nrung a { n := n + 1 }"), "");
    // Written above already, the value is new.
    assert_eq!(demo("output z\nvar m\nrung a ( m )\nrung m ( z )\nrung b ( m )"), "W0301 ( m )");
}

#[test]
fn reads_above_a_coil_are_one_note_at_the_first_of_them() {
    let text = "output z, x\nvar m\nrung m ( z )\nrung !m ( x )\nrung a ( m )";
    assert_eq!(demo(text), "W0305 m");
}

#[test]
fn a_preset_may_be_assigned_or_a_variable() {
    let preset = |call: &str, more: &str| demo(&format!("output z\nrung a {call} ( z )\n{more}"));
    assert_eq!(preset("t:TON(PT := 0s)", ""), "W0401 PT := 0s");
    assert_eq!(preset("t:TON()", ""), "W0401 t");
    assert_eq!(preset("t:TON()", "rung b { t.PT := 5s }"), "");
    assert_eq!(preset("t:TON(PT := p)", "var p : TIME\nrung b { p := 5s }"), "");
    assert_eq!(preset("t:TON(PT := P)", "const P := 0s"), "W0401 PT := P");
    // A counter that is there for its count needs none.
    let count = "output n : INT\nrung { n := c.CV }";
    assert_eq!(preset("c:CTU(R := b)", count), "");
    assert_eq!(preset("c:CTU(R := b)", ""), "W0401 c");
    assert_eq!(preset("c:CTU(R := b, PV := 0)", count), "W0401 PV := 0");
}

#[test]
fn a_counter_is_reset_by_its_parameter_or_a_coil() {
    assert_eq!(demo("output z\nrung a c:CTU(PV := 3) ( z )"), "W0402 c");
    assert_eq!(demo("output z\nrung a c:CTU(PV := 3) ( z )\nrung b (R c)"), "");
    // Allen-Bradley's count may be put back by an assignment as well.
    for call in ["c:AB_CTU(PRE := 3)", "c:AB_CTD(PRE := 3)", "c:AB_RTO(PRE := 3)"] {
        let counter = format!("output z\nrung a {call}\nrung c.DN ( z )\n");
        assert_eq!(demo(&counter), "W0402 c", "{call}");
        assert_eq!(demo(&format!("{counter}rung b {{ c.PRE := 5 }}")), "W0402 c", "{call}");
        assert_eq!(demo(&format!("{counter}rung b {{ c.ACC := 0 }}")), "", "{call}");
    }
    // Said, so meant.
    assert_eq!(demo("output z\nrung a c:CTU(R := FALSE, PV := 3) ( z )"), "");
}

#[test]
fn a_time_may_be_compared_with_the_values_at_which_it_rests() {
    let compare = |condition: &str| {
        demo(&format!("output z, x\nrung a t:TON(PT := 5s) ( z )\nrung {{ {condition} }} ( x )"))
    };
    for fine in ["t.ET = 0s", "t.ET = t.PT", "5s = t.ET", "t.ET >= 3s", "t.ET < 3s"] {
        assert_eq!(compare(fine), "", "{fine}");
    }
    for bad in ["t.ET = 3s", "3s <> t.ET", "NOT (t.ET = 3s)"] {
        assert_eq!(compare(bad), format!("W0403 {{ {bad} }}"), "{bad}");
    }
}

#[test]
fn units_of_time_may_be_compared_as_times_may() {
    for call in [
        "t:AB_TON(PRE := 5) ( z )",
        "t:AB_TON(PRE := 5, SIZE := DINT) ( z )",
        "t:AB_TOF(PRE := 5) ( z )",
        "t:AB_RTO(PRE := 5) ( z )\nrung b (R t)",
        "t:T1_0(PV := 5) ( z )\nrung b (R t)",
        "t:T0_1(PV := 5) ( z )\nrung b (R t)",
        "t:T_01(PV := 5) ( z )\nrung b (R t)",
        "t:TS(PV := 5) ( z )\nrung b (R t)",
        "t:TT(MODE := OFF, PV := 5) ( z )",
    ] {
        let preset = if call.contains("PRE") { "PRE" } else { "PV" };
        let compare = |condition: &str| {
            demo(&format!("output z, x\nrung a {call}\nrung {{ {condition} }} ( x )"))
        };
        for fine in ["t.ACC = 0", &format!("t.ACC = t.{preset}"), "5 <> t.ACC", "t.ACC >= 3"] {
            assert_eq!(compare(fine), "", "{call}: {fine}");
        }
        assert_eq!(compare("t.ACC = 3"), "W0403 { t.ACC = 3 }", "{call}");
    }
    // Counts stay until the next event.
    for call in ["t:CTU(R := b, PV := 5)", "t:UC(PV := 5)", "t:AB_CTU(PRE := 5)"] {
        let count = if call.contains(":CTU") { "CV" } else { "ACC" };
        let text = format!("output z, x\nrung a {call} ( z )\nrung b (R t)\n");
        assert_eq!(demo(&format!("{text}rung {{ t.{count} = 3 }} ( x )")), "", "{call}");
    }
}

#[test]
fn size_is_counted_in_elements_and_depth_in_lists() {
    let rung = |contacts: usize| demo(&format!("output z\nrung {}( z )", "a ".repeat(contacts)));
    assert_eq!(rung(63), "");
    assert_eq!(rung(64), "W0306 rung");
    let nested =
        |depth| format!("output z\nrung {}a{} ( z )", "[".repeat(depth), "]".repeat(depth));
    assert_eq!(demo(&nested(8)), "");
    assert_eq!(demo(&nested(9)), "W0307 rung");
}

#[test]
fn a_comment_allows_what_it_belongs_to() {
    for (text, expected) in [
        // At the end of the line of a name, and only of that line.
        ("var m, // allow(W0101)\nn", "W0101 n"),
        ("var m,\nn // allow(unused): later", "W0101 m"),
        // Above a declaration: all its names.
        ("// allow(unused)\nvar m,\nn", ""),
        ("/* allow(unused) */ var m\nvar n", "W0101 n"),
        // Further comments and empty lines may stand between.
        ("// allow(unused)\n\n// for later\nvar m\nvar n", "W0101 n"),
        // For a rung: above it, or on its first or last line; on another line for that line.
        ("// allow(W0303)\nrung\na\n(S y)", "W0302 (S y)"),
        ("// allow(W0302, W0303)\nrung\na\n(S y)", ""),
        ("rung // allow(COIL-AND-LATCH)\na\n(S y)", ""),
        ("rung\na // allow(W0302)\n(S y)", "W0302 (S y)"),
        ("rung\na\n(S y) // allow(W0302)", ""),
        ("output z\nrung a (S y)\n( z ) // allow(W0302)", ""),
        ("output z\nrung a (S y)\n( z )\n// allow(W0302)", "W0302 (S y)"),
        // Not before its bracket: that is prose.
        ("// allow unused\nvar m", "W0101 m"),
        // Nothing below it.
        ("var m\n// allow(unused)", "W0101 m"),
    ] {
        assert_eq!(demo(text), expected, "{text}");
    }
}

#[test]
fn above_the_header_a_comment_allows_for_the_file() {
    let text = "ladder demo\ninput a, b\noutput y\nvar m\nrung a ( y )\nvar n";
    assert_eq!(found(&format!("// allow(unused)\n{text}")), "W0103 b");
    assert_eq!(found(&format!("/* About it. */\n// allow(W0101, W0103)\n{text}")), "");
}

#[test]
fn an_allow_that_names_no_warning_is_one() {
    assert_eq!(demo("// allow(W0999, unused)\nvar m"), "W0001 W0999");
    assert_eq!(demo("// allow(E0101)\nvar m"), "W0001 E0101, W0101 m");
    assert_eq!(demo("// allow( unusd )\nvar m"), "W0001 unusd, W0101 m");
    let source =
        Source::new("a.ladder", "// allow(doublecoil)\nladder a input x output y rung x (y)");
    let (_, findings) = hotrail::analyze(&source);
    assert_eq!(findings[0].help, ["is `double-coil` meant?"]);
}

#[test]
fn options_allow_deny_and_switch_off() {
    let text = "ladder demo\ninput a\noutput y, z\nvar m, n\n\
        rung m ( z )\nrung a ( m )\nrung a ( y )";
    let levels = |options: Options| -> Vec<(&'static str, Severity)> {
        let source = Source::new("a.ladder", text);
        let (program, findings) = hotrail::analyze_with(&source, &options);
        assert_eq!(program.is_none(), findings.iter().any(Diagnostic::is_error));
        findings.iter().map(|found| (found.code.id, found.code.severity)).collect()
    };
    use Severity::{Error, Note, Warning};
    assert_eq!(levels(Options::default()), [("W0101", Warning), ("W0305", Note)]);
    let allow = vec![code::UNUSED];
    assert_eq!(levels(Options { allow, ..Options::default() }), [("W0305", Note)]);
    let all = Options { deny_warnings: true, ..Options::default() };
    assert_eq!(levels(all), [("W0101", Error), ("W0305", Note)]);
    let deny = vec![code::READ_ABOVE];
    let one = Options { deny, ..Options::default() };
    assert_eq!(levels(one), [("W0101", Warning), ("W0305", Error)]);
    assert_eq!(levels(Options { off: true, ..Options::default() }), []);
}

#[test]
fn findings_stand_in_the_order_of_the_text() {
    let text = "ladder demo\ninput a, b\nvar m\noutput y\nrung a ( y )\nrung a ( y )\nvar k";
    assert_eq!(found(text), "W0103 b, W0101 m, W0301 ( y ), W0101 k");
}

#[test]
fn at_the_rail_a_not_or_a_one_shot_acts_on_nothing() {
    for (rung, place) in [
        ("rung not a ( z )", "W0310 not"),
        ("rung rising a ( z )", "W0310 rising"),
        ("rung [ a | falling b ] ( z )", "W0310 falling"),
        ("rung [ a | not [ b | not a ] ] ( z )", "W0310 not"),
        ("rung ( z ) not b ( w )", "W0310 not"),
        ("rung a c:CTU(R := not b, PV := 3) ( z )", "W0310 not"),
        ("rung a c:CTU(R := [ b | rising ], PV := 3) ( z )", "W0310 rising"),
        ("rung a not b ( z )", ""),
        ("rung a [ b | not ] ( z )", ""),
        ("rung [ a | b ] rising ( z )", ""),
        ("rung t:TON(PT := 1s) not ( z )", ""),
        ("rung a c:CTU(R := b not, PV := 3) ( z )", ""),
    ] {
        let w = if rung.contains("( w )") { ", w" } else { "" };
        assert_eq!(demo(&format!("output z{w}\n{rung}")), place, "{rung}");
    }
}

#[test]
fn a_divisor_that_is_always_0_is_told_once() {
    let divide = |expression: &str| {
        demo(&format!(
            "input n : INT\noutput q : INT\noutput t : TIME\nrung {{ q := n }} {expression}"
        ))
    };
    for (bad, place) in [
        ("{ q := n / 0 }", "0"),
        ("{ q := 7 / 0 }", "0"),
        ("{ q := 7 MOD (3 - 3) }", "(3 - 3)"),
        ("{ t := 3s / 0 }", "0"),
        ("{ n / 0 = 0 } ( y )", "0"),
    ] {
        assert!(divide(bad).contains(&format!("W0202 {place}")), "{bad}: {}", divide(bad));
        assert_eq!(divide(bad).matches("W0202").count(), 1, "{bad}");
    }
    assert!(demo("const NONE := 4 / 0\noutput q : INT\nrung { q := NONE }").contains("W0202 0"));
    for good in ["{ q := 0 / 4 }", "{ q := n / 8 + 0 }", "{ q := n / 1 * 0 }", "{ t := 0s / 4 }"] {
        assert_eq!(divide(good).matches("W0202").count(), 0, "{good}");
    }
}
