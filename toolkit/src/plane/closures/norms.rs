//! Norms of order s, 0 and 1 + s of functions given by code.

use super::function::SingularPlaneFunction;
use super::piece::View;
use super::sums::{ClosureSum, Quantity};
use crate::error::{Error, Result};
use crate::estimate::{Estimate, SPENT, Tolerance};
use crate::numeric::scale::power_of_two;
use crate::order::Order;
use crate::root::{accept, root_of_squares};

/// Message: what limits the accuracy.
const LIMIT: &str = "the largest number of quadrature points is reached: the function is less smooth than declared, or \
     rounding limits the accuracy";

/// The estimate if it meets the tolerance, otherwise [`Error::ToleranceNotMet`].
fn judged(what: &'static str, found: Estimate, tolerance: Tolerance) -> Result<Estimate> {
    accept(what, found, tolerance, if found.work.points > tolerance.work() { SPENT } else { LIMIT })
}

impl SingularPlaneFunction<'_> {
    /// The seminorm |w|_s.
    ///
    /// # Method
    ///
    /// ```text
    /// |w|²_s = ∫∫ (w(x)−w(y))² / |x−y|^{2+2s},  ||w||²_s = ||w||² + |w|²_s,
    /// ||w||²_{1+s} = ||w||² + ||∇w||² + |∂₁w|²_s + |∂₂w|²_s.
    /// ```
    ///
    /// For w = w₀ + r^a (…) at a corner it is finite if and only if a > s − 1, and for functions that jump
    /// across an edge if and only if s < 1/2. |w(·/l)|_s = l^{1−s}|w|_s; (1−s)|w|²_s → (π/2)||∇w||² as s → 1 if
    /// this is finite; as s → 0 |w|_s tends to the integral with s = 0. Cost: the number of pairs of triangles
    /// times n⁴, where n is the number of points needed for the tolerance, about 9 for 1e-8; n³ to n⁴ values of
    /// the function per pair. There is no special rule for a singularity along an edge:
    /// [`Error::ToleranceNotMet`] reports the accuracy that was reached.
    ///
    /// # Errors
    /// [`Error::InfiniteNorm`] for a declared corner with a ≤ s − 1, and for a function that jumps if s ≥ 1/2;
    /// [`Error::OutOfRange`] for triangles that touch without a common node or whose distance is too small for
    /// their length; [`Error::NotFinite`] for a value that is not finite; [`Error::ToleranceNotMet`].
    pub(crate) fn seminorm(&self, order: Order, tolerance: Tolerance) -> Result<Estimate> {
        judged("seminorm", self.seminorm_as_it_is(order, tolerance)?, tolerance)
    }

    /// The norm of order s: ||w||²_s = ||w||² + |w|²_s.
    ///
    /// # Errors
    /// As [`SingularPlaneFunction::seminorm`].
    pub(crate) fn norm(&self, order: Order, tolerance: Tolerance) -> Result<Estimate> {
        let parts = [self.seminorm_as_it_is(order, tolerance)?, self.l2_as_it_is(tolerance)?];
        judged("norm", root_of_squares(&parts)?, tolerance)
    }

    /// The norm of order 1 + s, from the given partial derivatives.
    ///
    /// # Errors
    /// [`Error::InfiniteNorm`] if w jumps or the seminorm of order s of the gradient is infinite; else as
    /// [`SingularPlaneFunction::seminorm`].
    pub(crate) fn norm_with_gradient(
        &self,
        gradient: [&SingularPlaneFunction<'_>; 2],
        order: Order,
        tolerance: Tolerance,
    ) -> Result<Estimate> {
        if self.jumps() {
            let why = "a function that jumps has no gradient in L^2";
            return Err(Error::InfiniteNorm { order: 1.0 + order.value(), why });
        }
        let mut parts = vec![self.l2_as_it_is(tolerance)?];
        for part in gradient {
            parts.push(part.l2_as_it_is(tolerance)?);
            parts.push(part.seminorm_as_it_is(order, tolerance)?);
        }
        judged("norm", root_of_squares(&parts)?, tolerance)
    }

    /// The L² norm.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a value that is not finite; [`Error::ToleranceNotMet`].
    pub(crate) fn l2_norm(&self, tolerance: Tolerance) -> Result<Estimate> {
        judged("L2 norm", self.l2_as_it_is(tolerance)?, tolerance)
    }

    fn view(&self) -> View<'_> {
        View { function: self, extent: power_of_two(self.mesh().extent()), unit: self.unit() }
    }

    fn l2_as_it_is(&self, tolerance: Tolerance) -> Result<Estimate> {
        let view = self.view();
        let sum = ClosureSum::new(view, Order::HALF, tolerance, Quantity::Square)?;
        sum.square()?.sqrt()?.times(view.unit)?.times(view.extent)
    }

    fn seminorm_as_it_is(&self, order: Order, tolerance: Tolerance) -> Result<Estimate> {
        let infinite = |why| Err(Error::InfiniteNorm { order: order.value(), why });
        if self
            .corners()
            .all
            .iter()
            .any(|corner| corner.exponent + order.complement() <= f64::EPSILON)
        {
            return infinite(
                "r^a times a smooth angular part is in H^s near a corner only for a > s - 1",
            );
        }
        if self.jumps() && !order.is_below_half() {
            return infinite("a function that jumps across an edge is not in H^s for s >= 1/2");
        }
        let view = self.view();
        let sum = ClosureSum::new(view, order, tolerance, Quantity::Seminorm)?;
        let root = sum.seminorm()?.sqrt()?.times(view.unit)?;
        root.times(view.extent.powf(order.complement()))
    }
}
