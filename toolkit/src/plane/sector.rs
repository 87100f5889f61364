//! Corner singularities w = r^a sin(bφ) on the sector 0 < r < R, 0 < φ < ω.

use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance, Work};
use crate::order::Order;
use crate::quadrature::Rule;
use crate::root::{ENTRY_ROUNDING, accept, root_of_squares};
use std::f64::consts::PI;

/// The angular factor of r^a.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Part {
    /// sin(bφ).
    Sine,
    /// The vector (cos(bφ), sin(bφ)).
    Rotation,
    /// e^{iaφ} − e^{i(a−2)φ}.
    Bend,
}

/// The function r^a sin(bφ) on a sector.
///
/// # Method
///
/// F(x, y) = (w(x)−w(y))² |x−y|^{-2-2s} is homogeneous of degree 2a − 2 − 2s about the corner. As for
/// simplices (`means`) one radius can be taken to be R; with the other R e^{-u} and ψ the angle
/// between x and y,
///
/// |w|²_s = R^{2a+2−2s} / (a+1−s) ∫₀^ω ∫₀^∞ e^{-(1-s)u} J(u, ψ) (4 sinh²(u/2) + 4 sin²(ψ/2))^{-1-s} du dψ,
/// J = (1−τ)² P(ψ) + 2τ Q(ψ), τ = e^{-au}, L = ω − ψ,
/// P = ∫₀^L sin²(bφ) + sin²(b(φ+ψ)) dφ,  Q = ∫₀^L (sin(b(φ+ψ)) − sin(bφ))² dφ = 2 sin²(bψ/2) (L + cos(bω)
/// sin(bL)/b): nothing cancels. It is finite exactly for a > s − 1. At u = ψ = 0 the integrand is ξ^{-2s}
/// times an analytic function of polar kind: Duffy's coordinates and a Gauss-Jacobi rule in ξ; elsewhere
/// Gauss rules on cells that grow away from it.
///
/// The gradient of the harmonic r^p sin(pφ) is p r^{p−1} (cos, sin) of (p−1)φ in fixed directions: both
/// components together have P = 2L and Q = 4 sin²((p−1)ψ/2) L, a = p − 1, times p².
///
/// An elastic displacement with zero shear on y = 0 (Westergaard) is v = (α Re z^p − y Im pz^q, (1+α) Im z^p
/// − y Re pz^q), q = p − 1. The conformal and the other part of ∇v give, with
/// W = r^q (e^{iqφ} − e^{i(q−2)φ}) = 2iy z^{q−1},
///
/// |∇v|_s² = p² (2α² |r^q e^{iqφ}|_s² + 2(1 + 2α) |r^q sin qφ|_s² + ½ q² |W|_s²).
///
/// W has P = ∫₀^L 4 sin²φ + 4 sin²(φ+ψ) dφ, Q = 4 ((S² + T²) L − 2 S T cos ω sin L), S = sin(qψ/2), T =
/// sin((q−2)ψ/2).
#[doc(alias("corner singularity", "L-shape"))]
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SectorPower {
    part: Part,
    exponent: f64,
    frequency: f64,
    angle: f64,
    radius: f64,
}

/// Number of points in each direction, and that of the rule for the error estimate.
const POINTS: [usize; 2] = [16, 22];
/// Message: what limits the accuracy.
const LIMIT: &str = "the largest number of quadrature points is reached, or rounding of a + 1 - s limits the accuracy";
/// Largest width of a cell.
const CELL: f64 = 0.5;
/// Largest opening angle; beyond it the two sides come close to each other.
const WIDEST: f64 = 1.75 * PI;
/// Value of x from which e^{-x} is negligible.
const NOTHING: f64 = 40.0;

/// The elastic displacement v above on a half disc.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ElasticCorner {
    alpha: f64,
    /// r^p sin(pφ)
    power: SectorPower,
}

