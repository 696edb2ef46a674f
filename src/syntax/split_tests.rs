use super::*;

/// The code of a mistake and the text that it points at.
type Place = (&'static str, String);

/// The words that start the chunks, with their bodies, and the mistakes.
fn cut(text: &str) -> (Vec<(&str, &str)>, Vec<Place>) {
    let split = split(text);
    let mut faults: Vec<_> = split.diagnostics;
    let mut chunks = Vec::new();
    for chunk in split.chunks {
        faults.extend(chunk.fault.map(|fault| fault.diagnostic));
        chunks.push((&text[chunk.word.range()], &text[chunk.body.range()]));
    }
    let describe = |d: Diagnostic| (d.code.id, text[d.primary.span.range()].to_owned());
    (chunks, faults.into_iter().map(describe).collect())
}

fn faults(text: &str) -> Vec<Place> {
    cut(text).1
}

fn fault(id: &'static str, place: &str) -> Vec<Place> {
    vec![(id, place.to_owned())]
}

#[test]
fn reserved_words_start_items() {
    let (chunks, faults) = cut("\u{FEFF}ladder a rung[x](y)test\"rung\"tick_ rungs 2rung\n`rung`");
    let expected = [
        ("", ""),
        ("ladder", " a "),
        ("rung", "[x](y)"),
        ("test", "\"rung\"tick_ rungs 2rung\n`rung`"),
    ];
    assert_eq!(chunks, expected);
    assert_eq!(faults, []);
}

#[test]
fn comments_are_collected_and_hide_everything() {
    let text = "rung a // [ rung\r\n/* ( /* \" */ rung ` */ (y) \"// no /* comment\"";
    let split = split(text);
    assert!(split.chunks.iter().all(|chunk| chunk.fault.is_none()));
    let comments: Vec<_> = split.comments.iter().map(|span| &text[span.range()]).collect();
    assert_eq!(comments, ["// [ rung", "/* ( /* \" */ rung ` */"]);
    assert_eq!(split.chunks[1].comments, 0..2);
}

#[test]
fn brackets_have_to_match_within_their_item() {
    assert_eq!(faults("rung [ a ( b ] )"), fault("E0002", "]"));
    assert_eq!(faults("rung a ] ) (y)"), fault("E0002", "]"));
    assert_eq!(faults("rung [ a { rung [ b ]"), fault("E0002", "{"));
    assert_eq!(faults("rung [ a"), fault("E0002", "["));
    assert_eq!(faults("rung [\nrung ]"), [fault("E0002", "["), fault("E0002", "]")].concat());
}

#[test]
fn what_is_never_closed_is_shown_whole() {
    assert_eq!(faults("rung \"abc  \r\n (y)"), fault("E0002", "\"abc"));
    assert_eq!(faults("rung `abc"), fault("E0002", "`abc"));
    assert_eq!(faults("rung [ /* a /* b */ (y)"), fault("E0002", "/*"));
    assert_eq!(faults("rung /*"), fault("E0002", "/*"));
    assert_eq!(faults("rung /*/"), fault("E0002", "/*"));
}

#[test]
fn nesting_has_a_limit() {
    let nested = |open: &str, close: &str, depth: usize| {
        format!("rung {}{}", open.repeat(depth), close.repeat(depth))
    };
    for (open, close) in [("[", "]"), ("(", ")"), ("{", "}"), ("/*", "*/")] {
        assert_eq!(faults(&nested(open, close, MAX_NESTING)), []);
        assert_eq!(faults(&nested(open, close, MAX_NESTING + 1)), fault("E0003", open));
        assert_eq!(faults(&nested(open, close, 100_000)), fault("E0003", open));
    }
}

#[test]
fn control_characters_are_refused() {
    assert_eq!(faults("rung w\u{1}2\u{2} (y)"), fault("E0001", "\u{1}"));
    assert_eq!(faults("rung \"\u{1}\" // \u{1}\n"), []);
}
