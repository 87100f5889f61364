//! Contact by multigrid against the direct solver: the same solution, an honest estimate of the error, few
//! steps.

use crate::extremes::Draft;
use fractional_sobolev::Tolerance;
use signorini::Error;
use signorini::ToolkitError;
use signorini::cone::Cone;
use signorini::contact::{
    Accuracy, ContactProblem, ContactSolution, Fallback, MultigridReport, Progress, Settings,
    Solver,
};
use signorini::fem::{Field, Form};
use signorini::mesh::{Hierarchy, SideParts, unit_square};
use signorini::problems::{Parameters, TestProblem};

/// J of two computations at the tolerance 1e-12: it differs by the square of the error, and by rounding.
const ENERGIES: f64 = 1e-11;
/// Forces at the tolerance 1e-12: the edge norm of the error grows at most like n.
const FORCES: f64 = 1e-8;

fn direct(problem: &ContactProblem, cone: Cone) -> ContactSolution {
    let solution = problem.solve(cone, Solver::ActiveSet).unwrap();
    assert!(solution.status.is_converged());
    solution
}

fn settings(hierarchy: Option<&Hierarchy>, accuracy: Accuracy) -> Settings<'_> {
    Settings { solver: Solver::Multigrid, hierarchy, accuracy, ..Settings::default() }
}

fn multigrid(
    problem: &ContactProblem,
    cone: Cone,
    hierarchy: Option<&Hierarchy>,
    tolerance: f64,
) -> ContactSolution {
    let accuracy = Accuracy::Relative(Tolerance::new(tolerance).unwrap());
    problem.solve(cone, settings(hierarchy, accuracy)).unwrap()
}

fn report(solution: &ContactSolution) -> &MultigridReport {
    solution.multigrid.as_ref().unwrap()
}

/// A hundredth of the error of discretisation.
const SHARE: Accuracy = Accuracy::OfDiscretisation(0.01);

/// |u − v|_a.
fn apart(problem: &ContactProblem, u: &ContactSolution, v: &ContactSolution) -> f64 {
    let difference: Vec<f64> =
        u.displacement.iter().zip(&v.displacement).map(|(a, b)| a - b).collect();
    problem.energy_norm(&difference).unwrap()
}

fn assert_same(problem: &ContactProblem, cone: Cone, one: &ContactSolution, case: &str) {
    let other = direct(problem, cone);
    assert_eq!(one.status.to_string(), "converged", "{case}");
    let scale = other.energy.abs().max(other.force_scale() * other.displacement_scale() * 1e-6);
    assert!(
        (one.energy - other.energy).abs() <= ENERGIES * scale,
        "{case}: {} {}",
        one.energy,
        other.energy
    );
    let force = other.contact_force.abs().max(other.force_scale());
    assert!((one.contact_force - other.contact_force).abs() <= FORCES * force, "{case}");
    if !other.margins().is_weak(1e-9) {
        assert_eq!(one.contact_set, other.contact_set, "{case}");
    }
}

#[test]
fn every_problem_is_solved_as_by_the_direct_solver() {
    for scene in TestProblem::all() {
        for cone in Cone::ALL {
            for n in [16, 64, 128] {
                let problem = scene.problem(n).unwrap();
                let case = format!("{scene} {cone} {n}");
                let found = multigrid(&problem, cone, None, 1e-12);
                let expected = match scene {
                    _ if cone == Cone::Midpoint && problem.edge().is_closed() => {
                        Some(Fallback::ClosedEdge)
                    }
                    TestProblem::Incompressible => Some(Fallback::NearlyIncompressible),
                    // Its mesh is no grid.
                    TestProblem::Bracket => Some(Fallback::NoLevels),
                    _ => None,
                };
                assert_eq!(
                    report(&found).fallback,
                    expected,
                    "{case}: {:?}",
                    report(&found).levels
                );
                assert_same(&problem, cone, &found, &case);
                assert!(
                    report(&found).levels.iter().all(|level| level.steps <= 3),
                    "{case}: {:?}",
                    report(&found).levels
                );
            }
        }
    }
}

fn random_problem(seed: u64) -> (ContactProblem, Hierarchy) {
    let draft = Draft::random(seed, 1.0);
    (draft.problem(1.0, 0.0, [0.0; 2], 1.0), draft.hierarchy)
}

#[test]
fn random_bodies_are_solved_on_their_hierarchies() {
    let mut fallbacks = Vec::new();
    for seed in 0..if crate::MANY { 120 } else { 40 } {
        let (problem, hierarchy) = random_problem(seed);
        for cone in Cone::ALL {
            let found = multigrid(&problem, cone, Some(&hierarchy), 1e-12);
            fallbacks.extend(
                report(&found)
                    .fallback
                    .map(|why| format!("{seed} {cone}: {why}, {:?}", report(&found).levels)),
            );
            assert_same(&problem, cone, &found, &format!("seed {seed}, {cone}"));
        }
    }
    // Rounding keeps 1e-12 out of reach of a few.
    assert!(
        fallbacks.len() <= if crate::MANY { 6 } else { 2 },
        "{} fell back: {fallbacks:#?}",
        fallbacks.len()
    );
}

