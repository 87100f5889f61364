//! The halves of the intervals between breakpoints.

/// A one-sided neighbourhood of a breakpoint ("side" for short): half of the interval between two
/// breakpoints, the points c + sign δ, 0 < δ < length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Arm {
    pub(crate) anchor: usize,
    pub(crate) start: f64,
    pub(crate) sign: f64,
    pub(crate) length: f64,
    /// largest t at which values of the function are reliable
    pub(crate) depth: f64,
    /// rounding error of x = c + δ; 0 for functions of the offset
    pub(crate) blur: f64,
}

impl Arm {
    /// The distance δ = R e^{-t}.
    pub(crate) fn delta(&self, t: f64) -> f64 {
        self.length * (-t).exp()
    }

    /// Index of the side in the order from left to right.
    pub(super) fn index(&self) -> usize {
        if self.sign > 0.0 { 2 * self.anchor } else { 2 * self.anchor - 1 }
    }
}
