//! Falk's lemma for both cones: the terms of the example on computed solutions, their known infima, and (4.8).

use signorini::cone::Cone;
use signorini::problems::StripData;
use signorini::strip::{EdgeData, EdgeSolution, Reference, StripKind, StripProblem};

#[allow(dead_code)]
#[path = "../../examples/falk_terms.rs"]
mod falk_terms;
use falk_terms::Terms;

/// Squared errors carry the rounding of the contact iteration, 1e-13 of the energy.
const ROUNDING: f64 = 1e-9;

fn data(kind: StripKind, scene: &str, tau: f64) -> EdgeData {
    scene.parse::<StripData>().unwrap().data(tau, 64 << 7, kind.sides()).unwrap()
}

fn solved(problem: &StripProblem, n: usize, cone: Cone) -> EdgeSolution {
    problem.solve(n, cone).unwrap()
}

/// As in the example; there edges have ends, here the elastic strip is periodic.
fn terms(data: &EdgeData, problem: &StripProblem, n: usize, u: &[f64]) -> Terms {
    let (g, force, cells) = (data.values(), data.forces(), data.cells() / n);
    let nodal: Vec<f64> = g.iter().copied().step_by(cells).collect();
    let at = |v: &[f64], j: usize| {
        let (i, s) = (j / cells, (j % cells) as f64 / cells as f64);
        (1.0 - s) * v[i % v.len()] + s * v[(i + 1) % v.len()]
    };
    let work = |v: &[f64]| (0..g.len()).map(|j| force[j] * at(v, j)).sum::<f64>();
    let mut means = [0.0; 2];
    for a in (0..n).map(|s| s * cells) {
        let inner: f64 = force[a + 1..a + cells].iter().sum();
        let on_segment = inner + 0.5 * (force[a] + force[(a + cells) % g.len()]);
        let mean =
            |v: &dyn Fn(usize) -> f64| (a..a + cells).map(|j| 0.5 * (v(j) + v(j + 1))).sum::<f64>();
        means[0] += on_segment * mean(&|j| at(u, j)) / cells as f64;
        means[1] += on_segment * mean(&|j| g[j % g.len()]) / cells as f64;
    }
    let square = |v: &[f64]| problem.distance(n, v).unwrap().value.powi(2);
    let second = work(u);
    Terms {
        error: square(u),
        interpolation: square(&nodal),
        consistency: -work(&nodal),
        second,
        part_one: second - means[0] + means[1],
        part_two: -means[1],
        rounding: 0.0,
    }
}

#[test]
fn the_lemma_holds_with_constant_two_in_the_energy_norm() {
    let scenes = [
        ("transition:0.37", 1.75),
        ("transition:0.61", 2.0),
        ("transitions:5", 1.6),
        ("fat-cantor", 1.75),
    ];
    for ((scene, tau), kind) in scenes
        .into_iter()
        .flat_map(|case| [StripKind::Scalar, StripKind::Elastic].map(|kind| (case, kind)))
    {
        let data = data(kind, scene, tau);
        let problem = StripProblem::new(kind, &data, Reference::Nested, 4).unwrap();
        for (cone, n) in
            Cone::ALL.into_iter().flat_map(|cone| (2..=7).map(move |level| (cone, 1 << level)))
        {
            let u = solved(&problem, n, cone);
            let found = match kind {
                StripKind::Scalar => falk_terms::terms(&data, &problem, &u).unwrap(),
                StripKind::Elastic => terms(&data, &problem, n, &u.values),
            };
            let name = format!("{kind} {scene} tau {tau} {cone} n {n}: {found:?}");
            let Terms { error, interpolation, consistency, second, part_one, part_two, .. } = found;
            let size = ROUNDING * (error + interpolation);
            let added = if cone == Cone::Midpoint { second } else { 0.0 };
            assert!(error <= interpolation + 2.0 * (consistency + added) + size, "{name}");
            assert!(consistency >= 0.0 && part_two >= 0.0, "{name}");
            // (4.8)
            assert!(second <= part_one + part_two + size, "{name}");
            // u_h minimises |u − v|²/2 + ∫σ(v − u) over its cone, which contains I^h u.
            assert!(error - 2.0 * second <= interpolation + 2.0 * consistency + size, "{name}");
            assert!(cone == Cone::Midpoint || second <= size, "{name}: K^h is part of K");
        }
    }
}

/// |u − v|² + 2 ∫ σ_N (v − u)_N along v = (1 + t) u_h, which stays in the cone: least at t = 0, and symmetric about it.
#[test]
fn the_discrete_solution_attains_the_first_infimum() {
    let data = data(StripKind::Scalar, "fat-cantor", 1.75);
    let problem = StripProblem::new(StripKind::Scalar, &data, Reference::Nested, 4).unwrap();
    for (cone, n) in Cone::ALL.into_iter().flat_map(|cone| [16, 64].map(|n| (cone, n))) {
        let solution = solved(&problem, n, cone);
        let Terms { error, second, .. } = falk_terms::terms(&data, &problem, &solution).unwrap();
        let along = |t: f64| {
            let v: Vec<f64> = solution.values.iter().map(|u| (1.0 + t) * u).collect();
            problem.distance(n, &v).unwrap().value.powi(2) - 2.0 * (1.0 + t) * second
        };
        let least = error - 2.0 * second;
        assert!((along(0.0) - least).abs() <= ROUNDING * error, "{cone} {n}");
        assert!((along(0.1) / along(-0.1) - 1.0).abs() < 1e-9 && along(0.1) > least, "{cone} {n}");
    }
}
