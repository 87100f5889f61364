//! Section 2: the discrete Signorini problem (2.9) and its scalar form, nodal cone.

use crate::reference_squares::check_against_reference;
use signorini::cone::Cone;
use signorini::contact::{ContactProblem, Solver};
use signorini::fem::{Condensation, Form, Lame, stiffness};
use signorini::mesh::{Hierarchy, SideParts, unit_square};
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
fn refined_mesh_gives_the_same_solution_as_the_structured_one() {
    // Same triangles, other numbering, other elimination order: equal up to rounding of 10^4 operations per
    // sum.
    const NUMBERING: f64 = 1e-13;
    let mut hierarchy = Hierarchy::new(TestProblem::Block.mesh(8).unwrap());
    hierarchy.refine().unwrap();
    let nested = TestProblem::Block.on(hierarchy.finest().clone()).unwrap();
    let nested = nested.solve(Cone::Nodal, Solver::ActiveSet).unwrap();
    let direct = TestProblem::Block.problem(16).unwrap().solve(Cone::Nodal, Solver::ActiveSet).unwrap();
    assert!((nested.energy / direct.energy - 1.0).abs() < NUMBERING);
    for (a, b) in nested.normal_displacement.iter().zip(&direct.normal_displacement) {
        assert!((a - b).abs() < NUMBERING, "{a} {b}");
    }
}

#[test]
fn condensation_is_the_schur_complement() {
    // Against elimination of one unknown after the other from a dense copy; 16 ε times 50 unknowns.
    const DENSE: f64 = 1e-13;
    let mesh = unit_square(4, SideParts::HANGING).unwrap();
    let matrix = stiffness(&mesh, &Form::LAPLACE, &signorini::fem::Frame::cartesian());
    let prescribed: Vec<bool> = mesh.nodes().iter().map(|&[_, y]| y == 1.0).collect();
    let kept = [0, 1, 2, 3, 4];
    let condensed = Condensation::new(&matrix, mesh.nodes(), &prescribed, &kept).unwrap();
    let n = matrix.unknowns();
    let mut dense = vec![vec![0.0; n]; n];
    for i in 0..n {
        matrix.row(i).for_each(|(j, value)| dense[i][j] = value);
    }
    for pivot in (5..n).filter(|&i| !prescribed[i]) {
        for i in (0..n).filter(|&i| i < 5 || i > pivot) {
            let factor = dense[i][pivot] / dense[pivot][pivot];
            for j in 0..n {
                dense[i][j] -= factor * dense[pivot][j];
            }
        }
    }
    for i in 0..5 {
        for j in 0..5 {
            assert!((condensed.schur()[(i, j)] - dense[i][j]).abs() < DENSE, "{i} {j}");
        }
    }
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

#[test]
fn bad_input_is_an_error() {
    assert!(TestProblem::Block.problem(0).is_err());
    assert!("planar".parse::<Cone>().is_err() && "newton".parse::<Solver>().is_err());
    let mesh = || unit_square(4, SideParts::HANGING).unwrap();
    let elastic = || Form::elastic(Lame::new(1.0, 1.0).unwrap());
    assert!(ContactProblem::new(mesh(), elastic(), &[0.0; 3]).is_err());
    assert!(ContactProblem::new(mesh(), elastic(), &[f64::NAN; 50]).is_err());
    let loose = SideParts { top: signorini::mesh::Part::Neumann, ..SideParts::HANGING };
    let floating = ContactProblem::new(unit_square(4, loose).unwrap(), elastic(), &[0.0; 50]);
    assert!(floating.is_err());
}

/// Forces of a body hanging from its top, pressed down by f = (0, −1): load, reaction and floor add up to zero, to the
/// rounding that is stated for the material. Near ν = 1/2 it exceeds eight digits.
#[test]
fn the_rounding_of_forces_is_stated_for_materials_that_hardly_compress() {
    /// Standard deviations.
    const ROUNDINGS: f64 = 8.0;
    let imbalances = [0.25, 0.4999, 0.499_999_9, 0.499_999_999].map(|poisson| {
        let mesh = unit_square(16, SideParts::HANGING).unwrap();
        let load = [0.0, -1.0].repeat(mesh.nodes().len());
        let form = Form::elastic(Lame::plane_strain(2.5, poisson).unwrap());
        let problem = ContactProblem::new(mesh, form, &load).unwrap();
        let solution = problem.solve(Cone::Nodal, Solver::ActiveSet).unwrap();
        let imbalance = (solution.reaction[1] + solution.contact_force - 1.0).abs();
        assert!(
            imbalance <= ROUNDINGS * solution.force_rounding,
            "{poisson}: {imbalance:e}, {:e}",
            solution.force_rounding
        );
        (imbalance, solution.force_rounding)
    });
    // It grows with λ/μ = 2ν/(1 − 2ν), and is no excuse elsewhere.
    assert!(imbalances[0].1 < 1e-13 && imbalances[3].1 < 1e-4, "{imbalances:?}");
    assert!(imbalances.windows(2).all(|pair| pair[0].1 < pair[1].1), "{imbalances:?}");
}
