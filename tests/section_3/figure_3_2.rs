//! Figure 3.2: every contact segment of a computed solution is in the first or the second case.

use crate::proof_cases::printed_theta;
use signorini::cone::Cone;
use signorini::contact::Solver;
use signorini::edge::{EdgeTrace, Interval};
use signorini::problems::{StripData, TestProblem};
use signorini::strip::{LateralCondition, Reference, StripKind, StripProblem};

#[allow(dead_code)]
#[path = "../../examples/figure_3_2_alternative.rs"]
pub mod figure_3_2_alternative;

const FIRST: [bool; 2] = [true, false];
const SECOND: [bool; 2] = [false, true];
const BOTH: [bool; 2] = [true, true];

/// Whether a segment is in the first and in the second case.
fn cases(trace: &EdgeTrace, segment: Interval, theta: f64) -> [bool; 2] {
    let found = figure_3_2_alternative::cases(trace, segment, theta);
    [found.first, found.second]
}

/// The cases of n equal segments.
fn classified(trace: &EdgeTrace, n: usize, theta: f64) -> Vec<[bool; 2]> {
    let segment =
        |i: usize| Interval { start: i as f64 / n as f64, end: (i + 1) as f64 / n as f64 };
    (0..n).map(|i| cases(trace, segment(i), theta)).collect()
}

#[test]
fn every_segment_of_the_block_is_in_a_case() {
    for (scene, tau) in [
        (TestProblem::Block, 1.75),
        (TestProblem::Block, 2.0),
        (TestProblem::Membrane, 1.6),
        (TestProblem::Membrane, 2.0),
    ] {
        let body = scene.problem(128).unwrap();
        let solution = body.solve(Cone::Nodal, Solver::ActiveSet).unwrap();
        let trace = EdgeTrace::of_solution(&body, &solution).unwrap();
        for n in [4, 8, 16] {
            let found = classified(&trace, n, printed_theta(n, tau));
            assert!(!found.contains(&[false; 2]), "{scene} tau {tau} n {n}");
        }
    }
}

/// Contact, with a force, at the nodes i/64 that touch.
fn trace(touches: impl Fn(usize) -> bool) -> EdgeTrace {
    let nodes = (0..=64).map(|i| i as f64 / 64.0).collect::<Vec<_>>();
    let displacement: Vec<f64> = (0..=64).map(|i| if touches(i) { 0.0 } else { -1.0 }).collect();
    let force = (0..=64).map(|i| f64::from(u8::from(touches(i)))).collect::<Vec<_>>();
    EdgeTrace::new(&nodes, &displacement, &force, 0.0).unwrap()
}

#[test]
fn classification_agrees_with_the_definition_point_by_point() {
    // Contact sets of random runs on 64 nodes, classified by looking at every point of a fine grid.
    let mut state = 2012_u64;
    let mut random = move || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 33) as f64 / (1u64 << 31) as f64
    };
    const GRID: usize = 320 * 64; // a single touching node is a grid point
    for case in 0..200 {
        let mut touching = random() < 0.5;
        let contact: Vec<bool> = (0..=64)
            .map(|_| {
                touching = if random() < 0.1 { !touching } else { touching };
                touching
            })
            .collect();
        let trace = trace(|i| contact[i]);
        // no grid point within rounding of a limit: theta is not a multiple of the grid
        let theta = 0.013 + 0.9 * random();
        let [first, second] = cases(&trace, Interval { start: 0.0, end: 1.0 }, theta);
        // u_N is linear between the nodes i/64.
        let values = trace.displacement();
        let zero_at =
            |x: f64| [64.0 * x, (64.0 * x).ceil()].iter().all(|&node| values[node as usize] == 0.0);
        let near = |from_right: bool| {
            (0..GRID)
                .map(|k| k as f64 / GRID as f64)
                .take_while(|&d| d < theta)
                .any(|d| zero_at(if from_right { 1.0 - d } else { d }))
        };
        assert_eq!(first, near(false) && near(true), "case {case}, theta {theta}");
        assert!(first || second, "case {case}, theta {theta}");
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
            let own = EdgeTrace::of_strip(&strip.solve(n, Cone::Nodal).unwrap()).unwrap();
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
type Expected<'a> = (&'a str, &'a [[usize; 2]], [bool; 2]);

#[test]
fn degenerate_segments_have_the_expected_class() {
    // the segment [1/4, 3/4], theta = 1/4: pieces of length 1/8 at the vertices
    let segment = Interval { start: 0.25, end: 0.75 };
    let expected: [Expected; 10] = [
        ("full contact", &[[0, 64]], FIRST),
        ("no contact", &[], SECOND),
        ("contact elsewhere only", &[[0, 12], [52, 64]], SECOND),
        ("contact up to the left vertex, transition at a node", &[[0, 16]], SECOND),
        ("contact from the right vertex on", &[[48, 64]], SECOND),
        ("transition at either vertex", &[[0, 16], [48, 64]], BOTH),
        ("one contact point in the middle", &[[32, 32]], SECOND),
        ("two contact points, one near each vertex", &[[20, 20], [44, 44]], FIRST),
        ("contact begins exactly at distance h theta", &[[24, 48]], SECOND),
        ("contact begins one cell before that", &[[23, 48]], FIRST),
    ];
    for (name, contact, expected) in expected {
        let trace = trace(|i| contact.iter().any(|&[a, b]| (a..=b).contains(&i)));
        assert_eq!(cases(&trace, segment, 0.25), expected, "{name}");
    }
}
