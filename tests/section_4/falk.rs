//! Falk's lemma for both cones: its terms on computed solutions, their known infima, and (4.8).

use signorini::cone::Cone;
use signorini::edge::EdgeTrace;
use signorini::problems::StripData;
use signorini::proof::FalkTerms;
use signorini::strip::{Reference, StripKind, StripProblem};

#[allow(dead_code)]
#[path = "../../examples/falk_terms.rs"]
mod falk_terms;

/// Squared errors carry the rounding of the contact iteration, 1e-13 of the energy.
const ROUNDING: f64 = 1e-9;

/// The terms on 4, 8, .., 128 cells.
fn all_terms(kind: StripKind, scene: &str, tau: f64, cone: Cone) -> Vec<(usize, FalkTerms)> {
    let data = scene.parse::<StripData>().unwrap().data(tau, 64 << 7, kind.sides()).unwrap();
    let trace = EdgeTrace::of_data(&data).unwrap();
    let problem = StripProblem::new(kind, &data, Reference::Nested, 4).unwrap();
    let on = |n: usize| {
        let operator = problem.operator(n).unwrap().0;
        let solution = operator.solve_contact(&problem.load(n).unwrap(), cone, None, 1e-13).unwrap();
        (n, FalkTerms::new(&problem, &trace, n, &solution).unwrap())
    };
    (2..=7).map(|level| on(1 << level)).collect()
}

#[test]
fn the_lemma_holds_with_constant_two_in_the_energy_norm() {
    for (scene, tau) in
        [("transition:0.37", 1.75), ("transition:0.61", 2.0), ("transitions:5", 1.6), ("fat-cantor", 1.75)]
    {
        for kind in [StripKind::Scalar, StripKind::Elastic] {
            for cone in [Cone::Nodal, Cone::Midpoint] {
                for (n, terms) in all_terms(kind, scene, tau, cone) {
                    let name = format!("{kind} {scene} tau {tau} {cone} n {n}");
                    let size = ROUNDING * (terms.error + terms.approximation);
                    let second = if cone == Cone::Midpoint { terms.second_infimum } else { 0.0 };
                    let bound = terms.approximation + 2.0 * (terms.consistency + second);
                    assert!(terms.error <= bound + size, "{name}: {} above {bound}", terms.error);
                    assert!(terms.consistency >= 0.0 && terms.second_part >= 0.0, "{name}");
                    // (4.8)
                    let parts = terms.first_part + terms.second_part;
                    assert!(
                        terms.second_infimum <= parts + size,
                        "{name}: {} above {parts}",
                        terms.second_infimum
                    );
                    // u_h minimises |u − v|²/2 + ∫σ(v − u) over its cone, which contains I^h u.
                    let interpolant = terms.approximation + 2.0 * terms.consistency;
                    assert!(terms.first_infimum() <= interpolant + size, "{name}: {}", terms.first_infimum());
                    if cone == Cone::Nodal {
                        assert!(terms.second_infimum <= size, "{name}: K^h is part of K");
                    }
                }
            }
        }
    }
}

#[test]
fn the_example_has_the_terms_of_the_library() {
    let scene = "fat-cantor";
    let options =
        falk_terms::Options { problem: scene.parse().unwrap(), finest: 7, ..falk_terms::Options::default() };
    let outcome = falk_terms::outcome(&options).unwrap();
    for cone in [Cone::Nodal, Cone::Midpoint] {
        for (n, terms) in all_terms(StripKind::Scalar, scene, 1.75, cone).into_iter().skip(1) {
            for (name, expected) in [
                ("error", terms.error),
                ("interpolation", terms.approximation),
                ("consistency", terms.consistency),
                ("second", terms.second_infimum),
                ("part_one", terms.first_part),
                ("part_two", terms.second_part),
            ] {
                let found = outcome.value(&format!("{name}.cone{cone}.n{n}")).unwrap();
                assert!(
                    (found - expected).abs() < 1e-9 * terms.error,
                    "{name} {cone} {n}: {found} {expected}"
                );
            }
        }
    }
}

/// |u − v|² + 2 ∫ σ_N (v − u)_N along v = (1 + t) u_h, which stays in the cone: least at t = 0, and symmetric about it.
#[test]
fn the_discrete_solution_attains_the_first_infimum() {
    let data = "fat-cantor".parse::<StripData>().unwrap();
    let data = data.data(1.75, 64 << 7, StripKind::Scalar.sides()).unwrap();
    let trace = EdgeTrace::of_data(&data).unwrap();
    let problem = StripProblem::new(StripKind::Scalar, &data, Reference::Nested, 4).unwrap();
    for (cone, n) in Cone::ALL.into_iter().flat_map(|cone| [16, 64].map(|n| (cone, n))) {
        let operator = problem.operator(n).unwrap().0;
        let solution = operator.solve_contact(&problem.load(n).unwrap(), cone, None, 1e-13).unwrap();
        let terms = FalkTerms::new(&problem, &trace, n, &solution).unwrap();
        let along = |t: f64| {
            let v: Vec<f64> = solution.values.iter().map(|u| (1.0 + t) * u).collect();
            problem.error(n, &v).unwrap().value.powi(2) - 2.0 * (1.0 + t) * terms.second_infimum
        };
        let least = terms.first_infimum();
        assert!((along(0.0) - least).abs() <= ROUNDING * terms.error, "{cone} {n}");
        assert!((along(0.1) / along(-0.1) - 1.0).abs() < 1e-9 && along(0.1) > least, "{cone} {n}");
    }
}
