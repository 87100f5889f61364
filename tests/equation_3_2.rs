//! (3.2), (4.3): at τ = 2 the error is of order h in H², and |ln h|^{1/2} belongs to kinks outside H².

use example_frame::Outcome;
use experiments::convergence::{LogarithmFit, Quantity};

#[allow(dead_code)]
#[path = "../examples/equation_3_2_logarithm.rs"]
mod example;

/// The power of the logarithm is seen over a factor of three in |ln h| only.
const KINK: f64 = 0.15;

#[test]
fn no_logarithm_in_h2_and_a_square_root_of_one_outside() {
    // The half-widths of many gaps in the midpoint cone need all levels of the default.
    let headline = example::run(&example::Options::default()).unwrap();
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
    } // Twenty-two transitions with α = 0, 3/4, 1, a Cantor set with 0, 1, 3/2, in both cones: the sign of q.
    for (row, alpha) in [0.0, 0.0, 0.75, 0.75, 1.0, 1.0, 0.0, 0.0, 1.0, 1.0, 1.5, 1.5].into_iter().enumerate()
    {
        let number = |key: &str| headline.table.number(8 + row, key).unwrap();
        let (power, half) = (number("power"), number("half_width"));
        assert_eq!(number("expected"), 1.0 - 2.0 * alpha, "row {row}");
        assert!((power > 0.0) == (alpha == 0.0) && power.abs() > half, "row {row}: {headline}");
    }
}

#[test]
fn planted_faults_turn_the_outcome() {
    let options = example::Options { levels: "3-14".parse().unwrap(), ..example::Options::default() };
    let mut computed = example::compute(&options).unwrap();
    let outcome = |computed: &example::Computed, key: &str| {
        let found = example::findings(&options, computed);
        found.into_iter().find(|finding| finding.key() == key).unwrap().outcome()
    };
    assert_eq!(outcome(&computed, "none.transitions.nodal.100"), Outcome::Holds);
    let row = computed.rows.iter_mut().find(|row| row.key("none") == "none.transitions.nodal.100").unwrap();
    // A logarithm too many, on every level.
    for level in &mut row.study.levels {
        level.error *= (2.0 + (level.cells as f64).ln()).sqrt();
    }
    row.fit = LogarithmFit::of(&row.study.points(Quantity::Error)[3..]);
    assert_eq!(outcome(&computed, "none.transitions.nodal.100"), Outcome::Refuted);
    assert_eq!(outcome(&computed, "bound.transitions.nodal.100"), Outcome::Refuted);
}
