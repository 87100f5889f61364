//! Symmetric tridiagonal matrices K + t M of a mesh as electrical networks: factorizations without
//! cancellation.
//!
//! A row has s_i + c_{i−1} + c_i on the diagonal and −c_i next to it, where c are the conductances between
//! neighbours and s those to the ground. Elimination from left to right preserves this form,
//!   d_i = s_i + c_i,  s_{i+1} += s_i c_i / d_i,
//! without subtraction if c ≥ 0: rows with elements of length 1e-100 next to elements of length 1 are
//! factorized to full accuracy. Where c < 0 (t h² > 6, the mass) the conductance to the ground dominates.

use crate::mesh::Mesh;

/// The basis functions of a Gram matrix.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Basis {
    /// hat functions of all nodes
    Hats,
    /// hat functions of the inner nodes, zero outside the mesh
    InnerHats,
    /// indicator functions of the elements
    Indicators,
}

impl Basis {
    /// The number of basis functions.
    pub(crate) fn count(self, mesh: &Mesh) -> usize {
        match self {
            Self::Hats => mesh.len() + 1,
            Self::InnerHats => mesh.len() - 1,
            Self::Indicators => mesh.len(),
        }
    }
}

/// Conductances between neighbours and to the ground.
#[derive(Debug, Clone)]
pub(crate) struct Network {
    pub(crate) between: Vec<f64>,
    pub(crate) ground: Vec<f64>,
}

impl Network {
    /// The matrix a K + t M, K of (u′, v′) and M of L²; for indicator functions K has the conductances
    /// 1/distance between the midpoints.
    pub(crate) fn new(mesh: &Mesh, basis: Basis, a: f64, t: f64) -> Self {
        let h = mesh.lengths();
        let link = |h: f64| a / h - t * h / 6.0;
        match basis {
            Basis::Hats => {
                let mut ground = vec![0.0; h.len() + 1];
                for (e, h) in h.iter().enumerate() {
                    ground[e] += 0.5 * t * h;
                    ground[e + 1] += 0.5 * t * h;
                }
                Self { between: h.iter().map(|&h| link(h)).collect(), ground }
            }
            Basis::InnerHats => {
                let last = h.len() - 1;
                let mut ground: Vec<f64> = h.windows(2).map(|h| 0.5 * t * (h[0] + h[1])).collect();
                if let Some(first) = ground.first_mut() {
                    *first += link(h[0]);
                }
                if let Some(end) = ground.last_mut() {
                    *end += link(h[last]);
                }
                let inner = h.get(1..last).unwrap_or_default();
                Self { between: inner.iter().map(|&h| link(h)).collect(), ground }
            }
            Basis::Indicators => Self {
                between: h.windows(2).map(|h| 2.0 * a / (h[0] + h[1])).collect(),
                ground: h.iter().map(|h| t * h).collect(),
            },
        }
    }

    /// The product of the matrix with x.
    pub(crate) fn times(&self, x: &[f64]) -> Vec<f64> {
        let mut y: Vec<f64> = self.ground.iter().zip(x).map(|(s, x)| s * x).collect();
        for (i, c) in self.between.iter().enumerate() {
            let current = c * (x[i + 1] - x[i]);
            y[i] -= current;
            y[i + 1] += current;
        }
        y
    }

    /// The pivots d_i; they have the same signs as the eigenvalues.
    pub(crate) fn pivots(&self) -> Vec<f64> {
        let mut ground = 0.0;
        let beside = self.between.iter().copied().chain([0.0]);
        self.ground
            .iter()
            .zip(beside)
            .map(|(own, c)| {
                let s = own + ground;
                let pivot = s + c;
                ground = s * (c / pivot);
                pivot
            })
            .collect()
    }

    /// The factors L D Lᵀ.
    pub(crate) fn factor(&self) -> Tridiagonal {
        let pivots = self.pivots();
        let multipliers = self.between.iter().zip(&pivots).map(|(c, d)| c / d).collect();
        Tridiagonal { multipliers, inverse: pivots.iter().map(|d| 1.0 / d).collect() }
    }
}

/// A factorized tridiagonal matrix.
#[derive(Debug, Clone)]
pub(crate) struct Tridiagonal {
    multipliers: Vec<f64>,
    inverse: Vec<f64>,
}

impl Tridiagonal {
    /// The solution for the right-hand side r.
    pub(crate) fn solve(&self, r: &[f64]) -> Vec<f64> {
        let mut x = r.to_vec();
        for (i, m) in self.multipliers.iter().enumerate() {
            x[i + 1] += m * x[i];
        }
        let mut next = 0.0;
        for i in (0..x.len()).rev() {
            let multiplier = self.multipliers.get(i).copied().unwrap_or(0.0);
            next = x[i] * self.inverse[i] + multiplier * next;
            x[i] = next;
        }
        x
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_solution_solves_whatever_the_lengths() {
        let mesh = Mesh::from_lengths(&[1.0, 1e-100, 2e-100, 0.5, 1e-9, 3.0]).unwrap();
        for basis in [Basis::Hats, Basis::InnerHats, Basis::Indicators] {
            for t in [1e-8, 1.0, 1e8] {
                let network = Network::new(&mesh, basis, 1.0, t);
                // Currents between tiny elements would hide the load of the others: equal values.
                let x = vec![1.0; basis.count(&mesh)];
                let solved = network.factor().solve(&network.times(&x));
                for (a, b) in solved.iter().zip(&x) {
                    assert!((a - b).abs() < 1e-14 * b, "{basis:?} {t}: {a} {b}");
                }
            }
        }
    }
}
