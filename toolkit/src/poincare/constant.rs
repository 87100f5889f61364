//! The constant γ_θ(ν) of Lemma 5.2 for every order, zone and condition, with bounds and extremal function.

use super::continuation::Continuation;
use super::discrete::{Constraint, Discrete};
use super::extremal::ExtremalFunction;
use super::mesh::{MeshModel, SHORTEST_RADIUS};
use super::rounding::rounding;
use super::zone::{Condition, Zone};
use super::zones::Zones;
use crate::FractionalOrder;
use crate::error::{Error, Given, Result};
use crate::estimate::{Estimate, Tolerance, Work};

/// How often the space is refined when the two spaces still differ too much.
const REFINEMENTS: usize = 3;

/// Factors for the accuracy a mesh is made for: when it was not reached, and when it was too much for f64.
const FINER: f64 = 0.02;
const COARSER: f64 = 4.0;

/// γ_θ(ν) = sup ‖u‖₀ / |u|_ν over the functions that satisfy `condition` on `zone`, an interval or a union of
/// intervals.
///
/// # Method
///
/// γ = sup ‖u‖₀ / |u|_ν over u ∈ H^ν(0,1) with ∫_E u = 0 (or u = 0 on E). γ² is the largest eigenvalue of the
/// pencil (‖·‖₀², |·|_ν²) on the slope space of `slopes`, on the mesh of `mesh`; the space is conforming, so
/// every value is a lower bound up to rounding. The error estimate compares two spaces of different shape;
/// their difference is mostly the error of the coarser one. Cost: a few hundred unknowns, whatever θ.
///
/// ```
/// use fractional_sobolev::{FractionalOrder, Tolerance, poincare::{Condition, Zone, gamma}};
/// let whole = gamma(FractionalOrder::HALF, Zone::end(1.0)?, Condition::MeanZero, Tolerance::balanced())?;
/// let small = gamma(FractionalOrder::HALF, Zone::end(1e-9)?, Condition::MeanZero, Tolerance::balanced())?;
/// assert!((whole.value - 0.291_564_029).abs() < 1e-8 && small.value > 1.5);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// [`Error::OutOfRange`] when the condition leaves only u = 0 (vanishing on the whole interval);
/// [`Error::ToleranceNotMet`] when rounding (about 2e-13, up to 5e-11 for very short zones inside; for
/// several intervals far apart, of lengths up to θ, also 4e-15 θ^(2ν−1) below one half) forbids the
/// tolerance.
#[doc(alias("Poincare constant", "Poincaré constant", "Poincare inequality", "Friedrichs"))]
pub fn gamma(
    order: impl Given<FractionalOrder>,
    zone: impl Into<Zones>,
    condition: Condition,
    tolerance: impl Given<Tolerance>,
) -> Result<Estimate> {
    let (order, tolerance) = (order.given()?, tolerance.given()?);
    let constraint = constraint(&zone.into(), condition)?;
    continued(order, &constraint, tolerance, |order, tolerance| {
        refine_until(order, &constraint, tolerance, |model| quotient(order, &constraint, model))
    })
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

/// γ₀(ν) = sup ‖u‖₀ / |u|_ν over the functions that vanish at the point `a` of \[0,1\], ν > 1/2 (Remark 6).
///
/// ```
/// use fractional_sobolev::{FractionalOrder, Tolerance, poincare::gamma_at_point};
/// let order = FractionalOrder::new(0.75)?;
/// let [end, middle] = [0.0, 0.5].map(|a| gamma_at_point(order, a, Tolerance::fast()));
/// assert!(middle?.value < end?.value);
/// assert!(gamma_at_point(FractionalOrder::HALF, 0.0, Tolerance::fast()).is_err());
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// [`Error::OutOfRange`] for ν ≤ 1/2, where points have no trace, or a point outside;
/// [`Error::ToleranceNotMet`] as for [`gamma`], and when ν is so close to 1/2 that the constant is decided
/// below r = 1e-290.
pub fn gamma_at_point(
    order: impl Given<FractionalOrder>,
    a: f64,
    tolerance: impl Given<Tolerance>,
) -> Result<Estimate> {
    let (order, tolerance) = (order.given()?, tolerance.given()?);
    Error::require("nu", order.value(), "(1/2, 1)", order.offset() > 0.0)?;
    let inside = a == 0.0 || (1e-300..=1.0).contains(&a);
    let a = Error::require("point", a, "{0} or [1e-300, 1]", inside)?;
    let reached = SHORTEST_RADIUS.powf(2.0 * order.offset());
    if reached > tolerance.relative() {
        let why = "so near to order 1/2 it is decided nearer to the point than binary64 reaches";
        return Err(Error::out_of_reach("Poincare constant", tolerance.relative(), reached, why));
    }
    let constraint = Constraint::at_point(a);
    refine_until(order, &constraint, tolerance, |model| quotient(order, &constraint, model))
}

/// γ₁(ν): mean zero over the whole interval. 1/2 as ν → 0, √(1−ν)/π as ν → 1.
///
/// ```
/// use fractional_sobolev::{FractionalOrder, Tolerance, poincare::gamma_whole};
/// let near_one = FractionalOrder::new(1.0 - 1e-9)?;
/// let found = gamma_whole(near_one, Tolerance::balanced())?.value / near_one.complement().sqrt();
/// assert!((found - std::f64::consts::FRAC_1_PI).abs() < 1e-6);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// [`Error::ToleranceNotMet`] as for [`gamma`].
#[doc(alias("Poincare constant", "Poincare-Wirtinger"))]
pub fn gamma_whole(order: impl Given<FractionalOrder>, tolerance: impl Given<Tolerance>) -> Result<Estimate> {
    let (order, tolerance) = (order.given()?, tolerance.given()?);
    gamma(order, Zone::end(1.0)?, Condition::MeanZero, tolerance)
}

/// γ with a function for which it is attained: of the space on which the value was found, or continued from
/// larger orders as the value is.
///
/// ```
/// use fractional_sobolev::{FractionalOrder, Tolerance, poincare::{Condition, Zone, extremal}};
/// let zone = Zone::end(0.01)?;
/// let (gamma, u) = extremal(FractionalOrder::HALF, zone, Condition::Vanishing, Tolerance::fast())?;
/// assert!(u.value(0.005).abs() < 1e-12 && u.value(1.0) > 1.0 && gamma.value > 0.3);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// As for [`gamma`].
#[doc(alias("eigenfunction", "minimiser"))]
pub fn extremal(
    order: impl Given<FractionalOrder>,
    zone: impl Into<Zones>,
    condition: Condition,
    tolerance: impl Given<Tolerance>,
) -> Result<(Estimate, ExtremalFunction)> {
    let (order, tolerance) = (order.given()?, tolerance.given()?);
    let constraint = constraint(&zone.into(), condition)?;
    let direct = |order, tolerance| attained(order, &constraint, tolerance);
    match (direct(order, tolerance), Continuation::to(order, constraint.shortest(), tolerance)) {
        (Err(Error::ToleranceNotMet { .. }), Some(larger)) => {
            let (values, functions): (Vec<_>, Vec<_>) = larger.at_points(direct)?.into_iter().unzip();
            let function = ExtremalFunction::combined(&larger.all_weights(), functions);
            Ok((larger.value(&values)?, function))
        }
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

pub(super) fn constraint(zones: &Zones, condition: Condition) -> Result<Constraint> {
    let constraint = Constraint::on_zones(zones, condition);
    if condition == Condition::Vanishing {
        let theta = zones.length();
        Error::require("theta", theta, "(0, 1) for a vanishing function", !constraint.is_whole())?;
    }
    Ok(constraint)
}

fn quotient(order: FractionalOrder, constraint: &Constraint, model: &MeshModel) -> Result<(f64, Work)> {
    let mut discrete = Discrete::new(order, constraint, model)?;
    let (value, _) = discrete.largest_quotient()?;
    Ok((value, discrete.work))
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
