//! Theorem 4.1, its proof: (4.9)-(4.14) on computed pairs, each side by itself, and the ladder of bounds.

use signorini::edge::ContactPair;
use signorini::proof::{ProofConstants, Section, Step};

#[allow(dead_code)]
#[path = "../../examples/theorem_4_1_proof_profile.rs"]
mod theorem_4_1_proof_profile;

use crate::proof_cases::{all_cases, checked};

const SECTION: Section = Section::Four;

#[test]
fn every_inequality_holds_on_more_than_two_hundred_cases() {
    let (cases, checks) = all_cases(SECTION, &[1.55, 1.65, 1.75, 1.9, 2.0]);
    println!("{cases} cases, {checks} inequalities");
    assert!(cases >= 200 && checks > 10_000, "{cases} cases, {checks} inequalities");
}

#[test]
fn above_two_every_segment_with_contact_obeys_4_14() {
    for tau in [2.05, 2.25, 2.45] {
        let constants = ProofConstants::new(tau, 2.0, &[]).unwrap();
        // Transitions at one and at two thirds of a cell: halving h exchanges the two.
        let level = |n: usize| -> [f64; 2] {
            let rungs = [5.0 / 12.0, 11.0 / 24.0].map(|a| {
                let pair = ContactPair::smooth_transition(128 * n, a, tau).unwrap();
                checked(SECTION, &pair, n, 0.5, &constants, "smooth transition").rungs
            });
            [Step::Term, Step::WholeEdge].map(|step| rungs.iter().map(|r| r[step as usize].printed).sum())
        };
        let (coarse, fine) = (level(128), level(256));
        // h^(2 + 2 eps) is optimal on one transition; the norms of the whole edge still grow with the mesh.
        let order = |k: usize| (coarse[k] / fine[k]).log2();
        assert!((order(0) - (2.0 * tau - 2.0)).abs() < 0.1, "tau {tau}: {}", order(0));
        let factor = |n: f64| constants.edge_factor(SECTION, 1.0 / n, 0.5).printed;
        assert!(((factor(128.0) / factor(256.0)).log2() - (2.0 * tau - 2.0)).abs() < 1e-9);
    }
}

#[test]
fn the_example_finds_no_violation() {
    for tau in [1.55, 1.9] {
        let options = theorem_4_1_proof_profile::Options { tau, ..Default::default() };
        let outcome = theorem_4_1_proof_profile::outcome(&options).unwrap();
        assert!(outcome.status().is_confirmed(), "{}", outcome.text(false));
    }
}
