//! The steps of the ladder from the consistency term to the final bound.

/// Rungs of a ladder, the consistency term and the final bound included.
pub(super) const RUNGS: usize = Step::ALL.len();

/// What a rung of the ladder bounds the one before by.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Step {
    /// The consistency term itself.
    Term,
    /// Hölder's inequality.
    Hoelder,
    /// Interpolation, or the distance from a vertex to a zero.
    Interpolation,
    /// Embedding, and Poincaré's inequality for the zone the segment has.
    OwnZone,
    /// The same as if every zone were as short as h_e θ.
    ShortestZone,
    /// The law of the Poincaré constant in place of the constant.
    Law,
    /// Young's inequality and the norms of the whole edge.
    WholeEdge,
}

impl Step {
    /// From the term to the final bound.
    pub const ALL: [Step; 7] = [
        Step::Term,
        Step::Hoelder,
        Step::Interpolation,
        Step::OwnZone,
        Step::ShortestZone,
        Step::Law,
        Step::WholeEdge,
    ];
}

/// A rung with the printed law of γ_θ, and with the one that holds; they differ at τ = 2 from [`Step::Law`]
/// on.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct TwoLaws {
    /// C ln(1/θ) at τ = 2, C θ^{τ−2} below.
    pub printed: f64,
    /// C √ln(1/θ) at τ = 2, else as printed.
    pub corrected: f64,
}

impl TwoLaws {
    /// A bound that needs no law.
    pub(super) fn same(value: f64) -> Self {
        Self { printed: value, corrected: value }
    }

    /// The function of both.
    pub(super) fn map(self, f: impl Fn(f64) -> f64) -> Self {
        Self { printed: f(self.printed), corrected: f(self.corrected) }
    }

    pub(super) fn add(&mut self, other: Self, share: f64) {
        self.printed += share * other.printed;
        self.corrected += share * other.corrected;
    }
}
