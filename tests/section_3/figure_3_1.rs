//! Figure 3.1: measured orders lie on the optimal line, above the theorem's curve, for both cones.

use crate::program::outcome;

/// Orders against τ − 1 on levels 2^3 ... 2^12, five positions; wider than on scalar strips.
const ORDER: f64 = 0.03;

#[test]
fn errors_on_elastic_strips_lie_on_the_optimal_line() {
    let (_, found) = outcome("figure_3_1", &["--tau=1.55,1.75,1.95", "--kind=elastic"]);
    // Every order is nearer to τ − 1 than what it may be off by.
    assert_eq!(found["verdict"], "loose", "{found}");
    for tau in [1.55, 1.75, 1.95] {
        for cone in ["nodal", "midpoint"] {
            let order = found["values"][format!("{cone}.tau{tau}")].as_f64().unwrap();
            assert!((order - (tau - 1.0)).abs() < ORDER, "{cone} {tau}: {order}");
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
