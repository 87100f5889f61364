//! Suprema over conforming spaces: two spaces of different shape are refined until they agree to the tolerance;
//! for small orders, where all digits cancel, the result is extrapolated from larger ones.

use super::constraint::Constraint;
use super::continuation::Continuation;
use super::discrete::Discrete;
use super::extremal::SlopeSum;
use super::mesh::MeshModel;
use super::rounding::rounding;
use crate::Order;
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance, Work};
use std::sync::Arc;

/// Largest number of refinements if the two spaces still differ too much.
const REFINEMENTS: usize = 3;

/// Factors for the accuracy of the mesh: if it was not reached, and if it exceeded the range of f64.
const FINER: f64 = 0.02;
const COARSER: f64 = 4.0;

/// The constant γ, a function that attains it, and the two spaces on which it was computed.
#[derive(Debug, Clone)]
pub(super) struct Attained {
    pub(super) constant: Estimate,
    pub(super) function: SlopeSum,
    /// `None` if γ is extrapolated from larger orders.
    pub(super) spaces: Option<Arc<[Discrete; 2]>>,
}

/// The constant γ with a function that attains it.
pub(super) fn attained(
    order: Order,
    constraint: &Constraint,
    tolerance: Tolerance,
) -> Result<Attained> {
    let direct = |order, tolerance| on_two_spaces(order, constraint, tolerance);
    continued(order, constraint, tolerance, direct, |larger| {
        let at = |order, tolerance| {
            direct(order, tolerance).map(|found| (found.constant, found.function))
        };
        let (values, functions): (Vec<_>, Vec<_>) = larger.at_points(at)?.into_iter().unzip();
        let function = SlopeSum::combined(&larger.all_weights(), functions);
        Ok(Attained { constant: larger.value(&values)?, function, spaces: None })
    })
}

/// The result of `direct`; for small orders, where all digits cancel, its extrapolation from larger ones.
fn continued<R>(
    order: Order,
    constraint: &Constraint,
    tolerance: Tolerance,
    direct: impl Fn(Order, Tolerance) -> Result<R>,
    extrapolated: impl Fn(&Continuation) -> Result<R>,
) -> Result<R> {
    let Some(larger) = Continuation::to(order, constraint.shortest(), tolerance) else {
        return direct(order, tolerance);
    };
    if rounding(order, constraint) <= tolerance.relative() {
        match direct(order, tolerance) {
            Err(Error::ToleranceNotMet { .. }) => {}
            found => return found,
        }
    }
    extrapolated(&larger)
}

/// The constant γ and its function, both from the same one of the two spaces that are compared.
fn on_two_spaces(order: Order, constraint: &Constraint, tolerance: Tolerance) -> Result<Attained> {
    let rounding = rounding(order, constraint);
    let solve = |model: &MeshModel| -> Result<(f64, SlopeSum, Discrete)> {
        let mut discrete = Discrete::new(order, constraint, model)?;
        let (value, coefficients) = discrete.largest_quotient()?;
        Ok((value, SlopeSum::new(&discrete, coefficients), discrete))
    };
    type Solved = (f64, SlopeSum, Discrete);
    let join = |fine: Solved, coarse: Solved| {
        let (apart, work) = ((fine.0 - coarse.0).abs(), fine.2.work + coarse.2.work);
        let (value, function) =
            if fine.0 >= coarse.0 { (fine.0, fine.1) } else { (coarse.0, coarse.1) };
        let constant = Estimate::new(value, apart + rounding * value, work)?;
        Ok(Attained { constant, function, spaces: Some(Arc::new([fine.2, coarse.2])) })
    };
    refine(order, rounding, tolerance, solve, join, |found| found.constant)
}

/// A supremum over spaces, computed on two spaces that are refined until their difference meets the
/// tolerance; for small orders its extrapolation from larger ones.
pub(super) fn supremum(
    order: Order,
    constraint: &Constraint,
    tolerance: Tolerance,
    solve: impl Fn(Order, &MeshModel) -> Result<(f64, Work)> + Sync,
) -> Result<Estimate> {
    let direct = |order, tolerance| {
        let rounding = rounding(order, constraint);
        let join = |fine: (f64, Work), coarse: (f64, Work)| {
            let value = fine.0.max(coarse.0);
            Estimate::new(value, (fine.0 - coarse.0).abs() + rounding * value, fine.1 + coarse.1)
        };
        refine(order, rounding, tolerance, |model| solve(order, model), join, |found| *found)
    };
    let extrapolated = |larger: &Continuation| larger.value(&larger.at_points(direct)?);
    continued(order, constraint, tolerance, direct, extrapolated)
}

/// The combined result from two spaces, refined until its relative error meets the tolerance.
fn refine<T: Send, R>(
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
            (Err(Error::NotPositiveDefinite { .. }), _)
            | (_, Err(Error::NotPositiveDefinite { .. })) => {
                target *= COARSER;
            }
            (Err(error), _) | (_, Err(error)) => return Err(error),
        }
    }
    let why = "rounding of the Gram matrices, which grows for short zones and small orders, limits the accuracy";
    Err(Error::best_of("Poincare constant", asked, best, why))
}