impl ElasticCorner {
    /// The displacement v for 0 < φ < π, r < R.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless 0 < p ≤ 20, α > 0 and R > 0.
    pub(crate) fn new(power: f64, alpha: f64, radius: f64) -> Result<Self> {
        Error::require("power p", power, "(0, 20]", power > 0.0 && power <= 20.0)?;
        Error::require("alpha", alpha, "(0, inf)", alpha > 0.0 && alpha.is_finite())?;
        Ok(Self { alpha, power: SectorPower::new(power, power, PI, radius)? })
    }

    /// The seminorm |∇v|_s, which scales like R^{p−s}.
    ///
    /// # Errors
    /// As [`SectorPower::seminorm`], with a = p − 1.
    pub(crate) fn gradient_seminorm(&self, order: Order, tolerance: Tolerance) -> Result<Estimate> {
        let (power, alpha) = (self.power.exponent, self.alpha);
        let q = power - 1.0;
        let part = |part, frequency, weight: f64| {
            let one = SectorPower { part, frequency, exponent: q, ..self.power };
            one.seminorm(order, tolerance)?.times(power * weight.sqrt())
        };
        let rotation = part(Part::Rotation, q.abs(), 2.0 * alpha * alpha)?;
        let sine = part(Part::Sine, q.abs(), 2.0 * (1.0 + 2.0 * alpha))?;
        let bend = part(Part::Bend, (q - 2.0).abs().max(1.0), 0.5 * q * q)?;
        accept("seminorm", root_of_squares(&[rotation, sine, bend])?, tolerance, LIMIT)
    }
}

impl SectorPower {
    /// The function r^a sin(bφ) for r < R, 0 < φ < ω.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless −1 < a ≤ 20, 0 < b ≤ 20, 0 < ω ≤ 7π/4, R > 0.
    pub(crate) fn new(exponent: f64, frequency: f64, angle: f64, radius: f64) -> Result<Self> {
        Error::require("exponent a", exponent, "(-1, 20]", exponent > -1.0 && exponent <= 20.0)?;
        Error::require("frequency b", frequency, "(0, 20]", frequency > 0.0 && frequency <= 20.0)?;
        Error::require("angle", angle, "(0, 7 pi/4]", angle > 0.0 && angle <= WIDEST)?;
        Error::require("radius", radius, "(0, inf)", radius > 0.0 && radius.is_finite())?;
        Ok(Self { part: Part::Sine, exponent, frequency, angle, radius })
    }

    /// The seminorm |∇w|_s of the harmonic r^p sin(pφ), which scales like R^{p−s}; `None` if a ≠ b.
    ///
    /// # Errors
    /// As [`SectorPower::seminorm`], with a = p − 1.
    pub(crate) fn gradient_seminorm(
        &self,
        order: Order,
        tolerance: Tolerance,
    ) -> Result<Option<Estimate>> {
        let power = self.exponent;
        if self.frequency != power {
            return Ok(None);
        }
        let gradient = Self {
            part: Part::Rotation,
            exponent: power - 1.0,
            frequency: (power - 1.0).abs(),
            ..*self
        };
        gradient.seminorm(order, tolerance)?.times(power.abs()).map(Some)
    }

    /// The seminorm |w|_s, which scales like R^{a+1−s}.
    ///
    /// # Errors
    /// [`Error::InfiniteNorm`] for a ≤ s − 1, [`Error::ToleranceNotMet`].
    pub(crate) fn seminorm(&self, order: Order, tolerance: Tolerance) -> Result<Estimate> {
        let gap = self.exponent + order.complement();
        if gap <= 0.0 {
            let why = "r^a times a smooth angular part is in H^s near a corner only for a > s - 1";
            return Err(Error::InfiniteNorm { order: order.value(), why });
        }
        let [value, judge] = POINTS.map(|n| self.integral(order, n));
        let ((value, points), (judge, more)) = (value?, judge?);
        let work = Work { points: points + more, ..Work::default() };
        // What the rounding of a does where a + 1 − s is small.
        let rounding = value * (ENTRY_ROUNDING + f64::EPSILON / gap);
        let squared = Estimate::new(judge / gap, ((judge - value).abs() + rounding) / gap, work)?;
        accept("seminorm", squared.sqrt()?.times(self.radius.powf(gap))?, tolerance, LIMIT)
    }

