//! The accuracy asked of the multigrid solver, its progress and its report.

use fractional_sobolev::{Estimate, Tolerance};
use std::fmt;

/// How exact a discrete solution is to be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Accuracy {
    /// The algebraic error is this share of the error of discretisation, as estimated on the way up: more is
    /// worth nothing to the continuous solution.
    OfDiscretisation(f64),
    /// The algebraic error over the solution, both in the energy norm.
    Relative(Tolerance),
}

impl Default for Accuracy {
    /// Twelve digits.
    fn default() -> Self {
        Accuracy::Relative(Tolerance::reference())
    }
}

/// Where the iteration of multigrid is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Progress {
    /// The level, from 1.
    pub level: usize,
    /// How many levels there are.
    pub levels: usize,
    /// Unknowns of the level.
    pub unknowns: usize,
    /// The step of the contact iteration there, from 1.
    pub step: usize,
    /// The estimated error in the energy norm.
    pub error: f64,
}

/// Why the direct solver was taken instead.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Fallback {
    /// The contact edge lies in several pieces.
    SeveralEdges,
    /// Means on a closed edge, which the steps of the cycles do not know.
    ClosedEdge,
    /// No coarser meshes: neither a hierarchy nor a grid that can be halved.
    NoLevels,
    /// λ/μ above 100: cycles of point smoothers hardly converge.
    NearlyIncompressible,
    /// The accuracy asked for was not reached.
    NotReached,
}

/// λ/μ up to which cycles converge fast enough to be worth it.
pub(super) const MOST_INCOMPRESSIBLE: f64 = 100.0;

impl fmt::Display for Fallback {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Fallback::SeveralEdges => "direct solver: several contact edges",
            Fallback::ClosedEdge => "direct solver: means on a closed edge",
            Fallback::NoLevels => "direct solver: no coarser meshes",
            Fallback::NearlyIncompressible => "direct solver: nearly incompressible",
            Fallback::NotReached => "direct solver: accuracy not reached by cycles",
        })
    }
}

/// What happened on one level.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MultigridLevel {
    /// Unknowns, prescribed ones included.
    pub unknowns: usize,
    /// Contact sets tried, each with a linear system of the level.
    pub steps: usize,
    /// Conjugate gradient steps, one cycle each.
    pub gradient_steps: usize,
    /// The factor of one cycle alone, from the gradients: 1 − κ.
    pub factor: f64,
    /// The estimated algebraic error in the energy norm.
    pub error: f64,
    /// The expected error of discretisation in the energy norm; `None` on the first levels.
    pub discretisation: Option<f64>,
    /// Seconds.
    pub seconds: f64,
}

/// What multigrid reports beside the solution.
#[derive(Debug, Clone)]
pub struct MultigridReport {
    /// |u_h|_a with the estimated error of u_h in the same norm; `None` for the direct solver.
    pub error: Option<Estimate>,
    /// The expected error of discretisation in the energy norm.
    pub discretisation: Option<f64>,
    /// Contact sets tried by elimination on the coarsest mesh, or on the mesh itself where it took over; the
    /// first of them is guessed from coarser functions on the edge.
    pub coarsest_steps: usize,
    /// The levels above the coarsest one.
    pub levels: Vec<MultigridLevel>,
    /// Why the direct solver was taken, if it was.
    pub fallback: Option<Fallback>,
}
