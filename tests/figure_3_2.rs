//! Figure 3.2: every contact segment of a computed solution is in the first or the second case.

use signorini::edge::{EdgeTrace, Interval};

use experiments::proof::{Against, AlternativeCase};
use signorini::problems::{NamedProblem, TestProblem};
use signorini::proof::{Alternative, Section, ThetaRule};

#[allow(dead_code)]
#[path = "../examples/figure_3_2_alternative.rs"]
mod figure_3_2_alternative;

#[test]
fn every_segment_of_the_block_is_in_a_case() {
    for (scene, tau) in [
        (TestProblem::Block, 1.75),
        (TestProblem::Block, 2.0),
        (TestProblem::Membrane, 1.6),
        (TestProblem::Membrane, 2.0),
    ] {
        let study =
            AlternativeCase::new(Section::Three, scene, 16, ThetaRule::Printed { tau }).over_size().unwrap();
        for row in &study.rows {
            let found = &row.classification;
            assert_eq!(found.count(Alternative::Neither), 0, "{scene} tau {tau} n {}", row.n);
            let counted: usize = [Alternative::First, Alternative::Second, Alternative::Both]
                .map(|case| found.count(case))
                .iter()
                .sum();
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
    assert!(headline.verdict().is_confirmed());
    // block touches on [0, 0.33]: on 32 segments the ten inside are first cases, the rest second cases
    assert_eq!(headline.table.number(2, "first"), Some(10.0));
    assert_eq!(headline.table.number(2, "second"), Some(22.0));
}

#[test]
fn a_term_that_is_zero_has_no_share_and_says_so() {
    let options = figure_3_2_alternative::Options {
        scene: NamedProblem::Mesh(TestProblem::Free),
        n: 8,
        meshes: 2,
        ..Default::default()
    };
    let headline = figure_3_2_alternative::run(&options).unwrap();
    let share = headline.finding("second.carries").unwrap();
    assert!(share.measured().is_none() && share.comparison().contains("term is zero"), "{share:?}");
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
        let edge = Interval { start: 0.0, end: 1.0 };
        let found = Alternative::on_segment(Section::Three, &trace, edge, theta).unwrap();
        let zero_at = |x: f64| trace.displacement_at(x) == 0.0;
        let near = |from_right: bool| {
            (0..GRID)
                .map(|k| k as f64 / GRID as f64)
                .take_while(|&d| d < theta)
                .any(|d| zero_at(if from_right { 1.0 - d } else { d }))
        };
        assert_eq!(found.first(), near(false) && near(true), "case {case}, theta {theta}");
        assert!(found.first() || found.second(), "case {case}, theta {theta}");
    }
}

#[test]
fn every_segment_of_a_strip_scene_is_in_a_case() {
    for (scene, tau) in
        [("transition", 1.75), ("transitions:9", 1.6), ("cantor:0.3", 1.9), ("fat-cantor", 1.75)]
    {
        for against in [Against::Reference, Against::Itself] {
            let source: NamedProblem = scene.parse().unwrap();
            let rule = ThetaRule::Printed { tau };
            let case = AlternativeCase {
                meshes: 6,
                tau,
                against,
                ..AlternativeCase::new(Section::Three, source, 256, rule)
            };
            for row in case.over_size().unwrap().rows.iter().chain(&case.over_theta().unwrap().rows) {
                let found = &row.classification;
                assert_eq!(
                    found.count(Alternative::Neither),
                    0,
                    "{scene} {against} n {} theta {}",
                    row.n,
                    row.theta
                );
                assert_eq!(found.segments().len(), row.n);
                // The nodal solution has no consistency term of its own: lambda_i u_i = 0 at every node.
                if against == Against::Itself {
                    assert_eq!(found.total(), 0.0, "{scene} n {}", row.n);
                } else {
                    assert!(found.segments().iter().all(|s| s.term >= 0.0));
                    // on coarse meshes every vertex in a gap may have no contact beside it
                    assert!(row.n < 256 || found.total() > 0.0, "{scene} n {}", row.n);
                }
            }
        }
    }
}

#[test]
fn a_smaller_theta_moves_segments_out_of_the_first_case_and_into_the_second() {
    let case = AlternativeCase {
        meshes: 1,
        ..AlternativeCase::new(
            Section::Three,
            "fat-cantor".parse::<NamedProblem>().unwrap(),
            128,
            ThetaRule::Fixed(0.5),
        )
    };
    let study = case.over_theta().unwrap();
    let first =
        |c: &signorini::proof::Classification| c.count(Alternative::First) + c.count(Alternative::Both);
    let second =
        |c: &signorini::proof::Classification| c.count(Alternative::Second) + c.count(Alternative::Both);
    for pair in study.rows.windows(2) {
        assert!(first(&pair[0].classification) >= first(&pair[1].classification));
        assert!(second(&pair[0].classification) <= second(&pair[1].classification));
    }
}

/// u_N = 0 and sigma_N = -1 on the given intervals of [0, 1], with a node at every multiple of 1/64.
fn trace(contact: &[(f64, f64)]) -> EdgeTrace {
    let nodes: Vec<f64> = (0..=64).map(|i| f64::from(i) / 64.0).collect();
    let touching = |x: f64| contact.iter().any(|&(a, b)| x >= a && x <= b);
    let displacement = nodes.iter().map(|&x| if touching(x) { 0.0 } else { -1.0 }).collect();
    let force = nodes.iter().map(|&x| if touching(x) { 1.0 } else { 0.0 }).collect();
    EdgeTrace::new(nodes, displacement, force, 0.0).unwrap()
}

/// A name, the contact set of the edge, the expected case.
type Expected<'a> = (&'a str, &'a [(f64, f64)], Alternative);

#[test]
fn degenerate_segments_have_the_expected_class() {
    // the segment [1/4, 3/4], theta = 1/4: pieces of length 1/8 at the vertices
    let segment = Interval { start: 0.25, end: 0.75 };
    let cases: [Expected; 10] = [
        ("full contact", &[(0.0, 1.0)], Alternative::First),
        ("no contact", &[], Alternative::Second),
        ("contact elsewhere only", &[(0.0, 0.1875), (0.8125, 1.0)], Alternative::Second),
        ("contact up to the left vertex, transition at a node", &[(0.0, 0.25)], Alternative::Second),
        ("contact from the right vertex on", &[(0.75, 1.0)], Alternative::Second),
        ("transition at either vertex", &[(0.0, 0.25), (0.75, 1.0)], Alternative::Both),
        ("one contact point in the middle", &[(0.5, 0.5)], Alternative::Second),
        (
            "two contact points, one near each vertex",
            &[(0.3125, 0.3125), (0.6875, 0.6875)],
            Alternative::First,
        ),
        ("contact begins exactly at distance h theta", &[(0.375, 0.75)], Alternative::Second),
        ("contact begins one cell before that", &[(0.359375, 0.75)], Alternative::First),
    ];
    for (name, contact, expected) in cases {
        let found = Alternative::on_segment(Section::Three, &trace(contact), segment, 0.25);
        assert_eq!(found.unwrap(), expected, "{name}");
    }
}

#[test]
fn bad_studies_are_refused() {
    let rule = ThetaRule::Printed { tau: 1.75 };
    let strip = |n, meshes| AlternativeCase {
        meshes,
        ..AlternativeCase::new(Section::Three, "transition".parse::<NamedProblem>().unwrap(), n, rule)
    };
    for case in [strip(0, 1), strip(48, 2), strip(8, 5), strip(1 << 15, 3), strip(8, 0)] {
        assert!(case.over_size().is_err() && case.over_theta().is_err());
    }
    assert!(AlternativeCase::new(Section::Three, TestProblem::Block, 512, rule).over_size().is_err());
    assert!("cliff".parse::<NamedProblem>().is_err() && "both".parse::<Against>().is_err());
}
