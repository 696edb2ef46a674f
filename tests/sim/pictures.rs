//! The power of a scan and timing diagrams, as pictures.

use crate::folder;

/// The attribute that a screen reader reads, of each part of a picture.
pub fn labels(picture: &str) -> Vec<&str> {
    let labels = picture.split("aria-label=\"").skip(1);
    labels.map(|rest| rest.split('"').next().unwrap()).collect()
}

#[test]
fn a_picture_shows_the_power_of_a_scan() {
    let folder = folder();
    folder.write("s.csv", "up,load,patience\n0,,2\n1,-5,\n,,\n,,\n0,,\n");
    let power = |at: &[&str]| {
        let run =
            folder.run(&[&["sim", "lift.ladder", "s.csv", "--svg", "power.svg"], at].concat());
        assert_eq!((run.code, run.err.as_str()), (0, ""));
        assert_eq!(run.out.lines().count(), 6, "the table is printed too");
        folder.read("power.svg")
    };
    let third = power(&["--at", "2"]);
    assert!(third.contains(">power in scan 2</text>"), "{third}");
    let timer = "rung 1: up delay:TON(PT := patience) ( motor ). In this scan: up conducts, \
                 delay.PT = 0s, delay.Q = 0, delay.ET = 0s, motor is off, no power at the right end";
    assert_eq!(
        labels(&third)[0],
        timer.replace("PT = 0s", "PT = 2ms").replace("ET = 0s", "ET = 1ms")
    );
    assert!(labels(&third)[1].ends_with("weight = -5, load = -5, power to the right end"));
    let last = power(&[]);
    assert!(last.contains(">power in scan 4</text>"), "{last}");
    assert_eq!(
        labels(&last)[0],
        timer.replace("conducts", "is open").replace("PT = 0s", "PT = 2ms")
    );
}

#[test]
fn a_picture_of_a_scan_that_is_not_run_is_refused() {
    let folder = folder();
    let run = folder.run(&["sim", "lift.ladder", "--scans", "3", "--svg", "p.svg", "--at", "3"]);
    assert_eq!(run.code, 1);
    assert!(run.err.contains("the run has 3 scans, from 0"), "{}", run.err);
    let run = folder.run(&["sim", "lift.ladder", "--scans", "3", "--at", "1"]);
    assert_eq!(run.code, 2, "--at is for --svg");
    assert!(!folder.path("p.svg").exists());
}

#[test]
fn a_timing_diagram_tells_when_what_changed() {
    let folder = folder();
    folder.write("s.csv", "up,tick,patience\n0,,3\n1,,\n,,\n,0,\n,,\n,,\n,,\n0,,\n");
    let watch = ["--watch", "up,delay.ET,motor", "--waves", "waves.svg"];
    let run = folder.run(&[&["sim", "lift.ladder", "s.csv"][..], &watch].concat());
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    let picture = folder.read("waves.svg");
    assert_eq!(
        labels(&picture),
        [
            "tick: 1 from scan 0, 0 from scan 3, 1 from scan 4",
            "up: 0 from scan 0, 1 from scan 1, 0 from scan 7",
            "delay.ET: 0s from scan 0, 1ms from scan 2, 2ms from scan 4, 3ms from scan 5, \
             0s from scan 7",
            "motor: 0 from scan 0, 1 from scan 5, 0 from scan 7",
        ]
    );
    // Scan 5 is the fifth after the first one, and one of them had no tick.
    assert!(picture.contains(">5</text>") && picture.contains(">4ms</text>"), "{picture}");
}

#[test]
fn a_long_run_has_a_diagram_of_bounded_size() {
    let folder = folder();
    let rows: String =
        (0..20_000).map(|scan| format!("{},{}\n", scan % 2, scan * 7 % 100)).collect();
    folder.write("s.csv", &format!("up,load\n{rows}"));
    let run = folder.run(&["sim", "lift.ladder", "s.csv", "--waves", "waves.svg"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    let picture = folder.read("waves.svg");
    assert!(picture.contains("scans 0 to 1999 of 20000: too much happens to draw them all"));
    assert!(picture.len() < 3_000_000, "{}", picture.len());
    // One that waits for long is cut short.
    folder.write("long.csv", "up,patience\n1,50000\n");
    let long = ["sim", "lift.ladder", "long.csv", "--scans", "60000", "--watch", "motor,delay.ET"];
    let run = folder.run(&[&long[..], &["--waves", "waves.svg"]].concat());
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    let picture = folder.read("waves.svg");
    assert!(picture.contains(">50000</text>") && picture.len() < 10_000, "{picture}");
}
