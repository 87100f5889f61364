//! A computed bound beside the true error: the distance to the solution on a mesh of at least 16 times as many
//! triangles, in the energy norm; the force, moment and a weighted pressure beside those of that mesh.

#![allow(dead_code, reason = "each test uses a part")]

use signorini::bounds::{Enclosure, Interval, Traction};
use signorini::cone::Cone;
use signorini::contact::{Body, Settings, Solver};
use signorini::mesh::{Hierarchy, Triangulation};
use signorini::{Result, fem::Form};

/// What acts on a body, for every mesh of it.
pub type Acting = Box<dyn Fn(Triangulation) -> Body<'static> + Send + Sync>;

/// Rounding of energies, forces and errors relative to their sizes.
const ROUNDED: f64 = 1e-9;
/// Relative bound below which the distance to a mesh of [`TIMES`] times as many triangles is computed.
const SMALL: f64 = 0.2;
/// That mesh: from the one of 16 times as many triangles by bisection where its own bound is large, so that corners and
/// transitions are resolved in it. On uniform meshes the distance would be below the error by several percent.
const TIMES: usize = 64;
/// Share of the bound whose triangles are bisected for it.
const MOST_OF_IT: f64 = 0.7;
/// On fewer triangles than these.
const FEW: usize = 2500;

/// A body on a coarse mesh.
pub struct Scene {
    pub name: String,
    pub mesh: Triangulation,
    pub body: Acting,
}

/// The bound on one mesh, and what a mesh of 16 times as many triangles says of it.
#[derive(Debug, Clone)]
pub struct Beside {
    pub found: Enclosure,
    /// With the other tractions of the stress: the bound, and the interval of J(u).
    pub other: (Traction, f64, Interval),
    pub fine: Enclosure,
    /// |||u_fine − u^h|||.
    pub distance: f64,
    /// The same with an adaptive mesh of 64 times as many triangles, where the bound is small on few triangles.
    pub closer: Option<f64>,
    /// The forces of the contact edges from both meshes.
    pub forces: Vec<[Interval; 2]>,
    /// Moments of the forces about the first point of each edge, and pressures with weights from −1 to 1.
    pub weighted: Vec<[Interval; 2]>,
}

impl Scene {
    pub fn new(
        name: impl Into<String>,
        mesh: Triangulation,
        body: impl Fn(Triangulation) -> Body<'static> + Send + Sync + 'static,
    ) -> Self {
        Self { name: name.into(), mesh, body: Box::new(body) }
    }

    pub fn form(&self) -> Form {
        (self.body)(self.mesh.clone()).form().clone()
    }

