//! Moments of functions that vanish on a zone at one end: M = sup ∫ m(x) w(x) dx / |w|_ν.

use super::strong_form::strong_bounds;
use super::weight::Moment;
use crate::Order;
use crate::constant::{BestConstant, Extremal};
use crate::error::{Error, Given, Result};
use crate::estimate::Tolerance;
use crate::poincare::constraint::{Condition, Constraint};
use crate::poincare::discrete::Discrete;
use crate::poincare::extremal::SlopeSum;
use crate::poincare::mesh::MeshModel;
use crate::poincare::slopes::space::{SlopeSpace, legendre_primitives};
use crate::poincare::spaces::supremum;
use crate::poincare::zones::Zones;
use crate::quadrature::Rule;

/// The moment M = sup ∫ m w / |w|_s over the functions w that vanish on a zone at one end of (0,1).
///
/// x is the distance from the free end, e the length of the complement of the zone, and m is 1, x or e − x
/// ([`Moment`]). The zone is a range at either end: `e..1.0` represents a short length e to full relative
/// accuracy, `0.0..z` a short zone.
///
/// # Method
///
/// M² = ∫ m w for the function w with (w, v)_s = ∫ m v for all such v, (·, ·)_s the inner product of |·|_s,
/// by one linear solve on the spaces of [`gamma`](crate::gamma). The space is conforming, so that every value
/// is a lower bound up to rounding, and the error of M² is the square of the approximation error in |·|_s;
/// the error estimate compares two spaces, as for `gamma`.
///
/// As s → 1, |w|²_s (1 − s) → ‖w'‖²: M/√(1−s) → √(e³/3), √(e⁵/20), √(2e⁵/15). Of all zones of a given length
/// the zone at an end has the largest moment for m = 1 (by rearrangement). Cost: one factorization for a few
/// hundred unknowns, and another one for the extremal function.
///
/// **Bounds** ([`BestConstant::bounded`]) from the strong form of the equation for w, computed independently of the
/// Gram matrices: on the complement of the zone, scaled to (0, 1), the squared seminorm is (v, Av) with an integral
/// operator A, and k(x) = ∫ |x−t|^{−1−2s} dt over the scaled zone; for every v, with the residual r = m − A v,
/// ∫(m + r) v ≤ M² ≤ ∫(m + r) v + ½ ∫ r²/k. v is the least squares solution of r = 0. The gap between the bounds is
/// 1e-15 to 3e-9 of M in experiments. Cost: a million evaluations of basis functions for each s; those for the last s
/// are cached. [`Error::OutOfRange`] for s outside [1e-3, 1 − 1e-3], and unless the length of the complement lies in
/// [0.01, 0.99].
///
/// ```
/// use fractional_sobolev::{Moment, moment};
/// let found = moment(0.5, 0.5..1.0, Moment::Mass, 1e-9)?;
/// // M² at e = 1/2, computed independently with forty digits
/// let exact = 0.051_868_428_388_348_907f64.sqrt();
/// assert!((found.constant.value / exact - 1.0).abs() < 1e-9);
/// // the bounds of the strong form enclose it
/// let (lower, upper) = (found.bounded()?.lower.value, found.bounded()?.upper.map_or(f64::NAN, |m| m.value));
/// assert!(lower <= exact && exact <= upper && upper < (1.0 + 1e-8) * lower);
/// // the function that attains it
/// let w = moment(0.5, 0.0..0.5, Moment::Mass, 1e-3)?.extremal()?;
/// assert!(w.value(&[0.25]).abs() < 1e-12 && w.value(&[1.0]).abs() > 0.0);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// ```
/// use fractional_sobolev::{Moment, moment};
/// let [mass, first] = [Moment::Mass, Moment::FromFreeEnd].map(|m| moment(0.5, 0.5..1.0, m, 1e-8));
/// assert!(first?.constant.value < 0.5 * mass?.constant.value);
/// // the same zone at the other end
/// let [left, right] = [0.0..0.25, 0.75..1.0].map(|zone| moment(0.5, zone, Moment::Mass, 1e-8));
/// assert!((left?.constant.value / right?.constant.value - 1.0).abs() < 1e-8);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// [`Error::Incompatible`] unless the zone is one interval with an end at 0 or 1; [`Error::OutOfRange`] unless the
/// lengths of the zone and of its complement lie in [1e-300, 1 − 1e-15]; [`Error::ToleranceNotMet`] as for
/// [`gamma`](crate::gamma).
pub fn moment(
    s: impl Given<Order>,
    zone: impl Given<Zones>,
    moment: Moment,
    tolerance: impl Given<Tolerance>,
) -> Result<BestConstant> {
    let (order, zones, tolerance) = (s.given()?, zone.given()?, tolerance.given()?);
    let Some((zone, length, at_right)) = zones.at_one_end() else {
        let (what, given, with) = ("zone", zones.to_string(), "moments");
        return Err(Error::Incompatible {
            what,
            given,
            with,
            expected: "one interval with an end at 0 or 1",
        });
    };
    // The end from which the other length is known is given exactly.
    let (name, given) =
        if at_right { ("length of the complement", length) } else { ("length of the zone", zone) };
    let admissible = (SHORTEST..=LONGEST).contains(&given);
    Error::require(name, given, "[1e-300, 1 - 1e-15]", admissible)?;
    let place = Place { zone, length, at_right };
    let constraint = place.constraint();
    let constant = supremum(order, &constraint, tolerance, |order, model| {
        let discrete = Discrete::new(order, &constraint, model)?;
        let (value, _) = solve(&discrete, moment, model)?;
        Ok((value, discrete.work))
    })?;
    Ok(BestConstant::new(constant, constant, None)
        .with_extremal_by(move || extremal(order, &place, moment, tolerance))
        .with_bounds_by(move || strong_bounds(order, place.length, moment)))
}

