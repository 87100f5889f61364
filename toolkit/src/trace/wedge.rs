//! A corner: the wedge 0 < θ < ω, with the trace on its edge θ = 0.

use super::angular_kernel::AngularKernel;
use super::half_line::HalfLineSymbol;
use super::half_plane::require_trace;
use super::wedge_elements::{Fineness, WedgeElements};
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Work};
use crate::numeric::pencil::Factored;
use crate::order::Order;
use std::f64::consts::{FRAC_PI_2, PI};

/// Two levels of refinement: the value of the second one is returned, the first one gives the error.
const FINENESS: [Fineness; 2] = [
    Fineness { degree: 7, points: 11, levels: 3, first: 1e-4 },
    Fineness { degree: 9, points: 14, levels: 4, first: 1e-5 },
];
/// Rounding error of the matrix, relative to its entries, and its growth as 1 − s → 0, times 1/(1−s): changing
/// the quadrature points by one rounding error changes the quotient by 1.1e-11/(1−s) at 1 − s = 1e-8.
const ROUNDING: f64 = 1e-12;
const LOST: f64 = 2e-11;
/// Largest value of τ that the meshes resolve.
const LARGEST_TAU: f64 = 100.0;

/// Quotients edge/wedge of the squared seminorms, for every mode.
///
/// # Method
///
/// w = r^{s−1+iτ} ψ(θ), ψ(0) = 1. Per unit of ln r the edge has C(τ), the symbol of the half line, and the
/// wedge
///
/// E_τ(ψ) = ∫₀^ω∫₀^ω (ψ−ψ')² K_τ(θ−θ') + (ψ²+ψ'²) D_τ(θ−θ') dθ dθ',
///
/// whose minimum over ψ is computed by finite elements (`wedge_elements`). The best constant of the
/// wedge is the supremum of C(τ)/min E_τ over τ; as τ → ∞ the quotient tends to that of the half-plane,
/// from below. The half-plane itself, with even boundary values |x|^{s−1+iτ}, has ω = π and an axis of symmetry
/// at π/2; there the quotient is the closed form for *every* τ, which is thus computed independently.
#[derive(Debug, Clone, Copy)]
pub(super) struct WedgeTrace {
    order: Order,
    angle: f64,
    mirrored: bool,
}

impl WedgeTrace {
    /// The corner of angle ω, in radians.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless 1/2 < s and 0.1 ≤ ω ≤ π.
    pub(super) fn corner(order: Order, angle: f64) -> Result<Self> {
        require_trace(order)?;
        Ok(Self { order, angle: require_angle(angle)?, mirrored: false })
    }

    /// The half-plane with even boundary values.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for s ≤ 1/2.
    pub(super) fn half_plane(order: Order) -> Result<Self> {
        require_trace(order)?;
        Ok(Self { order, angle: FRAC_PI_2, mirrored: true })
    }

    /// The quotient |f|²_{s−1/2}/|w|²_s for the boundary values r^{s−1+iτ} and the extension of least energy: a
    /// lower bound of the square of the best constant.
    ///
    /// The finite elements approximate the least energy from above: up to quadrature the value is a lower
    /// bound of the quotient. Cost: 1e6 operations.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless 0 ≤ τ ≤ 100.
    pub(super) fn quotient(&self, tau: f64) -> Result<Estimate> {
        require_tau(tau)?;
        let edge = self.edge(tau);
        let [coarse, fine] = FINENESS.map(|fineness| self.least_energy(tau, fineness));
        let ((coarse, _, _), (fine, whole, points)) = (coarse?, fine?);
        // Near s = 1/2 the least energy is a small difference of two terms.
        let rounding = ROUNDING * whole.max(fine) + LOST / self.order.complement() * fine;
        let error = (fine - coarse).abs() + rounding;
        let work = Work { points, factorizations: 2, ..Work::default() };
        Estimate::new(edge / fine, edge / fine * error / fine, work)
    }

    /// The symbol of the seminorm on the edge.
    fn edge(&self, tau: f64) -> f64 {
        let (nu, s) = (self.order.offset(), self.order.value());
        let half = HalfLineSymbol::new(2.0 * self.order.complement()).at(tau) / nu;
        if !self.mirrored {
            return half;
        }
        // Pairs on different sides: 2 ∫ (cosh((1−s)u) − cos(τu)) (2cosh(u/2))^{-2s} du, even in u.
        let step = PI * PI / (36.0 + PI * tau);
        // From 36/(1−s) on a term is e^{−(2s−1)u}/4, a geometric sequence, and from 36/(2s−1) on it is nothing.
        let terms = (36.0 / (step * (2.0 * nu).max(self.order.complement()))).ceil();
        let rest = 0.25 * (-2.0 * nu * step * (terms + 1.0)).exp() / -(-2.0 * nu * step).exp_m1();
        let across = |k: usize| {
            let u = k as f64 * step;
            // sinh² times e^{−su} as e^{(1−2s)u} (1 − e^{−(1−s)u})²/4: near s = 1/2 sinh overflows.
            let near_one = (-self.order.complement() * u).exp_m1();
            let growing = 0.25 * near_one * near_one * (-2.0 * nu * u).exp();
            let waving = (0.5 * tau * u).sin().powi(2) * (-s * u).exp();
            (growing + waving) * (1.0 + (-u).exp()).powf(-2.0 * s)
        };
        half + 8.0 * step * ((1..=terms as usize).map(across).sum::<f64>() + rest)
    }

