//! The scaled KKT residuals of a contact solution, with the same definition for every solver.
//!
//! For min ½ u'K u − F'u subject to B u ≤ g, with multipliers λ:
//!
//! | residual | condition | measure |
//! | --- | --- | --- |
//! | balance | K u − F + B'λ = 0 | max_i abs(residual_i) / force |
//! | sign | λ ≥ 0 | max_i (−λ_i)₊ / λ scale |
//! | gap | B u − g ≤ 0 | max_i (B u − g)₊ / displacement |
//! | complementarity | λ_i (B u − g)_i = 0 | max_i abs(product) / (λ scale · displacement) |
//!
//! force = max_i (abs(K) abs(u) + abs(F))_i is the size of the terms in the balance (a backward error in
//! the sense of Oettli and Prager, normwise), i over the unknowns that are not prescribed;
//! displacement = max(abs(u), abs(g), abs(F_i)/K_ii), i over the same unknowns. The λ scale is max
//! abs(λ), unless all multipliers are below the rounding errors of the balance, [`KKT_ROUNDING`] · force: then it is force.
//! All residuals are invariant under scaling of load, stiffness and lengths. A residual 0/0 (no load) is 0.
//! Cost: O(length).

use crate::error::Result;
use crate::numeric::check::{require_finite, require_length};

/// Multipliers below this multiple of the force scale are attributed to rounding errors in the balance (about 500 ε).
const KKT_ROUNDING: f64 = 1e-13;

/// The terms of the KKT conditions at a candidate solution; `multiplier` and `gap` must list the constraints in the
/// same order.
#[derive(Debug, Clone, Copy)]
pub(crate) struct KktTerms<'a> {
    /// The residual K u − F + B'λ at all unknowns that are not prescribed.
    pub(crate) residual: &'a [f64],
    /// The multipliers λ, one per constraint.
    pub(crate) multiplier: &'a [f64],
    /// The gaps B u − g, one per constraint; feasible if ≤ 0.
    pub(crate) gap: &'a [f64],
    /// The force scale max_i (|K||u| + |F|)_i, i over the unknowns that are not prescribed.
    pub(crate) force: f64,
    /// The displacement scale max(|u|, |g|, |F_i|/K_ii); the last term is positive under a load even if
    /// contact prevents all displacement.
    pub(crate) displacement: f64,
}

/// The four scaled residuals of the KKT conditions; all 0 at an exact solution.
///
/// Nondimensional, ≥ 0, invariant under (K, F, g) → (α K, αβ F, β g), α, β > 0. The balance is a normwise backward
/// error: K u + B'λ = F holds exactly for data changed by this relative amount.
///
/// ```
/// use signorini::{cone::Cone, contact::Solver, problems::TestProblem};
/// let kkt = TestProblem::Block.problem(4)?.solve(Cone::Midpoint, Solver::ActiveSet)?.kkt;
/// assert!(kkt.worst() < 1e-13 && kkt.worst() >= kkt.balance);
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct KktResiduals {
    /// Residual of the balance of forces, K u − F + B'λ = 0.
    pub balance: f64,
    /// Violation of the sign condition: λ ≥ 0, that is σ_N ≤ 0.
    pub sign: f64,
    /// Penetration: violation of the constraints B u ≤ g of the cone.
    pub gap: f64,
    /// Violation of complementarity: λ_i (B u − g)_i = 0.
    pub complementarity: f64,
}

impl KktResiduals {
    /// The largest of the four residuals.
    ///
    /// It is 0 exactly at a KKT point of the convex program, hence at its solution.
    ///
    /// ```
    /// use signorini::cone::KktResiduals;
    /// let kkt = KktResiduals { balance: 1e-15, gap: 3e-9, ..KktResiduals::default() };
    /// assert_eq!(kkt.worst(), 3e-9);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    pub fn worst(&self) -> f64 {
        self.balance.max(self.sign).max(self.gap).max(self.complementarity)
    }
}

/// The margins of strict complementarity: the distance from a degenerate solution, in which a constraint is active
/// with zero force, so that the contact set is ambiguous.
///
/// Strict complementarity: λ_i > 0 or (B u − g)_i < 0 for every i. With both margins at least m, a perturbation of
/// the data that moves λ and B u by less than m relative to their scales leaves the contact set unchanged.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Margins {
    /// The smallest λ_i over the active constraints, relative to max |λ|, or to the force scale if all λ_i are below
    /// rounding; `None` if no constraint is active.
    pub pressure: Option<f64>,
    /// min −(B u − g)_i over the inactive constraints, relative to the displacement scale; `None` if all
    /// constraints are active.
    pub gap: Option<f64>,
}

impl Margins {
    /// True if contact is weak: one of the two margins is at most `threshold`.
    ///
    /// Monotone in the threshold. Without contact only the gap is tested, with full contact only the force.
    ///
    /// ```
    /// use signorini::{cone::Cone, contact::Solver, problems::TestProblem};
    /// let margins = TestProblem::Free.problem(4)?.solve(Cone::Nodal, Solver::ActiveSet)?.margins();
    /// // lifted off everywhere: no contact force, and every gap is open
    /// assert!(margins.pressure.is_none() && !margins.is_weak(1e-3));
    /// # Ok::<(), signorini::Error>(())
    /// ```
    pub fn is_weak(&self, threshold: f64) -> bool {
        [self.pressure, self.gap].into_iter().flatten().any(|margin| margin <= threshold)
    }
}

