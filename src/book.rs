//! The chapters of the book as documentation tests: every Rust block of a chapter is compiled and run, except code
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
    prerequisites: "prerequisites.md",
    section_2_elastic_contact: "section_2_elastic_contact.md",
    falk: "falk.md",
    lemma_6_1: "lemma_6_1.md",
    figure_3_2_alternative: "figure_3_2_alternative.md",
    lemma_5_2: "lemma_5_2.md",
    theorem_3_1_rates: "theorem_3_1_rates.md",
    worst_contact_set: "worst_contact_set.md",
    two_sided_energies: "two_sided_energies.md",
    by_hand: "by_hand.md",
    glossary: "glossary.md",
    notation: "notation.md",
    teaching: "teaching.md",
    section_1_norms: "section_1_norms.md",
    section_4_midpoint_cone: "section_4_midpoint_cone.md",
    section_2_scalar_contact: "section_2_scalar_contact.md",
    remark_2: "remark_2.md",
    lemma_6_2: "lemma_6_2.md",
    lemma_6_1_on_triangles: "lemma_6_1_on_triangles.md",
    lemma_5_2_limits: "lemma_5_2_limits.md",
    lemma_5_2_induction: "lemma_5_2_induction.md",
    remark_7: "remark_7.md",
    section_4_p0_projection: "section_4_p0_projection.md",
    theorem_3_1_measured: "theorem_3_1_measured.md",
    theorem_4_1_rates: "theorem_4_1_rates.md",
    theta_balance: "theta_balance.md",
    theorem_3_1_proof: "theorem_3_1_proof.md",
    figure_3_1: "figure_3_1.md",
    remark_3_face: "remark_3_face.md",
    segment_constants: "segment_constants.md",
    lemma_5_2_exact_law: "lemma_5_2_exact_law.md",
    theorem_3_1_without_c: "theorem_3_1_without_c.md",
    contact_costs_nothing: "contact_costs_nothing.md",
    rate_of_the_bound: "rate_of_the_bound.md",
    finite_contact_set: "finite_contact_set.md",
    bound_from_the_data: "bound_from_the_data.md",
    section_1_trace_constants: "section_1_trace_constants.md",
    section_2_singular_exponents: "section_2_singular_exponents.md",
    section_1_clamped_end: "section_1_clamped_end.md",
    your_own_body: "your_own_body.md",
    section_2_strip: "section_2_strip.md",
    toolkit: "toolkit.md",
    resolved_once: "resolved_once.md",
    from_python: "from_python.md",
    section_1_norms_in_the_plane: "section_1_norms_in_the_plane.md",
    fractional_laplacian: "fractional_laplacian.md",
    speed_for_accuracy: "speed_for_accuracy.md",
    beside_peers: "beside_peers.md",
    what_is_proved: "what_is_proved.md",
    every_label: "every_label.md",
    errata: "errata.md",
    after_2012: "after_2012.md",
    bibliography: "bibliography.md",
    // end of chapters
}
