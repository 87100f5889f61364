//! The chain of estimates from the consistency term to the final bound, and its steps.

/// A step of the chain of estimates; its value bounds the previous one.
///
/// ```
/// use signorini::proof::Step;
/// assert_eq!((Step::ALL[0], Step::ALL[6]), (Step::Term, Step::WholeEdge));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Step {
    /// The consistency term itself.
    Term,
    /// Hölder's inequality.
    Hoelder,
    /// Interpolation, or the distance from a vertex to a zero.
    Interpolation,
    /// Embedding, and Poincaré's inequality for the zone of the segment.
    OwnZone,
    /// The same with all zones replaced by zones of length h_e θ.
    ShortestZone,
    /// The law of the Poincaré constant in place of the constant.
    Law,
    /// Young's inequality and the norms of the whole edge.
    WholeEdge,
}

impl Step {
    /// All steps, from the term to the final bound.
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
