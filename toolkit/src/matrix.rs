//! Gram matrices of norms of fractional order, on meshes of intervals and on grids of the plane.

use super::gram::{
    GramOperator, gram_constants, gram_linears, mass_constants, mass_linears, require_constants_finite,
};
use super::mesh::Mesh;
use super::order::Order;
use super::plane::{GridOperator, Triangles};
use crate::error::{Given, Result};
use crate::estimate::Tolerance;
use crate::numeric::check::require_values;
use crate::numeric::memory::require_memory;
use nalgebra::DMatrix;
use std::sync::OnceLock;

/// The Gram matrix A of |·|_s in a nodal basis, uᵀAu = |u|²_s, and the mass matrix M of the same basis.
///
/// # Method
///
/// Products go by FFT on uniform meshes and grids, by H²-matrices on other meshes: O(N log N) to O(N log²(1/τ)) at the
/// relative tolerance τ; memory about 10 N numbers on a uniform mesh, 60 N on other meshes, 200 N on a grid. On an
/// interval the fast product is prepared when it is first asked for; the dense matrix has entries exact to rounding,
/// sums of a few integrals of one sign each, and costs O(N²) kernel values and nothing else. Constants are removed from
/// x before a product, since A maps them to zero.
///
/// ```
/// use fractional_sobolev::{Gram, Mesh};
/// let mesh = Mesh::uniform(100, 1.0)?;
/// let form = Gram::new(&mesh, 0.5, 1e-8)?;
/// let x = mesh.nodes(); // the identity: its seminorm is one
/// let of = |y: &[f64]| x.iter().zip(y).map(|(a, b)| a * b).sum::<f64>();
/// assert!((of(&form.apply(&x)?) - 1.0).abs() < 1e-7);
/// assert!((of(&form.mass(&x)?) - 1.0 / 3.0).abs() < 1e-12);
/// let dense = form.to_dense()?;
/// assert!(form.len() == 101 && dense.nrows() == 101);
/// assert!((form.diagonal()?[7] / dense[(7, 7)] - 1.0).abs() < 1e-12);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[doc(alias("Gram matrix", "stiffness matrix", "mass matrix", "fractional Laplacian", "FFT", "H-matrix"))]
pub struct Gram {
    form: Form,
}

enum Form {
    Interval(Box<Interval>),
    Grid { squares: [usize; 2], h: f64, form: GridOperator },
}

/// On a mesh of an interval; the fast product is prepared when it is first used.
struct Interval {
    mesh: Mesh,
    order: Order,
    tolerance: Tolerance,
    is_linear: bool,
    fast: OnceLock<GramOperator>,
}

impl Interval {
    fn fast(&self) -> Result<&GramOperator> {
        if let Some(fast) = self.fast.get() {
            return Ok(fast);
        }
        // Not inside `get_or_init`: the parallel loops may steal a task that asks for the same product.
        let build = if self.is_linear { GramOperator::linears } else { GramOperator::constants };
        let built = build(&self.mesh, self.order, self.tolerance)?;
        Ok(self.fast.get_or_init(|| built))
    }

    fn len(&self) -> usize {
        self.mesh.len() + usize::from(self.is_linear)
    }
}

impl std::fmt::Debug for Gram {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Gram({})", self.len())
    }
}

impl Gram {
    /// For the hat functions of all nodes of a mesh, 0 < s < 1.
    ///
    /// # Errors
    /// [`Error::OutOfRange`](crate::Error::OutOfRange) for another order or a tolerance outside its range.
    pub fn new(mesh: &Mesh, s: impl Given<Order>, tolerance: impl Given<Tolerance>) -> Result<Self> {
        Ok(Self::on_interval(mesh, s.given()?, tolerance.given()?, true))
    }

    /// For the indicator functions of the elements of a mesh, 0 < s < 1/2.
    ///
    /// ```
    /// use fractional_sobolev::{Gram, Mesh};
    /// let form = Gram::constants(&Mesh::uniform(2, 1.0)?, 0.25, 1e-8)?;
    /// let y = form.apply(&[1.0, 1.0])?; // constants have no seminorm
    /// assert!(y.iter().all(|y| y.abs() < 1e-12) && form.mass(&[2.0, 0.0])? == [1.0, 0.0]);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::InfiniteNorm`](crate::Error::InfiniteNorm) for s ≥ 1/2; as [`Gram::new`].
    pub fn constants(mesh: &Mesh, s: impl Given<Order>, tolerance: impl Given<Tolerance>) -> Result<Self> {
        let order = s.given()?;
        require_constants_finite(order)?;
        Ok(Self::on_interval(mesh, order, tolerance.given()?, false))
    }

    fn on_interval(mesh: &Mesh, order: Order, tolerance: Tolerance, is_linear: bool) -> Self {
        let (mesh, fast) = (mesh.clone(), OnceLock::new());
        Self { form: Form::Interval(Box::new(Interval { mesh, order, tolerance, is_linear, fast })) }
    }

