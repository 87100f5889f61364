//! The introduction: every printed rate, (E1)-(E4), (N1), (N2), is reached, and no order exceeds min(τ − 1,
//! 1).

#[allow(dead_code)]
#[path = "../examples/introduction_rates.rs"]
mod example;

/// Log-periodic Cantor sets, and logarithms at τ = 2, on few levels.
const ORDER: f64 = 0.04;

#[test]
fn every_rate_is_reached_and_the_optimal_one_is_not_passed() {
    // Fewer levels leave bars too wide to decide; one more is the default, run by `tests/findings.rs`.
    let options = example::Options { levels: "4-13".parse().unwrap(), ..example::Options::default() };
    let headline = example::run(&options).unwrap();
    assert!(headline.verdict().is_confirmed(), "{headline}");
    for row in 0..headline.table.rows().len() {
        let number = |key: &str| headline.table.number(row, key).unwrap();
        for cone in ["nodal", "midpoint"] {
            let order = number(cone);
            // Many kinks at τ = 2 lie outside H² and carry (ln h)^(1/2): below order one by 1/(2 |ln h|) and
            // more.
            assert!(order < (number("tau") - 1.0).min(1.0) + ORDER, "row {row}: {headline}");
            assert!(order > number("exponent") - ORDER, "row {row}: {headline}");
        }
    }
}
