//! The Gram matrices of |·|_ν as operators y = A x: no N² anywhere.

use super::band::Band;
use super::dense::require_constants_finite;
use super::hierarchical::Hierarchical;
use super::toeplitz::Toeplitz;
use crate::error::{Given, Result};
use crate::estimate::Tolerance;
use crate::kernel::cells::CellPairs;
use crate::kernel::power::PowerKernel;
use crate::mesh::Mesh;
use crate::numeric::check::{require_finite_at, require_length};
use crate::order::Order;
use rayon::prelude::*;

/// Entries of a vector treated by one thread.
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
/// Constants are removed from x before the product, since A maps them to zero: the error is relative to |A|
/// |x − mean|.
///
/// ```
/// use fractional_sobolev::{Order, GramOperator, Mesh, Tolerance};
/// let (order, asked) = (Order::new(0.25)?, Tolerance::balanced());
/// let mesh = Mesh::uniform(1000, 1.0)?;
/// let [fast, tree] = [
///     GramOperator::linears(&mesh, order, asked)?,
///     GramOperator::linears_hierarchical(&mesh, order, asked)?, // the road of graded meshes
/// ];
/// assert!(fast.is_uniform() && !tree.is_uniform() && fast.dimension() == 1001);
/// assert!((fast.diagonal()[7] / tree.diagonal()[7] - 1.0).abs() < 1e-12);
/// assert!(fast.bytes() < tree.bytes());
/// assert_eq!(GramOperator::constants(&mesh, order, asked)?.dimension(), 1000);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[doc(alias("Gram matrix", "fractional Laplacian", "H-matrix", "Toeplitz", "FFT", "matrix-vector product"))]
pub struct GramOperator {
    band: Band,
    rest: OffBand,
}

impl std::fmt::Debug for GramOperator {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let method = if self.is_uniform() { "uniform" } else { "graded" };
        write!(f, "GramOperator({method}, {})", self.dimension())
    }
}

impl GramOperator {
    /// For the hat functions of all N + 1 nodes; FFT when all lengths agree, else hierarchical.
    ///
    /// # Errors
    /// None on a valid mesh but what the rules of quadrature report.
    pub fn linears(
        partition: &Mesh,
        order: impl Given<Order>,
        tolerance: impl Given<Tolerance>,
    ) -> Result<Self> {
        let (order, tolerance) = (order.given()?, tolerance.given()?);
        Self::build(partition, order, tolerance, true, partition.uniform_length())
    }

    /// For the indicator functions of the N elements.
    ///
    /// # Errors
    /// [`crate::Error::InfiniteNorm`] for ν ≥ 1/2.
    pub fn constants(
        partition: &Mesh,
        order: impl Given<Order>,
        tolerance: impl Given<Tolerance>,
    ) -> Result<Self> {
        let (order, tolerance) = (order.given()?, tolerance.given()?);
        require_constants_finite(order)?;
        Self::build(partition, order, tolerance, false, partition.uniform_length())
    }

    /// As [`GramOperator::linears`], hierarchical also on a uniform mesh: the second road.
    ///
    /// # Errors
    /// As [`GramOperator::linears`].
    pub fn linears_hierarchical(
        partition: &Mesh,
        order: impl Given<Order>,
        tolerance: impl Given<Tolerance>,
    ) -> Result<Self> {
        let (order, tolerance) = (order.given()?, tolerance.given()?);
        Self::build(partition, order, tolerance, true, None)
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
        let band =
            if linears { Band::linears(partition, &cells) } else { Band::constants(partition, &cells) };
        let rest = match uniform {
            Some(h) if linears => OffBand::Uniform(Toeplitz::linears(partition, &cells, h)?),
            Some(h) => OffBand::Uniform(Toeplitz::constants(partition, &cells, h)?),
            None => {
                // ρ^{-m} = tolerance with ρ = 3 + √8; what is measured is smaller by some decades.
                let points = (-tolerance.relative().ln() / (3.0 + 8f64.sqrt()).ln()).ceil() as usize;
                OffBand::Graded(Hierarchical::new(partition, &cells, kernel, linears, points)?)
            }
        };
        Ok(Self { band, rest })
    }

    /// Number of unknowns.
    pub fn dimension(&self) -> usize {
        self.band.diagonal.len()
    }

    /// True when the product goes by FFT.
    pub fn is_uniform(&self) -> bool {
        matches!(self.rest, OffBand::Uniform(_))
    }

    /// The diagonal of the matrix.
    pub fn diagonal(&self) -> &[f64] {
        &self.band.diagonal
    }

    /// Bytes held.
    pub fn bytes(&self) -> usize {
        let rest = match &self.rest {
            OffBand::Uniform(toeplitz) => toeplitz.bytes(),
            OffBand::Graded(hierarchical) => hierarchical.bytes(),
        };
        self.band.bytes() + rest
    }

    /// A x.
    ///
    /// ```
    /// use fractional_sobolev::{Order, GramOperator, Mesh, Tolerance};
    /// let mesh = Mesh::uniform(1000, 1.0)?;
    /// let form = GramOperator::linears(&mesh, Order::HALF, Tolerance::balanced())?;
    /// let x = mesh.nodes(); // the identity, whose seminorm is one
    /// let squared: f64 = form.apply(&x)?.iter().zip(&x).map(|(a, b)| a * b).sum();
    /// assert!((squared - 1.0).abs() < 1e-7);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`crate::Error::LengthMismatch`], [`crate::Error::NotFinite`] for an entry of x.
    pub fn apply(&self, x: &[f64]) -> Result<Vec<f64>> {
        require_length("vector", x.len(), self.dimension())?;
        let share = 1.0 / x.len() as f64;
        // Pieces of fixed size: the sum does not depend on the number of threads.
        let sums: Vec<f64> =
            x.par_chunks(PIECE).map(|piece| piece.iter().map(|value| value * share).sum()).collect();
        let mean = sums.iter().sum::<f64>();
        if !mean.is_finite() {
            for (index, &value) in x.iter().enumerate() {
                require_finite_at("vector", index, value)?;
            }
        }
        let x: Vec<f64> = x.par_iter().with_min_len(PIECE).map(|value| value - mean).collect();
        let mut y = self.band.times(&x);
        match &self.rest {
            OffBand::Uniform(toeplitz) => toeplitz.add(&x, &mut y)?,
            OffBand::Graded(hierarchical) => hierarchical.add(&x, &mut y),
        }
        Ok(y)
    }
}