    /// The minimum of E_τ, the term from which it is subtracted, and the number of unknowns.
    fn least_energy(&self, tau: f64, fineness: Fineness) -> Result<(f64, f64, u64)> {
        let first = fineness.first / (1.0 + tau);
        let elements = WedgeElements::new(self.order, self.angle, Fineness { first, ..fineness })?;
        let kernel = AngularKernel::new(self.order, tau, elements.smallest());
        let form = elements.form(&kernel, self.mirrored)?;
        let best = Factored::new(&form.matrix)?.solve(&form.linear);
        let gain: f64 = best.iter().zip(&form.linear).map(|(x, b)| x * b).sum();
        Ok((form.constant - gain, form.constant, best.len() as u64))
    }
}

fn require_angle(angle: f64) -> Result<f64> {
    Error::require("angle", angle, "[0.1, pi]", (0.1..=PI).contains(&angle))
}

fn require_tau(tau: f64) -> Result<f64> {
    Error::require("tau", tau, "[0, 100]", (0.0..=LARGEST_TAU).contains(&tau))
}

/// The same quotient for s = 1, ‖∇w‖² on the wedge: 2(πτ coth(πτ) − 1)/(τ tanh(ωτ)).
///
/// # Errors
/// [`Error::OutOfRange`] unless 0.1 ≤ ω ≤ π and 0 ≤ τ ≤ 100.
pub(super) fn quotient_at_one(angle: f64, tau: f64) -> Result<f64> {
    require_angle(angle)?;
    let x = PI * require_tau(tau)?;
    if x < 1e-3 {
        // x coth x − 1 = x²/3 − x⁴/45 + ...
        return Ok(
            2.0 * PI * PI / (3.0 * angle) * (1.0 - x * x / 15.0 + (angle * tau).powi(2) / 3.0)
        );
    }
    Ok(2.0 * (x / x.tanh() - 1.0) / (tau * (angle * tau).tanh()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn near_one_the_corner_is_that_of_the_dirichlet_integral() {
        let order = Order::new(1.0 - 1e-5).unwrap();
        let scale = 0.5 * PI / order.complement();
        for (angle, tau) in [(FRAC_PI_2, 0.0), (1.0, 1.5)] {
            let found = WedgeTrace::corner(order, angle).unwrap().quotient(tau).unwrap();
            let limit = quotient_at_one(angle, tau).unwrap();
            assert!(
                (found.value * scale / limit - 1.0).abs() < 1e-3,
                "{angle} {tau}: {found} {limit}"
            );
        }
        // The rules come as close as 1 − s; the quotient goes to its limit like 1 − s.
        for distance in [1e-3, 1e-5, 1e-8] {
            let order = Order::new(1.0 - distance).unwrap();
            let scale = 0.5 * PI / order.complement();
            for (angle, tau) in [(FRAC_PI_2, 0.0), (2.0, 1.0), (0.5, 0.3)] {
                let found = WedgeTrace::corner(order, angle).unwrap().quotient(tau).unwrap();
                let limit = quotient_at_one(angle, tau).unwrap();
                let apart = (found.value * scale / limit - 1.0).abs();
                let allowed = 3.0 * distance + found.error * scale / limit;
                assert!(apart < allowed, "1 - s = {distance}, {angle} {tau}: {apart} > {allowed}");
            }
        }
        let [below, above] = [0.999e-3, 1.001e-3].map(|x| quotient_at_one(1.0, x / PI).unwrap());
        assert!((below / above - 1.0).abs() < 1e-8);
    }

    #[test]
    fn the_half_plane_has_its_closed_form_down_to_one_half() {
        for distance in [1e-6, 1e-4, 1e-3, 1e-2] {
            let order = Order::half_plus(distance).unwrap();
            let closed = crate::trace_constant(crate::Domain::HalfPlane, order, 1e-8)
                .unwrap()
                .constant
                .value;
            for tau in [0.0, 4.0, 64.0] {
                let found = WedgeTrace::half_plane(order).unwrap().quotient(tau).unwrap();
                assert!(
                    (found.value - closed * closed).abs() <= found.error,
                    "{distance:e} {tau}: {found}"
                );
            }
        }
    }
}
