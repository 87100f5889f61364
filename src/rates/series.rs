//! A power beside the terms of a smooth part, fitted to squared errors: e² = A h^{2p} + Σ_q B_q h^q.
//!
//! Relative least squares in the coefficients for each p by orthogonalisation (h^{2p} last), then in p: a
//! grid, and golden section about its best point. Where e is the distance to a discrete solution of mesh size
//! h_r on the same family of meshes, e² is that of h less that of h_r, and every h^q becomes h^q − h_r^q.
//! Cost: O(levels) per value of p.

use crate::numeric::grid::smallest_on_grid;
use crate::numeric::search::golden_section;
/// Orders tried for the power: below it no finite element error falls, above it nothing is told from the
/// smooth part h².
const POWERS: (f64, f64) = (0.05, 0.995);
/// Steps of the grid over them, 0.005 each: finer than any two minima lie apart.
const STEPS: usize = 190;
/// The minimum is located to this: two digits below the smallest half-width of interest.
const RESOLUTION: f64 = 1e-7;
/// A column that shrinks by this under orthogonalisation is a combination of the others as far as binary64
/// tells.
const DEPENDENT: f64 = 1e-9;

/// e² = A h^{2p} + Σ B_q h^q on some levels.
pub(super) struct Series<'a> {
    /// (h, e), coarsest first.
    pub(super) points: &'a [(f64, f64)],
    /// The q of the smooth part.
    pub(super) exponents: &'a [f64],
    /// Mesh size of a discrete reference; 0 without one.
    pub(super) reference: f64,
}

/// The least squares problem in the coefficients for one p.
struct Coefficients {
    /// Σ (model/e² − 1)².
    misfit: f64,
    /// A.
    leading: f64,
    /// Orthonormal columns of all terms.
    basis: Vec<Vec<f64>>,
}

impl Series<'_> {
    /// The best p with A > 0 and its standard error from the residuals; `None` where it is an end of the
    /// range.
    pub(super) fn power(&self) -> Option<(f64, f64)> {
        let (low, high) = POWERS;
        let (best, (a, b)) = smallest_on_grid(low, high, STEPS, |p| self.misfit(p));
        if best == 0 || best == STEPS {
            return None;
        }
        let order = golden_section(a, b, RESOLUTION, |p| self.misfit(p));
        let fit = self.coefficients(order)?;
        (fit.leading > 0.0).then(|| (order, self.standard_error(order, &fit)))
    }

    fn misfit(&self, p: f64) -> f64 {
        self.coefficients(p).map_or(f64::INFINITY, |fit| fit.misfit)
    }

    /// Linearised: residual variance over the share of ∂(model)/∂p that the other terms cannot take over.
    fn standard_error(&self, p: f64, fit: &Coefficients) -> f64 {
        let free = self.points.len() as f64 - self.exponents.len() as f64 - 2.0;
        let largest = self.points[0].0;
        let term = |h: f64| if h > 0.0 { (h / largest).powf(2.0 * p) * (h / largest).ln() } else { 0.0 };
        let slope = |&(h, e): &(f64, f64)| 2.0 * fit.leading * (term(h) - term(self.reference)) / (e * e);
        let mut column: Vec<f64> = self.points.iter().map(slope).collect();
        orthogonalise(&mut column, &fit.basis);
        let own = dot(&column, &column);
        if free > 0.0 && own > 0.0 { (fit.misfit / free / own).sqrt() } else { f64::INFINITY }
    }

    /// `None` where the terms cannot be told apart.
    fn coefficients(&self, p: f64) -> Option<Coefficients> {
        let largest = self.points[0].0;
        let column = |q: f64| -> Vec<f64> {
            let term = |h: f64| (h / largest).powf(q) - (self.reference / largest).powf(q);
            self.points.iter().map(|&(h, e)| term(h) / (e * e)).collect()
        };
        let mut rest = vec![1.0; self.points.len()];
        let mut basis: Vec<Vec<f64>> = Vec::new();
        let mut leading = 0.0;
        for q in self.exponents.iter().copied().chain([2.0 * p]) {
            let mut v = column(q);
            let before = dot(&v, &v).sqrt();
            orthogonalise(&mut v, &basis);
            let length = dot(&v, &v).sqrt();
            if length <= DEPENDENT * before {
                return None;
            }
            v.iter_mut().for_each(|x| *x /= length);
            let share = dot(&v, &rest);
            subtract(&mut rest, share, &v);
            leading = share / length;
            basis.push(v);
        }
        Some(Coefficients { misfit: dot(&rest, &rest), leading, basis })
    }
}

/// Takes the share of an orthonormal basis from v; twice is enough.
fn orthogonalise(v: &mut [f64], basis: &[Vec<f64>]) {
    for _ in 0..2 {
        for b in basis {
            let share = dot(b, v);
            subtract(v, share, b);
        }
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// a ← a − t b.
fn subtract(a: &mut [f64], t: f64, b: &[f64]) {
    a.iter_mut().zip(b).for_each(|(a, b)| *a -= t * b);
}
