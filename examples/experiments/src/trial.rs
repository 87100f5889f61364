//! Trial functions: quotients below the best constant, the family of Remark 5, and the cut of Remark 7.

use crate::ErrorExt;
use crate::EstimateExt;
use crate::growth::{END_SLOPE, growth, last_exponent};
use fractional_sobolev::{Error, Estimate, Function, Given, Mesh, Order, Result, Tolerance, closed_forms};

/// Ratio of neighbouring layers of a truncated logarithm, in ln x.
const LAYER: f64 = 0.35;
/// Layers there are at least, and layers towards x = 1, each half as long as the one before.
const LEAST_LAYERS: f64 = 8.0;
const LAYERS_AT_ONE: i32 = 40;
/// Nodes this close, relative, are the same.
const ONE_NODE: f64 = 1e-12;
/// Degree of the interpolants.
const DEGREE: usize = 2;

/// w = 1 − min(|ln x|, L)^α / L^α: zero on (0, e^{−L}), one at x = 1; piecewise quadratic on layers graded
/// towards 0 and 1, hence a function of H^{1/2} in its own right. Remark 5 takes α < 1/2; α = 1 is the ramp.
///
/// # Errors
/// [`Error::OutOfRange`] unless 0 < α ≤ 1 and 1 ≤ L ≤ 690.
///
/// ```
/// use experiments::trial::{trial_quotient, truncated_logarithm};
/// use fractional_sobolev::{Order, Tolerance};
/// let [short, shorter] = [16.0, 64.0].map(|log| {
///     trial_quotient(&truncated_logarithm(0.4, log)?, Order::HALF, Tolerance::fast())
/// });
/// assert!(shorter?.value > 1.5 * short?.value);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
pub fn truncated_logarithm(alpha: f64, log: f64) -> Result<Function<'static>> {
    Error::require("alpha", alpha, "(0, 1]", alpha > 0.0 && alpha <= 1.0)?;
    Error::require("L", log, "[1, 690]", (1.0..=690.0).contains(&log))?;
    let layers = (log / LAYER).ceil().max(LEAST_LAYERS);
    let mut nodes = vec![0.0];
    nodes.extend((0..=layers as usize).map(|k| (-log * (1.0 - k as f64 / layers)).exp()));
    nodes.pop();
    let last = nodes[nodes.len() - 1];
    nodes.extend((1..LAYERS_AT_ONE).map(|k| 1.0 - (1.0 - last) * 0.5f64.powi(k)));
    nodes.push(1.0);
    let value = |x: f64| {
        if x <= 0.0 { 0.0 } else { 1.0 - (-x.ln()).min(log).max(0.0).powf(alpha) / log.powf(alpha) }
    };
    Function::interpolate(&Mesh::from_nodes(&nodes)?, DEGREE, value)
}

/// The functions [`truncated_logarithm`] of one α beside the constants of the zones on which they vanish.
///
/// ```
/// use experiments::growth::END_SLOPE;
/// use experiments::trial::{TruncatedFamily, peetre_tartar, truncated_slope};
/// use fractional_sobolev::{Constraint, Order, Tolerance, gamma};
/// let asked = Tolerance::fast();
/// let (log, zone) = (16.0, 0.0..(-16f64).exp());
/// let constant = gamma(Order::HALF, Constraint::vanishing_on(zone), asked)?.constant;
/// let family = TruncatedFamily::new(0.4, &[(log, constant)], asked)?;
/// assert!(family.shares[0].value < 1.0);
/// assert!((truncated_slope(1.0) - END_SLOPE).abs() < 1e-15);
/// // Lemma 5.1: α (‖u‖₀² + |u|²)^{1/2} ≤ |u| with α = (1 + γ²)^{−1/2}
/// assert!((peetre_tartar(constant)?.value - 1.0 / 1f64.hypot(constant.value)).abs() < 1e-12);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct TruncatedFamily {
    /// The exponent α.
    pub alpha: f64,
    /// (L, ‖w‖₀ / |w|_{1/2}).
    pub quotients: Vec<(f64, Estimate)>,
    /// The quotients over the constants.
    pub shares: Vec<Estimate>,
    /// The chain of norms, one per zone; empty for α ≥ 1/2, where |ln x|^α is not in H^{1/2}.
    pub chain: Vec<NormChain>,
    /// The exponent of L in the quotient between the last two zones; see [`last_exponent`].
    pub growth: Option<Estimate>,
    /// What the square of the quotient grows by per unit of L between the last two zones; see
    /// [`growth`]. For α > 1/2 it tends to [`truncated_slope`].
    pub slope: Option<Estimate>,
}

