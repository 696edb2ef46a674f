//! `--schedule`

use clap::ValueEnum;
use hotrail::backend;

/// In which clocks of a scan the rungs act.
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum Schedule {
    /// One clock a scan: all rungs act in it
    Flat,
    /// Rungs that do not depend on each other act together, one level after the other
    Levels,
    /// One rung a clock, in text order
    Serial,
}

impl Schedule {
    pub fn schedule(self) -> backend::Schedule {
        match self {
            Schedule::Flat => backend::Schedule::Flat,
            Schedule::Levels => backend::Schedule::Levels,
            Schedule::Serial => backend::Schedule::Serial,
        }
    }
}
