//! Sharp constants of one contact segment, T = (0, 1), over all contact sets E; e = |E|, n = 1 − e.
//!
//! σ = σ_N is supported on E, w = u_N' on N = T \ E, ν = τ − 3/2, |·|_ν is the seminorm (1.1).
//!
//! | constant | of | value |
//! | --- | --- | --- |
//! | c(ν), [`product_bound`] | ‖σ‖_{L¹} ‖w‖_{L¹} ≤ c \|σ\| \|w\|, by potentials | ν / (2 (4^ν − 1)) |
//! | K(ν), [`product_constant`] | the same, best constant | max_e B(e) B(1−e) |
//! | κ(ν), [`consistency_constant`] | ∫ σ (I^h u), one gap at an end | max_e A(e) B(1−e) |
//! | κ̄(ν), [`midpoint_bound`] | midpoint cone, every E | max_e B(e) D(1−e) |
//!
//! B, A, D are the best constants M in ∫ m w ≤ M |w|_ν for the functions w that vanish outside (0, e), with the
//! weights m = 1, x and e − x, x the distance from the free end: [`fractional_sobolev::moment`].
//!
//! **c.** For x in N, ∫_E |x−y|^{−1−2ν} dy is smallest when E is as far from x as possible: it is at least ∫_n^1
//! t^{−1−2ν} dt = e G(n), G(s) the mean of t^{−1−2ν} over (s, 1). Hence 2 e G(n) ‖w‖² ≤ |w|², 2 n G(e) ‖σ‖² ≤ |σ|²,
//! and ‖σ‖_{L¹} ‖w‖_{L¹} ≤ √(en) ‖σ‖ ‖w‖ ≤ ½ (G(e) G(n))^{−1/2} |σ| |w|. The mean of t^{−1−2ν} over (s, 1) is that of
//! (1−θ+θs)^{−1−2ν} over 0 < θ < 1; each of these is log-convex in s, hence so is G, and G(e) G(1−e) has its minimum
//! ((4^ν − 1)/ν)² at e = 1/2.
//!
//! **K.** |·|_ν does not increase when |σ|, |w| are replaced by their monotone rearrangements, and ‖·‖_{L¹} is
//! preserved: E = (0, e), N = (e, 1) is the worst of all sets of measure e.
//!
//! **κ.** For one non-contact interval (0, b) the nodal term is u(0) ∫ σ (1−x), u(0) = −∫ w, and the midpoint term
//! ∫_N u ∫ σ, ∫_N u = −∫ x w: each is a product of two moments, A(1−b) B(b) and A(b) B(1−b), with the same maximum.
//!
//! **κ̄.** On an interior non-contact interval ∫ w = 0, so ∫_N |u| ≤ ∫ ρ |w| with ρ the distance from the midpoint of
//! the interval, or from the free end of an interval at an end of T. |{ρ > s}| = Σ (a − s)_+ + Σ
//! (l − 2s)_+ ≤ (n − s)_+, and by rearrangement ∫ ρ |w| ≤ D(n) |w|.
//!
//! As ν → 1: K/(1−ν) → 1/24 at e = 1/2 and κ/(1−ν) → (5⁵ 3³ / (60·8⁸))^{1/2} at e = 5/8.

use crate::cone::Cone;
use crate::error::{Error, Result, ToolkitError};
use crate::numeric::search::golden_section;
use fractional_sobolev::{BestConstant, Estimate, Given, Moment, Order, Tolerance, Work, moment};

/// A constant, with the measure of the contact set at which it is attained.
///
/// ```
/// use fractional_sobolev::{Order, Tolerance};
/// use signorini::proof::product_constant;
/// // with bounds by an independent computation, for the contact set found
/// let sharp = product_constant(Order::HALF, Tolerance::fast())?.best.bounded()?;
/// let (value, upper) = (sharp.constant, sharp.upper.map_or(f64::NAN, |upper| upper.value));
/// assert!(sharp.lower.value <= value.value + value.error && value.value - value.error <= upper);
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct SegmentConstant {
    /// The constant, as the product of the moments on the contact set and on its complement, with the products of their
    /// bounds ([`BestConstant::bounded`]).
    pub best: BestConstant,
    /// The measure |E| of the contact set, accurate to about 1e-6.
    pub contact: f64,
}

