//! The smallest positive eigenvalue of A x = λ M x from a dense elimination without subtraction.
//!
//! A is the matrix of a network: xᵀA x = Σ_{i<j} c_ij (x_i − x_j)² + Σ_i g_i x_i², with the
//! conductances c_ij = −a_ij. Elimination of node k with the pivot d = g_k + Σ_j c_kj keeps this form,
//!   c_ij += c_ik c_kj / d,  g_i += c_ik g_k / d,
//! and needs no diagonal: where the conductances are positive nothing is subtracted, and all numbers
//! are accurate relative to themselves, whatever the condition number (Grassmann, Taksar & Heyman,
//! Oper. Res. 33 (1985) 1107-1116; O'Cinneide, Numer. Math. 65 (1993) 109-120). Conductances of
//! neighbouring hat functions are negative for small orders, where the condition number is moderate.
//!
//! 1/λ is the largest eigenvalue of T = A⁻¹M, which is symmetric in the product of M. Its
//! eigenvectors are computed in a Krylov space of T with full orthogonalisation: errors of rounding are
//! relative to 1/λ, on short elements too, where those of the products with A are relative to their
//! largest eigenvalue.

use super::Network;
use crate::numeric::dense::{symmetric_eigen, times_transpose};
use crate::numeric::sum::pairwise_dot;
use nalgebra::DMatrix;

/// Number of nodes that are eliminated before the others are changed, by a product of matrices.
const PANEL: usize = 48;

/// Largest dimension of the Krylov space, and the residual in units of 1/λ at which it is large enough.
const KRYLOV: usize = 160;
const CONVERGED: f64 = 1e-13;

/// A network after elimination.
pub(crate) struct Elimination {
    /// the entries c_jk of column k, j > k, when node k was eliminated
    between: DMatrix<f64>,
    /// 1/d of all nodes, 0 for the last one if no node is connected to the ground
    inverse: Vec<f64>,
    has_ground: bool,
}

impl Elimination {
    /// The network with the conductances c_ij, i > j, and g_i; `None` if a pivot is not positive.
    /// Cost O(n³).
    pub(crate) fn new(mut between: DMatrix<f64>, mut ground: Vec<f64>) -> Option<Self> {
        let n = between.nrows();
        let has_ground = ground.iter().any(|g| *g != 0.0);
        let mut inverse = vec![0.0; n];
        for first in (0..n).step_by(PANEL) {
            let end = (first + PANEL).min(n);
            for k in first..end {
                let (before, own) = between.as_mut_slice().split_at_mut(k * n);
                let own = &mut own[k + 1..n];
                // The nodes of the panel before this one change its column here.
                for p in first..k {
                    let column = &before[p * n..(p + 1) * n];
                    let share = column[k] * inverse[p];
                    own.iter_mut()
                        .zip(&column[k + 1..])
                        .for_each(|(c, beside)| *c += share * beside);
                    ground[k] += share * ground[p];
                }
                let pivot = ground[k] + own.iter().sum::<f64>();
                if k + 1 < n || has_ground {
                    if !(pivot > 0.0 && pivot.is_finite()) {
                        return None;
                    }
                    inverse[k] = pivot.recip();
                }
            }
            if end == n {
                break;
            }
            let columns = between.view((end, first), (n - end, end - first)).into_owned();
            let mut scaled = columns.clone();
            for (k, mut column) in scaled.column_iter_mut().enumerate() {
                column *= inverse[first + k];
            }
            for (k, column) in scaled.column_iter().enumerate() {
                let of_panel = ground[first + k];
                column.iter().zip(&mut ground[end..]).for_each(|(c, g)| *g += c * of_panel);
            }
            let change = times_transpose(&scaled, &columns);
            for j in end..n {
                let column = &mut between.as_mut_slice()[j * n + j + 1..(j + 1) * n];
                let change = &change.as_slice()[(j - end) * (n - end) + j + 1 - end..];
                column.iter_mut().zip(change).for_each(|(c, change)| *c += change);
            }
        }
        Some(Self { between, inverse, has_ground })
    }

