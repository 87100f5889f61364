//! A bound with both laws of the Poincaré constant.

/// A bound with the printed law of γ_θ and with the corrected one; they differ at τ = 2 only.
///
/// ```
/// use signorini::proof::TwoLaws;
/// let twice = TwoLaws { printed: 4.0, corrected: 2.0 }.map(|bound| 2.0 * bound);
/// assert_eq!(twice, TwoLaws { printed: 8.0, corrected: 4.0 });
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct TwoLaws {
    /// C ln(1/θ) at τ = 2, C θ^{τ−2} below.
    pub printed: f64,
    /// C √ln(1/θ) at τ = 2, else as printed.
    pub corrected: f64,
}

impl TwoLaws {
    /// A bound that does not depend on the law.
    pub fn same(value: f64) -> Self {
        Self { printed: value, corrected: value }
    }

    /// The function of both.
    pub fn map(self, f: impl Fn(f64) -> f64) -> Self {
        Self { printed: f(self.printed), corrected: f(self.corrected) }
    }
}