/// The constant c(ν) = ν/(2 (4^ν − 1)) in ‖σ‖_{L¹} ‖w‖_{L¹} ≤ c |σ|_ν |w|_ν for functions on (0, 1) with
/// disjoint supports: c → 1/(4 ln 2) as ν → 0, c(1/2) = 1/4, c → 1/6 as ν → 1.
///
/// ```
/// use fractional_sobolev::Order;
/// use signorini::proof::product_bound;
/// assert!((product_bound(Order::HALF) - 0.25).abs() < 1e-15);
/// assert!((product_bound(Order::new(1e-9)?) - 0.25 / std::f64::consts::LN_2).abs() < 1e-8);
/// # Ok::<(), signorini::Error>(())
/// ```
pub fn product_bound(order: Order) -> f64 {
    0.5 * order.value() / (2.0 * std::f64::consts::LN_2 * order.value()).exp_m1()
}

/// The best constant K(ν) in ‖σ‖_{L¹} ‖w‖_{L¹} ≤ K |σ|_ν |w|_ν for functions on (0, 1) with disjoint
/// supports.
///
/// ```
/// use fractional_sobolev::{Order, Tolerance};
/// use signorini::proof::{product_bound, product_constant};
/// let sharp = product_constant(Order::HALF, Tolerance::fast())?.best.constant;
/// assert!(sharp.value < product_bound(Order::HALF));
/// # Ok::<(), signorini::Error>(())
/// ```
///
/// # Errors
/// [`ToolkitError::ToleranceNotMet`](crate::ToolkitError::ToleranceNotMet), as for [`moment`].
pub fn product_constant(
    order: impl Given<Order>,
    tolerance: impl Given<Tolerance>,
) -> Result<SegmentConstant> {
    largest_product(order.given()?, Moment::Mass, Moment::Mass, tolerance.given()?)
}

/// The best constant κ(ν) of the consistency term of either cone over the contact sets with one non-contact interval,
/// at an end.
///
/// κ(ν) = max_e A(e) B(1−e) ≤ K(ν) ≤ c(ν); A(e) and B(e) are the suprema of ∫ x f and ∫ f over |f|_ν = 1, f = 0
/// outside (0, e).
///
/// ```
/// use fractional_sobolev::{Order, Tolerance};
/// use signorini::proof::{consistency_constant, product_constant};
/// let kappa = consistency_constant(Order::HALF, Tolerance::fast())?;
/// let product = product_constant(Order::HALF, Tolerance::fast())?;
/// assert!(kappa.best.constant.value < product.best.constant.value && kappa.contact > 0.0 && kappa.contact < 1.0);
/// # Ok::<(), signorini::Error>(())
/// ```
///
/// # Errors
/// As for [`product_constant`].
pub fn consistency_constant(
    order: impl Given<Order>,
    tolerance: impl Given<Tolerance>,
) -> Result<SegmentConstant> {
    largest_product(order.given()?, Moment::FromFreeEnd, Moment::Mass, tolerance.given()?)
}

/// The constant κ̄(ν): the consistency term of the midpoint cone on a segment of length h is at most
/// κ̄ h^{2ν+1} |σ_N|_ν |u_N'|_ν for every contact set.
///
/// κ̄(ν) = max_e B(e) D(1−e) ≥ κ(ν), since sets with one non-contact interval at an end are included; B as in
/// [`consistency_constant`], D(e) the supremum of ∫ (e − x) f over the same functions.
///
/// ```
/// use fractional_sobolev::{Order, Tolerance};
/// use signorini::proof::{consistency_constant, midpoint_bound};
/// let every = midpoint_bound(Order::HALF, Tolerance::fast())?.best.constant;
/// let one_gap = consistency_constant(Order::HALF, Tolerance::fast())?.best.constant;
/// assert!(one_gap.value <= every.value + every.error + one_gap.error);
/// # Ok::<(), signorini::Error>(())
/// ```
///
/// # Errors
/// As for [`product_constant`].
pub fn midpoint_bound(
    order: impl Given<Order>,
    tolerance: impl Given<Tolerance>,
) -> Result<SegmentConstant> {
    largest_product(order.given()?, Moment::Mass, Moment::FromZone, tolerance.given()?)
}

