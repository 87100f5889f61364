//! Dual norms of the interpolation spaces by resolvents: exact to rounding on every mesh, O(N) per
//! resolvent.
//!
//! With A = -d²/dx² under the Neumann (cosines) or the Dirichlet condition (sines), Balakrishnan's formula is
//!   ⟨f, (1+A)^{-ν} f⟩ = (sin πν / π) ∫_0^∞ s^{-ν} ⟨f, (1+s+A)^{-1} f⟩ ds,
//! and the resolvent has Green's function in closed form: with τ² = 1 + s, E = e^{-τL} and a, b, d of
//! [`super::cells`],
//!   ⟨f, (τ²+A)^{-1} f⟩ = (d ± (a² + b² ± 2Eab)/(1 - E²)) / 2τ, + for Neumann, - for Dirichlet.
//! The trapezoidal rule with step η in y, s = e^y, has a relative error of at most 2 sin πν / sinh(2π²/η) for
//! every eigenvalue. ρ(τ) = τ² ⟨f, (τ²+A)^{-1} f⟩ tends to ρ(1) as s → 0 and is ∥f∥² - c/τ + ... as τ → ∞ (for
//! piecewise constants ∥f∥² - c/τ up to e^{-τh}): the infinite sums are geometric there.
//!
//! The mean is treated separately under the Neumann condition, where it is its own representer. On intervals
//! shorter than 1 the form of f at τL < 1 is computed from that of its primitive F with the other condition:
//! ⟨f, (τ²+A)^{-1} f⟩ = ∥F∥² - τ² ⟨F, (τ²+A')^{-1} F⟩ with F = 0 at both ends (Neumann, f with mean zero) or
//! with mean zero (Dirichlet). Cost: about a hundred passes over the elements, fewer for coarser tolerances.

use super::cells::{Cells, Run};
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance, Work};
use crate::numeric::parallel;
use crate::numeric::sum::RunningSum;
use crate::order::Order;
use crate::piecewise::PiecewisePolynomial;
use std::f64::consts::PI;

/// Values of τh from which e^{-τh} is negligible, and from which (τh)^{-2} is small.
const EXPONENTIAL: f64 = 40.0;
const POWER: f64 = 1e7;

/// The boundary conditions at the ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Ends {
    Neumann,
    Dirichlet,
}

impl Ends {
    /// (μ/2) (d ± (a² + b² ± 2Eab)/(1 - E²)) and its rounding error, μ = τL.
    fn form(self, mu: f64, run: Run) -> (f64, f64) {
        let (a, b, e) = (run.near, run.far, run.decay);
        let sign = if self == Self::Neumann { 1.0 } else { -1.0 };
        let rest = -(-2.0 * mu).exp_m1();
        let ends = (a * a + b * b + sign * 2.0 * e * a * b) / rest;
        let sizes =
            (a.abs() + e * b.abs()) * run.near_error + (b.abs() + e * a.abs()) * run.far_error;
        let rounding = run.form_error
            + 2.0 * sizes / rest
            + 4.0
                * f64::EPSILON
                * (run.form.abs() + (a * a + b * b + 2.0 * e * (a * b).abs()) / rest);
        (0.5 * mu * (run.form + sign * ends), 0.5 * mu * rounding)
    }

    fn other(self) -> Self {
        if self == Self::Neumann { Self::Dirichlet } else { Self::Neumann }
    }
}

/// The function f on (0, 1) with the data of its resolvent forms.
pub(super) struct Load {
    ends: Ends,
    /// L
    total: f64,
    cells: Cells,
    /// ∫ f²
    pub(super) square: f64,
    primitive: Option<(Cells, f64)>,
    /// the value of τ from which ρ = ∥f∥² - c/τ, and c
    pub(super) settled: f64,
    pub(super) slope: f64,
}

impl Load {
    /// The load f for resolvents with τ ≥ `least`.
    pub(super) fn new(ends: Ends, total: f64, cells: Cells, least: f64) -> Result<Self> {
        let primitive = if least * total < 1.0 {
            let whole = cells.primitive()?;
            let shifted = if ends == Ends::Neumann { whole } else { whole.minus(whole.mean())? };
            let square = shifted.square();
            Some((shifted, square))
        } else {
            None
        };
        let long = if cells.degree() == 0 { EXPONENTIAL } else { POWER };
        let settled = (long / cells.shortest()).min(1e305) / total;
        let square = cells.square();
        let mut load =
            Self { ends, total, cells, square, primitive, settled: f64::INFINITY, slope: 0.0 };
        let settled = settled.max(least);
        load.slope = (square - load.form(settled).0) * settled;
        load.settled = settled;
        Ok(load)
    }

