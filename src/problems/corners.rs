//! Corners and transitions of a computed contact problem, and the regularity of its solution there.
//!
//! They are found from the polygon of the mesh, the conditions on its sides and the computed contact set: every
//! boundary node at which the boundary bends, the conditions change, or contact ends is the vertex of a wedge, whose
//! exponents are computed by `singular`. u ∈ H^τ for every τ below the smallest of the resulting suprema. Data are
//! assumed to be smooth. A contact interval that consists of a single node counts as an interval with two transitions
//! at one point.

use crate::cone::Cone;
use crate::contact::{ContactProblem, ContactSolution};
use crate::error::{Error, Result, ToolkitError};
use crate::fem::{Form, Lame};
use crate::mesh::{Part, Point};
use crate::singular::{CornerRegularity, Medium, SideCondition, SideConditions, Wedge};
use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::{PI, TAU};
use std::fmt;

/// Openings closer to π than this count as straight.
const STRAIGHT: f64 = 1e-9;

/// A corner of the body, or a change of conditions on a straight side, with the regularity of the solution there.
///
/// Near the corner u = Re Σ_j c_j r^{λ_j} φ_j(θ) + a smoother function; r^λ φ, unless it is a polynomial,
/// lies in H^τ if and only if τ < 1 + Re λ.
///
/// ```
/// use signorini::{cone::Cone, contact::Solver, problems::{TestProblem, solution_regularity}};
/// let problem = TestProblem::Free.problem(4)?;
/// let found = solution_regularity(&problem, &problem.solve(Cone::Nodal, Solver::ActiveSet)?)?;
/// // without contact only the right angles of the square are left
/// assert!(found.corners.iter().all(|c| (c.wedge.angle() - std::f64::consts::FRAC_PI_2).abs() < 1e-12));
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct CornerSingularity {
    /// Position of the corner.
    pub place: Point,
    /// Opening and side conditions; θ = 0 is the side that starts at the corner with the body on its left.
    pub wedge: Wedge,
    /// The supremum of the τ with u ∈ H^τ near the corner, and the exponent that determines it.
    pub regularity: CornerRegularity,
}

impl fmt::Display for CornerSingularity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let ([x, y], degrees) = (self.place, self.wedge.angle().to_degrees());
        write!(f, "{} {degrees:.0} deg at ({x:.3}, {y:.3})", self.wedge.sides())
    }
}

/// The regularity of a solution, with its corners and transitions.
///
/// τ is the minimum over the corners: u ∈ H^{τ−ε} for every ε > 0, but in general u ∉ H^τ.
///
/// ```
/// use signorini::problems::{Parameters, TestProblem};
/// let found = TestProblem::Closed.regularity(&Parameters::default())?;
/// let least = found.corners.iter().map(|corner| corner.regularity.tau).fold(4.0, f64::min);
/// assert_eq!(found.tau, least);
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct SolutionRegularity {
    /// Supremum of the τ with u ∈ H^τ; at most 4, since only exponents with Re λ < 3 are computed.
    pub tau: f64,
    /// All corners and transitions, ordered by increasing regularity.
    pub corners: Vec<CornerSingularity>,
}

impl SolutionRegularity {
    /// The corner that determines τ; `None` if no exponent limits it.
    pub fn responsible(&self) -> Option<&CornerSingularity> {
        self.corners.first().filter(|corner| corner.regularity.exponent.is_some())
    }
}

/// The corners, transitions and regularity of a discrete solution. Cost: about a millisecond per distinct
/// wedge.
///
/// A boundary node is the vertex of a wedge if the boundary bends there or the condition (clamped, free, closed,
/// open) changes; a segment is closed if its constraint is active (midpoint), or if one of its nodes is
/// active and the other one active or clamped (nodal). A single active node between open segments counts as
/// two transitions.
///
/// ```
/// use signorini::{cone::Cone, contact::Solver, problems::{TestProblem, solution_regularity}};
/// let problem = TestProblem::Manufactured.problem(8)?;
/// let solution = problem.solve(Cone::Nodal, Solver::ActiveSet)?;
/// // r^{3/2} at the transition inside the edge: 1 + 3/2
/// assert!((solution_regularity(&problem, &solution)?.tau - 2.5).abs() < 1e-9);
/// # Ok::<(), signorini::Error>(())
/// ```
///
/// # Errors
/// [`ToolkitError::Node`](crate::ToolkitError::Node) for a corner where two materials or several pieces of
/// the boundary meet, or at which the boundary ends;
/// [`ToolkitError::OutOfRange`](crate::ToolkitError::OutOfRange) for a Poisson's ratio outside (−1, 1/2);
/// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) for a contact edge in several
/// pieces; and the errors of [`Wedge::regularity`].
pub fn solution_regularity(
    problem: &ContactProblem,
    solution: &ContactSolution,
) -> Result<SolutionRegularity> {
    regularity_with_ends(problem, solution, [None; 2])
}

