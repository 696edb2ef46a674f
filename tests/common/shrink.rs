//! Makes a failing program small.

/// The smallest text found by leaving out lines and words that still `fails`. A text that is no
/// program any more does not fail.
pub fn shrink(text: &str, fails: impl Fn(&str) -> bool) -> String {
    let mut best: Vec<Vec<String>> =
        text.lines().map(|line| line.split_whitespace().map(str::to_owned).collect()).collect();
    let join =
        |lines: &[Vec<String>]| lines.iter().map(|line| line.join(" ") + "\n").collect::<String>();
    loop {
        let before = best.clone();
        for line in (0..best.len()).rev() {
            let mut smaller = best.clone();
            smaller.remove(line);
            if fails(&join(&smaller)) {
                best = smaller;
            }
        }
        for line in 0..best.len() {
            // Longer runs first: a list goes with its brackets or not at all.
            for run in (1..=best[line].len()).rev() {
                let mut start = 0;
                while start + run <= best[line].len() {
                    let mut smaller = best.clone();
                    smaller[line].drain(start..start + run);
                    if fails(&join(&smaller)) {
                        best = smaller;
                    } else {
                        start += 1;
                    }
                }
            }
        }
        if best == before {
            return join(&best);
        }
    }
}
