//! Remark 1 as printed: −Δu + u = f with the conditions of contact on the whole boundary.

use example_frame::Outcome;
use signorini::cone::Cone;
use signorini::contact::{ContactProblem, Solver};
use signorini::fem::Form;
use signorini::mesh::{Part, SideParts, unit_square};
use signorini::problems::{KnownSolution, TestProblem, TransitionPowers};

#[allow(dead_code)]
#[path = "../examples/remark_1_whole_boundary.rs"]
mod example;

/// Eight digits of J, what the interior point method gives.
const ENERGY: f64 = 1e-8;

#[test]
fn both_solvers_agree_on_a_closed_edge_in_both_cones() {
    let transition = KnownSolution::whole_boundary(TransitionPowers::of_regularity(1.75), 0.37).unwrap();
    for n in [3, 4, 9, 16] {
        for problem in [TestProblem::MembraneReaction.problem(n).unwrap(), transition.problem(n).unwrap()] {
            assert!(problem.edge().is_closed() && problem.edge().nodes().len() == 4 * n);
            for cone in Cone::ALL {
                let [one, other] = [Solver::ActiveSet, Solver::InteriorPoint]
                    .map(|solver| problem.solve(cone, solver).unwrap());
                assert!(one.status.is_converged() && one.kkt.worst() < 1e-12, "{n} {cone}");
                assert_eq!(one.positions.len(), 4 * n, "{n} {cone}");
                assert!(one.positions.windows(2).all(|pair| pair[0] < pair[1]), "{n} {cone}");
                let apart = (one.energy - other.energy).abs() / other.energy.abs();
                assert!(apart < ENERGY, "{n} {cone}: {apart:e}");
            }
        }
    }
}

/// Pushed everywhere: all constraints of the ring are active, the means are dependent, u = ±c, c = 0.
#[test]
fn full_contact_on_a_ring_is_solved() {
    let all = Part::Contact;
    let mesh = unit_square(4, SideParts { bottom: all, right: all, top: all, left: all }).unwrap();
    let load = vec![1.0; mesh.nodes().len()];
    let problem = ContactProblem::new(mesh, Form::Scalar { reaction: 1.0 }, &load).unwrap();
    for cone in Cone::ALL {
        let solution = problem.solve(cone, Solver::ActiveSet).unwrap();
        assert!(solution.status.is_converged() && solution.kkt.worst() < 1e-12, "{cone}");
        assert_eq!(solution.contact_set.count(), 16, "{cone}");
        assert!(solution.multiplier.iter().all(|&force| force > 0.0), "{cone}: {:?}", solution.multiplier);
        let other = problem.solve(cone, Solver::InteriorPoint).unwrap();
        assert!((solution.energy / other.energy - 1.0).abs() < ENERGY, "{cone}");
        assert!((solution.contact_force / other.contact_force - 1.0).abs() < 1e-6, "{cone}");
    }
}

#[test]
fn the_theorems_hold_on_the_whole_boundary_and_planted_faults_turn_them() {
    let options = example::Options::default();
    let computed = example::compute(&options).unwrap();
    let outcome = |computed: &example::Computed, key: &str| {
        let found = example::findings(&options, computed);
        found.into_iter().find(|finding| finding.key() == key).unwrap().outcome()
    };
    let keys: Vec<String> = example::findings(&options, &computed)
        .iter()
        .filter(|finding| finding.outcome() != Outcome::Holds)
        .map(|finding| format!("{}: {}", finding.key(), finding.comparison()))
        .collect();
    assert!(keys.is_empty(), "{keys:?}");
    // A level without an error, a wrong order, a second minimum.
    let mut spoilt = example::Computed { rows: computed.rows.clone(), solved: computed.solved.clone() };
    spoilt.rows[0][1].study.levels[3].error = f64::NAN;
    assert_eq!(outcome(&spoilt, "levels"), Outcome::Refuted);
    let mut spoilt = example::Computed { rows: computed.rows.clone(), solved: computed.solved.clone() };
    if let Some(fit) = &mut spoilt.rows[0][1].error {
        fit.order -= 0.2;
    }
    assert_eq!(outcome(&spoilt, "closed.transition.175.midpoint"), Outcome::Refuted);
    assert_eq!(outcome(&spoilt, "bars"), Outcome::Refuted);
    let mut spoilt = example::Computed { rows: computed.rows.clone(), solved: computed.solved.clone() };
    spoilt.solved[1][0].energy *= 1.0 + 1e-6;
    assert_eq!(outcome(&spoilt, "solvers"), Outcome::Refuted);
    assert!(example::compute(&example::Options { meshes: 0, ..options }).is_err());
}