impl KktTerms<'_> {
    /// The four scaled residuals.
    ///
    /// Computed by the formulas in the table of this module; empty vectors have residual 0.
    ///
    /// # Errors
    /// [`ToolkitError::LengthMismatch`](crate::ToolkitError::LengthMismatch) if `multiplier` and `gap` differ in
    /// length, [`ToolkitError::NotFinite`](crate::ToolkitError::NotFinite) for values that are not finite.
    pub(crate) fn residuals(&self) -> Result<KktResiduals> {
        self.check()?;
        let force_of_contact = self.multiplier_scale();
        let largest = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, f64::max);
        Ok(KktResiduals {
            balance: ratio(largest(&mut self.residual.iter().map(|r| r.abs())), self.force),
            sign: ratio(largest(&mut self.multiplier.iter().map(|&l| -l)), force_of_contact),
            gap: ratio(largest(&mut self.gap.iter().copied()), self.displacement),
            complementarity: largest(&mut self.multiplier.iter().zip(self.gap).map(|(&l, &g)| {
                ratio(l.abs(), force_of_contact) * ratio(g.abs(), self.displacement)
            })),
        })
    }

    /// The margins of strict complementarity for the given active set.
    ///
    /// `active` has one flag per constraint. The margins are nonnegative up to the sign and gap residuals.
    ///
    /// # Errors
    /// As for [`KktTerms::residuals`]; [`ToolkitError::LengthMismatch`](crate::ToolkitError::LengthMismatch) also for
    /// `active`.
    pub(crate) fn margins(&self, active: &[bool]) -> Result<Margins> {
        self.check()?;
        require_length("contact set", active.len(), self.gap.len())?;
        let smallest = |wanted: bool, values: &dyn Fn(usize) -> f64| {
            (0..active.len()).filter(|&i| active[i] == wanted).map(values).reduce(f64::min)
        };
        let scale = self.multiplier_scale();
        Ok(Margins {
            pressure: smallest(true, &|i| ratio(self.multiplier[i], scale)),
            gap: smallest(false, &|i| ratio(-self.gap[i], self.displacement)),
        })
    }

    /// max |λ|, or the force scale if all multipliers are below rounding.
    fn multiplier_scale(&self) -> f64 {
        let largest = self.multiplier.iter().fold(0.0, |m: f64, l| m.max(l.abs()));
        if largest > KKT_ROUNDING * self.force { largest } else { self.force }
    }

    fn check(&self) -> Result<()> {
        require_length("multiplier", self.multiplier.len(), self.gap.len())?;
        let scales = [self.force, self.displacement];
        for (name, values) in [
            ("residual", self.residual),
            ("multiplier", self.multiplier),
            ("gap", self.gap),
            ("scale", &scales),
        ] {
            require_finite(name, values)?;
        }
        Ok(())
    }
}

/// a / b, with 0 / 0 = 0.
fn ratio(a: f64, b: f64) -> f64 {
    if a == 0.0 { 0.0 } else { a / b }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn candidate<'a>(residual: &'a [f64], multiplier: &'a [f64], gap: &'a [f64]) -> KktTerms<'a> {
        KktTerms { residual, multiplier, gap, force: 2.0, displacement: 0.5 }
    }

    #[test]
    fn each_condition_has_its_residual() {
        let kkt =
            candidate(&[0.2, -0.4], &[4.0, -1.0, 0.0], &[0.0, 0.0, -0.1]).residuals().unwrap();
        assert_eq!((kkt.balance, kkt.sign), (0.2, 0.25));
        assert_eq!((kkt.gap, kkt.complementarity), (0.0, 0.0));
        let kkt = candidate(&[], &[4.0, 2.0], &[0.1, -0.25]).residuals().unwrap();
        assert_eq!((kkt.gap, kkt.complementarity), (0.2, 0.25));
    }

    #[test]
    fn margins_are_those_of_the_weakest_constraints() {
        let (multiplier, gap) = (&[4.0, 1.0, 0.0], &[0.0, 0.0, -0.5]);
        let terms = KktTerms { residual: &[0.0], multiplier, gap, force: 4.0, displacement: 2.0 };
        let margins = terms.margins(&[true, true, false]).unwrap();
        assert_eq!((margins.pressure, margins.gap), (Some(0.25), Some(0.25)));
        assert!(margins.is_weak(0.3) && !margins.is_weak(0.2));
    }

    /// min w²/2 − 3 w over w ≤ 1: w = 1, λ = 2; with λ = 2.4 the balance w − 3 + λ is 0.4, relative to |w| + 3.
    #[test]
    fn a_wrong_multiplier_is_seen_in_the_balance() {
        let exact = KktTerms {
            residual: &[0.0],
            multiplier: &[2.0],
            gap: &[0.0],
            force: 4.0,
            displacement: 1.0,
        };
        assert_eq!(exact.residuals().unwrap().worst(), 0.0);
        let wrong = KktTerms { residual: &[0.4], multiplier: &[2.4], ..exact };
        assert!((wrong.residuals().unwrap().balance - 0.1).abs() < 1e-15);
    }

    #[test]
    fn values_that_are_not_finite_are_rejected() {
        assert!(candidate(&[f64::NAN], &[], &[]).residuals().is_err());
        assert!(candidate(&[], &[1.0], &[]).residuals().is_err());
    }
}
