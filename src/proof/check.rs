//! One inequality on one segment.

use super::inequality::Inequality;

/// Relative error of sums and constants beside that of the seminorms: 1e-10 from the embedding constant.
const ROUNDING: f64 = 1e-9;

/// left ≤ right, or left = right, with the relative error of both.
///
/// `error` is (1e-9 + relative error of the seminorms)(|left| + |right|), for an equality relative to the size of the
/// terms that cancel. The sides are in the units of the data.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Check {
    /// The inequality of the paper.
    pub inequality: Inequality,
    /// Left side.
    pub left: f64,
    /// Right side.
    pub right: f64,
    /// Absolute error of both sides together.
    pub error: f64,
    /// True for an equality.
    pub is_equality: bool,
}

impl Check {
    /// left ≤ right; `relative` is the relative error of the seminorms in it.
    pub(super) fn at_most(inequality: Inequality, left: f64, right: f64, relative: f64) -> Self {
        let error = (ROUNDING + relative) * (left.abs() + right.abs());
        Self { inequality, left, right, error, is_equality: false }
    }

    /// The same with an absolute error beside the relative one.
    pub(super) fn plus(self, absolute: f64) -> Self {
        Self { error: self.error + absolute, ..self }
    }

    /// left = right up to cancellation in terms of the given size.
    pub(super) fn equal(inequality: Inequality, left: f64, right: f64, size: f64) -> Self {
        let error = ROUNDING * (left.abs() + right.abs()) + 1e-12 * size;
        Self { inequality, left, right, error, is_equality: true }
    }

    /// True if the inequality holds within the error of its two sides.
    ///
    /// left ≤ right + error, or |left − right| ≤ error for an equality.
    pub fn holds(&self) -> bool {
        let excess = self.left - self.right;
        if self.is_equality { excess.abs() <= self.error } else { excess <= self.error }
    }
}
