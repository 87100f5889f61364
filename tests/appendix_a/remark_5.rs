//! Remark 5: truncated powers of |ln x| leave (5.3) without a constant at one half.

use fractional_sobolev::closed_forms::log_power_seminorm_squared;
use fractional_sobolev::{Constraint, Order, Tolerance, gamma};

#[allow(dead_code)]
#[path = "../../examples/remark_5_log_counterexample.rs"]
mod example;

/// ‖w‖₀ and |w|.
fn norms(alpha: f64, log: f64) -> [f64; 2] {
    let w = example::truncated(alpha, log).unwrap();
    let norm = w.norm(0.0, Tolerance::reference()).unwrap().value;
    [norm, w.seminorm(Order::HALF, Tolerance::balanced()).unwrap().value]
}

#[test]
fn statement_is_confirmed() {
    for alpha in [0.25, 0.3, 0.4, 0.45, 0.49] {
        let mut before = 0.0;
        for log in [4.0, 16.0, 64.0, 256.0, 600.0] {
            let [norm, seminorm] = norms(alpha, log);
            let zone = Constraint::vanishing_on(0.0..f64::exp(-log));
            let best = gamma(Order::HALF, zone, Tolerance::balanced()).unwrap().constant.value;
            let quotient = norm / seminorm;
            assert!(
                quotient > 1.2 * before && quotient < best,
                "alpha {alpha}, L {log}: {quotient} of {best}"
            );
            before = quotient;
        }
    }
}

#[test]
fn the_printed_chain_fails_and_the_repaired_one_holds() {
    for alpha in [0.25, 0.4, 0.45] {
        let seminorm_of_u = log_power_seminorm_squared(alpha).unwrap().value.sqrt();
        let norm_of_u = seminorm_of_u.hypot(libm::tgamma(1.0 + 2.0 * alpha).sqrt());
        for log in [4.0f64, 16.0, 64.0, 256.0] {
            let ([norm, seminorm], n) = (norms(alpha, log), log.powf(alpha));
            // ‖w‖ tends to one: the printed bound 1/n fails once n is above it.
            assert!(
                log < 64.0 || norm.hypot(seminorm) * n / norm_of_u > 1.4,
                "alpha {alpha}, L {log}"
            );
            let repaired = seminorm * n / seminorm_of_u;
            assert!(repaired < 1.0 + 1e-3, "alpha {alpha}, L {log}: {repaired}");
        }
    }
}

#[test]
fn the_ramp_has_the_sharp_factor_and_other_powers_less() {
    let slope = |alpha: f64| {
        let [long, short] = [64.0, 256.0].map(|log| {
            let [norm, seminorm] = norms(alpha, log);
            (norm / seminorm).powi(2)
        });
        (short - long) / 192.0
    };
    let sharp = 1.5 / std::f64::consts::PI.powi(2);
    assert!((slope(1.0) / sharp - 1.0).abs() < 1e-3, "{}", slope(1.0));
    assert!(slope(0.75) < 0.95 * sharp, "{}", slope(0.75));
    // (2α − 1)/α² · 3/(2π²), largest for α = 1
    for alpha in [0.6f64, 0.75, 0.9] {
        assert!((2.0 * alpha - 1.0) / (alpha * alpha) < 1.0 && slope(alpha) < sharp, "{alpha}");
    }
}
