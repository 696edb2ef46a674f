//! Checks on random programs: a seed is a program and what drives it. Tests run some of each, a
//! campaign as many as it likes.

use std::cell::Cell;
use std::ops::Range;
use std::panic::{self, AssertUnwindSafe};

use fastrand::Rng;
use hotrail::backend::hdl::Language;

use super::shrink::shrink;
use super::{
    analyze, bulk, emulated, generate, lockstep, relay, reordered, require_tool, scheduled, trees,
    variants,
};

/// Something that holds for every random program.
pub struct Check {
    /// What it is called.
    pub name: &'static str,
    /// What it shows.
    pub shows: &'static str,
    /// How many programs are checked at a time.
    pub batch: u64,
    run: fn(Range<u64>) -> Tally,
    /// Tools that it needs.
    tools: &'static [&'static str],
}

/// What came of some programs.
#[derive(Default)]
pub struct Tally {
    /// Programs that were checked.
    pub programs: u64,
    /// Programs that this check does not take.
    pub skipped: u64,
    /// Scans of all of them.
    pub scans: u64,
    /// Those that failed.
    pub failures: Vec<Failure>,
}

/// A program that failed.
pub struct Failure {
    /// The program.
    pub seed: u64,
    /// What is wrong, and the smallest program found that fails too.
    pub text: String,
}

/// All of them.
pub const ALL: &[Check] = &[CIRCUIT, SCHEDULES, ORDER, PROCESSOR, TREES, METAMORPHIC, ICARUS, GHDL];

/// The circuit as shipped, with all its inside shown, as straight code and in 64 lanes.
pub const CIRCUIT: Check = Check {
    name: "circuit",
    shows: "evaluator = circuit",
    batch: 200,
    run: |seeds| one_by_one(seeds, circuit),
    tools: &[],
};

/// The schedules that take several clocks for a scan.
pub const SCHEDULES: Check = Check {
    name: "schedules",
    shows: "evaluator = circuits of several clocks a scan",
    batch: 200,
    run: |seeds| one_by_one(seeds, schedules),
    tools: &[],
};

/// The rungs as values flow between them.
pub const ORDER: Check = Check {
    name: "order",
    shows: "what a change of order is not said to change stays",
    batch: 200,
    run: |seeds| one_by_one(seeds, order),
    tools: &[],
};

/// Programs that the ladder processor can do, on its emulator.
pub const PROCESSOR: Check = Check {
    name: "processor",
    shows: "evaluator = ladder processor",
    batch: 500,
    run: |seeds| one_by_one(seeds, processor),
    tools: &[],
};

/// Rungs as trees of contacts, every second one with bridges.
pub const TREES: Check = Check {
    name: "trees",
    shows: "tree of contacts = its words on the ladder processor",
    batch: 1000,
    run: |seeds| one_by_one(seeds, trees),
    tools: &[],
};

/// A change that keeps the meaning of a program, each kind in turn.
pub const METAMORPHIC: Check = Check {
    name: "metamorphic",
    shows: "program = program after a change that keeps its meaning",
    batch: 500,
    run: |seeds| one_by_one(seeds, metamorphic),
    tools: &[],
};

/// The printed Verilog.
pub const ICARUS: Check = Check {
    name: "icarus",
    shows: "evaluator = printed Verilog in Icarus",
    batch: 25,
    run: |seeds| simulators(Language::Verilog, seeds),
    tools: &["iverilog"],
};

/// The printed VHDL.
pub const GHDL: Check = Check {
    name: "ghdl",
    shows: "evaluator = printed VHDL in GHDL",
    batch: 25,
    run: |seeds| simulators(Language::Vhdl, seeds),
    tools: &["ghdl"],
};

/// What a program came to.
enum Outcome {
    Held { scans: u64 },
    Skipped,
    Failed(String),
}

impl Check {
    /// The check of a name.
    pub fn named(name: &str) -> Option<&'static Check> {
        ALL.iter().find(|check| check.name == name)
    }

    /// Checks the programs of these seeds. A panic is a failure of its program.
    pub fn run(&self, seeds: Range<u64>) -> Tally {
        (self.run)(seeds)
    }

    /// True if its tools are there, see [`require_tool`].
    pub fn can_run(&self) -> bool {
        self.tools.iter().all(|tool| require_tool(tool))
    }

    /// Checks the first programs.
    ///
    /// # Panics
    /// If one of them fails, with its seed and a small program that fails too.
    pub fn hold(&self, programs: u64) -> Tally {
        let mut sum = Tally::default();
        if !self.can_run() {
            return sum;
        }
        let batches = (0..programs).step_by(self.batch as usize);
        for seeds in batches.map(|first| first..programs.min(first + self.batch)) {
            let tally = self.run(seeds);
            if let Some(Failure { seed, text }) = tally.failures.first() {
                panic!("{}: seed {seed}, {text}", self.shows);
            }
            sum.programs += tally.programs;
            sum.skipped += tally.skipped;
            sum.scans += tally.scans;
        }
        sum
    }
}

thread_local! {
    static IS_QUIET: Cell<bool> = const { Cell::new(false) };
}

/// What a function gives, or what it panicked with.
fn caught<T>(work: impl FnOnce() -> T) -> Result<T, String> {
    static HOOK: std::sync::Once = std::sync::Once::new();
    HOOK.call_once(|| {
        let usual = panic::take_hook();
        panic::set_hook(Box::new(move |info| {
            if !IS_QUIET.get() {
                usual(info)
            }
        }));
    });
    let was_quiet = IS_QUIET.replace(true);
    let result = panic::catch_unwind(AssertUnwindSafe(work));
    IS_QUIET.set(was_quiet);
    result.map_err(|payload| match payload.downcast::<String>() {
        Ok(text) => format!("panic: {text}"),
        Err(payload) => format!("panic: {:?}", payload.downcast_ref::<&str>()),
    })
}

