//! Multigrid for contact: nested iteration, truncated Newton steps, conjugate gradients with a V-cycle.
//!
//! On every level the constraints of a contact set hold with equality and the others are ignored; the linear
//! problem left is solved by conjugate gradients whose preconditioner is a symmetric V-cycle on the coarse
//! functions that the set leaves free (C. Gräser and R. Kornhuber, J. Comput. Math. 27 (2009); R. Kornhuber
//! and R. Krause, Comput. Vis. Sci. 4 (2001)). Each level starts from the solution and the set of the coarser
//! one. The cost is O(unknowns) for a fixed accuracy.
//!
//! Nothing is known of the solution beforehand: a cold start is the way up from the coarsest mesh, where the
//! set is guessed from coarser functions on the edge. What the ends of contact do between two meshes is seen
//! on patches over them: a level takes one linear system in the nodal cone, or two; three at most in the
//! midpoint cone, n to 2048.
//!
//! In the midpoint cone a run that is short by one segment has multipliers that ring, and what a projection
//! makes of them is far from the set sought: where all that is wrong lies beside the ends of runs, the ends
//! move. A run beside a clamped end may have to be broken up at places that no step finds; up to n = 256
//! elimination gives the set of such a level.
//!
//! Measured on `block` with n segments on the contact edge, tolerance 1e-10: steps of the gradients on the
//! finest level, and the factor by which one cycle reduces the error (the last two rows with the limit on λ/μ
//! lifted).
//!
//! | λ/μ | n = 128 | n = 512 | factor |
//! | --- | --- | --- | --- |
//! | 0 | 16 | | 0.81 |
//! | 1 | 16 | 17 | 0.82 |
//! | 20 | 39 | 43 | 0.97 |
//! | 50 | 64 | 66 | 0.985 |
//! | 100 | 89 | 91 | 0.992 |
//! | 200 | 131 | 136 | 0.996 |
//! | 500 | 309 | 322, not reached | 0.997 |
//!
//! It is for λ/μ up to 100; near Poisson's ratio 1/2 point smoothers fail, and the direct
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
mod patch;
mod real;
mod sparse_level;
mod vectors;

pub use accuracy::{Accuracy, Fallback, MultigridLevel, MultigridReport, Progress};