/// Remark 5 prints |w|\_{1/2} ≤ ‖w‖\_{1/2} = ‖v‖\_{1/2} ≤ 1/n for v = u_n/n = 1 − w, ‖u‖\_{1/2} = 1: with
/// full norms the middle is false, since ‖w‖\_{1/2} ≥ ‖w‖₀ ≥ 1 − 1/n. |w| = |v| ≤ ‖v‖\_{1/2} ≤ 1/n repairs
/// it.
///
/// Returned by [`TruncatedFamily`].
///
/// ```
/// use experiments::trial::{NormChain, TruncatedFamily};
/// use fractional_sobolev::{Constraint, gamma};
/// let zone = 0.0..(-64f64).exp();
/// let constant = gamma(0.5, Constraint::vanishing_on(zone), 1e-3)?.constant;
/// let family = TruncatedFamily::new(0.4, &[(64.0, constant)], 1e-3)?;
/// let NormChain { truncation, repaired, printed } = family.chain[0];
/// assert!(truncation <= 1.0 && repaired <= 1.0 && printed > 1.0);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NormChain {
    /// n |w|\_{1/2} over |u|\_{1/2}: at most one, since truncation lowers the seminorm.
    pub truncation: f64,
    /// n |w|_{1/2}, at most one: the repaired chain.
    pub repaired: f64,
    /// n ‖w‖_{1/2}, at most one if the printed chain were right.
    pub printed: f64,
}

/// (2α − 1)/α² · 3/(2π²): the limit of (‖w‖₀/|w|\_{1/2})² / L for the functions [`truncated_logarithm`] with
/// α > 1/2, largest at α = 1, where it is that of γ². In t = |ln x| the seminorm is (2π²/3) ∫ ψ'(t)² dt to
/// leading order, ψ = (t/L)^α.
pub fn truncated_slope(alpha: f64) -> f64 {
    (2.0 * alpha - 1.0) / (alpha * alpha) * END_SLOPE
}

impl TruncatedFamily {
    /// The functions for the given (L, constant of the zone).
    ///
    /// # Errors
    /// Those of [`truncated_logarithm`] and of [`growth`].
    pub fn new(alpha: f64, constants: &[(f64, Estimate)], tolerance: impl Given<Tolerance>) -> Result<Self> {
        let tolerance = tolerance.given()?;
        // ‖|ln x|^α‖₀² = Γ(1 + 2α)
        let full = if alpha < 0.5 {
            let square = closed_forms::log_power_seminorm_squared(alpha)?.value;
            Some((square.sqrt(), (square + libm::tgamma(1.0 + 2.0 * alpha)).sqrt()))
        } else {
            None
        };
        let (mut quotients, mut shares, mut chain) = (Vec::new(), Vec::new(), Vec::new());
        for &(log, gamma) in constants {
            let w = truncated_logarithm(alpha, log)?;
            let seminorm = w.seminorm(Order::HALF, tolerance)?;
            let norm = w.norm(0.0, Tolerance::reference())?;
            let quotient = norm.over(seminorm)?;
            if let Some((seminorm_of_u, norm_of_u)) = full {
                let n = log.powf(alpha) / norm_of_u;
                chain.push(NormChain {
                    truncation: seminorm.value * log.powf(alpha) / seminorm_of_u,
                    repaired: n * seminorm.value,
                    printed: n * norm.value.hypot(seminorm.value),
                });
            }
            shares.push(quotient.over(gamma)?);
            quotients.push((log, quotient));
        }
        let by_zone: Vec<_> = quotients.iter().map(|&(log, quotient)| ((-log).exp(), quotient)).collect();
        let slope = growth(Order::HALF, &by_zone)?;
        Ok(Self { alpha, growth: last_exponent(&quotients)?, slope, quotients, shares, chain })
    }
}

/// ‖u‖₀ / |u|_ν: a lower bound of the constant of any condition that u satisfies.
///
/// # Errors
/// Those of [`Function::seminorm`]; [`Error::NotFinite`] for a constant.
pub fn trial_quotient(
    u: &Function<'_>,
    order: impl Given<Order>,
    tolerance: impl Given<Tolerance>,
) -> Result<Estimate> {
    let (order, tolerance) = (order.given()?, tolerance.given()?);
    u.norm(0.0, Tolerance::reference())?.over(u.seminorm(order, tolerance)?)
}

