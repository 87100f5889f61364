//! (6.2): |v(x) − v̄| ≤ h^{1/2} ‖v'‖₀, its best constant at every point.

use signorini::interpolation::limits::pointwise;
use signorini::quadrature::Rule;

/// Gauss rules integrate the polynomials below exactly.
const ROUNDING: f64 = 1e-14;

#[test]
fn the_extremal_parabolas_attain_the_constant() {
    // v' = s for s < x, s − 1 for s > x on (0, 1): v(x) − v̄ = ∫ k v' with k = v', so the quotient is ‖k‖.
    let rule = Rule::gauss_legendre(4).unwrap();
    for x in [0.0, 0.1, 0.5, 0.8, 1.0] {
        let square =
            x * rule.integrate(|t| (x * t).powi(2)) + (1.0 - x) * rule.integrate(|t| ((1.0 - x) * t).powi(2));
        let v = |s: f64| {
            if s <= x { 0.5 * s * s } else { 0.5 * x * x + 0.5 * ((1.0 - s).powi(2) - (1.0 - x).powi(2)) }
        };
        let mean = x * rule.integrate(|t| v(x * t)) + (1.0 - x) * rule.integrate(|t| v(x + (1.0 - x) * t));
        let quotient = (v(x) - mean) / square.sqrt();
        let best = pointwise(x).unwrap().value;
        assert!((quotient - best).abs() < ROUNDING, "{x}: {quotient} {best}");
    }
}

#[test]
fn the_printed_constant_is_loose_by_the_root_of_three_at_least() {
    for k in 0..=100 {
        let best = pointwise(f64::from(k) / 100.0).unwrap().value;
        assert!(best <= 1.0 / 3f64.sqrt() + ROUNDING && best >= 0.5 / 3f64.sqrt() - ROUNDING);
    }
    assert!((pointwise(0.0).unwrap().value - 1.0 / 3f64.sqrt()).abs() < ROUNDING);
    for bad in [-0.1, 1.1, f64::NAN] {
        assert!(pointwise(bad).is_err());
    }
}
