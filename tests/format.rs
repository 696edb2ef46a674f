//! The formatter: the same program, the same comments at the same places, and nothing to do when
//! it is run again.

mod common;

#[path = "format/sprinkle.rs"]
mod sprinkle;
#[path = "format/text.rs"]
mod text;

use std::path::PathBuf;
use std::thread;

use common::{amount, generate};
use fastrand::Rng;
use hotrail::diagnostic;
use hotrail::source::Source;
use hotrail::syntax;
use text::{comments_and_places, tree};

/// Formats and holds the result to everything that is true of every layout.
fn format(text: &str) -> String {
    let formatted = format_once(text);
    for (item, (after, before)) in std::iter::zip(tree(&formatted), tree(text)).enumerate() {
        assert_eq!(after, before, "item {item} is another\n{text}\n---\n{formatted}");
    }
    assert_eq!(tree(&formatted).len(), tree(text).len(), "{text}\n---\n{formatted}");
    let (before, after) = (comments_and_places(text), comments_and_places(&formatted));
    assert_eq!(after, before, "other comments\n{text}\n---\n{formatted}");
    assert_eq!(format_once(&formatted), formatted, "not stable\n{text}\n---\n{formatted}");
    assert!(!formatted.contains('\r') && !formatted.starts_with('\u{FEFF}'));
    // Long comments and what is reserved for later stay as written inside.
    let is_ours = !["/*", "use", "assert"].iter().any(|word| text.contains(word));
    assert!(!is_ours || !formatted.contains("\n\n\n"), "{formatted}");
    assert!(!formatted.starts_with('\n') && !formatted.ends_with("\n\n"), "{formatted}");
    assert!(formatted.is_empty() || formatted.ends_with('\n'), "{formatted}");
    for line in formatted.lines() {
        assert_eq!(line, line.trim_end(), "blanks at the end of a line");
        assert!(!line.trim_end().starts_with('\t'), "{line}");
    }
    formatted
}

fn format_once(text: &str) -> String {
    let source = Source::new("test.ladder", text);
    syntax::format(&source).unwrap_or_else(|diagnostics| {
        let found: String =
            diagnostics.iter().map(|d| diagnostic::render(d, &source, false)).collect();
        panic!("{found}\n{text}")
    })
}

#[test]
fn random_programs_stay_what_they_are() {
    // The layout has fewer cases than the meaning.
    for seed in 0..amount("HOTRAIL_RANDOM_PROGRAMS", 1000).min(2000) {
        let mut random = Rng::with_seed(seed);
        let program = generate::program(seed) + &sprinkle::more_items(&mut random);
        let plain = format(&program);
        let longest = plain.lines().map(|line| line.chars().count()).max();
        assert!(longest <= Some(100), "{plain}");
        let sprinkled = sprinkle::sprinkle(&program, &mut random);
        format(&sprinkled);
        // White space alone changes nothing, but in tests and in what is reserved for later.
        if !["test ", "use ", "assert "].iter().any(|word| plain.contains(word)) {
            let blanks = sprinkle::blanks(&program, &mut random);
            assert_eq!(without_blank_lines(&format(&blanks)), without_blank_lines(&plain));
        }
    }
}

fn without_blank_lines(text: &str) -> String {
    text.lines().filter(|line| !line.is_empty()).map(|line| format!("{line}\n")).collect()
}

#[test]
fn examples_are_formatted() {
    for example in common::examples() {
        let text = std::fs::read_to_string(&example.ladder).unwrap();
        let name = example.ladder.display();
        assert_eq!(format(&text), text, "run: hotrail fmt {name}");
    }
}

#[test]
fn ladders_in_the_documents_are_formatted() {
    let mut documents = vec![PathBuf::from("README.md")];
    for folder in ["docs", "docs/errors"] {
        let entries = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
        documents.extend(entries.filter(|path| path.extension().is_some_and(|e| e == "md")));
    }
    let mut count = 0;
    for document in documents {
        let text = std::fs::read_to_string(&document).unwrap();
        for ladder in text.split("```ladder\n").skip(1) {
            let ladder = ladder.split("```").next().unwrap();
            // The pages of mistakes have ladders with mistakes.
            if let Ok(formatted) = syntax::format(&Source::new("document", ladder)) {
                assert_eq!(formatted, ladder, "{}", document.display());
                count += 1;
            }
        }
    }
    assert!(count > 100, "{count}");
}

#[test]
fn a_new_project_is_formatted() {
    let text = include_str!("../templates/new/program.ladder").replace("{{NAME}}", "conveyor");
    assert_eq!(format(&text), text);
}

#[test]
fn mistakes_are_reported_and_nothing_is_formatted() {
    let source = Source::new("test", "ladder x\nrung a => (y)\nrung [");
    assert_eq!(syntax::format(&source).unwrap_err().len(), 2);
}

