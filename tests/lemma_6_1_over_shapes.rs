//! Lemma 6.1 over shapes: the default map, the blow-up of needles by hand, and planted faults.

#[allow(dead_code)]
#[path = "../examples/lemma_6_1_over_shapes.rs"]
mod example;

use example_frame::Outcome;

#[test]
fn large_angles_do_harm_and_below_one_small_ones_too() {
    let headline = example::run(&example::Options::default()).unwrap();
    assert!(headline.verdict().is_confirmed(), "{headline}");
}

#[test]
fn a_wrong_constant_is_seen() {
    let options = example::Options {
        s: vec!["0.6".parse().unwrap()],
        angles: vec![20.0, 60.0, 135.0],
        ..example::Options::default()
    };
    let outcome = |rows: &[example::Row], key: &str| {
        let found = example::findings(rows);
        found.iter().find(|finding| finding.key() == key).unwrap().outcome()
    };
    let sound = example::compute(&options).unwrap();
    for key in ["digits", "kobayashi", "flat", "needle"] {
        assert_eq!(outcome(&sound, key), Outcome::Holds, "{key}");
    }
    let spoiled = |key: &str, row: usize, order: usize, factor: f64| {
        let mut rows = sound.clone();
        rows[row].constants[order].value *= factor;
        assert_eq!(outcome(&rows, key), Outcome::Refuted, "{key}");
    };
    spoiled("kobayashi", 1, 1, 1.1);
    spoiled("flat", 2, 0, 0.3);
    spoiled("needle", 0, 0, 0.7);
    let mut rows = sound.clone();
    rows[0].constants[0].error = 0.1;
    assert_eq!(outcome(&rows, "digits"), Outcome::Refuted);
    let bad = example::Options { angles: vec![60.0, 179.0], ..options };
    assert!(example::compute(&bad).is_err());
}