    /// The enclosure on the mesh, and on its second uniform refinement.
    pub fn beside(&self, cone: Cone) -> Result<Beside> {
        let times = 2;
        let mut meshes = Hierarchy::refined(self.mesh.clone(), times)?;
        let coarse_body = (self.body)(self.mesh.clone());
        let fine_body = (self.body)(meshes.finest().clone());
        let found = coarse_body.enclose(cone)?;
        let tractions = match found.tractions {
            Traction::Reduced => Traction::Linear,
            Traction::Linear => Traction::Reduced,
        };
        let other = coarse_body.enclose_with(cone, tractions)?;
        let other = (tractions, other.error, other.energy);
        let fine = fine_body.enclose(cone)?;
        let distance = fine.problem.nested_energy_error(
            &meshes,
            (0, &found.solution.displacement),
            (times, &fine.solution.displacement),
        )?;
        let (mut forces, mut weighted) = (Vec::new(), Vec::new());
        for edge in 0..found.problem.edge().pieces().len() {
            let both =
                (coarse_body.contact_force(&found, edge)?, fine_body.contact_force(&fine, edge)?);
            let (Some(coarse), Some(finer)) = both else { continue };
            forces.push([coarse, finer]);
            if found.problem.edge().is_closed() {
                continue;
            }
            let weights: [fn(usize, f64) -> f64; 2] = [|_, s| s, alternating];
            for weight in weights {
                let [own, other] = weights_on(&found, &fine, edge, weight);
                weighted.push([
                    coarse_body.weighted_force(&found, &own)?,
                    fine_body.weighted_force(&fine, &other)?,
                ]);
            }
        }
        let mut closer = None;
        if found.relative_error() < SMALL && found.shares.len() < FEW {
            // A share is of the order of the square of the area; their quotient, averaged at the nodes, is prolonged.
            let density = density(meshes.finest(), &fine.shares);
            while meshes.finest().triangles().len() < TIMES * found.shares.len() {
                let own = meshes.prolong(times, meshes.levels().len() - 1, 1, &density)?;
                let mesh = meshes.finest();
                let expected = mesh.triangles().iter().enumerate().map(|(t, nodes)| {
                    let area = area(mesh, t);
                    area * area * nodes.iter().map(|&node| own[node]).sum::<f64>()
                });
                let marked = bulk(&expected.collect::<Vec<_>>());
                meshes.refine_where(|_, t| marked[t])?;
            }
            let settings = Settings { solver: Solver::ActiveSet, ..Settings::default() };
            let problem = (self.body)(meshes.finest().clone()).problem()?;
            let finest = problem.solve(cone, settings)?.displacement;
            closer = Some(problem.nested_energy_error(
                &meshes,
                (0, &found.solution.displacement),
                (meshes.levels().len() - 1, &finest),
            )?);
        }
        Ok(Beside { found, other, fine, distance, closer, forces, weighted })
    }
}

fn area(mesh: &Triangulation, t: usize) -> f64 {
    let [a, b, c] = mesh.corners(t);
    0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))
}

/// The mean of share/area² over the triangles around each node.
fn density(mesh: &Triangulation, shares: &[f64]) -> Vec<f64> {
    let (mut sums, mut counts) = (vec![0.0; mesh.nodes().len()], vec![0.0; mesh.nodes().len()]);
    for (t, nodes) in mesh.triangles().iter().enumerate() {
        for &node in nodes {
            sums[node] += shares[t] / area(mesh, t).powi(2);
            counts[node] += 1.0;
        }
    }
    sums.iter().zip(counts).map(|(sum, count)| sum / count).collect()
}

/// The fewest triangles that have [`MOST_OF_IT`] of the sum of the shares.
fn bulk(shares: &[f64]) -> Vec<bool> {
    let mut order: Vec<usize> = (0..shares.len()).collect();
    order.sort_by(|&a, &b| shares[b].total_cmp(&shares[a]));
    let (mut marked, mut sum) = (vec![false; shares.len()], 0.0);
    let enough = MOST_OF_IT * shares.iter().sum::<f64>();
    for t in order {
        marked[t] = sum <= enough;
        sum += shares[t];
    }
    marked
}

/// A weight that changes sign from node to node, by the number of the node in its edge.
fn alternating(k: usize, _: f64) -> f64 {
    [1.0, -0.4, 0.7, -1.0, 0.1][k % 5]
}

/// A function on one contact edge, linear between the nodes of the coarse mesh, by its values at the nodes of both meshes;
/// given by the number of a coarse node in the edge and its arc length there. 0 on the other edges.
fn weights_on(
    found: &Enclosure,
    fine: &Enclosure,
    edge: usize,
    weight: impl Fn(usize, f64) -> f64,
) -> [Vec<f64>; 2] {
    let [coarse, finer] = [found, fine].map(|one| one.problem.edge());
    let (own, other) = (coarse.pieces()[edge].clone(), finer.pieces()[edge].clone());
    let places = &coarse.arc()[own.clone()];
    let first = places[0];
    let values: Vec<f64> = places.iter().enumerate().map(|(k, s)| weight(k, s - first)).collect();
    let mut both = [vec![0.0; coarse.nodes().len()], vec![0.0; finer.nodes().len()]];
    both[0][own].copy_from_slice(&values);
    let start = finer.arc()[other.start];
    for i in other {
        let at = first + finer.arc()[i] - start;
        let k = places.partition_point(|s| *s < at).clamp(1, places.len() - 1);
        let share = (at - places[k - 1]) / (places[k] - places[k - 1]);
        both[1][i] = values[k - 1] + share * (values[k] - values[k - 1]);
    }
    both
}

