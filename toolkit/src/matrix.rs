//! Gram matrices of norms of fractional order on meshes of intervals.

use super::gram::{
    Basis, Forms, GramOperator, Network, Spectral, extreme_eigenvalues, gram_constants,
    gram_linears, gram_zero_outside, require_constants_finite, solve,
};
use super::mesh::Mesh;
use super::order::Order;
use crate::error::{Error, Given, Result};
use crate::estimate::{Estimate, Tolerance};
use crate::numeric::check::require_memory;
use crate::numeric::check::require_values;
use crate::numeric::sum::compensated;
use crate::piecewise::PiecewisePolynomial;
use crate::root::ENTRY_ROUNDING;
use nalgebra::DMatrix;
use std::sync::OnceLock;

/// Largest ratio of |sum| to sum of absolute values for a load that must sum to zero.
const BALANCED: f64 = 1e-8;
/// Tolerance of the form of an eigenvector, relative to that of the eigenvalue.
const OF_FORM: f64 = 0.05;

/// The Gram matrix A of |·|_s in a nodal basis, uᵀAu = |u|²_s, and the mass matrix M of the same
/// basis.
///
/// # Method
///
/// Products are computed by FFT on uniform meshes, and by H²-matrices on other meshes, in O(N log
/// N) to O(N log²(1/τ)) operations at the relative tolerance τ; the memory is about 10 N numbers on
/// a uniform mesh, 60 N on other meshes. The fast product is prepared at its first use. The entries
/// of the dense matrix are sums of a few integrals in closed form, and cost O(N²) kernel values;
/// their relative error is below 1e-13, of which the entries of neighbouring hat functions, whose
/// integrals have both signs, reach 3e-14 on very unequal elements. Where A maps constants to zero,
/// the mean of x is subtracted before a product.
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
#[doc(alias(
    "Gram matrix",
    "stiffness matrix",
    "mass matrix",
    "fractional Laplacian",
    "FFT",
    "H-matrix"
))]
pub struct Gram {
    mesh: Mesh,
    order: Order,
    tolerance: Tolerance,
    basis: Basis,
    /// The fast product and the preconditioner, prepared at their first use.
    fast: OnceLock<GramOperator>,
    inverse: OnceLock<Spectral>,
}

impl Gram {
    fn fast(&self) -> Result<&GramOperator> {
        if let Some(fast) = self.fast.get() {
            return Ok(fast);
        }
        // Not inside `get_or_init`: the parallel loops may steal a task that asks for the same
        // product.
        let build = match self.basis {
            Basis::Hats => GramOperator::linears,
            Basis::InnerHats => GramOperator::zero_outside,
            Basis::Indicators => GramOperator::constants,
        };
        let built = build(&self.mesh, self.order, self.tolerance)?;
        Ok(self.fast.get_or_init(|| built))
    }

    fn inverse(&self) -> &Spectral {
        if let Some(inverse) = self.inverse.get() {
            return inverse;
        }
        let built = Spectral::new(&self.mesh, self.basis, self.order);
        self.inverse.get_or_init(|| built)
    }
}

impl std::fmt::Debug for Gram {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Gram({})", self.len())
    }
}

impl Gram {
    /// The Gram matrix for the hat functions of all nodes of a mesh, 0 < s < 1: the double integral
    /// over the square of the interval, which is the form of the *regional* fractional Laplacian.
    /// The form of the *integral* fractional Laplacian, over the whole line, is
    /// [`Gram::zero_outside`].
    ///
    /// # Errors
    /// [`Error::OutOfRange`](crate::Error::OutOfRange) for an order or a tolerance outside its
    /// range.
    pub fn new(
        mesh: &Mesh,
        s: impl Given<Order>,
        tolerance: impl Given<Tolerance>,
    ) -> Result<Self> {
        Ok(Self::on_interval(mesh, s.given()?, tolerance.given()?, Basis::Hats))
    }

    /// The Gram matrix for the indicator functions of the elements of a mesh, 0 < s < 1/2.
    ///
    /// ```
    /// use fractional_sobolev::{Gram, Mesh};
    /// let form = Gram::constants(&Mesh::uniform(2, 1.0)?, 0.25, 1e-8)?;
    /// let y = form.apply(&[1.0, 1.0])?; // the seminorm of a constant is zero
    /// assert!(y.iter().all(|y| y.abs() < 1e-12) && form.mass(&[2.0, 0.0])? == [1.0, 0.0]);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::InfiniteNorm`](crate::Error::InfiniteNorm) for s ≥ 1/2; as [`Gram::new`].
    pub fn constants(
        mesh: &Mesh,
        s: impl Given<Order>,
        tolerance: impl Given<Tolerance>,
    ) -> Result<Self> {
        let order = s.given()?;
        require_constants_finite(order)?;
        Ok(Self::on_interval(mesh, order, tolerance.given()?, Basis::Indicators))
    }

