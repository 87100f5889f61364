//! The asymptotic law of γ_θ(ν) as θ → 0 for fixed ν, where one is known.

use super::bracket::bracket;
use super::constant::gamma;
use super::constraint::Constraint;
use super::mellin::end_limit;
use super::slopes::kernel::exp_quotient;
use super::uniform::UniformLaw;
use super::zones::Zones;
use crate::Order;
use crate::constant::BestConstant;
use crate::error::{Error, Given, Result};
use crate::estimate::{Estimate, Tolerance, Work};
use crate::numeric::parallel;
use std::f64::consts::PI;

/// Distance below 1/2 within which the law through 1/2 is used: there the power law is the leading term of one whose
/// second term is larger by θ^{1−2s} only.
const NEAR_HALF: f64 = 0.1;

/// The asymptotic law of the constant γ_θ(s) of [`gamma`] as θ → 0 for fixed s, for functions with mean zero
/// on zones of length θ that shrink to the point `place` of \[0, 1\]; for s > 1/2 also for functions that
/// vanish there. It is not uniform in s.
///
/// # Method
///
/// | s | printed in Lemma 5.2 | correct, zone at an end | correct, zone in the interior |
/// | --- | --- | --- | --- |
/// | < 1/2 | C θ^{s−1/2} | B θ^{s−1/2}, B by a Mellin transform | √(tan πs / (2π(1+2s))) θ^{s−1/2} |
/// | = 1/2 | C ln(1/θ) | γ² = A L + c + d/γ² + e/γ⁴ + O(L⁻³) | γ² ~ L/(2π²) |
/// | > 1/2 | C | γ₀(s), `Constraint::vanishing_at` | the same at the point |
///
/// A = 3/(2π²), L = ln(1/θ). At s = 1/2, c, d, e are computed from the dual norm N of u ↦ mean_E u − mean u,
/// E the zone: with its representer r in the inner product ⟨·, ·⟩ of |·|_s, γ² = λ solves λ = N² + ‖r‖₀²/λ +
/// ⟨T²r, r⟩/λ² + ... (T the operator of ‖·‖₀² on functions of mean zero). For 0.4 ≤ s < 1/2, and for s > 1/2
/// if γ₀ cannot be computed in binary64, the same expansion is used with L replaced by (θ^{2s−1} − 1)/(1 −
/// 2s) and A by A(s) = (1 − 2s) B(s)², continued analytically to s > 1/2. In the interior only the leading term of it
/// is known: it is used at these orders, with a remainder that decreases like 1/L relative to the constant.
///
/// ```
/// use fractional_sobolev::{Constraint, gamma, law};
/// let end = law(0.5, 0.0, 1e-8)?;
/// let found = gamma(0.5, Constraint::mean_zero_on(0.0..1e-30), 1e-8)?.constant;
/// let by_law = end.at(1e-30)?;
/// assert!((by_law.value - found.value).abs() <= by_law.error + found.error);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// [`Error::OutOfRange`] for a point outside [0, 1]; those of [`gamma`]; [`Error::ToleranceNotMet`] if B or the
/// dual norms do not meet the tolerance.
#[doc(alias("asymptotics", "limit law"))]
pub fn law(s: impl Given<Order>, place: f64, tolerance: impl Given<Tolerance>) -> Result<Law> {
    let (order, tolerance) = (s.given()?, tolerance.given()?);
    Error::require("position", place, "[0, 1]", (0.0..=1.0).contains(&place))?;
    let at_end = place == 0.0 || place == 1.0;
    let uniform = || UniformLaw::new(order, tolerance).map(|law| Form::Uniform(Box::new(law)));
    let form = if order.offset() > 0.0 {
        match gamma(order, Constraint::vanishing_at(place), tolerance).map(|found| found.constant) {
            Ok(limit) => Form::Constant(limit),
            // so close to 1/2 that the point is out of reach of f64
            Err(Error::ToleranceNotMet { .. }) if at_end => uniform()?,
            Err(Error::ToleranceNotMet { .. }) => Form::Leading(interior_slope(order)?),
            Err(error) => return Err(error),
        }
    } else {
        match at_end {
            true if order.offset() < -NEAR_HALF => Form::Power(end_limit(order, tolerance)?),
            true => uniform()?,
            false if order.offset() < -NEAR_HALF => Form::Power(interior_limit(order)?),
            false => Form::Leading(interior_slope(order)?),
        }
    };
    let expansion = match &form {
        Form::Uniform(law) => {
            Some([law.slope, law.constant, law.correction, law.second_correction])
        }
        _ => None,
    };
    Ok(Law { exponent: order.offset().min(0.0), expansion, order, place, tolerance, form })
}

