//! The constant γ_θ(ν) of Lemma 5.2 for every order, zone and condition, with bounds and extremal function.

use super::constraint::Constraint;
use super::continuation::Continuation;
use super::discrete::Discrete;
use super::extremal::ExtremalFunction;
use super::mesh::{MeshModel, SHORTEST_RADIUS};
use super::rounding::rounding;
use super::two_sided::{GammaBounds, two_sided};
use crate::FractionalOrder;
use crate::error::{Error, Given, Result};
use crate::estimate::{Estimate, Tolerance, Work};

/// How often the space is refined when the two spaces still differ too much.
const REFINEMENTS: usize = 3;

/// Factors for the accuracy a mesh is made for: when it was not reached, and when it was too much for f64.
const FINER: f64 = 0.02;
const COARSER: f64 = 4.0;

/// γ(ν) = sup ‖u‖₀ / |u|_ν over the functions that satisfy a constraint: the constant, its extremal function,
/// and bounds.
///
/// # Method
///
/// γ = sup ‖u‖₀ / |u|_ν over u ∈ H^ν(0,1) with ∫_E u = 0 (or u = 0 on E). γ² is the largest eigenvalue of the
/// pencil (‖·‖₀², |·|_ν²) on the slope space of `slopes`, on the mesh of `mesh`; the space is conforming, so
/// every value is a lower bound up to rounding. The error estimate compares two spaces of different shape;
/// their difference is mostly the error of the coarser one. Cost: a few hundred unknowns, whatever θ.
///
/// ```
/// use fractional_sobolev::{Constraint, gamma};
/// let whole = gamma(0.5, Constraint::mean_zero(), 1e-8)?.constant;
/// let small = gamma(0.5, Constraint::mean_zero_on(0.0..1e-9), 1e-8)?.constant;
/// assert!((whole.value - 0.291_564_029).abs() < 1e-8 && small.value > 1.5);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// [`Error::OutOfRange`] for a point when ν ≤ 1/2, where points have no trace; [`Error::ToleranceNotMet`] when
/// rounding (about 2e-13, up to 5e-11 for very short zones inside; for several intervals far apart, of lengths
/// up to θ, also 4e-15 θ^(2ν−1) below one half) forbids the tolerance, and for a point when ν is so close to
/// 1/2 that the constant is decided below r = 1e-290.
#[doc(alias("Poincare constant", "Poincaré constant", "Poincare inequality", "Friedrichs", "eigenfunction"))]
pub fn gamma(
    order: impl Given<FractionalOrder>,
    constraint: impl Given<Constraint>,
    tolerance: impl Given<Tolerance>,
) -> Result<Gamma> {
    let (order, constraint, tolerance) = (order.given()?, constraint.given()?, tolerance.given()?);
    if constraint.is_point() {
        Error::require("nu", order.value(), "(1/2, 1)", order.offset() > 0.0)?;
        let reached = SHORTEST_RADIUS.powf(2.0 * order.offset());
        if reached > tolerance.relative() {
            let why = "so near to order 1/2 it is decided nearer to the point than binary64 reaches";
            return Err(Error::out_of_reach("Poincare constant", tolerance.relative(), reached, why));
        }
    }
    let direct = |order, tolerance| attained(order, &constraint, tolerance);
    let larger = Continuation::to(order, constraint.shortest(), tolerance);
    let continued = |larger: &Continuation| {
        let (values, functions): (Vec<_>, Vec<_>) = larger.at_points(direct)?.into_iter().unzip();
        Ok((larger.value(&values)?, ExtremalFunction::combined(&larger.all_weights(), functions)))
    };
    let digits = rounding(order, &constraint) <= tolerance.relative();
    let (constant, function) = match larger {
        Some(larger) if !digits => continued(&larger),
        Some(larger) => match direct(order, tolerance) {
            Err(Error::ToleranceNotMet { .. }) => continued(&larger),
            result => result,
        },
        None => direct(order, tolerance),
    }?;
    Ok(Gamma { constant, order, constraint, tolerance, function })
}

/// A Poincaré constant with the function for which it is attained.
///
/// Returned by [`gamma`].
#[derive(Debug, Clone)]
pub struct Gamma {
    /// γ.
    pub constant: Estimate,
    order: FractionalOrder,
    constraint: Constraint,
    tolerance: Tolerance,
    function: ExtremalFunction,
}

impl Gamma {
    /// A function for which the constant is attained: of the space on which the value was found, or continued
    /// from larger orders as the value is.
    ///
    /// ```
    /// use fractional_sobolev::{Constraint, Gamma, gamma};
    /// let found: Gamma = gamma(0.5, Constraint::vanishing_on(0.0..0.01), 1e-4)?;
    /// let u = found.extremal();
    /// assert!(u.value(0.005).abs() < 1e-12 && u.value(1.0) > 1.0 && found.constant.value > 0.3);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    #[doc(alias("eigenfunction", "minimiser"))]
    pub fn extremal(&self) -> ExtremalFunction {
        self.function.clone()
    }

