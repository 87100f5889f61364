//! Norms of functions with declared breakpoints.

use super::arm::Arm;
use super::arm_integral::ArmIntegral;
use super::function::{Normalized, SingularFunction, Units};
use super::level::{Density, LevelValue};
use super::log_energy::LogEnergy;
use super::look::Look;
use super::refine::{LIMIT, refine};
use super::resolution::missed_of_integral;
use super::scales::{Profile, hidden, is_deep, is_endless, power};
use super::waves::OfWaves;
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance, Work};
use crate::kernel::power::PowerKernel;
use crate::order::Order;
use crate::root::{accept, whole};

/// Message: the function is not smooth between its breakpoints.
const UNDECLARED: &str =
    "the function is not smooth at a point between its breakpoints: declare it as a breakpoint";
/// Message: the function has structure that rules along its sides do not resolve; polynomials do ([`crate::resolved`]).
const SCALES: &str =
    "the function has structure on many scales or is not smooth between its breakpoints";
/// Message: a factor whose logarithm may be 700 is rounded.
const OF_UNIT: &str = "the power of the length of the interval is rounded";

impl Units {
    /// ‖u‖ in L^q from that of the normalized function.
    pub(crate) fn in_lq(self, q: f64, found: Estimate) -> Result<Estimate> {
        found.times(self.length.powf(1.0 / q))?.times(self.size)
    }

    /// |u|_ν from the seminorm of the normalized function: |u|_ν ~ L^{1/2−ν}.
    pub(crate) fn seminorm(self, order: Order, found: Estimate) -> Result<Estimate> {
        // ν − 1/2 is rounded for small ν, and the logarithm of the unit may be 700.
        let factor = if order.value() < 0.25 {
            self.length.sqrt() * self.length.powf(-order.value())
        } else {
            self.length.powf(-order.offset())
        };
        let rounding = 0.3 * self.length.ln().abs() * f64::EPSILON;
        let error = found.error + rounding * found.value;
        Estimate { error, ..found }.times(factor)?.times(self.size)
    }
}

