//! Moments of functions that vanish on a zone at one end: M(e) = sup ∫₀ᵉ m(x) w(x) dx / |w|_ν.

use crate::Order;
use crate::error::{Error, Given, Result};
use crate::estimate::{Estimate, Tolerance};
use crate::poincare::constraint::Constraint;
use crate::poincare::continuation::Continuation;
use crate::poincare::discrete::Discrete;
use crate::poincare::extremal::ExtremalFunction;
use crate::poincare::mesh::MeshModel;
use crate::poincare::slopes::space::{SlopeSpace, legendre_primitives};
use crate::poincare::spaces::refine_until;
use crate::poincare::zone::Condition;
use crate::quadrature::Rule;

/// The weight m of a moment; x is the distance from the free end, e − x that from the zone.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Moment {
    /// m = 1.
    Mass,
    /// m = x.
    FromFreeEnd,
    /// m = e − x.
    FromZone,
}

impl Moment {
    /// m for a distance from the free end and one from the zone.
    pub(super) fn weight(self, from_free_end: f64, from_zone: f64) -> f64 {
        match self {
            Moment::Mass => 1.0,
            Moment::FromFreeEnd => from_free_end,
            Moment::FromZone => from_zone,
        }
    }

    /// Power of a length in m.
    pub(super) fn degree(self) -> i32 {
        i32::from(self != Moment::Mass)
    }
}

/// M(e) = sup ∫ m w / |w|_ν over the w that vanish where the distance from the free end is more than e.
///
/// # Method
///
/// w ∈ H^ν(0,1) vanishes on (e, 1); x is the distance from the free end, and m is 1, x or e − x ([`Moment`]).
/// M² = ∫ m w for the w with (w, v)_ν = ∫ m v for all such v, one linear solve on the slope space of
/// `slopes`. The space is conforming, so that every value is a lower bound up to rounding, and so small only
/// by the square of what the space leaves of |w|_ν; the error estimate compares two spaces, as for
/// `gamma`.
///
/// As ν → 1, |w|²_ν (1 − ν) → ‖w'‖²: M/√(1−ν) → √(e³/3), √(e⁵/20), √(2e⁵/15). Of all zones of one length that
/// at an end is the worst for m = 1 (rearrangement). Cost: one factorization of a few hundred unknowns.
///
/// ```
/// use fractional_sobolev::{Order, Moment, moment_norm, Tolerance};
/// let [mass, first] = [Moment::Mass, Moment::FromFreeEnd]
///     .map(|moment| moment_norm(Order::HALF, 0.5, moment, Tolerance::balanced()));
/// assert!(first?.value < 0.5 * mass?.value);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// [`Error::OutOfRange`] unless 1e-300 ≤ e ≤ 1 − 1e-15; [`Error::ToleranceNotMet`] as for
/// [`crate::poincare::gamma`].
pub fn moment_norm(
    order: impl Given<Order>,
    length: f64,
    moment: Moment,
    tolerance: impl Given<Tolerance>,
) -> Result<Estimate> {
    let (order, tolerance) = (order.given()?, tolerance.given()?);
    on(order, &inside(length)?, moment, tolerance)
}

/// The same given the length of the zone in place of what it leaves, for zones down to 1e-300.
///
/// ```
/// use fractional_sobolev::{Order, Moment, moment_norm, moment_norm_beside, Tolerance};
/// let (order, asked) = (Order::HALF, Tolerance::balanced());
/// let left = moment_norm(order, 0.75, Moment::Mass, asked)?.value;
/// let zone = moment_norm_beside(order, 0.25, Moment::Mass, asked)?.value;
/// assert!((left / zone - 1.0).abs() < 1e-8);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// As for [`moment_norm`], with the zone's length in place of e.
pub fn moment_norm_beside(
    order: impl Given<Order>,
    zone: f64,
    moment: Moment,
    tolerance: impl Given<Tolerance>,
) -> Result<Estimate> {
    let (order, tolerance) = (order.given()?, tolerance.given()?);
    on(order, &beside(zone)?, moment, tolerance)
}