/// The asymptotic law of γ_θ(s) as θ → 0, for one order and one position of the zone.
///
/// Returned by [`law`].
#[derive(Debug, Clone, PartialEq)]
pub struct Law {
    /// The power of θ: s − 1/2 if that is negative, 0 for s ≥ 1/2.
    pub exponent: f64,
    /// A, c, d, e of γ² = A L + c + d/γ² + e/γ⁴, L as for [`law`], for a zone at an end and s at or near 1/2.
    pub expansion: Option<[Estimate; 4]>,
    order: Order,
    place: f64,
    tolerance: Tolerance,
    form: Form,
}

#[derive(Debug, Clone, PartialEq)]
enum Form {
    /// The law B θ^{s−1/2} for s < 1/2.
    Power(Estimate),
    /// The constant γ₀ of the point.
    Constant(Estimate),
    /// The law through s = 1/2.
    Uniform(Box<UniformLaw>),
    /// A zone in the interior and s at or near 1/2: the slope A of γ² ~ A (θ^{2s−1} − 1)/(1 − 2s).
    Leading(Estimate),
}

impl Law {
    /// The value of γ_θ by the law. Its error contains the remainder of the law: it is the distance of the law from
    /// the computed constant, plus the errors of both.
    ///
    /// At an end of \[0, 1\] the zone is (0, θ) or (1 − θ, 1). In the interior it is any zone of length θ whose
    /// closure contains the place: the remainder is the largest one at the leftmost, the rightmost and the most
    /// central of them. Cost: one or three constants γ.
    ///
    /// ```
    /// use fractional_sobolev::{Law, law};
    /// let inside: Law = law(0.25, 0.5, 1e-8)?;
    /// assert!((inside.at(1e-8)?.value / inside.factor()?.value - 100.0).abs() < 1e-10);
    /// // the remainder at θ = 1e-2 and at 1e-8
    /// assert!(inside.at(1e-2)?.relative_error() > 10.0 * inside.at(1e-8)?.relative_error());
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless 1e-300 ≤ θ < 1; at an end for s near 1/2 beyond θ = 0.8, where the expansion may not
    /// be positive; those of [`gamma`].
    pub fn at(&self, theta: f64) -> Result<Estimate> {
        let value = self.leading(theta)?;
        let remainders = parallel::over(&self.starts(theta), |&start| {
            let zone = Zones::from_start_and_length(start, theta)?;
            let found = gamma(self.order, Constraint::mean_zero_on(zone), self.tolerance);
            let found = Estimate::or_best(found.map(|found| found.constant))?;
            Ok(((value.value - found.value).abs() + found.error, found.work))
        });
        let (mut largest, mut work) = (0.0_f64, value.work);
        for remainder in remainders {
            let (remainder, of_gamma) = remainder?;
            largest = largest.max(remainder);
            work += of_gamma;
        }
        Estimate::new(value.value, value.error + largest, work)
    }

    /// The law without its remainder.
    fn leading(&self, theta: f64) -> Result<Estimate> {
        match &self.form {
            Form::Power(factor) => factor.times(theta.powf(self.order.offset())),
            Form::Constant(limit) => Ok(*limit),
            Form::Uniform(law) => law.gamma(theta),
            Form::Leading(slope) => {
                Error::require("theta", theta, "(0, 1)", theta > 0.0 && theta < 1.0)?;
                let growth = exp_quotient(self.order.one_minus_twice(), -theta.ln());
                slope.times(growth)?.sqrt()
            }
        }
    }

    /// The left ends of the zones of length θ at the place: the leftmost, the most central and the rightmost one.
    fn starts(&self, theta: f64) -> Vec<f64> {
        let last = 1.0 - theta;
        if self.is_at_end() {
            return vec![0.0]; // (1 − θ, 1) by reflection, where 1 − θ would be rounded
        }
        let (low, high) = ((self.place - theta).max(0.0), self.place.min(last));
        let mut starts = vec![low, (0.5 * last).clamp(low.min(high), high), high];
        starts.dedup();
        starts
    }

    fn is_at_end(&self) -> bool {
        self.place == 0.0 || self.place == 1.0
    }

