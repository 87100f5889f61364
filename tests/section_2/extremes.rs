//! Random scenes, extreme scales, degenerate contact: every solution is judged, both solvers agree.

use crate::common::SplitMix;
use signorini::cone::Cone;
use signorini::contact::{ContactProblem, ContactSolution, Solver};
use signorini::fem::{Form, Lame};
use signorini::mesh::{
    BoundaryEdge, ContactEdge, Hierarchy, Part, Point, SideParts, Triangulation, mapped_grid,
};
use signorini::problems::{Parameters, TestProblem};
use std::f64::consts::PI;

/// Scaled KKT figures of a solution that calls itself converged.
const KKT: f64 = 1e-10;
/// Both solvers, relative to the size of the terms in J.
const SOLVERS: f64 = 1e-8;
/// Change of the scaled answer under translation, rotation, scaling: condition number (up to 1e6) times
/// rounding.
const INVARIANCE: f64 = 1e-9;

/// Coordinates are multiples of 1/GRID.
const GRID: f64 = 1048576.0;

/// A random body: kept as data so that it can be moved and scaled.
pub struct Draft {
    pub hierarchy: Hierarchy,
    form: Form,
    load: Vec<f64>,
    gap: Vec<f64>,
}

impl Draft {
    /// A quadrilateral on a distorted grid or a polygon cut from a point inside, refined uniformly and toward one of its
    /// contact points; random labels at the sides, materials over `decades`, loads rough or smooth, gaps or none.
    pub fn random(seed: u64, decades: f64) -> Self {
        let random = &mut SplitMix::new(seed);
        let coarse = if random.below(2) == 0 { quadrilateral(random) } else { polygon(random) };
        let mut hierarchy = Hierarchy::refined(coarse, 1 + random.below(3)).unwrap();
        let contact = ContactEdge::of(hierarchy.finest()).unwrap();
        let point = contact.points()[random.below(contact.points().len())];
        for _ in 0..random.below(4) {
            hierarchy.refine_where(|mesh, t| mesh.corners(t).contains(&point)).unwrap();
        }
        let form = if random.below(2) == 0 {
            Form::Scalar {
                reaction: if random.below(2) == 0 { 0.0 } else { random.between(0.0, 10.0) },
            }
        } else {
            let mu = 10_f64.powf(random.between(-1.0 - decades, 1.0 + decades));
            Form::elastic(
                Lame::new(mu * 10_f64.powf(random.between(-decades, decades)), mu).unwrap(),
            )
        };
        let (rough, waves) = (random.below(2) == 0, random.between(0.5, 6.0));
        let nodes = hierarchy.finest().nodes();
        let load = (0..nodes.len() * form.components())
            .map(|i| {
                let [x, _] = nodes[i / form.components()];
                if rough { random.between(-1.0, 1.0) } else { (waves * x + i as f64 % 2.0).cos() }
            })
            .collect();
        let size = if random.below(3) == 0 { 0.05 } else { 0.0 };
        let count = ContactEdge::of(hierarchy.finest()).unwrap().nodes().len();
        let gap = (0..count).map(|_| size * random.uniform()).collect();
        Self { hierarchy, form, load, gap }
    }

    /// Moved by a similarity of the plane; data carried along so that the scaled answer stays the same.
    pub fn problem(&self, scale: f64, angle: f64, shift: Point, load_scale: f64) -> ContactProblem {
        let (sin, cos) = angle.sin_cos();
        let turn = |[x, y]: Point| [cos * x - sin * y, sin * x + cos * y];
        let mesh = self
            .hierarchy
            .finest()
            .clone()
            .mapped(|point| {
                let [x, y] = turn(point);
                [scale * x + shift[0], scale * y + shift[1]]
            })
            .unwrap();
        // Forces are ∫ f φ ~ scale², stiffness is free of scale: u ~ load scale².
        let (density, unit) = (load_scale / (scale * scale), load_scale);
        let load: Vec<f64> = match self.form.components() {
            1 => self.load.iter().map(|f| f * density).collect(),
            _ => {
                self.load.chunks(2).flat_map(|f| turn([f[0], f[1]])).map(|f| f * density).collect()
            }
        };
        let form = match self.form {
            Form::Scalar { reaction } => Form::Scalar { reaction: reaction / (scale * scale) },
            ref elastic => elastic.clone(),
        };
        let mut problem = ContactProblem::new(mesh, form, &load).unwrap();
        let mut next = 0;
        problem
            .set_gap(|_| {
                next += 1;
                unit * self.gap[next - 1]
            })
            .unwrap();
        problem
    }
}

