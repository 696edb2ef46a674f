//! The code keeps to the plan of the house: `ARCHITECTURE.md` says why, this says what.

use std::fs;
use std::path::{Path, PathBuf};

/// Each room of `src` and the rooms that it may import, in the order of the house: a room imports
/// only what stands above it. The functions of `src/lib.rs` are the room `lib`.
const ROOMS: &[(&str, &[&str])] = &[
    ("index", &[]),
    ("source", &[]),
    ("types", &[]),
    ("quantity", &[]),
    ("diagnostic", &["source"]),
    ("syntax", &["source", "diagnostic"]),
    ("circuit", &["index"]),
    ("blocks", &["types", "quantity", "circuit"]),
    ("model", &["index", "source", "types", "syntax", "blocks"]),
    ("check", &["source", "types", "quantity", "diagnostic", "syntax", "blocks", "model"]),
    ("equations", &["index", "types", "blocks", "model"]),
    ("lint", &["index", "source", "types", "diagnostic", "syntax", "blocks", "model", "equations"]),
    ("eval", &["index", "source", "types", "quantity", "diagnostic", "blocks", "model"]),
    ("draw", &["source", "types", "quantity", "syntax", "blocks", "model", "eval"]),
    ("live", &["source", "types", "quantity", "model", "eval", "draw"]),
    ("expand", &["index", "types", "circuit", "blocks", "model", "equations"]),
    (
        "backend",
        &[
            "index",
            "source",
            "types",
            "quantity",
            "diagnostic",
            "circuit",
            "model",
            "equations",
            "eval",
            "expand",
            "draw",
        ],
    ),
    ("report", &["index", "types", "quantity", "syntax", "blocks", "model", "equations"]),
    ("files", &["source", "diagnostic", "backend"]),
    ("lib", &["source", "diagnostic", "syntax", "model", "check", "lint", "expand"]),
    ("build_script", &["source", "diagnostic", "backend", "files", "lib"]),
    (
        "cli",
        &[
            "source",
            "types",
            "quantity",
            "diagnostic",
            "syntax",
            "blocks",
            "model",
            "check",
            "equations",
            "lint",
            "eval",
            "draw",
            "live",
            "backend",
            "report",
            "files",
            "lib",
        ],
    ),
    ("main", &["cli"]),
];

/// Crates, and what belongs to the outer world, with the only places that may name them.
const FENCED: &[(&str, &[&str])] = &[
    ("pest::", &["syntax/parse/grammar.rs"]),
    ("pest_derive::", &["syntax/parse/grammar.rs"]),
    ("askama::", &["backend/", "draw/svg.rs", "draw/timing/"]),
    ("annotate_snippets::", &["diagnostic/"]),
    ("serde::", &["diagnostic/", "report/"]),
    ("serde_json::", &["diagnostic/", "eval/stimulus/", "report/", "cli/"]),
    ("strsim::", &["diagnostic/"]),
    ("clap::", &["cli/"]),
    ("clap_complete::", &["cli/"]),
    ("anyhow::", &["cli/"]),
    ("similar::", &["cli/"]),
    ("petgraph::", &["equations/dataflow.rs"]),
    ("unicode_width::", &["draw/"]),
    ("csv::", &["eval/stimulus/", "cli/"]),
    ("vcd::", &["backend/"]),
    ("indicatif::", &["cli/"]),
    ("ratatui_core::", &["live/", "cli/run.rs"]),
    ("ratatui_crossterm::", &["cli/run.rs"]),
    ("tempfile::", &["files.rs", "cli/"]),
    ("std::fs", &["files.rs", "cli/"]),
    ("std::io", &["files.rs", "cli/"]),
    ("std::env", &["cli/", "build_script.rs"]),
    ("std::net", &[]),
    ("std::process", &["cli/", "main.rs"]),
    ("std::time", &["cli/run.rs"]),
    ("println!", &["cli/", "build_script.rs"]),
];

struct File {
    /// Path below `src`, with `/`.
    path: String,
    /// Its lines without comments.
    code: Vec<String>,
}

impl File {
    fn room(&self) -> &str {
        let first = self.path.split('/').next().unwrap();
        first.strip_suffix(".rs").unwrap_or(first)
    }

    /// How many modules it lies in, itself among them.
    fn depth(&self) -> usize {
        let parts = self.path.split('/').count();
        if self.path.ends_with("/mod.rs") { parts - 1 } else { parts }
    }
}

fn files() -> Vec<File> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut folders = vec![root.clone()];
    let mut files = Vec::new();
    while let Some(folder) = folders.pop() {
        let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
        let (inner, mut sources): (Vec<PathBuf>, Vec<_>) = entries.partition(|path| path.is_dir());
        folders.extend(inner);
        sources.retain(|path| path.extension().is_some_and(|ending| ending == "rs"));
        files.extend(sources.iter().map(|path| {
            let below = path.strip_prefix(&root).unwrap().components();
            let parts: Vec<_> = below.map(|part| part.as_os_str().to_string_lossy()).collect();
            let text = fs::read_to_string(path).unwrap();
            let code = text.lines().filter(|line| !line.trim_start().starts_with("//"));
            File { path: parts.join("/"), code: code.map(str::to_owned).collect() }
        }));
    }
    assert!(files.len() > 50, "only {} files", files.len());
    files
}

/// What follows each `word::` in a line, where `word` is not the end of a longer word.
fn paths<'l>(line: &'l str, word: &str) -> impl Iterator<Item = &'l str> {
    let start = format!("{word}::");
    line.match_indices(&start).map(|(at, _)| at).collect::<Vec<_>>().into_iter().filter_map({
        let length = start.len();
        move |at| {
            let before = line[..at].chars().next_back();
            let whole = before.is_none_or(|c| c != '_' && c != ':' && !c.is_alphanumeric());
            whole.then_some(&line[at + length..])
        }
    })
}

