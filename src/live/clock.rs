//! How fast a program runs beside the time of the person who watches.

/// How often real time goes by in a second, as a fraction, and what it is called.
const SPEEDS: [(u128, u128, &str); 7] = [
    (1, 1000, "1/1000 of real time"),
    (1, 100, "1/100 of real time"),
    (1, 10, "1/10 of real time"),
    (1, 1, "real time"),
    (10, 1, "10 x real time"),
    (100, 1, "100 x real time"),
    (1000, 1, "1000 x real time"),
];
const REAL_TIME: usize = 3;

/// Turns time that goes by into scans that are due, one for each tick.
pub(super) struct Clock {
    tick_ns: u128,
    speed: usize,
    is_running: bool,
    is_late: bool,
    /// Time for which no scan has run yet, in nanoseconds, times the divisor of the speed.
    debt: u128,
}

impl Clock {
    pub fn new(tick_ns: u64) -> Clock {
        let tick_ns = tick_ns.into();
        Clock { tick_ns, speed: REAL_TIME, is_running: false, is_late: false, debt: 0 }
    }

    pub fn is_running(&self) -> bool {
        self.is_running
    }

    /// True if scans that were due have been left out.
    pub fn is_late(&self) -> bool {
        self.is_late
    }

    pub fn speed(&self) -> &'static str {
        SPEEDS[self.speed].2
    }

    pub fn run(&mut self, is_running: bool) {
        (self.is_running, self.is_late, self.debt) = (is_running, false, 0);
    }

    pub fn faster(&mut self) {
        self.speed = (self.speed + 1).min(SPEEDS.len() - 1);
        self.run(self.is_running);
    }

    pub fn slower(&mut self) {
        self.speed = self.speed.saturating_sub(1);
        self.run(self.is_running);
    }

    /// So much time goes by. Scans that are still due from before are never made up for: the
    /// program runs as fast as it can.
    pub fn elapse(&mut self, ns: u64) {
        if self.is_running {
            self.is_late = self.due() > 0;
            let (times, divisor, _) = SPEEDS[self.speed];
            self.debt = self.debt % (self.tick_ns * divisor) + u128::from(ns) * times;
        }
    }

    /// The scans that are due.
    pub fn due(&self) -> usize {
        let (_, divisor, _) = SPEEDS[self.speed];
        usize::try_from(self.debt / (self.tick_ns * divisor)).unwrap_or(usize::MAX)
    }

    /// Takes at most so many of the scans that are due.
    pub fn take(&mut self, most: usize) -> usize {
        let scans = self.due().min(most);
        self.debt -= scans as u128 * self.tick_ns * SPEEDS[self.speed].1;
        scans
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scans_are_due_as_time_goes_by() {
        let mut clock = Clock::new(10);
        clock.elapse(1000);
        assert_eq!(clock.due(), 0, "it does not run");
        clock.run(true);
        clock.elapse(25);
        assert_eq!((clock.take(100), clock.due()), (2, 0));
        clock.elapse(5);
        assert_eq!((clock.take(100), clock.is_late()), (1, false));
        clock.slower();
        clock.elapse(250);
        assert_eq!(clock.take(100), 2);
        clock.elapse(50);
        assert_eq!(clock.take(100), 1);
        (0..9).for_each(|_| clock.faster());
        clock.elapse(1);
        assert_eq!(clock.take(60), 60);
    }

    #[test]
    fn who_is_late_leaves_scans_out() {
        let mut clock = Clock::new(10);
        clock.run(true);
        clock.elapse(1005);
        assert_eq!(clock.take(10), 10);
        clock.elapse(10);
        assert!(clock.is_late());
        assert_eq!(clock.take(10), 1);
        clock.elapse(10);
        assert!(!clock.is_late());
    }
}