/// The length of a zone at one end, the length of its complement, and whether that end is 1.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Place {
    zone: f64,
    length: f64,
    at_right: bool,
}

impl Place {
    /// The constraint that functions vanish on (0, `zone`), with the zone at the left end.
    fn constraint(&self) -> Constraint {
        Constraint {
            parts: vec![self.zone, self.length],
            zones: vec![0],
            condition: Condition::Vanishing,
        }
    }
}

/// The function w with |w|_s = 1 that attains the moment, to the requested tolerance.
fn extremal(order: Order, place: &Place, moment: Moment, tolerance: Tolerance) -> Result<Extremal> {
    let model = MeshModel::new(order, tolerance.relative());
    let discrete = Discrete::new(order, &place.constraint(), &model)?;
    let (_, coefficients) = solve(&discrete, moment, &model)?;
    let found = SlopeSum::new(&discrete, coefficients);
    Ok(Extremal::on_interval(if place.at_right { found.mirrored() } else { found }))
}

/// Lengths that are represented to full relative accuracy, with a complement of positive length.
const SHORTEST: f64 = 1e-300;
const LONGEST: f64 = 1.0 - 1e-15;

/// M and the coefficients of its function with |w|_s = 1.
fn solve(discrete: &Discrete, moment: Moment, model: &MeshModel) -> Result<(f64, Vec<f64>)> {
    let load = load(&discrete.space, moment, model.points() + 4)?;
    let solution = discrete.factored.solve(&load);
    let norm = load.iter().zip(&solution).map(|(b, x)| b * x).sum::<f64>().sqrt();
    // Lengths are in units of `unit`: one for dx, one for m; `factor` is that of 1/|w|_ν.
    let lengths = discrete.unit.powi(1 + moment.degree());
    let coefficients = solution.iter().map(|x| x * discrete.factor / norm).collect();
    Ok((norm * discrete.factor * lengths, coefficients))
}

/// ∫ m φ for every function of a space whose first cell is the zone: φ is 0 to the left of its cell; to the
/// right of it, the step of the cell is 1 and the other functions are 0.
fn load(space: &SlopeSpace, moment: Moment, points: usize) -> Result<Vec<f64>> {
    let rule = Rule::gauss_legendre(points)?;
    let length: f64 = space.cells[1..].iter().map(|cell| cell.length).sum();
    let mut load = vec![0.0; space.dimension()];
    for (index, panel) in space.panels.iter().enumerate() {
        let (first, functions) = (space.first[panel.cell], space.cells[panel.cell].functions);
        for (t, w) in rule.iter().filter(|_| functions > 0) {
            let from_free_end = space.panel_right[index] + panel.right_distance(1.0 - t);
            let weight =
                w * panel.stretch(t) * moment.weight(from_free_end, length - from_free_end);
            let values = legendre_primitives(functions, panel.in_cell(t));
            load[first..first + functions]
                .iter_mut()
                .zip(values)
                .for_each(|(b, v)| *b += weight * v);
        }
    }
    for (cell, &right) in
        space.cell_right.iter().enumerate().filter(|(c, _)| space.cells[*c].functions > 0)
    {
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
    use crate::estimate::Estimate;
    use crate::poincare::mean::largest_mean;

    fn moment_norm(order: Order, length: f64, m: Moment, tolerance: Tolerance) -> Result<Estimate> {
        Ok(moment(order, length..1.0, m, tolerance)?.constant)
    }

    fn moment_norm_beside(
        order: Order,
        zone: f64,
        m: Moment,
        tolerance: Tolerance,
    ) -> Result<Estimate> {
        Ok(moment(order, 0.0..zone, m, tolerance)?.constant)
    }

    #[test]
    fn the_mass_is_the_dual_norm_of_the_mean() {
        for nu in [0.1, 0.5, 0.9] {
            for length in [1e-3, 0.3, 0.8] {
                let order = Order::new(nu).unwrap();
                let tolerance = Tolerance::balanced();
                let mass = moment_norm(order, length, Moment::Mass, tolerance).unwrap();
                let zone = Constraint::vanishing_on(0.0..1.0 - length).unwrap();
                let mean = largest_mean(order, &zone, tolerance).unwrap();
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
            let place = Place { zone: 1.0 - e, length: e, at_right: false };
            let w = extremal(order, &place, moment, tolerance).unwrap();
            let right =
                super::moment(order, e..1.0, moment, tolerance).unwrap().extremal().unwrap();
            assert!(
                [0.1, 0.5, 0.7]
                    .iter()
                    .all(|&x| (right.value(&[x]) - w.value(&[1.0 - x])).abs() < 1e-12)
            );
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
        let (mass, parts) =
            (0.7 * norm(Moment::Mass), [norm(Moment::FromFreeEnd), norm(Moment::FromZone)]);
        assert!(
            parts[0] < parts[1] && parts[1] < mass && mass < parts[0] + parts[1],
            "{mass} {parts:?}"
        );
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