fn one_by_one(seeds: Range<u64>, check: fn(u64) -> Outcome) -> Tally {
    let mut tally = Tally::default();
    for seed in seeds {
        match caught(|| check(seed)).unwrap_or_else(Outcome::Failed) {
            Outcome::Held { scans } => {
                tally.programs += 1;
                tally.scans += scans;
            }
            Outcome::Skipped => tally.skipped += 1,
            Outcome::Failed(text) => {
                tally.programs += 1;
                tally.failures.push(Failure { seed, text });
            }
        }
    }
    tally
}

/// A failure with the smallest text that fails too; a panic counts. With `HOTRAIL_SHRINK=0` the text
/// stays as it is.
fn failed(wrong: &str, text: &str, fails: impl Fn(&str) -> bool) -> Outcome {
    if std::env::var_os("HOTRAIL_SHRINK").is_some_and(|value| value == "0") {
        return Outcome::Failed(format!("{wrong}; the program:\n{text}"));
    }
    let fails = |text: &str| caught(|| fails(text)).unwrap_or(true);
    Outcome::Failed(format!("{wrong}; the smallest such program:\n{}", shrink(text, fails)))
}

/// Scans of a program in the checks without a simulator.
const SCANS: usize = 200;

/// Holds that nothing is wrong with a program.
fn held(text: &str, scans: u64, wrong: impl Fn(&str) -> Result<Option<String>, String>) -> Outcome {
    match caught(|| wrong(text)) {
        Ok(Ok(None)) => Outcome::Held { scans },
        // It does not fit into the processor's code memory.
        Ok(Err(findings)) if findings.contains("E0802") => Outcome::Skipped,
        Ok(Err(findings)) => Outcome::Failed(format!("{findings}\n{text}")),
        Ok(Ok(Some(what))) | Err(what) => {
            failed(&what, text, |text| matches!(wrong(text), Ok(Some(_))))
        }
    }
}

fn circuit(seed: u64) -> Outcome {
    held(&generate::program(seed), SCANS as u64, |text| {
        let program = analyze("random.ladder", text)?;
        Ok(lockstep::difference(&program, SCANS, Rng::with_seed(seed)))
    })
}

fn schedules(seed: u64) -> Outcome {
    const SCANS: usize = 100;
    held(&generate::program(seed), 2 * SCANS as u64, |text| {
        let program = analyze("random.ladder", text)?;
        Ok(scheduled::differences(&program, SCANS, seed))
    })
}

fn order(seed: u64) -> Outcome {
    held(&generate::program(seed), reordered::SCANS as u64, |text| {
        let (before, mut after) = (analyze("order.ladder", text)?, analyze("order.ladder", text)?);
        Ok(reordered::wrong_claim(&before, &mut after, seed))
    })
}

fn processor(seed: u64) -> Outcome {
    held(&relay::program(seed), SCANS as u64, |text| {
        let (program, image) = emulated::compile(text)?;
        Ok(emulated::difference(&program, &image, SCANS, Rng::with_seed(seed)))
    })
}

fn trees(seed: u64) -> Outcome {
    let mut random = Rng::with_seed(seed);
    let depth = random.u32(1..7);
    let tree = trees::random_tree(&mut random, depth, seed.is_multiple_of(2));
    match caught(|| trees::difference(&tree, &mut random)) {
        Ok(None) => Outcome::Held { scans: trees::SCANS },
        Ok(Some(wrong)) | Err(wrong) => Outcome::Failed(format!("{wrong}; the tree:\n{tree:?}")),
    }
}

fn metamorphic(seed: u64) -> Outcome {
    let text = generate::program(seed);
    let change = (seed % variants::CHANGES.len() as u64) as usize;
    match variants::check("random.ladder", &text, change, seed) {
        Ok(Some(scans)) => Outcome::Held { scans },
        Ok(None) => Outcome::Skipped,
        Err(what) => {
            let what = format!("{}: {what}\nfrom", variants::CHANGES[change].0);
            failed(&what, &text, |text| {
                variants::check("random.ladder", text, change, seed).is_err()
            })
        }
    }
}

/// Scans of a program in a simulator.
const SIMULATED: usize = 100;

fn simulators(language: Language, seeds: Range<u64>) -> Tally {
    let list: Vec<(u64, String)> = seeds.map(|seed| (seed, generate::program(seed))).collect();
    let programs = list.len() as u64;
    let mut tally = Tally { programs, scans: programs * SIMULATED as u64, ..Tally::default() };
    let run = |programs: &[(u64, String)]| {
        let found = caught(|| bulk::simulate(language, programs, SIMULATED))?;
        Ok::<_, String>(found.expect("the tool is there"))
    };
    let failed = |(seed, program): &(u64, String), text: String| Failure {
        seed: *seed,
        text: format!("{text}; the program:\n{program}"),
    };
    match run(&list) {
        Ok(found) => {
            let wrong = list.iter().zip(found);
            tally.failures = wrong.filter_map(|(one, text)| Some(failed(one, text?))).collect();
        }
        // One of them was refused: which one shows alone.
        Err(refused) => {
            for one in &list {
                let text = match run(std::slice::from_ref(one)) {
                    Ok(found) => found.into_iter().flatten().next(),
                    Err(text) => Some(text),
                };
                tally.failures.extend(text.map(|text| failed(one, text)));
            }
            if tally.failures.is_empty() {
                tally.failures.push(failed(&list[0], format!("refused with others: {refused}")));
            }
        }
    }
    tally
}
