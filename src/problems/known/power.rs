//! Contact problems on the unit square with known solution and one transition of given regularity, scalar and
//! elastic.
//!
//! 1/2 < p < 3/2, p ≠ 1; r, φ are polar coordinates at the transition (a, 0), φ = 0 on the contact side x < a, and
//! ζ = (a−x) + iy.
//!
//! * *Scalar*: u = ± Im ζ^p = ± r^p sin(pφ), harmonic, u = 0 in contact and u = −|sin(pπ)| r^p outside contact.
//!   With σ_N = −p |sin(pπ)| r^{p−1} in contact and 0 outside, the edge also carries the load ∂u/∂n − σ_N,
//!   a power on each side.
//! * *Elastic* (Westergaard's form, no volume force, zero shear on the edge): α = μ/(λ+μ), β = 1 + α, A = ∓1,
//!   Z = Aζ^p, 2μ u_x = −α Re Z + y Im Z', 2μ u_y = β Im Z − y Re Z', the prime for d/dζ. On the edge u_N is
//!   β/(2μ) times the scalar one, and the normal stress Re Z' is the scalar ∂u/∂n: same σ_N, same load.
//!
//! u is prescribed on the other three sides. u ∈ H^τ exactly for τ < p + 1, and σ_N, u_N' ∈ H^ν exactly for
//! ν < p − 1/2. For p = 3/2 the load vanishes.

use super::moduli;
use crate::error::{Error, Result, ToolkitError};
use crate::fem::Lame;
use crate::mesh::Point;
use fractional_sobolev::{CornerFunction, Estimate, Function, Order, Position, Tolerance, Work};
use std::f64::consts::PI;

/// The transition a, not a node of uniform dyadic meshes.
pub(super) const TRANSITION: f64 = 0.4;
/// Bound of the rounding error of a dozen operations.
const ROUNDING: f64 = 1e-14;

/// The solution, by its power and material.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Power {
    pub(super) power: f64,
    pub(super) lame: Option<Lame>,
}

/// A function on the contact edge: σ_N or u_N'.
///
/// Both are multiples of r^{p−1} on one side of the transition and vanish on the other.
///
/// ```
/// use signorini::problems::{EdgeDatum, KnownSolution};
/// let u = KnownSolution::power(1.25, None)?;
/// // on the other side of the transition each of them vanishes
/// assert_eq!(u.edge_seminorm(EdgeDatum::Pressure, [0.5, 0.9], 0.25, 1e-6)?.value, 0.0);
/// assert_eq!(u.edge_seminorm(EdgeDatum::Slope, [0.1, 0.3], 0.25, 1e-6)?.value, 0.0);
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EdgeDatum {
    /// The normal stress σ_N.
    Pressure,
    /// The slope u_N'.
    Slope,
}

impl Power {
    /// The solution with power p; u ∈ H^τ for τ < p + 1.
    pub(super) fn new(power: f64, lame: Option<Lame>) -> Result<Self> {
        let admissible = power > 0.5 && power < 1.5 && (power - 1.0).abs() >= 0.01;
        let power =
            Error::require("p", power, "the union of (1/2, 0.99] and [1.01, 3/2)", admissible)?;
        Ok(Self { power, lame })
    }

    /// The sign in u = `sign` r^p sin(pφ).
    fn sign(&self) -> f64 {
        -(PI * self.power).sin().signum()
    }

    fn polar([x, y]: Point) -> (f64, f64) {
        ((x - TRANSITION).hypot(y), y.atan2(TRANSITION - x))
    }

    /// The displacement u; for a scalar solution the second entry is 0.
    pub(super) fn displacement(&self, point: Point) -> Point {
        let ((r, phi), p) = (Self::polar(point), self.power);
        let size = -self.sign() * r.powf(p);
        let (sin, cos) = (p * phi).sin_cos();
        let Some(lame) = self.lame else { return [-size * sin, 0.0] };
        let ((alpha, double), y) = (moduli(lame), p * phi.sin());
        let (low_sin, low_cos) = ((p - 1.0) * phi).sin_cos();
        [y * low_sin - alpha * cos, (1.0 + alpha) * sin - y * low_cos]
            .map(|part| size * part / double)
    }

