//! The constant γ_θ(ν) of Lemma 5.2 for every order, zone and condition, with bounds and extremal function.
//!
//! γ = sup ‖u‖₀ / |u|_ν over u ∈ H^ν(0,1) with ∫_E u = 0 (or u = 0 on E). γ² is the largest eigenvalue of the pencil (‖·‖₀², |·|_ν²) on
//! the slope space of `slopes`, on the mesh of `mesh`; the space is conforming, so every value is a lower bound up to rounding.
//! The error estimate compares two spaces of different shape; their difference is mostly the error of the coarser one.
//! Cost: a few hundred unknowns, whatever θ.

use super::discrete::{Constraint, Discrete};
use super::extremal::ExtremalFunction;
use super::mesh::MeshModel;
use super::zone::{Condition, Zone};
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance, Work};
use crate::sobolev::FractionalOrder;

/// Relative error of assembly, factorization and quotient: 1.3e-13 was the worst seen where the space is exact.
const ROUNDING: f64 = 2e-13;

/// How often the space is refined when the two spaces still differ too much.
const REFINEMENTS: usize = 3;

/// γ_θ(ν) = sup ‖u‖₀ / |u|_ν over the functions that satisfy `condition` on `zone`.
///
/// ```
/// use signorini::{Tolerance, poincare::{Condition, Zone, gamma}, sobolev::FractionalOrder};
/// let whole = gamma(FractionalOrder::HALF, Zone::end(1.0)?, Condition::MeanZero, Tolerance::balanced())?;
/// let small = gamma(FractionalOrder::HALF, Zone::end(1e-9)?, Condition::MeanZero, Tolerance::balanced())?;
/// assert!((whole.value - 0.291_564_029).abs() < 1e-8 && small.value > 1.5);
/// # Ok::<(), signorini::Error>(())
/// ```
///
/// # Errors
/// [`Error::OutOfRange`] when the condition leaves only u = 0 (vanishing on the whole interval);
/// [`Error::ToleranceNotMet`] when rounding (about 2e-13) forbids the tolerance.
pub fn gamma(
    order: FractionalOrder,
    zone: Zone,
    condition: Condition,
    tolerance: Tolerance,
) -> Result<Estimate> {
    let constraint = constraint(&zone, condition)?;
    refine_until(order, tolerance, |model| quotient(order, &constraint, model))
}

/// γ₀(ν) = sup ‖u‖₀ / |u|_ν over the functions that vanish at the point `a` of \[0,1\], ν > 1/2 (Remark 6).
///
/// ```
/// use signorini::{Tolerance, poincare::gamma_at_point, sobolev::FractionalOrder};
/// let order = FractionalOrder::new(0.75)?;
/// let [end, middle] = [0.0, 0.5].map(|a| gamma_at_point(order, a, Tolerance::fast()));
/// assert!(middle?.value < end?.value);
/// assert!(gamma_at_point(FractionalOrder::HALF, 0.0, Tolerance::fast()).is_err());
/// # Ok::<(), signorini::Error>(())
/// ```
///
/// # Errors
/// [`Error::OutOfRange`] for ν ≤ 1/2, where points have no trace, or a point outside; [`Error::ToleranceNotMet`] as for
/// [`gamma`], and when ν is so close to 1/2 that the constant is decided below r = 1e-290.
pub fn gamma_at_point(order: FractionalOrder, a: f64, tolerance: Tolerance) -> Result<Estimate> {
    Error::require("nu", order.value(), "(1/2, 1)", order.offset() > 0.0)?;
    let inside = a == 0.0 || (1e-300..=1.0).contains(&a);
    let a = Error::require("point", a, "{0} or [1e-300, 1]", inside)?;
    let constraint = Constraint::at_point(a);
    refine_until(order, tolerance, |model| quotient(order, &constraint, model))
}

