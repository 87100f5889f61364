//! Norms of functions by name: of their closures, or of the piecewise linear function of a file.

use super::dual::DualOf;
use super::functions::SingularFunction;
use super::gallery::{Evaluated, GalleryFunction};
use super::order::Order;
use crate::error::{Error, Given, Result};
use crate::estimate::{Estimate, Tolerance};

impl GalleryFunction {
    /// |u|_ν.
    ///
    /// # Errors
    /// [`Error::InfiniteNorm`] above the critical order, [`Error::ToleranceNotMet`], [`Error::File`].
    pub fn seminorm(&self, order: impl Given<Order>, tolerance: impl Given<Tolerance>) -> Result<Estimate> {
        match self.evaluated()? {
            Evaluated::Samples(u) => u.seminorm(order, tolerance),
            Evaluated::Closure(u) => u.seminorm(order, tolerance),
            Evaluated::NearlyOne(u, _) => u.seminorm(order.given()?, tolerance.given()?),
        }
    }

    /// |u|_ν, none where it is found to be infinite.
    ///
    /// # Errors
    /// As [`GalleryFunction::seminorm`] otherwise.
    pub fn finite_seminorm(
        &self,
        order: impl Given<Order>,
        tolerance: impl Given<Tolerance>,
    ) -> Result<Option<Estimate>> {
        let (order, tolerance) = (order.given()?, tolerance.given()?);
        match self.seminorm(order, tolerance) {
            Err(Error::InfiniteNorm { .. }) => Ok(None),
            outcome => outcome.map(Some),
        }
    }

    /// ||u||_ν.
    ///
    /// # Errors
    /// As [`GalleryFunction::seminorm`].
    pub fn norm(&self, order: impl Given<Order>, tolerance: impl Given<Tolerance>) -> Result<Estimate> {
        match self.evaluated()? {
            Evaluated::Samples(u) => u.norm(order, tolerance),
            Evaluated::Closure(u) => u.norm(order, tolerance),
            Evaluated::NearlyOne(u, _) => u.norm(order.given()?, tolerance.given()?),
        }
    }

    /// The L² norm.
    ///
    /// # Errors
    /// As [`GalleryFunction::lq_norm`].
    pub fn l2_norm(&self, tolerance: impl Given<Tolerance>) -> Result<Estimate> {
        self.lq_norm(2.0, tolerance)
    }

    /// ||u||\_{L^q}, 1 ≤ q ≤ ∞, as [`SingularFunction::lq_norm`].
    ///
    /// ```
    /// use fractional_sobolev::GalleryFunction;
    /// let root = GalleryFunction::Power(0.5);
    /// assert!((root.lq_norm(4.0, 1e-8)?.value - 3f64.powf(-0.25)).abs() < 1e-8);
    /// assert!((root.l2_norm(1e-8)?.value - 0.5f64.sqrt()).abs() < 1e-8);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`SingularFunction::lq_norm`]; [`Error::File`].
    pub fn lq_norm(&self, q: f64, tolerance: impl Given<Tolerance>) -> Result<Estimate> {
        match self.evaluated()? {
            Evaluated::Samples(u) => u.lq_norm(q, tolerance),
            Evaluated::Closure(u) | Evaluated::NearlyOne(_, u) => u.lq_norm(q, tolerance),
        }
    }

    /// The norm dual to [`GalleryFunction::norm`], sup ∫ u v / ||v||_ν.
    ///
    /// ```
    /// use fractional_sobolev::{DualOf, GalleryFunction};
    /// let step = GalleryFunction::Step(0.5); // no norm of order 1/2, but a dual norm
    /// let found = step.dual_norm(0.5, 1e-6)?;
    /// assert!(step.norm(0.5, 1e-6).is_err() && found.value < step.l2_norm(1e-6)?.value);
    /// assert!(step.dual_norm_in(DualOf::InterpolationZero, 0.5, 1e-6)?.value < found.value);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`SingularFunction::dual_norm`]; [`Error::File`].
    pub fn dual_norm(&self, order: impl Given<Order>, tolerance: impl Given<Tolerance>) -> Result<Estimate> {
        self.dual_norm_in(DualOf::Slobodeckij, order, tolerance)
    }

    /// The dual norm to any of the norms that [`DualOf`] names.
    ///
    /// # Errors
    /// As [`GalleryFunction::dual_norm`].
    pub fn dual_norm_in(
        &self,
        of: DualOf,
        order: impl Given<Order>,
        tolerance: impl Given<Tolerance>,
    ) -> Result<Estimate> {
        match self.evaluated()? {
            Evaluated::Samples(u) => u.dual_norm_in(of, order, tolerance),
            Evaluated::Closure(u) | Evaluated::NearlyOne(_, u) => u.dual_norm_in(of, order, tolerance),
        }
    }

    /// The function as a closure with its breaks, for [`SingularFunction::minus`].
    ///
    /// ```
    /// use fractional_sobolev::{GalleryFunction, Mesh, PiecewisePolynomial};
    /// let mesh = Mesh::algebraic(1000, 2.0, 1.0)?;
    /// let values: Vec<f64> = mesh.from_left().iter().map(|x| x.sqrt()).collect();
    /// let field = PiecewisePolynomial::linears(mesh, &values)?;
    /// let root = GalleryFunction::Power(0.5).function()?;
    /// let error = root.minus(&field);
    /// assert!(error.seminorm(0.5, 1e-4)?.value < 3e-3);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Incompatible`] for samples.
    pub fn function(&self) -> Result<SingularFunction<'_>> {
        match self.evaluated()? {
            Evaluated::Closure(u) | Evaluated::NearlyOne(_, u) => Ok(u),
            Evaluated::Samples(_) => Err(Error::Incompatible {
                what: "function",
                given: self.to_string(),
                with: "the error of a field",
                expected: "a function by formula, or the field minus the samples as one piecewise polynomial",
            }),
        }
    }
}
