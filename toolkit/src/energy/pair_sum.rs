//! Contributions of pairs of cells to a squared seminorm.

use std::ops::Add;

/// A positive integral and the rounding error of the differences in it.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct PairSum {
    pub(crate) value: f64,
    pub(crate) rounding: f64,
    pub(crate) points: u64,
}

impl Add for PairSum {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            value: self.value + other.value,
            rounding: self.rounding + other.rounding,
            points: self.points + other.points,
        }
    }
}
