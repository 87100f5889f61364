//! A seeded attack on contact problems in the plane: every solver beside a quadratic program of the test's
//! own that tries all contact sets, in numbers of twice the length (`attack_contact/program.rs`).
//!
//! `SIGNORINI_FUZZ=20000 cargo test --release --test attack_contact -- --nocapture` takes as many scenes,
//! `SIGNORINI_SCENE=17` only that one, and shows it.

mod compare;
mod count;
mod double;
mod meshes;
mod program;
mod scene;
mod stiffness;

use crate::common::SplitMix;
use count::Counts;
use meshes::grid;
use program::Program;
use scene::Scene;
use signorini::Error;
use signorini::ToolkitError;
use signorini::cone::{Cone, ContactSet};
use signorini::contact::{ContactSolution, Settings, Solver, Start};
use signorini::mesh::{ContactEdge, Part, Triangulation};

fn variable(name: &str) -> Option<u64> {
    let text = std::env::var(name).ok()?;
    Some(text.parse().unwrap_or_else(|_| panic!("{name} = {text} is not a number")))
}

#[test]
fn every_solver_beside_all_contact_sets() {
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
    counts.close(one.is_none());
}

/// The interior point method on the edge with a barrier weight for every node.
fn barrier(sizes: &[f64]) -> Settings<'_> {
    Settings { solver: Solver::EdgeInteriorPoint, sizes: Some(sizes), ..Settings::default() }
}

fn attack(seed: u64, scene: &Scene, cone: Cone, counts: &mut Counts) {
    let program = Program::new(scene, cone).expect("positive definite in numbers of twice the length");
    let answer = program.solve();
    let mut ask = |name: &'static str, solve: &dyn Fn() -> signorini::Result<ContactSolution>| {
        counts.judge(name, (seed, cone), scene, (&program, &answer), solve);
    };
    let problem = || scene.problem();
    for (name, solver) in [
        ("active set", Solver::ActiveSet),
        ("interior point", Solver::InteriorPoint),
        ("interior point, edge", Solver::EdgeInteriorPoint),
        ("multigrid", Solver::Multigrid),
        ("auto", Solver::Auto),
    ] {
        ask(name, &|| problem()?.solve(cone, solver));
    }
    // From anywhere: single changes of sides and the dual method have to find the way.
    ask("active set from a guess", &|| {
        let mut random = SplitMix::new(seed);
        let guess = program.supports().iter().map(|_| random.below(2) == 0).collect();
        problem()?.solve(cone, Settings { start: Start::Set(ContactSet::new(guess)), ..Settings::default() })
    });
    if cone == Cone::Nodal && !scene.mesh.is_closed && scene.mesh.further.is_empty() {
        let sizes = vec![1.0; scene.mesh.chain.len()];
        ask("barrier", &|| problem()?.solve(cone, barrier(&sizes)));
    }
    if let Some(hierarchy) = scene.hierarchy() {
        ask("multigrid on a hierarchy", &|| {
            let hierarchy = hierarchy.clone()?;
            let (solver, hierarchy) = (Solver::Multigrid, Some(&hierarchy));
            problem()?.solve(cone, Settings { solver, hierarchy, ..Settings::default() })
        });
    }
}

/// Two or three contact edges, each with its own normal.
#[test]
fn every_solver_on_several_contact_edges() {
    let one = variable("SIGNORINI_SCENE");
    let scenes = one.map_or(0..variable("SIGNORINI_FUZZ").unwrap_or(1000), |seed| seed..seed + 1);
    let (mut counts, mut edges, mut slanted) = (Counts::default(), [0; 4], 0);
    for seed in scenes {
        let scene = Scene::random_in_pieces(seed);
        if one.is_some() {
            println!("{scene:#?}");
        }
        assert!(scene.mesh.chain.len() <= 12, "scene {seed}: {} contact nodes", scene.mesh.chain.len());
        edges[scene.mesh.pieces().len()] += 1;
        slanted += usize::from(scene.mesh.pieces().iter().any(|piece| {
            let [a, b] = [piece[0], piece[1]].map(|node| scene.mesh.nodes[node]);
            a[0] != b[0] && a[1] != b[1]
        }));
        attack(seed, &scene, Cone::Nodal, &mut counts);
        let midpoint = scene.problem().and_then(|problem| problem.solve(Cone::Midpoint, Solver::Auto));
        assert!(
            matches!(
                midpoint,
                Err(Error::Toolkit(ToolkitError::Incompatible { .. })
                    | Error::Toolkit(ToolkitError::Triangle { .. }))
            ),
            "scene {seed}: {midpoint:?}"
        );
        let sizes = vec![1.0; scene.mesh.chain.len()];
        let barrier = scene.problem().and_then(|problem| problem.solve(Cone::Nodal, barrier(&sizes)));
        let named = matches!(
            barrier,
            Err(Error::Toolkit(ToolkitError::CountOutOfRange { .. })
                | Error::Toolkit(ToolkitError::Triangle { .. }))
        );
        assert!(named, "scene {seed}: the barrier takes several pieces for one");
    }
    println!("{} scenes of two contact edges, {} of three; {slanted} slanted", edges[2], edges[3]);
    counts.close(false);
}

/// Contact in several pieces, or around a corner of an elastic body, is refused by name; one piece never is.
#[test]
fn contact_in_pieces_is_named() {
    let mut random = SplitMix::new(22);
    let (mut refused, mut bent, mut taken) = (0, 0, 0);
    for case in 0..800 {
        let mut mesh = grid(&mut random, false);
        let rare = 3 + random.below(12);
        for edge in &mut mesh.boundary {
            edge.part = match random.below(rare) {
                0 => Part::Neumann,
                1 => Part::Dirichlet,
                _ => Part::Contact,
            };
        }
        let touches = |k: usize| mesh.boundary[k % mesh.boundary.len()].part == Part::Contact;
        let pieces = (0..mesh.boundary.len()).filter(|&k| touches(k) && !touches(k + 1)).count();
        let is_closed = (0..mesh.boundary.len()).all(touches);
        let made =
            Triangulation::new(mesh.nodes.clone(), mesh.triangles.clone(), mesh.boundary.clone()).unwrap();
        match ContactEdge::of(&made) {
            Ok(edge) => {
                assert!(pieces == 1 || is_closed, "case {case}: {pieces} pieces are taken for one");
                assert_eq!(edge.is_closed(), is_closed, "case {case}");
                taken += 1;
                bent += usize::from(edge.normal().is_err());
            }
            Err(error) => {
                assert!(pieces != 1 && !is_closed, "case {case}: one piece, {error}");
                refused += 1;
            }
        }
    }
    println!("contact edges: {refused} refused, {taken} taken, {bent} of them around a corner");
    assert!(refused >= 50 && bent >= 50, "{refused} refused, {taken} taken, {bent} around a corner");
}
