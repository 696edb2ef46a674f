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

#[test]
fn a_failure_shows_values_as_the_expectation_writes_them() {
    let folder = Folder::new();
    let text = "
        input w : WORD  input n : INT  output y : WORD[2]  output z  var long : TIME
        rung { y[1] := w OR 16#8000 } { long := -90s }
        rung first_scan late:TON(PT := 5s) ( z )
        test \"word\"  w := 16#2BCD  scan  expect { y[1] = 16#ABCE }
        test \"bits\"  w := 5  scan  expect [ { w = 2#11 } | { n > 8#17 } | { n = 3 } ]
        test \"decimal\"  w := 5  scan  expect { w = 3 AND y[1] = 16#8005 }
        test \"member\"  wait 2ms  expect { 1s = late.ET }
        test \"time\"  scan  expect { long >= 0s }
    ";
    folder.write("shown.ladder", &format!("ladder shown {text}"));
    let run = folder.run(&["test", "shown.ladder"]);
    assert_eq!(run.code, 1);
    for shown in [
        "does not conduct: y[1] is 16#ABCD\n",
        "does not conduct: w is 2#101, n is 8#0\n",
        "does not conduct: w is 5, y[1] is 16#8005\n",
        "does not conduct: late.ET is 0s\n",
        "does not conduct: long is -1m30s\n",
    ] {
        assert!(run.err.contains(shown), "{shown}{}", run.err);
    }
}

#[test]
fn a_failure_inside_of_repeat_tells_the_turn() {
    let folder = Folder::new();
    let text = "
        input a  var n : INT  rung rise(a) { n := n + 1 }
        test \"one\"  repeat 4 { pulse a  expect { n < 3 } }
        test \"two\"  repeat 4 { pulse a  repeat 5 { scan  expect !a { n < 2 } } }
        test \"none\"  repeat 2 { pulse a }  expect { n = 3 }
    ";
    folder.write("turns.ladder", &format!("ladder turns {text}"));
    let run = folder.run(&["test", "turns.ladder"]);
    assert_eq!(run.code, 1);
    for told in [
        "the test \"one\" failed on evaluator, in turn 3 of 4, after 6 scans\n",
        "the test \"two\" failed on evaluator, in turn 2 of 4, in turn 1 of 5, after 10 scans\n",
        "the test \"none\" failed on evaluator\n",
    ] {
        assert!(run.err.contains(told), "{told}{}", run.err);
    }
}
