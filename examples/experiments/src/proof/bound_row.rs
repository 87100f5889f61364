//! The explicit bound beside the error on one mesh.

/// The bound beside the error on one mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct BoundRow {
    /// Segments n; h = 1/n.
    pub n: usize,
    /// |u − u_h|_a.
    pub error: f64,
    /// |u − I^h u|_a.
    pub interpolation: f64,
    /// On the square, |u|₂ in the rectangles on the contact edge over |u|₂.
    pub share: Option<f64>,
    /// Bounds from |u|₂ near the edge, on the strip from the data of its edge; one for each constant of a
    /// segment.
    pub near: Vec<f64>,
    /// On the square, the same from |u|₂ alone.
    pub whole: Option<Vec<f64>>,
}

impl BoundRow {
    /// Bound over error with constant `version`: from |u|₂ near the edge, or (not `local`) from |u|₂ alone.
    pub fn effectivity(&self, version: usize, local: bool) -> Option<f64> {
        let bounds = if local { Some(&self.near) } else { self.whole.as_ref() };
        Some(bounds?.get(version)? / self.error)
    }
}
