//! The induction (5.5)-(5.9) in the proof of Lemma 5.2, both sides of every step.

use crate::ErrorExt;
use crate::EstimateExt;
use fractional_sobolev::{Constraint, Extremal, gamma};
use fractional_sobolev::{Error, Estimate, Function, Given, Order, Result, Tolerance};

/// The extremal function is interpolated by polynomials of this degree on its cells, each cut into pieces.
const DEGREE: usize = 2;
const PIECES: usize = 6;
/// Nodes this close to θ, relative, are θ.
const AT_THETA: f64 = 1e-12;

/// One step from θ to θ².
///
/// Returned by [`induction`].
///
/// ```
/// use experiments::induction::{InductionStep, induction};
/// // θ = 0.1, 0.01, 1e-4: γ grows by less than the 1 + θ^{ν−1/2} of the proof
/// for InductionStep { theta, factor, bound, share, .. } in induction(0.75, 0.1, 2, 1e-3)? {
///     assert!(factor.value < bound && share.value < 1.0, "{theta}");
/// }
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InductionStep {
    /// θ² after the step.
    pub theta: f64,
    /// γ after the step.
    pub gamma: Estimate,
    /// γ after the step over γ before it.
    pub factor: Estimate,
    /// Its bound 1 + θ^{ν−1/2} (5.8).
    pub bound: f64,
    /// The factor over its bound.
    pub share: Estimate,
    /// |c| / ‖u‖_{0,(0,1)}.
    pub mean: Estimate,
    /// ‖u‖\_{0,(0,1)} / (γ_θ |u|\_{ν,(0,1)}).
    pub poincare: Estimate,
    /// |u|\_{ν,(0,1)} / |u|\_{ν,I}.
    pub restriction: Estimate,
    /// ‖u‖_{0,I} over the right side of (5.6).
    pub stretched: Estimate,
    /// γ over its bound by γ of the first zone and the product of all factors so far (5.9).
    pub product: Estimate,
    /// γ over γ of the first zone and [`closing_factor`].
    pub closing: Estimate,
}

/// (5.5) by quadrature on both intervals: the larger of |q − 1|, q = θ^{1/2} ‖u‖\_{0,I} / ‖ũ‖₀ and
/// θ^{1/2−ν} |u|\_{ν,I} / |ũ|_ν, for ũ(x) = x^{3/5} (1 − x) on (0, 1) and u(x) = ũ(θx) on I = (0, 1/θ):
/// no digits are lost at the ends, where ũ vanishes, and ũ is in H^ν for every ν < 1.
///
/// ```
/// use experiments::induction::scaling_defect;
/// use fractional_sobolev::{Order, Tolerance};
/// let defect = scaling_defect(Order::HALF, 0.1, Tolerance::fast())?;
/// assert!(defect.value <= 1e-3);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// [`Error::OutOfRange`] unless 0 < θ ≤ 1; those of the quadrature.
pub fn scaling_defect(
    order: impl Given<Order>,
    theta: f64,
    tolerance: impl Given<Tolerance>,
) -> Result<Estimate> {
    let (order, tolerance) = (order.given()?, tolerance.given()?);
    Error::require("theta", theta, "(0, 1]", theta > 0.0 && theta <= 1.0)?;
    let on = |end: f64| {
        Function::from_positions(&[0.0, end], move |at| {
            let distance = (at.offset() / end).abs();
            match at.anchor() {
                0 => distance.powf(0.6) * (1.0 - distance),
                _ => (0.6 * (-distance).ln_1p()).exp() * distance,
            }
        })
    };
    let (unit, stretched) = (on(1.0)?, on(1.0 / theta)?);
    let off = |long: Estimate, short: Estimate, factor: f64| {
        let quotient = factor * long.value / short.value;
        let error = quotient * (long.relative_error() + short.relative_error());
        Estimate::new((quotient - 1.0).abs(), error, long.work + short.work)
    };
    let norms = off(stretched.norm(0.0, tolerance)?, unit.norm(0.0, tolerance)?, theta.sqrt())?;
    let seminorms = off(
        stretched.seminorm(order, tolerance)?,
        unit.seminorm(order, tolerance)?,
        theta.powf(-order.offset()),
    )?;
    Estimate::largest([norms, seminorms]).ok_or(Error::CountOutOfRange {
        name: "norms",
        value: 0,
        range: "[1, inf)",
    })
}

