//! Means of (w(x)−w(y))² |x−y|^{-2-2s} over two simplices that do not touch.
//!
//! Tensor Gauss rules are used; on a triangle the rule is a product after collapsing one side to a corner, x =
//! A + r (B − A + t (C − B)) with the weight 2r. Along a segment of length ℓ at distance d the kernel is
//! analytic in the ellipse with ρ = δ + √(1+δ²), δ = 2d/ℓ, and the error with n points is about ρ^{-2n}. Pieces
//! longer than twice their distance are bisected first. Every mean is computed with n − 2, n − 1 and n points:
//! the Gauss error of a convex kernel has one sign, so that the three values of a whole sum show the rate of
//! convergence.

use super::kernel::InversePower;
use super::simplex::Simplex;
use crate::error::{Error, Result};
use crate::numeric::budget::Budget;
use crate::numeric::scale::power_of_two;
use crate::quadrature::Rule;
use std::sync::OnceLock;

/// Entries (i, j) of a quadratic form in K functions, by three rules.
pub(super) type Levels<const K: usize> = [[[f64; K]; K]; LEVELS];

/// Number of rules that are compared.
pub(super) const LEVELS: usize = 3;
/// Smallest ratio of distance to length of an admissible piece.
const ADMISSIBLE: f64 = 0.5;
/// Share of the digits that is required on average, since only the nearest points are as close as the distance.
const AVERAGE: f64 = 0.75;
/// Smallest number of points of the last rule: the two points of the first rule are exact for the square of a
/// linear function.
const FEWEST: usize = LEVELS + 1;
/// Largest number of points of a rule.
const MOST: usize = 44;
/// Largest number of pieces into which one pair is subdivided.
const PATIENCE: usize = 2_000_000;

/// Message: the work limit is exceeded.
const NEEDLES: &str = "the work limit is reached: thin triangles are subdivided in proportion to their aspect ratio; use a \
     mesh with less elongated triangles, or raise the limit with Tolerance::with_work";

/// Barycentric coordinates (of corners 1 and 2) and weights of sum one.
type Points = Vec<([f64; 2], f64)>;

/// The error for two triangles without a common node that are too close to each other to be separated by
/// bisection.
pub(super) fn too_near(distance: f64, size: f64) -> Error {
    let range = "the range that the quadrature resolves for triangles without a common node";
    Error::OutOfRange { name: "ratio of distance to length", value: distance / size, range }
}

/// The rule with n points in each direction on a simplex of that dimension.
pub(super) fn points(dimension: usize, n: usize) -> Result<&'static Points> {
    static KNOWN: [[OnceLock<Points>; MOST + 1]; 3] =
        [const { [const { OnceLock::new() }; MOST + 1] }; 3];
    let known = &KNOWN[dimension][n];
    if let Some(points) = known.get() {
        return Ok(points);
    }
    let made = match dimension {
        0 => vec![([0.0; 2], 1.0)],
        1 => Rule::gauss_legendre(n)?.iter().map(|(t, w)| ([t, 0.0], w)).collect(),
        _ => {
            let (radial, across) = (Rule::gauss_jacobi(n, 0.0, 1.0)?, Rule::gauss_legendre(n)?);
            let pairs = radial.iter().flat_map(|r| across.iter().map(move |t| (r, t)));
            pairs.map(|((r, v), (t, w))| ([r * (1.0 - t), r * t], 2.0 * v * w)).collect()
        }
    };
    Ok(known.get_or_init(|| made))
}

/// The kernel |x−y|^{-2-2s} and the requested accuracy of every mean.
#[derive(Debug)]
pub(super) struct Leaves {
    /// 1 + s
    power: f64,
    kernel: InversePower,
    /// ln(1 / relative accuracy)
    digits: f64,
    budget: Budget,
}

impl Leaves {
    /// The integrals with at most this many kernel evaluations for all pairs together.
    pub(super) fn new(s: f64, accuracy: f64, evaluations: u64) -> Self {
        Self {
            power: 1.0 + s,
            kernel: InversePower::new(1.0 + s),
            digits: -accuracy.ln(),
            budget: Budget::new(evaluations, accuracy),
        }
    }

    /// The number of points in each direction for a piece of length ℓ at distance d.
    fn count(&self, size: f64, distance: f64) -> usize {
        if size == 0.0 {
            return FEWEST;
        }
        let delta = 2.0 * distance / size;
        let logarithm = (delta + (1.0 + delta * delta).sqrt()).ln();
        ((0.5 * AVERAGE * self.digits / logarithm).ceil() as usize + 1).clamp(FEWEST, MOST)
    }

