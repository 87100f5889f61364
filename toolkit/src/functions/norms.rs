//! Norms of functions with declared break points.

use super::arm_integral::ArmIntegral;
use super::function::SingularFunction;
use super::level::{Density, LevelValue};
use super::log_energy::LogEnergy;
use super::refine::{LIMIT, refine};
use super::resolution::missed_of_integral;
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance, Work};
use crate::order::Order;
use crate::root::{accept, root_of_squares, scaled};

impl SingularFunction<'_> {
    /// The seminorm |u|_ν on the whole interval.
    ///
    /// # Method
    ///
    /// Each integral is computed at two levels of accuracy or more: orders n and cell widths h of the rules
    /// in logarithmic coordinates. The error of the finer one is estimated by their difference (the error of
    /// the *coarser* one), plus what the limits along the arms, rounding, and waves between the points of the
    /// rules leave. Cost: a seminorm takes about (arms)² 10⁵ kernel values at 1e-8.
    ///
    /// A function with many waves is interpolated on short cells instead, and takes O(cells).
    ///
    /// # Errors
    /// [`Error::InfiniteNorm`] when the contributions near a break do not decay, [`Error::ToleranceNotMet`],
    /// [`Error::NotFinite`] when the closure returns NaN or an infinite value between the breaks.
    ///
    /// Refused are a function of the coordinate with a singularity at a break that is not 0, where x is rounded
    /// ([`SingularFunction::from_positions`] serves), and what takes more than [`Tolerance::with_work`] allows.
    pub(crate) fn seminorm(&self, order: Order, tolerance: Tolerance) -> Result<Estimate> {
        let (scale, unit) = self.of_moderate_size(tolerance)?;
        let waves = unit.seminorm_of_waves(order, tolerance);
        if let Some(found) = waves.map_err(|error| error.carry("seminorm", |best| scaled(scale, best)))? {
            return scaled(scale, found);
        }
        let root = |squared: Estimate| scaled(scale, squared.sqrt()?);
        refine(&unit, tolerance, 2.0, |level, tolerance| {
            LogEnergy::new(&unit, order, level)?.compute(tolerance)
        })
        .map_err(|error| error.carry("seminorm", root))
        .and_then(root)
    }

    /// The norm ||u||_ν: its square is the sum of the squares of the L² norm and of the seminorm.
    ///
    /// # Errors
    /// As [`SingularFunction::seminorm`].
    pub(crate) fn norm(&self, order: Order, tolerance: Tolerance) -> Result<Estimate> {
        let parts = [self.seminorm(order, tolerance), self.l2_norm(tolerance)];
        whole(parts, tolerance)
    }

    /// The norm ||u||_{1+ν} of a function and its derivative.
    ///
    /// # Errors
    /// As [`SingularFunction::seminorm`]; [`Error::OutOfRange`] when the two live on intervals of different
    /// length.
    pub(crate) fn norm_with_derivative(
        &self,
        derivative: &SingularFunction,
        order: Order,
        tolerance: Tolerance,
    ) -> Result<Estimate> {
        let same = self.length() == derivative.length();
        Error::require(
            "length of the derivative's interval",
            derivative.length(),
            "that of the function",
            same,
        )?;
        whole([self.l2_norm(tolerance), derivative.norm(order, tolerance)], tolerance)
    }

    /// The L² norm.
    ///
    /// # Errors
    /// As [`SingularFunction::lq_norm`].
    pub(crate) fn l2_norm(&self, tolerance: Tolerance) -> Result<Estimate> {
        self.lq_norm(2.0, tolerance)
    }

    /// ||u||\_{L^q} = (∫ |u|^q)^{1/q}, 1 ≤ q ≤ ∞. Zeros of u should be breaks, for q = ∞ its jumps.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for q < 1 or NaN, else as [`SingularFunction::seminorm`].
    pub(crate) fn lq_norm(&self, q: f64, tolerance: Tolerance) -> Result<Estimate> {
        Error::require("q", q, "[1, inf]", q >= 1.0)?;
        let (scale, unit) = self.of_moderate_size(tolerance)?;
        if q == f64::INFINITY {
            return scaled(scale, unit.largest(tolerance)?);
        }
        if q == 2.0
            && let Some(found) = unit.l2_norm_of_waves(tolerance)?
        {
            return scaled(scale, found);
        }
        let root = |power: Estimate| {
            let value = power.value.max(0.0).powf(1.0 / q);
            let error = if power.value > power.error {
                value * power.error / (q * power.value)
            } else {
                power.error.powf(1.0 / q)
            };
            scaled(scale, Estimate::new(value, error, power.work)?)
        };
        unit.integral_of(tolerance, q, |u| u.abs().powf(q))
            .map_err(|error| error.carry("L^q norm", root))
            .and_then(root)
    }

    /// (1/|I|) ∫ u; the tolerance is relative to the mean of |u|.
    ///
    /// # Errors
    /// As [`SingularFunction::lq_norm`].
    pub(crate) fn mean(&self, tolerance: Tolerance) -> Result<Estimate> {
        let (scale, unit) = self.of_moderate_size(tolerance)?;
        let size = unit.lq_norm(1.0, Tolerance::fast().with_work(tolerance.work()))?.value;
        if size == 0.0 {
            return Estimate::new(0.0, 0.0, Work::default());
        }
        // u/size + 2 is safely positive in the mean, so that a relative tolerance means something.
        let length = self.length();
        let shift = 2.0 / length;
        let back = |shifted: Estimate| {
            let factor = size / length * scale;
            Estimate::new((shifted.value - 2.0) * factor, shifted.error * factor, shifted.work)
        };
        unit.integral_of(tolerance, 0.3, |u| u / size + shift)
            .map_err(|error| error.carry("mean", back))
            .and_then(back)
    }

    /// ∫ f(u(x)) dx, to `factor` times the tolerance.
    fn integral_of(&self, tolerance: Tolerance, factor: f64, f: impl Fn(f64) -> f64) -> Result<Estimate> {
        let arms = self.arms();
        refine(self, tolerance, factor, |level, tolerance| {
            let integral = ArmIntegral::new(level, tolerance, 0.0, 0.0)?;
            let (mut value, mut tail, mut rounding, mut points) = (0.0, 0.0, 0.0, 0);
            for arm in &arms {
                let found = integral.integrate(arm.depth, value, None, |t| {
                    points += 1;
                    let delta = arm.delta(t);
                    let value = delta * f(self.at(arm, delta)?);
                    Ok(Density { value, rounding: 4.0 * f64::EPSILON * value.abs() })
                })?;
                value += found.limit.value;
                tail += found.limit.error;
                rounding += found.rounding;
            }
            let missed = missed_of_integral(self, level, &f)?;
            Ok(LevelValue { value, tail, rounding, missed, points })
        })
    }
}

/// √(Σ parts²) of the best that is known of each part, if it meets the tolerance.
fn whole(parts: [Result<Estimate>; 2], tolerance: Tolerance) -> Result<Estimate> {
    let [a, b] = parts.map(Estimate::or_best);
    accept("norm", root_of_squares(&[a?, b?])?, tolerance, LIMIT)
}
