//! What is kept of an inequality over the segments of a mesh.

use signorini::proof::{Check, Inequality};

/// An inequality over the segments of one mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InequalityProfile {
    /// The line of the proof.
    pub line: Inequality,
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
    fn new(line: Inequality) -> Self {
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
        let place = profiles.iter().position(|p| p.line == check.inequality).unwrap_or_else(|| {
            profiles.push(InequalityProfile::new(check.inequality));
            profiles.len() - 1
        });
        profiles[place].add(check);
    }
}
