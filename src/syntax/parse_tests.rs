use super::shape::{expression, series, statements};
use super::*;
use crate::syntax::ast::*;

fn parsed<T>(text: &str, use_file: impl FnOnce(&File<'_>) -> T) -> T {
    let source = Source::new("test", text);
    let (file, diagnostics) = parse(&source);
    assert_eq!(diagnostics, [], "{text}");
    use_file(&file)
}

/// Code, message and place of every diagnostic.
pub(super) fn mistakes(text: &str) -> Vec<String> {
    let source = Source::new("test", text);
    let (_, diagnostics) = parse(&source);
    let describe = |d: &Diagnostic| {
        let place = source.position(d.primary.span.start);
        format!("{place} {} {}", d.code.id, d.message)
    };
    diagnostics.iter().map(describe).collect()
}

/// The network of the last item, which is a rung, in a plain form.
fn rung(network: &str) -> String {
    parsed(&format!("var w : WORD[4]\nrung {network}"), |file| match file.items.last() {
        Some(Item::Rung(rung)) => series(&rung.network),
        other => panic!("{other:?}"),
    })
}

fn value(text: &str) -> String {
    parsed(&format!("var w : WORD[4]\nrung {{{text}}}"), |file| match file.items.last() {
        Some(Item::Rung(rung)) => match &rung.network.elements[0].kind {
            ElementKind::Compare(compare) => expression(compare),
            other => panic!("{other:?}"),
        },
        other => panic!("{other:?}"),
    })
}

#[test]
fn every_declaration_reads() {
    let text = "ladder a \"t\" clock 12.5MHz tick 1ms input a, `I:0/3` : INT output y at 316 := 1\n\
        var w : WORD[3] := [16#FF, -1] var m, n : INT := 5 var q : BOOL at 600 := TRUE\n\
        const FULL : INT := 2 * N const t := 5s use \"f\" assert always a block x";
    parsed(text, |file| {
        let [header, clock, tick, input, output, array, two, placed, full, time, later @ ..] =
            file.items.as_slice()
        else {
            panic!("{file:?}")
        };
        assert!(matches!(header, Item::Header(h) if h.title.unwrap().text == "t"));
        assert!(matches!(clock, Item::Clock(q) if q.text == "12.5MHz"));
        assert!(matches!(tick, Item::Tick(q) if q.text == "1ms"));
        assert!(matches!(input, Item::Variables(v) if v.kind == VariableKind::Input
            && v.names[1].name.text == "I:0/3" && v.ty.as_ref().unwrap().name.text == "INT"));
        assert!(matches!(output, Item::Variables(v) if v.kind == VariableKind::Output
            && v.ty.is_none() && v.names[0].address.unwrap().text == "316"
            && matches!(v.names[0].initial, Some(Initial::Value(_)))));
        assert!(matches!(array, Item::Variables(v) if v.kind == VariableKind::Var
            && v.ty.as_ref().unwrap().length.unwrap().text() == "3"
            && matches!(&v.names[0].initial, Some(Initial::List(values, _)) if values.len() == 2)));
        assert!(matches!(two, Item::Variables(v)
            if v.names.len() == 2 && v.names.iter().all(|name| name.initial.is_some())));
        assert!(matches!(placed, Item::Variables(v)
            if v.names[0].address.is_some() && v.names[0].initial.is_some()));
        assert!(matches!(full, Item::Constant(c) if c.ty.is_some()));
        assert!(matches!(time, Item::Constant(c) if c.ty.is_none() && c.name.text == "t"));
        assert!(later.len() == 3 && later.iter().all(|item| matches!(item, Item::Reserved(_))));
    });
}

#[test]
fn every_element_reads() {
    for (text, shape) in [
        ("a !b /c ! d.5 t1.Q", "a !b !c !d.#5 t1.Q"),
        (
            "TRUE FALSE 1 0 first_scan !first_scan",
            "const:true const:false const:true const:false first !first",
        ),
        ("rise(x) fall ( w[1].3 )", "Rise<x> Fall<w<1>.#3>"),
        ("[ a b | c | [ !d ] ]", "[a b|c|[!d]]"),
        ("a rising falling not(y)", "a Rise Fall Invert (Plain y)"),
        (
            "(y) (!y) (/y) (S y) (R t1) (rise y) (fall y)",
            "(Plain y) (Negated y) (Negated y) (Set y) (Reset t1) (Rise y) (Fall y)",
        ),
        (
            "(S) ( R ) (S.5) (S `a b`) (Sy) left right",
            "(Plain S) (Plain R) (Plain S.#5) (Set a b) (Plain Sy) left right",
        ),
        ("{ a >= 10 } { w[i].5 := b }", "{(a GreaterOrEqual 10)} {w<i>.#5:=b}"),
        ("`%IX0.3` `rung`.5 !`not`", "%IX0.3 rung.#5 !not"),
        ("a/* [ */ // )\n b", "a b"),
        ("! /* /x */ b / // c\n d", "!b !d"),
        ("notx rise_1 netto TRUEST", "notx rise_1 netto TRUEST"),
    ] {
        assert_eq!(rung(text), shape);
    }
}

#[test]
fn only_arrays_have_indexes() {
    assert_eq!(rung("w[2] w [i+1].5 x[ w ] x [ a ]"), "w<2> w<(i Add 1)>.#5 x [w] x [a]");
    assert_eq!(rung("/w[w[v]] (S w[1].4)"), "!w<w<v>> (Set w<1>.#4)");
    let late = parsed("rung w[a] (y) var w : WORD[2]", |file| format!("{:?}", file.items[0]));
    assert!(late.contains("Index"), "declarations may stand anywhere");
    assert_eq!(
        mistakes("rung x[2] (y) { x[2] = 1 }"),
        ["1:8 E0001 expected a contact, a coil, a list, `|` or `]`, found `2`"]
    );
    assert_eq!(
        mistakes("rung {x[2] = 1}"),
        ["1:8 E0001 expected an operator, `:=` or `}`, found `[`"]
    );
    // A mistake in its declaration makes no other where an array is read.
    assert_eq!(mistakes("var w : WORD[+]\nrung w[2] (y)").len(), 1);
}

#[test]
fn arguments_take_the_narrowest_reading() {
    for (text, shape) in [
        ("PV := 4, PT := T#5s, X := A", "PV=4; PT=T#5s; X=A"),
        ("R := [ clear | full fall ]", "R=net [clear|full fall]"),
        ("R := a !b", "R=net a !b"),
        ("R := !a, S := /a", "R=net !a; S=net !a"),
        ("R := a /b, EN := a b", "R=(a Divide b); EN=net a b"),
        ("R := first_scan, S := rise(x), T := not a", "R=net first; S=net Rise<x>; T=net Invert a"),
        ("R := { n > 3 } a", "R=net {(n Greater 3)} a"),
        ("R := 1, S := 1 a, T := TRUE", "R=1; S=net const:true a; T=TRUE"),
        (
            "T := [10, 200], U := [A, -1], V := [5], X := [a]",
            "T=list 10,200; U=list A,(Negate 1); V=list 5; X=list a",
        ),
        ("R := [a] b, S := [ a b ], T := [[a] | b]", "R=net [a] b; S=net [a b]; T=net [[a]|b]"),
        ("R := w[1].5, S := w[i] b, T := MAX(a, b)", "R=w<1>.#5; S=net w<i> b; T=MAX(a,b)"),
        (
            "R := (a + b) * 2, S := a + 1, T := NOT a, U := a = b",
            "R=((a Add b) Multiply 2); S=(a Add 1); T=(Not a); U=(a Equal b)",
        ),
        ("", ""),
    ] {
        assert_eq!(rung(&format!("t:TON({text})")), format!("t:TON<{shape}>"));
    }
    assert_eq!(rung("a b : CTU ( ) (y)"), "a b:CTU<> (Plain y)");
}

#[test]
fn general_networks_read() {
    let text = "net { left -> n1 : [ c9 | c2 ] n1<->n2:c6 c7 n2 -> right : t:TON() } (y)";
    let shape = "left->n1:[c9|c2],n1<->n2:c6 c7,n2->right:t:TON<> (Plain y)";
    assert_eq!(rung(text), shape);
}

#[test]
fn operators_bind_as_in_structured_text() {
    for (text, shape) in [
        ("a + b * c", "(a Add (b Multiply c))"),
        ("a - b - c", "((a Subtract b) Subtract c)"),
        ("a OR b XOR c AND d", "(a Or (b Xor (c And d)))"),
        ("a = b < c + d", "(a Equal (b Less (c Add d)))"),
        ("NOT a = b", "((Not a) Equal b)"),
        ("- a * b MOD -c", "(((Negate a) Multiply b) Modulo (Negate c))"),
        ("NOT NOT a AND (b OR c)", "((Not (Not a)) And (b Or c))"),
        (
            "LIMIT(0, x.5, MAX(a,b)) <> t.CV / 2",
            "(LIMIT(0,x.#5,MAX(a,b)) NotEqual (t.CV Divide 2))",
        ),
        ("a <= 5s", "(a LessOrEqual 5s)"),
        ("ANDY > ORa", "(ANDY Greater ORa)"),
        ("w[w[i]+1] = TRUE", "(w<(w<i> Add 1)> Equal TRUE)"),
    ] {
        assert_eq!(value(text), shape);
    }
}

#[test]
fn tests_read() {
    let text = "test \"t\" start := 1 n := -5 + a scan scan 10 wait 1.5s pulse `a b` reset\n\
        repeat 4 { scan repeat 2 { } } expect a !b { n = 3 } [ c | d ] b.5 := 1 expect w x := 2";
    let shape = |text| {
        parsed(text, |file| match &file.items[0] {
            Item::Test(test) => statements(&test.statements),
            other => panic!("{other:?}"),
        })
    };
    assert_eq!(
        shape(text),
        "start:=1;n:=((Negate 5) Add a);scan;scan 10;wait 1.5s;pulse a b;reset;\
         4*{scan;2*{}};expect a !b {(n Equal 3)} [c|d];b.#5:=1;expect w;x:=2"
    );
    // A name is an amount, unless it is what the next statement drives.
    assert_eq!(
        shape(
            "test \"t\" scan N scan a := 1 scan a.5 := 1 wait T a := 1 repeat N { scan } scan scan"
        ),
        "scan N;scan;a:=1;scan;a.#5:=1;wait T;a:=1;N*{scan};scan;scan"
    );
}

#[test]
fn spans_point_into_the_source() {
    let text = "\u{FEFF}rung \"é\" /* ü */ [ a | `ö` ]  b:TON( PT := ( 1 + 2 ) )  (y)  rung";
    parsed(text, |file| {
        let Item::Rung(rung) = &file.items[0] else { panic!() };
        let place = |span: Span| &text[span.range()];
        assert_eq!(rung.title.unwrap().text, "é");
        let spans: Vec<_> = rung.network.elements.iter().map(|e| place(e.span)).collect();
        assert_eq!(spans, ["[ a | `ö` ]", "b:TON( PT := ( 1 + 2 ) )", "(y)"]);
        assert!(place(rung.span).starts_with("rung \"é\"") && place(rung.span).ends_with("(y)"));
        assert_eq!(place(file.comments[0]), "/* ü */");
        let ElementKind::Call(call) = &rung.network.elements[1].kind else { panic!() };
        let ArgumentValue::Expr(value) = &call.arguments[0].value else { panic!() };
        assert_eq!(place(value.span), "( 1 + 2 )");
    });
}

#[test]
fn what_is_empty_has_a_place() {
    let places = |text: &str| {
        parsed(text, |file| {
            let Some(Item::Rung(rung)) = file.items.last() else { panic!() };
            match rung.network.elements.first().map(|element| &element.kind) {
                None => vec![rung.network.span.start],
                Some(ElementKind::Parallel(all)) => all.iter().map(|s| s.span.start).collect(),
                Some(ElementKind::Call(call)) => match &call.arguments[0].value {
                    ArgumentValue::Network(network) => vec![network.span.start],
                    other => panic!("{other:?}"),
                },
                other => panic!("{other:?}"),
            }
        })
    };
    assert_eq!(places("rung\n\n"), [4]);
    assert_eq!(places("rung \"t\"\n"), [8]);
    assert_eq!(places("rung []"), [6]);
    assert_eq!(places("rung [ a | ]"), [7, 10]);
    assert_eq!(places("rung t:TON(R := )"), [15]);
}

#[test]
fn independent_mistakes_are_all_reported_in_order() {
    let text =
        "foo\nladder x\nrung a => (y)\nrung [ b (y)\nrung { c + } (y)\nrung d (y)\nrung ) \"";
    assert_eq!(
        mistakes(text),
        [
            "1:1 E0001 expected an item, found `foo`",
            "3:8 E0001 expected a contact, a coil, a list or the next item, found `=>`",
            "4:6 E0002 `[` is never closed",
            "5:12 E0001 expected a variable, a number or `(`, found `}`",
            "7:6 E0002 `)` closes nothing",
        ]
    );
}

#[test]
fn reserved_words_are_no_names() {
    for (text, place) in [
        ("input clock, a", "1:7"),
        ("input a, test\n", "1:10"),
        ("input a : INT\nvar rung : INT", "2:5"),
        ("const block : INT := 3", "1:7"),
        ("rung ( test )", "1:8"),
        ("rung [ a | test | b ] (y)", "1:12"),
        ("rung (S rung)", "1:9"),
        ("rung scan (y)", "1:6"),
        ("var at : INT", "1:5"),
        ("rung {a := wait}", "1:12"),
        ("var fall : INT", "1:5"),
        ("ladder MOD", "1:8"),
    ] {
        let found = mistakes(text);
        assert_eq!(found.len(), 1, "{text}: {found:?}");
        assert!(found[0].starts_with(&format!("{place} E0103")), "{text}: {found:?}");
    }
    assert_eq!(mistakes("input a,\ninput b"), ["2:1 E0001 expected a name, found `input`"]);
}

#[test]
fn mistakes_say_what_was_wanted() {
    for (text, message) in [
        ("ladder", "expected the program's name, found the end of the file"),
        ("clock fast", "expected a frequency such as 50MHz, found `fast`"),
        ("var a : INT, b", "expected the next item, found `,`"),
        ("var a : INT[-3]", "expected the number of elements, such as 3, found `-`"),
        ("output a, b : INT at 316", "one address cannot serve several names"),
        ("output a at 316 : INT at 317", "`a` is given an address twice"),
        ("var a : 5", "expected a type such as `INT`, found `5`"),
        ("const a : INT", "expected `:=` and the constant's value, found the end of the file"),
        (
            "rung a \"t\" (y)",
            "expected a contact, a coil, a list or the next item, found the string \"t\"",
        ),
        ("rung ()", "expected the variable of the coil, found `)`"),
        ("rung (a b)", "expected `)` after the coil's variable, found `b`"),
        ("rung a. (y)", "expected a member's name or a bit's number after `.`, found `(`"),
        ("rung t:TON(5s)", "expected a parameter such as `PT := 5s`, or `)`, found `5s`"),
        ("rung !t:TON()", "a block needs a plain name before `:`"),
        ("rung t:TON(PT := 5s PV := 3)", "expected `,` or `)` after the argument, found `PV`"),
        ("rung {a b}", "expected an operator, `:=` or `}`, found `b`"),
        ("rung {a + 1 := b}", "only a variable is assigned"),
        ("rung {a.b(c)}", "only a function can be called in an expression"),
        ("rung {rise(x)}", "`rise(x)` is an element of a rung and no value"),
        ("rung {a = 5x}", "`5x` is no number and no time"),
        ("rung !not (y)", "`not` cannot be negated"),
        ("rung größe (y)", "`ö` can stand in a name in back-ticks only"),
        ("rung `` (y)", "a quoted name is empty"),
        ("rung net (y)", "expected `{` after `net`, found `(`"),
        ("rung net { left : a }", "expected `->` or `<->` after the node, found `:`"),
        ("test a", "expected the test's title in double quotes, found `a`"),
        ("test \"t\" wait 5", "expected a time, found `5`"),
        ("test \"t\" scan 5s", "expected a number of scans, found `5s`"),
        (
            "test \"t\" a",
            "expected `:=` and the value to drive the input with, found the end of the file",
        ),
        ("test \"t\" repeat 4 { ; }", "expected a statement or `}`, found `;`"),
    ] {
        let found = mistakes(text);
        assert_eq!(found.len(), 1, "{text}: {found:?}");
        assert!(found[0].ends_with(message), "{text}: {found:?}");
    }
}
