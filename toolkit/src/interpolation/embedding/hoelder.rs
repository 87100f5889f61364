//! C(α), the best constant of H^{3/2}(0,1) ⊂ C^{0,α}: |u(x) − u(y)| ≤ C(α) |x − y|^α ‖u‖_{3/2}, 0 < α < 1;
//! (E3).

use crate::error::{Error, Result};
use crate::estimate::{Estimate, Work};
use crate::gram::{gram_linears, mass_form};
use crate::numeric::dense::{Cholesky, transpose_times};
use crate::numeric::last::Last;
use crate::quadrature::Rule;
use crate::{Mesh, Order};
use nalgebra::DMatrix;
use std::sync::Arc;

/// Cache of the last increments, for other values of α on the same mesh.
static LAST: Last<EndIncrements> = Last::none();

/// The norms N(0, θ) at the nodes θ of a mesh.
///
/// # Method
///
/// For a fixed pair of points the best constant is the norm of the functional v ↦ ∫\_y^x v on the slopes v =
/// u', by one solve: N(x, y)² = ℓᵀ K⁻¹ ℓ with K the matrix of min_c ‖u + c‖₀² + ‖v‖₀² + |v|²_{1/2}. Over pairs
/// (0, θ), θ the nodes of a mesh graded geometrically towards 0, and piecewise linear v this is a lower bound
/// of C(α) = sup N(x, y)/|x − y|^α. An upper bound follows from Hölder's inequality: |∫ v| ≤ |x−y|^{1−1/q}
/// ‖v‖_q, so that C(α) ≤ C(q) with q = 1/(1−α). Growth: N(0, θ)² θ^{-2} ~ (3/(2π²)) ln(1/θ), hence C(α)² (1−α)
/// → 3/(4π²e) = 0.0279.., attained near ln(1/θ) = 1/(2(1−α)). Cost: O(N³) once, then O(N) per α.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct EndIncrements {
    nodes: Vec<f64>,
    norms: Vec<f64>,
}

impl EndIncrements {
    /// The increments at the nodes of a mesh of (0, 1), which should be graded geometrically towards 0; cached
    /// for the last mesh.
    ///
    /// # Errors
    /// As [`EndIncrements::new`].
    pub(super) fn on(mesh: &Mesh) -> Result<Arc<Self>> {
        LAST.get(|found| found.nodes == mesh.from_left()[1..], || Self::new(mesh))
    }

    /// The increments at the nodes of a mesh of (0, 1).
    ///
    /// # Errors
    /// [`Error::NotPositiveDefinite`] if rounding makes the Gram matrix indefinite.
    fn new(partition: &Mesh) -> Result<Self> {
        let size = partition.len() + 1;
        let norm = gram_linears(partition, Order::HALF)
            + mass_form(partition)
            + primitive_form(partition)?;
        let broken = || Error::NotPositiveDefinite {
            what: "Gram matrix of the norm of H^{3/2}",
            pivot: size,
        };
        let factor = Cholesky::new(&norm).ok_or_else(broken)?;
        // Column k: the integrals of the hats over (0, θ_k), in units of θ_k to stay in range.
        let nodes = partition.from_left()[1..].to_vec();
        let lengths = partition.lengths();
        let functionals = DMatrix::from_fn(size, nodes.len(), |i, k| {
            let left = if i > 0 && i - 1 <= k { lengths[i - 1] } else { 0.0 };
            let right = if i <= k { lengths[i] } else { 0.0 };
            0.5 * (left + right) / nodes[k]
        });
        let solved = factor.solve(&functionals);
        let norms = (0..nodes.len())
            .map(|k| (0..size).map(|i| functionals[(i, k)] * solved[(i, k)]).sum::<f64>().sqrt())
            .collect();
        Ok(Self { nodes, norms })
    }

    /// The maximum over θ of N(0, θ)/θ^α, a lower bound of C(α), and the θ at which it is attained.
    ///
    /// # Errors
    /// None.
    pub(super) fn constant(&self, alpha: f64) -> Result<(Estimate, f64)> {
        let (mut largest, mut place) = (0.0, 1.0);
        for (&theta, &norm) in self.nodes.iter().zip(&self.norms) {
            let value = norm * theta.powf(1.0 - alpha);
            if value > largest {
                (largest, place) = (value, theta);
            }
        }
        let work = Work { points: self.nodes.len() as u64, factorizations: 1, ..Work::default() };
        // Rounding of the solve; what the trial space misses is not part of a lower bound's error.
        Ok((Estimate::new(largest, 1e-12 * largest, work)?, place))
    }
}

/// min_c ‖∫₀^x v + c‖₀² as a form of the nodal values of v; it is exact, since the primitive is quadratic on a
/// cell.
fn primitive_form(partition: &Mesh) -> Result<DMatrix<f64>> {
    let rule = Rule::gauss_legendre(3)?;
    let (lengths, total) = (partition.lengths(), partition.total());
    let size = lengths.len() + 1;
    let mut rows = DMatrix::<f64>::zeros(3 * lengths.len(), size);
    let mut weights = Vec::with_capacity(3 * lengths.len());
    for (i, &h) in lengths.iter().enumerate() {
        for (p, (t, w)) in rule.iter().enumerate() {
            weights.push(h * w);
            for k in 0..=i + 1 {
                let before = if k > 0 { 0.5 * lengths[k - 1] } else { 0.0 };
                rows[(3 * i + p, k)] = match k {
                    _ if k < i => before + 0.5 * lengths[k],
                    _ if k == i => before + h * t * (1.0 - 0.5 * t),
                    _ => 0.5 * h * t * t,
                };
            }
        }
    }
    for k in 0..size {
        let mean = weights.iter().enumerate().map(|(p, w)| w * rows[(p, k)]).sum::<f64>() / total;
        for (p, w) in weights.iter().enumerate() {
            rows[(p, k)] = (rows[(p, k)] - mean) * w.sqrt();
        }
    }
    Ok(transpose_times(&rows, &rows))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn constants_grow_like_the_root_of_one_over_one_minus_alpha() {
        let increments = EndIncrements::new(&Mesh::geometric(250, 0.6, 1.0).unwrap()).unwrap();
        for q in [50.0, 200.0_f64] {
            let (lower, place) = increments.constant(1.0 - 1.0 / q).unwrap();
            assert!(lower.value / q.sqrt() > 0.167, "{q}: {lower}");
            // ln(1/θ) near q/2
            assert!((0.3..0.7).contains(&(-place.ln() / q)), "{q}: {place:e}");
        }
        // A pair inside the interval has a smaller increment than one at the end.
        let theta = 0.6f64.powi(20);
        let distance = |k: usize| (increments.nodes[k] / theta).ln().abs();
        let near = (0..increments.nodes.len())
            .min_by(|&a, &b| distance(a).total_cmp(&distance(b)))
            .unwrap();
        assert!(increments.norms[near] > 1.0);
    }
}
