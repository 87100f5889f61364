//! Figure 4.1: the contact set of every segment of a computed solution has a diameter below or above h_e θ.

use signorini::analysis::{AlternativeStudy, Section, ThetaRule};
use signorini::scenes::Scene;

#[allow(dead_code)]
#[path = "../examples/figure_4_1_alternative.rs"]
mod figure_4_1_alternative;

#[test]
fn first_cases_carry_no_pressure_far_from_the_contact_set() {
    // In the first case the term is at most the whole force of a set of diameter h_e θ; in an open segment it is 0.
    for (scene, tau) in [(Scene::Block, 1.75), (Scene::Membrane, 2.0)] {
        let study = AlternativeStudy::new(Section::Four, scene, 16, ThetaRule::Printed { tau }).unwrap();
        for row in study.rows() {
            let found = &row.classification;
            assert_eq!(found.count("none"), 0, "{scene} tau {tau} n {}", row.n);
            assert_eq!(found.segments().len(), row.n);
            assert!(
                found.segments().iter().all(|s| s.term >= 0.0),
                "{scene}: a consistency term is negative"
            );
        }
    }
}

#[test]
fn theta_moves_segments_from_the_second_to_the_first_case() {
    let count = |theta: f64| {
        let study = AlternativeStudy::new(Section::Four, Scene::Block, 16, ThetaRule::Fixed(theta)).unwrap();
        study.rows()[2].classification.count("first")
    };
    let counts = [0.01, 0.2, 0.6, 0.95].map(count);
    assert!(counts.windows(2).all(|pair| pair[0] <= pair[1]), "{counts:?}");
}

#[test]
fn the_example_confirms_the_figure() {
    let options = figure_4_1_alternative::Options::default();
    let headline = figure_4_1_alternative::run(&options).unwrap();
    assert!(headline.verdict.is_confirmed());
    // block touches on [0, 0.33]: ten segments inside and the one that holds the transition are second cases
    assert_eq!(headline.table.number(2, "second"), Some(11.0));
    assert_eq!(headline.table.number(2, "first"), Some(21.0));
}
