//! Multigrid for contact: nested iteration, truncated Newton steps, conjugate gradients with a V-cycle.
//!
//! On every level the constraints of a contact set hold with equality and the others are ignored; the linear
//! problem left is solved by conjugate gradients whose preconditioner is a symmetric V-cycle on the coarse
//! functions that the set leaves free (C. Gräser and R. Kornhuber, J. Comput. Math. 27 (2009); R. Kornhuber
//! and R. Krause, Comput. Vis. Sci. 4 (2001)). Each level starts from the solution and the set of the coarser
//! one. The cost is O(unknowns) for a fixed accuracy.
//!
//! It is for λ/μ up to [`MOST_INCOMPRESSIBLE`]; near Poisson's ratio 1/2 point smoothers fail, and the direct
//! solver takes over.

mod accuracy;
mod chain;
mod coarsest;
mod cycle;
mod discretisation;
mod edge;
mod entry;
mod face;
mod gradients;
mod grid_level;
mod grid_rows;
mod level;
mod link;
mod nested;
mod newton;
mod real;
mod sparse_level;
mod vectors;

pub use accuracy::{
    Accuracy, Fallback, MOST_INCOMPRESSIBLE, MultigridLevel, MultigridProgress, MultigridSolution,
};
