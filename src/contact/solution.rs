//! The result of a contact solver, and quantities computed from displacement and multiplier.
//!
//! Energy J = a(u,u)/2 − l(u). Pressure at a node of the edge: the nodal contact force B'λ divided by the length that
//! belongs to the node (∫ of its hat function). Global balance: in every direction d (a unit translation; scalar: the
//! constant 1), loads + reactions of the Dirichlet part − contact forces − a(d, u), relative to the sum of absolute
//! loads and reactions, or of the other terms if that is larger; a(d, u) vanishes without a reaction term.

use super::active_set::Step;
use super::multigrid::MultigridReport;
use super::problem::ContactProblem;
use super::solver::Solver;
use crate::cone::{Cone, ContactSet, EdgeCone, KktResiduals, KktTerms, Margins, Status};
use crate::error::Result;
use crate::mesh::Point;
use crate::numeric::check::require_values;
use crate::numeric::parallel;
use crate::numeric::scale::careful_dot;
use crate::numeric::scale::largest;
use crate::numeric::sum::compensated;
use fractional_sobolev::Work;
use rayon::prelude::*;

/// Largest KKT residual of a solution with status converged.
pub(super) const ACCEPTED: f64 = 1e-8;

/// Wall-clock time in seconds by phase.
///
/// The time of a phase that the solver does not have is 0.
///
/// ```
/// use signorini::{cone::Cone, contact::Solver, problems::TestProblem};
/// let seconds = TestProblem::Block.problem(4)?.solve(Cone::Nodal, Solver::ActiveSet)?.seconds;
/// assert!(seconds.total() >= seconds.factorization + seconds.contact);
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Seconds {
    /// Assembly of stiffness matrix and load.
    pub assembly: f64,
    /// Elimination of all but the contact unknowns; for multigrid, elimination and solution on the coarsest
    /// mesh; 0 for [`Solver::InteriorPoint`].
    pub factorization: f64,
    /// The contact iteration.
    pub contact: f64,
    /// Recovery of the displacement, iterative refinement, KKT residuals.
    pub recovery: f64,
}

impl Seconds {
    /// The total time.
    ///
    /// It is the sum of all phases.
    pub fn total(&self) -> f64 {
        self.assembly + self.factorization + self.contact + self.recovery
    }
}

