//! Figure 4.1: the contact set of every segment of a computed solution has a diameter below or above h_e θ.

use signorini::cone::Cone;
use signorini::edge::{EdgeTrace, Interval};
use signorini::problems::{NamedProblem, TestProblem};
use signorini::proof::{Alternative, Classification, Section, ThetaRule};

#[allow(dead_code)]
#[path = "../../examples/figure_4_1_alternative.rs"]
mod figure_4_1_alternative;

fn classified(trace: &EdgeTrace, n: usize, theta: f64) -> Classification {
    let vertices: Vec<f64> = (0..=n).map(|i| i as f64 / n as f64).collect();
    Classification::new(Section::Four, trace, &vertices, theta).unwrap()
}

#[test]
fn first_cases_carry_no_pressure_far_from_the_contact_set() {
    // In the first case the term is at most the whole force of a set of diameter h_e θ; in an open segment it
    // is 0. The example counts a segment as a first case only where the pressure lives on such a set.
    for (scene, tau) in [(TestProblem::Block, 1.75), (TestProblem::Membrane, 2.0)] {
        let trace = EdgeTrace::reference(&scene.into(), 16, tau).unwrap();
        for n in [4, 8, 16] {
            let theta = ThetaRule::Printed { tau }.theta(1.0 / n as f64).unwrap();
            let found = classified(&trace, n, theta);
            assert_eq!(found.count(Alternative::Neither), 0, "{scene} tau {tau} n {n}");
            for theirs in found.segments() {
                let case = theirs.alternative;
                let own = figure_4_1_alternative::cases(&trace, theirs.segment, theta);
                assert_eq!(own, [case.first(), case.second()], "{scene} n {n} {:?}", theirs.segment);
                assert!(theirs.term >= 0.0, "{scene}: a consistency term is negative");
            }
        }
    }
}

#[test]
fn theta_moves_segments_from_the_second_to_the_first_case() {
    let trace = EdgeTrace::reference(&TestProblem::Block.into(), 16, 1.75).unwrap();
    let counts = [0.01, 0.2, 0.6, 0.95].map(|theta| classified(&trace, 16, theta).count(Alternative::First));
    assert!(counts.windows(2).all(|pair| pair[0] <= pair[1]), "{counts:?}");
}

#[test]
fn every_segment_of_a_strip_problem_is_in_a_case() {
    for (scene, tau) in
        [("transition", 1.75), ("transitions:9", 1.6), ("cantor:0.3", 1.9), ("fat-cantor", 1.75)]
    {
        let source: NamedProblem = scene.parse().unwrap();
        let reference = EdgeTrace::reference(&source, 256, tau).unwrap();
        for n in [8, 16, 32, 64, 128, 256] {
            let own = EdgeTrace::discrete(&source, n, tau, Cone::Midpoint).unwrap();
            let printed = ThetaRule::Printed { tau }.theta(1.0 / n as f64).unwrap();
            let sweep = (1..=12).map(|k| 0.5f64.powi(k)).filter(|_| n == 256);
            for theta in sweep.chain([printed]) {
                for trace in [&reference, &own] {
                    let found = classified(trace, n, theta);
                    assert_eq!(found.count(Alternative::Neither), 0, "{scene} n {n} theta {theta}");
                    assert!(found.segments().iter().all(|s| s.term >= 0.0), "{scene} n {n}");
                }
            }
        }
    }
}

/// A name, the contact set of the edge, the expected case.
type Expected<'a> = (&'a str, &'a [(f64, f64)], Alternative);

#[test]
fn degenerate_segments_have_the_expected_class() {
    let nodes: Vec<f64> = (0..=64).map(|i| f64::from(i) / 64.0).collect();
    // the segment [1/4, 3/4], theta = 1/4: h_e theta = 1/8
    let segment = Interval { start: 0.25, end: 0.75 };
    let cases: [Expected; 9] = [
        ("full contact", &[(0.0, 1.0)], Alternative::Second),
        ("no contact", &[], Alternative::First),
        ("one contact point", &[(0.5, 0.5)], Alternative::First),
        (
            "the contact set of the edge is that point and another elsewhere",
            &[(0.5, 0.5), (0.9, 1.0)],
            Alternative::First,
        ),
        ("contact ends exactly at a vertex: one point", &[(0.0, 0.25)], Alternative::First),
        ("a point at either vertex", &[(0.0, 0.25), (0.75, 1.0)], Alternative::Second),
        ("transition exactly at a node, diameter equal to h theta", &[(0.0, 0.375)], Alternative::Both),
        ("one cell less", &[(0.0, 0.359375)], Alternative::First),
        ("two pieces further apart", &[(0.25, 0.25), (0.5, 0.5)], Alternative::Second),
    ];
    for (name, contact, expected) in cases {
        let touching = |x: f64| contact.iter().any(|&(a, b)| x >= a && x <= b);
        let displacement = nodes.iter().map(|&x| if touching(x) { 0.0 } else { -1.0 }).collect();
        let force = nodes.iter().map(|&x| if touching(x) { 1.0 } else { 0.0 }).collect();
        let trace = EdgeTrace::new(nodes.clone(), displacement, force, 0.0).unwrap();
        let found = Alternative::on_segment(Section::Four, &trace, segment, 0.25);
        assert_eq!(found.unwrap(), expected, "{name}");
    }
}
