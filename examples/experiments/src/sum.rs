//! Sums whose rounding does not grow with the number of terms.

/// A running sum with Neumaier's compensation (ZAMM 54, 1974).
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct RunningSum {
    sum: f64,
    carry: f64,
}

impl RunningSum {
    /// One more term.
    pub(crate) fn add(&mut self, term: f64) {
        let next = self.sum + term;
        self.carry +=
            if self.sum.abs() >= term.abs() { (self.sum - next) + term } else { (term - next) + self.sum };
        self.sum = next;
    }

    /// The sum so far.
    pub(crate) fn value(&self) -> f64 {
        self.sum + self.carry
    }
}