    /// The limit of θ^{−exponent} γ_θ as θ → 0: B for s < 1/2, γ₀ for s > 1/2.
    ///
    /// # Method
    ///
    /// At an end B² = (1/π) ∫₀^∞ dt / ( ((s+1/2)² + t²) C(t) ), C the symbol of the seminorm on (0,∞); in the
    /// interior B² = tan(πs) / (2π(1+2s)).
    ///
    /// ```
    /// use fractional_sobolev::{Order, law};
    /// // B² (1 − 2s) → 3/(2π²) as s → 1/2
    /// let order = Order::half_plus(-1e-5)?;
    /// let limit = law(order, 0.0, 1e-8)?.factor()?.value.powi(2) * (-2.0 * order.offset());
    /// assert!((limit * std::f64::consts::PI.powi(2) / 1.5 - 1.0).abs() < 1e-3);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for s = 1/2, where no such limit exists, and for s so little above 1/2 that γ₀
    /// cannot be computed in binary64; [`Error::ToleranceNotMet`] if the rounding error of 1 − 2s, in
    /// relative terms 9e-16/(1 − 2s), exceeds the tolerance.
    pub fn factor(&self) -> Result<Estimate> {
        match &self.form {
            Form::Power(factor) | Form::Constant(factor) => Ok(*factor),
            _ if self.order.is_below_half() && self.is_at_end() => {
                end_limit(self.order, self.tolerance)
            }
            _ if self.order.is_below_half() => interior_limit(self.order),
            _ => Err(self.no_formula(
                "(0, 1/2) and the orders above 1/2 for which the constant for u = 0 at a point is computable",
            )),
        }
    }

    /// γ_θ(1/2) between two bounds with explicit constants, for the zone (0,θ) with ln(1/θ) = `log`, which may exceed
    /// ln of the largest binary64 number.
    ///
    /// The lower bound is the quotient of a ramp in ln x, the upper bound is √(γ₁² + N²), γ₁ the constant of (0,1), where the dual norm N of u ↦ mean u − mean_(0,θ) u is bounded by the Cauchy-Schwarz
    /// inequality along chains of equal steps in ln x. Cost: about a thousand evaluations per bisection step.
    ///
    /// ```
    /// use fractional_sobolev::law;
    /// let end = law(0.5, 0.0, 1e-3)?;
    /// let slope = 3.0 / (2.0 * std::f64::consts::PI.powi(2));
    /// let between = end.bracket(1e10)?;
    /// let (lower, upper) = (between.lower.value, between.upper.map_or(f64::NAN, |upper| upper.value));
    /// assert!(upper.powi(2) / (slope * 1e10) < 1.001 && lower.powi(2) / (slope * 1e10) > 0.999);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless 1 ≤ `log` ≤ 1e15, s = 1/2 and the zone is at an end; those of [`gamma`].
    pub fn bracket(&self, log: f64) -> Result<BestConstant> {
        if self.order.offset() != 0.0 || !self.is_at_end() {
            return Err(self.no_formula("{1/2}, for a zone at an end"));
        }
        let [lower, upper] = bracket(log)?;
        BestConstant::between(lower.sqrt(), upper.sqrt(), Work::default())
    }

    fn no_formula(&self, range: &'static str) -> Error {
        Error::OutOfRange { name: "nu", value: self.order.value(), range }
    }
}

/// Relative rounding error of a tangent, two products and a square root; 1/2 − s is known exactly.
const CLOSED_FORM: f64 = 8.0 * f64::EPSILON;

/// The limit of θ^{1/2−s} γ_θ for a zone in the interior of (0,1), s < 1/2: √( tan(πs) / (2π(1+2s)) ).
fn interior_limit(order: Order) -> Result<Estimate> {
    Error::require("nu", order.value(), "(0, 1/2)", order.is_below_half())?;
    // tan(πν) = cot(π(1/2 − ν))
    let tangent = 1.0 / (PI * -order.offset()).tan();
    let limit = (tangent / (2.0 * PI * (1.0 + 2.0 * order.value()))).sqrt();
    Estimate::new(limit, CLOSED_FORM * limit, Work { points: 1, ..Work::default() })
}

/// The slope A of γ² with respect to (θ^{2ν−1} − 1)/(1 − 2ν) for a zone in the interior of (0,1), analytic at ν = 1/2:
/// A = (1 − 2ν) tan(πν) / (2π(1+2ν)), 1/(2π²) at ν = 1/2.
fn interior_slope(order: Order) -> Result<Estimate> {
    let p = order.one_minus_twice();
    // tan(πν) = cot(πp/2)
    let product = if p == 0.0 { 2.0 / PI } else { p / (0.5 * PI * p).tan() };
    let slope = product / (2.0 * PI * (1.0 + 2.0 * order.value()));
    Estimate::new(slope, CLOSED_FORM * slope, Work { points: 1, ..Work::default() })
}