/// Coordinates that a translation by 1e6 leaves exact.
fn rounded(point: Point) -> Point {
    point.map(|c| (c * GRID).round() / GRID)
}

fn side(random: &mut SplitMix) -> Part {
    if random.below(3) == 0 { Part::Dirichlet } else { Part::Neumann }
}

/// Random corners above a straight bottom in contact, graded and distorted grid, clamped top.
fn quadrilateral(random: &mut SplitMix) -> Triangulation {
    let (nx, ny) = (1 + random.below(6), 1 + random.below(4));
    let sides = SideParts {
        bottom: Part::Contact,
        right: side(random),
        top: Part::Dirichlet,
        left: side(random),
    };
    let [a, b] = [random.between(-0.2, 0.2), random.between(-0.2, 0.2)];
    let [p, q] = [random.between(0.7, 2.0), random.between(0.7, 2.0)];
    let grading = random.between(0.6, 2.0);
    let wave = random.between(0.0, 0.1);
    mapped_grid(nx, ny, sides, |[x, y]| {
        let x = x.powf(grading);
        let height = p + (q - p) * x;
        let shift = wave * (7.0 * x).sin() * y * (1.0 - y);
        rounded([x + y * (a + (b - a) * x), height * (y + shift)])
    })
    .unwrap()
}

/// Three to eight corners on a stretched circle with an edge at the bottom in contact, cut from the mean of
/// its corners; at least one side is clamped.
fn polygon(random: &mut SplitMix) -> Triangulation {
    let corners = 3 + random.below(6);
    let (wide, high) = (random.between(0.5, 1.5), random.between(0.5, 1.5));
    let mut angles: Vec<f64> = (0..corners - 2)
        .map(|k| {
            // The bottom edge spans the angles -2.2 to -0.9, the other corners share the rest.
            let step = (2.0 * PI - 1.3) / (corners - 1) as f64;
            -0.9 + step * (k as f64 + 1.0 + random.between(-0.3, 0.3))
        })
        .collect();
    angles.push(-2.2);
    angles.insert(0, -0.9);
    let bottom = high * (-0.9_f64).sin();
    let mut nodes: Vec<Point> =
        angles.iter().map(|&angle| rounded([wide * angle.cos(), high * angle.sin()])).collect();
    for corner in [0, corners - 1] {
        nodes[corner][1] = rounded([0.0, bottom])[1];
    }
    let mean = |axis: usize| nodes.iter().map(|node| node[axis]).sum::<f64>() / corners as f64;
    nodes.push(rounded([mean(0), mean(1)]));
    let next = |k: usize| (k + 1) % corners;
    let triangles = (0..corners).map(|k| [k, next(k), corners]).collect::<Vec<_>>();
    let clamped = random.below(corners - 1);
    let boundary = (0..corners)
        .map(|k| {
            let part = match k {
                k if k == corners - 1 => Part::Contact,
                k if k == clamped => Part::Dirichlet,
                _ => side(random),
            };
            BoundaryEdge { nodes: [k, next(k)], part }
        })
        .collect::<Vec<_>>();
    Triangulation::new(&nodes, &triangles, &boundary).unwrap()
}

/// |J|; contact may prevent every displacement, then J = 0 has no scale of its own.
fn energy_scale(solution: &ContactSolution) -> f64 {
    let rounding = f64::EPSILON * solution.force_scale() * solution.displacement_scale();
    if solution.energy.abs() <= rounding { rounding / f64::EPSILON } else { solution.energy.abs() }
}

fn judged(solution: &ContactSolution, case: &str) {
    assert!(
        !solution.status.is_converged() || solution.kkt.worst() <= KKT,
        "{case}: {} but {:?}",
        solution.status,
        solution.kkt
    );
}

#[test]
fn random_problems_are_solved_and_their_residuals_are_small() {
    let mut unresolved = 0;
    for seed in 0..if crate::MANY { 300 } else { 80 } {
        let problem = Draft::random(seed, 2.0).problem(1.0, 0.0, [0.0; 2], 1.0);
        for cone in Cone::ALL {
            let case = format!("scene {seed}, {cone}");
            let direct = problem.attempt(cone, Solver::ActiveSet).unwrap();
            judged(&direct, &case);
            unresolved += usize::from(!direct.status.is_converged());
            let interior = problem.attempt(cone, Solver::InteriorPoint).unwrap();
            let scale = energy_scale(&direct);
            let apart = if scale == 0.0 {
                interior.energy.abs()
            } else {
                (interior.energy - direct.energy).abs() / scale
            };
            assert!(
                apart <= SOLVERS,
                "{case}: energies apart by {apart:e}: {:e} {}, {:e} {}",
                direct.energy,
                direct.status,
                interior.energy,
                interior.status
            );
        }
    }
    assert_eq!(unresolved, 0);
}

