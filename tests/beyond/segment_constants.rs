//! The sharp constants of a segment: two independent computations, limits, and other contact sets.

use fractional_sobolev::{Order, Tolerance};
use signorini::cone::Cone;
use signorini::proof::{
    consistency_constant, midpoint_bound, one_gap_ratio, product_bound, product_constant,
};

/// K(1/2), the square of the moment of a half interval in closed form, computed with forty digits (the test
/// `half_order_moments` of the toolkit has the formula).
const HALF_ORDER_PRODUCT: f64 = 0.051_868_428_388_348_91;

fn order(nu: f64) -> Order {
    Order::new(nu).unwrap()
}

#[test]
fn the_constants_are_known_by_two_computations() {
    for nu in [0.001, 0.1, 0.25, 0.5, 0.75, 0.9, 0.999] {
        let nu = order(nu);
        let tolerance = Tolerance::new(1e-9).unwrap();
        let [product, kappa, midpoint] = [product_constant, consistency_constant, midpoint_bound]
            .map(|of| of(nu, tolerance).unwrap());
        for found in [&product, &kappa, &midpoint] {
            let bounded = found.best.bounded().unwrap();
            let (value, error) = (bounded.constant.value, bounded.constant.error);
            let (lower, upper) = (bounded.lower.value, bounded.upper.unwrap().value);
            let apart = (upper - value).abs().max((value - lower).abs()) + error;
            assert!(apart < 1e-8 * value, "{nu}: {bounded:?}");
        }
        assert!((product.contact - 0.5).abs() < 1e-4, "{nu}: {product:?}");
        let [product, kappa, midpoint] =
            [product, kappa, midpoint].map(|found| found.best.constant.value);
        assert!(kappa < midpoint && midpoint < product && product < product_bound(nu), "{nu}");
        assert!(kappa < 0.5 * 0.136, "{nu}: {kappa}");
        if nu == Order::HALF {
            assert!((product / HALF_ORDER_PRODUCT - 1.0).abs() < 1e-8, "{product}");
        }
    }
}

#[test]
fn constants_fall_with_the_order_and_have_limits_at_both_ends() {
    let tolerance = Tolerance::new(1e-8).unwrap();
    let nus = [1e-7, 1e-5, 1e-3, 0.05, 0.2, 0.4, 0.6, 0.8, 0.95];
    for constant in [product_constant, consistency_constant, midpoint_bound] {
        let values: Vec<f64> = nus
            .iter()
            .map(|&nu| constant(order(nu), tolerance).unwrap().best.constant.value)
            .collect();
        assert!(values.windows(2).all(|pair| pair[1] < pair[0]), "{values:?}");
        // Analytic in ν through 0: the first differences are proportional to ν.
        let slope = (values[1] - values[2]) / (nus[2] - nus[1]);
        let from_zero = (values[0] - values[1]) / (nus[1] - nus[0]);
        assert!((slope / from_zero - 1.0).abs() < 0.05, "{values:?}: {slope} {from_zero}");
    }
    // ν → 1: ∫w'² in place of (1 − ν)|w|², moments √(e⁵/20), √(n³/3) and √(e³/3), √(2n⁵/15).
    let left = 1e-6;
    let near = Order::half_plus(0.5 - left).unwrap();
    let place = 5f64.powi(5) * 27.0 / 8f64.powi(8);
    for (constant, limit) in [
        (product_constant(near, tolerance), 1.0 / 24.0),
        (consistency_constant(near, tolerance), (place / 60.0).sqrt()),
        (midpoint_bound(near, tolerance), (place * 2.0 / 45.0).sqrt()),
    ] {
        let value = constant.unwrap().best.constant.value / left;
        assert!((value / limit - 1.0).abs() < 1e-5, "{value} {limit}");
    }
}

#[test]
fn a_short_gap_at_any_scale_and_bad_input() {
    // A constant σ_N has |σ_N|²_ν ~ θ^{1−2ν} beside a gap θ, and u_N' on it ∫u_N' ~ θ^{1/2+ν}: θ^{2ν}.
    for nu in [0.1, 0.25, 0.4] {
        let ratio =
            |gap: f64| one_gap_ratio(Cone::Nodal, order(nu), gap, Tolerance::fast()).unwrap().value;
        let power = (ratio(1e-100) / ratio(1e-120)).log10() / 20.0;
        assert!((power - 2.0 * nu).abs() < 1e-3, "{nu}: {power}");
    }
    for gap in [0.0, 1.0, -0.1, f64::NAN] {
        assert!(one_gap_ratio(Cone::Midpoint, order(0.3), gap, Tolerance::fast()).is_err());
    }
}
