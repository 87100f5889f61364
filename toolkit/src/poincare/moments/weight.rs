//! The weights of moments.

/// The weight m of a moment; x is the distance from the free end, e − x that from the zone.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Moment {
    /// m = 1.
    Mass,
    /// m = x.
    FromFreeEnd,
    /// m = e − x.
    FromZone,
}

impl Moment {
    /// The weight m at the given distances from the free end and from the zone.
    pub(super) fn weight(self, from_free_end: f64, from_zone: f64) -> f64 {
        match self {
            Moment::Mass => 1.0,
            Moment::FromFreeEnd => from_free_end,
            Moment::FromZone => from_zone,
        }
    }

    /// The power of a length in m.
    pub(super) fn degree(self) -> i32 {
        i32::from(self != Moment::Mass)
    }
}
