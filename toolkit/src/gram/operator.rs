//! The Gram matrices of |·|_ν as operators x ↦ A x, with less than O(N²) time and memory.

use super::band::Band;
use super::dense::{exterior_linears, require_constants_finite};
use super::hierarchical::Hierarchical;
use super::toeplitz::Toeplitz;
use crate::error::Result;
use crate::estimate::Tolerance;
use crate::kernel::cells::CellPairs;
use crate::kernel::power::PowerKernel;
use crate::mesh::Mesh;
use crate::numeric::check::{require_finite_at, require_length};
use crate::order::Order;
use rayon::prelude::*;

/// Number of entries of a vector treated by one thread.
const PIECE: usize = 1 << 12;

enum OffBand {
    Uniform(Toeplitz),
    Graded(Hierarchical),
}

/// A Gram matrix of |·|_ν that can be applied to vectors.
///
/// # Method
///
/// | mesh | method | product | memory |
/// | --- | --- | --- | --- |
/// | uniform | circulant embedding (`toeplitz`) | O(N log N) | about 10 N numbers |
/// | any | H²-matrix (`hierarchical`) | O(N log²(1/ε)) | about 60 N numbers |
///
/// Constants are subtracted from x before the product, since A maps them to zero, and the row sums of the fast
/// product, which are its errors for constants, are subtracted from the diagonal: the error is that of Σ_j a_ij (x_j
/// − x_i), which is small where x varies slowly.
pub(crate) struct GramOperator {
    band: Band,
    rest: OffBand,
    /// A applied to the constant 1, which is zero up to the errors of the fast product
    row_sums: Vec<f64>,
    exterior: Option<Exterior>,
}

/// The contribution of the exterior to the inner nodes, for functions that vanish at the two ends and outside
/// the interval.
struct Exterior {
    diagonal: Vec<f64>,
    beside: Vec<f64>,
    /// diagonal of the whole matrix
    whole_diagonal: Vec<f64>,
}

impl GramOperator {
    /// The operator for the hat functions of all N + 1 nodes: by FFT if all lengths are equal, otherwise as an
    /// H²-matrix.
    pub(crate) fn linears(partition: &Mesh, order: Order, tolerance: Tolerance) -> Result<Self> {
        Self::build(partition, order, tolerance, true, partition.uniform_length())
    }

    /// The operator on the whole line, for the hat functions of the N − 1 inner nodes.
    pub(crate) fn zero_outside(
        partition: &Mesh,
        order: Order,
        tolerance: Tolerance,
    ) -> Result<Self> {
        let mut operator = Self::linears(partition, order, tolerance)?;
        let (diagonal, beside) = exterior_linears(partition, order);
        let whole_diagonal =
            operator.band.diagonal[1..].iter().zip(&diagonal).map(|(a, b)| a + b).collect();
        operator.exterior = Some(Exterior { diagonal, beside, whole_diagonal });
        Ok(operator)
    }

    /// The operator for the indicator functions of the N elements; [`crate::Error::InfiniteNorm`] for ν ≥ 1/2.
    pub(crate) fn constants(partition: &Mesh, order: Order, tolerance: Tolerance) -> Result<Self> {
        require_constants_finite(order)?;
        Self::build(partition, order, tolerance, false, partition.uniform_length())
    }

    fn build(
        partition: &Mesh,
        order: Order,
        tolerance: Tolerance,
        linears: bool,
        uniform: Option<f64>,
    ) -> Result<Self> {
        let cells = CellPairs::new(order);
        let kernel = PowerKernel::new(order);
        let band = if linears {
            Band::linears(partition, &cells)
        } else {
            Band::constants(partition, &cells)
        };
        let rest = match uniform {
            Some(h) if linears => OffBand::Uniform(Toeplitz::linears(partition, &cells, h)?),
            Some(h) => OffBand::Uniform(Toeplitz::constants(partition, &cells, h)?),
            None => {
                // ρ^{-m} = tolerance with ρ = 3 + √8; what is measured is smaller by some decades.
                let points =
                    (-tolerance.relative().ln() / (3.0 + 8f64.sqrt()).ln()).ceil() as usize;
                OffBand::Graded(Hierarchical::new(partition, &cells, kernel, linears, points)?)
            }
        };
        let mut operator = Self { band, rest, row_sums: Vec::new(), exterior: None };
        operator.row_sums = operator.uncorrected(&vec![1.0; operator.band.diagonal.len()])?;
        Ok(operator)
    }

    /// The number of unknowns.
    pub(crate) fn dimension(&self) -> usize {
        self.diagonal().len()
    }

    /// The diagonal of the matrix.
    pub(crate) fn diagonal(&self) -> &[f64] {
        self.exterior.as_ref().map_or(&self.band.diagonal, |exterior| &exterior.whole_diagonal)
    }

    /// The product A x.
    ///
    /// # Errors
    /// [`crate::Error::LengthMismatch`], [`crate::Error::NotFinite`] for an entry of x.
    pub(crate) fn apply(&self, x: &[f64]) -> Result<Vec<f64>> {
        require_length("vector", x.len(), self.dimension())?;
        let Some(exterior) = &self.exterior else { return self.apply_inside(x) };
        let mut padded = Vec::with_capacity(x.len() + 2);
        padded.push(0.0);
        padded.extend_from_slice(x);
        padded.push(0.0);
        let mut y = self.apply_inside(&padded)?;
        y.truncate(x.len() + 1);
        y.remove(0);
        for (i, d) in exterior.diagonal.iter().enumerate() {
            y[i] += d * x[i];
        }
        for (i, b) in exterior.beside.iter().enumerate() {
            y[i] += b * x[i + 1];
            y[i + 1] += b * x[i];
        }
        Ok(y)
    }