    /// Two bounds that do not use the eigenvalue, at about the cost of the constant (short proof: ‖u‖₀² =
    /// ‖u − m‖₀² + m² ≤ (γ₁² + N²) |u|_ν², m the mean of u over (0,1)).
    ///
    /// The upper bound is the smaller of √(γ₁² + N²) and the bound by a 2 × 2 matrix that follows from it when
    /// the representer of m is split off. It is guaranteed as far as the estimates of γ₁ and N are.
    ///
    /// ```
    /// use fractional_sobolev::{Constraint, gamma};
    /// let found = gamma(0.3, Constraint::mean_zero_on(0.25..0.26), 1e-4)?;
    /// let bounds = found.bounds()?;
    /// assert!(bounds.lower <= found.constant.value && found.constant.value <= bounds.upper);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`gamma`]; [`Error::OutOfRange`] for a condition at a point, which has no such bound.
    pub fn bounds(&self) -> Result<GammaBounds> {
        let order = self.order.value();
        Error::require("nu", order, "bounds of a zone, not of a point", !self.constraint.is_point())?;
        two_sided(self.order, &self.constraint, self.constant, self.tolerance)
    }
}

/// What `direct` finds, at small orders that have no digits of their own what is continued from larger ones.
pub(super) fn continued(
    order: FractionalOrder,
    constraint: &Constraint,
    tolerance: Tolerance,
    direct: impl Fn(FractionalOrder, Tolerance) -> Result<Estimate> + Sync,
) -> Result<Estimate> {
    let larger = Continuation::to(order, constraint.shortest(), tolerance);
    if let Some(larger) = larger.as_ref().filter(|_| rounding(order, constraint) > tolerance.relative()) {
        return larger.value(&larger.at_points(direct)?);
    }
    match (direct(order, tolerance), larger) {
        (Err(Error::ToleranceNotMet { .. }), Some(larger)) => larger.value(&larger.at_points(direct)?),
        (result, _) => result,
    }
}

/// γ and its function from the same one of the two spaces that are compared.
fn attained(
    order: FractionalOrder,
    constraint: &Constraint,
    tolerance: Tolerance,
) -> Result<(Estimate, ExtremalFunction)> {
    let rounding = rounding(order, constraint);
    let solve = |model: &MeshModel| -> Result<(f64, Work, ExtremalFunction)> {
        let mut discrete = Discrete::new(order, constraint, model)?;
        let (value, coefficients) = discrete.largest_quotient()?;
        Ok((value, discrete.work, ExtremalFunction::new(&discrete, coefficients)))
    };
    let join = |fine: (f64, Work, ExtremalFunction), coarse: (f64, Work, ExtremalFunction)| {
        let (apart, work) = ((fine.0 - coarse.0).abs(), fine.1 + coarse.1);
        let (value, _, function) = if fine.0 >= coarse.0 { fine } else { coarse };
        Ok((Estimate::new(value, apart + rounding * value, work)?, function))
    };
    refine(order, rounding, tolerance, solve, join, |found| found.0)
}

/// A supremum over spaces, computed on two spaces, finer ones until their difference meets the tolerance.
pub(crate) fn refine_until(
    order: FractionalOrder,
    constraint: &Constraint,
    tolerance: Tolerance,
    solve: impl Fn(&MeshModel) -> Result<(f64, Work)> + Sync,
) -> Result<Estimate> {
    let rounding = rounding(order, constraint);
    let join = |fine: (f64, Work), coarse: (f64, Work)| {
        let value = fine.0.max(coarse.0);
        Estimate::new(value, (fine.0 - coarse.0).abs() + rounding * value, fine.1 + coarse.1)
    };
    refine(order, rounding, tolerance, solve, join, |found| *found)
}

/// Solves on two spaces and joins the results, until their relative error meets the tolerance.
pub(super) fn refine<T: Send, R>(
    order: FractionalOrder,
    rounding: f64,
    tolerance: Tolerance,
    solve: impl Fn(&MeshModel) -> Result<T> + Sync,
    join: impl Fn(T, T) -> Result<R>,
    estimate: impl Fn(&R) -> Estimate,
) -> Result<R> {
    let asked = tolerance.relative();
    // Where rounding forbids the tolerance one pair of spaces shows what can be had.
    let mut target = asked.max(rounding).min(0.1);
    let mut best: Option<Estimate> = None;
    for _ in 0..=REFINEMENTS {
        let model = MeshModel::new(order, target);
        match rayon::join(|| solve(&model), || solve(&model.varied())) {
            (Ok(fine), Ok(coarse)) => {
                let found = join(fine, coarse)?;
                let reached = estimate(&found);
                if reached.relative_error() <= asked {
                    return Ok(found);
                }
                if best.is_none_or(|best| reached.relative_error() < best.relative_error()) {
                    best = Some(reached);
                }
                if rounding > asked {
                    break;
                }
                target *= FINER;
            }
            // Rounding made the fine space degenerate: a coarser one may be good enough.
            (Err(Error::NotPositiveDefinite { .. }), _) | (_, Err(Error::NotPositiveDefinite { .. })) => {
                target *= COARSER;
            }
            (Err(error), _) | (_, Err(error)) => return Err(error),
        }
    }
    let why = "rounding of the Gram matrices, which grows for short zones and small orders";
    Err(Error::best_of("Poincare constant", asked, best, why))
}
