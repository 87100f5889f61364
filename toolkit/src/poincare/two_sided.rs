//! Two-sided bounds of γ: a conforming lower bound, and an upper bound from γ₁ and a dual norm.

use super::constant::{constraint, gamma, gamma_whole, refine};
use super::continuation::Continuation;
use super::discrete::{Constraint, Discrete};
use super::mean::largest_mean;
use super::mesh::MeshModel;
use super::rounding::rounding;
use super::zone::{Condition, Zone};
use crate::FractionalOrder;
use crate::error::{Error, Given, Result};
use crate::estimate::{Estimate, Tolerance, Work};

/// γ between two bounds that do not use the eigenvalue itself.
///
/// ```
/// use fractional_sobolev::poincare::{Condition, TwoSided, Zone, two_sided};
/// // how much is certain without the eigenvalue: the bounds over the constant of the whole interval
/// let found: TwoSided = two_sided(0.5, Zone::end(1e-3)?, Condition::MeanZero, 1e-3)?;
/// let [low, high] = [found.lower, found.upper].map(|bound| bound / found.whole.value);
/// assert!(1.0 < low && low < high && high < 1.1 * low);
/// // max(γ₁, N) ≤ γ
/// assert!(found.dual_norm.value <= found.gamma.value + found.gamma.error);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TwoSided {
    /// γ with its error.
    pub gamma: Estimate,
    /// A conforming lower bound: the quotient of a function of the space, less its rounding. For orders so
    /// small that γ is continued from larger ones, γ less its error.
    pub lower: f64,
    /// An upper bound from γ₁ and the dual norm N, sharpened; raised by the estimated errors of γ₁ and N.
    pub upper: f64,
    /// γ₁(ν), the constant of the whole interval.
    pub whole: Estimate,
    /// N, the dual norm of the mean value: max(γ₁, N)² ≤ γ² ≤ γ₁² + N² for the mean-zero condition.
    pub dual_norm: Estimate,
}

/// γ with two-sided bounds (short proof: ‖u‖₀² = ‖u − m‖₀² + m² ≤ (γ₁² + N²) |u|_ν², m the mean of u over
/// (0,1)).
///
/// The upper bound is the smaller of √(γ₁² + N²) and the bound by a 2 × 2 matrix that follows from it when
/// the representer of m is split off. It is guaranteed as far as the estimates of γ₁ and N are.
///
/// ```
/// use fractional_sobolev::{FractionalOrder, Tolerance, poincare::{Condition, Zone, two_sided}};
/// let zone = Zone::at(0.25, 1e-3)?;
/// let found = two_sided(FractionalOrder::new(0.3)?, zone, Condition::MeanZero, Tolerance::fast())?;
/// assert!(found.lower <= found.gamma.value && found.gamma.value <= found.upper);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// As for [`super::gamma`].
pub fn two_sided(
    order: impl Given<FractionalOrder>,
    zone: Zone,
    condition: Condition,
    tolerance: impl Given<Tolerance>,
) -> Result<TwoSided> {
    let (order, tolerance) = (order.given()?, tolerance.given()?);
    let parts = constraint(&zone.into(), condition)?;
    let whole = gamma_whole(order, tolerance)?;
    let direct = refine(
        order,
        rounding(order, &parts),
        tolerance,
        |model| Sides::new(order, &parts, model, &whole),
        |fine, coarse| fine.join(&coarse, whole),
        |found| found.gamma,
    );
    match direct {
        // At small orders that have no digits of their own both are continued from larger ones.
        Err(Error::ToleranceNotMet { .. })
            if Continuation::to(order, parts.shortest(), tolerance).is_some() =>
        {
            let gamma = gamma(order, zone, condition, tolerance)?;
            let dual_norm = largest_mean(order, zone, condition, tolerance)?;
            Ok(TwoSided::of_estimates(gamma, whole, dual_norm))
        }
        result => result,
    }
}

impl TwoSided {
    /// (γ₁² + N²)^{1/2}, the bound of the short proof.
    ///
    /// ```
    /// use fractional_sobolev::{FractionalOrder, Tolerance, poincare::{Condition, Zone, two_sided}};
    /// let (order, zone) = (FractionalOrder::new(0.3)?, Zone::end(0.1)?);
    /// let found = two_sided(order, zone, Condition::MeanZero, Tolerance::fast())?;
    /// assert!(found.upper <= found.simple_bound()?.value * (1.0 + 1e-3));
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite) on overflow.
    pub fn simple_bound(&self) -> Result<Estimate> {
        let value = self.whole.value.hypot(self.dual_norm.value);
        let error = self.whole.error.hypot(self.dual_norm.error);
        Estimate::new(value, error, self.whole.work + self.dual_norm.work)
    }

    /// Where no function of the space has digits of its own: γ less its error, and √(γ₁² + N²) with their
    /// errors.
    fn of_estimates(gamma: Estimate, whole: Estimate, dual_norm: Estimate) -> Self {
        let upper = (whole.value + whole.error).hypot(dual_norm.value + dual_norm.error);
        let upper = upper.max(gamma.value + gamma.error);
        Self { gamma, lower: gamma.value - gamma.error, upper, whole, dual_norm }
    }
}

/// γ, its upper bound and N on one space.
struct Sides {
    gamma: f64,
    upper: f64,
    norm: f64,
    rounding: f64,
    work: Work,
}

impl Sides {
    fn new(
        order: FractionalOrder,
        constraint: &Constraint,
        model: &MeshModel,
        whole: &Estimate,
    ) -> Result<Self> {
        let mut discrete = Discrete::new(order, constraint, model)?;
        let (gamma, _) = discrete.largest_quotient()?;
        let dual = discrete.dual_norm()?;
        let whole_here = (whole.value + whole.error) / discrete.factor;
        Ok(Self {
            gamma,
            upper: dual.upper_bound(whole_here * whole_here).sqrt() * discrete.factor,
            norm: dual.square.sqrt() * discrete.factor,
            rounding: rounding(order, constraint),
            work: discrete.work,
        })
    }

    fn join(&self, coarse: &Self, whole: Estimate) -> Result<TwoSided> {
        let work = self.work + coarse.work;
        let estimate =
            |a: f64, b: f64| Estimate::new(a.max(b), (a - b).abs() + self.rounding * a.max(b), work);
        let gamma = estimate(self.gamma, coarse.gamma)?;
        let dual_norm = estimate(self.norm, coarse.norm)?;
        let upper = estimate(self.upper, coarse.upper)?;
        Ok(TwoSided {
            gamma,
            lower: gamma.value * (1.0 - self.rounding),
            upper: upper.value + upper.error + dual_norm.error,
            whole,
            dual_norm,
        })
    }
}
