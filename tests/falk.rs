//! Falk's lemma for both cones: its terms on computed solutions, their known infima, and (4.8).

use experiments::convergence::{Levels, StripCase};
use experiments::proof::falk_terms;
use signorini::cone::Cone;
use signorini::problems::StripData;
use signorini::strip::{Reference, StripKind};

#[allow(dead_code)]
#[path = "../examples/falk_terms.rs"]
mod falk_terms_example;

/// Squared errors carry the rounding of the contact iteration, 1e-13 of the energy.
const ROUNDING: f64 = 1e-9;

fn case(kind: StripKind, scene: &str, tau: f64, cone: Cone) -> StripCase {
    StripCase {
        kind,
        levels: Levels::new(2, 7).unwrap(),
        source: scene.parse::<StripData>().unwrap(),
        tau,
        cone,
        reference: Reference::Nested,
        positions: 1,
    }
}

#[test]
fn the_lemma_holds_with_constant_two_in_the_energy_norm() {
    for (scene, tau) in
        [("transition:0.37", 1.75), ("transition:0.61", 2.0), ("transitions:5", 1.6), ("fat-cantor", 1.75)]
    {
        for kind in [StripKind::Scalar, StripKind::Elastic] {
            for cone in [Cone::Nodal, Cone::Midpoint] {
                for row in falk_terms(&case(kind, scene, tau, cone), |_| ()).unwrap() {
                    let name = format!("{kind} {scene} tau {tau} {cone} n {}", row.n);
                    let size = ROUNDING * (row.terms.error + row.terms.approximation);
                    let second = if cone == Cone::Midpoint { row.terms.second_infimum } else { 0.0 };
                    let bound = row.terms.approximation + 2.0 * (row.terms.consistency + second);
                    assert!(row.terms.error <= bound + size, "{name}: {} above {bound}", row.terms.error);
                    assert!(row.terms.consistency >= 0.0 && row.terms.second_part >= 0.0, "{name}");
                    // (4.8)
                    let parts = row.terms.first_part + row.terms.second_part;
                    assert!(
                        row.terms.second_infimum <= parts + size,
                        "{name}: {} above {parts}",
                        row.terms.second_infimum
                    );
                    // u_h minimises |u − v|²/2 + ∫σ(v − u) over its cone, which contains I^h u.
                    let interpolant = row.terms.approximation + 2.0 * row.terms.consistency;
                    assert!(
                        row.terms.first_infimum() <= interpolant + size,
                        "{name}: {}",
                        row.terms.first_infimum()
                    );
                    if cone == Cone::Nodal {
                        assert!(row.terms.second_infimum <= size, "{name}: K^h is part of K");
                    }
                    assert!(row.kkt < 1e-9, "{name}: kkt {}", row.kkt);
                }
            }
        }
    }
}

#[test]
fn the_example_confirms_the_lemma() {
    for cone in [Cone::Nodal, Cone::Midpoint] {
        let options = falk_terms_example::Options { cone, ..falk_terms_example::Options::default() };
        let headline = falk_terms_example::run(&options).unwrap();
        assert!(headline.verdict().is_confirmed(), "{cone}: {}", headline.verdict());
        let rows = headline.table.rows().len();
        for row in 0..rows {
            let constant = headline.table.number(row, "constant").unwrap();
            assert!(constant > 0.0 && constant <= 2.0 + ROUNDING, "{cone} row {row}: {constant}");
        }
    }
}