/// What two f64 solutions of one problem may differ by in the energy norm, relative.
const ROUNDING: f64 = 1e-13;

#[test]
fn true_errors_lie_below_their_estimates_and_not_far_below() {
    let tolerances: Vec<f64> =
        (2..=11).step_by(if crate::MANY { 1 } else { 3 }).map(|k| 10_f64.powi(-k)).collect();
    let (mut runs, mut near) = (0, 0);
    let mut check =
        |problem: &ContactProblem, hierarchy: Option<&Hierarchy>, cone: Cone, case: &str| {
            let exact = direct(problem, cone);
            for &tolerance in &tolerances {
                let found = multigrid(problem, cone, hierarchy, tolerance);
                let Some(estimate) = report(&found).error else { continue };
                let error = apart(problem, &found, &exact);
                let floor = ROUNDING * estimate.value;
                assert!(
                    error <= estimate.error + floor,
                    "{case} {tolerance}: {error:e} beyond {:e}",
                    estimate.error
                );
                assert!(
                    estimate.error <= tolerance * estimate.value * 1.01 + floor,
                    "{case} {tolerance}"
                );
                runs += 1;
                near += usize::from(estimate.error <= 10.0 * error + floor);
            }
        };
    for scene in
        TestProblem::all().into_iter().filter(|&scene| scene != TestProblem::Incompressible)
    {
        for cone in Cone::ALL {
            for n in [16, 32, 64] {
                let problem = scene.problem(n).unwrap();
                check(&problem, None, cone, &format!("{scene} {cone} {n}"));
            }
        }
    }
    for seed in 200..215 {
        let (problem, hierarchy) = random_problem(seed);
        check(&problem, Some(&hierarchy), Cone::Nodal, &format!("seed {seed}"));
    }
    assert!(runs >= if crate::MANY { 500 } else { 200 }, "{runs} runs");
    assert!(near as f64 >= 0.95 * runs as f64, "{near} of {runs} within a factor 10");
}

#[test]
fn the_accuracy_may_be_a_share_of_the_error_of_discretisation() {
    for scene in [TestProblem::Block, TestProblem::Membrane, TestProblem::Corner] {
        let (fine, coarse) = (scene.problem(256).unwrap(), scene.problem(64).unwrap());
        let found = coarse.solve(Cone::Nodal, settings(None, SHARE)).unwrap();
        let (error, expected) =
            (report(&found).error.unwrap().error, report(&found).discretisation.unwrap());
        assert!(error <= 0.03 * expected, "{scene}: {error:e}, {expected:e}");
        // Another estimate of the error of discretisation: the energy of the mesh four times as fine.
        let seen = (2.0 * (found.energy - direct(&fine, Cone::Nodal).energy)).sqrt();
        assert!((0.5..2.0).contains(&(expected / seen)), "{scene}: {expected:e}, {seen:e}");
    }
}

#[test]
fn what_multigrid_cannot_do_is_said() {
    let problem = TestProblem::Block.problem(15).unwrap();
    assert_eq!(
        report(&multigrid(&problem, Cone::Nodal, None, 1e-8)).fallback,
        Some(Fallback::NoLevels)
    );
    let problem = TestProblem::Block.problem(32).unwrap();
    let accuracy = Accuracy::Relative(Tolerance::new(1e-15).unwrap());
    let beyond = problem.attempt(Cone::Nodal, settings(None, accuracy)).unwrap();
    assert!(report(&beyond).fallback == Some(Fallback::NotReached) || beyond.status.is_converged());
    let other = Hierarchy::refined(unit_square(2, SideParts::HANGING).unwrap(), 2).unwrap();
    let refused = problem.solve(Cone::Nodal, settings(Some(&other), SHARE));
    assert!(matches!(refused, Err(Error::Toolkit(ToolkitError::LengthMismatch { .. }))));
    let shares = [0.0, -1.0, 2.0, f64::NAN].map(Accuracy::OfDiscretisation);
    for accuracy in shares {
        assert!(problem.solve(Cone::Nodal, settings(None, accuracy)).is_err());
    }
}

#[test]
fn an_observer_may_stop_the_iteration() {
    let problem = TestProblem::Block.problem(64).unwrap();
    let mut heard: Vec<Progress> = Vec::new();
    let mut observe = |progress: &Progress| {
        heard.push(*progress);
        let reason = "enough".to_owned();
        if progress.level == 2 { Err(Error::Solver { reason }) } else { Ok(()) }
    };
    let stopped = problem
        .solve(Cone::Nodal, Settings { progress: Some(&mut observe), ..settings(None, SHARE) });
    assert!(stopped.is_err_and(|e| e.to_string().contains("enough")));
    assert!(heard.iter().all(|progress| progress.levels == 4 && progress.error.is_finite()));
    assert_eq!(heard.last().map(|progress| progress.level), Some(2));
}

