//! What the ladder processor cannot do, or has no room for, is refused with its reason; what fills it to the
//! last place is not.

mod common;

use common::analyze;
use common::emulated::compile;
use hotrail::backend::processor::{self, Sizes};

/// No word reaches whether a delay or a pulse is on its way.
#[test]
fn a_block_that_runs_without_power_cannot_be_reset() {
    for (block, can) in [
        ("TON(PT := 500ms)", true),
        ("TOF(PT := 500ms)", false),
        ("TP(PT := 500ms)", false),
        ("TT(MODE := ON, PV := 5, EN := b)", true),
        ("TT(MODE := OFF, PV := 5, EN := b)", false),
        ("TS(MODE := INTERVAL, PV := 5, EN := b)", false),
    ] {
        let text =
            format!("ladder demo tick 100ms input a, b output y rung a t:{block} (y) rung b (R t)");
        let told = compile(&text).map(|_| ()).err().unwrap_or_default();
        assert_eq!(told.contains("a reset coil on a running"), !can, "{block}: {told}");
        assert_eq!(told.is_empty(), can, "{block}: {told}");
    }
}

#[test]
fn what_a_block_cannot_be_given_is_refused_by_its_reason() {
    for (call, told) in [
        ("DRUM(PV := n, EN := a, TAPS := [1])", "a variable preset of a drum"),
        ("DRUM(PV := n + 1, EN := a, TAPS := [1])", "such a preset"),
        ("TON(PT := 24h)", "such a long time of the block TON"),
        ("TON(PT := t)", "a variable time"),
    ] {
        let text = format!(
            "ladder demo tick 1s input a input n : INT input t : TIME output y rung a b:{call} (y)"
        );
        let findings = compile(&text).map(|_| ()).unwrap_err();
        assert!(findings.contains(&format!("cannot do {told}")), "{findings}");
    }
}

/// A rung that is given up before it comes to its block does not hide that.
#[test]
fn a_block_that_reads_itself_is_refused_with_a_word() {
    let text = "ladder seal input a output y
        rung [ a | t.EN ] t:AB_TON(PRE := 5, SIZE := DINT) rung t.EN (y)";
    let told = compile(text).map(|_| ()).unwrap_err();
    assert!(told.contains("cannot do the block AB_TON"), "{told}");
}

/// The host reads and writes it, so the smallest processor for the program has it.
#[test]
fn a_variable_that_no_rung_names_needs_its_place() {
    let (_, image) = compile("ladder spare input a output y var v at 585 rung a (y)").unwrap();
    assert_eq!((image.rom.needs().image_bits, image.needs().image_bits), (8, 256));
}

/// Declarations or rungs, a line for each.
fn lines(count: usize, line: impl Fn(usize) -> String) -> String {
    (0..count).map(|number| line(number) + "\n").collect()
}

#[test]
fn a_full_processor_takes_no_more() {
    let outputs = |count: usize| lines(count, |n| format!("output y{n}"));
    let rungs = |count: usize| lines(count, |n| format!("rung a (y{n})"));
    let blocks = |count: usize, call: &str| {
        outputs(count) + &lines(count, |n| format!("rung a b{n}:{call} (y{n})"))
    };
    type Filled<'a> = (usize, &'a str, &'a dyn Fn(usize) -> String);
    let programs: [Filled; 9] = [
        (64, "timers and counters", &|count| blocks(count, "TON(PT := 1s)")),
        (16, "drums", &|count| blocks(count, "DRUM(PV := 4, EN := a, TAPS := [1])")),
        (32, "shift functions", &|count| {
            format!("var w : WORD\n{}", blocks(count, "SHL(REG := w, DATA := a)"))
        }),
        (256, "inputs", &|count| {
            lines(count - 1, |n| format!("input x{n}")) + &outputs(1) + "rung a x254 (y0)\n"
        }),
        (256, "outputs", &|count| outputs(count) + &rungs(count)),
        (511, "flags", &|count| lines(count, |n| format!("var v{n}\nrung a (v{n})"))),
        // A quarter of 512 registers: for each drum its steps and its taps.
        (128, "registers for presets", &|count| {
            let drum = |n: usize, taps: usize| {
                let taps = vec!["1"; taps].join(", ");
                format!("rung a d{n}:DRUM(PV := 4, EN := a, TAPS := [{taps}])")
            };
            lines(14, |n| drum(n, 8)) + &drum(14, count - 14 * 9 - 1)
        }),
        // Behind the counts of units and drums, but for the last one.
        (2047 - 512 - 64 - 16, "registers for words", &|count| {
            format!(
                "var v : WORD[432] var w : WORD[{}]\n{}rung v[0].1 w[0].1 (y0)\n",
                count - 432,
                outputs(1)
            )
        }),
        (1024, "words", &|count| {
            outputs(1)
                + &lines(510, |_| "rung a (y0)".to_owned())
                + "rung"
                + &" a".repeat(count - 1022)
                + " (y0)"
        }),
    ];
    for (most, what, program) in programs {
        let registers = if what.contains("presets") { 512 } else { 2047 };
        let sizes = Sizes { registers, ..Sizes::default() };
        let messages = |count: usize| {
            let text = format!("ladder full tick 100ms input a\n{}", program(count));
            let program = analyze("test.ladder", &text).unwrap_or_else(|found| panic!("{found}"));
            let findings = processor::compile_for(&program, &[], sizes).err().unwrap_or_default();
            findings.into_iter().map(|found| found.message).collect::<String>()
        };
        assert_eq!(messages(most), "", "{what}");
        let told = format!("needs {} {what}, the ladder processor has {most}", most + 1);
        assert!(messages(most + 1).contains(&told), "{told}: {}", messages(most + 1));
    }
}

/// The last bit of an image is always 1.
#[test]
fn the_constant_of_a_small_image_is_no_flag() {
    let sizes = Sizes { image_bits: 32, ..Sizes::default() };
    let messages = |count: usize| {
        let text = format!(
            "ladder small input a\n{}",
            lines(count, |n| format!("var v{n}\nrung a (v{n})"))
        );
        let program = analyze("test.ladder", &text).unwrap();
        let findings = processor::compile_for(&program, &[], sizes).err().unwrap_or_default();
        findings.into_iter().map(|found| found.message).collect::<String>()
    };
    assert_eq!(messages(15), "");
    assert_eq!(messages(16), "the program needs 16 flags, the ladder processor has 15");
}
