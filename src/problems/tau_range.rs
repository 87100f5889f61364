//! The admissible regularities τ of a test problem on the strip.

use crate::error::{Error, Result};

/// Lower limit of τ: up to it σ_N has no trace in L² in general.
const SMALLEST: f64 = 1.5;

/// The admissible τ of a test problem: from 3/2, excluded, to the largest value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct TauRange {
    largest: f64,
    is_attained: bool,
    words: &'static str,
}

impl TauRange {
    /// For transitions inside the edge: up to the natural r^{3/2}.
    pub(super) const TRANSITION: TauRange = TauRange { largest: 2.5, is_attained: true, words: "(3/2, 5/2]" };
    /// For a discontinuous slope of u_N, or a discontinuous λ.
    pub(super) const SLOPE: TauRange =
        TauRange { largest: 2.0, is_attained: true, words: "(3/2, 2] for this problem" };
    /// For d = 4 − 2τ > 0.
    pub(super) const FAT_CANTOR: TauRange =
        TauRange { largest: 2.0, is_attained: false, words: "(3/2, 2) for a fat Cantor set" };

    /// Fails with [`ToolkitError::OutOfRange`](crate::ToolkitError::OutOfRange) for an inadmissible τ.
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