    /// ρ(τ)/L and its rounding error.
    pub(super) fn form(&self, tau: f64) -> (f64, f64) {
        if tau >= self.settled {
            let dropped =
                if self.cells.degree() == 0 { 0.0 } else { (self.settled / tau / POWER).powi(2) };
            let rounding = (4.0 * f64::EPSILON + 10.0 * dropped) * self.square;
            return (self.square - self.slope / tau, rounding);
        }
        let mu = tau * self.total;
        match &self.primitive {
            Some((primitive, square)) if mu < 1.0 => {
                let (value, error) = self.ends.other().form(mu, primitive.run(mu));
                (mu * mu * (square - value), mu * mu * (error + 4.0 * f64::EPSILON * square))
            }
            _ => self.ends.form(mu, self.cells.run(mu)),
        }
    }
}

/// √(1 + e^y).
fn tau(y: f64) -> f64 {
    if y > 0.0 { (0.5 * y).exp() * (1.0 + (-y).exp()).sqrt() } else { (1.0 + y.exp()).sqrt() }
}

/// The part beyond `distance` of the infinite trapezoidal rule for e^{−ay}, a = `rate`: a geometric series.
pub(super) fn geometric(rate: f64, step: f64, distance: f64) -> f64 {
    (-rate * distance).exp() * step / -(-rate * step).exp_m1()
}

/// ⟨f, (1+A)^{-ν} f⟩ / L and its error, to a relative `goal`, with the number of evaluations.
fn power_form(load: &Load, order: Order, goal: f64) -> (f64, f64, u64) {
    let (nu, complement) = (order.value(), order.complement());
    let step = 2.0 * PI * PI / (4.0 / goal).ln();
    // Below, ρ(τ) is ρ(1) up to e^y; above, the law of large τ holds and 1 + e^{-y} is 1.
    let first = (goal.ln() / (1.0 + complement) / step).floor();
    let last = ((2.0 * load.settled.ln()).max(37.0) / step).ceil();
    let nodes: Vec<f64> =
        (0..=(last - first) as usize).map(|k| (first + k as f64) * step).collect();
    let terms: Vec<(f64, f64)> = parallel::over(&nodes, |&y| {
        let (value, error) = load.form(tau(y));
        let weight = if y > 0.0 {
            (-nu * y).exp() / (1.0 + (-y).exp())
        } else {
            (complement * y).exp() / (1.0 + y.exp())
        };
        (step * weight * value, step * weight * error)
    });
    let (mut sum, mut error) = (RunningSum::default(), 0.0);
    for (term, rounding) in terms {
        sum.add(term);
        error += rounding;
    }
    let (low, low_error) = load.form(1.0);
    let below = geometric(complement, step, -(nodes[0] - step));
    sum.add(below * low);
    // ρ(1) ≤ ρ(τ) ≤ τ² ρ(1)
    error += below * (low_error + nodes[0].exp() * low);
    let end = nodes[nodes.len() - 1] + step;
    sum.add(geometric(nu, step, end) * load.square);
    sum.add(-geometric(nu + 0.5, step, end) * load.slope);
    error += geometric(nu, step, end) * load.form(tau(end)).1;
    let factor = (PI * nu.min(complement)).sin() / PI;
    let value = factor * sum.value();
    (value, factor * error + (goal + 16.0 * f64::EPSILON) * value, nodes.len() as u64)
}

