//! Figure 3.2: every contact segment of a computed solution is in the first or the second case.

use signorini::analysis::{AlternativeStudy, EdgeTrace, Interval, NearVertices, Section, ThetaRule};
use signorini::scenes::Scene;

#[allow(dead_code)]
#[path = "../examples/figure_3_2_alternative.rs"]
mod figure_3_2_alternative;

#[test]
fn every_segment_of_the_block_is_in_a_case() {
    for (scene, tau) in
        [(Scene::Block, 1.75), (Scene::Block, 2.0), (Scene::Membrane, 1.6), (Scene::Membrane, 2.0)]
    {
        let study = AlternativeStudy::new(Section::Three, scene, 16, ThetaRule::Printed { tau }).unwrap();
        for row in study.rows() {
            let found = &row.classification;
            assert_eq!(found.count("none"), 0, "{scene} tau {tau} n {}", row.n);
            let counted: usize = ["first", "second", "both"].iter().map(|case| found.count(case)).sum();
            assert_eq!(counted, row.n, "{scene} tau {tau} n {}", row.n);
            assert!(
                found.segments().iter().all(|s| s.term >= 0.0),
                "{scene}: a consistency term is negative"
            );
        }
    }
}

#[test]
fn the_example_confirms_the_figure() {
    let options = figure_3_2_alternative::Options::default();
    let headline = figure_3_2_alternative::run(&options).unwrap();
    assert!(headline.verdict.is_confirmed());
    // block touches on [0, 0.33]: on 32 segments the ten inside are first cases, the rest second cases
    assert_eq!(headline.table.number(2, "first"), Some(10.0));
    assert_eq!(headline.table.number(2, "second"), Some(22.0));
}

#[test]
fn classification_agrees_with_the_definition_point_by_point() {
    // Contact sets of random runs on 64 nodes, classified by looking at every point of a fine grid.
    let mut state = 2012_u64;
    let mut random = move || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 33) as f64 / (1u64 << 31) as f64
    };
    const NODES: usize = 64;
    const GRID: usize = 320 * NODES; // a single touching node is a grid point
    for case in 0..200 {
        let nodes: Vec<f64> = (0..=NODES).map(|i| i as f64 / NODES as f64).collect();
        let mut touching = random() < 0.5;
        let contact: Vec<bool> = nodes
            .iter()
            .map(|_| {
                touching = if random() < 0.1 { !touching } else { touching };
                touching
            })
            .collect();
        let displacement = contact.iter().map(|&c| if c { 0.0 } else { -1.0 }).collect();
        let force = contact.iter().map(|&c| f64::from(u8::from(c))).collect();
        let trace = EdgeTrace::new(nodes, displacement, force, 0.0).unwrap();
        // no grid point within rounding of a limit: theta is not a multiple of the grid
        let theta = 0.013 + 0.9 * random();
        let found = NearVertices::new(theta).unwrap().classify(&trace, Interval { start: 0.0, end: 1.0 });
        let zero_at = |x: f64| trace.displacement_at(x) == 0.0;
        let near = |from_right: bool| {
            (0..GRID)
                .map(|k| k as f64 / GRID as f64)
                .take_while(|&d| d < theta)
                .any(|d| zero_at(if from_right { 1.0 - d } else { d }))
        };
        assert_eq!(found.first, near(false) && near(true), "case {case}, theta {theta}");
        assert!(found.first || found.second, "case {case}, theta {theta}");
    }
}