    /// The Gram matrix on the whole line for the hat functions of the N − 1 inner nodes of a mesh,
    /// which vanish outside it: the form ∫∫ (u(x)−u(y)) (v(x)−v(y)) / |x−y|^{1+2s} over R × R, 0 <
    /// s < 1.
    ///
    /// This is the form of the integral fractional Laplacian with u = 0 outside the interval: the
    /// weak form of (−Δ)^s u = f is C(1, s)/2 A x = b with
    /// [`fractional_laplacian_constant`](crate::closed_forms::fractional_laplacian_constant).
    /// [`Gram::new`] is the *regional* form, over the square of the interval: a different operator,
    /// with different solutions.
    ///
    /// ```
    /// use fractional_sobolev::{Gram, Mesh, closed_forms::fractional_laplacian_constant};
    /// // (−Δ)^s u = 1 on (0, 2), u = 0 outside: u(1) = 1/Γ(1 + 2s)
    /// let mesh = Mesh::uniform(200, 2.0)?;
    /// let form = Gram::zero_outside(&mesh, 0.5, 1e-8)?;
    /// let half = 0.5 * fractional_laplacian_constant(0.5)?.value;
    /// let load = vec![0.01 / half; form.len()]; // ∫ φ_i = h
    /// let (u, energy) = form.solve(&load)?;
    /// assert!((u[99] - 1.0).abs() < 0.01 && (half * energy.value - 1.5708).abs() < 0.01);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::CountOutOfRange`](crate::Error::CountOutOfRange) for a mesh with one element; as
    /// [`Gram::new`].
    #[doc(alias(
        "fractional Laplacian",
        "integral fractional Laplacian",
        "restricted",
        "Dirichlet",
        "exterior"
    ))]
    pub fn zero_outside(
        mesh: &Mesh,
        s: impl Given<Order>,
        tolerance: impl Given<Tolerance>,
    ) -> Result<Self> {
        if mesh.len() < 2 {
            return Err(Error::CountOutOfRange {
                name: "elements",
                value: mesh.len(),
                range: "[2, inf)",
            });
        }
        Ok(Self::on_interval(mesh, s.given()?, tolerance.given()?, Basis::InnerHats))
    }

    fn on_interval(mesh: &Mesh, order: Order, tolerance: Tolerance, basis: Basis) -> Self {
        let (mesh, fast, inverse) = (mesh.clone(), OnceLock::new(), OnceLock::new());
        Self { mesh, order, tolerance, basis, fast, inverse }
    }

    /// The number of basis functions.
    #[expect(clippy::len_without_is_empty, reason = "never empty")]
    pub fn len(&self) -> usize {
        self.basis.count(&self.mesh)
    }

    /// The product A x; the error is of the size of the tolerance times |A| |x − x̄|, absolute
    /// values entry by entry, x̄ the mean of x.
    ///
    /// # Errors
    /// [`Error::LengthMismatch`](crate::Error::LengthMismatch),
    /// [`Error::NotFinite`](crate::Error::NotFinite).
    pub fn apply(&self, x: &[f64]) -> Result<Vec<f64>> {
        self.fast()?.apply(x)
    }

    /// The product M x with the Gram matrix M of L², exact to rounding, in O(N) operations.
    ///
    /// # Errors
    /// As [`Gram::apply`].
    pub fn mass(&self, x: &[f64]) -> Result<Vec<f64>> {
        require_values("vector", x, self.len())?;
        Ok(Network::new(&self.mesh, self.basis, 0.0, 1.0).times(x))
    }

    /// The solution x of A x = b, to the relative tolerance in the norm of A, and xᵀA x with the
    /// number of iterations.
    ///
    /// The method of conjugate gradients is preconditioned by the power s of the tridiagonal pencil
    /// of (u′, v′) and L², at the cost of 10 to 40 tridiagonal solves per step. The number of
    /// iterations does not depend on the number of elements, but on the ratios of neighbouring lengths:
    /// for eight digits 10 to 20 for hat functions on lengths drawn from two decades, up to 90 from
    /// eight; for constants 21 to 28 and 70 at s near 1/2, up to 400 from eight decades.
    /// Except for [`Gram::zero_outside`], constants have seminorm zero: then the
    /// entries of b must sum to zero, and x is the solution with mean zero. The error of xᵀA x
    /// includes the rounding of the entries of A, which exceeds the tolerance if elements are very
    /// short and s is near 1.
    /// ```
    /// use fractional_sobolev::{Gram, Mesh};
    /// let form = Gram::new(&Mesh::uniform(50, 1.0)?, 0.3, 1e-10)?;
    /// let x: Vec<f64> = (0..=50).map(|i| (i as f64 / 50.0 - 0.5).powi(3)).collect();
    /// let (solved, energy) = form.solve(&form.apply(&x)?)?;
    /// assert!(solved.iter().zip(&x).all(|(a, b)| (a - b).abs() < 1e-9) && energy.work.iterations < 30);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::OutOfRange`](crate::Error::OutOfRange) if the entries of b must sum to zero but do
    /// not; [`Error::ToleranceNotMet`](crate::Error::ToleranceNotMet) with the best energy; as
    /// [`Gram::apply`].
    #[doc(alias("fractional Laplacian", "preconditioner", "conjugate gradients"))]
    pub fn solve(&self, load: &[f64]) -> Result<(Vec<f64>, Estimate)> {
        require_values("load", load, self.len())?;
        if self.basis != Basis::InnerHats {
            let size: f64 = load.iter().map(|b| b.abs()).sum();
            let sum = compensated(load.iter().copied());
            let admissible = sum.abs() <= BALANCED * size;
            Error::require(
                "sum of the load",
                sum,
                "[-1e-8, 1e-8] times the sum of the absolute values of its entries",
                admissible,
            )?;
        }
        solve(self.fast()?, self.inverse(), load, self.tolerance)
    }

    /// The preconditioner of [`Gram::solve`] applied to r: a symmetric approximate inverse of A,
    /// for use in other iterations.
    ///
    /// The eigenvalues of its product with A lie in an interval that depends on s and on the ratios of
    /// neighbouring lengths, not on the number of elements.
    /// Cost: 10 to 40 tridiagonal solves. If constants have seminorm zero, it is applied to r minus
    /// its mean, and the result has mean zero.
    ///
    /// ```
    /// use fractional_sobolev::{Gram, Mesh};
    /// let form = Gram::zero_outside(&Mesh::uniform(64, 1.0)?, 0.5, 1e-10)?;
    /// let x = vec![1.0; form.len()];
    /// let y = form.precondition(&form.apply(&x)?)?;
    /// assert!(y.iter().all(|y| (0.3..3.0).contains(y)));
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Gram::apply`].
    #[doc(alias = "preconditioner")]
    pub fn precondition(&self, r: &[f64]) -> Result<Vec<f64>> {
        require_values("residual", r, self.len())?;
        let (inverse, mut r, mut out) = (self.inverse(), r.to_vec(), vec![0.0; r.len()]);
        inverse.without_mean(&mut r);
        inverse.times(&r, &mut out);
        inverse.without_constant(&mut out);
        Ok(out)
    }

    /// The smallest positive and the largest eigenvalue of A x = λ M x on an interval, to the
    /// tolerance of the form.
    ///
    /// They are computed by a block iteration with preconditioned residuals (LOBPCG), which for the
    /// largest one starts, among others, from the Ritz vectors of windows of 48 basis functions: 5
    /// to 30 steps of a few products each, up to 200 on a uniform mesh, where the largest
    /// eigenvalues are close together and tolerances below 1e-6 are not met. The error bounds the
    /// distance to the spectrum by the residual, for the smallest one by its square over the
    /// distance to the next eigenvalue, plus the rounding of the product and its tolerance. For at
    /// most 128 basis functions the number of eigenvalues in between is counted by the inertia of A
    /// − σM; for more, the distance is that of the Ritz values, less the residual of the next one.
    /// Where the smallest one takes more than 60 steps, as on very unequal elements, its vector comes
    /// from a Krylov space of A⁻¹M by an elimination without subtraction, up to 4096 basis functions, in
    /// O(N³) operations. The ratio of the two
    /// eigenvalues is the condition number of A relative to M, on the functions of mean zero if
    /// constants have seminorm zero.
    ///
    /// ```
    /// use fractional_sobolev::{Gram, Mesh, closed_forms::fractional_laplacian_constant};
    /// // the lowest eigenvalue of (−Δ)^{1/2} on (−1, 1) is 1.1577738836977 (Kwaśnicki 2012)
    /// let form = Gram::zero_outside(&Mesh::uniform(400, 2.0)?, 0.5, 1e-8)?;
    /// let half = 0.5 * fractional_laplacian_constant(0.5)?.value;
    /// let [low, high] = form.extreme_eigenvalues()?;
    /// assert!((half * low.value - 1.15777).abs() < 2e-3 && high.value > 1e2 * low.value);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::CountOutOfRange`](crate::Error::CountOutOfRange) for fewer than four basis
    /// functions; [`Error::ToleranceNotMet`](crate::Error::ToleranceNotMet) with the best value,
    /// without one if a larger eigenvalue than the one found is counted;
    /// [`Error::Solver`](crate::Error::Solver) if the iteration breaks down.
    #[doc(alias("condition number", "eigenvalue", "spectrum", "LOBPCG"))]
    pub fn extreme_eigenvalues(&self) -> Result<[Estimate; 2]> {
        if self.len() < 4 {
            let (name, range) = ("basis functions", "[4, inf)");
            return Err(Error::CountOutOfRange { name, value: self.len(), range });
        }
        let (fast, inverse) = (self.fast()?, self.inverse());
        let dense = || self.to_dense();
        let network = || self.network();
        let form = |x: &[f64]| self.form_of_differences(fast, x);
        let matrix = Forms {
            operator: fast,
            spectral: inverse,
            dense: &dense,
            network: &network,
            form: &form,
        };
        extreme_eigenvalues(&matrix, &self.mesh, self.basis, self.tolerance)
    }

    /// The conductances of the network of A between the nodes, in the lower half, and to the ground.
    fn network(&self) -> Result<(DMatrix<f64>, Vec<f64>)> {
        let (mut between, ground) = match self.basis {
            Basis::InnerHats => gram_zero_outside(&self.mesh, self.order),
            Basis::Hats | Basis::Indicators => (self.to_dense()?, vec![0.0; self.len()]),
        };
        between.neg_mut();
        Ok((between, ground))
    }

    /// xᵀA x as |u|² of the function u with these coefficients: a sum of positive terms over pairs of
    /// elements, whose rounding error is relative to itself.
    fn form_of_differences(&self, fast: &GramOperator, x: &[f64]) -> Result<Estimate> {
        let mesh = self.mesh.clone();
        let u = match self.basis {
            Basis::Indicators => PiecewisePolynomial::constants(mesh, x)?,
            Basis::Hats => PiecewisePolynomial::linears(mesh, x)?,
            Basis::InnerHats => {
                let values: Vec<f64> = [0.0].iter().chain(x).chain(&[0.0]).copied().collect();
                PiecewisePolynomial::linears(mesh, &values)?
            }
        };
        let asked = Tolerance::new((OF_FORM * self.tolerance.relative()).max(1e-15))?;
        let found = Estimate::or_best(u.seminorm(self.order, asked))?;
        let (inside, outside) = (found.product(found)?, fast.form_outside(x));
        let error = inside.error + ENTRY_ROUNDING * outside;
        Estimate::new(inside.value + outside, error, inside.work)
    }

    /// The diagonal of A, stored with the fast product.
    ///
    /// # Errors
    /// [`Error::Solver`](crate::Error::Solver) if a Fourier transform fails.
    pub fn diagonal(&self) -> Result<Vec<f64>> {
        Ok(self.fast()?.diagonal().to_vec())
    }

    /// A as a dense matrix, by closed forms, to a relative error of every entry below 1e-13, at the
    /// cost of O(N²) kernel evaluations.
    ///
    /// # Errors
    /// [`Error::TooLarge`](crate::Error::TooLarge) if the memory does not suffice.
    pub fn to_dense(&self) -> Result<DMatrix<f64>> {
        let n = self.len();
        require_memory("entries", n.saturating_mul(n), 16)?;
        match self.basis {
            Basis::Hats => Ok(gram_linears(&self.mesh, self.order)),
            Basis::InnerHats => Ok(gram_zero_outside(&self.mesh, self.order).0),
            Basis::Indicators => gram_constants(&self.mesh, self.order),
        }
    }
}
