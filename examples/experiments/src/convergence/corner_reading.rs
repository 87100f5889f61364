//! The exponent of a corner, read off discrete solutions on meshes graded toward it.
//!
//! On uniform meshes the corner has A h^{2λ} of e² and the smooth part B h²: where λ is near one, or A small,
//! the levels that can be computed do not tell the order from one. Near the corner itself u is r^λ U(θ), and
//! nothing else. The triangles whose middle is nearer than R_k = 2^{−k}/4 are cut for k = 0, 1, …: every
//! shell R_{k+1} ≤ r < R_k is the same mesh but for scale, `cells` elements along its radius, and the stress
//! energy of shell k is W_k = c 4^{−λ_h k} (1 + …), so that
//!
//! p_k = log₂(W_k/W_{k+2})/4 → λ_h.
//!
//! What is left far outside of the tip and far inside of the body is the next exponent, 2^{−(λ₂ − λ₁) k}:
//! extrapolated (Aitken). λ_h = λ + O(cells^{−2}), an eigenvalue of the map from one shell to the next:
//! extrapolated from cells and 2 cells. The error of the [`Estimate`] is twice the distance of these two, six
//! times what is extrapolated, and what the last shells still move. Cost: two solutions of some 10⁴ nodes.

use crate::ErrorExt;
use fractional_sobolev::{Estimate, Work};
use signorini::cone::{Cone, ContactSet};
use signorini::contact::{ContactProblem, ContactSolution, Solver};
use signorini::edge::radial_intervals;
use signorini::fem::{Form, gradients, stresses};
use signorini::mesh::{Hierarchy, Point, Triangulation};
use signorini::problems::{CornerSingularity, Parameters, TestProblem};
use signorini::rates::order_between;
use signorini::{Error, Result, ToolkitError};
use std::f64::consts::PI;

/// The outermost shell, in units of the squares of the scenes.
const RADIUS: f64 = 0.25;
/// Shells.
const SHELLS: usize = 40;
/// The shell that is read: 2^{-29} from the corner, far above the tip.
const READ: usize = 28;
/// Shells between the three values that are extrapolated.
const APART: usize = 4;

/// The exponent at the corner responsible for the regularity of a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct CornerReading {
    /// The corner.
    pub corner: CornerSingularity,
    /// λ_h with `cells` and with 2 `cells`.
    pub meshes: [f64; 2],
    /// λ.
    pub exponent: Estimate,
    /// Where the stretch of contact or gap at the corner ends, by its distance, seen from shell 28 outwards;
    /// `None` off the ends of the contact edge, and where all the edge is one stretch.
    pub border: Option<f64>,
}

impl CornerReading {
    /// Reads the exponent with `cells` and 2 `cells` elements along a shell, nodal cone; `None` where no
    /// exponent limits τ, where it is complex, and for the end of contact on a straight edge, whose place is
    /// not a node.
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](signorini::ToolkitError::CountOutOfRange) unless 2 ≤ cells ≤ 64; those of meshes and solvers;
    /// [`ToolkitError::ToleranceNotMet`](signorini::ToolkitError::ToleranceNotMet) when a solver did not converge or the stress vanishes at the corner.
    pub fn of(scene: TestProblem, setting: &Parameters, cells: usize) -> Result<Option<Self>> {
        if !(2..=64).contains(&cells) {
            return Err(Error::Toolkit(ToolkitError::CountOutOfRange {
                name: "cells of a shell",
                value: cells,
                range: "[2, 64]",
            }));
        }
        let found = scene.regularity(setting)?;
        let is_read = |corner: &&CornerSingularity| {
            let exponent = corner.regularity.exponent.as_ref();
            corner.wedge.angle() != PI && exponent.is_some_and(|exponent| !exponent.is_complex())
        };
        let Some(corner) = found.responsible().filter(is_read).cloned() else { return Ok(None) };
        let coarse = Read::of(scene, setting, corner.place, cells)?;
        let Read { exponent, drift, border } = Read::of(scene, setting, corner.place, 2 * cells)?;
        let (meshes, change) = ([coarse.exponent, exponent], exponent - coarse.exponent);
        let error = 2.0 * change.abs() + drift;
        let exponent = Estimate::new(exponent + change / 3.0, error, Work::default())?;
        Ok(Some(Self { corner, meshes, exponent, border }))
    }

    /// |reading − Re λ| over the error of the reading; infinite where nothing limits τ.
    pub fn deviation(&self) -> f64 {
        let expected = self.corner.regularity.tau - 1.0;
        (self.exponent.value - expected).abs() / self.exponent.error
    }
}

