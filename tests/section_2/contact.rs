//! Section 2: the discrete Signorini problem (2.9) and its scalar form, nodal cone.

use crate::reference_squares::check_against_reference;
use signorini::cone::Cone;
use signorini::contact::{ContactProblem, ContactSolution, Solver};
use signorini::fem::{Form, Lame};
use signorini::mesh::{Hierarchy, SideParts, Triangulation, parse_msh, unit_square};
use signorini::problems::TestProblem;

#[test]
fn block_nodal_matches_five_packages() {
    check_against_reference("E1", TestProblem::Block, Cone::Nodal);
}

#[test]
fn membrane_nodal_matches_five_packages() {
    check_against_reference("S1", TestProblem::Membrane, Cone::Nodal);
}

#[test]
fn nested_energy_errors_decrease() {
    // Only the decrease, and that a function has no distance to itself.
    let hierarchy = Hierarchy::refined(TestProblem::Membrane.mesh(8).unwrap(), 2).unwrap();
    let solve = |level: usize| {
        let problem = TestProblem::Membrane.on(hierarchy.levels()[level].clone()).unwrap();
        let solution = problem.solve(Cone::Nodal, Solver::ActiveSet).unwrap();
        (problem, solution.displacement)
    };
    let (finest, reference) = solve(2);
    let errors: Vec<f64> = (0..3)
        .map(|level| {
            let (_, coarse) = solve(level);
            finest.nested_energy_error(&hierarchy, (level, &coarse), (2, &reference)).unwrap()
        })
        .collect();
    assert!(errors[0] > 1.5 * errors[1] && errors[1] > 0.0 && errors[2] == 0.0, "{errors:?}");
}

/// A body of E = 5/2 under the volume load (0, f).
fn pressed(mesh: Triangulation, f: f64, poisson: f64) -> ContactProblem {
    let load = [0.0, f].repeat(mesh.nodes().len());
    ContactProblem::new(mesh, Form::elastic(Lame::plane_strain(2.5, poisson).unwrap()), &load)
        .unwrap()
}

/// Forces of a body hanging from its top, pressed down by f = (0, −1): load, reaction and floor add up to zero, to the
/// rounding that is stated for the material. Near ν = 1/2 it exceeds eight digits.
#[test]
fn the_rounding_of_forces_is_stated_for_materials_that_hardly_compress() {
    /// Standard deviations.
    const ROUNDINGS: f64 = 8.0;
    let imbalances = [0.25, 0.4999, 0.499_999_9, 0.499_999_999].map(|poisson| {
        let problem = pressed(unit_square(16, SideParts::HANGING).unwrap(), -1.0, poisson);
        let solution = problem.solve(Cone::Nodal, Solver::ActiveSet).unwrap();
        let imbalance = (solution.reaction[1] + solution.contact_force - 1.0).abs();
        assert!(imbalance <= ROUNDINGS * solution.force_rounding(), "{poisson}: {imbalance:e}");
        (imbalance, solution.force_rounding())
    });
    // It grows with λ/μ = 2ν/(1 − 2ν), and is no excuse elsewhere.
    assert!(imbalances[0].1 < 1e-13 && imbalances[3].1 < 1e-4, "{imbalances:?}");
    assert!(imbalances.windows(2).all(|pair| pair[0].1 < pair[1].1), "{imbalances:?}");
}

/// The L of the examples, nearly incompressible: residuals of 1e-11, relative to |K||u|, leave J off by 1 %.
#[test]
fn an_interior_point_solution_that_is_lost_has_not_converged() {
    // Up to 10 000 unknowns a solution that is lost is completed in double-double; the last mesh has more.
    let converged = [(0.25, 0), (0.4999, 0), (0.499_999_999_9, 0), (0.499_999_999_9, 4)].map(
        |(poisson, times)| {
            let mesh = parse_msh(include_str!("../../examples/data/l_shape.msh")).unwrap();
            let mesh = Hierarchy::refined(mesh, times).unwrap().finest().clone();
            let problem = pressed(mesh, -0.05, poisson);
            let direct = problem.attempt(Cone::Nodal, Solver::ActiveSet).unwrap();
            // A solution that has not converged is in the error.
            let answer = problem.solve(Cone::Nodal, Solver::InteriorPoint);
            let interior = match &answer {
                Ok(found) => found,
                Err(error) => error.unfinished::<ContactSolution>().unwrap(),
            };
            let allowed = 10.0 * direct.energy_rounding - 1e-8 * direct.energy;
            let is_near = (interior.energy - direct.energy).abs() <= allowed;
            let is_converged = interior.status.is_converged();
            assert!(is_near || !is_converged, "{poisson}: {}", interior.status);
            assert_eq!(answer.is_ok(), is_converged, "{poisson}: {}", interior.status);
            is_converged
        },
    );
    assert_eq!(converged, [true, true, true, false]);
}
