//! Every example at its default size: every claim holds, and every check, its number moved across its bound, turns
//! its mark, the status and the exit code. `cargo book labels` writes the list of examples.

#![allow(clippy::duplicate_mod, reason = "twins and the tour share files, and every example is loaded")]

use example_report::{Decision, Outcome, Role, Verdict};
use std::collections::BTreeSet;

/// Lines and columns of a terminal.
const SCREEN: (usize, usize) = (40, 100);

/// What a check moved to `decision` must do to the status, where all other claims hold.
fn follows(role: Role, decision: Decision, outcome: &Outcome) -> bool {
    let status = outcome.status();
    match (role, decision) {
        (Role::Claim, Decision::Fails) => outcome.exit_code() == 1 && status == Verdict::Fails,
        (Role::Claim, Decision::Undecided) => outcome.exit_code() == 1 && status == Verdict::Undecided,
        (Role::AsPrinted, Decision::Fails) => outcome.exit_code() == 0 && status == Verdict::FalseAsPrinted,
        (Role::NotSharp, Decision::Holds) => {
            outcome.exit_code() == 0 && matches!(status, Verdict::NotSharp | Verdict::FalseAsPrinted)
        }
        (Role::Stronger, Decision::Holds) => {
            outcome.exit_code() == 0 && !matches!(status, Verdict::True | Verdict::Open)
        }
        _ => outcome.exit_code() == 0,
    }
}

fn every_check_turns(outcome: &Outcome) {
    let text = outcome.text(false);
    assert_eq!(outcome.exit_code(), 0, "{text}");
    assert!(text.lines().count() <= SCREEN.0, "{} lines:\n{text}", text.lines().count());
    let wide = text.lines().filter(|line| line.chars().count() > SCREEN.1).collect::<Vec<_>>();
    assert!(wide.is_empty(), "wider than a terminal: {wide:?}");
    let keys: BTreeSet<String> = outcome.checks().iter().map(example_report::Checked::key).collect();
    assert_eq!(keys.len(), outcome.checks().len(), "two checks with one key:\n{text}");
    for (at, check) in outcome.checks().iter().enumerate() {
        let label = format!("{} / {}: {}", outcome.label(), check.key(), check.comparison());
        if check.decision() == Decision::ByProof {
            continue;
        }
        assert!(!check.source().is_empty(), "a bound without a source: {label}");
        let mut said = BTreeSet::new();
        for wanted in [Decision::Holds, Decision::Fails, Decision::Undecided] {
            let moved = check.moved(wanted);
            assert_eq!(moved.decision(), wanted, "{label}: {}", moved.comparison());
            said.insert(format!("{} {}", wanted.mark(), moved.comparison()));
            let changed = outcome.with_check(at, moved);
            assert!(follows(check.role(), wanted, &changed), "{label}: {wanted:?}: {}", changed.status());
        }
        assert_eq!(said.len(), 3, "the same line for different decisions: {label}: {said:?}");
    }
}

macro_rules! examples {
    ($($name:ident: $file:literal),* $(,)?) => {
        $(#[path = $file] #[allow(dead_code, reason = "only `outcome` is used here")] mod $name;)*

        $(#[test]
        fn $name() {
            every_check_turns(&$name::outcome(&$name::Options::default()).unwrap());
        })*
    };
}

examples! {
    // examples
    contact_costs_nothing: "../examples/contact_costs_nothing.rs",
    equation_3_2_logarithm: "../examples/equation_3_2_logarithm.rs",
    equation_6_2_mean: "../examples/equation_6_2_mean.rs",
    extremes: "../examples/extremes.rs",
    falk_terms: "../examples/falk_terms.rs",
    figure_3_1: "../examples/figure_3_1.rs",
    figure_3_2_alternative: "../examples/figure_3_2_alternative.rs",
    figure_4_1_alternative: "../examples/figure_4_1_alternative.rs",
    introduction_rates: "../examples/introduction_rates.rs",
    lemma_5_1_peetre_tartar: "../examples/lemma_5_1_peetre_tartar.rs",
    lemma_5_2_exact_law: "../examples/lemma_5_2_exact_law.rs",
    lemma_5_2_induction: "../examples/lemma_5_2_induction.rs",
    lemma_5_2_poincare_scaling: "../examples/lemma_5_2_poincare_scaling.rs",
    lemma_6_1_local_estimate: "../examples/lemma_6_1_local_estimate.rs",
    lemma_6_1_on_triangles: "../examples/lemma_6_1_on_triangles.rs",
    lemma_6_2_global_estimate: "../examples/lemma_6_2_global_estimate.rs",
    remark_1_whole_boundary: "../examples/remark_1_whole_boundary.rs",
    remark_2_dual_norm_counterexample: "../examples/remark_2_dual_norm_counterexample.rs",
    remark_3_face: "../examples/remark_3_face.rs",
    remark_4_saturation: "../examples/remark_4_saturation.rs",
    remark_5_log_counterexample: "../examples/remark_5_log_counterexample.rs",
    remark_6_point_condition: "../examples/remark_6_point_condition.rs",
    remark_7_rearrangement: "../examples/remark_7_rearrangement.rs",
    remark_7_zone_location: "../examples/remark_7_zone_location.rs",
    section_1_clamped_end: "../examples/section_1_clamped_end.rs",
    section_1_closures_in_the_plane: "../examples/section_1_closures_in_the_plane.rs",
    section_1_field_errors: "../examples/section_1_field_errors.rs",
    section_1_fractional_norms: "../examples/section_1_fractional_norms.rs",
    section_1_norms_in_the_plane: "../examples/section_1_norms_in_the_plane.rs",
    section_1_polygon_norms: "../examples/section_1_polygon_norms.rs",
    section_1_trace_constants: "../examples/section_1_trace_constants.rs",
    section_2_elastic_contact: "../examples/section_2_elastic_contact.rs",
    section_2_multigrid: "../examples/section_2_multigrid.rs",
    section_2_own_body: "../examples/section_2_own_body.rs",
    section_2_regularity: "../examples/section_2_regularity.rs",
    section_2_scalar_contact: "../examples/section_2_scalar_contact.rs",
    section_2_singular_exponents: "../examples/section_2_singular_exponents.rs",
    section_2_speed_for_accuracy: "../examples/section_2_speed_for_accuracy.rs",
    section_2_strip: "../examples/section_2_strip.rs",
    section_3_embedding_constants: "../examples/section_3_embedding_constants.rs",
    section_4_p0_projection: "../examples/section_4_p0_projection.rs",
    segment_constants: "../examples/segment_constants.rs",
    speed_for_accuracy: "../examples/speed_for_accuracy.rs",
    theorem_3_1_proof_profile: "../examples/theorem_3_1_proof_profile.rs",
    theorem_3_1_rates: "../examples/theorem_3_1_rates.rs",
    theorem_3_1_with_numbers: "../examples/theorem_3_1_with_numbers.rs",
    theorem_3_1_without_c: "../examples/theorem_3_1_without_c.rs",
    theorem_4_1_proof_profile: "../examples/theorem_4_1_proof_profile.rs",
    theorem_4_1_rates: "../examples/theorem_4_1_rates.rs",
    theta_balance: "../examples/theta_balance.rs",
    tour: "../examples/tour.rs",
    worst_contact_set: "../examples/worst_contact_set.rs",
    // end of examples
}
