//! Dual norms of piecewise polynomials: by resolvents in the interpolation spaces (`resolvent`), by piecewise
//! linear functions with a known correction for (1.1) (`regional`).

use super::resolvent::Ends;
use crate::error::Result;
use crate::estimate::{Estimate, Tolerance};
use crate::numeric::scale::power_of_two;
use crate::order::Order;
use crate::piecewise::PiecewisePolynomial;

/// The norm whose dual norm is computed.
///
/// | [`DualOf`] | ‖v‖² | space |
/// | --- | --- | --- |
/// | `Slobodeckij` | ∥v∥²_0 + \|v\|²_ν, (1.1) of the paper | H^ν(I) |
/// | `Interpolation` | Σ_k (1+λ_k)^ν v_k², v_k coefficients in orthonormal cosines | H^ν(I) |
/// | `InterpolationZero` | the same with sines | H^ν, H^{1/2}_{00}, H^ν_0 for ν below, at, above 1/2 |
///
/// λ_k = (kπ/L)², L the length of I. The dual of the first norm at ν = 1/2 is ∥·∥\_{1/2,*} of (4.7) and Remark 2.
/// The other two are the norms of \[L², H¹\]_ν and \[L², H¹_0\]_ν, expressed by eigenpairs.
///
/// The first two are equivalent norms on the same space, with different constants; the third is larger than the
/// second, and for ν ≥ 1/2 its space is smaller, so that its dual norm is smaller than that of the second.
///
/// ```
/// use fractional_sobolev::{DualOf, Function, Mesh};
/// let sign = Function::piecewise(&Mesh::uniform(2, 1.0)?, 0, &[1.0, -1.0])?;
/// let cosines = sign.dual_norm(DualOf::Interpolation, 0.5, 1e-8)?.value;
/// let sines = sign.dual_norm(DualOf::InterpolationZero, 0.5, 1e-8)?.value;
/// assert!(sines < cosines);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[doc(alias("H-1/2", "dual norm"))]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DualOf {
    /// ∥v∥²_0 + |v|²_ν.
    Slobodeckij,
    /// Interpolation between L² and H¹, by cosines.
    Interpolation,
    /// Interpolation between L² and H¹_0, by sines.
    InterpolationZero,
}

impl PiecewisePolynomial {
    /// A unit for f: its largest value times a power of two close to the L² norm, on the unit interval, of f
    /// divided by that value, so that squares of a load on a short element neither overflow nor underflow. 0
    /// for the zero function.
    pub(super) fn unit_of_load(&self) -> f64 {
        let size = self.pieces().iter().map(|piece| piece.size()).fold(0.0, f64::max);
        if size == 0.0 {
            return 0.0;
        }
        let total = self.mesh().total();
        let pieces = self.pieces().iter().zip(self.mesh().lengths());
        let square: f64 = pieces.map(|(piece, h)| h / total * (piece.size() / size).powi(2)).sum();
        size * power_of_two(square.sqrt())
    }

    /// The dual norm sup ∫ u v / ||v||_ν of the functional v ↦ ∫ u v with respect to (1.1), the norm of
    /// [`PiecewisePolynomial::norm`].
    ///
    /// In the interpolation spaces the dual norm is Balakrishnan's integral of resolvents, each in closed form
    /// on every element and summed in O(N): exact to rounding on every mesh, at the cost of some hundred passes
    /// over the elements (a fraction of a second for 100 000 elements).
    ///
    /// In the norm (1.1) it is Q_h + R − R_h: the supremum over piecewise linear functions on M equal elements,
    /// corrected by comparison forms that are known exactly and approximate (1.1) locally; M is doubled up to
    /// 2^20. For ±1 on 100 000 elements, equal or not, eight digits take seconds if ν ≥ 0.3; at ν = 0.1,
    /// unequal elements take forty seconds, and with equal ones the error does not fall below 4e-8. The error
    /// estimate is the change at the last doubling; it is not a proved bound.
    ///
    /// # Errors
    /// [`Error::ToleranceNotMet`] with the best value, if 2^20 elements do not suffice or rounding exceeds the
    /// tolerance; [`Error::NotFinite`] if the norm exceeds the range of binary64.
    ///
    /// [`Error::ToleranceNotMet`]: crate::Error::ToleranceNotMet
    /// [`Error::NotFinite`]: crate::Error::NotFinite
    pub(crate) fn dual_norm(
        &self,
        of: DualOf,
        order: Order,
        tolerance: Tolerance,
    ) -> Result<Estimate> {
        match of {
            DualOf::Slobodeckij => self.dual_of_regional(order, tolerance),
            DualOf::Interpolation => self.dual_by_resolvents(Ends::Neumann, order, tolerance),
            DualOf::InterpolationZero => self.dual_by_resolvents(Ends::Dirichlet, order, tolerance),
        }
    }
}
