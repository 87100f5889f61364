//! Theorems 3.1, 4.1: no contact set brings the consistency term to the theorem's exponent.

#[allow(dead_code)]
#[path = "../../examples/worst_contact_set.rs"]
mod example;

use crate::worst_pair::worst_ratio;
use fractional_sobolev::{Order, Tolerance};
use signorini::cone::Cone;
use signorini::proof::consistency_constant;

#[test]
fn the_ratio_of_a_set_is_that_of_two_independent_computations() {
    let order = Order::new(0.25).unwrap();
    let form = example::seminorm_form(40, order.value());
    let one_gap = |gap: usize| -> Vec<bool> { (0..40).map(|k| k >= gap).collect() };
    let ratio = |cone, contact: &[bool]| example::by_definition(cone, contact, &form).unwrap();
    for gap in [3, 10, 25] {
        // One gap and its complement exchange the cones.
        let (nodal, midpoint) =
            (ratio(Cone::Nodal, &one_gap(gap)), ratio(Cone::Midpoint, &one_gap(40 - gap)));
        assert!((nodal / midpoint - 1.0).abs() < 1e-11, "{gap}: {nodal} {midpoint}");
    }
    // Constants on equal cells here, on a graded mesh there.
    let there = worst_ratio(Cone::Nodal, 1.75, 0.0, 0.25, 0.02).0;
    let here = ratio(Cone::Nodal, &one_gap(10));
    assert!(here < 1.02 * there && here > 0.8 * there, "{here} {there}");
    // A gap without room only takes room from the pressure.
    let mut inside = one_gap(12);
    inside[25] = false;
    assert!(ratio(Cone::Midpoint, &inside) < ratio(Cone::Midpoint, &one_gap(12)));
    // Every contact interval stays below the sharp constant of one gap.
    let sharp = consistency_constant(order, Tolerance::fast()).unwrap().best.constant.value;
    for cone in [Cone::Nodal, Cone::Midpoint] {
        for (a, b) in (0..40).flat_map(|a| (a + 1..=40).map(move |b| (a, b))) {
            let contact: Vec<bool> = (0..40).map(|k| (a..b).contains(&k)).collect();
            assert!(ratio(cone, &contact) < sharp, "{cone} {a} {b}");
        }
    }
}

#[test]
fn a_short_gap_makes_the_term_small_where_the_second_case_lets_it_grow() {
    for tau in [1.6, 1.75, 1.9] {
        let ratios: Vec<f64> = [1e-2, 1e-4, 1e-5]
            .iter()
            .map(|&t| worst_ratio(Cone::Nodal, tau, 0.0, t, 0.05).0)
            .collect();
        assert!(ratios.windows(2).all(|pair| pair[1] < pair[0]), "{tau}: {ratios:?}");
        // A constant σ_N has |σ_N|²_ν ~ θ^{1−2ν} beside a gap θ, and u_N' on it ∫u_N' ~ θ^{1/2+ν} |u_N'|_ν:
        // together θ^{2ν} = θ^{2τ−3}.
        let order = (ratios[1] / ratios[2]).log10();
        assert!((order - (2.0 * tau - 3.0)).abs() < 0.05, "{tau}: {order}");
    }
}
