//! `hotrail why`: the cause of a state, from the coil back to the inputs.

mod common;

use common::folder::Folder;
use common::{amount, generate};
use fastrand::Rng;
use hotrail::eval::{Cause, Evaluator, Looked, Reason, Row, ShownRung, Subject, Why};
use hotrail::model::{Role, VariableId};
use hotrail::source::Source;

/// What `why` answers for the last scan of a stimulus.
fn answer(program: &str, stimulus: &str, arguments: &[&str]) -> String {
    let folder = Folder::new();
    folder.write("p.ladder", program);
    folder.write("s.csv", stimulus);
    let run = folder.run(&[&["why", "p.ladder", "s.csv"], arguments].concat());
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    run.out
}

const MOTOR: &str = "ladder start_stop
input  start, stop
output motor, lamp
rung \"seal-in\"
    [ start | motor ] !stop ( motor )
rung motor delay:TON(PT := 3ms) ( lamp )
";

const PRESSED: &str = "start,stop\n0,0\n1,\n0,\n,\n,\n,\n,1\n";

#[test]
fn a_timer_leads_back_to_the_contact_that_started_it() {
    insta::assert_snapshot!(answer(MOTOR, PRESSED, &["lamp", "--at", "5"]), @r#"
    lamp is on in scan 5, since scan 4: ( lamp ), rung 2, line 6
      delay.Q is on in scan 5, since scan 4: delay:TON has power since scan 1, PT = 3ms, ET = 3ms, rung 2, line 6
        motor went on in scan 1: ( motor ), rung 1 "seal-in", line 5
          start went on in scan 1: an input
          stop is off in scan 1, since reset: an input
    "#);
}

#[test]
fn a_timer_that_has_not_run_shows_how_far_it_is() {
    insta::assert_snapshot!(answer(MOTOR, PRESSED, &["lamp", "--at", "2", "--depth", "2"]), @r#"
    lamp is off in scan 2, since reset: ( lamp ), rung 2, line 6
      delay.Q is off in scan 2, since reset: delay:TON has power since scan 1, PT = 3ms, ET = 1ms, rung 2, line 6
        motor went on in scan 1: ...
    "#);
}

#[test]
fn only_what_blocks_is_named() {
    insta::assert_snapshot!(answer(MOTOR, PRESSED, &["motor"]), @r#"
    motor went off in scan 6: ( motor ), rung 1 "seal-in", line 5
      stop went on in scan 6: an input
    "#);
    insta::assert_snapshot!(answer(MOTOR, PRESSED, &["motor", "--at", "0"]), @r#"
    motor is off in scan 0, since reset: ( motor ), rung 1 "seal-in", line 5
      start is off in scan 0, since reset: an input
      motor is off in scan 0, since reset
    "#);
}

#[test]
fn a_latch_names_who_set_it_and_who_does_not() {
    let program = "ladder latch  input a, b, clear  output y, z
        rung a b (S y)
        rung clear (R y)
        rung y rising not ( z )";
    let stimulus = "a,b,clear\n1,1,0\n0,0,0\n0,0,1\n0,1,0\n";
    insta::assert_snapshot!(answer(program, stimulus, &["y", "--at", "1"]), @"
    y is on in scan 1, since scan 0: (S y), rung 1, line 2
      a went on in scan 0: an input
      b went on in scan 0: an input
    ");
    insta::assert_snapshot!(answer(program, stimulus, &["y"]), @"
    y is off in scan 3, since scan 2: kept, nothing wrote it
      y went off in scan 2: (R y), rung 2, line 3
        clear went on in scan 2: an input
      (S y) has no power in scan 3: rung 1, line 2
        a is off in scan 3, since scan 1: an input
    ");
    insta::assert_snapshot!(answer(program, stimulus, &["z", "--at", "1"]), @"
    z went on in scan 1: ( z ), rung 3, line 4
      rising does not conduct in scan 1: rung 3, line 4
        y went on in scan 0: (S y), rung 1, line 2
          a went on in scan 0: an input
          b went on in scan 0: an input
    ");
}

#[test]
fn numbers_lead_back_to_what_they_were_made_of() {
    let program = "ladder sums  input box  input weight : INT  var total : INT  output heavy
        rung rise(box) { total := total + weight }
        rung box n:CTU(PV := 2)
        rung n.Q { total > 10 } ( heavy )";
    let stimulus = "box,weight\n1,6\n0,\n1,7\n0,1\n";
    insta::assert_snapshot!(answer(program, stimulus, &["heavy"]), @"
    heavy is on in scan 3, since scan 2: ( heavy ), rung 3, line 4
      n.Q is on in scan 3, since scan 2: n:CTU has no power since scan 3, R = off, PV = 2, CV = 2, rung 2, line 3
        box went on in scan 2: an input
      { total > 10 } conducts in scan 3: rung 3, line 4
        total became 13 in scan 2: { total := total + weight }, rung 1, line 2
          rise(box) conducts in scan 2: rung 1, line 2
            box went on in scan 2: an input
          total became 6 in scan 0: ...
          weight became 7 in scan 2: an input
    ");
}

#[test]
fn a_network_names_the_path_or_the_gaps() {
    let program = "ladder bridge  input a, b, c, d, e  output y
        rung net { left -> n : a  left -> m : b  n <-> m : c  n -> right : d  m -> right : e } (y)";
    let stimulus = "a,b,c,d,e\n1,0,1,0,1\n,,0,,\n";
    insta::assert_snapshot!(answer(program, stimulus, &["y", "--at", "0"]), @"
    y went on in scan 0: (y), rung 1, line 2
      a went on in scan 0: an input
      c went on in scan 0: an input
      e went on in scan 0: an input
    ");
    insta::assert_snapshot!(answer(program, stimulus, &["y"]), @"
    y went off in scan 1: (y), rung 1, line 2
      b is off in scan 1, since reset: an input
      c went off in scan 1: an input
      d is off in scan 1, since reset: an input
    ");
}

#[test]
fn json_has_the_same_causes() {
    let text = answer(MOTOR, PRESSED, &["motor", "--at", "6", "--format", "json"]);
    let json: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(json["name"], "motor");
    assert_eq!((&json["value"], &json["scan"], &json["since"]), (&0.into(), &6.into(), &6.into()));
    assert_eq!(json["at"]["title"], "seal-in");
    assert_eq!(json["causes"][0]["name"], "stop");
    assert_eq!(json["causes"][0]["reason"], "input");
}

#[test]
fn the_rungs_that_decided_are_drawn() {
    let text = answer(MOTOR, PRESSED, &["lamp", "--at", "5", "--format", "drawing"]);
    insta::assert_snapshot!(text);
    let svg = answer(MOTOR, PRESSED, &["lamp", "--at", "5", "--format", "svg"]);
    assert!(
        svg.contains(">why lamp is on in scan 5, since scan 4: ( lamp ), rung 2, line 6</text>")
    );
    for name in ["lamp", "delay", "motor", "start", "stop"] {
        let marked = svg.lines().filter(|line| line.contains(" decides\" "));
        assert!(marked.clone().any(|line| line.ends_with(&format!(">{name}</text>"))), "{name}");
    }
    // The second rung is shown in two scans and has one name for links.
    assert_eq!((svg.matches("<g ").count(), svg.matches("id=\"rung-2\"").count()), (3, 1));
    let program = "ladder q  input a, b  var n : INT  output y
        rung a { n := n + 1 }
        rung { n > 1 } b not ( y )";
    let text = answer(program, "a,b\n1,1\n", &["y", "--format", "drawing"]);
    assert!(text.contains("»n > 1«") && !text.contains("»b«"), "{text}");
    let program = "ladder r  input a  output y  rung a rising ( y )";
    let text = answer(program, "a\n1\n1\n", &["y", "--format", "drawing"]);
    assert!(text.contains("»┥rising├«"), "{text}");
}

/// What an explanation says of elements is what the rungs show that are drawn of it.
fn is_shown(cause: &Cause, shown: &[ShownRung]) {
    if let Reason::Element(place) | Reason::Call(place, _) = &cause.reason {
        let is_it = |shown: &&ShownRung| (shown.scan, shown.rung) == (cause.told_of, place.rung);
        let seen = &shown.iter().find(is_it).unwrap().seen[place.element];
        assert!(seen.decides, "{cause:?}");
        match (&cause.subject, &cause.reason) {
            (Subject::Condition(_), _) => assert_eq!(seen.is_on, cause.value != 0, "{cause:?}"),
            (Subject::IdleCoil(_), _) => assert!(!seen.power, "{cause:?}"),
            (_, Reason::Call(_, power)) => {
                assert_eq!(seen.power, power.is_on, "{cause:?}");
                assert!(!seen.readings.is_empty(), "{cause:?}");
            }
            _ => {}
        }
    }
    if let Some(Looked { scan, rung, element }) = cause.looked {
        let is_it = |shown: &&ShownRung| (shown.scan, shown.rung) == (scan, rung);
        assert!(shown.iter().find(is_it).unwrap().seen[element].decides, "{cause:?}");
    }
    cause.causes.iter().for_each(|cause| is_shown(cause, shown));
}

/// The number of parts of an explanation; it is no deeper than asked for.
fn parts(cause: &Cause, depth: usize) -> usize {
    assert!(depth > 0 || cause.causes.is_empty());
    1 + cause.causes.iter().map(|cause| parts(cause, depth.saturating_sub(1))).sum::<usize>()
}

#[test]
fn every_variable_of_random_programs_can_be_explained() {
    for seed in 0..amount("HOTRAIL_RANDOM_PROGRAMS", 1000) / 5 {
        let source = Source::new("random.ladder", generate::program(seed));
        let program = hotrail::analyze(&source).0.expect("random programs are good");
        let mut random = Rng::with_seed(seed);
        let inputs: Vec<VariableId> = program.with_role(Role::Input).map(|(id, _)| id).collect();
        let rows: Vec<(bool, Vec<(VariableId, i64)>)> = (0..30)
            .map(|_| {
                let driven = inputs.iter().filter(|_| random.bool()).copied().collect::<Vec<_>>();
                let mut drive =
                    |id: VariableId| (id, program.variables[id].ty.wrap(random.i64(-3..4)));
                let drives = driven.into_iter().map(&mut drive).collect();
                (random.bool(), drives)
            })
            .collect();
        let all = rows.iter().map(|(tick, drives)| Row { tick: *tick, drives });
        let why = Why::new(&program, &source, all);
        let mut evaluator = Evaluator::new(&program);
        for (scan, (tick, drives)) in rows.iter().enumerate() {
            drives.iter().for_each(|&(input, value)| evaluator.drive(input, value));
            evaluator.scan(*tick);
            if scan % 7 != 0 {
                continue;
            }
            for (id, variable) in program.named_variables() {
                let cause = why.explain(id, scan, 100);
                assert_eq!(cause.value, evaluator.value(id), "{} of seed {seed}", variable.name);
                // A condition is a part of its own beside the variable that it reads.
                let parts = parts(&cause, 200);
                assert!(parts < 20_000, "{} of seed {seed}: {parts}", variable.name);
                if scan == 14 {
                    is_shown(&cause, &why.shown(&cause));
                }
            }
        }
    }
}
