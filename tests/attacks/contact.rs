//! A seeded attack on contact problems in the plane: every solver beside a quadratic program of the test's
//! own that tries all contact sets, in numbers of twice the length (`contact/program.rs`).
//!
//! `SIGNORINI_FUZZ=20000 cargo test --release --test attacks -- --nocapture all_contact_sets` takes as many scenes,
//! `SIGNORINI_SCENE=17` only that one, and shows it.

mod cases;
mod compare;
mod meshes;
mod program;
mod scene;
mod stiffness;

use crate::common::SplitMix;
use compare::{compare, is_hard};
use program::{Answer, Program};
use scene::Scene;
use signorini::cone::{Cone, ContactSet};
use signorini::contact::{ContactSolution, Settings, Solver, Start};
use signorini::{Error, Result, ToolkitError};
use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Share of the solvable scenes in which an interior point may give up with a status.
const GIVEN_UP: f64 = 0.08;

/// Solver by solver, how many were asked and how many gave up with a status; what is wrong.
#[derive(Debug, Default)]
struct Counts {
    asked: BTreeMap<&'static str, [usize; 2]>,
    wrong: Vec<String>,
}

#[test]
fn every_solver_beside_all_contact_sets() {
    let variable = |name: &str| std::env::var(name).ok().map(|text| text.parse::<u64>().unwrap());
    let one = variable("SIGNORINI_SCENE");
    let scenes = one.map_or(0..variable("SIGNORINI_FUZZ").unwrap_or(1000), |seed| seed..seed + 1);
    let mut counts = Counts::default();
    for seed in scenes {
        let scene = Scene::random(seed);
        if one.is_some() {
            println!("{scene:#?}");
        }
        for cone in Cone::ALL {
            attack(seed, &scene, cone, &mut counts);
        }
    }
    println!("asked and given up: {:?}", counts.asked);
    let Counts { asked, wrong } = counts;
    assert!(wrong.is_empty(), "{} wrong: {:#?}", wrong.len(), &wrong[..wrong.len().min(200)]);
    let many = |[asked, given_up]: &[usize; 2]| *given_up as f64 > GIVEN_UP * *asked as f64;
    assert!(one.is_some() || !asked.values().any(many), "{asked:?}");
}

fn attack(seed: u64, scene: &Scene, cone: Cone, counts: &mut Counts) {
    let program =
        Program::new(scene, cone).expect("positive definite in numbers of twice the length");
    let answer = program.solve();
    let mut ask = |name: &'static str, solve: &dyn Fn() -> Result<ContactSolution>| {
        let [asked, given_up] = counts.asked.entry(name).or_default();
        *asked += 1;
        match verdict(name, scene, (&program, &answer), solve) {
            Ok(is_answered) => *given_up += usize::from(!is_answered),
            Err(what) => {
                let case = format!("seed {seed}, {cone}, cond {:.1e}", program.condition());
                counts.wrong.push(format!("{name}, {case}: {what}"));
            }
        }
    };
    let problem = || scene.problem();
    for (name, solver) in [
        ("active set", Solver::ActiveSet),
        ("interior point", Solver::InteriorPoint),
        ("multigrid", Solver::Multigrid),
        ("auto", Solver::Auto),
    ] {
        ask(name, &|| problem()?.attempt(cone, solver));
    }
    // From anywhere: single changes of sides and the dual method have to find the way.
    ask("active set from a guess", &|| {
        let mut random = SplitMix::new(seed);
        let guess = program.supports().iter().map(|_| random.below(2) == 0).collect::<Vec<_>>();
        problem()?.attempt(
            cone,
            Settings { start: Start::Set(ContactSet::new(&guess)), ..Settings::default() },
        )
    });
}

/// Share of ill-conditioned scenes and solvers that may be refused, or not converged.
const REFUSED: f64 = 0.01;

