//! `hotrail test`: which tests run, and what they leave.

use crate::GOOD;
use crate::common::folder::Folder;

#[test]
fn tests_can_be_chosen_by_title() {
    let folder = Folder::new();
    let text = "test \"on\"  a := 1  scan  expect y   test \"off\"  scan  expect !y";
    folder.write("good.ladder", &format!("{GOOD} {text}"));
    let run = folder.run(&["test", "good.ladder", "--filter", "of"]);
    assert_eq!(run.code, 0);
    assert!(run.out.contains("test off ... ok"), "{}", run.out);
    assert!(run.out.contains("1 passed; 0 failed; 1 filtered out"), "{}", run.out);
}

#[test]
fn a_filter_that_chooses_no_test_fails() {
    let folder = Folder::new();
    folder.write("good.ladder", &format!("{GOOD} test \"on\"  a := 1  scan  expect y"));
    let run = folder.run(&["test", "good.ladder", "--filter", "off"]);
    assert_eq!(run.code, 1);
    assert!(run.err.contains("no test has a title with `off`"), "{}", run.err);
}
