//! Closed forms of squared seminorms against references computed in multiple precision.

use fractional_sobolev::{Error, Function, Order, Position, closed_forms};
use serde_json::Value;

/// A few hundred operations of one sign.
const CLOSED_FORM_TOLERANCE: f64 = 1e-12;

fn references() -> Vec<Value> {
    serde_json::from_str(include_str!("../reference/closed_forms.json")).unwrap()
}

fn number(row: &Value, key: &str) -> f64 {
    row[key].as_str().unwrap().parse().unwrap()
}

#[test]
fn powers_have_twelve_digits() {
    for row in references() {
        let estimate = match row["function"].as_str().unwrap() {
            "x^a" => {
                let order: Order = row["nu"].as_str().unwrap().parse().unwrap();
                closed_forms::power_seminorm_squared(number(&row, "a"), order)
            }
            "|ln x|^alpha" => closed_forms::log_power_seminorm_squared(number(&row, "alpha")),
            _ => continue,
        };
        let (estimate, exact) = (estimate.unwrap(), number(&row, "seminorm_sq"));
        let error = (estimate.value / exact - 1.0).abs();
        assert!(
            error < CLOSED_FORM_TOLERANCE,
            "{row}: {} against {exact}, {error:e}",
            estimate.value
        );
        assert!(error < estimate.relative_error(), "{row}: error {error:e} beyond its estimate");
    }
}

#[test]
fn infinite_norms_say_why() {
    let order = Order::new(0.75).unwrap();
    for outcome in [
        closed_forms::power_seminorm_squared(0.25, order),
        closed_forms::jump_seminorm_squared(0.5, 0.5, order),
        closed_forms::jump_seminorm_squared(0.5, 0.5, Order::HALF),
        closed_forms::log_power_seminorm_squared(0.5),
    ] {
        assert!(matches!(outcome, Err(Error::InfiniteNorm { .. })), "{outcome:?}");
    }
    assert!(closed_forms::power_seminorm_squared(f64::NAN, order).is_err());
    assert!(closed_forms::log_power_seminorm_squared(-0.1).is_err());
}

#[test]
fn jumps_and_hats_have_elementary_values() {
    // ν = 1/4, p = q = 1: 2 (2 − √2) / (1/4)
    let quarter = Order::new(0.25).unwrap();
    let jump = closed_forms::jump_seminorm_squared(1.0, 1.0, quarter).unwrap().value;
    assert!((jump / (8.0 * (2.0 - 2f64.sqrt())) - 1.0).abs() < CLOSED_FORM_TOLERANCE, "{jump}");
    // ν = 1/2, hat over two unit elements alone: own cells 1 each, touching cells 2 ∫∫ (s−t)²/(s+t)²
    let hat = closed_forms::hat_seminorm_squared(0.0, 1.0, 1.0, 0.0, Order::HALF).unwrap().value;
    let touching = 2.0 * (3.0 - 4.0 * 2f64.ln()); // ∫∫ = ∫₀¹ ((1−η)/(1+η))² dη · (2/2) · 1 = 3 − 4 ln 2
    assert!(
        (hat / (2.0 + touching) - 1.0).abs() < CLOSED_FORM_TOLERANCE,
        "{hat} {}",
        2.0 + touching
    );
}

/// The tolerances asked of closures, loosest first.
const ASKED: [f64; 5] = [1e-3, 1e-5, 1e-7, 1e-9, 1e-11];

/// |ln x|^α, as exact near x = 1 as near 0.
fn log_power(alpha: f64) -> impl Fn(Position) -> f64 + Sync {
    move |at: Position| {
        let minus_log = match at.anchor() {
            0 => -at.log_distance(),
            _ => -at.offset().ln_1p(),
        };
        minus_log.powf(alpha)
    }
}

/// min(|ln x|^α, N), from the exact height at its break x = e^(−N^(1/α)).
fn truncated(alpha: f64, top: f64, cut: f64) -> impl Fn(Position) -> f64 + Sync {
    move |at: Position| {
        let minus_log = match at.anchor() {
            0 => return top,
            1 if at.offset() < 0.0 => return top,
            1 => top.powf(1.0 / alpha) - (at.offset() / cut).ln_1p(),
            _ => -at.offset().ln_1p(),
        };
        minus_log.max(0.0).powf(alpha)
    }
}

#[test]
fn logarithms_as_closures_reach_the_tolerance_asked() {
    for row in references() {
        let of = |key| number(&row, key);
        let u = match row["function"].as_str().unwrap() {
            // At α = 0.4 a quarter of the seminorm lies below x = 1e-300.
            "|ln x|^alpha" => {
                Function::from_log_distances(&[0.0, 1.0], log_power(of("alpha"))).unwrap()
            }
            "min(|ln x|^alpha, N)" => {
                let breaks = [0.0, of("x_cut"), 1.0];
                Function::from_positions(&breaks, truncated(of("alpha"), of("N"), of("x_cut")))
                    .unwrap()
            }
            _ => continue,
        };
        let exact = of("seminorm_sq").sqrt();
        for asked in ASKED {
            let found = u
                .seminorm(Order::HALF, asked)
                .unwrap_or_else(|e| panic!("{row}, asked {asked:e}: {e}"));
            let error = (found.value / exact - 1.0).abs();
            assert!(
                error <= asked && error <= 10.0 * found.relative_error(),
                "{row}: {found}, error {error:e}"
            );
        }
    }
}
