//! A lower bound of C(q): the quotient ‖u‖\_{L^q}/‖u‖_ν of functions computed by an ascent.

use super::upper::{check, critical_exponent};
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance};
use crate::gram::{gram_linears, mass_form};
use crate::numeric::dense::{Cholesky, product};
use crate::numeric::last::Last;
use crate::quadrature::Rule;
use crate::{Function, Mesh, Order};
use nalgebra::DMatrix;
use std::sync::Arc;

/// Largest number of steps of the ascent; some dozen steps suffice if the maximum is isolated.
const STEPS: usize = 400;

/// Relative increase per step below which the ascent has converged.
const RISE: f64 = 1e-12;

/// Gauss points per cell in the ascent; the quotient that is returned is integrated again, to its tolerance.
const POINTS: usize = 12;

/// Largest exponent for which the layers of a mesh are chosen; for larger ones they would exceed the range of
/// binary64.
const LARGEST: f64 = 1000.0;
/// The same for a critical exponent.
const LARGEST_CRITICAL: f64 = 800.0;
/// Smallest exponent for which the layers at ν = 1/2 are chosen.
const USUAL: f64 = 200.0;

/// Cache of the last space, whose factorized matrix is reused for other exponents
/// q.
static LAST: Last<EmbeddingSpace> = Last::none();

/// Grading towards the end of the interval.
const RATIO: f64 = 0.6;

/// The number of layers that resolve the extremal functions for exponents up to q: down to e^{-0.6 q}, beyond
/// ln(1/θ) = q/2, where these functions are cut off.
fn layers(q: f64) -> usize {
    (30.0 + 0.6 * q.clamp(USUAL, LARGEST) / -RATIO.ln()) as usize
}

/// A mesh of (0, 1) with those layers at 0.
pub(super) fn graded(q: f64) -> Result<Mesh> {
    Mesh::geometric(layers(q), RATIO, 1.0)
}

/// A function and its quotient ‖u‖\_{L^q}/‖u‖_ν: a lower bound of C(q).
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Trial {
    /// The quotient; its error is that of its evaluation.
    pub(super) quotient: Estimate,
    pub(super) mesh: Mesh,
    /// Values at the nodes.
    pub(super) values: Vec<f64>,
}

/// Piecewise linear functions on a mesh graded geometrically towards 0, and the iteration u ← B⁻¹ ∫ |u|^{q−2} u
/// φ_i, B the matrix of ‖·‖²_ν: the quotient increases, since ‖·‖_q is convex. Cost: O(N³) once, O(N²) per
/// step.
#[derive(Debug, Clone)]
pub(super) struct EmbeddingSpace {
    order: Order,
    layers: usize,
    partition: Mesh,
    norm: DMatrix<f64>,
    factor: Cholesky,
}

impl EmbeddingSpace {
    /// A space for the exponent q; the last one if order and number of layers are the same. For ν < 1/2 the layers
    /// are chosen for four times the critical exponent, or for LARGEST_CRITICAL if that is smaller.
    ///
    /// # Errors
    /// As [`EmbeddingSpace::new`].
    pub(super) fn of(order: Order, q: f64) -> Result<Arc<Self>> {
        let critical = critical_exponent(order);
        let layers = if critical.is_finite() {
            let q = (4.0 * critical).min(LARGEST_CRITICAL);
            (30.0 + 0.6 * q / -RATIO.ln()) as usize
        } else {
            layers(q)
        };
        let is_same = |space: &Self| space.layers == layers && space.order == order;
        LAST.get(is_same, || Self::new(order, layers, RATIO))
    }

    /// The space on elements that shrink by `ratio` from 1/4 to 1/4 ratio^layers towards the end 0, and equal
    /// elements on the rest of (0, 1).
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a ratio outside (0, 1), or if elements are too short.
    fn new(order: Order, layers: usize, ratio: f64) -> Result<Self> {
        let mut lengths = Mesh::geometric(layers, ratio, 0.25)?.lengths().to_vec();
        let rest = (3.0 * ratio / (1.0 - ratio)).ceil().max(4.0) as usize;
        lengths.extend(vec![0.75 / rest as f64; rest]);
        let partition = Mesh::from_lengths(&lengths)?;
        let norm = gram_linears(&partition, order) + mass_form(&partition);
        let pivot = partition.len();
        let factor = Cholesky::new(&norm)
            .ok_or(Error::NotPositiveDefinite { what: "Gram matrix of the norm", pivot })?;
        Ok(Self { order, layers, partition, norm, factor })
    }