impl SingularFunction<'_> {
    /// The seminorm |u|_ν on the whole interval.
    ///
    /// # Method
    ///
    /// Each integral is computed at two levels of accuracy or more: orders n and cell widths h of the rules
    /// in logarithmic coordinates. The error of the finer one is estimated by their difference (the error
    /// of the *coarser* one), plus the errors of the limits along the sides, of rounding, and of
    /// oscillations between the points of the rules. Cost: a seminorm takes about (sides)² 10⁵ kernel
    /// values at 1e-8.
    ///
    /// A function with many oscillations is replaced by polynomials on short cells, at a cost of O(cells)
    /// ([`super::waves`]). One with structure on several scales is rejected, and is then resolved by polynomials
    /// ([`crate::resolved`]). It is recognised by samples once per unit of ln δ, down to the smallest distance: a layer
    /// e^{−δ/w} at a breakpoint is noticed for w ≥ 1e-290. A feature narrower than
    /// 1/500 of an interval away from the breakpoints may be missed ([`super::look`]): declare its position as a
    /// breakpoint, and give the function by positions.
    ///
    /// # Errors
    /// [`Error::InfiniteNorm`] if the contributions near a breakpoint do not decay, [`Error::ToleranceNotMet`],
    /// [`Error::NotFinite`] if the function is NaN or infinite between the breakpoints.
    ///
    /// A function of x alone that is singular at a breakpoint x₀ other than 0 is rejected, because x − x₀ is
    /// rounded there (use [`SingularFunction::from_positions`]); so is a computation that exceeds the limit of
    /// [`Tolerance::with_work`].
    pub(crate) fn seminorm(&self, order: Order, tolerance: Tolerance) -> Result<Estimate> {
        let normalized = self.normalized(tolerance)?;
        let found = normalized.u.seminorm_of_normalized(order, tolerance);
        let back = |found: Estimate| normalized.units.seminorm(order, found);
        let found = found.map_err(|error| error.carry("seminorm", back)).and_then(back)?;
        accept("seminorm", found, tolerance, OF_UNIT)
    }

    /// |u|_ν of a function of size 1 on an interval of length 1.
    fn seminorm_of_normalized(&self, order: Order, tolerance: Tolerance) -> Result<Estimate> {
        let waves = self.seminorm_of_waves(order, tolerance)?;
        if let OfWaves::Found(found) = waves {
            return Ok(found);
        }
        let profile = Profile::of(self);
        let is_inside = matches!(waves, OfWaves::Inside);
        let is_constant = !is_inside && profile.is_constant();
        let logs = profile.energies(PowerKernel::new(order));
        let asked = 2.0 * tolerance.relative();
        // Whether the rest of a slow end is finite, and how large, the rules find out.
        let is_endless = is_endless(&logs, asked);
        let is_deep = !is_endless && (profile.is_unequal() || is_deep(&logs, asked));
        if !is_constant && (is_inside || is_deep) {
            return Err(Error::out_of_reach(
                "seminorm",
                tolerance.relative(),
                f64::INFINITY,
                SCALES,
            ));
        }
        let root = |squared: Estimate| squared.sqrt();
        refine(self, tolerance, 2.0, is_constant, |level, tolerance| {
            LogEnergy::new(self, order, level)?.compute(tolerance)
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
        whole(parts, tolerance, LIMIT)
    }

    /// The norm ||u||_{1+ν} of a function and its derivative.
    ///
    /// # Errors
    /// As [`SingularFunction::seminorm`]; [`Error::OutOfRange`] if the intervals of the function and of its
    /// derivative differ in length.
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
            "{length of the function's interval}",
            same,
        )?;
        whole([self.l2_norm(tolerance), derivative.norm(order, tolerance)], tolerance, LIMIT)
    }

    /// The L² norm.
    ///
    /// # Errors
    /// As [`SingularFunction::lq_norm`].
    pub(crate) fn l2_norm(&self, tolerance: Tolerance) -> Result<Estimate> {
        self.lq_norm(2.0, tolerance)
    }

    /// The norm ||u||\_{L^q} = (∫ |u|^q)^{1/q}, 1 ≤ q ≤ ∞. Declare the zeros of u (for q = ∞ its jumps) as
    /// breakpoints.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for q < 1 or NaN, else as [`SingularFunction::seminorm`].
    pub(crate) fn lq_norm(&self, q: f64, tolerance: Tolerance) -> Result<Estimate> {
        Error::require("q", q, "[1, inf]", q >= 1.0)?;
        let Normalized { units, u } = self.normalized(tolerance)?;
        if q == f64::INFINITY {
            let back = |found: Estimate| found.times(units.size);
            return u
                .largest(tolerance)
                .map_err(|error| error.carry("L^inf norm", back))
                .and_then(back);
        }
        let back = |found: Estimate| units.in_lq(q, found);
        let (waves, look) = u.l2_norm_of_waves(tolerance)?;
        if let Some(found) = waves
            && q == 2.0
        {
            return back(found);
        }
        // Powers of a layer high above what counts of it in L² would overflow.
        let profile = Profile::of(&u);
        let unit = profile.unit_in_lq(q);
        let root = |power: Estimate| {
            let value = power.value.max(0.0).powf(1.0 / q);
            let error = if power.value > power.error {
                value * (power.error / power.value) / q
            } else {
                power.error.powf(1.0 / q)
            };
            // Powers of rounded values.
            let rounding = 32.0 * f64::EPSILON * value;
            back(Estimate::new(value, error + rounding, power.work)?.times(unit)?)
        };
        u.integral_of(&profile, &look, tolerance, q, q, &|u| power(u / unit, q))
            .map_err(|error| error.carry("L^q norm", root))
            .and_then(root)
    }

    /// The mean (1/|I|) ∫ u; the tolerance is relative to the mean of |u|.
    ///
    /// # Errors
    /// As [`SingularFunction::lq_norm`].
    pub(crate) fn mean(&self, tolerance: Tolerance) -> Result<Estimate> {
        let Normalized { units: Units { size: scale, .. }, u } = self.normalized(tolerance)?;
        let profile = Profile::of(&u);
        let (_, look) = u.l2_norm_of_waves(tolerance)?;
        let crude = Tolerance::fast().with_work(tolerance.work());
        let size =
            Estimate::or_best(u.integral_of(&profile, &look, crude, 1.0, 1.0, &f64::abs))?.value;
        if size == 0.0 {
            return Estimate::new(0.0, 0.0, Work::default());
        }
        // u/size + 2 is safely positive in the mean, so that a relative tolerance means something.
        let length = u.length();
        let shift = 2.0 / length;
        let back = |shifted: Estimate| {
            let factor = size / length;
            Estimate::new((shifted.value - 2.0) * factor, shifted.error * factor, shifted.work)?
                .times(scale)
        };
        u.integral_of(&profile, &look, tolerance, 0.3, 1.0, &|u| u / size + shift)
            .map_err(|error| error.carry("mean", back))
            .and_then(back)
    }

    /// ∫ f(u(x)) dx, f comparable to |u|^q, to `factor` times the tolerance.
    fn integral_of(
        &self,
        profile: &Profile,
        look: &Look,
        tolerance: Tolerance,
        factor: f64,
        q: f64,
        f: &dyn Fn(f64) -> f64,
    ) -> Result<Estimate> {
        let asked = factor * tolerance.relative();
        let by_scales = || {
            let found = self.integral_by_scales(look, asked, &f)?;
            if found.relative_error() <= asked {
                return Ok(found);
            }
            let why = if look.is_inside { UNDECLARED } else { LIMIT };
            Err(Error::not_met("integral", tolerance.relative(), found, why))
        };
        let logs = profile.densities(q);
        if look.is_inside || is_deep(&logs, asked) {
            return by_scales();
        }
        match self.integral_by_rules(profile, look, tolerance, factor, &f) {
            Err(refused @ Error::ToleranceNotMet { .. }) if self.work_left() > 0 => {
                by_scales().map_err(|_| refused)
            }
            // A layer too small to count is seen by the samples only: what they see is part of the error, doubled.
            found => found.map(|found| Estimate {
                error: found.error + 2.0 * hidden(&logs, asked) * found.value.abs(),
                ..found
            }),
        }
    }

    /// The same for functions without structure on small scales.
    fn integral_by_rules(
        &self,
        profile: &Profile,
        look: &Look,
        tolerance: Tolerance,
        factor: f64,
        f: &impl Fn(f64) -> f64,
    ) -> Result<Estimate> {
        let arms = self.arms();
        // Seen already, on all scales.
        let seen = |(k, arm): (usize, &Arm)| -> Vec<(f64, f64)> {
            let of = |(delta, u): (f64, f64)| ((arm.length / delta).ln(), delta * f(u));
            profile.samples(k).map(of).collect()
        };
        let samples: Vec<Vec<(f64, f64)>> = arms.iter().enumerate().map(seen).collect();
        refine(self, tolerance, factor, false, |level, tolerance| {
            let integral = ArmIntegral::new(level, tolerance, 0.0, 0.0, 1.0)?;
            let (mut value, mut tail, mut rounding, mut points) = (0.0, 0.0, 0.0, 0);
            let mut is_settled = true;
            let mut sides = Vec::with_capacity(arms.len());
            for (arm, samples) in arms.iter().zip(&samples) {
                let found = integral.integrate(arm.depth, value, None, samples, |t| {
                    points += 1;
                    let delta = arm.delta(t);
                    let value = delta * f(self.along(arm, t, delta)?);
                    Ok(Density { value, rounding: 4.0 * f64::EPSILON * value.abs() })
                })?;
                value += found.limit.value;
                tail += found.limit.error;
                rounding += found.rounding;
                is_settled &= found.is_settled;
                sides.push(found.limit.value);
            }
            let missed = missed_of_integral(self, level, f)?;
            let of_rules = (is_settled && !look.is_structured).then_some(missed);
            Ok(LevelValue { value, sides, tail, rounding, missed, of_rules, points })
        })
    }
}