    /// The gradient ∇u: row c is the gradient of component c.
    pub(super) fn gradient(&self, point: Point) -> [Point; 2] {
        let ((r, phi), q) = (Self::polar(point), self.power - 1.0);
        let size = -self.sign() * self.power * r.powf(q);
        let (sin, cos) = (q * phi).sin_cos();
        let Some(lame) = self.lame else { return [[size * sin, -size * cos], [0.0; 2]] };
        let ((alpha, double), y) = (moduli(lame), q * phi.sin());
        let (low_sin, low_cos) = ((q - 1.0) * phi).sin_cos();
        let (across, along) = ((1.0 + alpha) * sin, alpha * cos);
        let rows = [
            [along - y * low_sin, across + y * low_cos],
            [y * low_cos - across, along + y * low_sin],
        ];
        rows.map(|row| row.map(|entry| size * entry / double))
    }

    /// The value of [`KnownSolution::body_seminorm`](super::KnownSolution::body_seminorm).
    pub(super) fn body_seminorm(&self, tau: f64, tolerance: Tolerance) -> Result<Estimate> {
        let (p, q) = (self.power, self.power - 1.0);
        // The half disc about the transition that contains the square.
        let radius = TRANSITION.max(1.0 - TRANSITION).hypot(1.0);
        let material = self.lame.map(moduli);
        if tau == 2.0 {
            if q <= 0.0 {
                return Err(Error::Toolkit(ToolkitError::InfiniteNorm {
                    order: 2.0,
                    why: "r^p is in H^2 only for p > 1",
                }));
            }
            let shape = material.map_or(1.0, |(alpha, double)| {
                (alpha * alpha + (1.0 + alpha).powi(2) + 1.0 - q + q * q).sqrt() / double
            });
            let value = shape * p * (q * PI * radius.powf(2.0 * q)).sqrt();
            return Ok(Estimate::new(value, ROUNDING * value, Work::default())?);
        }
        let order = Order::new(tau - 1.0)?;
        Ok(match material {
            None => {
                CornerFunction::power(p, p, PI, radius)?.seminorm(order.plus_one(), tolerance)?
            }
            Some((alpha, double)) => {
                let corner = CornerFunction::elastic(p, alpha, radius)?;
                corner.seminorm(order.plus_one(), tolerance)?.times(double.recip())?
            }
        })
    }

    /// The factor of r^{p−1} in σ_N on the contact side.
    fn pressure(&self) -> f64 {
        -self.power * (PI * self.power).sin().abs()
    }

    /// σ_N at (x, 0).
    pub(super) fn normal_stress(&self, x: f64) -> f64 {
        let before = TRANSITION - x;
        if before > 0.0 { self.pressure() * before.powf(self.power - 1.0) } else { 0.0 }
    }

    /// The factor of r^{p−1} in u_N' outside contact.
    fn slope(&self) -> f64 {
        self.pressure()
            * self.lame.map(moduli).map_or(1.0, |(alpha, double)| (1.0 + alpha) / double)
    }

    /// |σ_N|_ν or |u_N'|_ν on the part (from, to) of the edge.
    pub(super) fn edge_seminorm(
        &self,
        datum: EdgeDatum,
        [from, to]: [f64; 2],
        order: Order,
        tolerance: Tolerance,
    ) -> Result<Estimate> {
        if order.value() >= self.power - 0.5 {
            let why = "r^(p-1) on one side of a point is in H^nu only for nu < p - 1/2";
            return Err(Error::Toolkit(ToolkitError::InfiniteNorm { order: order.value(), why }));
        }
        let size = if datum == EdgeDatum::Pressure { self.pressure() } else { self.slope() };
        let value = |distance: f64| {
            let is_inside = (distance < 0.0) == (datum == EdgeDatum::Pressure);
            if is_inside { size * distance.abs().powf(self.power - 1.0) } else { 0.0 }
        };
        if !(from < TRANSITION && TRANSITION < to) {
            let whole = Function::from_fn(&[from, to], |x| value(x - TRANSITION))?;
            return Ok(whole.seminorm(order, tolerance)?);
        }
        let breaks = [from, TRANSITION, to];
        let at =
            |at: Position| value(if at.anchor() == 1 { at.offset() } else { at.x() - TRANSITION });
        Ok(Function::from_positions(&breaks, at)?.seminorm(order, tolerance)?)
    }

    /// The factors of r^{p−1} in the edge load ∂u/∂n − σ_N, in the direction of n: in contact and outside.
    pub(super) fn loads(&self) -> [f64; 2] {
        let slope = self.sign() * self.power;
        [-slope - self.pressure(), slope * (PI * self.power).cos()]
    }

