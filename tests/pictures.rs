//! SVG pictures as a browser shows them: no text leaves the picture, meets another text or has a
//! line going through it; they are not blank; they are dark where the reader wants it so.

mod common;

use std::process::Command;

use common::{examples, require_tool};
use fastrand::Rng;
use hotrail::draw::{Drawing, Options, Timing};
use hotrail::eval::{Evaluator, Flow, Row, Why};
use hotrail::model::{Role, VariableId};
use hotrail::source::Source;

const LOOK: &str = include_str!("pictures/look.html");
const EVERY_SHAPE: &str = include_str!("draw/every_shape.ladder");

/// A picture with every fault that is looked for.
const FAULTY: &str = r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 200 80" width="200" height="80">
<title>faulty</title><g><path stroke="black" d="M0 20H100"/>
<text x="10" y="25">crossed</text><text x="10" y="60">first</text><text x="15" y="60">second</text>
<text x="180" y="60">too far right</text></g></svg>"#;

fn svg(name: &str, text: &str) -> String {
    let source = Source::new(name, text);
    Drawing::new(&source, &Options::default()).svg()
}

/// The ladder with the power of a scan, the timing diagram of everything that has a name, and the
/// rungs that decided the last output, in a run on random inputs that change now and then.
fn of_a_run(name: &str, text: &str, seed: u64) -> [String; 3] {
    let source = Source::new(name, text);
    let program = hotrail::analyze(&source).0.unwrap();
    let named: Vec<VariableId> = program.named_variables().map(|(id, _)| id).collect();
    let mut random = Rng::with_seed(seed);
    let mut evaluator = Evaluator::new(&program);
    let mut timing = Timing::new(&program, &named);
    let mut flow = Flow::at_reset(&program);
    let mut rows: Vec<(bool, Vec<(VariableId, i64)>)> = Vec::new();
    for _ in 0..8 {
        let mut drives = Vec::new();
        for (input, variable) in program.with_role(Role::Input) {
            let (low, high) = variable.ty.range();
            drives.push((input, random.i64(low..=high)));
        }
        drives.iter().for_each(|&(input, value)| evaluator.drive(input, value));
        for _ in 0..random.usize(1..30) {
            let tick = random.u8(0..9) > 0;
            flow = evaluator.scan_seen(tick);
            timing.scan(tick, |variable| evaluator.value(variable));
            rows.push((tick, drives.clone()));
        }
    }
    let all = rows.iter().map(|(tick, drives)| Row { tick: *tick, drives });
    let why = Why::new(&program, &source, all);
    let output = program.with_role(Role::Output).last().unwrap().0;
    let shown = why.shown(&why.explain(output, rows.len() - 1, 12));
    let mut decided =
        Drawing::with_flow(&source, &Options::default(), &flow).of_explanation(&shown);
    decided.say("why the last output is what it is");
    let drawing = Drawing::with_flow(&source, &Options::default(), &flow);
    let moment = Some("power in some scan".to_owned());
    [Drawing { moment, ..drawing }.svg(), timing.svg(), decided.svg()]
}

/// What the page says of some pictures.
fn look(pictures: &str, scheme: &str) -> Vec<String> {
    let folder = tempfile::tempdir().unwrap();
    let page = folder.path().join("page.html");
    std::fs::write(&page, LOOK.replace("PICTURES", pictures)).unwrap();
    let output = Command::new("chromium")
        .args(["--headless", "--no-sandbox", "--disable-gpu", "--virtual-time-budget=20000"])
        .args([scheme, "--dump-dom"])
        .arg(format!("--user-data-dir={}", folder.path().join("profile").display()))
        .arg(format!("file://{}", page.display()))
        .output()
        .expect("chromium can be run");
    let text = String::from_utf8(output.stdout).unwrap();
    let result = text.split("<pre id=\"result\">").nth(1).unwrap_or_else(|| panic!("{text}"));
    let result = result.split("</pre>").next().unwrap();
    result.lines().filter(|line| !line.is_empty()).map(str::to_owned).collect()
}

const LIGHT: &str = "--blink-settings=preferredColorScheme=1";
const DARK: &str = "--blink-settings=preferredColorScheme=0";

#[test]
fn pictures_look_right_in_a_browser() {
    if !require_tool("chromium") {
        return;
    }
    let every_shape = svg("every_shape.ladder", EVERY_SHAPE);
    let mut pictures = every_shape.clone();
    let of_every_shape = of_a_run("every_shape.ladder", EVERY_SHAPE, 0).concat();
    let dark = every_shape + &of_every_shape;
    pictures += &of_every_shape;
    for (example, seed) in examples().iter().zip(1..) {
        let text = std::fs::read_to_string(&example.ladder).unwrap();
        pictures += &svg(&example.name(), &text);
        // Explanations look like each other: that of some examples will do.
        let of_a_run = of_a_run(&example.name(), &text, seed);
        let shown = if seed % 4 == 0 { 3 } else { 2 };
        pictures += &of_a_run[..shown].concat();
    }
    let count = pictures.matches("<svg ").count();
    assert!(count > 3 * examples().len(), "{count}");
    for (scheme, paper, pictures, count) in
        [(LIGHT, "rgb(255, 255, 255)", pictures, count), (DARK, "rgb(20, 24, 29)", dark, 4)]
    {
        let lines = look(&pictures, scheme);
        assert_eq!(lines.len(), count, "{lines:#?}");
        for line in lines {
            let seen = line.strip_prefix("seen ").unwrap_or_else(|| panic!("{line}"));
            let (_, seen) = seen.split_once(": ").unwrap();
            let (texts, seen) = seen.split_once(" texts, ").unwrap();
            let (ink, on) = seen.split_once(" % ink on ").unwrap();
            assert!(texts.parse::<u32>().unwrap() > 4, "{line}");
            assert!((1..30).contains(&ink.parse::<u32>().unwrap()), "{line}");
            assert_eq!(on, paper, "{line}");
        }
    }
}

#[test]
fn faults_of_a_picture_are_found() {
    if !require_tool("chromium") {
        return;
    }
    let lines = look(FAULTY, LIGHT);
    for fault in [
        "faulty: a line goes through \"crossed\"",
        "faulty: \"first\" and \"second\" meet",
        "faulty: \"too far right\" leaves the picture",
    ] {
        assert!(lines.iter().any(|line| line == fault), "{fault}: {lines:#?}");
    }
    assert_eq!(lines.len(), 4, "{lines:#?}");
}
