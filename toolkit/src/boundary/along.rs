//! Norms on polygonal curves that depend on the arc length s only: L^q, and dual norms of interpolation
//! spaces.
//!
//! The eigenfunctions of −d²/ds² on a closed curve of length L are 1 and the pairs cos, sin of 2πks/L. Those
//! even about s = L/2 are the cosines of an interval of length L/2, the odd ones its sines, with the same
//! eigenvalues: f is the sum of (f(s) ± f(L−s))/2 on (0, L/2), and its squared dual norm is twice the sum of
//! the squared dual norms of the two parts.

use super::function::BoundaryFunction;
use crate::dual::DualOf;
use crate::error::Result;
use crate::estimate::{Estimate, Tolerance};
use crate::mesh::Mesh;
use crate::order::Order;
use crate::piecewise::PiecewisePolynomial;
use crate::root::{accept, root_of_squares};

/// Nodes of the two halves closer than this, relative to the length, are merged.
const ONE_NODE: f64 = 16.0 * f64::EPSILON;

impl BoundaryFunction {
    /// The norm ||u||\_{L^q(Γ)} = (∫_Γ |u|^q ds)^{1/q}, 1 ≤ q ≤ ∞, exact to rounding on every element as
    /// [`PiecewisePolynomial::lq_norm`]. Cost O(N).
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for q < 1 or NaN; [`Error::NotFinite`] on overflow.
    ///
    /// [`Error::OutOfRange`]: crate::Error::OutOfRange
    /// [`Error::NotFinite`]: crate::Error::NotFinite
    pub(crate) fn lq_norm(&self, q: f64, tolerance: Tolerance) -> Result<Estimate> {
        self.along()?.lq_norm(q, tolerance)
    }

    /// The dual norm of the norm that [`DualOf`] names: [`BoundaryFunction::dual_norm`] for `Slobodeckij`;
    /// otherwise that of an interpolation space between L²(Γ) and H¹(Γ), or H¹_0(Γ), with the norm Σ_k
    /// (1+λ_k)^ν v_k², (λ_k, v_k) from the eigenpairs of −d²/ds² along the curve.
    ///
    /// # Method
    ///
    /// These norms depend on the arc length only, not on corners. On an open curve they are the norms of
    /// [`PiecewisePolynomial::dual_norm`] on (0, L). On a closed curve λ = (2πk/L)², each k ≥ 1 twice; f is
    /// split into its even and odd parts, expanded on half of the length in cosines and sines. A closed
    /// curve has no ends, so that `InterpolationZero` equals `Interpolation`. Cost O(N): 10⁵ elements in a
    /// second; `Slobodeckij` is limited to 1500 elements.
    ///
    /// # Errors
    /// As [`BoundaryFunction::dual_of_slobodeckij`] and [`PiecewisePolynomial::dual_norm`].
    pub(crate) fn dual_norm(
        &self,
        of: DualOf,
        order: Order,
        tolerance: Tolerance,
    ) -> Result<Estimate> {
        if of == DualOf::Slobodeckij {
            return self.dual_of_slobodeckij(order, tolerance);
        }
        if !self.curve().is_closed() {
            return self.along()?.dual_norm(of, order, tolerance);
        }
        let inner =
            Tolerance::new((0.5 * tolerance.relative()).max(1e-15))?.with_work(tolerance.work());
        let [even, odd] = self.even_and_odd()?;
        let even = Estimate::or_best(even.dual_norm(DualOf::Interpolation, order, inner))?;
        let odd = Estimate::or_best(odd.dual_norm(DualOf::InterpolationZero, order, inner))?;
        let found = root_of_squares(&[even, odd])?.times(std::f64::consts::SQRT_2)?;
        // Each node may be displaced by ONE_NODE L, which counts as much as an element of that length.
        let displaced = ONE_NODE * self.curve().len() as f64 * found.value;
        let found = Estimate::new(found.value, found.error + displaced, found.work)?;
        accept(
            "dual norm",
            found,
            tolerance,
            "the dual norms of the even and the odd part limit the accuracy",
        )
    }

    /// The function of the arc length on (0, L).
    fn along(&self) -> Result<PiecewisePolynomial> {
        let lengths =
            (0..self.curve().len()).map(|e| self.curve().element_length(e)).collect::<Vec<_>>();
        PiecewisePolynomial::discontinuous_linears(Mesh::from_lengths(&lengths)?, self.ends())
    }

    /// (f(s) + f(L−s))/2 and (f(s) − f(L−s))/2 on (0, L/2), with the nodes of both halves.
    fn even_and_odd(&self) -> Result<[PiecewisePolynomial; 2]> {
        let (count, half) = (self.curve().len(), 0.5 * self.curve().length());
        let near = 2.0 * ONE_NODE * half;
        let length = |e: usize| self.curve().element_length(e);
        // Elements at s and at L−s, and how much of them is left.
        let (mut e, mut f) = (0, count - 1);
        let (mut rest, mut back) = (length(e), length(f));
        let (mut at, mut lengths) = (0.0, Vec::with_capacity(count));
        let (mut even, mut odd) = (Vec::with_capacity(count), Vec::with_capacity(count));
        while half - at > near && e <= f {
            let step = rest.min(back).min(half - at);
            // From s to s + step, the second one backwards.
            let value = |e: usize, t: f64| self.ends()[e][0] * (1.0 - t) + self.ends()[e][1] * t;
            let there = [rest, rest - step].map(|left| value(e, 1.0 - left / length(e)));
            let here = [back, back - step].map(|left| value(f, left / length(f)));
            lengths.push(step);
            even.push([0, 1].map(|k| 0.5 * there[k] + 0.5 * here[k]));
            odd.push([0, 1].map(|k| 0.5 * there[k] - 0.5 * here[k]));
            (rest, back, at) = (rest - step, back - step, at + step);
            let slack = |left: f64| left <= ONE_NODE * at;
            if slack(rest) && e + 1 < count {
                e += 1;
                rest = length(e);
            }
            if slack(back) && f > 0 {
                f -= 1;
                back = length(f);
            }
        }
        let partition = Mesh::from_lengths(&lengths)?;
        let odd = PiecewisePolynomial::discontinuous_linears(partition.clone(), &odd)?;
        Ok([PiecewisePolynomial::discontinuous_linears(partition, &even)?, odd])
    }
}