impl Beside {
    /// Bound over distance to the finest solution: at least the effectivity.
    pub fn effectivity(&self) -> f64 {
        if self.found.error == 0.0 {
            return 1.0;
        }
        self.found.error / self.closer.unwrap_or(self.distance)
    }

    /// The same with reduced tractions of the stress.
    pub fn effectivity_of_reduced(&self) -> f64 {
        match self.other {
            (Traction::Reduced, error, _) if self.found.error > 0.0 => {
                error / self.closer.unwrap_or(self.distance)
            }
            _ => self.effectivity(),
        }
    }

    /// What contradicts the statements of T11 and T12, if anything.
    pub fn violations(&self, name: &str) -> Vec<String> {
        let Self { found, other, fine, distance, closer, forces, weighted } = self;
        let mut wrong = Vec::new();
        let mut claim = |is_true: bool, what: String| {
            if !is_true {
                wrong.push(format!("{name}: {what}"));
            }
        };
        let size = fine.norm.upper;
        // |||u − u^h||| ≥ |||u_fine − u^h||| − |||u − u_fine|||; almost always the distance alone is below the bound.
        claim(
            found.error >= distance * (1.0 - ROUNDED) - ROUNDED * size,
            format!("bound {:e} below the distance {distance:e} to the fine solution", found.error),
        );
        let closer = closer.unwrap_or(*distance);
        claim(
            found.error >= closer * (1.0 - ROUNDED) - ROUNDED * size,
            format!("bound {:e} below the distance {closer:e} to the finest solution", found.error),
        );
        let (tractions, error, energy) = *other;
        claim(
            error >= closer * (1.0 - ROUNDED) - ROUNDED * size,
            format!("{tractions:?}: bound {error:e} below the distance {closer:e}"),
        );
        claim(
            found.error + fine.error >= distance * (1.0 - ROUNDED),
            format!("bound {:e} below {distance:e} − {:e}", found.error, fine.error),
        );
        let room = ROUNDED * size * size;
        let (wide, narrow) = (found.energy, fine.energy);
        claim(
            wide.lower <= narrow.upper + room && narrow.lower <= wide.upper + room,
            format!("energies {wide:?} and {narrow:?}"),
        );
        claim(
            energy.lower <= narrow.upper + room && narrow.lower <= energy.upper + room,
            format!("{tractions:?}: energies {energy:?} and {narrow:?}"),
        );
        claim(
            wide.lower <= fine.solution.energy + room || fine.correction > 0.0,
            format!("J of the fine mesh {:e} outside of {wide:?}", fine.solution.energy),
        );
        for [coarse, fine] in forces.iter().chain(weighted) {
            let room = ROUNDED * (coarse.upper.abs() + coarse.lower.abs());
            claim(
                coarse.lower <= fine.upper + room && fine.lower <= coarse.upper + room,
                format!("forces {coarse:?} and {fine:?}"),
            );
        }
        wrong
    }
}

/// The exponent of the last values as a power of the numbers, by least squares in logarithms.
pub fn exponent(points: &[(f64, f64)]) -> f64 {
    let count = points.len() as f64;
    let mean = |of: &dyn Fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / count;
    let (x, y) = (mean(&|p| p.0.ln()), mean(&|p| p.1.ln()));
    let xy: f64 = points.iter().map(|p| (p.0.ln() - x) * (p.1.ln() - y)).sum();
    let xx: f64 = points.iter().map(|p| (p.0.ln() - x).powi(2)).sum();
    xy / xx
}

/// Solves with the active set method on a refinement.
pub fn solved_on(body: &Body<'_>, mesh: &Triangulation, cone: Cone) -> Result<f64> {
    let settings = Settings { solver: Solver::ActiveSet, ..Settings::default() };
    Ok(body.problem_on(mesh)?.solve(cone, settings)?.energy)
}
