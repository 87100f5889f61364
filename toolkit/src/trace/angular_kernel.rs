//! The kernel |x−z|^{-2-2s}, multiplied by r^{s−1+iτ} and integrated over the radii.
//!
//! K_τ(a) = ∫_{−∞}^∞ cos(τu) (2cosh u − 2cos a)^{-1-s} du,
//! D_τ(a) = ∫_{−∞}^∞ (cosh((1−s)u) − cos(τu)) (2cosh u − 2cos a)^{-1-s} du, 0 < a ≤ π.
//!
//! With S = sin(a/2), sinh(u/2) = S sinh v: 2cosh u − 2cos a = 4S² cosh² v, and the trapezoidal rule in v
//! converges exponentially, uniformly in a. a^{1+2s} K and a^{2s−1} D are smooth in ln a: they are tabulated at
//! Chebyshev points of cells in ln a.

use crate::order::Order;
use std::f64::consts::PI;

/// Number of Chebyshev points of a cell, the ends of which have the ratio e^{WIDTH}.
const POINTS: usize = 16;
const WIDTH: f64 = 0.7;
/// Logarithm of the relative truncation error of the sums in v.
const NOTHING: f64 = 34.0;

/// Tables of K and D.
pub(super) struct AngularKernel {
    order: Order,
    /// ln of the smallest angle.
    start: f64,
    /// The positions of the points of a cell in (0, 1), and their barycentric weights.
    places: [(f64, f64); POINTS],
    /// (a^{1+2s} K, a^{2s−1} D), cell after cell.
    values: Vec<[f64; 2]>,
}

impl AngularKernel {
    /// The tables for angles between `smallest` and π.
    pub(super) fn new(order: Order, tau: f64, smallest: f64) -> Self {
        let start = smallest.ln();
        let cells = ((PI.ln() - start) / WIDTH).ceil() as usize;
        let places = std::array::from_fn(|i| {
            let angle = PI * (i as f64 + 0.5) / POINTS as f64;
            let sign = if i % 2 == 0 { 1.0 } else { -1.0 };
            (0.5 * (1.0 - angle.cos()), sign * angle.sin())
        });
        let width = (PI.ln() - start) / cells as f64;
        let at = |k: usize| {
            let a = (start + width * ((k / POINTS) as f64 + places[k % POINTS].0)).exp();
            scaled(order, tau, a.min(PI))
        };
        Self { order, start, places, values: (0..cells * POINTS).map(at).collect() }
    }

    /// (K, D) at the angle a.
    pub(super) fn at(&self, a: f64) -> [f64; 2] {
        let cells = self.values.len() / POINTS;
        let place = (a.ln() - self.start) / (PI.ln() - self.start) * cells as f64;
        let cell = (place.max(0.0) as usize).min(cells - 1);
        let x = place - cell as f64;
        let table = &self.values[cell * POINTS..(cell + 1) * POINTS];
        let (mut sums, mut total) = ([0.0; 2], 0.0);
        for (&(at, weight), value) in self.places.iter().zip(table) {
            let share = if x == at { 1e300 } else { weight / (x - at) };
            total += share;
            sums = [sums[0] + share * value[0], sums[1] + share * value[1]];
        }
        let s = self.order.value();
        let singular = a.powf(1.0 - 2.0 * s) / total;
        [sums[0] * singular / (a * a), sums[1] * singular]
    }
}

/// (a^{1+2s} K, a^{2s−1} D) at one angle.
fn scaled(order: Order, tau: f64, a: f64) -> [f64; 2] {
    let s = order.value();
    let sine = (0.5 * a).sin();
    let step = (PI * PI / (NOTHING + PI * tau)).min(0.25);
    let count = (((2.0 / sine).ln() + NOTHING / (4.0 * s)) / step).ceil() as usize;
    let (mut kernel, mut rest) = (0.0, 0.0);
    for k in (0..=count).rev() {
        let v = k as f64 * step;
        let height = sine * v.sinh();
        let u = 2.0 * height.asinh();
        let twice = if k == 0 { 1.0 } else { 2.0 };
        let weight = twice * step * v.cosh().powf(-1.0 - 2.0 * s) / height.hypot(1.0);
        kernel += weight * (tau * u).cos();
        let difference =
            (0.5 * order.complement() * u).sinh().powi(2) + (0.5 * tau * u).sin().powi(2);
        rest += 2.0 * weight * difference;
    }
    let scale = (0.5 * a / sine).powf(1.0 + 2.0 * s);
    [scale * kernel, scale * rest / (a * a)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_agree_with_sums_and_a_closed_form() {
        let order = Order::new(0.7).unwrap();
        for tau in [0.0, 3.0, 20.0] {
            let table = AngularKernel::new(order, tau, 1e-10);
            for a in [2e-10, 1e-3, 0.4, 1.3, 3.0, PI] {
                let ([k, d], [exact, rest]) = (table.at(a), scaled(order, tau, a));
                assert!(
                    (k * a.powf(2.4) - exact).abs() < 1e-10 * scaled(order, 0.0, a)[0],
                    "{tau} {a}"
                );
                assert!((d * a.powf(0.4) / rest - 1.0).abs() < 1e-10, "{tau} {a}");
            }
        }
        // a → 0: √π Γ(s+1/2)/Γ(s+1).
        let limit = PI.sqrt() * libm::tgamma(1.2) / libm::tgamma(1.7);
        assert!((scaled(order, 2.0, 1e-9)[0] - limit).abs() < 1e-13);
    }
}
