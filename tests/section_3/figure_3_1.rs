//! Figure 3.1: the printed curves. Orders of scalar and elastic strips: `rates`; of both cones: `interface/outcomes`.

#[test]
fn the_printed_curves_meet_at_the_ends_and_part_by_a_sixteenth() {
    use signorini::rates::Bound;
    let exponent = |bound: Bound, tau: f64| bound.exponent(tau).unwrap();
    assert_eq!(exponent(Bound::Paper, 1.75), 11.0 / 16.0);
    assert_eq!(exponent(Bound::Optimal, 1.75) - exponent(Bound::Paper, 1.75), 1.0 / 16.0);
    assert_eq!(exponent(Bound::Earlier, 2.0), 0.75);
    assert_eq!(exponent(Bound::Paper, 2.0), exponent(Bound::Optimal, 2.0));
}