/// The best constant of the consistency term for one non-contact interval of length b = `gap` at an end: A(1−b) B(b)
/// for the nodal cone, A(b) B(1−b) for the midpoint cone, A and B as in [`consistency_constant`].
///
/// ```
/// use fractional_sobolev::{Order, Tolerance};
/// use signorini::{cone::Cone, proof::one_gap_ratio};
/// let ratio = |cone, gap| one_gap_ratio(cone, Order::HALF, gap, Tolerance::fast());
/// let (nodal, midpoint) = (ratio(Cone::Nodal, 0.3)?, ratio(Cone::Midpoint, 0.7)?);
/// assert!((nodal.value - midpoint.value).abs() <= nodal.error + midpoint.error);
/// # Ok::<(), signorini::Error>(())
/// ```
///
/// # Errors
/// [`ToolkitError::OutOfRange`](crate::ToolkitError::OutOfRange) unless 1e-300 ≤ gap ≤ 1 − 1e-15; as for
/// [`product_constant`].
pub fn one_gap_ratio(
    cone: Cone,
    order: impl Given<Order>,
    gap: f64,
    tolerance: impl Given<Tolerance>,
) -> Result<Estimate> {
    let (order, tolerance) = (order.given()?, tolerance.given()?);
    let moments = match cone {
        Cone::Nodal => (Moment::Mass, Moment::FromFreeEnd),
        Cone::Midpoint => (Moment::FromFreeEnd, Moment::Mass),
    };
    Ok(product(order, moments, gap, tolerance)?.constant)
}

/// The ratio for one contact set: the product of the moments of functions on both parts, of length 1 − `length` and
/// `length`.
fn product(
    order: Order,
    moments: (Moment, Moment),
    length: f64,
    tolerance: Tolerance,
) -> Result<BestConstant> {
    let first = moment(order, length..1.0, moments.0, tolerance);
    let second = moment(order, 0.0..length, moments.1, tolerance);
    if let (Ok(first), Ok(second)) = (&first, &second) {
        return Ok(first.product(second)?);
    }
    // A refused moment carries its own best value; that of the product is the product.
    let first = Estimate::or_best(first.map(|found| found.constant))?;
    let second = Estimate::or_best(second.map(|found| found.constant))?;
    let best = first.product(second)?;
    Err(Error::not_met("ratio of one gap", tolerance.relative(), best, "a moment does not meet it"))
}

/// The refusal of a maximum over the gap: the value for one gap is not its best value.
fn without_value(error: Error) -> Error {
    match error {
        Error::Toolkit(ToolkitError::ToleranceNotMet { asked, reached, why, .. }) => {
            Error::out_of_reach("largest product of moments", asked, reached, why)
        }
        other => other,
    }
}

/// The search interval of the maximum, the width of the golden-section search, and the half width of the
/// polynomial that refines it.
const RANGE: (f64, f64) = (0.1, 0.95);
const COARSE_WIDTH: f64 = 0.004;
const STEP: f64 = 0.01;

