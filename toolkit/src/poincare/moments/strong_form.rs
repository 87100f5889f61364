//! Lower and upper bounds for moments of functions that vanish on a zone, from the strong form of their
//! equation, independently of the Gram matrices of `moment`.

use super::strong_basis::{BASIS, Collocation, LEFT, collocate};
use super::weight::Moment;
use crate::Order;
use crate::error::{Error, Result};
use crate::numeric::last::Last;
use crate::poincare::slopes::kernel::exp_quotient;

/// Columns whose norm falls below this fraction when they are orthogonalised count as combinations of the
/// previous ones; then v has nine correct digits, and the bounds, which are stationary in v, have the full
/// accuracy of the rules.
const DEPENDENT: f64 = 1e-7;
/// Error of the integrals, relative to M²: rules with two more points change them by at most 2e-12.
const QUADRATURE: f64 = 1e-10;

/// Cache of the last strong form.
static LAST: Last<StrongForm> = Last::none();

/// Lower and upper bound of sup ∫ m w / |w|_ν over the functions w that vanish beyond the distance `length`
/// from the free end.
pub(super) fn strong_bounds(order: Order, length: f64, moment: Moment) -> Result<[f64; 2]> {
    LAST.get(|form| form.order == order, || StrongForm::new(order))?.moment(length, moment)
}

/// The strong form for one order, for all zones.
///
/// # Method
///
/// On the complement of the zone, scaled to (0, 1), with s the distance from the free end and the zone from 1
/// to 1/e, the seminorm is (v, Av) with
///
/// A v(s) = 2 [ PV ∫₀¹ (v(s) − v(t)) |s−t|^{−1−2ν} dt + k(s) v(s) ],
/// k(s) = ((1−s)^{−2ν} − (1/e−s)^{−2ν}) / (2ν).
///
/// M² = sup 2∫mw − |w|². With w = v + z and the residual r = m − A v this is ∫mv + ∫rv + sup 2∫rz − |z|², and
/// |z|² ≥ 2∫k z² (pairs with one point in the zone), so that **for every v**
///
/// ∫(m + r) v ≤ M² ≤ ∫(m + r) v + ½ ∫ r²/k.
///
/// v is the least squares solution of r = 0 in that weight over the functions of `strong_basis`.
///
/// The bounds hold up to the rounding and quadrature errors of these integrals, by which they are widened. The
/// gap between them is 1e-15 to 3e-9 of M in experiments (the latter at ν = 0.001, where the basis is nearly
/// dependent). Cost: a million evaluations of basis functions for each ν, for all e together.
struct StrongForm {
    order: Order,
    points: Vec<Collocation>,
}

impl StrongForm {
    /// The strong form for one order, with the values of A on the basis.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for ν outside [1e-3, 1 − 1e-3].
    fn new(order: Order) -> Result<Self> {
        let nu = order.value();
        let inside = (1e-3 - 1e-12..=1.0 - 1e-3 + 1e-12).contains(&nu);
        Error::require("nu", nu, "[0.001, 0.999]", inside)?;
        Ok(Self { order, points: collocate(nu, 2.0 * order.offset())? })
    }

    /// Bounds of sup ∫ m w / |w|_ν over the functions w that vanish beyond the distance `length` from the free
    /// end.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless 0.01 ≤ length ≤ 0.99.
    fn moment(&self, length: f64, moment: Moment) -> Result<[f64; 2]> {
        Error::require("length", length, "[0.01, 0.99]", (0.01..=0.99).contains(&length))?;
        let p = -2.0 * self.order.value();
        let end = 1.0 / length - 1.0;
        let (mut columns, mut fitted) = (Columns::default(), Fit::default());
        let weights: Vec<[f64; 3]> = self
            .points
            .iter()
            .map(|point| {
                let c = point.complement;
                let potential = exp_quotient(p, (end + c).ln()) - exp_quotient(p, c.ln());
                [potential, (point.weight / potential).sqrt(), moment.weight(point.s, c)]
            })
            .collect();
        for k in 0..BASIS {
            let value = |i: usize| self.points[i].values[k];
            let image = |i: usize| 2.0 * (self.points[i].images[k] + weights[i][0] * value(i));
            let rows = 0..self.points.len();
            columns.push(
                rows.clone().map(|i| image(i) * weights[i][1]).collect(),
                rows.map(value).collect(),
                if k == 0 { 1.0 } else { 0.0 },
            );
        }
        let target: Vec<f64> = weights.iter().map(|w| w[2] * w[1]).collect();
        columns.project(&target, &mut fitted);
        let (mut lower, mut gap) = (0.0, 0.0);
        for (i, point) in self.points.iter().enumerate() {
            let (m, residual) = (weights[i][2], fitted.residual[i] / weights[i][1]);
            lower += (m + residual) * fitted.values[i] * point.weight;
            gap += 0.5 * fitted.residual[i].powi(2);
        }
        // Left of the first panel v is its value at 0.
        let rest = (-f64::from(LEFT)).exp();
        lower += fitted.at_zero * rest * moment.weight(0.5 * rest, 1.0);
        let scale = length.powi(1 + 2 * moment.degree()) * length.powf(2.0 * self.order.value());
        let off = QUADRATURE * lower;
        Ok([((lower - off) * scale).sqrt(), ((lower + gap + off) * scale).sqrt()])
    }
}

