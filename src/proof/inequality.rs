//! One inequality on one segment, and what is kept of it over a mesh.

use super::line::Line;

/// Relative error of sums and constants beside that of the seminorms: 1e-10 from the embedding constant.
const ROUNDING: f64 = 1e-9;

/// left ≤ right, or left = right, with the relative error of both.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Check {
    /// The line of the proof.
    pub line: Line,
    /// Left side.
    pub left: f64,
    /// Right side.
    pub right: f64,
    /// Absolute error of both sides together.
    pub error: f64,
    /// The line is an equality.
    pub is_equality: bool,
}

impl Check {
    /// left ≤ right; `relative` is the relative error of the seminorms in it.
    pub(super) fn at_most(line: Line, left: f64, right: f64, relative: f64) -> Self {
        let error = (ROUNDING + relative) * (left.abs() + right.abs());
        Self { line, left, right, error, is_equality: false }
    }

    /// The same with an absolute error beside the relative one.
    pub(super) fn plus(self, absolute: f64) -> Self {
        Self { error: self.error + absolute, ..self }
    }

    /// left = right up to cancellation in terms of the given size.
    pub(super) fn equal(line: Line, left: f64, right: f64, size: f64) -> Self {
        let error = ROUNDING * (left.abs() + right.abs()) + 1e-12 * size;
        Self { line, left, right, error, is_equality: true }
    }

    /// Holds within the error of its two sides.
    pub fn holds(&self) -> bool {
        let excess = self.left - self.right;
        if self.is_equality { excess.abs() <= self.error } else { excess <= self.error }
    }
}

/// An inequality over the segments of one mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InequalityProfile {
    /// The line of the proof.
    pub line: Line,
    /// Segments on which it was checked with a positive right side.
    pub count: usize,
    /// Sum of the left sides.
    pub left: f64,
    /// Sum of the right sides.
    pub right: f64,
    /// Largest left/right.
    pub sharpest: f64,
    /// Segments on which it fails beyond the error of its sides.
    pub violations: usize,
}

impl InequalityProfile {
    fn new(line: Line) -> Self {
        Self { line, count: 0, left: 0.0, right: 0.0, sharpest: 0.0, violations: 0 }
    }

    /// right/left of the sums; `None` when the left is zero.
    pub fn slack(&self) -> Option<f64> {
        (self.left > 0.0).then(|| self.right / self.left)
    }

    fn add(&mut self, check: &Check) {
        self.violations += usize::from(!check.holds());
        // Both sides at the level of rounding say nothing of the slack.
        if check.right > 0.0 && (check.is_equality || check.error < 0.5 * check.right) {
            self.count += 1;
            self.left += check.left;
            self.right += check.right;
            self.sharpest = self.sharpest.max(check.left / check.right);
        }
    }
}

/// Adds checks to the profile by their lines, in order of first appearance.
pub(super) fn tally(profiles: &mut Vec<InequalityProfile>, checks: &[Check]) {
    for check in checks {
        let place = profiles.iter().position(|p| p.line == check.line).unwrap_or_else(|| {
            profiles.push(InequalityProfile::new(check.line));
            profiles.len() - 1
        });
        profiles[place].add(check);
    }
}