fn on(order: Order, constraint: &Constraint, moment: Moment, tolerance: Tolerance) -> Result<Estimate> {
    let direct = |order, tolerance| {
        refine_until(order, constraint, tolerance, |model| {
            let discrete = Discrete::new(order, constraint, model)?;
            let (value, _) = solve(&discrete, moment, model)?;
            Ok((value, discrete.work))
        })
    };
    match (direct(order, tolerance), Continuation::to(order, constraint.shortest(), tolerance)) {
        (Err(Error::ToleranceNotMet { .. }), Some(larger)) => larger.value(&larger.at_points(direct)?),
        (result, _) => result,
    }
}

/// The w with |w|_ν = 1 for which the moment is attained, as a function of the distance from the free end
/// subtracted from 1: it vanishes on (0, 1 − e). On a space for the tolerance asked for.
///
/// ```
/// use fractional_sobolev::{Order, Moment, moment_extremal, Tolerance};
/// let w = moment_extremal(Order::HALF, 0.5, Moment::Mass, Tolerance::fast())?;
/// assert!(w.value(0.25).abs() < 1e-12 && w.value(1.0).abs() > 0.0);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// As for [`moment_norm`].
pub fn moment_extremal(
    order: impl Given<Order>,
    length: f64,
    moment: Moment,
    tolerance: impl Given<Tolerance>,
) -> Result<ExtremalFunction> {
    let (order, tolerance) = (order.given()?, tolerance.given()?);
    let model = MeshModel::new(order, tolerance.relative());
    let discrete = Discrete::new(order, &inside(length)?, &model)?;
    let (_, coefficients) = solve(&discrete, moment, &model)?;
    Ok(ExtremalFunction::new(&discrete, coefficients))
}

/// Zero on (0, 1 − e), free at 1.
fn inside(length: f64) -> Result<Constraint> {
    let admissible = (SHORTEST..=LONGEST).contains(&length);
    Error::require("length", length, "[1e-300, 1 - 1e-15]", admissible)?;
    Ok(vanishing(vec![1.0 - length, length]))
}

/// Zero on (0, `zone`).
fn beside(zone: f64) -> Result<Constraint> {
    let admissible = (SHORTEST..=LONGEST).contains(&zone);
    Error::require("length of the zone", zone, "[1e-300, 1 - 1e-15]", admissible)?;
    Ok(vanishing(vec![zone, 1.0 - zone]))
}

fn vanishing(parts: Vec<f64>) -> Constraint {
    Constraint { parts, zones: vec![0], condition: Condition::Vanishing }
}

/// Lengths that keep their digits, and leave a part of positive length.
const SHORTEST: f64 = 1e-300;
const LONGEST: f64 = 1.0 - 1e-15;

/// M and the coefficients of its function, |w|_ν = 1.
fn solve(discrete: &Discrete, moment: Moment, model: &MeshModel) -> Result<(f64, Vec<f64>)> {
    let load = load(&discrete.space, moment, model.points() + 4)?;
    let solution = discrete.factored.solve(&load);
    let norm = load.iter().zip(&solution).map(|(b, x)| b * x).sum::<f64>().sqrt();
    // Lengths are in units of `unit`: one for dx, one for m; `factor` is that of 1/|w|_ν.
    let lengths = discrete.unit.powi(1 + moment.degree());
    let coefficients = solution.iter().map(|x| x * discrete.factor / norm).collect();
    Ok((norm * discrete.factor * lengths, coefficients))
}