/// A discrete solution with its KKT residuals, forces, energy and solver statistics.
///
/// In exact arithmetic: K u − F + B'λ = 0 on the free unknowns, B u ≤ g, λ ≥ 0, λ'(B u − g) = 0. For homogeneous
/// Dirichlet data and g = 0 testing with u gives a(u, u) = F'u, hence J(u) = −½ a(u, u) = −½ F'u.
///
/// ```
/// use signorini::{cone::Cone, contact::Solver, problems::TestProblem};
/// let problem = TestProblem::Block.problem(8)?;
/// let u = problem.solve(Cone::Midpoint, Solver::ActiveSet)?;
/// let norm = problem.energy_norm(&u.displacement)?;
/// assert!((u.energy + 0.5 * norm * norm).abs() < 1e-14);
/// // λ (B u − g) = 0 constraint by constraint, and all forces are in equilibrium
/// assert!(u.multiplier.iter().zip(&u.gap).all(|(l, gap)| (l * gap).abs() < 1e-15));
/// assert!(u.balance < 1e-13);
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct ContactSolution {
    /// The discrete cone.
    pub cone: Cone,
    pub(super) solver: Solver,
    /// Cartesian nodal displacement, node-major: (u_x, u_y) of node i at 2i, 2i + 1 (scalar: u at i),
    /// prescribed nodes included, in the unit of length of the mesh.
    pub displacement: Vec<f64>,
    /// The normal displacement u_N (scalar: u) at the nodes of the contact edge, in order.
    ///
    /// One value per contact node, n outward; u_N ≤ g in the nodal cone.
    pub normal_displacement: Vec<f64>,
    /// The multipliers λ, one per constraint.
    ///
    /// A force, not a density: λ_i = −∫ σ_N φ_i (nodal) or −∫ σ_N over segment i (midpoint); ≥ 0 up to `kkt.sign`.
    pub multiplier: Vec<f64>,
    /// The gaps B u − g, one per constraint.
    ///
    /// It has the dimension of a length and is ≤ 0 up to `kkt.gap`; it is 0 up to rounding where the constraint is
    /// active.
    pub gap: Vec<f64>,
    /// The arc length at every constraint: at its node or at the midpoint of its segment.
    pub positions: Vec<f64>,
    /// The contact pressure −σ_N at the nodes of the contact edge.
    ///
    /// (B'λ)_i / ∫ φ_i, one per contact node, ≥ 0 in compression.
    pub pressure: Vec<f64>,
    /// (σ_N, σ_T) at the nodes of the contact edge, recovered from the residual K u − F: nodal force divided by
    /// ∫ φ_i. At nodes on the Dirichlet boundary this is the reaction; for a scalar problem it is (∂u/∂n, 0).
    pub traction: Vec<Point>,
    /// The active constraints.
    pub contact_set: ContactSet,
    /// The termination status of the solver.
    pub status: Status,
    /// The four scaled KKT residuals.
    pub kkt: KktResiduals,
    pub(super) force_scale: f64,
    pub(super) displacement_scale: f64,
    pub(super) margins: Margins,
    /// The energy J.
    pub energy: f64,
    /// The error of J as a minimum over the discrete cone: rounding of K and F, and what the solver left of the
    /// equations, Σ |r_i u_i| + Σ |λ_i (B u − g)_i|, r = K u − F + B'λ; for multigrid ½ e², e its error estimate.
    ///
    /// The rounding is the standard deviation ε (Σ_i u_i² (|K||u| + |F|)_i²)^{1/2}; on an inclined
    /// contact edge the sum over the nodes, with the norms of u, F and the 2 × 2 blocks of K at a node.
    ///
    /// This is an estimate, not a bound; differences of J below it are not significant. Where it exceeds 1e-11 of the
    /// energy, or a triangle or material is extreme, a problem of some thousand unknowns is solved again in
    /// double-double, and this is a bound on the error of the solve: the correction ½ r'K⁻¹r, r = F − K u − B'λ, the
    /// work λ'|B u − g|, and the rounding of the data. The status is not converged if it exceeds 1e-8 of the energy.
    pub energy_rounding: f64,
    /// The scale of J: ½ a(u, u) + |F'u| + m d², m the smallest of all μ, λ + μ (scalar: 1), d the scale of
    /// displacements.
    pub(super) energy_scale: f64,
    pub(super) force_rounding: f64,
    /// The total contact force: the sum of the multipliers.
    ///
    /// Σ_i λ_i = −∫ σ_N over the contact edge, in both cones, because the rows of B sum to 1.
    pub contact_force: f64,
    /// Total reaction of the Dirichlet part (scalar: second entry 0).
    pub reaction: Point,
    /// The relative imbalance of all forces (global balance).
    pub balance: f64,
    /// The steps of the active set method in order: a set, the minimiser with equality on it, what it violates. The
    /// last one is the solution. Empty for the other solvers.
    pub steps: Vec<Step>,
    /// Number of iterations and factorizations.
    pub work: Work,
    /// Time in seconds by phase.
    pub seconds: Seconds,
    /// The statistics of multigrid by level, its error estimate, and the reason for using the direct solver, if it
    /// was used; `None` for the other solvers.
    pub multigrid: Option<MultigridReport>,
}

impl ContactSolution {
    /// The solver that was used.
    pub fn solver(&self) -> Solver {
        self.solver
    }

    /// The force scale of the KKT residuals: max_i (|K||u| + |F|)_i, i over the unknowns that are not
    /// prescribed.
    pub fn force_scale(&self) -> f64 {
        self.force_scale
    }

    /// The displacement scale of the KKT residuals: max(|u|, |g|, |F_i|/K_ii), i over the unknowns that are
    /// not prescribed.
    pub fn displacement_scale(&self) -> f64 {
        self.displacement_scale
    }

    /// The margins of strict complementarity; small values mean weak contact.
    pub fn margins(&self) -> Margins {
        self.margins
    }

    /// The standard deviation due to rounding of a sum of forces (a component of the reaction, or the contact force):
    /// ε (Σ_i (|K||u| + |F|)_i²)^{1/2}.
    ///
    /// It is large relative to the loads if the terms of K u nearly cancel, as for Poisson's ratio near 1/2; an
    /// imbalance below it is within rounding.
    pub fn force_rounding(&self) -> f64 {
        self.force_rounding
    }
}