/// The largest product over e: golden-section search at low accuracy, then the maximum of the polynomial through five
/// values of full accuracy. The maximiser is accurate to 1e-6 and the value, stationary there, to 1e-11.
fn largest_product(
    order: Order,
    first: Moment,
    second: Moment,
    tolerance: Tolerance,
) -> Result<SegmentConstant> {
    let moments = (first, second);
    let mut failure = None;
    let rough = golden_section(RANGE.0, RANGE.1, COARSE_WIDTH, |e| {
        product(order, moments, e, Tolerance::fast()).map_or_else(
            |error| {
                failure = Some(error);
                0.0
            },
            |found| -found.constant.value,
        )
    });
    if let Some(error) = failure {
        return Err(without_value(error));
    }
    let sharper = Tolerance::new((0.25 * tolerance.relative()).max(1e-15))?;
    let exact = |e: f64| product(order, moments, e, sharper).map_err(without_value);
    let mut values = [0.0; 5];
    let mut work = Work::default();
    for (k, value) in values.iter_mut().enumerate() {
        let found = exact(rough + STEP * (k as f64 - 2.0))?.constant;
        *value = found.value;
        work += found.work;
    }
    let contact = rough + STEP * stationary(&values);
    let mut best = exact(contact)?;
    best.constant.work += work;
    Ok(SegmentConstant { best, contact })
}

/// The stationary point near 0 of the polynomial through the values at −2 ... 2, by Newton's method.
fn stationary(values: &[f64; 5]) -> f64 {
    let [a, b, c, d, e] = *values;
    // Derivatives at 0 of the quartic.
    let first = (a - 8.0 * b + 8.0 * d - e) / 12.0;
    let second = (-a + 16.0 * b - 30.0 * c + 16.0 * d - e) / 12.0;
    let third = 0.5 * (-a + 2.0 * b - 2.0 * d + e);
    let fourth = a - 4.0 * b + 6.0 * c - 4.0 * d + e;
    let mut x = 0.0;
    for _ in 0..20 {
        let slope = first + x * (second + x * (0.5 * third + x * fourth / 6.0));
        let curvature = second + x * (third + 0.5 * x * fourth);
        x = (x - slope / curvature).clamp(-2.0, 2.0);
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;

    const ASKED: f64 = 1e-9;

    #[test]
    fn the_potentials_weigh_most_at_one_half() {
        for k in 1..=200 {
            let nu = f64::from(k) / 201.0;
            let order = Order::new(nu).unwrap();
            let g = |s: f64| (-2.0 * nu * (-s).ln_1p()).exp_m1() / (2.0 * nu);
            let of = |e: f64| 0.5 * (e * (1.0 - e) / (g(e) * g(1.0 - e))).sqrt();
            assert!((of(0.5) / product_bound(order) - 1.0).abs() < 1e-13, "{nu}");
            let values: Vec<f64> = (1..2000).map(|j| of(f64::from(j) / 2000.0)).collect();
            assert!(
                values[..1000].windows(2).all(|pair| pair[0] < pair[1] * (1.0 + 1e-14)),
                "{nu}"
            );
            assert!(values[999..].windows(2).all(|pair| pair[1] < pair[0] * (1.0 + 1e-14)), "{nu}");
        }
    }

    #[test]
    fn a_quartic_has_its_maximum_found() {
        let f = |x: f64| 3.0 - (x - 0.4).powi(2) - 0.1 * (x - 0.4).powi(4);
        let place = stationary(&[-2.0, -1.0, 0.0, 1.0, 2.0].map(f));
        assert!((place - 0.4).abs() < 1e-12, "{place}");
    }

    #[test]
    fn the_maximum_found_is_that_of_a_grid() {
        for nu in [0.01, 0.5, 0.95] {
            let order = Order::new(nu).unwrap();
            let kappa = consistency_constant(order, ASKED).unwrap();
            let largest = product_constant(order, ASKED).unwrap().best.constant;
            for k in 1..40 {
                let gap = f64::from(k) / 40.0;
                let ratio = one_gap_ratio(Cone::Nodal, order, gap, Tolerance::fast()).unwrap();
                assert!(
                    ratio.value - ratio.error <= kappa.best.constant.value,
                    "{nu} {gap}: {ratio} {kappa:?}"
                );
                let masses = (Moment::Mass, Moment::Mass);
                let k = product(order, masses, gap, Tolerance::fast()).unwrap().constant;
                assert!(k.value - k.error <= largest.value, "{nu} {gap}: {k} {largest}");
            }
        }
    }
}