/// What the last lines of the proof make of the product (5.9), for a start θ₀ and any θ ≤ θ₀: γ_θ/γ_{θ₀} is
/// at most
///
/// | ν | |
/// | --- | --- |
/// | = 1/2 | 2 ln(1/θ) / ln(1/θ₀) |
/// | > 1/2 | exp Σ_i (θ₀^{ν−1/2})^{2^i} |
/// | < 1/2 | θ^{ν−1/2} exp Σ_i (θ₀^{1/4−ν/2})^{2^i} |
///
/// with all terms of the sums, so that only θ^{ν−1/2} and ln(1/θ) depend on θ. Infinite where exp overflows,
/// for ν near 1/2.
///
/// ```
/// use experiments::induction::closing_factor;
/// use fractional_sobolev::Order;
/// // 2 ln(1/θ)/ln(1/θ₀)
/// assert!((closing_factor(Order::HALF, 0.1, 0.001)? - 6.0).abs() < 1e-14);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// [`Error::OutOfRange`] unless 0 < θ ≤ θ₀ < 1.
pub fn closing_factor(order: impl Given<Order>, start: f64, theta: f64) -> Result<f64> {
    let order = order.given()?;
    Error::require(
        "theta",
        theta,
        "(0, theta_0], theta_0 < 1",
        0.0 < theta && theta <= start && start < 1.0,
    )?;
    // Σ a^{2^i} by ln a, which doubles also where a itself is rounded to 1; the terms below the rounding of
    // the first are not seen.
    let sum = |exponent: f64| {
        let last = exponent * start.ln() + f64::EPSILON.ln();
        let logs = std::iter::successors(Some(exponent * start.ln()), |log| Some(2.0 * log));
        logs.take_while(|&log| log > last).map(f64::exp).sum::<f64>()
    };
    let offset = order.offset();
    Ok(if offset == 0.0 {
        2.0 * theta.ln() / start.ln()
    } else if offset > 0.0 {
        sum(offset).exp()
    } else {
        theta.powf(offset) * sum(-0.5 * offset).exp()
    })
}

