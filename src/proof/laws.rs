//! A bound under both laws of the Poincaré constant.

/// A bound evaluated with the printed law of γ_θ and with the corrected law; they differ only at τ = 2.
///
/// ```
/// use signorini::proof::TwoLaws;
/// let twice = TwoLaws { printed: 4.0, corrected: 2.0 }.map(|bound| 2.0 * bound);
/// assert_eq!(twice, TwoLaws { printed: 8.0, corrected: 4.0 });
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct TwoLaws {
    /// The bound with γ_θ ≤ C ln(1/θ) at τ = 2, γ_θ ≤ C θ^{τ−2} for τ < 2, γ_θ ≤ C for τ > 2.
    pub printed: f64,
    /// The bound with γ_θ ≤ C √ln(1/θ) at τ = 2, otherwise as printed.
    pub corrected: f64,
}

impl TwoLaws {
    /// A bound that is the same under both laws.
    pub fn same(value: f64) -> Self {
        Self { printed: value, corrected: value }
    }

    /// The values of f at both bounds.
    pub fn map(self, f: impl Fn(f64) -> f64) -> Self {
        Self { printed: f(self.printed), corrected: f(self.corrected) }
    }
}