/// γ₁(ν): mean zero over the whole interval. 1/2 as ν → 0, √(1−ν)/π as ν → 1.
///
/// # Errors
/// [`Error::ToleranceNotMet`] as for [`gamma`].
pub fn gamma_whole(order: FractionalOrder, tolerance: Tolerance) -> Result<Estimate> {
    refine_until(order, tolerance, |model| quotient(order, &Constraint::whole(), model))
}

/// N = sup |mean of u| / |u|_ν over the same functions as in [`gamma`]: for mean zero on E, the dual norm of 1_E/|E| − 1.
///
/// # Errors
/// As for [`gamma`].
pub fn dual_norm(
    order: FractionalOrder,
    zone: Zone,
    condition: Condition,
    tolerance: Tolerance,
) -> Result<Estimate> {
    let constraint = constraint(&zone, condition)?;
    refine_until(order, tolerance, |model| {
        let discrete = Discrete::new(order, &constraint, model)?;
        Ok((discrete.dual_norm()?.square.sqrt() * discrete.factor, discrete.work))
    })
}

/// N² and ‖r‖₀² for a zone (0,θ), r the mean-free representer of the dual norm.
pub(crate) struct DualMoments {
    pub(crate) square: Estimate,
    pub(crate) representer: Estimate,
}

pub(crate) fn dual_moments(order: FractionalOrder, theta: f64, tolerance: Tolerance) -> Result<DualMoments> {
    let constraint = Constraint::on_zone(&Zone::end(theta)?, Condition::MeanZero);
    let moments = |model: &MeshModel| -> Result<([f64; 2], Work)> {
        let discrete = Discrete::new(order, &constraint, model)?;
        let dual = discrete.dual_norm()?;
        let scale = discrete.factor * discrete.factor;
        Ok(([dual.square * scale, dual.square * dual.rayleigh * scale * scale], discrete.work))
    };
    let model = MeshModel::new(order, tolerance.relative());
    let (fine, work) = moments(&model)?;
    let (coarse, more) = moments(&model.varied())?;
    let estimate = |k: usize| {
        Estimate::new(fine[k], (fine[k] - coarse[k]).abs() + 2.0 * ROUNDING * fine[k], work + more)
    };
    Ok(DualMoments { square: estimate(0)?, representer: estimate(1)? })
}

/// γ between two bounds that do not use the eigenvalue itself.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TwoSided {
    /// γ with its error.
    pub gamma: Estimate,
    /// A conforming lower bound: the quotient of a function of the space, less its rounding.
    pub lower: f64,
    /// An upper bound from γ₁ and the dual norm N, sharpened; raised by the estimated errors of γ₁ and N.
    pub upper: f64,
    /// γ₁(ν), the constant of the whole interval.
    pub whole: Estimate,
    /// N, the dual norm of the mean value: max(γ₁, N)² ≤ γ² ≤ γ₁² + N² for the mean-zero condition.
    pub dual_norm: Estimate,
}

/// γ with two-sided bounds (short proof: ‖u‖₀² = ‖u − m‖₀² + m² ≤ (γ₁² + N²) |u|_ν², m the mean of u over (0,1)).
///
/// The upper bound is the smaller of √(γ₁² + N²) and the bound by a 2 × 2 matrix that follows from it when the representer of
/// m is split off. It is guaranteed as far as the estimates of γ₁ and N are.
///
/// ```
/// use signorini::{Tolerance, poincare::{Condition, Zone, two_sided}, sobolev::FractionalOrder};
/// let zone = Zone::at(0.25, 1e-3)?;
/// let found = two_sided(FractionalOrder::new(0.3)?, zone, Condition::MeanZero, Tolerance::fast())?;
/// assert!(found.lower <= found.gamma.value && found.gamma.value <= found.upper);
/// # Ok::<(), signorini::Error>(())
/// ```
///
/// # Errors
/// As for [`gamma`].
pub fn two_sided(
    order: FractionalOrder,
    zone: Zone,
    condition: Condition,
    tolerance: Tolerance,
) -> Result<TwoSided> {
    let constraint = constraint(&zone, condition)?;
    let whole = gamma_whole(order, tolerance)?;
    let mut target = tolerance.relative();
    let mut reached = f64::INFINITY;
    for _ in 0..=REFINEMENTS {
        let model = MeshModel::new(order, target);
        let fine = Sides::new(order, &constraint, &model, &whole)?;
        let coarse = Sides::new(order, &constraint, &model.varied(), &whole)?;
        let found = fine.join(&coarse, whole)?;
        reached = found.gamma.relative_error();
        if reached <= tolerance.relative() {
            return Ok(found);
        }
        target *= 0.02;
    }
    Err(Error::ToleranceNotMet { what: "Poincare constant", asked: tolerance.relative(), reached })
}

