//! The trial space of one triangle: its seminorm of gradients, and the two error norms.
//!
//! Polynomials of degree 2 ... p (the linear ones are interpolated exactly) and, about every corner, the
//! powers r^{2s} times polynomials in the direction: an extremal function solves an equation of order 2 + 2s
//! with point forces at the corners, where it has interpolation conditions, and such a force causes a
//! singularity r^{2s}.

use super::basis::{Polynomials, Powers};
use super::gram::CornerGram;
use super::mixed::{between, corner_rule};
use super::shape::{Barycentric, TriangleShape, barycentric};
use crate::Order;
use crate::error::Result;
use crate::numeric::dense::{product, times_transpose};
use crate::quadrature::Rule;
use nalgebra::DMatrix;

/// Number of points of each half in the rules for powers, beyond the degree.
const MORE: usize = 16;

/// Functions w of the space by their values and gradients, less those of their interpolant if requested.
pub(super) struct Space {
    shape: TriangleShape,
    polynomials: Polynomials,
    powers: Powers,
    /// Values at the three corners, by function.
    corners: Vec<[f64; 3]>,
}

/// The matrices of |∇w|_s², ‖∇(w − Iw)‖² and ‖w − Iw‖².
pub(super) struct Forms {
    pub(super) seminorm: DMatrix<f64>,
    pub(super) derivative: DMatrix<f64>,
    pub(super) l2: DMatrix<f64>,
}

impl Space {
    pub(super) fn new(shape: TriangleShape, degree: usize, exponent: f64, count: usize) -> Self {
        let mut space = Self {
            shape,
            polynomials: Polynomials(degree),
            powers: Powers { exponent, count },
            corners: Vec::new(),
        };
        let unit = [0, 1, 2].map(|k| space.values(barycentric(k, 0.0, 0.5)));
        space.corners =
            (0..unit[0].len()).map(|i| unit.each_ref().map(|values| values[i])).collect();
        space
    }

    /// The values of all functions.
    pub(super) fn values(&self, beta: Barycentric) -> Vec<f64> {
        let powers = (0..3).flat_map(|apex| self.powers.values(apex, beta));
        self.polynomials.values(&self.shape, 0, beta).into_iter().chain(powers).collect()
    }

    /// The values of all functions minus their interpolants.
    pub(super) fn errors(&self, beta: Barycentric) -> Vec<f64> {
        let interpolant = |corners: &[f64; 3]| (0..3).map(|k| corners[k] * beta[k]).sum::<f64>();
        self.values(beta)
            .iter()
            .zip(&self.corners)
            .map(|(value, c)| value - interpolant(c))
            .collect()
    }

    fn gradients(&self, beta: Barycentric) -> Vec<[f64; 2]> {
        let powers = (0..3).flat_map(|apex| self.powers.gradients(&self.shape, apex, beta));
        self.polynomials.gradients(&self.shape, beta).into_iter().chain(powers).collect()
    }

    fn error_gradients(&self, beta: Barycentric) -> Vec<[f64; 2]> {
        let g = self.shape.gradients();
        let slope =
            |c: usize, corners: &[f64; 3]| (0..3).map(|k| corners[k] * g[k][c]).sum::<f64>();
        let all = self.gradients(beta);
        all.iter()
            .zip(&self.corners)
            .map(|(v, k)| [v[0] - slope(0, k), v[1] - slope(1, k)])
            .collect()
    }

    /// The degree of every function: (p, false) of a polynomial, (k, true) of a power.
    pub(super) fn degrees(&self) -> Vec<(usize, bool)> {
        let powers = (0..3 * self.powers.count).map(|i| (i % self.powers.count, true));
        self.polynomials.index().iter().map(|(k, m)| (k + m, false)).chain(powers).collect()
    }

    /// The three forms for an order s < 1.
    ///
    /// # Errors
    /// As the rules.
    pub(super) fn forms(&self, order: Order) -> Result<Forms> {
        let count = self.polynomials.index().len();
        let size = count + 3 * self.powers.count;
        let [derivative, l2] = self.masses(size)?;
        let mut seminorm = DMatrix::<f64>::zeros(size, size);
        let inner = Polynomials(self.polynomials.0 - 1);
        for apex in 0..3 {
            let of = (self.powers.exponent, self.powers.count);
            let gram = CornerGram::new(&self.shape, apex, order, inner, of, apex == 0)?;
            let slopes = self.slopes(apex, inner)?;
            if apex == 0 {
                for slope in &slopes {
                    add(&mut seminorm, [0, 0], &between_slopes(slope, &gram.polynomials, slope));
                }
            }
            let at = count + apex * self.powers.count;
            for (c, slope) in slopes.iter().enumerate() {
                let angular = self.angular(apex, c)?;
                add(&mut seminorm, [0, at], &between_slopes(slope, &gram.mixed, &angular));
                add(&mut seminorm, [at, at], &between_slopes(&angular, &gram.powers, &angular));
            }
            let next = count + (apex + 1) % 3 * self.powers.count;
            let both = between(&self.shape, apex, order, self.powers)?;
            if at < next {
                add(&mut seminorm, [at, next], &both);
            } else {
                add(&mut seminorm, [next, at], &both.transpose());
            }
        }
        let whole = DMatrix::from_fn(size, size, |i, j| seminorm[(i.min(j), i.max(j))]);
        Ok(Forms { seminorm: whole, derivative, l2 })
    }

