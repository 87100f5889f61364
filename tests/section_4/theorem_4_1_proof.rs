//! Theorem 4.1, its proof: (4.9)-(4.14) on computed pairs, each side by itself, and the bounds one after the other.

use crate::proof_cases::Proof;
use signorini::edge::ContactPair;
use signorini::proof::ProofConstants;

#[allow(dead_code)]
#[path = "../../examples/theorem_3_1_proof_profile.rs"]
mod theorem_3_1_proof_profile;

const PROOF: Proof = Proof {
    lines: |t, c, theta| {
        let found = theorem_3_1_proof_profile::midpoint(t, c, theta).unwrap();
        assert!(
            found.bounds.is_some() || t.contact_diameter().is_none(),
            "a segment in neither case: {t:?}"
        );
        let lines = found.lines.into_iter().map(|l| (l.name, l.left, l.right, l.size)).collect();
        (lines, found.bounds.map(|b| [b.integral, b.hoelder, b.own_zone, b.theta]))
    },
    factor: |c, h, theta| {
        let second =
            c.law(theta).printed * c.projection * c.wirtinger * h.powf(2.0 * c.tau() - 2.0);
        let first = c.pointwise * c.embedding * h * theta.powf(c.hoelder());
        if c.tau() > 2.0 { second } else { first.max(second) }
    },
};

#[test]
fn every_inequality_holds_on_more_than_two_hundred_cases() {
    PROOF.holds_on_all_cases();
    PROOF.holds_on_degenerate_pairs();
}

#[test]
fn above_two_every_segment_with_contact_obeys_4_14() {
    for tau in [2.05, 2.25, 2.45] {
        let constants = ProofConstants::new(tau, 2.0, &[]).unwrap();
        // Transitions at one and at two thirds of a cell: halving h exchanges the two.
        let term = |n: usize| -> f64 {
            let on = |a: f64| ContactPair::smooth_transition(128 * n, a, tau).unwrap();
            let sums = |a: f64| PROOF.checked(&on(a), n, 0.5, &constants, "smooth transition").1;
            sums(5.0 / 12.0)[0] + sums(11.0 / 24.0)[0]
        };
        // h^(2 + 2 eps) is optimal on one transition.
        let order = (term(128) / term(256)).log2();
        assert!((order - (2.0 * tau - 2.0)).abs() < 0.1, "tau {tau}: {order}");
    }
}
