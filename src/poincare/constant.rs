//! The constant γ_θ(ν) of Lemma 5.2 for every order, zone and condition.
//!
//! γ = sup ‖u‖₀ / |u|_ν over u ∈ H^ν(0,1) with ∫_E u = 0 (or u = 0 on E). γ² is the largest eigenvalue of the pencil (‖·‖₀², |·|_ν²) on
//! the slope space of `slopes`, on the mesh of `mesh`; a conforming space, so every value is a lower bound up to rounding.
//! The error estimate compares two spaces of different shape; their difference is mostly the error of the coarser one.
//! Cost: a few hundred unknowns, whatever θ.

use super::mesh::{MeshModel, PANEL_SPREAD};
use super::slopes::gram::seminorm_gram;
use super::slopes::mass::{Primitives, mass_gram};
use super::slopes::pencil::largest_eigenvalue;
use super::slopes::space::SlopeSpace;
use super::zone::{Condition, Zone};
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance, Work};
use crate::sobolev::FractionalOrder;

/// Relative error of assembly, factorization and quotient: 1e-13 was the worst seen where the space is exact.
const ROUNDING: f64 = 2e-13;

/// How often the space is refined when the two spaces still differ too much.
const REFINEMENTS: usize = 3;

/// γ_θ(ν) = sup ‖u‖₀ / |u|_ν over the functions that satisfy `condition` on `zone`.
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
    if condition == Condition::Vanishing {
        let theta = zone.length();
        Error::require("theta", theta, "(0, 1) for a vanishing function", zone.start() + zone.rest() > 0.0)?;
    }
    refine_until(tolerance, |target| {
        largest_quotient(order, [zone.start(), zone.length(), zone.rest()], condition, target)
    })
}

/// γ₀(ν) = sup ‖u‖₀ / |u|_ν over the functions that vanish at the point `a` of \[0,1\], ν > 1/2 (Remark 6).
///
/// # Errors
/// [`Error::OutOfRange`] for ν ≤ 1/2, where points have no trace, or a point outside; [`Error::ToleranceNotMet`] as for [`gamma`].
pub fn gamma_at_point(order: FractionalOrder, a: f64, tolerance: Tolerance) -> Result<Estimate> {
    Error::require("nu", order.value(), "(1/2, 1)", order.offset() > 0.0)?;
    let inside = a == 0.0 || (1e-300..=1.0).contains(&a);
    let a = Error::require("point", a, "{0} or [1e-300, 1]", inside)?;
    refine_until(tolerance, |target| largest_quotient(order, [a, 0.0, 1.0 - a], Condition::Vanishing, target))
}

/// Two lower bounds of the same number, from a finer and from a coarser space.
struct Bounds {
    fine: f64,
    coarse: f64,
    work: Work,
}

fn refine_until(tolerance: Tolerance, solve: impl Fn(f64) -> Result<Bounds>) -> Result<Estimate> {
    let mut work = Work::default();
    let mut target = tolerance.relative();
    let mut reached = f64::INFINITY;
    for _ in 0..=REFINEMENTS {
        let bounds = solve(target)?;
        work += bounds.work;
        let value = bounds.fine.max(bounds.coarse);
        let error = (bounds.fine - bounds.coarse).abs() + ROUNDING * value;
        reached = error / value;
        if reached <= tolerance.relative() {
            return Estimate::new(value, error, work);
        }
        target *= 0.02;
    }
    Err(Error::ToleranceNotMet { what: "Poincare constant", asked: tolerance.relative(), reached })
}

/// γ for the three lengths before, on and after the zone, on two spaces for a relative error of about `target`.
fn largest_quotient(
    order: FractionalOrder,
    lengths: [f64; 3],
    condition: Condition,
    target: f64,
) -> Result<Bounds> {
    let model = MeshModel::new(order, target);
    let (fine, work) = lower_bound(order, lengths, condition, &model)?;
    let (coarse, more) = lower_bound(order, lengths, condition, &model.varied())?;
    Ok(Bounds { fine, coarse, work: work + more })
}

/// The largest quotient ‖u‖₀/|u|_ν on the space of one mesh model.
fn lower_bound(
    order: FractionalOrder,
    lengths: [f64; 3],
    condition: Condition,
    model: &MeshModel,
) -> Result<(f64, Work)> {
    let shortest = lengths.into_iter().filter(|&l| l > 0.0).fold(1.0, f64::min);
    // Lengths between 1e-150 and 1e150 instead of 1e-300 and 1
    let unit = shortest.sqrt();
    let (cells, range) = model.cells(lengths.map(|l| l / unit), condition == Condition::Vanishing);
    let space = SlopeSpace::new(cells, PANEL_SPREAD);
    let (gram, mut work) = seminorm_gram(&space, order, model.points())?;
    let primitives = Primitives::new(&space, &range, model.points() + 4)?;
    let (square, _) = largest_eigenvalue(&gram, &mass_gram(&space, &primitives))?;
    work.factorizations += 2;
    // γ² scales like ℓ^{2ν} and the mass matrix is divided by ℓ, the length 1/unit of the interval
    Ok((square.sqrt() * unit.powf(order.offset()), work))
}
