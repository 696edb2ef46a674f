//! Damaged programs, images and stimuli, and random words: whatever a file holds, reading it ends
//! with a result or with findings. `PROPTEST_CASES` says how many of each; `docs/trust.md` tells
//! of the long run.

mod common;

use std::fs;
use std::path::{Path, PathBuf};

use common::{emulated, relay, targets};
use hotrail::backend::processor::{Form, Parameters, Part};
use proptest::prelude::*;
use proptest::sample::Index;

/// The bytes of all files of some folders with an ending.
fn corpus(folders: &[&str], ending: &str) -> Vec<Vec<u8>> {
    fn files(path: &Path, found: &mut Vec<PathBuf>) {
        for entry in fs::read_dir(path).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() { files(&path, found) } else { found.push(path) }
        }
    }
    let mut found = Vec::new();
    folders.iter().for_each(|folder| files(Path::new(folder), &mut found));
    found.retain(|path| path.extension().is_some_and(|extension| extension == ending));
    found.sort();
    assert!(!found.is_empty());
    found.iter().map(|path| fs::read(path).unwrap()).collect()
}

/// Images of random programs, in every form.
fn images() -> Vec<Vec<u8>> {
    let images = (0..20).filter_map(|seed| emulated::compile(&relay::program(seed)).ok());
    let memories = images.flat_map(|(_, image)| {
        let comments = [Parameters::of(&image.rom).to_string()];
        Part::ALL.map(|part| Form::ALL.map(|form| image.rom.memory(part).write(form, &comments)))
    });
    memories.flatten().collect()
}

/// A damage to a text.
#[derive(Clone, Debug)]
enum Damage {
    /// A part goes.
    Cut(Index, usize),
    /// A part stands there once more, somewhere.
    Copy(Index, usize, Index),
    /// A part of another file.
    Graft(Index, Index, usize, Index),
    /// Another byte.
    Byte(Index, u8),
    /// One of [`WORDS`].
    Word(Index, &'static str),
}

/// Words of the language, and what readers may stumble over.
#[rustfmt::skip]
const WORDS: &[&str] = &[
    "[", "]", "(", ")", "{", "}", "|", "`", "\"", "/*", "*/", "//", "not", "rung", "\n", "\r", "\0",
    "\u{feff}", "\u{202e}", "é", "99999999999999999999", "-1", "16#FFFFFFFF", "1s", "TRUE", ".",
    ",", ":=", "{ ", "rise(", "net {", "left -> right :", "repeat 3 {", "w[", "].5", "/ 0", "MOD 0",
    "ladder", "demo", "input", "output", "var", "const", "tick", "clock", "1ms", "a", "b", "y", "n",
    ": INT", ": TIME", ":= 5", ":= 1s", ":= a", "test", "\"t\"", "(y)", "(S y)", "{ n := n + 1 }",
    "{ n > 3 }", "t:TON(PT := 1s)", "c:CTU(R := a, PV := 3)", "t.Q", "c.CV", "(R t)", "rise(a)",
    "rising", "first_scan", "!", "/", "expect", "scan", "scan 3", "wait 1s", "pulse a",
    "repeat 2 {", "reset", "a := 1", "net", "->", "<->", ":", "\u{1}", "\u{2}", "``", "-", "AND",
    "NOT", "=", "n.5", "n[1]", "w", "TON", "rise", "S", "5", "0", "5s", "+", "<", "..", "`x`",
    "repeat", "var w : INT[2]", "at",
];

fn damage() -> impl Strategy<Value = Damage> {
    let place = any::<Index>;
    prop_oneof![
        (place(), 0..60_usize).prop_map(|(at, length)| Damage::Cut(at, length)),
        (place(), 0..60_usize, place()).prop_map(|(at, length, to)| Damage::Copy(at, length, to)),
        (place(), place(), 0..80_usize, place())
            .prop_map(|(file, at, length, to)| Damage::Graft(file, at, length, to)),
        (place(), any::<u8>()).prop_map(|(at, byte)| Damage::Byte(at, byte)),
        (place(), prop::sample::select(WORDS)).prop_map(|(at, word)| Damage::Word(at, word)),
    ]
}

/// A file of a corpus after some damages.
fn damaged(corpus: Vec<Vec<u8>>) -> impl Strategy<Value = Vec<u8>> {
    let damages = prop::collection::vec(damage(), 0..5);
    (any::<Index>(), damages).prop_map(move |(file, damages)| {
        let mut bytes = file.get(&corpus).clone();
        for damage in damages {
            apply(&damage, &corpus, &mut bytes);
        }
        bytes
    })
}

fn apply(damage: &Damage, corpus: &[Vec<u8>], bytes: &mut Vec<u8>) {
    let part = |bytes: &[u8], at: &Index, length: usize| {
        let start = at.index(bytes.len() + 1);
        start..bytes.len().min(start + length)
    };
    let insert = |bytes: &mut Vec<u8>, at: &Index, new: &[u8]| {
        let at = at.index(bytes.len() + 1);
        bytes.splice(at..at, new.iter().copied());
    };
    match damage {
        Damage::Cut(at, length) => drop(bytes.drain(part(bytes, at, *length))),
        Damage::Copy(at, length, to) => {
            let copied = bytes[part(bytes, at, *length)].to_vec();
            insert(bytes, to, &copied);
        }
        Damage::Graft(file, at, length, to) => {
            let other = file.get(corpus);
            insert(bytes, to, &other[part(other, at, *length)]);
        }
        Damage::Byte(at, byte) if !bytes.is_empty() => {
            let at = at.index(bytes.len());
            bytes[at] = *byte;
        }
        Damage::Byte(..) => {}
        Damage::Word(at, word) => insert(bytes, at, word.as_bytes()),
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_text_is_read_to_its_end(
        bytes in damaged(corpus(&["examples", "tests/errors", "tests/lockstep"], "ladder"))
    ) {
        targets::program(&String::from_utf8_lossy(&bytes));
    }

    #[test]
    fn any_image_is_read_to_its_end(
        bytes in damaged(images()),
        noise in prop::collection::vec(any::<u8>(), 0..64),
    ) {
        targets::image(&bytes);
        targets::image(&noise);
    }

    #[test]
    fn any_stimulus_is_read_to_its_end(
        bytes in damaged(corpus(&["tests/stimulus"], "csv")),
        lines in damaged(corpus(&["tests/stimulus"], "jsonl")),
    ) {
        targets::stimulus(&String::from_utf8_lossy(&bytes));
        targets::stimulus(&String::from_utf8_lossy(&lines));
    }
}

proptest! {
    // Most of these are read in no time.
    #![proptest_config(ProptestConfig {
        failure_persistence: None,
        cases: ProptestConfig::default().cases * 10,
        ..ProptestConfig::default()
    })]

    #[test]
    fn any_words_are_read_to_their_end(
        words in prop::collection::vec((prop::sample::select(WORDS), any::<bool>()), 0..60),
        noise in prop::collection::vec(any::<u8>(), 0..200),
    ) {
        let spaced = words.iter().map(|(word, blank)| word.to_string() + if *blank { " " } else { "" });
        let text: String = spaced.collect();
        targets::program(&text);
        targets::program(&format!("ladder demo input a output y var n : DINT {text}"));
        targets::program(&String::from_utf8_lossy(&noise));
    }
}
