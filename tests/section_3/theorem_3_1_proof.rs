//! Theorem 3.1, its proof: (3.3)-(3.15) on computed pairs, each side by itself, and the bounds one after the other.

use crate::proof_cases::{Proof, pair, printed_theta};
use signorini::edge::{ContactPair, Traces};
use signorini::problems::StripData;
use signorini::proof::ProofConstants;
use signorini::strip::{EdgeData, LateralCondition};

#[allow(dead_code)]
#[path = "../../examples/theorem_3_1_proof_profile.rs"]
mod theorem_3_1_proof_profile;

const PROOF: Proof = Proof {
    lines: |t, c, theta| {
        let found = theorem_3_1_proof_profile::nodal(t, c, theta).unwrap();
        assert!(found.bounds.is_some(), "a segment in neither case: {t:?}");
        let lines = found.lines.into_iter().map(|l| (l.name, l.left, l.right, l.size)).collect();
        (lines, found.bounds.map(|b| [b.integral, b.hoelder, b.own_zone, b.theta]))
    },
    factor: |c, h, theta| {
        let second = c.law(theta).printed * c.interpolation * h.powf(2.0 * c.tau() - 2.0);
        (c.embedding * h * theta.powf(c.hoelder())).max(second)
    },
};

#[test]
fn every_inequality_holds_on_more_than_two_hundred_cases() {
    PROOF.holds_on_all_cases();
}

#[test]
fn the_corrected_law_gives_the_square_root_of_the_logarithm() {
    let meshes = || (3..=10).map(|level| 1usize << level);
    let zones: Vec<f64> = meshes().map(|n| printed_theta(n, 2.0)).collect();
    let c = ProofConstants::new(2.0, 2.0, &zones).unwrap();
    // The second case with its law over h² ln(1/h), over h² sqrt(ln(1/h)): the law in place of γ_θ in the fourth bound.
    let quotients: Vec<[f64; 2]> = meshes()
        .map(|n| {
            let theta = printed_theta(n, 2.0);
            let (_, sums) =
                PROOF.checked(&pair(&StripData::transition(), 2.0, n), n, theta, &c, "transition");
            let (law, gamma) = (c.law(theta), c.gamma(theta).unwrap());
            assert!(sums[3] > 0.0 && law.corrected >= gamma * (1.0 - 1e-8));
            [law.printed / gamma / (n as f64).ln().sqrt(), law.corrected / gamma]
        })
        .collect();
    // γ_θ ~ sqrt(ln(1/θ)): both quotients stay within a factor of their first value.
    for quotient in &quotients {
        let apart = [0, 1].map(|column| quotient[column] / quotients[0][column]);
        assert!(apart.iter().all(|ratio| (0.5..2.0).contains(ratio)), "{quotients:?}");
    }
}

#[test]
fn degenerate_pairs_have_finite_norms_and_no_violation() {
    PROOF.holds_on_degenerate_pairs();
    // A force on an isolated contact point is no density.
    let values: Vec<f64> = (0..=8).map(|i| if i == 4 { 0.0 } else { -1.0 }).collect();
    let forces: Vec<f64> = (0..=8).map(|i| if i == 4 { 1.0 } else { 0.0 }).collect();
    let scene = EdgeData::new(8, LateralCondition::Natural, &values, &forces).unwrap();
    assert!(ContactPair::of_data(&scene, Traces::Constants).is_err());
}
