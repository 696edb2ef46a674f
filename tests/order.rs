//! `--order dataflow`: the rungs as values flow between them, and what is said about the change.

mod common;

use common::reordered::wrong_claim;
use common::{amount, checks, generate};
use hotrail::equations::by_dataflow;
use hotrail::model::Program;
use hotrail::report::{Report, order_summary};
use hotrail::source::Source;

fn analyze(text: &str) -> Program {
    let (program, findings) = hotrail::analyze(&Source::new("demo.ladder", text));
    program.unwrap_or_else(|| panic!("{findings:?}"))
}

/// The rungs in their new order, numbered as in the text.
fn order(rungs: &str) -> Vec<u32> {
    let start = "ladder demo  input a, b  output x, y, z  var m  var w : WORD  ";
    let mut program = analyze(&format!("{start}{rungs}"));
    let order = by_dataflow(&mut program);
    let numbers: Vec<u32> = program.rungs.iter().map(|rung| rung.number).collect();
    assert_eq!(order.rungs.iter().map(|rung| rung + 1).collect::<Vec<_>>(), numbers);
    numbers
}

#[test]
fn readers_come_behind_writers() {
    assert_eq!(order("rung a (x) rung x (y)"), [1, 2]);
    assert_eq!(order("rung x (y) rung a (x)"), [2, 1]);
    assert_eq!(order("rung y (z) rung x (y) rung a (x)"), [3, 2, 1]);
    // What is free stays in the order of the text.
    assert_eq!(order("rung a (x) rung b (y) rung a b (z)"), [1, 2, 3]);
    // A seal-in reads itself.
    assert_eq!(order("rung x (y) rung [ a | x ] !b (x)"), [2, 1]);
    assert_eq!(order("rung t.Q (x) rung a t:TON(PT := 5ms)"), [2, 1]);
    assert_eq!(order("rung w.1 (x) rung a s:SHL(REG := w)"), [2, 1]);
}

#[test]
fn writers_stay_in_the_order_of_the_text() {
    assert_eq!(order("rung a (S x) rung x (y) rung b (R x)"), [1, 3, 2]);
    assert_eq!(order("rung a (R t) rung b t:TON(PT := 5ms) rung t.Q (x)"), [1, 2, 3]);
    assert_eq!(order("rung t.Q (R t) rung b t:TON(PT := 5ms)"), [1, 2]);
}

#[test]
fn loops_keep_the_order_of_the_text_and_come_in_their_place() {
    assert_eq!(order("rung a !y (x) rung b !x (y)"), [1, 2]);
    // The reader of a loop comes behind it, what it reads in front.
    assert_eq!(order("rung y (z) rung m !y (x) rung b !x (y) rung a (m)"), [4, 2, 3, 1]);
}

/// What a rung reads twice, or reads after it has written it, is told once or not at all.
#[test]
fn a_change_is_told_once() {
    let text = "ladder demo input a, b output x, y, z
        rung [ x a | !x b ] (y)  rung a (x)  rung b (S z) z (y)";
    let order = by_dataflow(&mut analyze(text));
    assert_eq!(order.rungs, [1, 0, 2]);
    let [change] = &order.changes[..] else { panic!("{:?}", order.changes) };
    assert_eq!((change.rung, change.before, change.after), (0, None, Some(1)));
    assert!(order.feedback.is_empty());
}

#[test]
fn what_is_not_named_does_not_differ() {
    let mut changed = 0;
    let programs = amount("HOTRAIL_RANDOM_PROGRAMS", 1000) / 4;
    checks::ORDER.hold(programs);
    for seed in 0..programs {
        let mut program = analyze(&generate::program(seed));
        changed += usize::from(!by_dataflow(&mut program).changes.is_empty());
    }
    assert!(changed > 0);
    for example in common::examples() {
        let text = std::fs::read_to_string(&example.ladder).unwrap();
        let wrong = wrong_claim(&analyze(&text), &mut analyze(&text), 1);
        assert_eq!(wrong, None, "{}", example.ladder.display());
    }
}

/// The page shows the report of an example.
#[test]
fn the_page_is_true() {
    let text = include_str!("../examples/order_next_scan/order_next_scan.ladder");
    let mut program = analyze(text);
    let order = by_dataflow(&mut program);
    let mut report = Report::new(&program, false);
    report.set_order(order);
    let page = include_str!("../docs/equations.md");
    let (_, behind) = page.split_once("<!-- order -->\n```text\n").unwrap();
    let (shown, _) = behind.split_once("```").unwrap();
    assert!(report.text().starts_with(shown), "{}", report.text());
}

#[test]
fn the_report_tells_what_changes() {
    let text = "ladder demo input a output x, y, z, u var m
        rung y (z) rung x !u (y) rung a (x) rung y (u) rung a (m) rung m (m)";
    let mut program = analyze(text);
    let order = by_dataflow(&mut program);
    let summary = order_summary(&program, &order);
    let mut report = Report::new(&program, false);
    report.set_order(order);
    let (head, _) =
        report.text().split_once("\n\n").map(|(a, b)| (a.to_owned(), b.to_owned())).unwrap();
    insta::assert_snapshot!("order", format!("{summary}\n\n{head}\n"));
    assert!(report.json().contains("\"may_differ\""));
    assert!(!Report::new(&program, false).json().contains("may_differ"));
}