    /// The double integral with n points in each direction, and the total number of points.
    fn integral(&self, order: Order, n: usize) -> Result<(f64, u64)> {
        let near = self.angle.min(1.0);
        let (plain, power) = (Rule::gauss_legendre(n)?, 2.0 * order.complement() - 1.0);
        let weighted = Rule::gauss_jacobi(n, 0.0, power)?;
        let (mut sum, mut points) = (0.0, 0);
        let cells = (near / CELL).max(self.frequency * near / PI).ceil();
        // The square next to the singular point in Duffy's coordinates: the part ξ < near/cells, then the
        // rest.
        let inner = near / cells;
        for (xi, v) in weighted.iter() {
            for (t, w) in plain.iter() {
                let size = inner * xi;
                let scale = size * xi.powf(-power);
                let both =
                    self.density(order, size, size * t) + self.density(order, size * t, size);
                sum += inner * v * w * scale * both;
                points += 2;
            }
        }
        let mut rectangle = |u: [f64; 2], psi: [f64; 2]| {
            for (s, v) in plain.iter() {
                for (t, w) in plain.iter() {
                    let at = [u[0] + (u[1] - u[0]) * s, psi[0] + (psi[1] - psi[0]) * t];
                    sum += v
                        * w
                        * (u[1] - u[0])
                        * (psi[1] - psi[0])
                        * self.density(order, at[0], at[1]);
                    points += 1;
                }
            }
        };
        let decay = 2.0 * (1.0 + self.exponent.min(0.0));
        let depth = NOTHING / decay + 2.0;
        let grown = |end: f64, most: f64| {
            let mut cuts = vec![0.0, inner];
            while cuts[cuts.len() - 1] < end {
                let last = cuts[cuts.len() - 1];
                cuts.push((last + last.min(most)).min(end));
            }
            cuts
        };
        let widest = CELL.min(1.0 / self.frequency);
        let (us, psis) =
            (grown(depth, 1.0 / (1.0 + self.exponent.abs())), grown(self.angle, widest));
        for (i, u) in us.windows(2).enumerate() {
            for (j, psi) in psis.windows(2).enumerate() {
                if (i, j) != (0, 0) && psi[1] > psi[0] {
                    rectangle([u[0], u[1]], [psi[0], psi[1]]);
                }
            }
        }
        Ok((sum, points))
    }

    fn density(&self, order: Order, u: f64, psi: f64) -> f64 {
        let (b, s) = (self.frequency, order.value());
        let rest = self.angle - psi;
        let (tau, one_minus) = ((-self.exponent * u).exp(), -(-self.exponent * u).exp_m1());
        let half = (0.5 * b * psi).sin();
        // P of sin(bφ).
        let sines = |b: f64| {
            let ends =
                (2.0 * b * rest).sin() + (2.0 * b * self.angle).sin() - (2.0 * b * psi).sin();
            rest - ends / (4.0 * b)
        };
        let (p, q) = match self.part {
            Part::Rotation => (2.0 * rest, 4.0 * half * half * rest),
            Part::Sine => {
                let q = 2.0 * half * half * (rest + (b * self.angle).cos() * (b * rest).sin() / b);
                (sines(b), q)
            }
            Part::Bend => {
                let [first, second] = [0.0, 2.0].map(|k| (0.5 * (self.exponent - k) * psi).sin());
                let mixed = 2.0 * first * second * self.angle.cos() * rest.sin();
                (4.0 * sines(1.0), 4.0 * ((first * first + second * second) * rest - mixed))
            }
        };
        let distance = 4.0 * ((0.5 * u).sinh().powi(2) + (0.5 * psi).sin().powi(2));
        let weight = (-order.complement() * u - (1.0 + s) * distance.ln()).exp();
        weight * (one_minus * one_minus * p + 2.0 * tau * q)
    }
}