    /// For the hat functions of all nodes of [`Triangles::grid`] with the same arguments, row by row from the bottom.
    ///
    /// ```
    /// use fractional_sobolev::{Function, Gram, Triangles};
    /// let form = Gram::on_grid([4, 4], 0.25, 0.5, 1e-8)?;
    /// let mesh = Triangles::grid([4, 4], 0.25)?;
    /// let x: Vec<f64> = mesh.nodes().iter().map(|p| p[0]).collect();
    /// let of = |y: &[f64]| x.iter().zip(y).map(|(a, b)| a * b).sum::<f64>();
    /// let exact = Function::on_triangles(&mesh, 1, &x)?.seminorm(0.5, 1e-8)?.value;
    /// assert!((of(&form.apply(&x)?).sqrt() / exact - 1.0).abs() < 1e-7);
    /// assert!((of(&form.mass(&x)?) - 1.0 / 3.0).abs() < 1e-12);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::CountOutOfRange`](crate::Error::CountOutOfRange) for no square,
    /// [`Error::TooLarge`](crate::Error::TooLarge) for more than memory holds; as [`Gram::new`].
    pub fn on_grid(
        squares: [usize; 2],
        h: f64,
        s: impl Given<Order>,
        tolerance: impl Given<Tolerance>,
    ) -> Result<Self> {
        let form = GridOperator::new(squares, h, s.given()?, tolerance.given()?)?;
        Ok(Self { form: Form::Grid { squares, h, form } })
    }

    /// Number of basis functions.
    #[expect(clippy::len_without_is_empty, reason = "never empty")]
    pub fn len(&self) -> usize {
        match &self.form {
            Form::Interval(interval) => interval.len(),
            Form::Grid { form, .. } => form.size(),
        }
    }

    /// A x; the error is relative to |A| |x − mean|.
    ///
    /// # Errors
    /// [`Error::LengthMismatch`](crate::Error::LengthMismatch), [`Error::NotFinite`](crate::Error::NotFinite).
    pub fn apply(&self, x: &[f64]) -> Result<Vec<f64>> {
        match &self.form {
            Form::Interval(interval) => interval.fast()?.apply(x),
            Form::Grid { form, .. } => form.apply(x),
        }
    }

    /// M x, M the Gram matrix of L², exact to rounding in O(N).
    ///
    /// # Errors
    /// As [`Gram::apply`].
    pub fn mass(&self, x: &[f64]) -> Result<Vec<f64>> {
        require_values("vector", x, self.len())?;
        let mut y = vec![0.0; x.len()];
        match &self.form {
            Form::Interval(interval) if !interval.is_linear => {
                y.iter_mut().zip(x).zip(mass_constants(&interval.mesh)).for_each(|((y, x), h)| *y = h * x);
            }
            Form::Interval(interval) => {
                let (diagonal, beside) = mass_linears(&interval.mesh);
                y.iter_mut().zip(x).zip(diagonal).for_each(|((y, x), d)| *y = d * x);
                for (k, entry) in beside.into_iter().enumerate() {
                    y[k] += entry * x[k + 1];
                    y[k + 1] += entry * x[k];
                }
            }
            Form::Grid { squares, h, .. } => {
                let mesh = Triangles::grid(*squares, *h)?;
                for (nodes, area) in mesh.triangles().iter().zip(mesh.areas()) {
                    let sum: f64 = nodes.iter().map(|&node| x[node]).sum();
                    nodes.iter().for_each(|&node| y[node] += area / 12.0 * (sum + x[node]));
                }
            }
        }
        Ok(y)
    }

    /// Bytes that the fast product holds.
    ///
    /// # Errors
    /// As [`Gram::new`].
    pub fn bytes(&self) -> Result<usize> {
        match &self.form {
            Form::Interval(interval) => Ok(interval.fast()?.bytes()),
            Form::Grid { form, .. } => Ok(form.bytes()),
        }
    }

    /// The diagonal of A: known on an interval; on a grid from N products.
    ///
    /// # Errors
    /// As [`Gram::apply`].
    pub fn diagonal(&self) -> Result<Vec<f64>> {
        match &self.form {
            Form::Interval(interval) => Ok(interval.fast()?.diagonal().to_vec()),
            Form::Grid { form, .. } => (0..form.size()).map(|k| Ok(column(form, k)?[k])).collect(),
        }
    }

    /// A as a dense matrix: on an interval by closed forms, exact to rounding at O(N²) kernel values; on a grid from N
    /// products.
    ///
    /// # Errors
    /// [`Error::TooLarge`](crate::Error::TooLarge) for more than memory holds; as [`Gram::apply`].
    pub fn to_dense(&self) -> Result<DMatrix<f64>> {
        let n = self.len();
        require_memory("entries", n.saturating_mul(n), 16)?;
        match &self.form {
            Form::Interval(interval) if interval.is_linear => {
                Ok(gram_linears(&interval.mesh, interval.order))
            }
            Form::Interval(interval) => gram_constants(&interval.mesh, interval.order),
            Form::Grid { form, .. } => {
                let mut dense = DMatrix::zeros(n, n);
                for k in 0..n {
                    dense.column_mut(k).copy_from_slice(&column(form, k)?);
                }
                Ok(dense)
            }
        }
    }
}

/// A column of the matrix.
fn column(form: &GridOperator, k: usize) -> Result<Vec<f64>> {
    let mut unit = vec![0.0; form.size()];
    unit[k] = 1.0;
    form.apply(&unit)
}
