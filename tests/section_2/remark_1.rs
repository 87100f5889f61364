//! Remark 1 as printed: −Δu + u = f with the conditions of contact on the whole boundary.

use signorini::cone::Cone;
use signorini::contact::{ContactProblem, Solver};
use signorini::fem::Form;
use signorini::mesh::{Part, SideParts, unit_square};
use signorini::problems::{KnownSolution, TestProblem, TransitionPowers};

/// Eight digits of J, what the interior point method gives.
const ENERGY: f64 = 1e-8;

#[test]
fn both_solvers_agree_on_a_closed_edge_in_both_cones() {
    let transition =
        KnownSolution::whole_boundary(TransitionPowers::of_regularity(1.75), 0.37).unwrap();
    for n in [3, 4, 9, 16] {
        for problem in
            [TestProblem::MembraneReaction.problem(n).unwrap(), transition.problem(n).unwrap()]
        {
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
        assert!(
            solution.multiplier.iter().all(|&force| force > 0.0),
            "{cone}: {:?}",
            solution.multiplier
        );
        let other = problem.solve(cone, Solver::InteriorPoint).unwrap();
        assert!((solution.energy / other.energy - 1.0).abs() < ENERGY, "{cone}");
        assert!((solution.contact_force / other.contact_force - 1.0).abs() < 1e-6, "{cone}");
    }
}

/// Orders between h = 1/16 and h = 1/64, mean squares over the transitions at 1/3 and 2/3, by adaptive quadrature.
#[test]
fn orders_on_the_whole_boundary_are_at_least_those_of_the_theorems() {
    let error = |n: usize, tau: f64, cone: Cone| {
        let square = |a: f64| {
            let u = KnownSolution::whole_boundary(TransitionPowers::of_regularity(tau), a).unwrap();
            let problem = u.problem(n).unwrap();
            let discrete = problem.solve(cone, Solver::ActiveSet).unwrap();
            u.error(&problem, &discrete.displacement, 1e-3).unwrap().value.powi(2)
        };
        (square(1.0 / 3.0) + square(2.0 / 3.0)).sqrt()
    };
    for tau in [1.6, 1.75, 1.85] {
        let printed = tau * tau - 2.5 * tau + 2.0;
        for cone in Cone::ALL {
            let order = (error(16, tau, cone) / error(64, tau, cone)).ln() / 4.0f64.ln();
            assert!(order > printed, "{tau} {cone}: {order}");
        }
    }
}
