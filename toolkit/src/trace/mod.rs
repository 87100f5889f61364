//! The trace theorem with an explicit constant: |w|\_{s−1/2, edge} ≤ C |w|\_{s,Ω}, 1/2 < s ≤ 1.

mod angular_kernel;
mod half_line;
mod half_plane;
mod wedge;
mod wedge_elements;

pub(crate) use half_line::HalfLineSymbol;

use crate::constant::{BestConstant, Domain, UnitOrder};
use crate::error::{Error, Given, Result};
use crate::estimate::{Estimate, Tolerance, Work};
use crate::order::SobolevOrder;
use half_plane::{extension_profile, half_plane_trace};
use std::f64::consts::TAU;
use wedge::{WedgeTrace, quotient_at_one};

/// Modes for which the quotient of a corner is computed first.
const MODES: [f64; 8] = [0.0, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0];
/// Golden ratio, and the number of steps of golden-section search that reduce an interval to 1e-4: 1e-8 of the
/// value.
const GOLDEN: f64 = 0.618_033_988_749_894_9;
const STEPS: usize = 20;
/// Value of y beyond which the profile of the half-plane is below 1e-300.
const FAR: f64 = 690.0;

/// The best constant in |w|\_{s−1/2, edge} ≤ C |w|\_{s,Ω}, 1/2 < s ≤ 1, on a half-plane, a sector or a square.
///
/// |w|²_{s,Ω} = ∫_Ω∫_Ω (w(x)−w(y))² / |x−y|^{2+2s} dx dy and, for s = 1, ‖∇w‖²; the edge has the same double
/// integral with |x−y|^{-2s}. Both scale like l^{1−s}, so that C is invariant under scaling.
///
/// # Method
///
/// **Half-plane.** C(s)² = 4s² / ((2s−1) D(s)), D(s) = −π cot(πs) − ψ(2s) − γ, ψ = Γ'/Γ, γ Euler's constant; C(1)² =
/// 2π. Limits: C(s)² (2s−1)² → 3/π² as s → 1/2; π/(2(1−s)) C(s)² → 2π as s → 1. No edge of a domain has a smaller
/// constant. The extremal function (per period) is cos(x) φ(y), φ(y) = 2^{1−σ}/Γ(σ) y^σ K_σ(y), σ = s − 1/2,
/// K_σ the modified Bessel function.
///
/// **Corner.** C is the supremum over μ ≥ 0 of the constant of the mode r^{s−1+iμ}, [`trace_constant_of_mode`], which
/// tends to that of the half-plane as μ → ∞. The larger of the latter and the largest constant found for μ ≤ 16 is
/// returned: a lower bound up to the error of the finite elements; `upper` is `None`.
///
/// **Square.** C(s) of the half-plane: proved to be the best constant for s = 1, and proved to be a lower bound for s
/// < 1, where no function with a larger quotient is known and `upper` is `None`.
///
/// ```
/// use fractional_sobolev::{Domain, Order, trace_constant};
/// let near = trace_constant(Domain::HalfPlane, Order::half_plus(1e-9)?, 1e-8)?.constant;
/// assert!((near.value * 2e-9 - 3f64.sqrt() / std::f64::consts::PI).abs() < 1e-8);
/// let [half_plane, right, acute] = [Domain::HalfPlane, Domain::Corner(1.571), Domain::Corner(0.5)]
///     .map(|domain| trace_constant(domain, 0.75, 1e-4).map(|found| found.constant.value));
/// assert!(half_plane == right && acute? > half_plane?); // a right angle does not increase C, an acute one does
/// assert_eq!(trace_constant(Domain::Square, 1.0, 1e-8)?.constant.value, std::f64::consts::TAU.sqrt());
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// [`Error::OutOfRange`] for s ≤ 1/2, where functions have no trace, for s > 1, and for a corner unless its
/// angle is in [0.1, π]; [`Error::Incompatible`] for another domain; [`Error::ToleranceNotMet`].
#[doc(alias("trace theorem", "trace constant"))]
pub fn trace_constant(
    domain: Domain,
    s: impl Given<SobolevOrder>,
    tolerance: impl Given<Tolerance>,
) -> Result<BestConstant> {
    let (s, tolerance) = (UnitOrder::new(s.given()?)?, tolerance.given()?);
    let flat = half_plane(s)?;
    let found = match domain {
        Domain::HalfPlane => with_profile(BestConstant::exact(flat), s),
        Domain::Square if s == UnitOrder::One => BestConstant::exact(flat),
        Domain::Square => BestConstant::new(flat, flat, None),
        Domain::Corner(angle) => {
            let largest = largest_mode(angle, s)?.sqrt()?;
            let constant = if largest.value > flat.value { largest } else { flat };
            BestConstant::new(constant, constant, None)
        }
        _ => return Err(domain.refused("trace", "HalfPlane, Corner or Square")),
    };
    found.met(
        "trace constant",
        tolerance,
        "rounding, and the fixed degree of the finite elements, limit the accuracy",
    )
}

