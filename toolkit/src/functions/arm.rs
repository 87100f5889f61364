//! The halves of the intervals between breakpoints.

/// Half of the interval between two breakpoints: the points c + sign δ, 0 < δ < length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Arm {
    pub(crate) anchor: usize,
    pub(crate) start: f64,
    pub(crate) sign: f64,
    pub(crate) length: f64,
    /// largest t at which the function can be trusted
    pub(crate) depth: f64,
    /// rounding of x = c + δ; 0 where offsets are seen
    pub(crate) blur: f64,
}

impl Arm {
    /// δ = R e^{-t}.
    pub(crate) fn delta(&self, t: f64) -> f64 {
        self.length * (-t).exp()
    }
}