/// One mesh.
struct Read {
    /// λ_h.
    exponent: f64,
    /// How far extrapolation to the corner and the last shell moved it.
    drift: f64,
    border: Option<f64>,
}

impl Read {
    fn of(scene: TestProblem, setting: &Parameters, place: Point, cells: usize) -> Result<Self> {
        let mut hierarchy = Hierarchy::new(scene.mesh_with(4 * cells, setting)?);
        hierarchy.refine_around(place, RADIUS, SHELLS)?;
        let fine = hierarchy.finest();
        // Checked: coordinates that are not short binary fractions are rounded, and triangles may collapse.
        let (nodes, triangles) = (fine.nodes().to_vec(), fine.triangles().to_vec());
        let mesh = Triangulation::new(nodes, triangles, fine.boundary().to_vec())?;
        let problem = scene.on_with(mesh, setting)?;
        let solution = problem.solve(Cone::Nodal, Solver::ActiveSet)?;
        let energies = shells(&problem, &solution, place)?;
        let p = |k: usize| 0.5 * order_between((4.0, energies[k]), (1.0, energies[k + 2]));
        let [a, b, d, c] = [READ - 2 * APART, READ - APART, READ - 1, READ].map(p);
        let is_finite = [a, b, c, d].iter().all(|p| p.is_finite());
        if !is_finite || !solution.status.is_converged() {
            let why = "the solver did not converge, or the stress vanishes at the corner";
            return Err(ToolkitError::out_of_reach("exponent of a corner", 1.0, c, why).into());
        }
        let (first, second) = (b - a, c - b);
        let step = if (second / first).abs() < 1.0 { second * second / (first - second) } else { second };
        let border = border(&problem, &solution, place)?;
        Ok(Self { exponent: c + step, drift: step.abs() + (c - d).abs(), border })
    }
}

/// Where the stretch of contact or gap at an end of the contact edge ends; what is nearer than the shell that
/// is read does not count.
fn border(problem: &ContactProblem, solution: &ContactSolution, place: Point) -> Result<Option<f64>> {
    let points = problem.edge().points();
    let mut nodes: Vec<usize> = (0..points.len()).collect();
    if points[points.len() - 1] == place {
        nodes.reverse();
    } else if points[0] != place {
        return Ok(None);
    }
    let nearest = RADIUS * 0.5f64.powi(READ as i32);
    nodes.retain(|&i| distance(points[i], place) >= nearest);
    let radii: Vec<f64> = nodes.iter().map(|&i| distance(points[i], place)).collect();
    let set = nodes.iter().map(|&i| solution.contact_set.contains(i)).collect();
    let found = radial_intervals(&radii, &ContactSet::new(set))?;
    Ok(found.first().filter(|_| found.len() > 1).map(|stretch| stretch.to))
}

/// ∫ |σ|², or ∫ |∇u|², over every shell.
fn shells(problem: &ContactProblem, solution: &ContactSolution, place: Point) -> Result<Vec<f64>> {
    let (mesh, u) = (problem.mesh(), &solution.displacement);
    let density: Vec<f64> = match problem.form() {
        Form::Scalar { .. } => gradients(mesh, u)?.into_iter().map(|[x, y]| x * x + y * y).collect(),
        form => {
            let all = stresses(mesh, form, u)?;
            all.into_iter().map(|s| s.xx * s.xx + s.yy * s.yy + 2.0 * s.xy * s.xy).collect()
        }
    };
    let mut energies = vec![0.0; SHELLS];
    for (t, density) in density.into_iter().enumerate() {
        let corners = mesh.corners(t);
        let shell = (RADIUS / distance(middle(corners), place)).log2().floor();
        if (0.0..SHELLS as f64).contains(&shell) {
            energies[shell as usize] += 0.5 * doubled_area(corners) * density;
        }
    }
    Ok(energies)
}

fn distance(a: Point, b: Point) -> f64 {
    (b[0] - a[0]).hypot(b[1] - a[1])
}

/// Twice the signed area of a triangle.
fn doubled_area([a, b, c]: [Point; 3]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])
}

/// The centre of gravity of a triangle.
fn middle([a, b, c]: [Point; 3]) -> Point {
    [0, 1].map(|k| (a[k] + b[k] + c[k]) / 3.0)
}