/// The best constant in |f|\_{s−1/2} ≤ C |w|_s for the boundary values f = r^{s−1+iμ} of a corner of angle ω or, even
/// in x, of the half-plane, and all their extensions w, 1/2 < s ≤ 1, 0 ≤ μ ≤ 100: a lower bound of [`trace_constant`].
///
/// # Method
///
/// For w = r^{s−1+iμ} ψ(θ), ψ(0) = 1, and s < 1 the square of the constant is C(μ)/min E_μ. Per unit of ln r the squared seminorm
/// is C(μ), the Mellin symbol of the half line, on the edge and E_μ(ψ) on the wedge, where u runs over ℝ and
/// ψ' = ψ(θ'):
///
/// ```text
/// E_μ(ψ) = ∫₀^ω∫₀^ω (ψ−ψ')² K_μ(θ−θ') + (ψ²+ψ'²) D_μ(θ−θ') dθ dθ',
/// K_μ(a) = ∫ cos(μu) (2 cosh u − 2 cos a)^{−1−s} du,
/// D_μ(a) = ∫ (cosh((1−s)u) − cos(μu)) (2 cosh u − 2 cos a)^{−1−s} du.
/// ```
///
/// The minimum over ψ is approximated from above by finite elements: up to quadrature the value is a lower
/// bound of it. The half-plane is ω = π with an axis of symmetry at π/2; there it equals
/// the closed form for *every* μ, as two independent computations confirm. For s = 1 the square of a corner
/// is 2(πμ coth(πμ) − 1)/(μ tanh(ωμ)). Cost: 1e6 operations.
///
/// ```
/// use fractional_sobolev::{Domain, trace_constant, trace_constant_of_mode};
/// let best = trace_constant(Domain::HalfPlane, 0.75, 1e-8)?.constant.value;
/// let flat = trace_constant_of_mode(Domain::HalfPlane, 0.75, 2.0, 1e-4)?.constant;
/// assert!((flat.value - best).abs() <= flat.error);
/// let right = Domain::Corner(std::f64::consts::FRAC_PI_2);
/// assert!(trace_constant_of_mode(right, 0.75, 1.0, 1e-4)?.constant.value < 0.84 * best);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// [`Error::OutOfRange`] outside these ranges and unless 0.1 ≤ ω ≤ π; [`Error::Incompatible`] for another domain;
/// [`Error::ToleranceNotMet`].
pub fn trace_constant_of_mode(
    domain: Domain,
    s: impl Given<SobolevOrder>,
    mu: f64,
    tolerance: impl Given<Tolerance>,
) -> Result<BestConstant> {
    let (s, tolerance) = (UnitOrder::new(s.given()?)?, tolerance.given()?);
    let found = match (&domain, s) {
        (Domain::Corner(angle), _) => mode(*angle, s, mu)?.sqrt()?,
        (Domain::HalfPlane, UnitOrder::Inner(order)) => {
            WedgeTrace::half_plane(order)?.quotient(mu)?.sqrt()?
        }
        (Domain::HalfPlane, _) => {
            Error::require("mu", mu, "[0, 100]", (0.0..=100.0).contains(&mu))?;
            half_plane(s)?
        }
        _ => return Err(domain.refused("modes of the trace", "HalfPlane or Corner")),
    };
    BestConstant::new(found, found, None).met(
        "trace constant of a mode",
        tolerance,
        "the fixed degree of the finite elements limits the accuracy",
    )
}

/// The constant C(s) of the half-plane.
fn half_plane(s: UnitOrder) -> Result<Estimate> {
    match s {
        UnitOrder::Inner(order) => half_plane_trace(order),
        UnitOrder::One => Estimate::new(TAU.sqrt(), 0.0, Work::default()),
        UnitOrder::Zero => Err(Error::OutOfRange { name: "s", value: 0.0, range: "(1/2, 1]" }),
    }
}

