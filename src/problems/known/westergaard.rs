//! Contact problems on the unit square with solution in closed form, scalar and elastic, with one or two transitions.
//!
//! With z = x + iy, a = 3/10 and b = 7/10 let F = (z − a)^{3/2}, or F = ((z − a)(b − z))^{3/2}, with the
//! square root of real part ≥ 0 for each factor. On y = 0 either F > 0 and F' is real (no contact: x > a, or
//! a < x < b), or Re F = 0 and Im F' ≥ 0 (contact). All second derivatives are of size r^{−1/2} at the
//! transitions, so u ∈ H^{5/2−ε}.
//!
//! * *Scalar*: u = −Re F, harmonic, ∂u/∂n = −Im F' on y = 0.
//! * *Elastic* (Westergaard's function iF'; α = μ/(λ+μ), β = 1 + α, no volume force):
//!   2μ u_x = −α Im F − y Re F',  2μ u_y = β Re F + y Im F'.
//!   On y = 0, n = (0, −1): σ_T = 0, σ_N = −Im F' ≤ 0, u_N = −β Re F/(2μ) ≤ 0.
//!
//! The solution with a = 2/5 and free sides differs from that with one transition only in a and in its boundary data.
//! H. M. Westergaard, J. Appl. Mech. 6 (1939) A49-A53.

use super::{moduli, rule};
use crate::error::{Error, Result};
use crate::fem::Lame;
use crate::mesh::{Point, SideParts, mapped_grid};
use fractional_sobolev::{Estimate, Tolerance, Work};
use fractional_sobolev_numeric::transforms::Complex;
use std::fmt;

/// Numbers of points along each side of a triangle for seminorms, graded toward the transitions; tried in turn until
/// the tolerance is met.
const POINTS: [usize; 4] = [6, 10, 14, 20];

/// The solution by its transitions, with contact to the left of a and to the right of b.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Westergaard {
    /// a, or a and b; not nodes of uniform dyadic meshes.
    pub(super) transitions: &'static [f64],
    /// True if ∂u/∂n is given on the left and the right side.
    pub(super) has_free_sides: bool,
    /// The Lamé constants; `None` for the scalar problem.
    pub(super) lame: Option<Lame>,
}

/// The root √z in the first quadrant, for Im z ≥ 0.
fn root(x: f64, y: f64) -> Complex<f64> {
    let (r, half) = (x.hypot(y).sqrt(), 0.5 * y.atan2(x));
    // On the negative axis the real part is zero, not rounding.
    if y == 0.0 && x < 0.0 { Complex::new(0.0, r) } else { Complex::from_polar(r, half) }
}

impl Westergaard {
    /// Contact to the left of 3/10.
    pub(super) fn one_transition(lame: Option<Lame>) -> Self {
        Self { transitions: &[0.3], has_free_sides: false, lame }
    }

    /// Contact to the left of 3/10 and to the right of 7/10.
    pub(super) fn two_transitions(lame: Option<Lame>) -> Self {
        Self { transitions: &[0.3, 0.7], ..Self::one_transition(lame) }
    }

    /// Contact to the left of 2/5, free sides.
    pub(super) fn three_halves() -> Self {
        Self { transitions: &[0.4], has_free_sides: true, lame: None }
    }

    /// F, F', F'', F'''.
    fn potential(&self, [x, y]: Point) -> [Complex<f64>; 4] {
        let a = self.transitions[0];
        let left = root(x - a, y);
        let Some(&b) = self.transitions.get(1) else {
            let cube = left * left * left;
            return [cube, 1.5 * left, 0.75 * left.inv(), -0.375 * cube.inv()];
        };
        // (b − z)^{1/2} is the conjugate of the root of b − x + iy. G = ((z−a)(b−z))^{1/2}, G' = m/(2G).
        let g = left * root(b - x, y).conj();
        let (below, m) = (g.inv(), Complex::new(a + b - 2.0 * x, -2.0 * y));
        let slope = 0.5 * m * below;
        let length = (b - a) * (b - a);
        [
            g * g * g,
            1.5 * g * m,
            0.75 * length * below - 6.0 * g,
            -0.75 * length * slope * below * below - 6.0 * slope,
        ]
    }