/// The raw result of a solver: unknowns of the frame, multipliers, termination status.
pub(super) struct Candidate {
    pub(super) solver: Solver,
    pub(super) unknowns: Vec<f64>,
    pub(super) multiplier: Vec<f64>,
    pub(super) contact_set: ContactSet,
    pub(super) status: Status,
    pub(super) steps: Vec<Step>,
    pub(super) work: Work,
    /// Largest KKT residual of a converged solution; infinite for solvers with an error estimate.
    pub(super) accepted: f64,
}

/// K u, J and the error of J in double-double, rounded.
pub(super) struct Evaluated {
    pub(super) stress_force: Vec<f64>,
    pub(super) energy: f64,
    pub(super) rounding: f64,
}

/// The solution with its KKT residuals from a candidate, with the same definition for every solver. Fails if the
/// energy of the displacement overflows.
pub(super) fn conclude(
    problem: &ContactProblem,
    cone: Cone,
    candidate: Candidate,
) -> Result<ContactSolution> {
    conclude_with(problem, cone, candidate, None)
}

/// The same with K u and J as given.
pub(super) fn conclude_with(
    problem: &ContactProblem,
    cone: Cone,
    candidate: Candidate,
    evaluated: Option<Evaluated>,
) -> Result<ContactSolution> {
    let u = &candidate.unknowns;
    let normals = problem.normal_unknowns();
    let normal_displacement: Vec<f64> = normals.iter().map(|&unknown| u[unknown]).collect();
    let edge_cone = problem.edge_cone(cone);
    let edge_force = edge_cone.apply_transposed(&candidate.multiplier)?;
    let computed;
    let stress_force = match &evaluated {
        Some(evaluated) => &evaluated.stress_force,
        None => {
            computed = problem.multiply(u);
            &computed
        }
    };
    let lengths = problem.edge.nodal_lengths();
    let traction = tractions(problem, stress_force, &lengths);
    let mut residual: Vec<f64> =
        stress_force.iter().zip(&problem.load).map(|(k, f)| k - f).collect();
    normals.iter().zip(&edge_force).for_each(|(&unknown, force)| residual[unknown] += force);
    let gap = gap_of(problem, edge_cone, &normal_displacement);
    let free: Vec<f64> =
        (0..residual.len()).filter(|&i| !problem.prescribed[i]).map(|i| residual[i]).collect();
    // Sums over all unknowns in the same order on one thread each: digits do not depend on the number of threads.
    let balance = || global_balance(problem, u, &residual, &edge_force);
    let of_energy = || {
        let terms =
            rayon::join(|| 0.5 * careful_dot(u, stress_force), || careful_dot(u, &problem.load));
        (terms.0 - terms.1, terms.0.abs() + terms.1.abs())
    };
    let of_sizes = || {
        let sizes = sizes(problem, u);
        let is_by_entry = problem.stencils().is_some() || problem.frames.are_along_axes();
        let energy_terms = || match is_by_entry || problem.form.components() == 1 {
            true => u.iter().zip(&sizes).map(|(u, size)| u * size).fold(0.0, f64::hypot),
            false => energy_terms_by_node(problem, u),
        };
        let force_terms = || sizes.iter().copied().fold(0.0, f64::hypot);
        let roundings = rayon::join(energy_terms, force_terms);
        (largest_free(problem, &sizes), roundings)
    };
    let scales = || rayon::join(of_sizes, || displacement_scale(problem, u));
    let (
        (reaction, balance),
        ((energy, energy_scale), ((force_scale, roundings), displacement_scale)),
    ) = rayon::join(balance, || rayon::join(of_energy, scales));
    let energy_scale = energy_scale + problem.smallest_modulus() * displacement_scale.powi(2);
    let [energy_rounding, force_rounding] =
        [roundings.0, roundings.1].map(|root| f64::EPSILON * root);
    let (energy, energy_rounding) = evaluated
        .as_ref()
        .map_or((energy, energy_rounding), |found| (found.energy, found.rounding));
    require_values("energy J", &[energy, energy_rounding], 2)?;
    let terms = KktTerms {
        residual: &free,
        multiplier: &candidate.multiplier,
        gap: &gap,
        force: force_scale,
        displacement: displacement_scale,
    };
    let kkt = terms.residuals()?;
    // Of a solver without an estimate of its own; multigrid adds ½ e².
    let of_solve = match candidate.accepted.is_finite() && evaluated.is_none() {
        true => left_by_solver(problem, u, &residual, &candidate.multiplier, &gap),
        false => 0.0,
    };
    let margins = free_margins(problem, edge_cone, &terms, &candidate.contact_set)?;
    let status = match candidate.status {
        Status::Converged if kkt.worst() > candidate.accepted => {
            Status::Stalled { residual: kkt.worst() }
        }
        Status::Converged if energy_rounding > ACCEPTED * energy_scale => {
            Status::Stalled { residual: energy_rounding / energy_scale }
        }
        status => status,
    };
    Ok(ContactSolution {
        cone,
        solver: candidate.solver,
        displacement: problem.to_cartesian(u),
        pressure: edge_force.iter().zip(lengths).map(|(force, length)| force / length).collect(),
        traction,
        normal_displacement,
        contact_force: compensated(candidate.multiplier.iter().copied()),
        multiplier: candidate.multiplier,
        positions: positions(problem, edge_cone),
        gap,
        contact_set: candidate.contact_set,
        status,
        kkt,
        force_scale,
        displacement_scale,
        margins,
        energy,
        energy_rounding: energy_rounding + of_solve,
        energy_scale,
        force_rounding,
        reaction,
        balance,
        steps: candidate.steps,
        work: candidate.work,
        seconds: Seconds::default(),
        multigrid: None,
    })
}

