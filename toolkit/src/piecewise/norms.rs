//! Norms of order ν and 1 + ν of piecewise polynomials, (1.1) of the paper.

use super::polynomial::PiecewisePolynomial;
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance, Work};
use crate::numeric::scale::power_of_two;
use crate::numeric::sum::RunningSum;
use crate::order::Order;
use crate::quadrature::Rule;
use crate::root::{ENTRY_ROUNDING, accept, root_of_squares};

/// Message: what limits the accuracy of a quadratic form.
const LIMIT: &str = "rounding of the form dominates: use fewer elements or a smoother function";

impl PiecewisePolynomial {
    /// The seminorm |u|_ν.
    ///
    /// # Method
    ///
    /// ```text
    /// |u|²_ν = ∫∫ (u(x)−u(y))² / |x−y|^{1+2ν},  ||u||²_{m+ν} = Σ_{k≤m} ||u^{(k)}||² + |u^{(m)}|²_ν,  m < 2.
    /// ```
    ///
    /// For few elements the pairs are summed one by one, exact to rounding, with O(N²) kernel values: piecewise
    /// constants and continuous piecewise linear functions through the Gram matrix in the form −Σ_{i<j} a_ij
    /// (u_i−u_j)², which uses that constants have seminorm zero and so remains accurate when u is nearly
    /// constant. For more elements they are summed
    ///
    /// - on uniform meshes, for piecewise constant and linear functions, by the fast product xᵀAx, whose
    ///   rounding error is relative to Σ a_ii x_i²: O(N log N);
    /// - otherwise, and if that rounding error exceeds the tolerance, by moments: pairs of clusters of elements
    ///   with a gap no shorter than either, on which the kernel is interpolated at Chebyshev points to the
    ///   requested [`Tolerance`]; O(N log(1/τ)²), down to about 1e-13. Since the integrand is nonnegative, the
    ///   relative error of the sum is at most that of the kernel.
    ///
    /// For many elements and ν near 1 the accuracy is limited by the rounding of neighbouring values.
    ///
    /// # Errors
    /// [`Error::InfiniteNorm`] if u jumps and ν ≥ 1/2; [`Error::ToleranceNotMet`] if rounding exceeds the
    /// tolerance.
    pub(crate) fn seminorm(&self, order: Order, tolerance: Tolerance) -> Result<Estimate> {
        accept("seminorm", self.seminorm_as_it_is(order, tolerance)?, tolerance, LIMIT)
    }

    /// The norm ||u||_ν, the square of which is the sum of the squares of the L² norm and of the seminorm.
    ///
    /// # Errors
    /// As [`PiecewisePolynomial::seminorm`].
    pub(crate) fn norm(&self, order: Order, tolerance: Tolerance) -> Result<Estimate> {
        let parts = [self.seminorm_as_it_is(order, tolerance)?, self.l2_norm()?];
        accept("norm", root_of_squares(&parts)?, tolerance, LIMIT)
    }

    /// The norm ||u||_{1+ν} of a function and its derivative, [`PiecewisePolynomial::derivative`].
    ///
    /// # Errors
    /// As [`PiecewisePolynomial::seminorm`] for the derivative; [`Error::InfiniteNorm`] if u jumps;
    /// [`Error::OutOfRange`] if the intervals of the function and of the derivative differ in length.
    pub(crate) fn norm_with_derivative(
        &self,
        derivative: &Self,
        order: Order,
        tolerance: Tolerance,
    ) -> Result<Estimate> {
        let total = derivative.mesh().total();
        let same = self.mesh().total() == total;
        Error::require(
            "length of the derivative's interval",
            total,
            "{length of the function's interval}",
            same,
        )?;
        if !self.is_continuous() {
            return Err(Error::InfiniteNorm {
                order: 1.0 + order.value(),
                why: "a function that jumps has no derivative in L^2",
            });
        }
        let top = derivative.seminorm_as_it_is(order, tolerance)?;
        let parts = [top, self.l2_norm()?, derivative.l2_norm()?];
        accept("norm", root_of_squares(&parts)?, tolerance, LIMIT)
    }

    /// The L² norm, exact to rounding, so that it meets every tolerance.
    ///
    /// # Errors
    /// [`Error::NotFinite`] on overflow.
    pub(crate) fn l2_norm(&self) -> Result<Estimate> {
        let scale = self.scale();
        let rule = Rule::gauss_legendre(self.degree() + 1)?;
        let mut sum = RunningSum::default();
        // The length may overflow a product of its own; the root is taken of values in units of the interval.
        let total = self.mesh().total();
        for (piece, &h) in self.pieces().iter().zip(self.mesh().lengths()) {
            sum.add(h / total * rule.integrate(|t| (piece.value(t) / scale).powi(2)));
        }
        let value = scale * (total.sqrt() * sum.value().sqrt());
        Estimate::new(value, ENTRY_ROUNDING * value, Work::default())
    }

    /// A power of two near the largest value; 1 for the zero function.
    fn scale(&self) -> f64 {
        power_of_two(self.pieces().iter().map(|piece| piece.size()).fold(0.0, f64::max))
    }

    /// A power of two near the largest difference of two values: squares of differences of a few ulps must
    /// not underflow.
    fn spread(&self) -> f64 {
        let (mut low, mut high, mut bubbles) = (f64::INFINITY, f64::NEG_INFINITY, 0.0_f64);
        for piece in self.pieces() {
            low = low.min(piece.left).min(piece.right);
            high = high.max(piece.left).max(piece.right);
            bubbles = bubbles.max(piece.bubbles.iter().map(|c| c.abs()).fold(0.0, f64::max));
        }
        let spread = (0.5 * high - 0.5 * low).max(bubbles);
        if spread == 0.0 { self.scale() } else { power_of_two(spread) }
    }

    /// |u|_ν with its error, which may exceed the tolerance; u and the lengths are divided by powers of two,
    /// and |u|_ν ~ L^{1/2−ν}.
    fn seminorm_as_it_is(&self, order: Order, tolerance: Tolerance) -> Result<Estimate> {
        self.require_finite_seminorm(order)?;
        let scale = self.spread();
        let (unit, partition) = self.mesh().of_moderate_lengths()?;
        let moderate = self.scaled_by(1.0 / scale).on(partition);
        let root = moderate.seminorm_squared_of_moderate(order, tolerance)?.sqrt()?;
        // ν − 1/2 is rounded for small ν, and the logarithm of the unit may be 700.
        let length = if order.value() < 0.25 {
            unit.sqrt() * unit.powf(-order.value())
        } else {
            unit.powf(-order.offset())
        };
        // Exponents like 3 − 2ν are rounded, and they multiply logarithms of such lengths.
        let logarithm =
            self.mesh().lengths().iter().fold(0.0, |most: f64, length| most.max(length.ln().abs()));
        let rounding =
            if unit == 1.0 { 0.0 } else { (4.0 + 0.15 * logarithm) * f64::EPSILON * root.value };
        Estimate::new(root.value, root.error + rounding, root.work)?.times(length)?.times(scale)
    }

    fn require_finite_seminorm(&self, order: Order) -> Result<()> {
        if order.is_below_half() || self.is_continuous() {
            return Ok(());
        }
        Err(Error::InfiniteNorm {
            order: order.value(),
            why: "a function with a jump is not in H^nu for nu >= 1/2",
        })
    }
}