/// The regularity of the solution, given whether the first and the last segment of the edge are closed.
pub(super) fn regularity_with_ends(
    problem: &ContactProblem,
    solution: &ContactSolution,
    ends: [Option<bool>; 2],
) -> Result<SolutionRegularity> {
    problem.edge().require_one_piece()?;
    let mesh = problem.mesh();
    let contact = closed_edges(problem, solution, ends);
    let mut sides: BTreeMap<usize, [Option<(usize, SideCondition)>; 2]> = BTreeMap::new();
    for edge in mesh.boundary() {
        let side = match edge.part {
            Part::Dirichlet => SideCondition::Clamped,
            Part::Neumann => SideCondition::Free,
            Part::Contact if contact.edges.contains(&edge.nodes[0]) => SideCondition::Closed,
            Part::Contact => SideCondition::Open,
        };
        let [start, end] = edge.nodes;
        for (node, k, other) in [(start, 0, end), (end, 1, start)] {
            let slot = &mut sides.entry(node).or_default()[k];
            if slot.replace((other, side)).is_some() {
                return Err(Error::Toolkit(ToolkitError::Node {
                    node: mesh.number(node),
                    reason: "belongs to several pieces of the boundary",
                }));
            }
        }
    }
    let mut corners: Vec<CornerSingularity> = Vec::new();
    for (node, ends) in sides {
        let [Some((next, mut first)), Some((last, second))] = ends else {
            return Err(Error::Toolkit(ToolkitError::Node {
                node: mesh.number(node),
                reason: "is an end point of the boundary, which must consist of closed curves",
            }));
        };
        let place = mesh.nodes()[node];
        let angle = opening(place, mesh.nodes()[next], mesh.nodes()[last]);
        if angle == PI && first == second {
            if !contact.single.contains(&node) {
                continue;
            }
            first = SideCondition::Closed;
        }
        let wedge = Wedge::new(angle, SideConditions(first, second), medium(problem, node)?)?;
        let known =
            corners.iter().find(|corner| corner.wedge == wedge).map(|c| c.regularity.clone());
        let regularity = match known {
            Some(regularity) => regularity,
            None => wedge.regularity()?,
        };
        corners.push(CornerSingularity { place, wedge, regularity });
    }
    corners.sort_by(|a, b| a.regularity.tau.total_cmp(&b.regularity.tau));
    let tau =
        corners.first().map_or(1.0 + crate::singular::LARGEST, |corner| corner.regularity.tau);
    Ok(SolutionRegularity { tau, corners })
}

/// The closed edges of the contact boundary, by their first node, and the isolated contact nodes.
struct Closed {
    edges: BTreeSet<usize>,
    single: Vec<usize>,
}

/// True if the segment of the edge at the given distance from its first node is closed.
pub(super) fn is_closed_at(problem: &ContactProblem, solution: &ContactSolution, arc: f64) -> bool {
    let edge = problem.edge();
    let first = edge.arc().partition_point(|&at| at <= arc).saturating_sub(1);
    let node = edge.nodes()[first.min(edge.nodes().len() - 2)];
    closed_edges(problem, solution, [None; 2]).edges.contains(&node)
}

fn closed_edges(
    problem: &ContactProblem,
    solution: &ContactSolution,
    ends: [Option<bool>; 2],
) -> Closed {
    let (nodes, is_loop) = (problem.edge().nodes(), problem.edge().is_closed());
    let (count, set) = (nodes.len(), &solution.contact_set);
    let segments = if is_loop { count } else { count - 1 };
    let clamped = problem.mesh().nodes_on(Part::Dirichlet);
    // A clamped node does not determine the state of its edge.
    let may_close = |i: usize| clamped[nodes[i]] || set.contains(i);
    let is_closed = |i: usize| match solution.cone {
        Cone::Midpoint => set.contains(i),
        Cone::Nodal => {
            let j = (i + 1) % count;
            may_close(i) && may_close(j) && (set.contains(i) || set.contains(j))
        }
    };
    let mut edges: Vec<bool> = (0..segments).map(is_closed).collect();
    for (segment, known) in [0, segments - 1].into_iter().zip(ends) {
        edges[segment] = known.unwrap_or(edges[segment]);
    }
    let touches = |&i: &usize| {
        let before = if i > 0 || is_loop { edges[(i + segments - 1) % segments] } else { false };
        let after = i < segments && edges[i];
        solution.cone == Cone::Nodal && set.contains(i) && !clamped[nodes[i]] && !before && !after
    };
    Closed {
        single: (0..count).filter(touches).map(|i| nodes[i]).collect(),
        edges: (0..segments).filter(|&i| edges[i]).map(|i| nodes[i]).collect(),
    }
}

/// The interior angle of the body at a node, from the next node of the boundary to the previous one.
fn opening([x, y]: Point, next: Point, last: Point) -> f64 {
    let angle = |[a, b]: Point| (b - y).atan2(a - x);
    let turned = (angle(last) - angle(next)).rem_euclid(TAU);
    match turned {
        straight if (straight - PI).abs() < STRAIGHT => PI,
        crack if crack < STRAIGHT => TAU,
        other => other,
    }
}

/// The medium at a node, if there is only one.
fn medium(problem: &ContactProblem, node: usize) -> Result<Medium> {
    let Form::Elastic { materials } = problem.form() else { return Ok(Medium::Scalar) };
    let mesh = problem.mesh();
    let regions: Vec<usize> = match materials.len() {
        1 => vec![0],
        _ => {
            let around =
                (0..mesh.triangles().len()).filter(|&t| mesh.triangles()[t].contains(&node));
            around.map(|t| mesh.region(t)).collect()
        }
    };
    let mut found: Vec<Lame> = regions.iter().filter_map(|&r| problem.form().material(r)).collect();
    found.dedup();
    match found[..] {
        [material] => {
            let (lambda, mu) = (material.lambda(), material.mu());
            Ok(Medium::PlaneStrain(0.5 * lambda / (lambda + mu)))
        }
        _ => Err(Error::Toolkit(ToolkitError::Node {
            node: mesh.number(node),
            reason: "lies between two materials: exponents of such corners are not computed",
        })),
    }
}
