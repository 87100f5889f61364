//! Theorem 4.1: errors and consistency terms of the midpoint cone are of the optimal order, above the printed one.

#[allow(dead_code, reason = "only `outcome` is used here")]
#[path = "../examples/theorem_3_1_problems.rs"]
mod example;
mod theorem_rates;

use signorini::cone::Cone;
use signorini::problems::{NamedProblem, TestProblem};

#[test]
fn single_transitions_have_order_tau_minus_one() {
    theorem_rates::single_transitions(Cone::Midpoint);
}

#[test]
fn many_transitions_have_order_tau_minus_one() {
    theorem_rates::many_transitions(Cone::Midpoint);
}

#[test]
fn smooth_transitions_have_order_one() {
    theorem_rates::smooth_transitions(Cone::Midpoint);
}

#[test]
fn corners_have_the_order_of_their_opening() {
    let problem = vec![NamedProblem::Mesh(TestProblem::Corner)];
    let (tau, cone) = (vec![1.6, 1.75, 1.9], Cone::Midpoint);
    let found = example::outcome(&example::Options { tau, problem, cone, finest: 13 }).unwrap();
    theorem_rates::corners(|key| found.value(key));
}

#[test]
fn the_consistency_term_by_two_roads() {
    theorem_rates::terms_by_two_roads(Cone::Midpoint);
}
