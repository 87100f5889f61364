//! The chapters of the book as documentation tests: a Rust block in a chapter compiles and runs, unless it is code
//! included from an example (`rust,ignore`, compiled there). `cargo book labels` writes the list from `SUMMARY.md`.

macro_rules! chapters {
    ($($name:ident: $file:literal,)*) => {
        $(#[doc = include_str!(concat!("../book/src/", $file))]
        mod $name {})*
    };
}

chapters! {
    // chapters
    readme: "../../README.md",
    introduction: "introduction.md",
    notation: "notation.md",
    section_2_elastic_contact: "section_2_elastic_contact.md",
    section_2_scalar_contact: "section_2_scalar_contact.md",
    your_own_body: "your_own_body.md",
    remark_1: "remark_1.md",
    section_4_midpoint_cone: "section_4_midpoint_cone.md",
    section_1_norms: "section_1_norms.md",
    test_problems: "test_problems.md",
    introduction_rates: "introduction_rates.md",
    falk: "falk.md",
    remark_2: "remark_2.md",
    figure_3_2_alternative: "figure_3_2_alternative.md",
    figure_4_1_alternative: "figure_4_1_alternative.md",
    lemma_5_2: "lemma_5_2.md",
    theorem_3_1_rates: "theorem_3_1_rates.md",
    figure_3_1: "figure_3_1.md",
    theorem_4_1_rates: "theorem_4_1_rates.md",
    worst_contact_set: "worst_contact_set.md",
    lemma_5_1: "lemma_5_1.md",
    lemma_5_2_induction: "lemma_5_2_induction.md",
    remark_5: "remark_5.md",
    remark_6: "remark_6.md",
    remark_7: "remark_7.md",
    lemma_6_1: "lemma_6_1.md",
    equation_6_2: "equation_6_2.md",
    lemma_6_1_on_triangles: "lemma_6_1_on_triangles.md",
    lemma_6_2: "lemma_6_2.md",
    section_4_p0_projection: "section_4_p0_projection.md",
    remark_4: "remark_4.md",
    section_3_embeddings: "section_3_embeddings.md",
    theorem_3_1_proof: "theorem_3_1_proof.md",
    theorem_4_1_proof: "theorem_4_1_proof.md",
    theta_balance: "theta_balance.md",
    equation_3_2_logarithm: "equation_3_2_logarithm.md",
    remark_3_face: "remark_3_face.md",
    remark_7_rearrangement: "remark_7_rearrangement.md",
    lemma_5_2_exact_law: "lemma_5_2_exact_law.md",
    segment_constants: "segment_constants.md",
    theorem_3_1_without_c: "theorem_3_1_without_c.md",
    theorem_3_1_with_numbers: "theorem_3_1_with_numbers.md",
    contact_costs_nothing: "contact_costs_nothing.md",
    section_1_norms_in_the_plane: "section_1_norms_in_the_plane.md",
    section_1_closures_in_the_plane: "section_1_closures_in_the_plane.md",
    section_1_trace_constants: "section_1_trace_constants.md",
    section_1_errors_and_boundaries: "section_1_errors_and_boundaries.md",
    section_2_singular_exponents: "section_2_singular_exponents.md",
    section_1_clamped_end: "section_1_clamped_end.md",
    section_2_strip: "section_2_strip.md",
    speed_for_accuracy: "speed_for_accuracy.md",
    extremes: "extremes.md",
    toolkit: "toolkit.md",
    tour: "tour.md",
    every_label: "every_label.md",
    errata: "errata.md",
    after_2012: "after_2012.md",
    lemma_cards: "lemma_cards.md",
    sessions: "sessions.md",
    bibliography: "bibliography.md",
    // end of chapters
}
