//! (3.2), (4.3): at τ = 2 the error is of order h in H², and |ln h|^{1/2} belongs to kinks outside H².

#[allow(dead_code)]
#[path = "../examples/equation_3_2_logarithm.rs"]
mod example;

/// The power of the logarithm is seen over a factor of three in |ln h| only.
const KINK: f64 = 0.15;

#[test]
fn no_logarithm_in_h2_and_a_square_root_of_one_outside() {
    let options = example::Options { levels: "3-13".parse().unwrap(), ..example::Options::default() };
    let headline = example::run(&options).unwrap();
    assert!(headline.verdict().is_confirmed(), "{headline}");
    for (row, expected) in [1.0, 1.0, -0.5, -0.5, -1.0, -1.0, -2.0, -2.0].into_iter().enumerate() {
        let number = |key: &str| headline.table.number(row, key).unwrap();
        let (power, half) = (number("power"), number("half_width"));
        assert!((power - expected).abs() < half.max(KINK), "row {row}: {headline}");
        if expected > 0.0 {
            assert!(power - half > 0.0, "row {row}: {headline}");
        } else {
            assert!(power + half < 0.0, "row {row}: {headline}");
            assert!(number("paper") < 1.0 && number("sharpened") < 1.0, "row {row}: {headline}");
        }
    }
}