/// ‖u − m‖₀ / |u|_ν, m the mean of u over the elements up to θ, a node of its partition of (0,1): a lower
/// bound of γ_θ.
///
/// ```
/// use experiments::trial::{cut_in_two, mean_free_quotient, trial_quotient};
/// use fractional_sobolev::{Function, Mesh, Order, Tolerance};
/// let (order, asked) = (Order::HALF, Tolerance::fast());
/// // u = x: ‖x‖₀ = 1/√3, ‖x − 1/4‖₀ = (7/48)^{1/2}, |x|_{1/2} = 1
/// let u = Function::linears(&Mesh::uniform(2, 1.0)?, &[0.0, 0.5, 1.0])?;
/// assert!((trial_quotient(&u, order, asked)?.value - 1.0 / 3f64.sqrt()).abs() < 1e-4);
/// assert!((mean_free_quotient(&u, 0.5, order, asked)?.value - (7.0f64 / 48.0).sqrt()).abs() < 1e-4);
/// // two halves: each has |u|² = 1/4 and length 1/2
/// let cut = cut_in_two(&u, 1, order, asked)?;
/// assert!((cut.right.value - 0.5).abs() < 1e-4);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// As [`trial_quotient`]; [`Error::OutOfRange`] when θ is no node.
pub fn mean_free_quotient(
    u: &Function<'_>,
    theta: f64,
    order: impl Given<Order>,
    tolerance: impl Given<Tolerance>,
) -> Result<Estimate> {
    let (order, tolerance) = (order.given()?, tolerance.given()?);
    let near = |x: f64| (x - theta).abs() <= ONE_NODE * theta;
    let node = u.mesh()?.nodes().iter().position(|&x| near(x)).filter(|&k| k > 0);
    let elements = node.ok_or(Error::OutOfRange { name: "theta", value: theta, range: "the nodes" })?;
    let (zone, whole) =
        (u.restrict(0..elements)?.mean(Tolerance::reference())?, u.mean(Tolerance::reference())?);
    // ‖u − m‖₀² = ‖u − mean u‖₀² + (mean u − m)²
    let norm = u.norm(0.0, Tolerance::reference())?;
    let centred = (norm.value * norm.value - whole.value * whole.value).max(0.0);
    let square = centred + (whole.value - zone.value).powi(2);
    let error = 2.0 * (norm.value * norm.error + whole.value.abs() * whole.error)
        + 2.0 * (whole.value - zone.value).abs() * (whole.error + zone.error);
    Estimate::new(square, error, norm.work)?.sqrt()?.over(u.seminorm(order, tolerance)?)
}

/// Both sides of a bound, with errors.
///
/// Returned by [`cut_in_two`].
///
/// ```
/// use experiments::trial::{BothSides, cut_in_two};
/// use fractional_sobolev::{Function, Mesh};
/// // sgn(x − 1/2) cut at its jump: no constant bounds the left side by the right one
/// let sign = Function::piecewise(&Mesh::uniform(2, 1.0)?, 0, &[-1.0, 1.0])?;
/// let BothSides { left, right } = cut_in_two(&sign, 1, 0.25, 1e-8)?;
/// assert!((left.value - 1.0).abs() < 1e-14 && right.value == 0.0);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BothSides {
    /// What is bounded.
    pub left: Estimate,
    /// What bounds it, without its constant.
    pub right: Estimate,
}

/// Remark 7 cuts the interval after the first `elements` of the partition of u: ‖u‖₀ and
/// (Σ_k |I_k|^{2ν} |u|²_{ν,I_k})^{1/2} over the two pieces, which the printed step compares.
///
/// # Errors
/// Those of [`Function::restrict`] and [`Function::seminorm`].
pub fn cut_in_two(
    u: &Function<'_>,
    elements: usize,
    order: impl Given<Order>,
    tolerance: impl Given<Tolerance>,
) -> Result<BothSides> {
    let (order, tolerance) = (order.given()?, tolerance.given()?);
    let (mut square, mut error) = (0.0, 0.0);
    let left = u.norm(0.0, Tolerance::reference())?;
    for range in [0..elements, elements..u.mesh()?.len()] {
        let piece = u.restrict(range)?;
        let seminorm = piece.seminorm(order, tolerance)?;
        let scale = piece.mesh()?.total().powf(2.0 * order.value());
        square += scale * seminorm.value * seminorm.value;
        error += 2.0 * scale * seminorm.value * seminorm.error;
    }
    Ok(BothSides { left, right: Estimate::new(square, error, left.work)?.sqrt()? })
}

/// Lemma 5.1 for the spaces of Lemma 5.2: α = (1 + γ²)^{−1/2}, the largest with α (‖u‖₀² + |u|_ν²)^{1/2} ≤
/// |u|_ν. With the quotient of one function in place of γ, |u|_ν over that norm.
///
/// # Errors
/// [`Error::NotFinite`] never for an estimate that was made by [`Estimate::new`].
pub fn peetre_tartar(gamma: Estimate) -> Result<Estimate> {
    let alpha = 1.0 / gamma.value.hypot(1.0);
    Estimate::new(alpha, alpha.powi(3) * gamma.value.abs() * gamma.error, gamma.work)
}
