//! Remark 3: quotients on one face, and planted faults.

#[allow(dead_code)]
#[path = "../examples/remark_3_face.rs"]
mod example;

use example_frame::Outcome;
use experiments::proof::FaceGaps;
use fractional_sobolev::{Order, Tolerance};

#[test]
fn the_nodal_quotient_grows_and_the_mean_quotient_falls() {
    let headline = example::run(&example::Options::default()).unwrap();
    assert!(headline.verdict().is_confirmed(), "{headline}");
    assert!(FaceGaps::new(3, Order::HALF, Tolerance::fast()).is_err());
}

#[test]
fn planted_faults_are_seen() {
    let sound =
        || example::compute(&example::Options { halvings: 12, ..example::Options::default() }).unwrap();
    let outcome = |rows: &[example::Rows], key: &str| {
        let found = example::findings(rows);
        found.iter().find(|finding| finding.key() == key).unwrap().outcome()
    };
    for key in ["exponent", "nodal", "mean"] {
        assert_eq!(outcome(&sound(), key), Outcome::Holds, "{key}");
    }
    let mut rows = sound();
    rows[0].1.iter_mut().fold(1.0, |factor, gaps| {
        gaps.nodal.value *= factor;
        1.1 * factor
    });
    assert_eq!(outcome(&rows, "exponent"), Outcome::Refuted);
    let mut rows = sound();
    rows[0].1[11].nodal.value = rows[0].1[10].nodal.value * 0.9;
    assert_eq!(outcome(&rows, "nodal"), Outcome::Refuted);
    let mut rows = sound();
    rows[1].1[5].mean.value = 1.1 * rows[1].1[0].mean.value;
    assert_eq!(outcome(&rows, "mean"), Outcome::Refuted);
}