    /// The forms with ‖D²w‖² instead of the seminorm, for polynomials alone.
    ///
    /// # Errors
    /// As the rules.
    pub(super) fn forms_at_one(&self) -> Result<Forms> {
        let size = self.polynomials.index().len();
        let [derivative, l2] = self.masses(size)?;
        let inner = Polynomials(self.polynomials.0 - 1);
        let second = Self::new(self.shape, self.polynomials.0 - 1, 1.0, 0)
            .slopes(0, Polynomials(inner.0 - 1))?;
        let mut seminorm = DMatrix::<f64>::zeros(size, size);
        for slope in self.slopes(0, inner)? {
            for second in &second {
                let both = product(&slope, second);
                add(&mut seminorm, [0, 0], &times_transpose(&both, &both));
            }
        }
        Ok(Forms { seminorm, derivative, l2 })
    }

    /// Gradients of the polynomials in those of one degree less seen from a corner, by component.
    fn slopes(&self, apex: usize, inner: Polynomials) -> Result<[DMatrix<f64>; 2]> {
        let n = self.polynomials.0 + 2;
        let (radial, across) = (Rule::gauss_jacobi(n, 0.0, 1.0)?, Rule::gauss_legendre(n)?);
        let mut slopes =
            [(); 2].map(|()| DMatrix::zeros(self.polynomials.index().len(), inner.index().len()));
        for (tau, v) in radial.iter() {
            for (a, w) in across.iter() {
                let beta = barycentric(0, tau, a);
                let (mine, theirs) = (
                    self.polynomials.gradients(&self.shape, beta),
                    inner.values(&self.shape, apex, beta),
                );
                for (i, slope) in mine.iter().enumerate() {
                    for (j, value) in theirs.iter().enumerate() {
                        for c in 0..2 {
                            slopes[c][(i, j)] += self.shape.twice() * v * w * slope[c] * value;
                        }
                    }
                }
            }
        }
        Ok(slopes)
    }

    /// τ^{1−μ} times a component of the gradients of the powers, in orthonormal Legendre polynomials of a.
    fn angular(&self, apex: usize, component: usize) -> Result<DMatrix<f64>> {
        let count = self.powers.count;
        let mut matrix = DMatrix::zeros(count, count);
        for (a, w) in Rule::gauss_legendre(count + 1)?.iter() {
            let p = super::basis::Angular::new(count, a).values;
            let gradients = self.powers.angular_gradients(&self.shape, apex, a);
            for i in 0..count {
                for j in 0..count {
                    matrix[(i, j)] += w * gradients[i][component] * p[j];
                }
            }
        }
        Ok(matrix)
    }

    /// The forms ‖∇(w − Iw)‖² and ‖w − Iw‖².
    fn masses(&self, size: usize) -> Result<[DMatrix<f64>; 2]> {
        let rule = if self.powers.count == 0 {
            let n = self.polynomials.0 + 2;
            let (radial, across) = (Rule::gauss_jacobi(n, 0.0, 1.0)?, Rule::gauss_legendre(n)?);
            let point = |tau: f64, v: f64, a: f64, w: f64| {
                (barycentric(0, tau, a), self.shape.twice() * v * w)
            };
            radial
                .iter()
                .flat_map(|(tau, v)| across.iter().map(move |(a, w)| point(tau, v, a, w)))
                .collect()
        } else {
            corner_rule(&self.shape, 0, self.polynomials.0 + MORE)?
        };
        let (mut slopes, mut values) =
            (DMatrix::<f64>::zeros(size, 2 * rule.len()), DMatrix::<f64>::zeros(size, rule.len()));
        for (j, (beta, weight)) in rule.iter().enumerate() {
            let (gradients, errors) = (self.error_gradients(*beta), self.errors(*beta));
            for i in 0..size {
                slopes[(i, 2 * j)] = weight.sqrt() * gradients[i][0];
                slopes[(i, 2 * j + 1)] = weight.sqrt() * gradients[i][1];
                values[(i, j)] = weight.sqrt() * errors[i];
            }
        }
        Ok([times_transpose(&slopes, &slopes), times_transpose(&values, &values)])
    }
}

/// The product A G Bᵀ.
fn between_slopes(a: &DMatrix<f64>, gram: &DMatrix<f64>, b: &DMatrix<f64>) -> DMatrix<f64> {
    times_transpose(&product(a, gram), b)
}

fn add(matrix: &mut DMatrix<f64>, at: [usize; 2], block: &DMatrix<f64>) {
    for i in 0..block.nrows() {
        for j in 0..block.ncols() {
            matrix[(at[0] + i, at[1] + j)] += block[(i, j)];
        }
    }
}
