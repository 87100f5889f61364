//! Section 2: scenes with known solutions, regularity or limits.

use signorini::cone::Cone;
use signorini::contact::{ContactProblem, ContactSolution, Solver};
use signorini::fem::Field;
use signorini::problems::{KnownSolution, Parameters, TestProblem};

fn solved(scene: TestProblem, n: usize, cone: Cone) -> (ContactProblem, ContactSolution) {
    let problem = scene.problem(n).unwrap();
    let solution = problem.solve(cone, Solver::ActiveSet).unwrap();
    (problem, solution)
}

/// Slope of ln error against ln h between two meshes.
fn order(coarse: f64, fine: f64, factor: f64) -> f64 {
    (coarse / fine).ln() / factor.ln()
}

#[test]
fn known_solution_is_approached_at_the_optimal_rate() {
    // u in H^{5/2-ε}: order 1 in the energy norm, close to 2 in L². Bounded from both sides.
    let known = KnownSolution::three_halves();
    for cone in Cone::ALL {
        let norms = [16, 64].map(|n| {
            let (problem, solution) = solved(TestProblem::Manufactured, n, cone);
            known.error_norms(&problem, &solution.displacement).unwrap()
        });
        let [coarse, fine] = norms;
        assert_eq!(fine.h1, fine.energy, "the form is the Dirichlet form");
        let (energy, l2) = (order(coarse.h1, fine.h1, 4.0), order(coarse.l2, fine.l2, 4.0));
        assert!((0.95..=1.1).contains(&energy), "{cone}: order {energy} in the energy norm");
        assert!((1.7..=2.3).contains(&l2), "{cone}: order {l2} in L²");
    }
}

#[test]
fn known_contact_set_and_force_are_found() {
    // Contact ends within two cells of 0.4; the total force is ∫ (3/2) (a − x)^{1/2} = a^{3/2}.
    let transition = KnownSolution::three_halves().transitions()[0];
    let exact = transition.powf(1.5);
    for cone in Cone::ALL {
        let mut off = Vec::new();
        for n in [32, 128] {
            let (_, solution) = solved(TestProblem::Manufactured, n, cone);
            let runs = solution.contact_set.runs();
            assert_eq!(runs.len(), 1, "{cone}");
            let end = solution.positions[runs[0].end - 1];
            assert!((end - transition).abs() <= 2.0 / n as f64, "{cone}: {end}");
            off.push((solution.contact_force - exact).abs());
        }
        assert!(off[1] < 0.3 * off[0] && off[0] < 0.01, "{cone}: force off by {off:?}");
    }
}

#[test]
fn nearly_incompressible_blocks_lock_and_both_solvers_say_the_same() {
    // P1 elements: the displacement dies as Poisson's ratio approaches 1/2 on a fixed mesh. Solvers agree as
    // far as the condition number 1e7 times that of the mesh allows.
    let largest = |poisson: f64| {
        let setting = Parameters { poisson, ..Parameters::default() };
        let problem = TestProblem::Incompressible.problem_with(16, &setting).unwrap();
        let [a, b] = [Solver::ActiveSet, Solver::InteriorPoint]
            .map(|solver| problem.solve(Cone::Nodal, solver).unwrap());
        assert!(
            (a.energy / b.energy - 1.0).abs() < 1e-8,
            "{poisson}: {:e} {:e}",
            a.energy,
            b.energy
        );
        assert!(a.kkt.worst() < 1e-13, "{poisson}");
        let (apart, rounding) =
            ((a.energy - b.energy).abs(), a.energy_rounding + b.energy_rounding);
        assert!(apart <= 5.0 * rounding, "{poisson}: apart by {apart:e}, rounding {rounding:e}");
        a.energy.abs()
    };
    let energies = [0.25, 0.49, 0.4999, 0.4999999].map(largest);
    assert!(energies.windows(2).all(|pair| pair[1] < pair[0]), "{energies:?}");
    assert!(energies[3] < 0.2 * energies[0], "{energies:?}");
}

#[test]
fn initial_gap_and_settlement_move_the_contact() {
    // Pressing the top down by s against a gap of g is pressing by s − g against none: u_N − g is the same.
    let mesh = TestProblem::Closed.mesh(16).unwrap();
    let build = |settlement: f64, gap: f64| {
        let form = TestProblem::Closed.problem(16).unwrap().form().clone();
        let mut problem = ContactProblem::new(mesh.clone(), form, &vec![0.0; 2 * 17 * 17]).unwrap();
        problem.set_dirichlet(&Field::Vector(&|_| [0.0, -settlement])).unwrap();
        problem.set_gap(|[x, _]| gap + 0.05 * x * x).unwrap();
        problem
    };
    for cone in Cone::ALL {
        for solver in [Solver::ActiveSet, Solver::InteriorPoint] {
            let near = build(0.02, 0.0).solve(cone, solver).unwrap();
            let far = build(0.12, 0.1).solve(cone, solver).unwrap();
            assert!(near.contact_set.count() > 0 && near.contact_set.count() < 16, "{cone}");
            assert_eq!(near.contact_set, far.contact_set, "{cone} {solver}");
            for (a, b) in near.multiplier.iter().zip(&far.multiplier) {
                assert!((a - b).abs() < 1e-10, "{cone} {solver}: {a} {b}");
            }
            assert!(near.balance < 1e-12 && far.balance < 1e-12);
        }
    }
}

#[test]
fn traction_from_the_residual_is_the_contact_pressure() {
    let (problem, solution) = solved(TestProblem::Block, 32, Cone::Nodal);
    for (pressure, [normal, tangential]) in solution.pressure.iter().zip(&solution.traction) {
        assert!(
            (pressure + normal).abs() < 1e-12 && tangential.abs() < 1e-12,
            "{pressure} {normal} {tangential}"
        );
    }
    assert_eq!(problem.contact_mesh().unwrap().lengths().len(), 32);
    // Against the known σ_N, away from both ends of the run.
    let (problem, solution) = solved(TestProblem::Manufactured, 128, Cone::Nodal);
    for (&x, [normal, _]) in problem.edge().arc().iter().zip(&solution.traction) {
        if (0.1..0.35).contains(&x) {
            assert!(
                (normal - KnownSolution::three_halves().normal_stress(x)).abs() < 2e-3,
                "{x}: {normal}"
            );
        }
    }
}