    /// The best quotient obtained by ascents from functions concentrated at 0 to several degrees, and from u =
    /// 1.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for q outside the domain.
    pub(super) fn climb(&self, q: f64, tolerance: Tolerance) -> Result<Trial> {
        check(self.order, q)?;
        let nodes = self.partition.from_left();
        let depth = (nodes[1] / nodes[nodes.len() - 1]).ln();
        let mut best = self.trial(q, &vec![1.0; nodes.len()], tolerance)?;
        for fraction in [0.1, 0.3, 0.6] {
            // (λ² + x²)^{-(1−2ν)/4}-like bubbles for ν < 1/2, logarithms at 1/2, cut off at λ.
            let lambda = (fraction * depth).exp();
            let decay = 0.5 * self.order.one_minus_twice();
            let start: Vec<f64> = nodes
                .iter()
                .map(|x| {
                    let log = (lambda * lambda + x * x).ln() * 0.5;
                    // (1 + λ − x^...)/decay → −ln x as the decay vanishes
                    0.1 + if decay > 1e-3 { (-2.0 * decay * log).exp() } else { 0.1 - log }
                })
                .collect();
            let found = self.ascend(q, start, tolerance)?;
            if found.quotient.value > best.quotient.value {
                best = found;
            }
        }
        Ok(best)
    }

    fn ascend(&self, q: f64, start: Vec<f64>, tolerance: Tolerance) -> Result<Trial> {
        let rule = Rule::gauss_legendre(POINTS)?;
        let mut values = start;
        let mut last = 0.0;
        for _ in 0..STEPS {
            let largest = values.iter().fold(0.0f64, |m, v| m.max(v.abs()));
            values.iter_mut().for_each(|v| *v /= largest);
            let (load, power) = self.load(q, &values, &rule);
            let quotient = power.powf(1.0 / q) / self.energy(&values).sqrt();
            if quotient <= last * (1.0 + RISE) {
                break;
            }
            last = quotient;
            let next = self.factor.solve(&load);
            values = (0..values.len()).map(|i| next[(i, 0)]).collect();
        }
        self.trial(q, &values, tolerance)
    }

    /// The integrals (∫ |u|^{q−2} u φ_i, ∫ |u|^q).
    fn load(&self, q: f64, values: &[f64], rule: &Rule) -> (DMatrix<f64>, f64) {
        let mut load = DMatrix::zeros(values.len(), 1);
        let mut power = 0.0;
        for (i, &h) in self.partition.lengths().iter().enumerate() {
            for (t, w) in rule.iter() {
                let u = values[i] * (1.0 - t) + values[i + 1] * t;
                let weight = h * w * u.abs().powf(q - 1.0).copysign(u);
                load[(i, 0)] += weight * (1.0 - t);
                load[(i + 1, 0)] += weight * t;
                power += weight * u;
            }
        }
        (load, power)
    }

    fn energy(&self, values: &[f64]) -> f64 {
        let u = DMatrix::from_fn(values.len(), 1, |i, _| values[i]);
        u.dot(&product(&self.norm, &u))
    }

    fn trial(&self, q: f64, values: &[f64], tolerance: Tolerance) -> Result<Trial> {
        let function = Function::linears(&self.partition, values)?;
        let top = function.lp(q, tolerance)?;
        let norm = function.norm(self.order, tolerance)?;
        let mut quotient = top.quotient(norm)?;
        quotient.work.factorizations = 1;
        Ok(Trial { quotient, mesh: self.partition.clone(), values: values.to_vec() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_finer_mesh_does_not_change_the_quotient_much() {
        let coarse = EmbeddingSpace::new(Order::HALF, 100, 0.5).unwrap();
        let fine = EmbeddingSpace::new(Order::HALF, 195, 0.7).unwrap();
        for q in [16.0, 50.0, 90.0] {
            let of = |space: &EmbeddingSpace| {
                space.climb(q, Tolerance::balanced()).unwrap().quotient.value
            };
            let (a, b) = (of(&coarse), of(&fine));
            assert!(a <= b * (1.0 + 1e-6) && b <= a * 1.003, "{q}: {a} {b}");
        }
        assert!(EmbeddingSpace::new(Order::HALF, 10, 1.5).is_err());
    }
}