/// A case of `tests/format/`: `NAME.ladder` is formatted to the snapshot `NAME`.
macro_rules! case {
    ($name:ident) => {
        #[test]
        fn $name() {
            let text = include_str!(concat!("format/", stringify!($name), ".ladder"));
            insta::with_settings!({
                snapshot_path => "format",
                prepend_module_to_snapshot => false,
                omit_expression => true,
            }, {
                insta::assert_snapshot!(stringify!($name), format(text));
            });
        }
    };
}

case!(every_construct);
case!(comments_everywhere);
case!(long_chains);
case!(long_rungs);
case!(one_line);

#[test]
fn line_ends_and_marks_of_other_systems_go() {
    let text = "\u{FEFF}// a \r\nladder\tx\t\"a\tb\"\r\n\r\n\r\n\r\n/* b  \r\n\t c */ input a\r\n";
    let formatted = format(text);
    assert_eq!(formatted, "// a\nladder x \"a\tb\"\n\n/* b\n     c */\ninput  a\n");
}

#[test]
fn what_is_empty_stays_empty() {
    assert_eq!(format(""), "");
    assert_eq!(format(" \r\n\t\n"), "");
    assert_eq!(format("\n\n// alone"), "// alone\n");
    assert_eq!(
        format("rung rung \"t\" rung [ | ] t:TON( ) net { } u:TON(R:=)"),
        "rung\nrung \"t\"\nrung [ | ] t:TON() net { } u:TON(R :=)\n"
    );
}

#[test]
fn names_lose_back_ticks_that_they_do_not_need() {
    let formatted =
        format("input `a`, `I:0/3`, `rung`, `größe`, `1a`, `S`\nrung `a` (`S`) (S `S`)");
    assert_eq!(formatted, "input  a, `I:0/3`, `rung`, `größe`, `1a`, S\n\nrung a ( S ) (S S)\n");
}

#[test]
fn brackets_of_expressions_stay_as_written() {
    for (written, printed) in [
        ("((a+b))*c=-( -1)", "{ (a + b) * c = -(-1) }"),
        ("(a AND b) OR (NOT(c))", "{ (a AND b) OR (NOT (c)) }"),
        ("(((a)))", "{ (a) }"),
        ("( a ):=( ( b ) )", "{ a := (b) }"),
        ("(a)+b", "{ (a) + b }"),
        ("((a)+b)", "{ ((a) + b) }"),
        ("- - 1 = NOT NOT a", "{ --1 = NOT NOT a }"),
    ] {
        assert_eq!(format(&format!("rung {{{written}}}")), format!("rung {printed}\n"));
    }
    // Without the brackets these would read as networks.
    format("rung t:TON(R := (a / (b + 1)), S := ((a)) / (b + 1), T := (a) / -b)");
}

/// Formats on a stack of 2 MiB.
fn format_on_a_small_stack(text: String) -> String {
    let run = thread::Builder::new().stack_size(2 << 20).spawn(move || format_once(&text));
    run.unwrap().join().expect("no overflow")
}

#[test]
fn deep_programs_fit_the_stack() {
    for (before, open, middle, close) in [
        ("rung ", "[ a | ", "b", "]"),
        ("rung ", "a [", "b // c\n", "] c"),
        ("rung ", "t:TON(R := x ", "a", ")"),
        ("rung ", "net { a -> b : ", "c", "}"),
        ("test \"t\" ", "repeat 2 {", "scan // c\n", "}"),
    ] {
        for depth in [200, syntax::MAX_NESTING] {
            let text = format!("{before}{}{middle}{}", open.repeat(depth), close.repeat(depth));
            let formatted = format_on_a_small_stack(text);
            assert_eq!(format_on_a_small_stack(formatted.clone()), formatted);
        }
    }
    for (open, middle, close) in
        [("(", "a", ")"), ("MAX(1,", "a", ")"), ("w[", "a", "]"), ("-", "1", ""), ("(1+", "a", ")")]
    {
        let depth = syntax::MAX_NESTING - 1;
        let nest = format!("{}{middle}{}", open.repeat(depth), close.repeat(depth));
        let formatted = format_on_a_small_stack(format!("var w : INT[4] rung {{{nest}}}"));
        assert_eq!(format_on_a_small_stack(formatted.clone()), formatted);
    }
}

/// What takes more time than the text is long would keep this from ending.
#[test]
fn long_texts_are_formatted() {
    for unit in ["rung a [ b /* c */ | !c d ] { n := n + 1 } ( y ) /* e */ ", "// c\n", "/* c */ "]
    {
        format_on_a_small_stack(unit.repeat(2_000_000 / unit.len()));
    }
    format_on_a_small_stack(format!("rung {}", "a [ b | /* m\nm */ c ] ".repeat(50_000)));
    format_on_a_small_stack(format!("test \"t\" {}", "a := 1 scan ".repeat(50_000)));
    format_on_a_small_stack(format!("input a {}", ", /* c */ b // d\n".repeat(50_000)));
}
