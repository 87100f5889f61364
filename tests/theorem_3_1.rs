//! Theorem 3.1: errors and consistency terms of the nodal cone stay below the printed bound, at the optimal
//! order.

#[allow(dead_code)]
#[path = "../examples/theorem_3_1_rates.rs"]
mod example;
mod theorem_rates;

use signorini::cone::Cone;

#[test]
fn single_transitions_have_order_tau_minus_one() {
    theorem_rates::single_transitions(Cone::Nodal);
}

#[test]
fn many_transitions_have_order_tau_minus_one() {
    theorem_rates::many_transitions(Cone::Nodal);
}

#[test]
fn corners_have_the_order_of_their_opening() {
    theorem_rates::corners(Cone::Nodal);
}

#[test]
fn a_corner_beside_a_contact_zone_has_the_order_of_its_opening() {
    theorem_rates::corner_with_contact(Cone::Nodal);
}

#[test]
fn the_consistency_term_by_two_roads() {
    theorem_rates::terms_by_two_roads(Cone::Nodal);
}

#[test]
fn the_example_confirms_the_theorem() {
    let options = example::Options { tau: vec![1.75, 2.0, 2.1], ..example::Options::default() };
    let headline = example::run(&options).unwrap();
    assert!(headline.verdict().is_confirmed(), "{headline}");
}

#[test]
fn planted_faults_turn_the_verdict() {
    let options = theorem_rates::one_transition!(example::Options);
    let mut computed = example::compute(Cone::Nodal, &options).unwrap();
    let rows = computed.rows.clone();
    theorem_rates::planted_faults(&rows, |rows| {
        computed.rows = rows;
        example::findings(&options, &computed)
    });
}