/// The constant with the extremal function cos(x) φ(y).
fn with_profile(found: BestConstant, s: UnitOrder) -> BestConstant {
    let profile = move |y: f64| match s {
        UnitOrder::Inner(order) if y < FAR => extension_profile(order, y).unwrap_or(f64::NAN),
        _ if y >= 0.0 => (-y).exp(),
        _ => f64::NAN,
    };
    found.with_extremal(move |point| {
        point.first_chunk().map_or(f64::NAN, |&[x, y]| x.cos() * profile(y))
    })
}

/// The quotient of one mode of a corner.
fn mode(angle: f64, s: UnitOrder, tau: f64) -> Result<Estimate> {
    match s {
        UnitOrder::Inner(order) => WedgeTrace::corner(order, angle)?.quotient(tau),
        _ => {
            let value = quotient_at_one(angle, tau)?;
            Estimate::new(value, 1e-12 * value, Work::default())
        }
    }
}

/// The largest quotient of the modes of a corner.
fn largest_mode(angle: f64, s: UnitOrder) -> Result<Estimate> {
    let coarse = MODES.iter().map(|&tau| mode(angle, s, tau)).collect::<Result<Vec<_>>>()?;
    let at =
        (0..MODES.len()).max_by(|&i, &j| coarse[i].value.total_cmp(&coarse[j].value)).unwrap_or(0);
    let work = coarse.iter().fold(Work::default(), |work, found| work + found.work);
    let mut best = Estimate::new(coarse[at].value, coarse[at].error, work)?;
    // At τ = 0 the quotient is even; a maximum at the last mode is that of τ → ∞.
    if at + 1 == MODES.len() {
        return Ok(best);
    }
    let (mut low, mut high) = (MODES[at.saturating_sub(1)], MODES[at + 1]);
    for _ in 0..STEPS {
        let [a, b] = [high - GOLDEN * (high - low), low + GOLDEN * (high - low)];
        let (left, right) = (mode(angle, s, a)?, mode(angle, s, b)?);
        for found in [left, right] {
            if found.value > best.value {
                best = Estimate::new(found.value, found.error, best.work + found.work)?;
            }
        }
        if left.value >= right.value { high = b } else { low = a }
    }
    Ok(best)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn a_corner_has_the_largest_of_its_modes_and_of_the_half_plane() {
        let of = |domain, s| trace_constant(domain, s, 1e-4).unwrap().constant.value;
        for s in [0.6, 0.9] {
            assert_eq!(of(Domain::Corner(0.5 * PI), s), of(Domain::HalfPlane, s), "{s}");
            let acute = trace_constant_of_mode(Domain::Corner(PI / 6.0), s, 0.0, 1e-4).unwrap();
            let best = of(Domain::Corner(PI / 6.0), s);
            assert!((best / acute.constant.value - 1.0).abs() < 1e-9, "{s}");
        }
        // s = 1: 2π²/(3ω) at τ = 0 where the angle is acute
        let exact = (2.0 * PI * PI / 1.5).sqrt();
        assert!((of(Domain::Corner(0.5), 1.0) / exact - 1.0).abs() < 1e-9);
        assert_eq!(of(Domain::Corner(2.0), 1.0), TAU.sqrt());
    }

    #[test]
    fn orders_and_domains_without_a_trace_are_errors() {
        for s in [0.0, 0.3, 0.5, 1.5, f64::NAN] {
            assert!(trace_constant(Domain::HalfPlane, s, 1e-4).is_err(), "{s}");
        }
        assert!(trace_constant(Domain::Interval(1.0), 0.75, 1e-4).is_err());
        assert!(trace_constant(Domain::Corner(0.01), 0.75, 1e-4).is_err());
        assert!(trace_constant_of_mode(Domain::Square, 0.75, 0.0, 1e-4).is_err());
        for s in [0.75, 1.0] {
            assert!(trace_constant_of_mode(Domain::HalfPlane, s, 1e4, 1e-4).is_err(), "{s}");
        }
        assert!(matches!(
            trace_constant(Domain::Corner(0.5), 0.75, 1e-14),
            Err(Error::ToleranceNotMet { .. })
        ));
    }
}