    /// The load of the edge of the mesh with n × n squares, integrated exactly: nodal values on the whole mesh.
    pub(super) fn edge_load(&self, n: usize) -> Vec<f64> {
        // In the direction of n: u_N is u, or −u_y.
        let (c, normal) = if self.lame.is_some() { (2, -1.0) } else { (1, 1.0) };
        let mut load = vec![0.0; c * (n + 1) * (n + 1)];
        let (h, q) = (1.0 / n as f64, self.power - 1.0);
        // ∫ r^q over the part and ∫ r^{q+1}, with r from `near` to `far`.
        let moment = |k: f64, near: f64, far: f64| (far.powf(q + k) - near.powf(q + k)) / (q + k);
        for i in 0..n {
            let (left, right) = (i as f64 * h, (i + 1) as f64 * h);
            for (size, side) in self.loads().into_iter().zip([-1.0, 1.0]) {
                let (low, high) = if side < 0.0 {
                    (left, right.min(TRANSITION))
                } else {
                    (left.max(TRANSITION), right)
                };
                if low >= high {
                    continue;
                }
                let distances = [low, high].map(|x| side * (x - TRANSITION));
                let (near, far) =
                    (distances[0].min(distances[1]).max(0.0), distances[0].max(distances[1]));
                let (whole, first) = (moment(1.0, near, far), moment(2.0, near, far));
                // The hat function of the right node is (x − left)/h, x = a ± r.
                let right_part = ((TRANSITION - left) * whole + side * first) / h;
                load[(i + 2) * c - 1] += normal * size * right_part;
                load[(i + 1) * c - 1] += normal * size * (whole - right_part);
            }
        }
        load
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// σ(u), in the scalar case with the one row ∇u.
    fn stress(lame: Option<Lame>, [[xx, xy], [yx, yy]]: [Point; 2]) -> [Point; 2] {
        let Some(lame) = lame else { return [[xx, xy], [0.0; 2]] };
        let (sum, shear) = (lame.lambda() * (xx + yy), lame.mu() * (xy + yx));
        [[sum + 2.0 * lame.mu() * xx, shear], [shear, sum + 2.0 * lame.mu() * yy]]
    }

    #[test]
    fn the_solution_meets_all_conditions_and_is_in_balance() {
        let elastic = Some(Lame::new(1.3, 0.7).unwrap());
        for (power, lame) in
            [0.65, 0.8, 0.95, 1.1, 1.3].into_iter().flat_map(|p| [(p, None), (p, elastic)])
        {
            let known = Power::new(power, lame).unwrap();
            for i in 0..=20 {
                let x = f64::from(i) / 20.0 + 1e-3;
                let (r, side) = ((x - TRANSITION).abs(), usize::from(x > TRANSITION));
                let (u, s) = (known.displacement([x, 0.0]), stress(lame, known.gradient([x, 0.0])));
                let (u, shear, normal) = match lame {
                    Some(_) => (-u[1], s[1][0], s[1][1]),
                    None => (u[0], 0.0, -s[0][1]),
                };
                let pressure = normal - known.loads()[side] * r.powf(power - 1.0);
                assert!(
                    u <= 1e-15 && pressure <= 1e-14 && (u * pressure).abs() < 1e-14,
                    "{power} {x}"
                );
                assert!(shear.abs() < 1e-14, "{power} {x}: {shear}");
                let exact =
                    [known.slope() / power * r.powf(power), known.pressure() * r.powf(power - 1.0)];
                let [given, found] = if side == 1 { [exact[0], u] } else { [exact[1], pressure] };
                assert!(
                    given < 0.0 && (given - found).abs() < 1e-14,
                    "{power} {x}: {given} {found}"
                );
            }
            let (h, [x, y]) = (1e-5, [0.55, 0.2]);
            let points = [[x + h, y], [x - h, y], [x, y + h], [x, y - h]];
            let (u, g) = (points.map(|p| known.displacement(p)), known.gradient([x, y]));
            let s = points.map(|p| stress(lame, known.gradient(p)));
            for c in 0..2 {
                for d in 0..2 {
                    assert!(
                        ((u[2 * d][c] - u[2 * d + 1][c]) / (2.0 * h) - g[c][d]).abs() < 1e-8,
                        "{power}"
                    );
                }
                let force = (s[0][c][0] - s[1][c][0] + s[2][c][1] - s[3][c][1]) / (2.0 * h);
                assert!(force.abs() < 1e-7, "{power}: {force}");
            }
        }
    }

    #[test]
    fn bad_powers_and_infinite_norms_are_errors() {
        assert!(Power::new(1.0, None).is_err() && Power::new(0.4, None).is_err());
        let known = Power::new(0.8, None).unwrap();
        let order = Order::new(0.3).unwrap();
        assert!(
            known.edge_seminorm(EdgeDatum::Slope, [0.0, 1.0], order, Tolerance::fast()).is_err()
        );
    }
}
