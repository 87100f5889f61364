//! Theorems 3.1, 4.1: no contact set brings the consistency term to the theorem's exponent.

#[allow(dead_code)]
#[path = "../examples/worst_contact_set.rs"]
mod example;

use example_frame::{Outcome, Verdict};
use fractional_sobolev::Tolerance;
use signorini::cone::Cone;
use signorini::proof::worst_ratio;

#[test]
fn no_set_is_bad_and_none_passes_the_sharp_constant() {
    let options = example::Options { depth: 15, ..example::Options::default() };
    let mut computed = example::compute(&options).unwrap();
    assert!(Verdict::of(&example::findings(&computed)).is_confirmed());
    for (family, terms, _) in &computed.sets {
        assert!(terms.shares.iter().all(|share| (0.0..1.0).contains(share)), "{family}: {terms:?}");
    }
    let sharp = computed.sharp[0].value.value;
    // The two cones exchange their parts for one gap: no difference is left but that of the search.
    for searched in &computed.searched {
        assert!(searched.largest() < sharp && searched.largest() > 0.8 * sharp, "{searched:?} {sharp}");
        assert_eq!(searched.climbed.gaps(), 1, "{searched:?}");
    }
    let [nodal, midpoint] = &computed.searched;
    assert!((nodal.interval.ratio / midpoint.interval.ratio - 1.0).abs() < 1e-10);
    assert_eq!(outcome(&computed, "search"), Outcome::Holds);
    computed.searched[1].random.ratio = 1.001 * sharp;
    assert_eq!(outcome(&computed, "search"), Outcome::Refuted);
}

#[test]
fn a_short_gap_makes_the_term_small_where_the_second_case_lets_it_grow() {
    let tolerance = Tolerance::new(0.05).unwrap();
    for tau in [1.6, 1.75, 1.9] {
        let ratios: Vec<f64> = [1e-2, 1e-4, 1e-5]
            .iter()
            .map(|&t| worst_ratio(Cone::Nodal, tau, 0.0, t, tolerance).unwrap().value)
            .collect();
        assert!(ratios.windows(2).all(|pair| pair[1] < pair[0]), "{tau}: {ratios:?}");
        // A constant σ_N has |σ_N|²_ν ~ θ^{1−2ν} beside a gap θ, and u_N' on it ∫u_N' ~ θ^{1/2+ν} |u_N'|_ν:
        // together θ^{2ν} = θ^{2τ−3}.
        let order = (ratios[1] / ratios[2]).log10();
        assert!((order - (2.0 * tau - 3.0)).abs() < 0.05, "{tau}: {order}");
    }
}

fn outcome(computed: &example::Computed, key: &str) -> Outcome {
    let found = example::findings(computed);
    found.iter().find(|finding| finding.key() == key).unwrap().outcome()
}