/// Σ |r_i u_i| + Σ |λ_i (B u − g)_i|, r = K u − F + B'λ at the free unknowns: what the iteration has left of J.
fn left_by_solver(
    problem: &ContactProblem,
    u: &[f64],
    residual: &[f64],
    multiplier: &[f64],
    gap: &[f64],
) -> f64 {
    let free = (0..u.len()).filter(|&i| !problem.prescribed[i]);
    let balance: f64 = free.map(|i| (residual[i] * u[i]).abs()).sum();
    balance + multiplier.iter().zip(gap).map(|(l, gap)| (l * gap).abs()).sum::<f64>()
}

/// (Σ |u_i|² (Σ_j |K_ij| |u_j| + |F_i|)²)^{1/2} over the nodes, with the Frobenius norms of the blocks: the entries of
/// an inclined frame are sums of all entries of a Cartesian block, and are rounded relative to its norm.
fn energy_terms_by_node(problem: &ContactProblem, u: &[f64]) -> f64 {
    let size = |values: &[f64]| values.iter().copied().fold(0.0, f64::hypot);
    let matrix = problem.matrix();
    let at = |node: usize| {
        let terms = matrix.neighbours(node).iter().zip(matrix.blocks(node).chunks_exact(4));
        let stress: f64 = terms
            .map(|(&column, block)| {
                size(block) * size(&u[2 * column as usize..2 * column as usize + 2])
            })
            .sum();
        size(&u[2 * node..2 * node + 2]) * (stress + size(&problem.load[2 * node..2 * node + 2]))
    };
    (0..u.len() / 2).map(at).fold(0.0, f64::hypot)
}

/// Arc lengths of the constraints; the closing segment of a closed edge follows the last node.
fn positions(problem: &ContactProblem, cone: EdgeCone) -> Vec<f64> {
    let arc = problem.edge.arc();
    let mut positions = cone.apply(arc);
    if let (true, [.., last], Some(closing)) = (
        positions.len() == arc.len() && cone.kind() == Cone::Midpoint,
        arc,
        problem.edge.segment_lengths().last(),
    ) && let Some(position) = positions.last_mut()
    {
        *position = last + 0.5 * closing;
    }
    positions
}

/// (K u − F) divided by the nodal lengths, along the contact edge.
fn tractions(problem: &ContactProblem, stress_force: &[f64], lengths: &[f64]) -> Vec<Point> {
    let c = problem.form.components();
    let force = |unknown: usize| stress_force[unknown] - problem.load[unknown];
    let at = |(&node, length): (&usize, &f64)| match c {
        1 => [force(node) / length, 0.0],
        _ => [force(2 * node + 1) / length, force(2 * node) / length],
    };
    problem.edge.nodes().iter().zip(lengths).map(at).collect()
}