#[test]
fn answers_do_not_depend_on_place_size_or_units() {
    let moves: [(f64, f64, Point, f64); 7] = [
        (1e-6, 0.0, [0.0; 2], 1.0),
        (1e6, 0.0, [0.0; 2], 1.0),
        (1.0, 0.7, [0.0; 2], 1.0),
        (1.0, 2.9, [1e-6, -1e-6], 1.0),
        (1.0, 0.0, [1e6, -1e6], 1.0),
        (1.0, 0.0, [0.0; 2], 1e-150),
        (1.0, 0.0, [0.0; 2], 1e150),
    ];
    for seed in 0..if crate::MANY { 300 } else { 80 } {
        let draft = Draft::random(seed, 2.0);
        for cone in Cone::ALL {
            let still =
                draft.problem(1.0, 0.0, [0.0; 2], 1.0).solve(cone, Solver::ActiveSet).unwrap();
            let largest = still.normal_displacement.iter().fold(0.0, |m: f64, u| m.max(u.abs()));
            for (scale, angle, shift, units) in moves {
                let problem = draft.problem(scale, angle, shift, units);
                let moved = problem.solve(cone, Solver::ActiveSet).unwrap();
                let case =
                    format!("scene {seed}, {cone}, moved by {:?}", (scale, angle, shift, units));
                judged(&moved, &case);
                let energy =
                    (moved.energy / units / units - still.energy).abs() / energy_scale(&still);
                assert!(energy <= INVARIANCE, "{case}: J off by {energy:e}");
                for (a, b) in moved.normal_displacement.iter().zip(&still.normal_displacement) {
                    let off = (a / units - b).abs();
                    assert!(
                        off <= INVARIANCE * largest,
                        "{case}: u_N off by {off:e}, largest {largest:e}"
                    );
                }
            }
        }
    }
}

#[test]
fn midpoint_cone_leaves_every_cycle_under_rough_loads() {
    let mut steps = Vec::new();
    for seed in 0..if crate::MANY { 200 } else { 50 } {
        let mut random = SplitMix::new(1000 + seed);
        let mesh = TestProblem::Block.mesh(24).unwrap();
        let load: Vec<f64> =
            (0..2 * mesh.nodes().len()).map(|_| random.between(-1.0, 1.0)).collect();
        let form = Form::elastic(Lame::new(1.0, 1.0).unwrap());
        let problem = ContactProblem::new(mesh, form, &load).unwrap();
        let solution = problem.solve(Cone::Midpoint, Solver::ActiveSet).unwrap();
        assert!(solution.status.is_converged(), "seed {seed}: {}", solution.status);
        judged(&solution, &format!("seed {seed}"));
        steps.push(solution.work.iterations);
    }
    steps.sort_unstable();
    assert!(steps[steps.len() / 2] <= 12, "median of {steps:?}");
}

#[test]
fn an_energy_that_is_no_number_is_an_error() {
    for load_scale in [1e160, 1e200, 1e300] {
        let setting = Parameters { load_scale, ..Parameters::default() };
        for (scene, cone) in
            [(TestProblem::Block, Cone::Nodal), (TestProblem::Membrane, Cone::Midpoint)]
        {
            let problem = scene.problem_with(8, &setting).unwrap();
            for solver in [Solver::ActiveSet, Solver::InteriorPoint] {
                let outcome = problem.attempt(cone, solver);
                assert!(
                    outcome.is_err(),
                    "{scene} {solver}, load {load_scale:e}: {:?}",
                    outcome.map(|s| s.energy)
                );
            }
        }
    }
}

#[test]
fn weak_contact_is_reported_and_not_in_the_way() {
    // No load at all: every constraint touches without force.
    let mesh = TestProblem::Block.mesh(8).unwrap();
    let form = Form::elastic(Lame::new(1.0, 1.0).unwrap());
    let load = vec![0.0; 2 * mesh.nodes().len()];
    let problem = ContactProblem::new(mesh, form, &load).unwrap();
    for cone in Cone::ALL {
        for solver in [Solver::ActiveSet, Solver::InteriorPoint] {
            let solution = problem.solve(cone, solver).unwrap();
            assert!(
                solution.status.is_converged(),
                "{cone} {solver}: {} {:?}",
                solution.status,
                solution.kkt
            );
            assert!(solution.margins().is_weak(1e-12), "{cone} {solver}");
            assert_eq!(solution.energy, 0.0, "{cone} {solver}");
        }
    }
}