/// γ, its upper bound and N on one space.
struct Sides {
    gamma: f64,
    upper: f64,
    norm: f64,
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
            work: discrete.work,
        })
    }

    fn join(&self, coarse: &Self, whole: Estimate) -> Result<TwoSided> {
        let work = self.work + coarse.work;
        let estimate = |a: f64, b: f64| Estimate::new(a.max(b), (a - b).abs() + ROUNDING * a.max(b), work);
        let gamma = estimate(self.gamma, coarse.gamma)?;
        let dual_norm = estimate(self.norm, coarse.norm)?;
        let upper = estimate(self.upper, coarse.upper)?;
        Ok(TwoSided {
            gamma,
            lower: gamma.value * (1.0 - ROUNDING),
            upper: upper.value + upper.error + dual_norm.error,
            whole,
            dual_norm,
        })
    }
}

/// γ with the function for which it is attained.
///
/// # Errors
/// As for [`gamma`].
pub fn extremal(
    order: FractionalOrder,
    zone: Zone,
    condition: Condition,
    tolerance: Tolerance,
) -> Result<(Estimate, ExtremalFunction)> {
    let constraint = constraint(&zone, condition)?;
    let estimate = gamma(order, zone, condition, tolerance)?;
    let model = MeshModel::new(order, tolerance.relative());
    let mut discrete = Discrete::new(order, &constraint, &model)?;
    let (_, coefficients) = discrete.largest_quotient()?;
    Ok((estimate, ExtremalFunction::new(&discrete, coefficients)))
}

fn constraint(zone: &Zone, condition: Condition) -> Result<Constraint> {
    if condition == Condition::Vanishing {
        let theta = zone.length();
        let something_left = zone.start() + zone.rest() > 0.0;
        Error::require("theta", theta, "(0, 1) for a vanishing function", something_left)?;
    }
    Ok(Constraint::on_zone(zone, condition))
}

fn quotient(order: FractionalOrder, constraint: &Constraint, model: &MeshModel) -> Result<(f64, Work)> {
    let mut discrete = Discrete::new(order, constraint, model)?;
    let (value, _) = discrete.largest_quotient()?;
    Ok((value, discrete.work))
}

/// A supremum over spaces, computed on two spaces, finer ones until their difference meets the tolerance.
pub(crate) fn refine_until(
    order: FractionalOrder,
    tolerance: Tolerance,
    solve: impl Fn(&MeshModel) -> Result<(f64, Work)>,
) -> Result<Estimate> {
    let mut work = Work::default();
    let mut target = tolerance.relative();
    let mut reached = f64::INFINITY;
    for _ in 0..=REFINEMENTS {
        let model = MeshModel::new(order, target);
        let (fine, fine_work) = solve(&model)?;
        let (coarse, coarse_work) = solve(&model.varied())?;
        work += fine_work + coarse_work;
        let value = fine.max(coarse);
        let error = (fine - coarse).abs() + ROUNDING * value;
        reached = error / value;
        if reached <= tolerance.relative() {
            return Estimate::new(value, error, work);
        }
        target *= 0.02;
    }
    Err(Error::ToleranceNotMet { what: "Poincare constant", asked: tolerance.relative(), reached })
}
