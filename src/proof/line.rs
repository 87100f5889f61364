//! The lines of the proofs that are checked, each with the paper's label.

use std::fmt;

/// A line of Section 3 or 4, in the order of the paper.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Line {
    /// (3.3): ∫σ_N(I^h u)_N ≤ ‖σ_N‖₀‖(I^h u)_N‖₀.
    InterpolantCauchySchwarz,
    /// (3.3): ‖(I^h u)_N‖₀ ≤ h^{1/2} max|u_N(a_i)|.
    VertexValue,
    /// (3.4): |u_N(a_i)| = |∫ u_N'| up to the nearest zero.
    VertexToZero,
    /// (3.5): Hölder's inequality on that piece.
    VertexHoelder,
    /// (3.6): H^ν ⊂ L^q with the scaled norm.
    SlopeEmbedding,
    /// (3.7): the scaled norm by the full one.
    NormScaling,
    /// (3.8): both.
    ScaledEmbedding,
    /// (3.9): the first case, τ < 2.
    FirstCase,
    /// (3.9): Young's inequality.
    FirstYoung,
    /// (3.10): the first case, τ = 2.
    FirstCaseTwo,
    /// (3.10): Young's inequality.
    FirstYoungTwo,
    /// (3.11): ∫σ_N(I^h u)_N = ∫σ_N((I^h u)_N − u_N).
    Complementarity,
    /// (3.11): Cauchy-Schwarz.
    ErrorCauchySchwarz,
    /// (3.12): Poincaré's inequality of σ_N.
    StressPoincare,
    /// (3.13): interpolation.
    Interpolation,
    /// (3.14): the second case, τ < 2.
    SecondCase,
    /// (3.14): Young's inequality.
    SecondYoung,
    /// (3.15): the second case, τ = 2.
    SecondCaseTwo,
    /// (3.15): Young's inequality.
    SecondYoungTwo,
    /// (4.9): σ_N − π^hσ_N has mean zero.
    MeanZero,
    /// (4.10): L¹ times L^∞.
    ForceTimesHeight,
    /// (4.10): ‖u_N − π^h u_N‖_{L^∞} by (6.2).
    Pointwise,
    /// (4.10): Hölder's inequality on the support of σ_N.
    SupportHoelder,
    /// (4.10): H^ν ⊂ L^q.
    StressEmbedding,
    /// (4.10): the first case, τ < 2.
    SetFirstCase,
    /// (4.12): the first case, τ = 2.
    SetFirstCaseTwo,
    /// (4.11): Cauchy-Schwarz.
    ProjectionCauchySchwarz,
    /// (4.11): (4.6) of σ_N.
    StressProjection,
    /// (4.11): (4.6) of u_N.
    DisplacementProjection,
    /// (4.11): Poincaré's inequality of u_N'.
    SlopePoincare,
    /// (4.11): the second case, τ < 2.
    SetSecondCase,
    /// (4.13): the second case, τ = 2.
    SetSecondCaseTwo,
    /// (4.14): any contact, τ > 2.
    AnyContact,
}

impl Line {
    /// Its name in small letters with hyphens: `first-case-two`.
    pub fn key(self) -> String {
        let name = format!("{self:?}");
        let letter = |(i, c): (usize, char)| {
            let hyphen = (i > 0 && c.is_uppercase()).then_some('-');
            hyphen.into_iter().chain(c.to_lowercase())
        };
        name.chars().enumerate().flat_map(letter).collect()
    }

    /// Whether the line is stated for τ ≥ 2 only.
    pub fn is_limit(self) -> bool {
        matches!(
            self,
            Line::FirstCaseTwo
                | Line::FirstYoungTwo
                | Line::SecondCaseTwo
                | Line::SecondYoungTwo
                | Line::SetFirstCaseTwo
                | Line::SetSecondCaseTwo
                | Line::AnyContact
        )
    }

    /// Whether both sides are equal, up to rounding.
    pub fn is_equality(self) -> bool {
        matches!(self, Line::VertexToZero | Line::Complementarity | Line::MeanZero)
    }
}

impl fmt::Display for Line {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Line::InterpolantCauchySchwarz => "(3.3) Cauchy-Schwarz",
            Line::VertexValue => "(3.3) value at a vertex",
            Line::VertexToZero => "(3.4) from a vertex to a zero",
            Line::VertexHoelder => "(3.5) Hölder",
            Line::SlopeEmbedding => "(3.6) embedding",
            Line::NormScaling => "(3.7) scaling of the norm",
            Line::ScaledEmbedding => "(3.8) both",
            Line::FirstCase => "(3.9) first case",
            Line::FirstYoung => "(3.9) Young",
            Line::FirstCaseTwo => "(3.10) first case, τ = 2",
            Line::FirstYoungTwo => "(3.10) Young",
            Line::Complementarity => "(3.11) σ u = 0",
            Line::ErrorCauchySchwarz => "(3.11) Cauchy-Schwarz",
            Line::StressPoincare => "(3.12) Poincaré",
            Line::Interpolation => "(3.13) interpolation",
            Line::SecondCase => "(3.14) second case",
            Line::SecondYoung => "(3.14) Young",
            Line::SecondCaseTwo => "(3.15) second case, τ = 2",
            Line::SecondYoungTwo => "(3.15) Young",
            Line::MeanZero => "(4.9) mean zero",
            Line::ForceTimesHeight => "(4.10) L¹ and L∞",
            Line::Pointwise => "(4.10) by (6.2)",
            Line::SupportHoelder => "(4.10) Hölder on S",
            Line::StressEmbedding => "(4.10) embedding",
            Line::SetFirstCase => "(4.10) first case",
            Line::SetFirstCaseTwo => "(4.12) first case, τ = 2",
            Line::ProjectionCauchySchwarz => "(4.11) Cauchy-Schwarz",
            Line::StressProjection => "(4.11) (4.6) of σ_N",
            Line::DisplacementProjection => "(4.11) (4.6) of u_N",
            Line::SlopePoincare => "(4.11) Poincaré of u_N'",
            Line::SetSecondCase => "(4.11) second case",
            Line::SetSecondCaseTwo => "(4.13) second case, τ = 2",
            Line::AnyContact => "(4.14) any contact, τ > 2",
        })
    }
}