    /// The product A⁻¹ r; without a ground r must sum to zero, and the last value is 0.
    pub(crate) fn solve(&self, r: &[f64]) -> Vec<f64> {
        let n = r.len();
        let below = |k: usize| &self.between.as_slice()[k * n + k + 1..(k + 1) * n];
        let mut x = r.to_vec();
        for k in 0..n {
            let (x, rest) = x[k..].split_at_mut(1);
            let share = x[0] * self.inverse[k];
            rest.iter_mut().zip(below(k)).for_each(|(x, c)| *x += share * c);
        }
        for k in (0..n).rev() {
            x[k] = (x[k] + pairwise_dot(below(k), &x[k + 1..])) * self.inverse[k];
        }
        x
    }

    /// The product A⁻¹ r on functions of mean zero if there is no ground.
    pub(crate) fn solve_without_mean(&self, r: &[f64], masses: &[f64]) -> Vec<f64> {
        if self.has_ground {
            return self.solve(r);
        }
        let total: f64 = masses.iter().sum();
        let excess = r.iter().sum::<f64>() / total;
        let load: Vec<f64> = r.iter().zip(masses).map(|(r, m)| r - excess * m).collect();
        let mut x = self.solve(&load);
        let mean = pairwise_dot(&x, masses) / total;
        x.iter_mut().for_each(|x| *x -= mean);
        x
    }
}

/// The vector of the smallest positive eigenvalue, of norm 1 in the product of M, with the Ritz values
/// of the two smallest ones.
pub(crate) struct Lowest {
    pub(crate) vector: Vec<f64>,
    /// not above the second eigenvalue as far as the Krylov space has found it
    pub(crate) second: f64,
    pub(crate) steps: usize,
}

/// The eigenvector by a Krylov space of A⁻¹M.
pub(crate) fn lowest(elimination: &Elimination, mass: &Network) -> Option<Lowest> {
    let n = elimination.inverse.len();
    let masses = mass.times(&vec![1.0; n]);
    let total: f64 = masses.iter().sum();
    let [mut basis, mut images]: [Vec<Vec<f64>>; 2] = Default::default();
    // No eigenvector is orthogonal to this one.
    let mut next: Vec<f64> = (0..n).map(|i| (1.3 * i as f64).cos() + i as f64 / n as f64).collect();
    let most = KRYLOV.min(n - usize::from(!elimination.has_ground));
    let mut form = DMatrix::zeros(most, most);
    for k in 0..most {
        if !elimination.has_ground {
            let mean = pairwise_dot(&next, &masses) / total;
            next.iter_mut().for_each(|x| *x -= mean);
        }
        let image = mass.times(&next);
        let size = pairwise_dot(&next, &image).sqrt();
        if !(size > 0.0 && size.is_finite()) {
            return None;
        }
        basis.push(next.iter().map(|x| x / size).collect());
        images.push(image.iter().map(|m| m / size).collect());
        next = elimination.solve_without_mean(&images[k], &masses);
        // Twice: the second time what rounding left.
        for pass in 0..2 {
            for j in 0..=k {
                let share = pairwise_dot(&images[j], &next);
                next.iter_mut().zip(&basis[j]).for_each(|(x, v)| *x -= share * v);
                if pass == 0 && j == k {
                    form[(k, k)] = share;
                }
            }
        }
        let beside = pairwise_dot(&next, &mass.times(&next)).max(0.0).sqrt();
        let (values, vectors) = symmetric_eigen(&form.view((0, 0), (k + 1, k + 1)).into_owned())?;
        let residual = |j: usize| beside * vectors[(k, j)].abs();
        let is_last = k + 1 == most || beside <= f64::EPSILON * values[k];
        if is_last || (k > 0 && residual(k) <= CONVERGED * values[k]) {
            let mut vector = vec![0.0; n];
            for (j, v) in basis.iter().enumerate() {
                vector.iter_mut().zip(v).for_each(|(x, v)| *x += vectors[(j, k)] * v);
            }
            let second = if k > 0 { values[k - 1] + residual(k - 1) } else { 0.0 };
            return Some(Lowest { vector, second: second.recip(), steps: k + 1 });
        }
        form[(k, k + 1)] = beside;
        form[(k + 1, k)] = beside;
    }
    None
}