    /// `weight` times the mean over both simplices; the evaluations are counted in `work`.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if the two simplices touch or are too close to each other.
    pub(super) fn mean<const K: usize>(
        &self,
        a: &Simplex<K>,
        b: &Simplex<K>,
        weight: [f64; 2],
        work: &mut u64,
    ) -> Result<Levels<K>> {
        let mut sum = [[[0.0; K]; K]; LEVELS];
        let mut open = vec![(*a, *b, weight)];
        let mut patience = PATIENCE;
        while let Some((a, b, weight)) = open.pop() {
            let ((edge, size), (other_edge, other)) = (a.longest(), b.longest());
            let distance = a.distance(&b);
            if patience == 0 || distance <= 0.0 {
                return Err(too_near(distance, size.max(other)));
            }
            patience -= 1;
            if size.max(other) * ADMISSIBLE <= distance {
                let counts = [self.count(size, distance), self.count(other, distance)];
                let count = self.leaf(&a, &b, counts, distance, weight, &mut sum)?;
                if !self.budget.spend(count) {
                    return Err(self.budget.spent("seminorm", NEEDLES));
                }
                *work += count;
            } else if size >= other {
                open.extend(a.halves(edge).map(|half| (half, b, [0.5 * weight[0], weight[1]])));
            } else {
                open.extend(
                    b.halves(other_edge).map(|half| (a, half, [weight[0], 0.5 * weight[1]])),
                );
            }
        }
        Ok(sum)
    }

    fn leaf<const K: usize>(
        &self,
        a: &Simplex<K>,
        b: &Simplex<K>,
        counts: [usize; 2],
        distance: f64,
        weight: [f64; 2],
        sum: &mut Levels<K>,
    ) -> Result<u64> {
        let unit = power_of_two(distance);
        // weight₁ weight₂ unit^{-2-2s}, without overflow on the way
        let half = |w: f64| w / unit * unit.powf(1.0 - self.power);
        let weight = half(weight[0]) * half(weight[1]);
        let mut work = 0;
        for (level, sum) in sum.iter_mut().enumerate() {
            let back = LEVELS - 1 - level;
            let first = placed(a, a, unit, counts[0] - back)?;
            let second = placed(b, a, unit, counts[1] - back)?;
            work += (first.len() * second.len()) as u64;
            let mut part = [[0.0; K]; K];
            for (x, u, v) in &first {
                for (y, z, w) in &second {
                    let (dx, dy) = (x[0] - y[0], x[1] - y[1]);
                    let kernel = v * w * self.kernel.at(dx * dx + dy * dy);
                    add_square(&mut part, kernel, std::array::from_fn(|k| u[k] - z[k]));
                }
            }
            for i in 0..K {
                for j in 0..=i {
                    sum[i][j] += weight * part[i][j];
                }
            }
        }
        Ok(work)
    }
}

/// Adds k d dᵀ to the lower triangle of a matrix.
#[inline]
pub(super) fn add_square<const K: usize>(entries: &mut [[f64; K]; K], k: f64, d: [f64; K]) {
    for i in 0..K {
        for j in 0..=i {
            entries[i][j] += k * d[i] * d[j];
        }
    }
}

type Placed<const K: usize> = Vec<(super::geometry::Point, [f64; K], f64)>;

/// The points of a rule relative to the first corner of `origin`, in units, with the values there and the
/// weights.
fn placed<const K: usize>(
    s: &Simplex<K>,
    origin: &Simplex<K>,
    unit: f64,
    n: usize,
) -> Result<Placed<K>> {
    let (corners, origin) = (s.corners(), origin.corners()[0].at);
    let (first, second) = (corners[1.min(s.dimension())], corners[s.dimension()]);
    let start = corners[0];
    let place = |&(t, w): &([f64; 2], f64)| {
        let mixed = |a: f64, b: f64, c: f64| a + (t[0] * (b - a) + t[1] * (c - a));
        let coordinate = |k: usize| {
            let at = (start.at[k] - origin[k]) / unit;
            at + (t[0] * (first.at[k] - start.at[k]) + t[1] * (second.at[k] - start.at[k])) / unit
        };
        let values =
            std::array::from_fn(|k| mixed(start.values[k], first.values[k], second.values[k]));
        ([coordinate(0), coordinate(1)], values, w)
    };
    Ok(points(s.dimension(), n)?.iter().map(place).collect())
}
