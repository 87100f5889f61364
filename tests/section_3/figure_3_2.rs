//! Figure 3.2: every contact segment of a computed solution is in the first or the second case.

use signorini::cone::Cone;
use signorini::edge::{EdgeTrace, Interval};
use signorini::problems::{NamedProblem, TestProblem};
use signorini::proof::{Alternative, Classification, Section, ThetaRule};

#[allow(dead_code)]
#[path = "../../examples/figure_3_2_alternative.rs"]
mod figure_3_2_alternative;

fn classified(trace: &EdgeTrace, n: usize, theta: f64) -> Classification {
    let vertices: Vec<f64> = (0..=n).map(|i| i as f64 / n as f64).collect();
    Classification::new(Section::Three, trace, &vertices, theta).unwrap()
}

#[test]
fn every_segment_of_the_block_is_in_a_case() {
    for (scene, tau) in [
        (TestProblem::Block, 1.75),
        (TestProblem::Block, 2.0),
        (TestProblem::Membrane, 1.6),
        (TestProblem::Membrane, 2.0),
    ] {
        let trace = EdgeTrace::reference(&scene.into(), 16, tau).unwrap();
        for n in [4, 8, 16] {
            let theta = ThetaRule::Printed { tau }.theta(1.0 / n as f64).unwrap();
            let found = classified(&trace, n, theta);
            assert_eq!(found.count(Alternative::Neither), 0, "{scene} tau {tau} n {n}");
            let terms = found.segments().iter().map(|s| s.term);
            assert!(terms.clone().all(|term| term >= 0.0), "{scene}: a consistency term is negative");
            // The example compares lengths where the library looks for zeros and pieces.
            for theirs in found.segments() {
                let case = theirs.alternative;
                let (own, _) = figure_3_2_alternative::cases(&trace, theirs.segment, theta);
                assert_eq!(own, [case.first(), case.second()], "{scene} n {n} {:?}", theirs.segment);
            }
        }
    }
}

#[test]
fn a_body_without_contact_carries_nothing() {
    let options = figure_3_2_alternative::Options {
        problem: NamedProblem::Mesh(TestProblem::Free),
        n: vec![4, 8],
        ..Default::default()
    };
    let outcome = figure_3_2_alternative::outcome(&options).unwrap();
    assert_eq!([outcome.value("integral.n8"), outcome.value("carried_by.n8")], [Some(0.0); 2]);
    assert_eq!(outcome.value("second.n8"), Some(8.0));
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
        let (example, _) = figure_3_2_alternative::cases(&trace, edge, theta);
        assert_eq!(example, [found.first(), found.second()], "case {case}, theta {theta}");
    }
}

#[test]
fn every_segment_of_a_strip_problem_is_in_a_case() {
    for (scene, tau) in
        [("transition", 1.75), ("transitions:9", 1.6), ("cantor:0.3", 1.9), ("fat-cantor", 1.75)]
    {
        let source: NamedProblem = scene.parse().unwrap();
        let reference = EdgeTrace::reference(&source, 256, tau).unwrap();
        for n in [8, 16, 32, 64, 128, 256] {
            let own = EdgeTrace::discrete(&source, n, tau, Cone::Nodal).unwrap();
            let printed = ThetaRule::Printed { tau }.theta(1.0 / n as f64).unwrap();
            let sweep = (1..=12).map(|k| 0.5f64.powi(k)).filter(|_| n == 256);
            for theta in sweep.chain([printed]) {
                let found = classified(&reference, n, theta);
                assert_eq!(found.count(Alternative::Neither), 0, "{scene} n {n} theta {theta}");
                assert!(found.segments().len() == n && found.segments().iter().all(|s| s.term >= 0.0));
                // on coarse meshes every vertex in a gap may have no contact beside it
                assert!(n < 256 || found.total() > 0.0, "{scene} n {n}");
                // The nodal solution has no consistency term of its own: lambda_i u_i = 0 at every node.
                let found = classified(&own, n, theta);
                assert_eq!(found.count(Alternative::Neither), 0, "{scene} itself n {n} theta {theta}");
                assert_eq!(found.total(), 0.0, "{scene} n {n}");
            }
        }
    }
}

#[test]
fn a_smaller_theta_moves_segments_out_of_the_first_case_and_into_the_second() {
    let trace = EdgeTrace::reference(&"fat-cantor".parse().unwrap(), 128, 1.75).unwrap();
    let count = |theta: f64, case: Alternative| {
        let found = classified(&trace, 128, theta);
        found.count(case) + found.count(Alternative::Both)
    };
    for k in 1..12 {
        let (large, small) = (0.5f64.powi(k), 0.5f64.powi(k + 1));
        assert!(count(large, Alternative::First) >= count(small, Alternative::First));
        assert!(count(large, Alternative::Second) <= count(small, Alternative::Second));
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