    /// The contribution of the exterior to xᵀA x.
    pub(crate) fn form_outside(&self, x: &[f64]) -> f64 {
        let Some(exterior) = &self.exterior else { return 0.0 };
        let own = exterior.diagonal.iter().zip(x).map(|(d, x)| d * x * x);
        let beside = exterior.beside.iter().zip(x.windows(2)).map(|(b, x)| 2.0 * b * x[0] * x[1]);
        own.sum::<f64>() + beside.sum::<f64>()
    }

    fn apply_inside(&self, x: &[f64]) -> Result<Vec<f64>> {
        let share = 1.0 / x.len() as f64;
        // Pieces of fixed size: the sum does not depend on the number of threads.
        let sums: Vec<f64> = x
            .par_chunks(PIECE)
            .map(|piece| piece.iter().map(|value| value * share).sum())
            .collect();
        let mean = sums.iter().sum::<f64>();
        if !mean.is_finite() {
            for (index, &value) in x.iter().enumerate() {
                require_finite_at("vector", index, value)?;
            }
        }
        let x: Vec<f64> = x.par_iter().with_min_len(PIECE).map(|value| value - mean).collect();
        let mut y = self.uncorrected(&x)?;
        y.par_iter_mut()
            .zip(&x)
            .zip(&self.row_sums)
            .with_min_len(PIECE)
            .for_each(|((y, x), sum)| *y -= sum * x);
        Ok(y)
    }

    fn uncorrected(&self, x: &[f64]) -> Result<Vec<f64>> {
        let mut y = self.band.times(x);
        match &self.rest {
            OffBand::Uniform(toeplitz) => toeplitz.add(x, &mut y)?,
            OffBand::Graded(hierarchical) => hierarchical.add(x, &mut y),
        }
        Ok(y)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gram::gram_linears;

    /// Tolerance of the operators, and required accuracy of the product relative to its largest entry.
    const ASKED: f64 = 1e-12;
    const PRODUCT_TOLERANCE: f64 = 1e-10;

    /// Both methods on a uniform mesh: by FFT, and hierarchical as on graded meshes.
    fn both(mesh: &Mesh, order: Order, tolerance: f64) -> [GramOperator; 2] {
        let tolerance = Tolerance::new(tolerance).unwrap();
        let tree = GramOperator::build(mesh, order, tolerance, true, None).unwrap();
        [GramOperator::linears(mesh, order, tolerance).unwrap(), tree]
    }

    fn vector(count: usize) -> Vec<f64> {
        (0..count).map(|i| ((i * 7919) % 1009) as f64 / 1009.0 - 0.5).collect()
    }

    fn largest_difference(a: &[f64], b: &[f64]) -> f64 {
        a.iter().zip(b).fold(0.0, |m, (a, b)| m.max((a - b).abs()))
    }

    #[test]
    fn both_fast_methods_agree_on_a_large_uniform_mesh() {
        let mesh = Mesh::uniform(20_000, 1.0).unwrap();
        let [fourier, tree] = both(&mesh, Order::new(0.6).unwrap(), ASKED);
        assert!((fourier.diagonal()[7] / tree.diagonal()[7] - 1.0).abs() < 1e-12);
        let x = vector(20_001);
        let (a, b) = (fourier.apply(&x).unwrap(), tree.apply(&x).unwrap());
        let largest = a.iter().fold(0.0f64, |m, v| m.max(v.abs()));
        let worst = largest_difference(&a, &b);
        assert!(worst <= PRODUCT_TOLERANCE * largest, "{worst:e} against {largest:e}");
    }

    #[test]
    fn one_and_two_elements_work() {
        for n in [1, 2, 3] {
            let mesh = Mesh::uniform(n, 1.0).unwrap();
            let (matrix, x) = (gram_linears(&mesh, Order::HALF), vector(n + 1));
            let row = |i: usize| (0..=n).map(|j| matrix[(i, j)] * x[j]).sum::<f64>();
            let exact: Vec<f64> = (0..=n).map(row).collect();
            let largest = exact.iter().fold(0.0f64, |m, v| m.max(v.abs()));
            for operator in both(&mesh, Order::HALF, 1e-8) {
                let product = operator.apply(&x).unwrap();
                let worst = largest_difference(&product, &exact);
                assert!(worst <= PRODUCT_TOLERANCE * largest, "{n} elements: {worst:e}");
                // Without a transform every entry has its digits, relative to |A||x|.
                for i in (0..=n).filter(|_| matches!(operator.rest, OffBand::Graded(_))) {
                    let absolute: f64 = (0..=n).map(|j| (matrix[(i, j)] * x[j]).abs()).sum();
                    let off = (product[i] - exact[i]).abs();
                    assert!(
                        off <= PRODUCT_TOLERANCE * absolute,
                        "{n} elements, entry {i}: {off:e}"
                    );
                }
            }
        }
    }
}
