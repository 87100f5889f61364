//! The admissible regularities τ of a test problem of the strip.

use crate::error::{Error, Result};

/// Below it a solution of the paper's problem has no trace of σ_N in L².
const SMALLEST: f64 = 1.5;

/// The admissible τ of a test problem: from 3/2, excluded, up to the largest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct TauRange {
    largest: f64,
    is_attained: bool,
    words: &'static str,
}

impl TauRange {
    /// Ends of gaps inside the edge: up to the natural r^{3/2}.
    pub(super) const TRANSITION: TauRange = TauRange { largest: 2.5, is_attained: true, words: "(3/2, 5/2]" };
    /// The slope of u_N jumps somewhere, or λ does.
    pub(super) const SLOPE: TauRange =
        TauRange { largest: 2.0, is_attained: true, words: "(3/2, 2] for this problem" };
    /// d = 4 − 2τ > 0.
    pub(super) const FAT_CANTOR: TauRange =
        TauRange { largest: 2.0, is_attained: false, words: "(3/2, 2) for a fat Cantor set" };

    /// [`ToolkitError::OutOfRange`](crate::ToolkitError::OutOfRange) for a τ outside.
    pub(super) fn check(&self, tau: f64) -> Result<()> {
        let is_inside = tau < self.largest || self.is_attained && tau == self.largest;
        Error::require("tau", tau, self.words, tau > SMALLEST && is_inside)?;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_belong_to_the_range_as_printed() {
        for (range, inside, outside) in [
            (TauRange::TRANSITION, 2.5, 2.5 + 1e-12),
            (TauRange::SLOPE, 2.0, 2.0 + 1e-12),
            (TauRange::FAT_CANTOR, 2.0 - 1e-12, 2.0),
        ] {
            assert!(range.check(inside).is_ok() && range.check(1.5 + 1e-12).is_ok(), "{range:?}");
            for wrong in [outside, 1.5, f64::NAN, f64::NEG_INFINITY] {
                assert!(range.check(wrong).is_err(), "{range:?} {wrong}");
            }
        }
    }
}
