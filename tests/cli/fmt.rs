//! `hotrail fmt`: files in place, once, and only what is sound.

use std::fs;

use crate::common::folder::Folder;

/// The text of a file, and what `fmt` makes of it.
const LOOSE: &str = "ladder good  input a\noutput y  rung  /a (y) // seen\n";
const LAID_OUT: &str =
    "ladder good\ninput  a\noutput y\n\nrung !a ( y )                   // seen\n";

#[test]
fn fmt_rewrites_files_in_place_and_once() {
    let folder = Folder::new();
    folder.write("loose.ladder", LOOSE);
    folder.write("good.ladder", LAID_OUT);
    let modified = || fs::metadata(folder.path("good.ladder")).unwrap().modified().unwrap();
    let before = modified();
    let run = folder.run(&["fmt", "loose.ladder", "good.ladder"]);
    assert_eq!((run.code, run.out.as_str(), run.err.as_str()), (0, "", ""));
    assert_eq!(folder.read("loose.ladder"), LAID_OUT);
    assert_eq!(modified(), before, "what is formatted already is not written again");
    assert_eq!(fs::read_dir(folder.path("")).unwrap().count(), 2, "no temporary file is left");
    assert_eq!(folder.run(&["fmt", "--check", "loose.ladder", "good.ladder"]).code, 0);
}

#[test]
fn fmt_check_shows_a_difference_and_writes_nothing() {
    let folder = Folder::new();
    folder.write("loose.ladder", LOOSE);
    let run = folder.run(&["fmt", "--check", "loose.ladder"]);
    assert_eq!(run.code, 1);
    for line in ["--- loose.ladder", "-output y  rung  /a (y) // seen", "+output y"] {
        assert!(run.out.lines().any(|found| found == line), "{line}\n{}", run.out);
    }
    assert_eq!(folder.read("loose.ladder"), LOOSE);
}

#[test]
fn fmt_writes_nothing_when_one_of_several_fails() {
    let folder = Folder::new();
    folder.write("loose.ladder", LOOSE);
    folder.write("bad.ladder", "ladder bad  rung [ a");
    let run = folder.run(&["fmt", "loose.ladder", "bad.ladder"]);
    assert_eq!(run.code, 1);
    assert!(run.err.contains("error[E0002]") && run.err.contains("bad.ladder:1:18"), "{}", run.err);
    assert_eq!(folder.read("loose.ladder"), LOOSE);
    assert_eq!(folder.run(&["fmt"]).code, 2);
}

#[test]
fn fmt_passes_standard_input_on() {
    let fmt = |arguments: &[&str]| Folder::new().run_with(arguments, LOOSE);
    let run = fmt(&["fmt", "-"]);
    assert_eq!((run.code, run.out.as_str()), (0, LAID_OUT));
    let run = fmt(&["fmt", "--check", "-"]);
    assert_eq!(run.code, 1);
    assert!(run.out.starts_with("--- <stdin>\n"), "{}", run.out);
}

#[cfg(unix)]
#[test]
fn fmt_keeps_permissions_and_follows_no_link() {
    use std::os::unix::fs::PermissionsExt;
    let folder = Folder::new();
    folder.write("loose.ladder", LOOSE);
    let path = folder.path("loose.ladder");
    let set_mode = |mode| fs::set_permissions(&path, fs::Permissions::from_mode(mode)).unwrap();

    std::os::unix::fs::symlink(&path, folder.path("link.ladder")).unwrap();
    let run = folder.run(&["fmt", "link.ladder"]);
    assert_eq!(run.code, 1);
    assert!(run.err.contains("E0602") && run.err.contains("symbolic link"), "{}", run.err);

    set_mode(0o440);
    let run = folder.run(&["fmt", "loose.ladder"]);
    assert_eq!(run.code, 1);
    assert!(run.err.contains("read-only"), "{}", run.err);
    assert_eq!(folder.read("loose.ladder"), LOOSE);

    set_mode(0o640);
    assert_eq!(folder.run(&["fmt", "loose.ladder"]).code, 0);
    assert_eq!(folder.read("loose.ladder"), LAID_OUT);
    assert_eq!(fs::metadata(&path).unwrap().permissions().mode() & 0o777, 0o640);
}
