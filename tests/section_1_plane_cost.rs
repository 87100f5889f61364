//! What norms in the plane cost: tolerances are met, and planted faults are seen.

#[allow(dead_code)]
#[path = "../examples/section_1_plane_cost.rs"]
mod example;

use example_frame::Outcome;

#[test]
fn wrong_norms_are_seen() {
    let options = example::Options { squares: 30, triangles: 300, ..example::Options::default() };
    let mut computed = example::compute(&options).unwrap();
    let outcome = |computed: &example::Computed, key: &str| {
        let found = example::findings(computed);
        found.iter().find(|finding| finding.key() == key).unwrap().outcome()
    };
    for key in ["met", "large", "product", "rate", "interpolants", "memory"] {
        assert_eq!(outcome(&computed, key), Outcome::Holds, "{key}");
    }
    computed.0[2].3 = 0.1;
    computed.1[0] = 1e-6;
    computed.1[2] = 1e5;
    computed.2[1] = 1e-6;
    computed.0.iter_mut().rev().zip([6e-3, 8e-3, 1e-2]).for_each(|(row, off)| row.3 = off);
    for key in ["met", "large", "product", "rate", "memory"] {
        assert_eq!(outcome(&computed, key), Outcome::Refuted, "{key}");
    }
}
