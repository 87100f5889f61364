//! The example `lemma_5_1_peetre_tartar` confirms its statement.

#[path = "../examples/lemma_5_1_peetre_tartar.rs"]
#[allow(dead_code)]
mod example;

#[test]
fn statement_is_confirmed() {
    let headline = example::run(&example::Options::default()).unwrap();
    assert!(headline.verdict.is_confirmed(), "{headline}");
}
