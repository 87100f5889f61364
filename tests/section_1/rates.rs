//! The introduction: every printed rate, (E1)-(E4), (N1), (N2), is reached, and no order exceeds min(τ − 1,
//! 1).

#[allow(dead_code)]
#[path = "../../examples/introduction_rates.rs"]
mod example;

/// Log-periodic Cantor sets, and logarithms at τ = 2, on few levels.
const ORDER: f64 = 0.06;

#[test]
fn every_rate_is_reached_and_the_optimal_one_is_not_passed() {
    let found = example::outcome(&example::Options::default()).unwrap();
    let text = found.text(false);
    assert_eq!(found.exit_code(), 0, "{text}");
    for cone in ["nodal", "midpoint"] {
        for (order, optimal) in found.numbers(cone).into_iter().zip(found.numbers("optimal")) {
            assert!((order - optimal).abs() < ORDER, "{order} {optimal}:\n{text}");
        }
    }
}
