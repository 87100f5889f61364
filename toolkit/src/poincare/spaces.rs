//! Suprema over conforming spaces: two spaces of different shape, finer ones until they agree to the tolerance;
//! small orders that have no digits of their own are continued from larger ones.

use super::constraint::Constraint;
use super::continuation::Continuation;
use super::discrete::Discrete;
use super::extremal::ExtremalFunction;
use super::mesh::MeshModel;
use super::rounding::rounding;
use crate::Order;
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance, Work};

/// How often the space is refined when the two spaces still differ too much.
const REFINEMENTS: usize = 3;

/// Factors for the accuracy a mesh is made for: when it was not reached, and when it was too much for f64.
const FINER: f64 = 0.02;
const COARSER: f64 = 4.0;

/// γ with a function for which it is attained.
pub(super) fn constant_and_function(
    order: Order,
    constraint: &Constraint,
    tolerance: Tolerance,
) -> Result<(Estimate, ExtremalFunction)> {
    let direct = |order, tolerance| attained(order, constraint, tolerance);
    let larger = Continuation::to(order, constraint.shortest(), tolerance);
    let continued = |larger: &Continuation| {
        let (values, functions): (Vec<_>, Vec<_>) = larger.at_points(direct)?.into_iter().unzip();
        Ok((larger.value(&values)?, ExtremalFunction::combined(&larger.all_weights(), functions)))
    };
    let digits = rounding(order, constraint) <= tolerance.relative();
    match larger {
        Some(larger) if !digits => continued(&larger),
        Some(larger) => match direct(order, tolerance) {
            Err(Error::ToleranceNotMet { .. }) => continued(&larger),
            result => result,
        },
        None => direct(order, tolerance),
    }
}

/// What `direct` finds, at small orders that have no digits of their own what is continued from larger ones.
pub(super) fn continued(
    order: Order,
    constraint: &Constraint,
    tolerance: Tolerance,
    direct: impl Fn(Order, Tolerance) -> Result<Estimate> + Sync,
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
    order: Order,
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
    order: Order,
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
    order: Order,
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
