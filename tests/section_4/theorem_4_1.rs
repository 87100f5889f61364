//! Theorem 4.1: errors and consistency terms of the midpoint cone are of the optimal order, above the printed one.

#[allow(dead_code, reason = "only `outcome` is used here")]
#[path = "../../examples/theorem_4_1_rates.rs"]
mod example;

use signorini::cone::Cone;
use signorini::problems::{NamedProblem, TestProblem};

#[test]
fn single_transitions_have_order_tau_minus_one() {
    crate::theorem_rates::single_transitions(Cone::Midpoint);
}

#[test]
fn many_transitions_have_order_tau_minus_one() {
    crate::theorem_rates::many_transitions(Cone::Midpoint);
}

#[test]
fn smooth_transitions_have_order_one() {
    crate::theorem_rates::smooth_transitions(Cone::Midpoint);
}

#[test]
fn corners_have_the_order_of_their_opening() {
    let problem = vec![NamedProblem::Mesh(TestProblem::Corner)];
    let found =
        example::outcome(&example::Options { tau: vec![1.6, 1.75, 1.9], problem, finest: 13 }).unwrap();
    crate::theorem_rates::corners(|key| found.value(key));
}

#[test]
fn the_consistency_term_by_two_roads() {
    crate::theorem_rates::terms_by_two_roads(Cone::Midpoint);
}
