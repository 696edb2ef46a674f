//! What is written, what is never overwritten, and what is left behind when something fails.

use std::fs;
use std::path::Path;

use crate::common::folder::Folder;
use crate::{GOOD, good};

fn is_empty(folder: &Path) -> bool {
    fs::read_dir(folder).is_ok_and(|mut entries| entries.next().is_none())
}

#[test]
fn nothing_is_written_when_one_of_several_fails() {
    let folder = good();
    folder.write("bad.ladder", "ladder bad  output y  rung a (y)");
    assert_eq!(folder.run(&["build", "good.ladder", "bad.ladder", "-o", "out"]).code, 1);
    assert!(!folder.path("out").exists());
}

#[test]
fn building_again_replaces_our_own_files_only() {
    let folder = good();
    let build = ["build", "good.ladder", "-o", "out", "--emit", "vhdl,verilog"];
    assert_eq!(folder.run(&build).code, 0);
    let first = folder.read("out/good.v");
    assert_eq!(folder.run(&build).code, 0);
    assert_eq!(folder.read("out/good.v"), first);

    folder.write("out/good.v", "module mine; endmodule\n");
    let refused = folder.run(&build);
    assert_eq!(refused.code, 1);
    assert!(refused.err.contains("E0602") && refused.err.contains("--force"), "{}", refused.err);
    assert_eq!(folder.read("out/good.v"), "module mine; endmodule\n");
    assert_eq!(folder.run(&[&build[..], &["--force"]].concat()).code, 0);
    assert_eq!(folder.read("out/good.v"), first);
    let names = fs::read_dir(folder.path("out")).unwrap();
    assert_eq!(names.count(), 2, "no temporary file is left");
}

#[cfg(unix)]
#[test]
fn a_symbolic_link_is_never_followed() {
    let folder = good();
    folder.write("precious", "");
    fs::create_dir(folder.path("out")).unwrap();
    std::os::unix::fs::symlink(folder.path("precious"), folder.path("out/good.v")).unwrap();
    let run = folder.run(&["build", "good.ladder", "-o", "out", "--force"]);
    assert_eq!(run.code, 1);
    assert!(run.err.contains("symbolic link"), "{}", run.err);
    assert_eq!(folder.read("precious"), "");
}

#[test]
fn a_source_is_never_overwritten() {
    let folder = Folder::new();
    folder.write("good.v", GOOD);
    let run = folder.run(&["build", "good.v", "-o", ".", "--force"]);
    assert_eq!(run.code, 1);
    assert!(run.err.contains("is a source"), "{}", run.err);
    assert_eq!(folder.read("good.v"), GOOD);
}

#[test]
fn two_programs_of_one_name_are_refused() {
    let folder = Folder::new();
    folder.write("a.ladder", GOOD);
    folder.write("b.ladder", &GOOD.replace("good", "GOOD"));
    let run = folder.run(&["build", "a.ladder", "b.ladder", "-o", "out"]);
    assert_eq!(run.code, 1);
    assert!(run.err.contains("E0603") && run.err.contains("a.ladder"), "{}", run.err);
    assert!(!folder.path("out").exists());
}

#[test]
fn check_shows_a_difference_and_writes_nothing() {
    let folder = good();
    let check = ["build", "good.ladder", "-o", "out", "--check"];
    let missing = folder.run(&check);
    assert_eq!(missing.code, 1);
    assert!(missing.out.contains("+module good"), "{}", missing.out);
    assert!(!folder.path("out").exists() || is_empty(&folder.path("out")));

    assert_eq!(folder.run(&["build", "good.ladder", "-o", "out"]).code, 0);
    let same = folder.run(&check);
    assert_eq!((same.code, same.out.as_str()), (0, ""));

    folder.write("good.ladder", &GOOD.replace("rung a", "rung !a"));
    let changed = folder.run(&check);
    assert_eq!(changed.code, 1);
    assert!(changed.out.contains("-  wire y_next = a;"), "{}", changed.out);
    assert!(changed.out.contains("+  wire y_next = ~a;"), "{}", changed.out);
}

/// A write that fails halfway leaves the folder as it was.
#[cfg(unix)]
#[test]
fn a_full_disk_leaves_the_old_files() {
    let folder = good();
    assert_eq!(folder.run(&["build", "good.ladder", "-o", "out"]).code, 0);
    let before = folder.read("out/good.v");
    folder.write("good.ladder", &GOOD.replace("rung a", "rung !a"));
    // A file may grow to no size at all; the signal that says so is ignored, as for a full disk.
    let build = "exec hotrail build good.ladder -o out --emit verilog,vhdl";
    let run = folder.shell(&format!("trap '' XFSZ; ulimit -f 0; {build}"));
    assert_eq!(run.code, 1);
    assert!(run.err.contains("E0602"), "{}", run.err);
    assert_eq!(folder.read("out/good.v"), before);
    assert_eq!(fs::read_dir(folder.path("out")).unwrap().count(), 1, "nothing is left behind");
}

#[test]
fn a_folder_that_cannot_be_made_is_one_clear_error() {
    let folder = good();
    let run = folder.run(&["build", "good.ladder", "-o", "good.ladder/out"]);
    assert_eq!(run.code, 1);
    assert!(run.err.starts_with("error[E0602]: good.ladder/out"), "{}", run.err);
}

#[test]
fn what_is_no_folder_is_said_so() {
    let folder = good();
    for (out, words) in [("good.ladder", "is a file, not a folder"), ("-", "name a folder")] {
        let run = folder.run(&["build", "good.ladder", "-o", out]);
        assert_eq!(run.code, 1);
        assert!(run.err.contains(words), "{}", run.err);
    }
    let twice = folder.run(&["build", "good.ladder", "good.ladder", "-o", "out"]);
    assert!(twice.err.contains("is named twice"), "{}", twice.err);
    assert!(folder.run(&["new", ".."]).err.contains("no name for a new folder"));
}

#[test]
fn runs_at_the_same_time_do_not_meet() {
    let folder = good();
    let build = ["build", "good.ladder", "-o", "out", "--emit", "verilog,vhdl,testbench,wrapper"];
    std::thread::scope(|scope| {
        for _ in 0..8 {
            scope.spawn(|| {
                let run = folder.run(&build);
                assert_eq!(run.code, 0, "{}", run.err);
            });
        }
    });
    assert_eq!(folder.run(&[&build[..], &["--check"]].concat()).code, 0);
    assert_eq!(fs::read_dir(folder.path("out")).unwrap().count(), 6);
}