/// The margins over the constraints with at least one free node; constraints on fixed nodes are ignored.
fn free_margins(
    problem: &ContactProblem,
    cone: EdgeCone,
    terms: &KktTerms<'_>,
    set: &ContactSet,
) -> Result<Margins> {
    let normals = problem.normal_unknowns();
    let free: Vec<usize> = (0..terms.gap.len())
        .filter(|&i| cone.support(i).any(|node| !problem.prescribed[normals[node]]))
        .collect();
    let pick = |values: &[f64]| -> Vec<f64> { free.iter().map(|&i| values[i]).collect() };
    let (multiplier, gap) = (pick(terms.multiplier), pick(terms.gap));
    let active: Vec<bool> = free.iter().map(|&i| set.contains(i)).collect();
    KktTerms { multiplier: &multiplier, gap: &gap, ..*terms }.margins(&active)
}

/// B u − g.
pub(super) fn gap_of(
    problem: &ContactProblem,
    cone: EdgeCone,
    normal_displacement: &[f64],
) -> Vec<f64> {
    let bound = cone.apply(&problem.gap);
    let means = cone.apply(normal_displacement);
    means.iter().zip(bound).map(|(mean, g)| mean - g).collect()
}

/// (|K||u| + |F|)_i.
pub(super) fn sizes(problem: &ContactProblem, u: &[f64]) -> Vec<f64> {
    let stress_force = problem.multiply_absolute(u);
    stress_force.iter().zip(&problem.load).map(|(size, force)| size + force.abs()).collect()
}

/// max_i (|K||u| + |F|)_i over the free unknowns.
pub(super) fn force_scale(problem: &ContactProblem, u: &[f64]) -> f64 {
    largest_free(problem, &sizes(problem, u))
}

fn largest_free(problem: &ContactProblem, sizes: &[f64]) -> f64 {
    (0..sizes.len()).filter(|&i| !problem.prescribed[i]).map(|i| sizes[i]).fold(0.0, f64::max)
}

/// max(|u|, |g|, max_i |F_i| / K_ii): the last term is the displacement due to the load alone, the scale if contact
/// prevents all displacement.
///
/// Positive also where contact keeps u = 0, so that rounding of the gap has a scale.
pub(super) fn displacement_scale(problem: &ContactProblem, u: &[f64]) -> f64 {
    let alone = (0..u.len())
        .into_par_iter()
        .with_min_len(1 << 14)
        .filter(|&i| !problem.prescribed[i] && problem.load[i] != 0.0)
        .map(|i| problem.load[i].abs() / problem.diagonal(i))
        .reduce(|| 0.0, f64::max);
    largest(u).max(largest(&problem.gap)).max(alone)
}

/// The total reaction and the relative imbalance of all forces.
fn global_balance(
    problem: &ContactProblem,
    u: &[f64],
    residual: &[f64],
    edge_force: &[f64],
) -> (Point, f64) {
    let c = problem.form.components();
    let mut reactions = vec![0.0; residual.len()];
    for i in (0..residual.len()).filter(|&i| problem.prescribed[i]) {
        reactions[i] = residual[i];
    }
    let mut contact = vec![0.0; residual.len()];
    for (unknown, force) in problem.normal_unknowns().into_iter().zip(edge_force) {
        contact[unknown] = *force;
    }
    let absolute = |values: &[f64]| compensated(values.iter().map(|v| v.abs()));
    let along = |axis: usize| {
        let unit: Vec<f64> =
            (0..residual.len()).map(|i| f64::from(u8::from(i % c == axis))).collect();
        let direction = problem.to_frame(&unit);
        let reaction = careful_dot(&direction, &reactions);
        let inner = problem.multiply(&direction);
        let size = inner.iter().zip(u).map(|(k, u)| (k * u).abs()).sum::<f64>();
        let sum = careful_dot(&direction, &problem.load) + reaction
            - careful_dot(&direction, &contact)
            - careful_dot(&inner, u);
        (reaction, size, sum.abs())
    };
    let of_forces = || (absolute(&problem.load) + absolute(&reactions)).max(absolute(&contact));
    let (found, forces) = rayon::join(|| parallel::map(c, &along), of_forces);
    let (mut reaction, mut worst, mut scale) = ([0.0; 2], 0.0_f64, forces);
    for (axis, (along, size, sum)) in found.into_iter().enumerate() {
        reaction[axis] = along;
        scale = scale.max(size);
        worst = worst.max(sum);
    }
    let balance = if worst == 0.0 { 0.0 } else { worst / scale };
    (reaction, balance)
}