fn first_word(text: &str) -> &str {
    text.split(|c: char| c != '_' && !c.is_alphanumeric()).next().unwrap()
}

/// The room that a name at the root of the crate belongs to.
fn room_of(name: &str) -> &str {
    match name {
        "analyze" | "analyze_with" => "lib",
        _ => name,
    }
}

/// The rooms that a file names, with the line.
fn imports(file: &File) -> Vec<(String, String)> {
    let mut found = Vec::new();
    for line in &file.code {
        // The command line is a crate of its own and sees the library as any other user does.
        let roots: &[&str] =
            if file.room() == "cli" { &["hotrail"] } else { &["crate", "hotrail"] };
        for rest in roots.iter().flat_map(|root| paths(line, root)) {
            assert!(!rest.starts_with('{'), "{}: one `use` for each room: {line}", file.path);
            found.push((room_of(first_word(rest)).to_owned(), line.clone()));
        }
    }
    found
}

#[test]
fn rooms_import_only_what_they_may() {
    for file in files().iter().filter(|file| file.room() != "lib") {
        let (_, allowed) = ROOMS
            .iter()
            .find(|(room, _)| *room == file.room())
            .unwrap_or_else(|| panic!("{} is in no room of the table", file.path));
        for (room, line) in imports(file) {
            let own = room == file.room();
            assert!(own || allowed.contains(&room.as_str()), "{}: {line}", file.path);
        }
    }
}

#[test]
fn the_order_runs_one_way() {
    let place = |room: &str| ROOMS.iter().position(|(name, _)| *name == room);
    for (room, allowed) in ROOMS {
        for other in *allowed {
            let above = place(other).unwrap_or_else(|| panic!("no room {other}"));
            assert!(above < place(room).unwrap(), "{room} imports {other}");
        }
    }
}

/// `ARCHITECTURE.md` shows the same table.
#[test]
fn the_document_shows_these_rooms() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("ARCHITECTURE.md");
    let text = fs::read_to_string(path).unwrap();
    let is_room = |word: &str| ROOMS.iter().any(|(room, _)| *room == word);
    for (room, allowed) in ROOMS.iter().filter(|(room, _)| !["lib", "main"].contains(room)) {
        let row = text.lines().find(|line| line.starts_with(&format!("| `{room}` | ")));
        let row = row.unwrap_or_else(|| panic!("no row for {room}"));
        let imports = row.trim_end_matches([' ', '|']).rsplit(" | ").next().unwrap();
        let shown = match row.ends_with("| |") {
            true => Vec::new(),
            false => imports.split(|c: char| !c.is_alphanumeric() && c != '_').collect(),
        };
        let mut shown: Vec<&str> = shown.into_iter().filter(|word| is_room(word)).collect();
        let mut allowed = allowed.to_vec();
        shown.sort_unstable();
        allowed.sort_unstable();
        assert_eq!(shown, allowed, "{room}");
    }
}

#[test]
fn nobody_leaves_a_room_by_the_back_door() {
    for file in files() {
        for line in &file.code {
            let chain = line.matches("super::").count();
            assert!(chain < 2 || chain < file.depth(), "{}: {line}", file.path);
        }
    }
}

#[test]
fn the_model_takes_one_type_of_the_tree() {
    for file in files().iter().filter(|file| file.room() == "model") {
        for line in file.code.iter().filter(|line| line.contains("syntax::")) {
            assert_eq!(line, "pub use crate::syntax::ast::Edge;", "{}", file.path);
        }
    }
}

/// The evaluator judges circuits, so it uses nothing that they are made with: of a block it takes
/// the plain step alone.
#[test]
fn the_evaluator_shares_nothing_with_what_it_judges() {
    let allowed = ["use crate::blocks::Step;"];
    for file in files().iter().filter(|file| file.room() == "eval") {
        for line in file.code.iter().filter(|line| line.contains("blocks::")) {
            assert!(allowed.contains(&line.as_str()), "{}: {line}", file.path);
        }
    }
}

#[test]
fn crates_and_the_outer_world_are_named_in_their_places_only() {
    for (name, places) in FENCED {
        let mut hits = 0;
        for file in files().iter().filter(|file| !file.path.ends_with("_tests.rs")) {
            let (word, is_path) = match name.strip_suffix("::") {
                Some(word) => (word, true),
                None => (*name, false),
            };
            let uses = |line: &String| match is_path {
                true => paths(line, word).next().is_some(),
                false => line.match_indices(word).any(|(at, _)| {
                    !line[..at].ends_with(|c: char| c == '_' || c.is_alphanumeric())
                }),
            };
            for line in file.code.iter().filter(|line| uses(line)) {
                hits += 1;
                let here = places.iter().any(|place| file.path.starts_with(place));
                assert!(here, "{name} in {}: {line}", file.path);
            }
        }
        assert!(places.is_empty() || hits > 0, "nobody names {name} any more");
    }
}

/// A build script takes the library without the command line.
#[test]
fn the_library_does_without_the_command_line() {
    let lib = files().into_iter().find(|file| file.path == "lib.rs").unwrap();
    assert!(!lib.code.iter().any(|line| line.contains("mod cli")));
    let manifest = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("Cargo.toml"));
    let manifest = manifest.unwrap();
    for name in [
        "anyhow",
        "clap",
        "csv",
        "indicatif",
        "ratatui-core",
        "ratatui-crossterm",
        "similar",
        "vcd",
    ] {
        let line = manifest.lines().find(|line| line.starts_with(&format!("{name} = ")));
        assert!(line.is_some_and(|line| line.contains("optional = true")), "{name}");
    }
}