/// `SIGNORINI_FUZZ=2000 .. ill_conditioned` takes as many scenes.
#[test]
fn ill_conditioned_scenes_have_the_least_energy() {
    let variable = |name: &str| std::env::var(name).ok().map(|text| text.parse::<u64>().unwrap());
    let one = variable("SIGNORINI_SCENE");
    let scenes = one.map_or(0..variable("SIGNORINI_FUZZ").unwrap_or(200), |seed| seed..seed + 1);
    let mut asked: BTreeMap<&'static str, [usize; 2]> = BTreeMap::new();
    let (mut outside, mut refused) = (Vec::new(), Vec::new());
    for (seed, cone) in scenes.flat_map(|seed| Cone::ALL.map(|cone| (seed, cone))) {
        let scene = Scene::ill_conditioned(seed);
        if one.is_some() {
            println!("{scene:#?}");
        }
        let program =
            Program::new(&scene, cone).expect("positive definite in numbers of twice the length");
        let answer = program.solve();
        let exact = answer.energy;
        // The reference has 32 digits; where contact prevents all displacement, of the work of the load alone.
        let most = scene.forces.iter().fold(0.0, |most: f64, f| most.max(f.abs()));
        let digits =
            1e-32 * program.condition() * answer.energy_size + 1e-20 * most * program.alone();
        let guess = {
            let mut random = SplitMix::new(seed);
            ContactSet::new(
                &program.supports().iter().map(|_| random.below(2) == 0).collect::<Vec<_>>(),
            )
        };
        let from_guess = || Settings { start: Start::Set(guess.clone()), ..Settings::default() };
        for (name, settings) in [
            ("active set", Settings::from(Solver::ActiveSet)),
            ("interior point", Settings::from(Solver::InteriorPoint)),
            ("multigrid", Settings::from(Solver::Multigrid)),
            ("auto", Settings::from(Solver::Auto)),
            ("active set from a guess", from_guess()),
        ] {
            let [all, failed] = asked.entry(name).or_default();
            *all += 1;
            let case = format!("{name}, seed {seed}, {cone}, cond {:.1e}", program.condition());
            match scene.problem().and_then(|problem| problem.solve(cone, settings)) {
                Err(error) => {
                    *failed += 1;
                    refused.push(format!("{case}: {error}"));
                }
                Ok(found) if (found.energy - exact).abs() > found.energy_rounding + digits => {
                    outside.push(format!(
                        "{case}: J {:e} ± {:.1e}, exact {exact:e}, off by {:.1} of it",
                        found.energy,
                        found.energy_rounding,
                        (found.energy - exact).abs() / found.energy_rounding
                    ))
                }
                Ok(_) => {}
            }
        }
    }
    println!("asked and refused: {asked:?}\n{:#?}", &refused[..refused.len().min(50)]);
    let count: usize = asked.values().map(|[all, _]| all).sum();
    assert!(
        outside.is_empty(),
        "{} outside: {:#?}",
        outside.len(),
        &outside[..outside.len().min(50)]
    );
    let most = REFUSED * count as f64;
    assert!(
        refused.len() as f64 <= most,
        "{} refused: {:#?}",
        refused.len(),
        &refused[..refused.len().min(50)]
    );
}

/// Whether there is an answer beside a status, or a reason to refuse; otherwise what is wrong.
fn verdict(
    solver: &str,
    scene: &Scene,
    (program, answer): (&Program, &Answer),
    solve: &dyn Fn() -> Result<ContactSolution>,
) -> std::result::Result<bool, String> {
    let found = catch_unwind(AssertUnwindSafe(solve)).map_err(|_| "panic".to_owned())?;
    let solution = match found {
        // By rounding the matrix is not positive definite.
        Err(Error::Toolkit(ToolkitError::NotPositiveDefinite { .. })) if is_hard(program) => {
            return Ok(true);
        }
        Err(error) => return Err(format!("refused: {error}")),
        Ok(solution) => solution,
    };
    let is_iterated = solver == "interior point";
    // Prescribed values that penetrate have a status that says so.
    if compare(scene, program, answer, &solution)? || !program.is_admissible() {
        return Ok(true);
    }
    let may_give_up = is_hard(program) || is_iterated;
    if may_give_up { Ok(false) } else { Err(format!("{} {:?}", solution.status, solution.kkt)) }
}
