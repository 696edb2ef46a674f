//! `hotrail draw`: text and pictures, on standard output and in files.

use crate::GOOD;
use crate::common::folder::Folder;

#[test]
fn a_ladder_is_drawn_on_standard_output() {
    let folder = Folder::new();
    folder.write("a.ladder", "ladder one  input a  output y, z  rung \"lamp\" a (y)  rung !a (z)");
    let all = folder.run(&["draw", "a.ladder"]);
    assert_eq!((all.code, all.err.as_str()), (0, ""));
    assert!(all.out.contains("┤ ├") && all.out.contains("┤/├"), "{}", all.out);
    let first = folder.run(&["draw", "a.ladder", "--rung", "lam", "--ascii"]);
    assert!(first.out.contains("| |") && !first.out.contains("|/|"), "{}", first.out);
    let second = folder.run(&["draw", "a.ladder", "--rung", "2"]);
    assert!(!second.out.contains("┤ ├") && second.out.contains("┤/├"), "{}", second.out);
    let none = folder.run(&["draw", "a.ladder", "--rung", "pump"]);
    assert_eq!((none.code, none.out.as_str()), (1, ""));
    assert!(none.err.contains("no rung has the number or the title `pump`"), "{}", none.err);
    assert_eq!(folder.run(&["draw", "a.ladder", "--width", "20"]).code, 2);
    folder.write("bad.ladder", "ladder bad  rung q (y)");
    let bad = folder.run(&["draw", "a.ladder", "bad.ladder"]);
    assert_eq!((bad.code, bad.out.as_str()), (1, ""));
}

#[test]
fn pictures_go_to_a_folder_or_to_standard_output() {
    let folder = Folder::new();
    folder.write("a.ladder", GOOD);
    folder.write("b.ladder", &GOOD.replace("good", "other"));
    let draw = ["draw", "--format", "svg", "a.ladder"];
    let shown = folder.run(&draw).out;
    assert!(shown.starts_with("<svg ") && shown.ends_with("</svg>\n"), "{shown}");
    let into = |more: &[&str]| folder.run(&[&draw[..], &["b.ladder"], more].concat());
    assert_eq!(into(&[]).code, 1);
    assert_eq!(into(&["-o", "out"]).code, 0);
    assert_eq!(folder.read("out/good.svg"), shown);
    // What `build` writes is the same, and what is ours is replaced.
    let build = ["build", "a.ladder", "-o", "out", "--emit", "svg"];
    assert_eq!(folder.run(&build).code, 0);
    assert_eq!(folder.read("out/good.svg"), shown);
    folder.write("out/other.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\">mine</svg>");
    let refused = into(&["-o", "out"]);
    assert_eq!(refused.code, 1);
    assert!(refused.err.contains("was not made by hotrail"), "{}", refused.err);
    assert_eq!(into(&["-o", "out", "--force"]).code, 0);
    assert_eq!(folder.run(&["draw", "a.ladder", "-o", "out"]).code, 1);
    let check = folder.run(&["build", "a.ladder", "-o", "out", "--emit", "svg", "--check"]);
    assert_eq!((check.code, check.out.as_str()), (0, ""));
}