/// Loads, gaps, given displacements and forces that are no numbers are refused before any solver sees them.
#[test]
fn data_that_are_no_number_are_errors() {
    let mesh = || unit_square(4, SideParts::HANGING).unwrap();
    let good = || ContactProblem::new(mesh(), Form::LAPLACE, &[-1.0; 25]).unwrap();
    for bad in [f64::NAN, f64::INFINITY] {
        let mut load = [1.0; 25];
        load[7] = bad;
        assert!(ContactProblem::new(mesh(), Form::LAPLACE, &load).is_err());
        assert!(good().add_load(&load).is_err());
        assert!(good().set_gap(|_| bad).is_err());
        assert!(good().set_dirichlet(&Field::Scalar(&|_| bad)).is_err());
    }
    for solver in [Solver::ActiveSet, Solver::InteriorPoint, Solver::Multigrid, Solver::Auto] {
        assert!(good().solve(Cone::Midpoint, solver).unwrap().status.is_converged(), "{solver}");
    }
}

/// From nothing known: three linear systems on a level at most, every scene, and a corner beside which single
/// segments touch by turns. Signs alone took five there, and the projection onto the cone sixty. Where
/// elimination takes over there is one mesh, and four.
#[test]
fn sets_are_few_on_every_level_from_nothing_known() {
    let plain = |case: TestProblem, n: usize, parameters: &Parameters| {
        (case.to_string(), case.problem_with(n, parameters).unwrap(), None)
    };
    let sixty = Parameters { angle: 60.0, ..Parameters::default() };
    let graded = || {
        let mut hierarchy = Hierarchy::refined(TestProblem::Block.mesh(8).unwrap(), 3).unwrap();
        for _ in 0..10 {
            hierarchy.refine_where(|mesh, t| mesh.corners(t).contains(&[0.5, 0.0])).unwrap();
        }
        let problem = TestProblem::Block.on(hierarchy.finest().clone()).unwrap();
        ("bisected 10 times".to_owned(), problem, Some(hierarchy))
    };
    let of = |case: TestProblem| {
        // Seconds: coarser where the finer mesh shows nothing more.
        let n = match case.to_string().as_str() {
            "incompressible" | "bracket" => 128,
            "leaning" | "raised" | "free" | "closed" => 256,
            _ => 512,
        };
        plain(case, n, &Parameters::default())
    };
    let cases = TestProblem::all().into_iter().map(of);
    for (case, problem, hierarchy) in
        cases.chain([plain(TestProblem::Corner, 512, &sixty), graded()])
    {
        let is_eliminated = ["incompressible", "bracket"].contains(&case.as_str());
        for cone in
            Cone::ALL.into_iter().filter(|&c| c == Cone::Nodal || !problem.edge().is_closed())
        {
            let accuracy = Accuracy::Relative(Tolerance::new(1e-6).unwrap());
            let found = problem.solve(cone, settings(hierarchy.as_ref(), accuracy)).unwrap();
            assert!(found.status.is_converged(), "{case} {cone}");
            assert_eq!(
                report(&found).fallback.is_some(),
                is_eliminated,
                "{case} {cone}: {:?}",
                report(&found).fallback
            );
            let steps: Vec<usize> = report(&found).levels.iter().map(|level| level.steps).collect();
            println!(
                "{case} {cone}: {} on the coarsest mesh, {steps:?}",
                report(&found).coarsest_steps
            );
            let most = if is_eliminated { 4 } else { 3 };
            assert!(
                report(&found).coarsest_steps <= most,
                "{case} {cone}: {}",
                report(&found).coarsest_steps
            );
            assert!(steps.iter().all(|&steps| steps <= 3), "{case} {cone}: {steps:?}");
        }
    }
}

/// The factor of one cycle is that of the table in the solver's documentation: restriction, prolongation and smoother are
/// those of a V-cycle. A restriction with 0.4 in place of 0.5 gives 0.97 on 256 segments.
#[test]
fn one_cycle_reduces_the_error_by_a_factor_that_the_mesh_does_not_change() {
    for n in [64, 128, 256] {
        let problem = TestProblem::Block.problem(n).unwrap();
        let found = multigrid(&problem, Cone::Nodal, None, 1e-12);
        let report = report(&found);
        assert_eq!(report.fallback, None, "n {n}: {:?}", found.status);
        let steps = report.levels.last().unwrap().gradient_steps;
        assert!(steps <= 30, "n {n}: {steps}");
        for level in &report.levels {
            assert!(level.factor < 0.83, "n {n}: {level:?}");
        }
        assert!(found.kkt.worst() < 1e-13, "n {n}: {:?}", found.kkt);
    }
}