impl PiecewisePolynomial {
    pub(super) fn dual_by_resolvents(
        &self,
        ends: Ends,
        order: Order,
        tolerance: Tolerance,
    ) -> Result<Estimate> {
        let unit = self.unit_of_load();
        if unit == 0.0 {
            return Estimate::new(0.0, 0.0, Work::default());
        }
        let total = self.mesh().total();
        let cells = Cells::new(self, unit)?;
        let (mut mean, mut rest) = (0.0, cells);
        if ends == Ends::Neumann {
            mean = rest.mean();
            rest = rest.minus(mean)?;
            // what is left of a constant is its rounding
            let ulps = 8.0 * f64::EPSILON * mean.abs();
            if rest.square() <= ulps * ulps {
                let work = Work { points: self.mesh().len() as u64, ..Work::default() };
                return Estimate::new(mean.abs(), 2.0 * ulps, work)?
                    .times(unit)?
                    .times(total.sqrt());
            }
        }
        let shifted = 4.0 * f64::EPSILON * mean.abs();
        let goal = (1e-2 * tolerance.relative()).max(f64::EPSILON);
        let (value, error, passes) = power_form(&Load::new(ends, total, rest, 1.0)?, order, goal);
        let work = Work {
            points: passes * self.mesh().len() as u64,
            iterations: passes,
            ..Work::default()
        };
        let error = error + 2.0 * shifted * value.max(0.0).sqrt() + 2.0 * shifted * mean.abs();
        let found = Estimate::new(mean * mean + value, error, work)?
            .sqrt()?
            .times(unit)?
            .times(total.sqrt())?;
        // below the range of binary64
        let found =
            if found.value == 0.0 { Estimate::new(0.0, f64::MIN_POSITIVE, work)? } else { found };
        if found.relative_error() <= tolerance.relative() {
            return Ok(found);
        }
        let why = "rounding of the sums over the elements limits the accuracy";
        Err(Error::not_met("dual norm", tolerance.relative(), found, why))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{DualOf, Mesh};
    use std::f64::consts::PI;

    /// The norm of 1 in the dual of the space of sines on (0, 1): (8/π² Σ_{odd k} k^{-2} (1 +
    /// k²π²)^{-ν})^{1/2}, the tail by the midpoint rule.
    fn one_exactly(nu: f64) -> f64 {
        const LAST: f64 = 200_000.0;
        let term = |k: f64| 8.0 / (PI * k).powi(2) * (PI * k).hypot(1.0).powf(-2.0 * nu);
        let head: f64 = (0..LAST as u32 / 2).rev().map(|m| term(2.0 * f64::from(m) + 1.0)).sum();
        let tail = 4.0 * PI.powf(-2.0 - 2.0 * nu) * LAST.powf(-1.0 - 2.0 * nu) / (1.0 + 2.0 * nu);
        (head + tail).sqrt()
    }

    #[test]
    fn small_orders_are_summed_with_their_tail() {
        let one = PiecewisePolynomial::linears(Mesh::uniform(3, 1.0).unwrap(), &[1.0; 4]).unwrap();
        for nu in [1e-6, 0.01, 0.1, 0.3, 0.5, 0.9] {
            let order = Order::new(nu).unwrap();
            let exact = one_exactly(nu);
            for tolerance in [1e-2, 1e-4, 1e-6, 1e-8] {
                let tolerance = Tolerance::new(tolerance).unwrap();
                let found = one.dual_norm(DualOf::InterpolationZero, order, tolerance).unwrap();
                let error = (found.value - exact).abs();
                assert!(
                    error <= found.error + 1e-12,
                    "nu {nu}: {found} against {exact}, {error:e}"
                );
                assert!(found.relative_error() <= tolerance.relative());
            }
        }
    }

    #[test]
    fn sizes_scale_and_what_cannot_be_summed_is_an_error() {
        let one = |length: f64, value: f64| {
            let cells = Mesh::uniform(3, length).unwrap();
            PiecewisePolynomial::linears(cells, &[value; 4]).unwrap()
        };
        let norm = |u: PiecewisePolynomial| {
            u.dual_norm(DualOf::Interpolation, Order::HALF, Tolerance::fast()).unwrap().value
        };
        for (length, value) in [(1.0, 1e-300), (1.0, 1e300), (1e-300, 1.0), (1e300, 1.0)] {
            let exact = value * f64::sqrt(length);
            assert!((norm(one(length, value)) / exact - 1.0).abs() < 1e-12, "{length} {value}");
        }
        // 3000 jumps of both signs at random
        let signs: Vec<f64> =
            (0..3000u32).map(|i| f64::from(i.wrapping_mul(2_654_435_761) >> 31) - 0.5).collect();
        let noise =
            PiecewisePolynomial::constants(Mesh::uniform(3000, 1.0).unwrap(), &signs).unwrap();
        let found = |tolerance| {
            let order = Order::new(0.01).unwrap();
            noise.dual_norm(DualOf::InterpolationZero, order, Tolerance::new(tolerance).unwrap())
        };
        assert!((found(1e-12).unwrap().value / found(1e-4).unwrap().value - 1.0).abs() < 1e-6);
        let refused = found(1e-15);
        assert!(matches!(refused, Err(Error::ToleranceNotMet { asked: 1e-15, .. })), "{refused:?}");
    }
}