/// Squares θ `steps` times. The errors of (5.7) hold for the interpolated function; what its mean over the
/// zone misses of zero is added to that of the Poincaré quotient.
///
/// # Method
///
/// From θ to θ²: γ_{θ²} ≤ γ_θ (1 + θ^{ν−1/2}). With u the extremal function of V_{θ²} in the variable x/θ, I
/// the stretched interval and c the mean of u over (0,1), (5.7) is
/// |c| ≤ ‖u‖\_{0,(0,1)} ≤ γ_θ |u|\_{ν,(0,1)} ≤ γ_θ |u|\_{ν,I},
/// and (5.6) ‖u‖\_{0,I} ≤ θ^{−1/2} |c| + θ^{−ν} γ_θ |u|\_{ν,I}.
///
/// # Errors
/// [`Error::OutOfRange`] unless 0 < θ < 1 and θ^(2^steps) ≥ 1e-300; those of [`gamma`].
///
/// ```
/// use experiments::induction::induction;
/// use fractional_sobolev::{Order, Tolerance};
/// let steps = induction(Order::HALF, 0.1, 1, Tolerance::fast())?;
/// assert!(steps[0].bound == 2.0 && steps[0].factor.value < 1.5);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
pub fn induction(
    order: impl Given<Order>,
    theta: f64,
    steps: u32,
    tolerance: impl Given<Tolerance>,
) -> Result<Vec<InductionStep>> {
    let (order, tolerance) = (order.given()?, tolerance.given()?);
    Error::require("steps", f64::from(steps), "[1, 9]", (1..=9).contains(&steps))?;
    // θ^(2^steps) is the shortest zone; on the whole interval no function is restricted.
    let admissible = theta > 0.0 && theta < 1.0 && theta.powf(2f64.powi(steps as i32)) >= 1e-300;
    let mut theta = Error::require("theta", theta, "(0, 1), its powers above 1e-300", admissible)?;
    let solve = |theta: f64| {
        gamma(order, Constraint::mean_zero_on(0.0..theta), tolerance)
            .map(|found| (found.constant, found.extremal()))
    };
    let start = theta;
    let mut before = solve(theta)?.0;
    let first = before;
    let mut bound = before;
    let mut found = Vec::new();
    for _ in 0..steps {
        let (gamma, function) = solve(theta * theta)?;
        let step = 1.0 + theta.powf(order.offset());
        bound = Estimate::new(bound.value * step, bound.error * step, bound.work)?;
        let [mean, poincare, restriction, stretched] = restricted(order, theta, before, &function)?;
        let (factor, product) = (gamma.over(before)?, gamma.over(bound)?);
        let share = Estimate::new(factor.value / step, factor.error / step, factor.work)?;
        theta *= theta;
        let last = closing_factor(order, start, theta)?;
        let growth = gamma.over(first)?;
        found.push(InductionStep {
            theta,
            gamma,
            factor,
            bound: step,
            share,
            mean,
            poincare,
            restriction,
            stretched,
            product,
            closing: Estimate::new(growth.value / last, growth.error / last, growth.work)?,
        });
        before = gamma;
    }
    Ok(found)
}

/// The three quotients of (5.7) and that of (5.6) for the extremal function of V_{θ²}, in the variable x/θ.
fn restricted(order: Order, theta: f64, gamma: Estimate, u: &Extremal) -> Result<[Estimate; 4]> {
    let whole = u.interpolate(DEGREE, PIECES, &[theta * theta, theta])?;
    let nodes = whole.mesh()?.nodes();
    let before = |end: f64| nodes.iter().filter(|&&x| x <= end * (1.0 + AT_THETA)).count() - 1;
    let (zone, part) = (whole.restrict(0..before(theta * theta))?, whole.restrict(0..before(theta))?);
    // (5.5): |u|_I = θ^{ν−1/2} |ũ|, ‖u‖ = θ^{−1/2} ‖ũ‖
    let scale = theta.powf(order.offset());
    let scaled = |e: Estimate, factor: f64| Estimate::new(e.value * factor, e.error * factor, e.work);
    let seminorm = scaled(part.seminorm(order, Tolerance::fast())?, scale)?;
    let everywhere = scaled(whole.seminorm(order, Tolerance::fast())?, scale)?;
    let root = theta.sqrt().recip();
    let norm = scaled(part.norm(0.0, Tolerance::reference())?, root)?;
    let stretched = scaled(whole.norm(0.0, Tolerance::reference())?, root)?;
    let mean = part.mean(Tolerance::reference())?;
    let poincare = norm.over(seminorm)?.over(gamma)?;
    let missed = zone.mean(Tolerance::reference())?.value.abs() / norm.value * poincare.value;
    // θ^{−1/2} |c| + θ^{−ν} γ_θ |u|_{ν,I}
    let spread = theta.powf(-order.value());
    let right = root * mean.value.abs() + spread * gamma.value * everywhere.value;
    let off = root * mean.error + spread * (gamma.value * everywhere.error + gamma.error * everywhere.value);
    Ok([
        Estimate::new(mean.value.abs(), mean.error, mean.work)?.over(norm)?,
        Estimate::new(poincare.value, poincare.error + missed, poincare.work)?,
        seminorm.over(everywhere)?,
        stretched.over(Estimate::new(right, off, everywhere.work)?)?,
    ])
}
