//! Figure 3.1: measured orders lie on the optimal line, above the theorem's curve, for both cones.

#[allow(dead_code)]
#[path = "../../examples/figure_3_1.rs"]
mod example;

use example_report::Verdict;
use signorini::strip::StripKind;

/// Orders against τ − 1 on levels 2^3 ... 2^12, five positions; on elastic strips the scatter is larger.
const ORDER: f64 = 0.02;

#[test]
fn errors_of_both_cones_lie_on_the_optimal_line() {
    for kind in [StripKind::Scalar, StripKind::Elastic] {
        let tau = vec![1.55, 1.75, 1.95];
        let options = example::Options { tau, kind, ..example::Options::default() };
        let found = example::outcome(&options).unwrap();
        // Every order is nearer to τ − 1 than what it may be off by.
        assert_eq!(found.status(), Verdict::Loose, "{}", found.text(false));
        for cone in ["nodal", "midpoint"] {
            for (order, optimal) in found.numbers(cone).into_iter().zip(found.numbers("optimal")) {
                let wide = if kind == StripKind::Scalar { ORDER } else { 1.5 * ORDER };
                assert!((order - optimal).abs() < wide, "{kind} {cone}: {}", found.text(false));
            }
        }
    }
}

#[test]
fn the_printed_curves_meet_at_the_ends_and_part_by_a_sixteenth() {
    use signorini::rates::Bound;
    let exponent = |bound: Bound, tau: f64| bound.exponent(tau).unwrap();
    assert_eq!(exponent(Bound::Paper, 1.75), 11.0 / 16.0);
    assert_eq!(exponent(Bound::Optimal, 1.75) - exponent(Bound::Paper, 1.75), 1.0 / 16.0);
    assert_eq!(exponent(Bound::Earlier, 2.0), 0.75);
    assert_eq!(exponent(Bound::Paper, 2.0), exponent(Bound::Optimal, 2.0));
}