    /// The displacement u; for a scalar solution the second entry is 0.
    pub(super) fn displacement(&self, point: Point) -> Point {
        let ([f, g, ..], y) = (self.potential(point), point[1]);
        let Some(lame) = self.lame else { return [-f.re, 0.0] };
        let (alpha, double) = moduli(lame);
        [(-alpha * f.im - y * g.re) / double, ((1.0 + alpha) * f.re + y * g.im) / double]
    }

    /// The gradient ∇u: row c is the gradient of component c.
    pub(super) fn gradient(&self, point: Point) -> [Point; 2] {
        let ([_, f, g, _], y) = (self.potential(point), point[1]);
        let Some(lame) = self.lame else { return [[-f.re, f.im], [0.0; 2]] };
        // y F'' is zero on the edge, at a transition as the limit: F'' grows only like r^{−1/2}.
        let g = if y == 0.0 { Complex::ZERO } else { g };
        let (alpha, double) = moduli(lame);
        let across = (1.0 + alpha) * f.re;
        let rows = [
            [-alpha * f.im - y * g.re, y * g.im - across],
            [across + y * g.im, -alpha * f.im + y * g.re],
        ];
        rows.map(|row| row.map(|entry| entry / double))
    }

    /// (∂²/∂x², ∂²/∂x∂y, ∂²/∂y²) of each component; not finite at a transition, where these have no limit.
    pub(super) fn second_derivatives(&self, point: Point) -> [[f64; 3]; 2] {
        let ([_, _, f, g], y) = (self.potential(point), point[1]);
        let Some(lame) = self.lame else { return [[-f.re, f.im, f.re], [0.0; 3]] };
        let (alpha, double) = moduli(lame);
        let rows = [
            [
                -alpha * f.im - y * g.re,
                y * g.im - (1.0 + alpha) * f.re,
                (alpha + 2.0) * f.im + y * g.re,
            ],
            [
                (1.0 + alpha) * f.re + y * g.im,
                y * g.re - alpha * f.im,
                (1.0 - alpha) * f.re - y * g.im,
            ],
        ];
        rows.map(|row| row.map(|entry| entry / double))
    }

    /// σ(u) n; the scalar problem has (∂u/∂n, 0).
    pub(super) fn traction(&self, point: Point, [p, q]: Point) -> Point {
        let [[xx, xy], [yx, yy]] = self.gradient(point);
        let Some(lame) = self.lame else { return [xx * p + xy * q, 0.0] };
        let (sum, shear) = (lame.lambda() * (xx + yy), lame.mu() * (xy + yx));
        let double = 2.0 * lame.mu();
        [(sum + double * xx) * p + shear * q, shear * p + (sum + double * yy) * q]
    }

    /// σ_N at (x, 0), n = (0, −1).
    pub(super) fn normal_stress(&self, x: f64) -> f64 {
        let traction = self.traction([x, 0.0], [0.0, -1.0]);
        if self.lame.is_some() { -traction[1] } else { traction[0] }
    }

    /// |u|₂ on (0, 1) × (0, 1/n).
    pub(super) fn second_seminorm(&self, n: usize, tolerance: Tolerance) -> Result<Estimate> {
        let height = 1.0 / n as f64;
        let mesh = mapped_grid(n.max(4), (4 / n.max(1)).max(1), SideParts::HANGING, |[x, y]| {
            [x, height * y]
        })?;
        let integral = |points: usize| -> Result<(f64, u64)> {
            let (rule, mut sum, mut count) = (rule(points, self.transitions)?, 0.0, 0);
            for t in 0..mesh.triangles().len() {
                rule.on(mesh.corners(t), &mut |point, weight| {
                    let squares = self.second_derivatives(point);
                    sum += weight
                        * squares.iter().map(|[p, q, r]| p * p + 2.0 * q * q + r * r).sum::<f64>();
                    count += 1;
                    Ok(())
                })?;
            }
            Ok((sum, count))
        };
        let (mut before, mut taken) = integral(POINTS[0])?;
        let mut best = None;
        for &points in &POINTS[1..] {
            let (square, count) = integral(points)?;
            taken += count;
            let work = Work { points: taken, ..Work::default() };
            let found = Estimate::new(square, square - before, work)?.sqrt()?;
            if found.relative_error() <= tolerance.relative() {
                return Ok(found);
            }
            (before, best) = (square, Some(found));
        }
        let why = "quadrature of second derivatives converges slowly near the transition";
        let asked = tolerance.relative();
        let what = "seminorm of second derivatives";
        Err(best.map_or(Error::out_of_reach(what, asked, f64::INFINITY, why), |best| {
            Error::not_met(what, asked, best, why)
        }))
    }
}