/// ∫ m φ for every function of a space whose first cell is the zone: φ is 0 left of its cell, and right of it
/// 1 for the step of the cell, 0 for the others.
fn load(space: &SlopeSpace, moment: Moment, points: usize) -> Result<Vec<f64>> {
    let rule = Rule::gauss_legendre(points)?;
    let length: f64 = space.cells[1..].iter().map(|cell| cell.length).sum();
    let mut load = vec![0.0; space.dimension()];
    for (index, panel) in space.panels.iter().enumerate() {
        let (first, functions) = (space.first[panel.cell], space.cells[panel.cell].functions);
        for (t, w) in rule.iter().filter(|_| functions > 0) {
            let from_free_end = space.panel_right[index] + panel.right_distance(1.0 - t);
            let weight = w * panel.stretch(t) * moment.weight(from_free_end, length - from_free_end);
            let values = legendre_primitives(functions, panel.in_cell(t));
            load[first..first + functions].iter_mut().zip(values).for_each(|(b, v)| *b += weight * v);
        }
    }
    for (cell, &right) in space.cell_right.iter().enumerate().filter(|(c, _)| space.cells[*c].functions > 0) {
        load[space.first[cell]] += match moment {
            Moment::Mass => right,
            Moment::FromFreeEnd => 0.5 * right * right,
            Moment::FromZone => right * (length - 0.5 * right),
        };
    }
    Ok(load)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::poincare::{Zone, largest_mean};

    #[test]
    fn the_mass_is_the_dual_norm_of_the_mean() {
        for nu in [0.1, 0.5, 0.9] {
            for length in [1e-3, 0.3, 0.8] {
                let order = Order::new(nu).unwrap();
                let tolerance = Tolerance::balanced();
                let mass = moment_norm(order, length, Moment::Mass, tolerance).unwrap();
                let zone = Zone::end(1.0 - length).unwrap();
                let mean = largest_mean(order, Constraint::vanishing_on(zone), tolerance).unwrap();
                let apart = (mass.value - mean.value).abs();
                assert!(apart <= mass.error + mean.error, "{nu} {length}: {mass} {mean}");
            }
        }
    }

    #[test]
    fn near_order_one_the_moments_are_those_of_the_slope() {
        // (1-ν)|w|² = ∫w'² + O(1-ν), so that M/√(1-ν) is off by O(1-ν).
        let order = Order::half_plus(0.5 - 1e-6).unwrap();
        let e: f64 = 0.4;
        let limits = [
            (Moment::Mass, (e.powi(3) / 3.0).sqrt()),
            (Moment::FromFreeEnd, (e.powi(5) / 20.0).sqrt()),
            (Moment::FromZone, (2.0 * e.powi(5) / 15.0).sqrt()),
        ];
        for (moment, limit) in limits {
            let found = moment_norm(order, e, moment, Tolerance::balanced()).unwrap().value / 1e-3;
            assert!((found / limit - 1.0).abs() < 1e-5, "{moment:?}: {found} {limit}");
        }
    }

    #[test]
    fn the_extremal_function_has_its_moment() {
        let (order, e) = (Order::new(0.3).unwrap(), 0.6);
        let tolerance = Tolerance::balanced();
        for (moment, weight) in [
            (Moment::Mass, [1.0, 0.0]),
            (Moment::FromFreeEnd, [1.0, -1.0]),
            (Moment::FromZone, [e - 1.0, 1.0]),
        ] {
            let norm = moment_norm(order, e, moment, tolerance).unwrap();
            let w = moment_extremal(order, e, moment, tolerance).unwrap();
            let u = w.interpolate(3, 4, &[1.0 - e]).unwrap();
            let seminorm = u.seminorm(order, tolerance).unwrap().value;
            assert!((seminorm - 1.0).abs() < 1e-4, "{moment:?}: {seminorm}");
            let profile = w.profile(64);
            let sum: f64 = profile
                .windows(2)
                .map(|p| {
                    let (x, value) = (0.5 * (p[0].0 + p[1].0), 0.5 * (p[0].1 + p[1].1));
                    (p[1].0 - p[0].0) * value * (weight[0] + weight[1] * x)
                })
                .sum();
            assert!((sum / norm.value - 1.0).abs() < 1e-3, "{moment:?}: {sum} {norm}");
        }
    }

    #[test]
    fn moments_add_up_and_bad_lengths_are_refused() {
        // A supremum: M of x + (e − x) = e is at most the sum.
        let order = Order::HALF;
        let norm = |moment| moment_norm(order, 0.7, moment, Tolerance::balanced()).unwrap().value;
        let (mass, parts) = (0.7 * norm(Moment::Mass), [norm(Moment::FromFreeEnd), norm(Moment::FromZone)]);
        assert!(parts[0] < parts[1] && parts[1] < mass && mass < parts[0] + parts[1], "{mass} {parts:?}");
        for length in [0.0, 1.0, f64::NAN] {
            assert!(moment_norm(order, length, Moment::Mass, Tolerance::fast()).is_err());
            assert!(moment_norm_beside(order, length, Moment::Mass, Tolerance::fast()).is_err());
        }
        let [a, b] = [
            moment_norm(order, 0.25, Moment::Mass, Tolerance::balanced()),
            moment_norm_beside(order, 0.75, Moment::Mass, Tolerance::balanced()),
        ];
        assert_eq!(a.unwrap(), b.unwrap());
    }
}
