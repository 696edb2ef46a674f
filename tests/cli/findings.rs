//! Findings in the forms that people, editors and services read; warnings that are allowed and
//! denied.

use crate::GOOD;
use crate::common::folder::Folder;

#[test]
fn findings_have_three_forms() {
    let folder = Folder::new();
    folder.write("bad.ladder", "ladder bad\noutput y\nrung nobody (y)\n");
    let form = |form| folder.run(&["check", "bad.ladder", "--message-format", form]).err;
    assert!(form("human").contains("--> bad.ladder:3:6"), "{}", form("human"));
    assert_eq!(form("short"), "bad.ladder:3:6: error[E0101]: nothing is named `nobody`\n");
    let json: serde_json::Value = serde_json::from_str(&form("json")).unwrap();
    assert_eq!(json["code"], "E0101");
    assert_eq!(json["primary"]["line"], 3);
}

#[test]
fn a_file_larger_than_allowed_is_one_finding_in_every_form() {
    let folder = Folder::new();
    folder.write("large.ladder", &format!("{GOOD}{}", " ".repeat(1 << 20)));
    let form = |form| {
        let run =
            folder.run(&["check", "large.ladder", "--max-size", "1", "--message-format", form]);
        assert_eq!(run.code, 1);
        run.err
    };
    assert!(form("human").contains("--max-size"), "{}", form("human"));
    assert_eq!(form("short"), "large.ladder: error[E0601]: larger than 1 MiB\n");
    let found: serde_json::Value = serde_json::from_str(&form("json")).unwrap();
    assert_eq!(found["code"], "E0601");
    assert_eq!(found["file"], "large.ladder");
    assert!(found["primary"].is_null());
    assert_eq!(folder.run(&["check", "large.ladder", "--max-size", "2"]).code, 0);
    assert_eq!(folder.run(&["check", "large.ladder", "--max-size", "0"]).code, 2);
}

#[test]
fn very_many_findings_are_cut_for_people_only() {
    let folder = Folder::new();
    let names: String = (0..500).map(|number| format!(" u{number}")).collect();
    folder.write("many.ladder", &format!("ladder many  output y  rung{names} (y)"));
    let human = folder.run(&["check", "many.ladder"]).err;
    assert_eq!(human.matches("error[E0101]").count(), 100);
    assert!(human.ends_with("400 more findings; --message-format short shows all\n"), "{human}");
    let short = folder.run(&["check", "many.ladder", "--message-format", "short"]).err;
    assert_eq!(short.lines().count(), 500);
}

const CARELESS: &str = "ladder careless\ninput a, b\noutput y\nrung a (y)\nrung b (y)\n";

#[test]
fn warnings_are_shown_and_stop_nothing_unless_denied() {
    let folder = Folder::new();
    folder.write("careless.ladder", CARELESS);
    let check = |more: &[&str]| {
        folder.run(&[&["check", "careless.ladder", "--message-format", "short"], more].concat())
    };
    let shown = "careless.ladder:5:8: warning[W0301]: `y` has two coils\n";
    let as_error = shown.replace("warning", "error");
    for (options, code, text) in [
        (&[][..], 0, shown),
        (&["--allow", "double-coil"], 0, ""),
        (&["--allow", "w0302,W0301"], 0, ""),
        (&["--deny", "warnings"], 1, &as_error),
        (&["--deny", "W0301"], 1, &as_error),
        (&["--deny", "unused,read-above"], 0, shown),
        (&["--deny", "warnings", "--allow", "W0301"], 0, ""),
    ] {
        let run = check(options);
        assert_eq!((run.code, run.err.as_str()), (code, text), "{options:?}");
    }
    for (option, words) in [
        ("W0999", "there is no such code"),
        ("E0101", "E0101 is an error in any case"),
        ("dobule-coil", "is double-coil meant?"),
    ] {
        let run = check(&["--allow", option]);
        assert!(run.code == 2 && run.err.contains(words), "{option}: {}", run.err);
    }
}

#[test]
fn build_warns_and_writes_test_keeps_quiet() {
    let folder = Folder::new();
    folder.write("careless.ladder", &format!("{CARELESS}test \"off\"  scan  expect !y\n"));
    let built = folder.run(&["build", "careless.ladder", "-o", "out"]);
    assert!(built.code == 0 && built.err.contains("warning[W0301]"), "{}", built.err);
    assert!(folder.path("out/careless.v").exists());
    let denied = folder.run(&["build", "careless.ladder", "-o", "not", "--deny", "warnings"]);
    assert!(denied.code == 1 && denied.err.contains("error[W0301]"), "{}", denied.err);
    assert!(!folder.path("not").exists());
    let tested = folder.run(&["test", "careless.ladder"]);
    assert_eq!((tested.code, tested.err.as_str()), (0, ""));
}

#[test]
fn sarif_is_one_document_on_standard_output() {
    let folder = Folder::new();
    folder.write("careless.ladder", CARELESS);
    folder.write("failing.ladder", &format!("{GOOD}\ntest \"on\"  scan  expect y"));
    let sarif = |arguments: &[&str]| {
        let run = folder.run(&[arguments, &["--message-format", "sarif"]].concat());
        let log: serde_json::Value = serde_json::from_str(&run.out).unwrap();
        assert_eq!(log["version"], "2.1.0");
        let results = log["runs"][0]["results"].as_array().unwrap().clone();
        let brief = |result: &serde_json::Value| {
            let place = &result["locations"][0]["physicalLocation"];
            let line = place["region"]["startLine"].as_u64().unwrap_or(0);
            let [rule, level, file] =
                [&result["ruleId"], &result["level"], &place["artifactLocation"]["uri"]]
                    .map(|text| text.as_str().unwrap());
            format!("{rule} {level} {file} {line}")
        };
        (run.code, results.iter().map(brief).collect::<Vec<_>>(), run.err)
    };
    let (code, results, err) = sarif(&["check", "careless.ladder", "missing.ladder"]);
    assert_eq!(results, ["W0301 warning careless.ladder 5", "E0601 error missing.ladder 0"]);
    assert_eq!((code, err.as_str()), (1, ""));
    // A document also where nothing is found, so that a service closes what was open.
    folder.write("good.ladder", GOOD);
    assert_eq!(sarif(&["check", "good.ladder"]), (0, vec![], String::new()));
    let (code, results, err) = sarif(&["test", "failing.ladder"]);
    assert_eq!((code, results), (1, vec!["E0502 error failing.ladder 2".to_owned()]));
    assert!(err.contains("test on ... FAILED"), "{err}");
    let (code, results, err) = sarif(&["build", "good.ladder", "-o", "out", "--check"]);
    assert_eq!((code, results), (1, vec![]));
    assert!(err.contains("+module good"), "{err}");
    folder.write("taken", "");
    let (code, results, _) = sarif(&["build", "good.ladder", "-o", "taken"]);
    assert_eq!((code, results), (1, vec!["E0602 error taken 0".to_owned()]));
}

#[test]
fn github_takes_commands_from_standard_output() {
    let folder = Folder::new();
    folder.write("careless.ladder", CARELESS);
    let check = ["check", "careless.ladder", "missing.ladder", "--message-format", "github"];
    let run = folder.run(&check);
    let lines: Vec<&str> = run.out.lines().collect();
    let warning = "::warning file=careless.ladder,line=5,col=8,endColumn=11,title=W0301::`y` has";
    assert!(lines[0].starts_with(warning), "{}", run.out);
    assert!(lines[1].starts_with("::error file=missing.ladder,title=E0601::"), "{}", run.out);
    assert_eq!((run.code, lines.len(), run.err.as_str()), (1, 2, ""));
}
