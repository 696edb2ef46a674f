//! What the README shows is what happens.

use std::path::Path;
use std::process::Command;

use hotrail::draw::{self, Drawing, Glyphs};
use hotrail::source::Source;

const README: &str = include_str!("../README.md");

/// The blocks of a language in the README.
fn blocks(language: &str) -> Vec<&'static str> {
    let fence = format!("```{language}\n");
    README.split(&fence).skip(1).map(|rest| rest.split("```").next().unwrap()).collect()
}

#[test]
fn the_main_job_runs_as_printed() {
    let folder = tempfile::tempdir().unwrap();
    let mut ran = 0;
    for line in blocks("sh").iter().flat_map(|block| block.lines()) {
        let Some(arguments) = line.strip_prefix("cargo run --release -- ") else { continue };
        let out = folder.path().join("out").display().to_string();
        let arguments = arguments.split(' ').map(|word| if word == "out" { &out } else { word });
        let status = Command::new(env!("CARGO_BIN_EXE_hotrail")).args(arguments).status().unwrap();
        assert!(status.success(), "{line}");
        ran += 1;
    }
    assert_eq!(ran, 1);
    for file in ["start_stop.v", "start_stop.vhd"] {
        let built = std::fs::read_to_string(folder.path().join("out").join(file)).unwrap();
        let golden = std::fs::read_to_string(format!("examples/start_stop/golden/{file}")).unwrap();
        assert_eq!(built, golden, "{file}");
    }
}

/// The drawing is that of the ladder in the README.
#[test]
fn drawings_are_what_is_drawn() {
    let [ladder] = blocks("ladder")[..] else { panic!("the README shows one ladder") };
    let draw = |name: &str, text: &str, width| {
        Drawing::new(&Source::new(name, text), &draw::Options { width })
    };
    let drawn = draw("start_stop.ladder", ladder, 80).text(Glyphs::Unicode);
    let (_, rungs) = drawn.split_once("\n\n").unwrap();
    assert_eq!(blocks("text"), [rungs]);
    let page = std::fs::read_to_string("docs/drawing.md").unwrap();
    assert!(page.contains(rungs), "docs/drawing.md does not show\n{rungs}");
}

/// The pictures are what the commands beside them make.
#[cfg(unix)]
#[test]
fn pictures_are_what_is_drawn() {
    let page = std::fs::read_to_string("docs/pictures/README.md").unwrap();
    let folder = tempfile::tempdir().unwrap();
    let examples = std::fs::canonicalize("examples").unwrap();
    std::os::unix::fs::symlink(examples, folder.path().join("examples")).unwrap();
    std::fs::create_dir_all(folder.path().join("docs/pictures")).unwrap();
    let stimulus = "docs/pictures/start.csv";
    std::fs::copy(stimulus, folder.path().join(stimulus)).unwrap();
    let mut ran = 0;
    for line in page.lines() {
        let Some(arguments) = line.strip_prefix("hotrail ") else { continue };
        let line = format!("{} {arguments}", env!("CARGO_BIN_EXE_hotrail"));
        let run = Command::new("sh").args(["-c", &line]).current_dir(folder.path()).output();
        assert!(run.unwrap().status.success(), "{line}");
        ran += 1;
    }
    let pictures = |root: &Path| {
        let files = std::fs::read_dir(root.join("docs/pictures")).unwrap();
        let paths = files.map(|file| file.unwrap().path());
        let mut pictures: Vec<(String, String)> = paths
            .filter(|path| path.extension().is_some_and(|extension| extension == "svg"))
            .map(|path| {
                let name = path.file_name().unwrap().to_str().unwrap().to_owned();
                (name, std::fs::read_to_string(path).unwrap())
            })
            .collect();
        pictures.sort();
        pictures
    };
    let (kept, made) = (pictures(Path::new(".")), pictures(folder.path()));
    assert_eq!((ran, kept.len(), made.len()), (4, 4, 4));
    for (kept, made) in kept.iter().zip(&made) {
        assert!(kept == made, "{} is out of date: see docs/pictures/README.md", kept.0);
    }
}

/// The power that docs/drawing.md shows is that of the example.
#[test]
fn the_power_of_a_scan_is_what_is_drawn() {
    let folder = tempfile::tempdir().unwrap();
    let stimulus = folder.path().join("stimulus.csv");
    std::fs::write(&stimulus, "start\n1\n0\n").unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_hotrail"))
        .args(["draw", "examples/start_stop/start_stop.ladder", "--width", "80", "--at", "3200"])
        .arg("--stimulus")
        .arg(&stimulus)
        .output()
        .unwrap();
    let drawn = String::from_utf8(output.stdout).unwrap();
    let (_, rungs) = drawn.split_once("\n\n").unwrap();
    let page = std::fs::read_to_string("docs/drawing.md").unwrap();
    assert!(page.contains(rungs), "docs/drawing.md does not show\n{rungs}");
}

#[test]
fn the_ladder_and_the_verilog_belong_together() {
    let [ladder] = blocks("ladder")[..] else { panic!("the README shows one ladder") };
    let [verilog] = blocks("verilog")[..] else { panic!("the README shows one piece of Verilog") };
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("start_stop.ladder");
    std::fs::write(&file, ladder).unwrap();
    let run = |arguments: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_hotrail"));
        let status = command.args(arguments).arg(&file).current_dir(folder.path()).status();
        assert!(status.unwrap().success(), "{arguments:?}");
    };
    run(&["test"]);
    run(&["build", "-o", "out"]);
    let built = std::fs::read_to_string(folder.path().join("out/start_stop.v")).unwrap();
    assert!(built.contains(verilog), "{built}");
}
