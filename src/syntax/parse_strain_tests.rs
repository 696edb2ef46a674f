//! Texts that strain the parser: deep, long, and with mistakes without end.

use super::tests::mistakes;
use super::*;
use crate::syntax::MAX_NESTING;

/// Parses and drops the tree on a stack of 2 MiB. What grows exponentially would take hours.
fn mistakes_on_a_small_stack(text: String) -> Vec<String> {
    let run = thread::Builder::new().stack_size(2 << 20).spawn(move || mistakes(&text));
    run.unwrap().join().expect("no overflow")
}

#[test]
fn deep_brackets_fit_the_stack() {
    let nest = |before: &str, open: &str, middle: &str, close: &str, depth: usize| {
        format!("{before}{}{middle}{}", open.repeat(depth), close.repeat(depth))
    };
    for depth in [200, MAX_NESTING - 1] {
        for (open, middle, close) in [
            ("[ a | ", "b", "]"),
            ("a [", "b", "] c"),
            ("[", "", "]"),
            ("t:TON(R := ", "a", ")"),
            ("t:TON(R := x ", "a", ")"),
            ("net { a -> b : ", "c", "}"),
        ] {
            assert_eq!(
                mistakes_on_a_small_stack(nest("rung ", open, middle, close, depth)),
                [""; 0]
            );
        }
        for (open, middle, close) in [("(", "a", ")"), ("MAX(1,", "a", ")"), ("w[", "a", "]")] {
            let text = nest("var w : INT[4] rung {", open, middle, close, depth) + "}";
            assert_eq!(mistakes_on_a_small_stack(text), [""; 0]);
            let text = nest("var w : INT[4] rung t:TON(R := ", open, middle, close, depth) + ")";
            assert_eq!(mistakes_on_a_small_stack(text), [""; 0]);
            let text = nest("var w : INT[4] rung {", open, "+", close, depth) + "}";
            assert_eq!(mistakes_on_a_small_stack(text).len(), 1);
        }
        assert_eq!(mistakes_on_a_small_stack(nest("rung ", "(", "a", ")", depth)).len(), 1);
        assert_eq!(
            mistakes_on_a_small_stack(nest("rung t:TON(R := ", "[", "+", "]", depth) + ")").len(),
            1
        );
        assert_eq!(
            mistakes_on_a_small_stack(nest("test \"t\" ", "repeat 2 {", "", "}", depth)),
            [""; 0]
        );
    }
}

#[test]
fn deep_operators_are_refused() {
    for (unit, end) in [("a - ", "a"), ("NOT ", "a"), ("- ", "1"), ("a = ", "b")] {
        let chain = |length: usize| format!("rung {{ {}{end} }}", unit.repeat(length));
        assert_eq!(mistakes_on_a_small_stack(chain(MAX_NESTING)), [""; 0]);
        for length in [MAX_NESTING + 1, 100_000] {
            let found = mistakes_on_a_small_stack(chain(length));
            assert_eq!(found.len(), 1);
            assert!(
                found[0].contains("E0003 an expression may have at most 256 operators"),
                "{found:?}"
            );
        }
    }
    let both = format!("rung {{ {}a{} }}", "(1 + ".repeat(250), ")".repeat(250));
    assert_eq!(mistakes_on_a_small_stack(both), [""; 0]);
}

#[test]
fn many_cores_read_what_one_reads() {
    let unit = "rung a [ b | c ] (y)\n// comment\nrung w[1] (z)\nrung {\n";
    let text = format!("var w : INT[2]\n{}", unit.repeat(3 * WORTH_A_THREAD / unit.len()));
    let source = Source::new("test", text);
    let (file, diagnostics) = parse(&source);
    let units = 3 * WORTH_A_THREAD / unit.len();
    assert_eq!((file.items.len(), diagnostics.len()), (1 + 2 * units, units));
    assert!(diagnostics.is_sorted_by_key(|diagnostic| diagnostic.primary.span));
}

#[test]
fn many_mistakes_on_one_line_are_all_found() {
    assert_eq!(mistakes_on_a_small_stack("rung ) ".repeat(5_000)).len(), 5_000);
}
