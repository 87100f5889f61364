//! The inequalities of the proofs, each with the paper's label.

use std::fmt;

/// An inequality of Section 3 or 4 (three are equalities), in the order of the paper.
///
/// ```
/// use signorini::proof::Inequality;
/// assert_eq!(Inequality::FirstCaseTwo.key(), "first-case-two");
/// assert!(Inequality::FirstCaseTwo.is_limit() && !Inequality::FirstCase.is_limit());
/// assert!(Inequality::Complementarity.is_equality());
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Inequality {
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

impl Inequality {
    /// Its name in lower case with hyphens: `first-case-two`.
    pub fn key(self) -> String {
        let name = format!("{self:?}");
        let letter = |(i, c): (usize, char)| {
            let hyphen = (i > 0 && c.is_uppercase()).then_some('-');
            hyphen.into_iter().chain(c.to_lowercase())
        };
        name.chars().enumerate().flat_map(letter).collect()
    }

    /// True if it is stated for τ ≥ 2 only.
    pub fn is_limit(self) -> bool {
        matches!(
            self,
            Inequality::FirstCaseTwo
                | Inequality::FirstYoungTwo
                | Inequality::SecondCaseTwo
                | Inequality::SecondYoungTwo
                | Inequality::SetFirstCaseTwo
                | Inequality::SetSecondCaseTwo
                | Inequality::AnyContact
        )
    }

    /// True for an equality, up to rounding.
    pub fn is_equality(self) -> bool {
        matches!(self, Inequality::VertexToZero | Inequality::Complementarity | Inequality::MeanZero)
    }
}

impl fmt::Display for Inequality {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Inequality::InterpolantCauchySchwarz => "(3.3) Cauchy-Schwarz",
            Inequality::VertexValue => "(3.3) value at a vertex",
            Inequality::VertexToZero => "(3.4) from a vertex to a zero",
            Inequality::VertexHoelder => "(3.5) Hölder",
            Inequality::SlopeEmbedding => "(3.6) embedding",
            Inequality::NormScaling => "(3.7) scaling of the norm",
            Inequality::ScaledEmbedding => "(3.8) both",
            Inequality::FirstCase => "(3.9) first case",
            Inequality::FirstYoung => "(3.9) Young",
            Inequality::FirstCaseTwo => "(3.10) first case, τ = 2",
            Inequality::FirstYoungTwo => "(3.10) Young",
            Inequality::Complementarity => "(3.11) σ u = 0",
            Inequality::ErrorCauchySchwarz => "(3.11) Cauchy-Schwarz",
            Inequality::StressPoincare => "(3.12) Poincaré",
            Inequality::Interpolation => "(3.13) interpolation",
            Inequality::SecondCase => "(3.14) second case",
            Inequality::SecondYoung => "(3.14) Young",
            Inequality::SecondCaseTwo => "(3.15) second case, τ = 2",
            Inequality::SecondYoungTwo => "(3.15) Young",
            Inequality::MeanZero => "(4.9) mean zero",
            Inequality::ForceTimesHeight => "(4.10) L¹ and L∞",
            Inequality::Pointwise => "(4.10) by (6.2)",
            Inequality::SupportHoelder => "(4.10) Hölder on S",
            Inequality::StressEmbedding => "(4.10) embedding",
            Inequality::SetFirstCase => "(4.10) first case",
            Inequality::SetFirstCaseTwo => "(4.12) first case, τ = 2",
            Inequality::ProjectionCauchySchwarz => "(4.11) Cauchy-Schwarz",
            Inequality::StressProjection => "(4.11) (4.6) of σ_N",
            Inequality::DisplacementProjection => "(4.11) (4.6) of u_N",
            Inequality::SlopePoincare => "(4.11) Poincaré of u_N'",
            Inequality::SetSecondCase => "(4.11) second case",
            Inequality::SetSecondCaseTwo => "(4.13) second case, τ = 2",
            Inequality::AnyContact => "(4.14) any contact, τ > 2",
        })
    }
}
