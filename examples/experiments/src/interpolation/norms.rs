//! ‖e‖₀ and ‖e'‖₀ of the interpolation error e = u − I u from the slope v = u': e' = v − v̄, e(x) = ∫₀^x (v −
//! v̄).
//!
//! Of a piecewise polynomial on one element, by Gauss rules on its cells, and of a sample on all elements of
//! a mesh.

use super::panels::PanelRules;
use super::sample::SampleSlope;
use crate::ErrorExt;
use crate::sum::RunningSum;
use fractional_sobolev::gauss_legendre;
use fractional_sobolev::{Error, Result};
use fractional_sobolev::{Estimate, Tolerance, Work};
use fractional_sobolev::{Function, Mesh};

/// Relative rounding of the sums below: positive terms, each from a few operations on (v − v̄).
pub(super) const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// (‖e‖₀, ‖e'‖₀).
pub(super) fn error_norms(slope: &Function<'_>) -> Result<(Estimate, Estimate)> {
    let partition = slope.mesh()?;
    let mean = slope.mean(Tolerance::reference())?.value;
    let rule = gauss_legendre(slope.degree()? + 2)?;
    let total = partition.total();
    let (mut squares, mut error_squares, mut error, mut largest) = (0.0, 0.0, 0.0, 0.0f64);
    for (index, length) in partition.lengths().iter().enumerate() {
        // In units of this element: its third power must not underflow.
        let h = length / total;
        let deviation = |t: f64| slope.value(index, t).map(|v| v - mean);
        for (t, w) in rule.iter() {
            let d = deviation(t)?;
            squares += h * w * d * d;
            let mut inner = 0.0;
            for (s, v) in rule.iter() {
                inner += t * v * deviation(s * t)?;
            }
            error_squares += h * w * (error + h * inner).powi(2);
        }
        let mut rise = 0.0;
        for (s, v) in rule.iter() {
            rise += v * deviation(s)?;
        }
        error += h * rise;
        largest = largest.max(error.abs());
    }
    let work = Work { points: (partition.len() * rule.points().len().pow(2)) as u64, ..Work::default() };
    // The running value of e carries the rounding of the mean.
    let absolute = ROUNDING * (mean.abs() + largest);
    let (l2, derivative) = (error_squares.sqrt(), squares.sqrt());
    let root = total.sqrt();
    let estimate = |value: f64, rounding: f64, unit: f64| {
        Estimate::new(value * unit, (ROUNDING * value + rounding) * unit, work)
    };
    Ok((estimate(l2, absolute, root * total)?, estimate(derivative, ROUNDING * mean.abs(), root)?))
}

/// (‖e‖₀, ‖e'‖₀) on a mesh of (0, 1) for a slope in closed form.
///
/// # Errors
/// [`Error::OutOfRange`] unless the mesh is one of (0, 1).
pub(in crate::interpolation) fn sample_norms(
    slope: SampleSlope,
    mesh: &Mesh,
) -> Result<(Estimate, Estimate)> {
    slope.check()?;
    require_unit(mesh)?;
    let rules = PanelRules::new()?;
    let (mut error, mut slopes, mut points) = (RunningSum::default(), RunningSum::default(), 0);
    for (&left, &h) in mesh.from_left().iter().zip(mesh.lengths()) {
        let squares = slope.element_squares(left, h, &rules);
        error.add(squares.error);
        slopes.add(squares.slope);
        points += squares.points;
    }
    let estimate = |square: f64| {
        let value = square.sqrt();
        Estimate::new(value, ROUNDING * value, Work { points, ..Work::default() })
    };
    Ok((estimate(error.value())?, estimate(slopes.value())?))
}

/// The mesh is one of (0, 1).
pub(in crate::interpolation) fn require_unit(mesh: &Mesh) -> Result<()> {
    let total = mesh.total();
    let fits = mesh.nodes()[0] == 0.0 && (total - 1.0).abs() <= ROUNDING;
    Error::require("length of the mesh", total, "{1}, from 0", fits).map(|_| ())
}