impl fmt::Display for Westergaard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let kind = if self.lame.is_some() { "elastic" } else { "scalar" };
        let solution = match self.transitions.len() {
            _ if self.has_free_sides => "r^(3/2)",
            1 => "one transition",
            _ => "two transitions",
        };
        write!(f, "{kind}, {solution}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn all_known() -> [Westergaard; 5] {
        let lame = Some(Lame::new(1.3, 0.7).unwrap());
        let [scalar, elastic] = [None, lame]
            .map(|lame| [Westergaard::one_transition(lame), Westergaard::two_transitions(lame)]);
        [scalar[0], scalar[1], elastic[0], elastic[1], Westergaard::three_halves()]
    }

    #[test]
    fn contact_conditions_hold_on_the_edge() {
        for known in all_known() {
            for i in 0..=40 {
                let point = [f64::from(i) / 40.0, 0.0];
                let (u, stress) = (known.displacement(point), known.traction(point, [0.0, -1.0]));
                let (normal, pressure, shear) = match known.lame {
                    Some(_) => (-u[1], -stress[1], stress[0]),
                    None => (u[0], stress[0], 0.0),
                };
                assert!(
                    normal <= 0.0 && pressure <= 1e-15,
                    "{known} {point:?}: {normal} {pressure}"
                );
                assert!(
                    (normal * pressure).abs() < 1e-15 && shear.abs() < 1e-15,
                    "{known} {point:?}"
                );
            }
        }
    }

    #[test]
    fn derivatives_are_those_of_u_and_forces_balance() {
        // Central differences: h² times third derivatives, ε/h of rounding.
        let (h, tolerance) = (1e-5, 1e-7);
        for known in all_known() {
            for point in [[0.1, 0.2], [0.55, 0.4], [0.9, 0.15]] {
                let [x, y] = point;
                let (gradient, second) = (known.gradient(point), known.second_derivatives(point));
                let sides = [[x + h, y], [x - h, y], [x, y + h], [x, y - h]];
                let (u, g) =
                    (sides.map(|p| known.displacement(p)), sides.map(|p| known.gradient(p)));
                for c in 0..2 {
                    for d in 0..2 {
                        let slope = (u[2 * d][c] - u[2 * d + 1][c]) / (2.0 * h);
                        assert!((slope - gradient[c][d]).abs() < tolerance, "{known} {point:?}");
                        for e in 0..2 {
                            let curve = (g[2 * d][c][e] - g[2 * d + 1][c][e]) / (2.0 * h);
                            assert!(
                                (curve - second[c][d + e]).abs() < tolerance,
                                "{known} {point:?}"
                            );
                        }
                    }
                }
                let laplace = second.map(|[xx, _, yy]| xx + yy);
                let (lambda, mu) = known.lame.map_or((-1.0, 1.0), |m| (m.lambda(), m.mu()));
                let grad = [second[0][0] + second[1][1], second[0][1] + second[1][2]];
                for c in 0..2 {
                    assert!((mu * laplace[c] + (lambda + mu) * grad[c]).abs() < 1e-13, "{known}");
                }
            }
        }
    }

    #[test]
    fn the_seminorm_of_one_transition_is_the_closed_form() {
        // |F''|² = 9/(16 r); ∫ 1/r over (0, p) × (0, q) from its corner is p asinh(q/p) + q asinh(p/q).
        let corner = |p: f64, q: f64| p * (q / p).asinh() + q * (p / q).asinh();
        for n in [1, 2, 16] {
            let q = 1.0 / n as f64;
            let exact = (1.125 * (corner(0.3, q) + corner(0.7, q))).sqrt();
            let value = all_known()[0].second_seminorm(n, Tolerance::fast()).unwrap();
            assert!((value.value - exact).abs() <= value.error.max(1e-9), "{n}: {value:?} {exact}");
        }
    }
}