/// Orthonormal columns of weighted images, with the values that belong to them.
#[derive(Default)]
struct Columns {
    images: Vec<Vec<f64>>,
    values: Vec<Vec<f64>>,
    at_zero: Vec<f64>,
}

/// v and the weighted residual.
#[derive(Default)]
struct Fit {
    values: Vec<f64>,
    residual: Vec<f64>,
    at_zero: f64,
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

fn subtract(a: &mut [f64], factor: f64, b: &[f64]) {
    a.iter_mut().zip(b).for_each(|(x, y)| *x -= factor * y);
}

impl Columns {
    /// Adds a column, orthogonalised twice by the Gram-Schmidt method.
    fn push(&mut self, mut image: Vec<f64>, mut value: Vec<f64>, mut at_zero: f64) {
        let size = dot(&image, &image).sqrt();
        for _ in 0..2 {
            for k in 0..self.images.len() {
                let share = dot(&image, &self.images[k]);
                subtract(&mut image, share, &self.images[k]);
                subtract(&mut value, share, &self.values[k]);
                at_zero -= share * self.at_zero[k];
            }
        }
        let left = dot(&image, &image).sqrt();
        if left > DEPENDENT * size {
            image.iter_mut().chain(value.iter_mut()).for_each(|x| *x /= left);
            self.images.push(image);
            self.values.push(value);
            self.at_zero.push(at_zero / left);
        }
    }

    fn project(&self, target: &[f64], fit: &mut Fit) {
        fit.residual = target.to_vec();
        fit.values = vec![0.0; target.len()];
        for k in 0..self.images.len() {
            let share = dot(&fit.residual, &self.images[k]);
            subtract(&mut fit.residual, share, &self.images[k]);
            subtract(&mut fit.values, -share, &self.values[k]);
            fit.at_zero += share * self.at_zero[k];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::poincare::moments::moment as weak_moment;

    const MOMENTS: [Moment; 3] = [Moment::Mass, Moment::FromFreeEnd, Moment::FromZone];

    #[test]
    fn both_computations_agree_to_nine_digits() {
        for nu in [0.001, 0.01, 0.1, 0.25, 0.4, 0.499, 0.5, 0.501, 0.6, 0.75, 0.9, 0.99, 0.999] {
            let order = Order::new(nu).unwrap();
            let strong = StrongForm::new(order).unwrap();
            for length in [0.2, 0.5, 0.8] {
                for moment in MOMENTS {
                    let [lower, upper] = strong.moment(length, moment).unwrap();
                    let weak = weak_moment(order, length..1.0, moment, 1e-9).unwrap().constant;
                    let (high, low) = (weak.value + weak.error, weak.value - weak.error);
                    assert!(
                        lower <= high && low <= upper,
                        "{nu} {length} {moment:?}: {lower} {upper} {weak}"
                    );
                    assert!(
                        upper / lower - 1.0 < 1e-8,
                        "{nu} {length} {moment:?}: {lower} {upper}"
                    );
                }
            }
        }
    }

    #[test]
    fn orders_and_lengths_beyond_the_domain_are_refused() {
        assert!(StrongForm::new(Order::new(1e-4).unwrap()).is_err());
        let strong = StrongForm::new(Order::HALF).unwrap();
        assert!(
            strong.moment(0.001, Moment::Mass).is_err()
                && strong.moment(1.0, Moment::Mass).is_err()
        );
    }
}
