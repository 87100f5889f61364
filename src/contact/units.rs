//! Units for loads so small or so large that their squares leave the range of binary64: an iteration that measures
//! its error by (r, M r)^{1/2}, r the residual and M the preconditioner, would treat errors below 1e-162 as
//! zero.
//!
//! The problem is positively homogeneous in (F, u_D, g): it is scaled by a power of two for which the energy is
//! moderate, which is exact up to underflow, and the solution is scaled back. With k the largest modulus of the form
//! the energy is about |F|²/k, and k g² where data are prescribed.

use super::multigrid::MultigridReport;
use super::problem::ContactProblem;
use super::solution::ContactSolution;
use crate::error::Result;
use crate::fem::Form;
use crate::numeric::check::require_values;
use crate::numeric::scale::{largest, power_of_two};
use fractional_sobolev::Estimate;

/// Energy norms in [1/PLAIN, PLAIN] are not rescaled.
const PLAIN: f64 = 1e60;

impl ContactProblem {
    /// The scaled problem and its unit, a power of two; `None` if no scaling is needed, or none helps.
    pub(super) fn in_unit(&self) -> Option<(Self, f64)> {
        let stiff = match &self.form {
            Form::Scalar { .. } => 1.0,
            Form::Elastic { materials } => {
                materials.iter().map(|m| m.lambda().abs().max(m.mu())).fold(0.0, f64::max)
            }
        };
        let root = f64::sqrt(stiff);
        let length = largest(&self.gap).max(largest(&self.values));
        let norm = (largest(&self.load) / root).max(length * root);
        if norm == 0.0 || !norm.is_finite() || (PLAIN.recip()..=PLAIN).contains(&norm) {
            return None;
        }
        let unit = power_of_two(norm);
        let mut scaled = self.clone();
        for values in [&mut scaled.load, &mut scaled.values, &mut scaled.gap] {
            values.iter_mut().for_each(|v| *v /= unit);
        }
        Some((scaled, unit))
    }
}

impl ContactSolution {
    /// The solution with displacements and forces multiplied by the unit and the energy by its square.
    /// Dimensionless quantities are unchanged.
    pub(super) fn scaled_by(mut self, unit: f64) -> Result<Self> {
        for values in [
            &mut self.displacement,
            &mut self.normal_displacement,
            &mut self.multiplier,
            &mut self.gap,
            &mut self.pressure,
        ] {
            values.iter_mut().for_each(|v| *v *= unit);
        }
        self.traction.iter_mut().flatten().for_each(|v| *v *= unit);
        self.reaction.iter_mut().for_each(|v| *v *= unit);
        for value in [
            &mut self.force_scale,
            &mut self.displacement_scale,
            &mut self.contact_force,
            &mut self.force_rounding,
        ] {
            *value *= unit;
        }
        for value in [&mut self.energy, &mut self.energy_rounding, &mut self.energy_scale] {
            *value = *value * unit * unit;
        }
        for step in &mut self.steps {
            step.energy = step.energy * unit * unit;
            step.penetration *= unit;
            step.tension *= unit;
        }
        require_values("energy J", &[self.energy, self.energy_rounding], 2)?;
        self.multigrid = self.multigrid.map(|report| report.scaled_by(unit));
        Ok(self)
    }
}

impl MultigridReport {
    fn scaled_by(mut self, unit: f64) -> Self {
        let scaled = |found: Estimate| Estimate {
            value: found.value * unit,
            error: found.error * unit,
            ..found
        };
        self.error = self.error.map(scaled);
        self.discretisation = self.discretisation.map(|error| error * unit);
        for level in &mut self.levels {
            level.error *= unit;
            level.discretisation = level.discretisation.map(|error| error * unit);
        }
        self
    }
}
