//! Figure 4.1: the contact set of every segment of a computed solution has a diameter below or above h_e θ.

use crate::proof_cases::printed_theta;
use signorini::cone::Cone;
use signorini::contact::Solver;
use signorini::edge::{EdgeTrace, Interval};
use signorini::problems::{StripData, TestProblem};
use signorini::strip::{LateralCondition, Reference, StripKind, StripProblem};

#[allow(dead_code)]
#[path = "../../examples/figure_4_1_alternative.rs"]
mod figure_4_1_alternative;

/// Whether a segment is in the first and in the second case.
fn cases(trace: &EdgeTrace, segment: Interval, theta: f64) -> [bool; 2] {
    let found = figure_4_1_alternative::cases(trace, segment, theta);
    [found.first, found.second]
}

/// The cases of n equal segments.
fn classified(trace: &EdgeTrace, n: usize, theta: f64) -> Vec<[bool; 2]> {
    let segment =
        |i: usize| Interval { start: i as f64 / n as f64, end: (i + 1) as f64 / n as f64 };
    (0..n).map(|i| cases(trace, segment(i), theta)).collect()
}

#[test]
fn every_segment_of_a_body_is_in_a_case_and_a_larger_theta_moves_it_to_the_first() {
    for (scene, tau) in [(TestProblem::Block, 1.75), (TestProblem::Membrane, 2.0)] {
        let body = scene.problem(128).unwrap();
        let solution = body.solve(Cone::Nodal, Solver::ActiveSet).unwrap();
        let trace = EdgeTrace::of_solution(&body, &solution).unwrap();
        for n in [4, 8, 16] {
            let found = classified(&trace, n, printed_theta(n, tau));
            assert!(!found.contains(&[false; 2]), "{scene} tau {tau} n {n}");
        }
        let first =
            |theta: f64| classified(&trace, 16, theta).iter().filter(|&case| case[0]).count();
        let counts = [0.01, 0.2, 0.6, 0.95].map(first);
        assert!(counts.windows(2).all(|pair| pair[0] <= pair[1]), "{scene}: {counts:?}");
    }
}

#[test]
fn every_segment_of_a_strip_problem_is_in_a_case() {
    for (scene, tau) in
        [("transition", 1.75), ("transitions:9", 1.6), ("cantor:0.3", 1.9), ("fat-cantor", 1.75)]
    {
        let data: StripData = scene.parse().unwrap();
        let data = data.data(tau, 1 << 16, LateralCondition::Natural).unwrap();
        let strip = StripProblem::new(StripKind::Scalar, &data, Reference::Nested, 8).unwrap();
        let reference = EdgeTrace::of_data(&data).unwrap();
        for n in [8, 16, 32, 64, 128, 256] {
            let own = EdgeTrace::of_strip(&strip.solve(n, Cone::Midpoint).unwrap()).unwrap();
            let sweep = (1..=12).map(|k| 0.5f64.powi(k)).filter(|_| n == 256);
            for theta in sweep.chain([printed_theta(n, tau)]) {
                for trace in [&reference, &own] {
                    assert!(
                        !classified(trace, n, theta).contains(&[false; 2]),
                        "{scene} n {n} theta {theta}"
                    );
                }
            }
        }
    }
}

/// A name, the contact set of the edge, the expected cases.
type Expected<'a> = (&'a str, &'a [[f64; 2]], [bool; 2]);

#[test]
fn degenerate_segments_have_the_expected_class() {
    const FIRST: [bool; 2] = [true, false];
    const SECOND: [bool; 2] = [false, true];
    let nodes: Vec<f64> = (0..=64).map(|i| f64::from(i) / 64.0).collect();
    // the segment [1/4, 3/4], theta = 1/4: h_e theta = 1/8
    let segment = Interval { start: 0.25, end: 0.75 };
    let expected: [Expected; 9] = [
        ("full contact", &[[0.0, 1.0]], SECOND),
        ("no contact", &[], FIRST),
        ("one contact point", &[[0.5, 0.5]], FIRST),
        ("that point and another set elsewhere", &[[0.5, 0.5], [0.9, 1.0]], FIRST),
        ("contact ends exactly at a vertex: one point", &[[0.0, 0.25]], FIRST),
        ("a point at either vertex", &[[0.0, 0.25], [0.75, 1.0]], SECOND),
        ("transition exactly at a node, diameter equal to h theta", &[[0.0, 0.375]], [true, true]),
        ("one cell less", &[[0.0, 0.359375]], FIRST),
        ("two pieces further apart", &[[0.25, 0.25], [0.5, 0.5]], SECOND),
    ];
    for (name, contact, expected) in expected {
        let touching = |x: f64| contact.iter().any(|&[a, b]| x >= a && x <= b);
        let displacement: Vec<f64> =
            nodes.iter().map(|&x| if touching(x) { 0.0 } else { -1.0 }).collect();
        let force: Vec<f64> = nodes.iter().map(|&x| if touching(x) { 1.0 } else { 0.0 }).collect();
        let trace = EdgeTrace::new(&nodes, &displacement, &force, 0.0).unwrap();
        assert_eq!(cases(&trace, segment, 0.25), expected, "{name}");
    }
}
