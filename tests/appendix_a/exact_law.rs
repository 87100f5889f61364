//! The law of the Poincaré constant at one half: two proved bounds enclose it, and what is left is predicted.

use fractional_sobolev::{BestConstant, Constraint, Error, Law, Order, Tolerance, gamma, law};

/// 3/(2π²).
const END_SLOPE: f64 = 1.5 / (std::f64::consts::PI * std::f64::consts::PI);

fn at_one_half() -> Law {
    law(Order::HALF, 0.0, Tolerance::fast()).unwrap()
}

/// The squares of both bounds.
fn squares(found: &BestConstant) -> [f64; 2] {
    [found.lower, found.upper.unwrap()].map(|bound| bound.value.powi(2))
}

#[test]
fn two_proved_bounds_enclose_the_constant() {
    let law = at_one_half();
    for theta in [0.3, 0.1, 3e-2, 1e-3, 1e-6, 1e-12, 1e-50, 1e-150, 1e-250, 1e-300] {
        let zone = Constraint::mean_zero_on(0.0..theta);
        let found = gamma(Order::HALF, zone, Tolerance::balanced()).unwrap().constant;
        let (low, high) = (found.value - found.error, found.value + found.error);
        let [lower, upper] = squares(&law.bracket(-f64::ln(theta)).unwrap());
        assert!(lower <= high * high, "theta {theta}: {found} against {lower}");
        assert!(upper >= low * low, "theta {theta}: {found} against {upper}");
    }
}

/// A^(1/2) ∫ C(r) r²/(2 sinh²(r/2)) dr is 3.46.
const CHAINS: f64 = 3.5;

#[test]
fn the_bounds_close_on_the_law() {
    let mut before = f64::INFINITY;
    let at_one_half = at_one_half();
    for exponent in 1..=15 {
        let log = 10f64.powi(exponent);
        let [lower, upper] = squares(&at_one_half.bracket(log).unwrap());
        let law = END_SLOPE * log;
        // The ramp is right up to 1/L. The chains lose b = A^(1/2) ∫ C w / L^(1/2), and N ≤ (A L)^(1/2) (b +
        // (1 + b²)^(1/2)).
        assert!((lower / law - 1.0).abs() < 1.0 / log, "L {log}: {lower} against {law}");
        let above = upper / law - 1.0;
        assert!(above > 0.0 && above < before, "L {log}: {above} after {before}");
        let b = CHAINS / log.sqrt();
        assert!(above < (b + b.hypot(1.0)).powi(2) - 1.0, "L {log}: {above}");
        before = above;
    }
}

#[test]
fn bad_lengths_are_refused() {
    let law = at_one_half();
    for log in [f64::NAN, 0.0, 0.5, -3.0, f64::INFINITY, 1e16] {
        assert!(matches!(law.bracket(log), Err(Error::OutOfRange { .. })), "{log}");
    }
}
